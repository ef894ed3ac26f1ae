#pragma once
// The anchorings over which the published error is held against the one made: depths, soils, ships, seas.

#include "server/exercise/definition/exercise_def.hpp"

#include <span>
#include <string>

namespace windlass::bench {

/// One of them, and how it is worked.
struct AnchoringCase {
    const char* name;
    bool tuned;   ///< looked at when the estimate's constants were chosen; the others were held out
    double depth; ///< m
    const char* soil;
    const char* ship;
    int shackles;
    bool walked_back; ///< in gear, where it is too deep to let go
    double wind;      ///< m/s
    double swell;     ///< m, significant height, of 10 s; 0: none
};

std::span<const AnchoringCase> anchoring_cases();

/// The exercise of a case, by the model's policy. Throws ConfigError where the files of config/ do not fit.
exercise::ExerciseDef definition(const AnchoringCase& anchoring);

} // namespace windlass::bench
