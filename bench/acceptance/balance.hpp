#pragma once
// Where the energy of an anchoring goes: let-go, walk-back and weighing, every sink by its name. A run that
// does not get where it should throws std::runtime_error.

#include "bench/acceptance/machines.hpp"

#include <string>
#include <vector>

namespace windlass::lab {

/// A sum of energy by its name.
struct Entry {
    std::string name;
    double joules = 0;
};

/// What one run took and gave.
struct Balance {
    std::string run;
    double given_up = 0;         ///< J, by weight, motion and stretch of cable and anchor; below 0: gained
    std::vector<Entry> sinks;    ///< where it went; what is below 0 was put in
    std::vector<Entry> brake;    ///< where the heat of the band brake went
    double brake_heat = 0;       ///< J, put into the lining
    double lining = 0, drum = 0; ///< K, hottest of the run

    /// J: the larger of what was put in and what was taken out.
    double turned_over() const;
    /// What is not accounted for, as a share of what was turned over.
    double open() const;
};

/// Let go in 25 m, ship falling astern, brought to a stop at 55 m.
Balance let_go(const Machine& machine);
/// Walked back under power to the bottom in 60 m, and on.
Balance walk_back(const Machine& machine);
/// Let go and dug in, then hove in: cable off the ground, anchor broken out and home.
Balance weigh(const Machine& machine);
/// Let run until the cable is gone, the bitter end with it.
Balance run_out(const Machine& machine);

} // namespace windlass::lab
