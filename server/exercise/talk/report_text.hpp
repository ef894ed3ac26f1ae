#pragma once
// A report of the forecastle as the log has it.

#include "server/exercise/definition/orders.hpp"

#include <string>

namespace windlass::exercise {

/// One line for the log, of what was entered and nothing else: "reported: 3 shackles on deck".
std::string report_text(const ReportMade& report);

} // namespace windlass::exercise
