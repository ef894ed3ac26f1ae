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
    constexpr std::uint64_t kMaxFirstOrder =
        10; // one step in so many; a cable that comes to rest has one in 18; tuned
    constexpr std::uint64_t kMaxCapped = 20;
    return counts.unsolved > 0 || counts.dropped > 0 || counts.capped * kMaxCapped > counts.steps ||
           (counts.implicit + counts.friction) * kMaxFirstOrder > counts.steps;
}

template <class Visitor, StateOf<StepCounts> State>
void visit_state(Visitor& v, State& state) {
    auto& [steps, implicit, unsolved, friction, contacts, dropped, capped] = state;
    WINDLASS_STATE(v, steps, implicit, unsolved, friction, contacts, dropped, capped);
}
WINDLASS_STATE_LISTED(StepCounts);

} // namespace windlass::physics
