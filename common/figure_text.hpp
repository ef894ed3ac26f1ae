#pragma once
// Figures for people.

#include <cstdint>
#include <string>

namespace windlass {

/// "383 kN", "5.8 m/s", "35 degC": of a value in an SI unit. unit: "N", "K" (above absolute zero), "yes" (1
/// or 0), or any other as it is to be read; empty: a bare number.
std::string figure_text(double value, const std::string& unit);

/// Points of 100 in tenths, in which a lesson decides (server/assess/result.cpp). Rounded down: what has not
/// reached the pass does not read as if it had. Pages have the same in kit/points_said.ts.
std::int64_t points_in_tenths(double points);
/// "69.9": the same for people.
std::string points_text(double points);

} // namespace windlass
