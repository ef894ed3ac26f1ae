#pragma once
// Anchorings drawn at random, over which the model's claims about itself are held against what it does.

#include "server/exercise/definition/exercise_def.hpp"

#include <cstdint>
#include <string>

namespace windlass::bench {

/// A ship and the ground tackle that goes with her (docs/ships.md), as files of config/.
struct Outfit {
    const char *ship, *windlass, *chain, *anchor;
};

/// One anchoring, and how it is worked.
struct DrawnAnchoring {
    Outfit outfit{};
    const char* soil = nullptr;
    double depth = 0;    ///< m
    double sternway = 0; ///< m/s, over the ground, as the anchor is let go
    double wind = 0;     ///< m/s
    double wind_off = 0; ///< degrees, off her bow: no ship lies dead head to wind
    double swell = 0;    ///< m, significant height, of 10 s; 0: none
    int shackles = 0;
    bool walked_back = false; ///< in gear, where it is too deep to let go
};

/// The number-th of a seed; the same on every machine. Six outfits, four soils, 18 to 60 m, walked back
/// beyond 45 m, 0.2 to 0.8 m/s of sternway, a scope of 4 to 7 within 4 to 9 shackles, 4 to 10 m/s of wind up
/// to 25 degrees off the bow, a swell of 0.5 to 2.5 m in two of five.
DrawnAnchoring drawn_anchoring(std::uint64_t seed, std::uint64_t number);

/// "panamax_ballast, 38.4 m gravel, 5 shackles, 0.48 m/s astern"
std::string title(const DrawnAnchoring& anchoring);

/// Its exercise, by the model's policy. Throws ConfigError where the files of config/ do not fit.
exercise::ExerciseDef definition(const DrawnAnchoring& anchoring);

} // namespace windlass::bench
