#include "door/asked.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdint>

namespace windlass::door {

using gateway::Verdict;
using nlohmann::json;

std::int64_t unix_s() {
    return std::chrono::duration_cast<std::chrono::seconds>(
               std::chrono::system_clock::now().time_since_epoch())
        .count();
}

Verdict answer(const json& body, int status) {
    return {.kind = Verdict::Kind::answer,
            .status = status,
            .type = "application/json",
            .body = body.dump(-1, ' ', false, json::error_handler_t::replace)};
}

std::string text_of(const json& asked, const char* name) {
    const auto found = asked.find(name);
    if (found == asked.end() || !found->is_string())
        throw Denied(400, std::string(name) + ": a text is expected");
    return found->get<std::string>();
}

int number_of(const json& asked, const char* name) {
    const auto found = asked.find(name);
    if (found == asked.end() || !found->is_number_integer())
        throw Denied(400, std::string(name) + ": a whole number is expected");
    const auto value = found->get<std::int64_t>();
    return static_cast<int>(std::clamp<std::int64_t>(value, -1, 1'000'000));
}

std::string plain_name_of(const std::string& text) {
    std::string name = plain_name(text);
    if (name.empty() || name == "server" || name == "door")
        throw Denied(400, "name: 1 to 32 bytes of text are allowed, but not server or door");
    return name;
}

std::string name_in(const json& asked) {
    return plain_name_of(text_of(asked, "name"));
}

void not_too_often(const Attempts& attempts, const std::string& key) {
    if (const double wait = attempts.wait(key, Clock::now()); wait > 0)
        throw Denied(429, fmt::format("too many were wrong: try again in {:.0f} s", wait + 1));
}

std::string cookie(Way way, const char* name, const std::string& secret, int age) {
    return fmt::format("{}={}; Path=/; HttpOnly; SameSite=Strict; Max-Age={}{}", name, secret, age,
                       way == Way::tls ? "; Secure" : "");
}

} // namespace windlass::door
