#pragma once

#include "station/picture.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace windlass::console {

/// The exercise's status, truth and weather in some lines for people; the status must have been heard.
std::string status_text(const station::Picture& picture);

/// The same in one object: the status, what the truth has besides (its title as "instructor_title"), and
/// "environment".
nlohmann::json status_json(const station::Picture& picture);

/// Every fault code, a line each: name, what it does, and which ones this version models.
std::string fault_list();
nlohmann::json fault_json();

} // namespace windlass::console
