#pragma once
// Names in a lesson file, and what is said of one that is not known.

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace windlass::assess {

/// Place of a name; -1: there is none.
int place_of(std::span<const std::string_view> names, const std::string& name);

/// "\"x\" is not known; the nearest is \"y\"", or all names where none is near.
std::string unknown(const std::string& name, const std::vector<std::string>& known);

} // namespace windlass::assess
