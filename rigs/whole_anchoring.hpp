#pragma once
// A whole anchoring: let go, brought up, lying to the anchor, weighed. Worked once by events, it can be given
// to other models of the same exercise order by order, and what they make of it compared.

#include "rigs/drill.hpp"

namespace windlass::rigs {

/// Orders of a whole anchoring and what it took.
struct Anchoring {
    std::vector<GivenOrder> orders;
    std::uint64_t brought_up = 0, weigh = 0, end = 0; ///< ticks: brought up, heaving begins, anchor aweigh
};

/// Gives the orders of an anchoring again to another run of it: while the cable runs at the same marks, as a
/// hand on the brake would, else at the same ticks. A mark that the cable stops short of is not waited for.
class SameHand {
public:
    SameHand(const Anchoring& anchoring, int tick_rate_hz);
    /// Gives what is due after the exercise's last tick.
    void work(exercise::Exercise& exercise);
    bool looks() const;              ///< the next order is given at a mark
    std::uint64_t next_tick() const; ///< before which none is due

private:
    const std::vector<GivenOrder>& orders_;
    std::uint64_t late_; ///< ticks by which a mark may come earlier or later
    std::size_t next_ = 0;
    exercise::Snapshot snapshot_;
};

/// What can be compared of a moment of it.
struct Moment {
    double time = 0;      ///< s
    double gauge = 0;     ///< N, at the hawse pipe, now
    double load = 0;      ///< N, the same, mean of the second before and after
    double cable_out = 0; ///< m
    physics::ModelLevel level = physics::ModelLevel::dynamic;
    physics::ModelError error; ///< as estimated by the model
    double friction = 0; ///< share of the steps of the last ten seconds with friction of the step's start
    std::vector<physics::Vec3> nodes; ///< m, world
};

/// One run of it, and its cost.
struct AnchoringRun {
    std::vector<Moment> moments; ///< ten a second
    double cost = 0;             ///< s of processor time in Exercise::step
};

/// Gives the orders of an anchoring to an exercise (they were recorded at the same tick rate).
AnchoringRun run_anchoring(const exercise::ExerciseDef& def, const Anchoring& anchoring);

/// How far one run is from another between two ticks: load, root mean square as a fraction of the
/// reference's; shape, root mean square distance of its nodes from the reference's cable.
physics::ModelError difference(const AnchoringRun& run, const AnchoringRun& reference, std::uint64_t from,
                               std::uint64_t to, int tick_rate_hz);

/// m, root mean square distance of a moment's nodes from the cable of another run at that moment.
double shape_distance(const Moment& moment, const Moment& reference);

/// Works the exercise: lets go and pays out to the shackles, is brought up, lies for the given time (s), and
/// weighs. One that starts with its clutch in walks the cable back instead. Throws std::runtime_error naming
/// what did not happen; that she is not brought up within ten minutes, only where she must hold.
Anchoring work_anchoring(const exercise::ExerciseDef& def, int shackles, double lying, bool must_hold = true);

/// A definition and orders to be computed with so many ticks in one of theirs.
exercise::ExerciseDef at_rate(exercise::ExerciseDef def, int times);
Anchoring at_rate(Anchoring anchoring, int times);

} // namespace windlass::rigs
