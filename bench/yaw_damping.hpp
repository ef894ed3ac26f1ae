#pragma once
// What damps, and what steadies, a ship that sheers at anchor: one thing changed at a time.

#include <ostream>
#include <span>

namespace windlass::bench {

/// The Panamax in ballast to 247 m of cable in 30 m of water, in steady winds (m/s): the server's ship by
/// herself, her cable a catenary at rest whose foot never moves, so that nothing but ship, wind and water is
/// compared. Writes a row for each wind and change: yaw to either side and period of the eight in the second
/// hour.
void table_of_dampings(std::ostream& table, std::span<const double> winds);

} // namespace windlass::bench
