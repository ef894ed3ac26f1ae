#pragma once
// Figures for people.

#include <cstdint>
#include <string>

namespace windlass {

/// "383 kN", "5.8 m/s", "35 °C", "11.5 o'clock", "6.97 shackles": of a value in an SI unit. unit: "N", "K"
/// (above absolute zero), "h" (of the clock, 12 ahead), "yes" (1 or 0), or any other as it is to be read;
/// empty: a bare number.
std::string figure_text(double value, const std::string& unit);
/// "6.97", "4": shackles of cable to two decimals, wherever a judge tells them.
std::string shackles_figure(double shackles);

/// Points of 100 in tenths, in which a lesson decides (server/assess/result.cpp). Rounded down: what has not
/// reached the pass does not read as if it had. Pages have the same in kit/points_said.ts.
std::int64_t points_in_tenths(double points);
/// "69.9": the same for people.
std::string points_text(double points);
/// "6.3" of 6.25: the part that one criterion has of the 100, which decides nothing: to the nearest tenth, a
/// half up. Pages have the same in kit/points_said.ts.
std::string share_text(double points);

} // namespace windlass
