#include "server/exercise/tick/anchor_party.hpp"

#include "server/exercise/watch/event_detector.hpp"
#include "server/physics/base/state_limits.hpp"
#include "server/physics/chain/shackle_marks.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::exercise {

using namespace physics;

namespace {

constexpr double kMoves = 0.05; // m/s, of the cable
// m, from the surface to its middle: its flukes are within reach of a boathook
constexpr double kAtTheWater = 1.5;
constexpr double kFoul = 0.05;    // of what an old cable is
constexpr double kShare = 0.2;    // of the cable's pull, that brake and motor may have left of it
constexpr double kBuoyTime = 180; // s, of breaking the cable: the buoy comes first

/// Whether a joining shackle lies on deck, where men get at it: inboard of the pipe, and not on the gypsy
/// yet.
bool shackle_on_deck(const GroundTackle& tackle) {
    const ChainDef& chain = tackle.setup().chain;
    for (int k = 1; k <= joining_shackles(chain); ++k) {
        const double inboard = stretched_length(chain, tackle.chain(), shackle_mark(chain, k).from_anchor) -
                               tackle.windlass().state().cable_out;
        if (inboard > words::limits::mark_in_pipe && inboard < words::limits::seen_on_deck) return true;
    }
    return false;
}

/// Share of her pumps' flow at full pressure that a windlass still has, 0..1.
double fed(const EquipmentFaults& causes) {
    return (1 - causes.power_lost) * (1 - causes.pumps_lost);
}

/// What is left of a windlass's flow when one of the other one's pumps feeds it.
EquipmentFaults fed_by(const EquipmentFaults& other, const WindlassDef& windlass) {
    EquipmentFaults causes;
    causes.power_lost = other.power_lost;
    causes.pumps_lost = std::max(other.pumps_lost, 1 - 1.0 / std::max(1, windlass.hydraulic_pumps));
    return causes;
}

} // namespace

double deck_work_time(DeckWork work) {
    switch (work) {
    case DeckWork::none:
        break;
    case DeckWork::clear_anchor:
        return 480;
    case DeckWork::break_cable:
        return 600;
    case DeckWork::slip:
        return 5;
    case DeckWork::cross_connect:
        return 300;
    }
    return 0;
}

void AnchorParty::set_to(DeckWork work, Side side, const EventLog& log) {
    if (work == set_) return;
    set_ = work;
    waits_ = DeckHindrance::none;
    if (work == DeckWork::none)
        log("deck_work.ended", static_cast<int>(side), 0);
    else
        log("deck_work.begun", static_cast<int>(side), deck_work_time(work) - worked(work),
            "men begin: " + std::string(words::row_of(work).said));
}

double AnchorParty::left() const {
    return std::max(0.0, deck_work_time(set_) - worked(set_));
}

DeckHindrance AnchorParty::hindrance(const Place& place) const {
    const Windlass& windlass = place.tackle.windlass();
    const WindlassState& state = windlass.state();
    const bool still = std::abs(state.cable_speed) < kMoves;
    switch (set_) {
    case DeckWork::none:
        break;
    case DeckWork::clear_anchor:
        if (!still) return DeckHindrance::cable_moves;
        if (!state.stopper.closed) return DeckHindrance::stopper_off;
        if (state.brake.position < kHardOn) return DeckHindrance::brake_off;
        if (std::abs(place.tackle.anchor().pose().position.z() - place.level) > kAtTheWater)
            return DeckHindrance::anchor_not_at_water;
        if (place.tackle.anchor().holding().fouled < kFoul) return DeckHindrance::nothing_to_slip;
        break;
    case DeckWork::break_cable: {
        if (has(DeckWork::break_cable)) break;
        if (!still) return DeckHindrance::cable_moves;
        if (!state.stopper.closed) return DeckHindrance::stopper_off;
        const WindlassLoads& loads = windlass.loads();
        if (loads.brake + loads.shaft_brake + loads.deck.motor >
            kShare * std::max(0.0, loads.deck.gypsy_load))
            return DeckHindrance::weight_on_brake;
        if (!shackle_on_deck(place.tackle)) return DeckHindrance::no_shackle_on_deck;
        break;
    }
    case DeckWork::slip:
        if (!has(DeckWork::break_cable)) return DeckHindrance::not_broken;
        break;
    case DeckWork::cross_connect:
        if (windlass.def().drive != DriveKind::hydraulic) return DeckHindrance::not_hydraulic;
        if (place.levers.speed != 0) return DeckHindrance::lever_over;
        if (fed(place.other) <= 0) return DeckHindrance::other_dead;
        break;
    }
    return DeckHindrance::none;
}

DeckWork AnchorParty::work(const Place& place, double dt, const EventLog& log) {
    if (set_ == DeckWork::none || left() <= 0) return DeckWork::none;
    const int side = static_cast<int>(place.side);
    const DeckHindrance before = std::exchange(waits_, hindrance(place));
    const bool at_the_cable = set_ == DeckWork::clear_anchor || set_ == DeckWork::break_cable;
    const bool moves = at_the_cable && worked(set_) > 0 && waits_ == DeckHindrance::cable_moves;
    if (moves && !endangered_)
        log("deck_work.endangered", side, place.tackle.windlass().state().cable_speed,
            "the cable moves while men are at it: " + std::string(words::row_of(set_).said));
    endangered_ = moves;
    if (waits_ != DeckHindrance::none) {
        if (waits_ != before)
            log("deck_work.waits", side, 0, "men wait: " + std::string(words::row_of(waits_).said));
        return DeckWork::none;
    }
    double& worked = worked_[static_cast<std::size_t>(set_)];
    const double was = std::exchange(worked, std::min(worked + dt, deck_work_time(set_)));
    if (set_ == DeckWork::break_cable && was < kBuoyTime && worked >= kBuoyTime) log("cable.buoyed", side, 0);
    if (left() > 0) return DeckWork::none;
    if (set_ == DeckWork::break_cable) log("cable.broken", side, place.tackle.windlass().state().cable_out);
    if (set_ == DeckWork::cross_connect) log("windlass.cross_connected", side, 0);
    if (set_ == DeckWork::clear_anchor) {
        log("anchor.cleared", side, 0);
        worked = 0; // it may come up foul again
        set_ = DeckWork::none;
        return DeckWork::clear_anchor;
    }
    return set_;
}

void AnchorParty::lay(const WindlassDef& windlass, const EquipmentFaults& other,
                      EquipmentFaults& causes) const {
    if (has(DeckWork::slip)) causes.cable_slipped = 1;
    if (!has(DeckWork::cross_connect)) return;
    const EquipmentFaults crossed = fed_by(other, windlass);
    if (fed(crossed) <= fed(causes)) return;
    causes.power_lost = crossed.power_lost;
    causes.pumps_lost = crossed.pumps_lost;
}

WindlassLevers AnchorParty::acting(WindlassLevers levers) const {
    if (!has(DeckWork::break_cable)) return levers;
    levers.stopper_closed = true;
    levers.speed = 0;
    return levers;
}

template <class Visitor, StateOf<AnchorParty> Self>
void visit_state(Visitor& v, Self& self) {
    WINDLASS_STATE(v, self.set_, self.waits_, self.endangered_);
    for (std::size_t k = 0; k < self.worked_.size(); ++k) {
        v.field({"worked"}, self.worked_[k]);
        if constexpr (Visitor::kRestores)
            v.within({"worked"}, self.worked_[k], 0, deck_work_time(static_cast<DeckWork>(k)));
    }
}
WINDLASS_STATE_LISTED(AnchorParty);

} // namespace windlass::exercise
