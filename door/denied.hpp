#pragma once
// Why somebody is not let in, or not let do it.

#include <stdexcept>
#include <string>

namespace windlass::door {

/// what() is a line for people, status that of HTTP.
struct Denied : std::runtime_error {
    Denied(int its_status, const std::string& text) : std::runtime_error(text), status{its_status} {}
    int status;
};

} // namespace windlass::door
