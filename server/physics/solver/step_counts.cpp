#include "server/physics/solver/step_counts.hpp"

namespace windlass::physics {

StepCounts operator+(const StepCounts& a, const StepCounts& b) {
    return {a.steps + b.steps,       a.implicit + b.implicit, a.unsolved + b.unsolved,
            a.friction + b.friction, a.contacts + b.contacts, a.dropped + b.dropped,
            a.capped + b.capped};
}

StepCounts operator-(const StepCounts& later, const StepCounts& earlier) {
    return {later.steps - earlier.steps,       later.implicit - earlier.implicit,
            later.unsolved - earlier.unsolved, later.friction - earlier.friction,
            later.contacts - earlier.contacts, later.dropped - earlier.dropped,
            later.capped - earlier.capped};
}

bool in_doubt(const StepCounts& counts) {
    // One step in so many; tuned, but for friction: where a cable comes to strain on the bed one step in ten
    // to three has it from the step's start, and its error is no larger there (bench/error_coverage.cpp).
    constexpr std::uint64_t kMaxImplicit = 10, kMaxCapped = 20, kMaxFriction = 2;
    return counts.unsolved > 0 || counts.dropped > 0 || counts.capped * kMaxCapped > counts.steps ||
           counts.implicit * kMaxImplicit > counts.steps || counts.friction * kMaxFriction > counts.steps;
}

template <class Visitor, StateOf<StepCounts> State>
void visit_state(Visitor& v, State& state) {
    auto& [steps, implicit, unsolved, friction, contacts, dropped, capped] = state;
    WINDLASS_STATE(v, steps, implicit, unsolved, friction, contacts, dropped, capped);
}
WINDLASS_STATE_LISTED(StepCounts);

} // namespace windlass::physics
