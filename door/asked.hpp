#pragma once
// What a browser has asked, read field by field, and how it is answered: for the acts of the door. Each
// reader throws Denied (400) naming the field.

#include "door/attempts.hpp"
#include "door/door_host.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>

namespace windlass::door {

inline constexpr int kDay = 24 * 3600; ///< s

std::int64_t unix_s(); ///< since 1970, by this machine's clock

gateway::Verdict answer(const nlohmann::json& body, int status = 200);

std::string text_of(const nlohmann::json& asked, const char* name);
int number_of(const nlohmann::json& asked, const char* name);
/// A person's or device's name, without what is not to be shown.
std::string plain_name_of(const std::string& text);
std::string name_in(const nlohmann::json& asked);

/// Throws Denied (429) while that address or name has to wait.
void not_too_often(const Attempts& attempts, const std::string& key);

/// The value of a Set-Cookie header. age: s; 0 takes the cookie away.
std::string cookie(Way way, const char* name, const std::string& secret, int age);

} // namespace windlass::door
