#pragma once
// Looks at the steps that the model takes, and tells the instructor and the recording of those that were not
// what they should be.

#include "server/exercise/faults/faults.hpp"
#include "server/physics/solver/step_counts.hpp"

#include <string>

namespace windlass::exercise {

/// Looks every ten seconds. While the steps of the last ten are in doubt (physics::in_doubt) it says so,
/// once; what was counted it tells once a minute (event "model.steps", value: the share of steps), and
/// nothing where nothing was.
class ModelWatch {
public:
    /// After each tick; rate: ticks a second; counts: of all cables, since the start.
    void look(std::uint64_t tick, int rate, const physics::StepCounts& counts, const EventLog& log);

    bool in_doubt() const { return in_doubt_; }
    /// Steps between the last two looks.
    const physics::StepCounts& last() const { return last_; }

    template <class Visitor, physics::StateOf<ModelWatch> Self>
    friend void visit_state(Visitor& v, Self& self);

private:
    physics::StepCounts last_;
    physics::StepCounts looked_, told_; ///< all of them, at the last look, and when they were told
    bool in_doubt_ = false;
};

/// "3000 steps: 12 of first order (implicit), 1 unsolved" and so on: the kinds that there are.
std::string words(const physics::StepCounts& counts);

} // namespace windlass::exercise
