#pragma once
// What the checks of a simulated centre find of harm that is done on purpose.

#include "sim/centre.hpp"

#include <cstdint>
#include <string>

namespace windlass::sim {

/// The first check that fails, of so many seeds of half a minute; empty: none does.
inline std::string first_failure(Sabotage sabotage, std::uint64_t seeds) {
    Plan plan;
    plan.sabotage = sabotage;
    plan.minutes = 0.5;
    for (plan.seed = 1; plan.seed <= seeds; ++plan.seed)
        if (const Outcome found = run(plan); found.failed) return found.failed->what.check;
    return "";
}

} // namespace windlass::sim
