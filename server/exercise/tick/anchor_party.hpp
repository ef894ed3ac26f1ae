#pragma once
// The men at a windlass: what the mate sets them to, how far they are, and what keeps them from going on.

#include "server/exercise/definition/orders.hpp"
#include "server/exercise/picture/event_log.hpp"
#include "server/physics/tackle/ground_tackle.hpp"

#include <array>

namespace windlass::exercise {

using words::DeckHindrance; ///< why men do not go on

/// Seconds that a work takes men who know it, from the word to "done". No source was found: assumed, at the
/// quick end of what is told on board.
double deck_work_time(DeckWork work);

/// The anchor party of one side.
class AnchorParty {
public:
    /// Where they work: the machine, its levers, the sea level (m, world) and what ails the other windlass.
    struct Place {
        Side side;
        const physics::GroundTackle& tackle;
        const physics::WindlassLevers& levers;
        double level;
        const physics::EquipmentFaults& other;
    };

    /// The mate's word. What was done of another work before stays done.
    void set_to(DeckWork work, Side side, const EventLog& log);

    /// They work on for dt (s), or wait. What they have finished in it; none: nothing.
    DeckWork work(const Place& place, double dt, const EventLog& log);

    /// What the windlass has of their work: other pumps, and a cable that is slipped. other: what ails the
    /// other windlass.
    void lay(const physics::WindlassDef& windlass, const physics::EquipmentFaults& other,
             physics::EquipmentFaults& causes) const;
    /// Levers as they act: a cable that is broken hangs on the slip, which holds it as the stopper does, and
    /// no longer on the gypsy.
    physics::WindlassLevers acting(physics::WindlassLevers levers) const;

    DeckWork set() const { return set_; }
    double left() const; ///< s
    DeckHindrance waits() const { return waits_; }
    bool has(DeckWork work) const { return worked(work) >= deck_work_time(work); }

    template <class Visitor, physics::StateOf<AnchorParty> Self>
    friend void visit_state(Visitor& v, Self& self);

private:
    double worked(DeckWork work) const { return worked_[static_cast<std::size_t>(work)]; }
    DeckHindrance hindrance(const Place& place) const;

    DeckWork set_ = DeckWork::none;
    DeckHindrance waits_ = DeckHindrance::none;
    std::array<double, words::kDeckWork.size()> worked_{}; ///< s, by DeckWork
    bool endangered_ = false;
};

} // namespace windlass::exercise
