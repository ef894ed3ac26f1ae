#pragma once
// Whether a method stays bounded, and if not, how it fails.

#include "bench/lab/case/case.hpp"

#include <array>

namespace windlass::lab {

/// What became of a run. Of several faults the gravest is told.
enum class Fate {
    bounded,
    grew,         ///< more energy than the start and the ends' motion can have given it
    stretched,    ///< a link beyond all reason
    not_a_number, ///< a place or a tension
    unsolved,     ///< else bounded, but the method could not solve a step and went on
    too_long,     ///< no fault as far as it went
    cannot        ///< the method cannot do the case
};
inline constexpr std::array kFateNames{"bounded",  "energy grew", "stretched", "not a number",
                                       "unsolved", "too long",    "cannot"}; ///< in that order

/// Where a fault begins.
struct FaultLimits {
    /// Energy above that at play, of it: ten times the drift of any method here that is bounded.
    double energy = 0.1;
    /// Least strain that is beyond all reason: six times what breaks the chain.
    double strain = 0.05;
    /// The same, of the strain that the whole energy at play gives the whole line: waves meet, but not so.
    double strain_of_energy = 3;
    double max_seconds = 1e9; ///< s of processor time; a run that would need more is given up
};

/// A run that was judged.
struct Verdict {
    Fate fate = Fate::bounded;
    double when = 0;      ///< s of the first fault, or the whole duration
    double strain = 0;    ///< largest of any link
    double energy = 0;    ///< largest above the lowest, of that at play
    double cost = 0;      ///< ms of processor time for a simulated second
    std::string why = {}; ///< of cannot
};

/// J: what a run can at most have above the energy of the line hanging straight down: what the start has, the
/// kinetic energy of the whole line at the largest speed of its ends, and the stretch under its own weight.
double energy_at_play(const Problem& problem, int links);

/// Runs a case with rate steps in a second and judges it: strain and places in every step, energy 120 times
/// in a second at most.
Verdict judge(const Case& given, const MethodEntry& method, int links, int rate, const FaultLimits& limits);

} // namespace windlass::lab
