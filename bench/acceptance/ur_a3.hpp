#pragma once
// The acceptance runs of IACS UR A3 Rev.1 (2019) on a windlass as configured.

#include "bench/acceptance/machines.hpp"

#include <string>
#include <vector>

namespace windlass::lab {

/// Which way a requirement counts.
enum class Bound { at_least, at_most };

/// One requirement and what the run came to.
struct Finding {
    std::string clause;      ///< of UR A3
    std::string requirement; ///< what is asked for
    std::string unit;        ///< of both figures
    Bound bound = Bound::at_least;
    double required = 0, measured = 0;
    std::string note = {}; ///< what else was seen
    bool met() const { return bound == Bound::at_least ? measured >= required : measured <= required; }
};

/// Continuous duty pull, N: 37.5, 42.5, 47.5 d^2 for grade 1, 2, 3, d in mm (UR A3 3.1.2).
double continuous_duty_pull(const physics::ChainDef& chain);

/// Largest load on the gypsy (N) that the brake, and the stopper behind an open brake, hold without slip:
/// raised by a thousandth of the breaking load at a time; twice the breaking load when nothing gave.
double brake_holds(const Machine& machine);
double stopper_holds(const Machine& machine);

/// Every run of the rules that a simulator can make, in their order: some 40 minutes of the windlass's time.
std::vector<Finding> accept(const Machine& machine);

} // namespace windlass::lab
