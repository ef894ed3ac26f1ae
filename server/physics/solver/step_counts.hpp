#pragma once
// How many steps of a cable were taken, and how many of them were not what they should be, by kind. None of
// these is a blow-up; each makes a step first order, or leaves something out of it.

#include "server/physics/base/state_visitor.hpp"

#include <cstdint>

namespace windlass::physics {

/// Steps since the start. One step may be in several kinds.
struct StepCounts {
    std::uint64_t steps = 0;
    std::uint64_t implicit = 0; ///< too long for their tension, or hard to solve: implicit Euler, damped
    std::uint64_t unsolved = 0; ///< of these, those whose iteration ended before the nodes were still
    std::uint64_t friction = 0; ///< whose sliding on the bed was not found: friction as at the step's start
    std::uint64_t contacts = 0; ///< whose contacts were still coming and going when it ended
    std::uint64_t dropped = 0;  ///< in which a list of contacts was full: some were left out
    std::uint64_t capped = 0;   ///< longer than their tension asks for: the most substeps were not enough

    bool operator==(const StepCounts&) const = default;
};
template <class Visitor, StateOf<StepCounts> State>
void visit_state(Visitor& v, State& state);

/// The steps of both; of steps that came after others.
StepCounts operator+(const StepCounts& a, const StepCounts& b);
StepCounts operator-(const StepCounts& later, const StepCounts& earlier);

/// Whether results may no longer be trusted to what is published of their error, on these counts of some
/// seconds: a step that was not solved, something left out, steps that are too long all the time, or more
/// than a share of steps of first order. What these shares go by is in docs/physics.md.
bool in_doubt(const StepCounts& counts);

} // namespace windlass::physics
