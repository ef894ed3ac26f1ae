#pragma once
// A ship that lies to her anchor in a steady wind and sheers about it: how far, how long, how hard.

#include "server/exercise/weather/weather.hpp"

#include <span>
#include <string>

namespace windlass::rigs {

/// A ship of config/ships with the ground tackle that goes with her, and where she anchors.
struct AnchoredShip {
    std::string ship, windlass, chain, anchor; ///< names of files in config
    double depth = 30;                         ///< m, sand
    double cable = 212;                        ///< m, on port
};

/// Every ship of docs/ships.md; capes and VLCCs in 40 m to 270 m, the others in 30 m to 212 m.
std::span<const AnchoredShip> anchored_ships();

/// That one of them, by its name in config/ships. Throws std::out_of_range.
const AnchoredShip& anchored_ship(const std::string& name);

/// What an hour of lying, or less, showed.
struct Sheering {
    double yaw = 0;     ///< deg, farthest off the mean wind
    double sweep = 0;   ///< deg, from the heading farthest to one side to that farthest to the other
    double period = 0;  ///< s, from one side to the other and back, in the mean; 0: less than once
    double mean = 0;    ///< N, of the load at the hawse, of both cables together
    double peak = 0;    ///< N
    double ahead = 0;   ///< N, what that wind asks of her from right ahead
    double dragged = 0; ///< m, port anchor, in that time
};

/// A wind (m/s) from the north: no gusts, no stream, no sea.
exercise::Weather steady_wind(double speed);

/// Lets go on port at 0.4 m/s of sternway, 5 degrees off a wind of 8 m/s, pays out as she falls back, and
/// lies for half an hour in that weather, whose wind is from the north, and then for as many minutes as are
/// looked at. underfoot: the starboard anchor is let go under her foot before the wind rises, with cable of
/// 1.5 times the depth from the lip. freshens: s of the first half hour, in which that weather comes up.
/// Throws std::runtime_error when an anchor does not come to the bottom.
Sheering sheer(const AnchoredShip& ship, const exercise::Weather& weather, bool underfoot, int minutes = 60,
               double freshens = 0);

} // namespace windlass::rigs
