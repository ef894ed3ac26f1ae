#pragma once
// The ship's windlasses with the hands on their levers and the eyes on them, each moved when its turn comes,
// or two together while their cables lie near each other.

#include "server/exercise/definition/exercise_def.hpp"
#include "server/exercise/faults/faults.hpp"
#include "server/exercise/tick/anchor_party.hpp"
#include "server/exercise/watch/event_detector.hpp"
#include "server/physics/ship/hull_surface.hpp"
#include "server/physics/ship/ship.hpp"
#include "server/physics/tackle/cable_crossing.hpp"

#include <optional>
#include <span>
#include <vector>

namespace windlass::exercise {

/// One side: the machine, the hands on its levers, the eyes on it.
struct Bower {
    Side side;
    physics::GroundTackle tackle;
    EventDetector event_detector;
    physics::WindlassLevers levers;
    AnchorParty party;
    physics::ShipState from;                      ///< where the ship was at the tackle's last step
    physics::CablePull pull;                      ///< of that step
    physics::Vec3 moment = physics::Vec3::Zero(); ///< N m, world, about midships on the waterline, of that
                                                  ///< step; all of what pull has about the vertical only
    int waited = 0;                               ///< ticks since
    bool touched = false;                         ///< levers moved since
    /// Ticks, in a state that is brought back; GroundTackle::stride() asks for 12 at most.
    static constexpr int kMaxWaited = 100;

    Bower(const ExerciseDef& exercise, const GroundTackleDef& def, const physics::ObstacleMesh& hull,
          const physics::ShipState& ship);
};
template <class Visitor, physics::StateOf<Bower> Self>
void visit_state(Visitor& v, Self& self);

/// What is wrong with its windlass now: faults, and what men have done about them.
physics::EquipmentFaults causes(const Bower& bower, const FaultBook& faults);

/// What the world is to the deck in one tick.
struct DeckTick {
    const physics::EnvironmentDef& environment;
    const physics::ShipState& ship; ///< as it is now
    const FaultBook& faults;
    const EventLog& log;
    double wave_height = 0; ///< m, significant
    double wave_period = 0; ///< s, of the longest waves that count
    /// N, level, world: what all but her cables does to her when she lies at rest as she heads.
    physics::Vec3 force_at_rest = physics::Vec3::Zero();
    std::uint64_t number = 0;
    double dt = 0; ///< s
};

/// Links and contacts that the steps of a tick go over before what is left of the tick is taken in one step.
/// The server's core has 3.3 ms for a tick, which 2^17 of them take. The shipped exercises come to 7 000,
/// links of 0.3 m to 38 000; a state from outside, links that all lie in one place, may ask for millions.
inline constexpr std::int64_t kMaxTickVisits = 1 << 17;

/// The stations of one ship.
class Deck {
public:
    /// Throws std::invalid_argument for no tackle, more than two, or the same side twice.
    Deck(const ExerciseDef& def, const physics::ShipState& ship);

    /// Moves each tackle whose turn it is up to where the ship is now. False when one ceased to be finite.
    bool step(const DeckTick& tick);

    /// Moves those that are behind. One that ceases to be finite is found so in the next step.
    void catch_up(const DeckTick& tick);

    /// Throws physics::StateError where, in a state that was brought back, a hawse pipe is not near where its
    /// cable was left some ticks ago: now, or as the ship is expected next. What jumps tears cables.
    void hold_together(const physics::StateVisitor& v, const physics::ShipState& now,
                       const physics::ShipState& next) const;

    std::vector<Bower>& bowers() { return bowers_; }
    const std::vector<Bower>& bowers() const { return bowers_; }
    unsigned substeps() const { return substeps_; } ///< most that a tackle needed in the last tick
    /// What the last tick's steps have cost: links and contacts, each time that an iteration went over them,
    /// and pairs of links of two cables that were looked at.
    std::int64_t visits() const { return all_visits() - visits_before_; }

    template <class Visitor, physics::StateOf<Deck> Self>
    friend void visit_state(Visitor& v, Self& self);

private:
    bool work(std::span<Bower> gang, double seconds, const DeckTick& tick);
    std::int64_t all_visits() const;
    CableStrain strain(const Bower& bower, const DeckTick& tick) const;

    physics::ShipDef ship_;
    int max_substeps_;
    physics::ObstacleMesh hull_;
    std::vector<Bower> bowers_;
    std::optional<physics::CableCrossing> crossing_; ///< of two cables
    bool near_ = false;                              ///< they were near each other when last looked at
    unsigned substeps_ = 1;
    std::int64_t visits_before_ = 0; ///< the last tick
};

/// Where the ship of an exercise starts, and how she moves; level: m, world, of the water.
physics::ShipState ship_start(const ShipStartDef& def, double level);

} // namespace windlass::exercise
