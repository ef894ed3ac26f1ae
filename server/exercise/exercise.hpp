#pragma once
// One exercise: ship, ground tackle and faults, advanced tick by tick. Knows no clock, thread, topic or file.

#include "server/exercise/definition/orders.hpp"
#include "server/exercise/picture/snapshot.hpp"
#include "server/physics/base/state_visitor.hpp"

#include <memory>

namespace windlass::exercise {

/// The whole simulated world of one exercise. Deterministic: the same definition and the same commands at
/// the same ticks give the same bits.
class Exercise {
public:
    /// Throws std::invalid_argument when the definition has no tackle, more than two, or the same side twice.
    /// One that starts at anchor plays its prelude (prelude.hpp), unless the definition has its outcome:
    /// seconds of computing, and std::runtime_error when she cannot be brought up.
    explicit Exercise(const ExerciseDef& def);
    /// Without prelude and faults: to be brought to a state that somebody has kept.
    static Exercise blank(const ExerciseDef& def);
    ~Exercise();
    Exercise(Exercise&&) noexcept;
    Exercise& operator=(Exercise&&) noexcept;

    /// Takes an order, to act from the next step on. Values must be finite and in range.
    void apply(const Order& command);

    /// Advances by one tick of dt seconds (1 / tick_rate_hz). Allocates nothing in the steady state.
    /// Returns false when the state ceased to be finite: no view of it may be published then.
    bool step(double dt);

    /// Everything that changes, for whoever keeps it or brings it back; see physics/base/state_visitor.hpp. A
    /// state that is brought back must be one of an exercise of the same definition.
    void visit_state(physics::ConstStateVisitor& v) const;
    void visit_state(physics::StateVisitor& v);

    /// Copies what can be seen from outside into snapshot, reusing its memory. Events of the last tick only.
    void view(Snapshot& snapshot) const;
    /// The same but for the hash of the state, which costs as much as a third of a step: 0, not known.
    void view_unhashed(Snapshot& snapshot) const;

    /// Whether anything was called out in the last tick.
    bool called() const;
    /// What the steps of the last tick have cost, as a count that is the same on every machine
    /// (Deck::visits).
    std::int64_t visits() const;

    /// The levers of a windlass and of the helm as they were last ordered.
    WindlassOrder levers(Side side) const;
    HelmOrder helm() const;
    /// Whether another simulator moves the ship.
    bool foreign() const;
    /// Whether nothing is heard of it any more, so that she lies still.
    bool foreign_lost() const;

    /// Whether the ship is brought up to the anchor of that side; false where there is none.
    bool brought_up(Side side) const;
    /// Whether the cable of that side runs away, from the event of it until it is no faster than practice
    /// lets it run; false where there is none.
    bool runs_away(Side side) const;
    /// Whether its protection has cut off that side's windlass motor, on overload or overspeed, and nobody
    /// has reset it; false where there is none.
    bool motor_tripped(Side side) const;

    const ExerciseDef& def() const;
    std::uint64_t tick() const;
    double time() const; ///< s

private:
    struct World;
    explicit Exercise(std::unique_ptr<World> world);
    std::unique_ptr<World> world_;
};

} // namespace windlass::exercise
