#pragma once
// How a lesson file calls what the exercise has.

#include "server/exercise/snapshot.hpp"

#include <span>
#include <string>
#include <vector>

namespace windlass::assess {

/// In the order of the enumeration: "stand_by", "let_go", ...
std::span<const char* const> order_names();  ///< exercise::BridgeOrderCode
std::span<const char* const> report_names(); ///< exercise::ReportCode
std::span<const char* const> phase_names();  ///< exercise::AnchorPhase
std::span<const char* const> kind_names();   ///< CriterionKind
std::span<const char* const> event_names();  ///< codes of the exercise's events, in no order

/// Place of a name; -1: there is none.
int place_of(std::span<const char* const> names, const std::string& name);

/// "\"x\" is not known; the nearest is \"y\"", or all names where none is near.
std::string unknown(const std::string& name, const std::vector<std::string>& known);

} // namespace windlass::assess
