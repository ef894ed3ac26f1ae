#pragma once
// How a lesson file calls what the exercise has; orders, reports, phases and events: common/code_names.hpp.

#include "server/exercise/picture/snapshot.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace windlass::assess {

std::span<const std::string_view> kind_names(); ///< in the order of CriterionKind

/// Place of a name; -1: there is none.
int place_of(std::span<const std::string_view> names, const std::string& name);

/// "\"x\" is not known; the nearest is \"y\"", or all names where none is near.
std::string unknown(const std::string& name, const std::vector<std::string>& known);

} // namespace windlass::assess
