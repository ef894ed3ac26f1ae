#pragma once
// Figures in the units that the seats have unless somebody chooses others: loads in t, the cable's speed in
// m/min, ship, wind and stream in kn. What a judge says is in SI (station/web/src/kit/figures_in_text.ts is
// the same for the pages of the seats).

#include <string>

namespace windlass::debrief {

/// A sentence with its loads, and speeds of which it says whose they are, in these units; the rest as it was.
std::string in_seat_units(const std::string& text);

std::string cable_speed_text(double speed); ///< "314 m/min", "7.3 m/min"; m/s, as it is signed
std::string shackles_text(double metres);   ///< "6.97 shackles", of a length of cable
/// "29 t", "330 m/min", "35 °C": a limit of a criterion, or what was so of it. SI; of: what is limited, as
/// the lesson names it.
std::string limited_text(double value, const std::string& unit, const std::string& of);
std::string limited_figure(double value, const std::string& unit, const std::string& of); ///< without unit

/// A factor from SI to these units, and their name.
struct SeatUnit {
    std::string name;
    double factor = 1, offset = 0;
};
SeatUnit seat_unit(const std::string& unit, const std::string& of);

} // namespace windlass::debrief
