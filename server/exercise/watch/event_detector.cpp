#include "server/exercise/watch/event_detector.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace windlass::exercise {

using physics::Clutch;

namespace {

static_assert(words::limits::lining_smokes == physics::kFadeStart, "smoke is where a lining begins to fade");

constexpr double kSettleTime = 0.5;   ///< s a phase must last before it is called
constexpr double kLeaves = 5;         ///< s off the bottom, of an anchor that no longer hops along it
constexpr double kBack = 10;          ///< s on it again, of one that was called off it
constexpr double kRunningSpeed = 0.5; ///< m/s, cable that runs rather than creeps
constexpr double kHeldSpeed = 0.02;   ///< m/s, cable that is held
constexpr double kDigging = 0.1;      ///< m within half a minute, of an anchor that digs in
constexpr double kHeap = 0.3;         ///< m of chain under the gypsy that anyone sees
constexpr double kWedged = 0.2;       ///< of the hawse pipe's efficiency left to a twisted cable
constexpr double kCooled = 100;       ///< K below smoking; a hand that hunts makes a lining swing by 60
constexpr double kBrakeOff = 0.5;     ///< of the hand-wheel, from where it holds no anchor's weight
constexpr double kStands = 0.005;     ///< m/s, cable that stands, and is not lowered however slowly
constexpr double kStandsLong = 3;     ///< s for which it must stand before anybody says that it does not run
constexpr double kCalled = -1;        ///< of stood_
constexpr int kMaxShackles = 1000;    ///< in a state that is brought back: more than any cable has

std::string text(const char* format, double value) {
    char buffer[128];
    std::snprintf(buffer, sizeof buffer, format, value);
    return buffer;
}

/// s that a phase must last before it is called. An anchor that is hove along the bottom hops, and is not
/// aweigh with every hop.
double settle_time(AnchorPhase was, AnchorPhase now, bool landed) {
    const auto off = [](AnchorPhase phase) {
        return phase == AnchorPhase::aweigh || phase == AnchorPhase::fouled;
    };
    if (off(now) && !landed) return off(was) ? kSettleTime : kLeaves;
    return off(was) && landed ? kBack : kSettleTime;
}

bool has(Run run, Run which) {
    return (static_cast<int>(run) & static_cast<int>(which)) != 0;
}

void set(Run& run, Run which, bool on) {
    const int others = static_cast<int>(run) & ~static_cast<int>(which);
    run = static_cast<Run>(on ? others | static_cast<int>(which) : others);
}

/// Whether cable is to run out: let go, or lowered by the motor.
bool is_to_run_out(const physics::WindlassState& state) {
    const bool lowered = state.clutch.position == Clutch::in && state.motor.target > 0;
    return state.brake.position < kBrakeOff && !state.stopper.closed &&
           (lowered || state.clutch.position != Clutch::in);
}

/// Calls when a condition comes up, not while it lasts.
template <class Call>
void on_rise(bool& was, bool is, const Call& call) {
    if (is && !was) call();
    was = is;
}

} // namespace

EventDetector::EventDetector(Side side, const physics::GroundTackle& tackle) : side_(static_cast<int>(side)) {
    phase_ = candidate_ = look(tackle);
    shackles_ = static_cast<int>(physics::shackles_from_metres(tackle.windlass().state().cable_out));
}

AnchorPhase EventDetector::look(const physics::GroundTackle& tackle) const {
    const physics::Anchor& anchor = tackle.anchor();
    const physics::HoldingState& holding = anchor.holding();
    if (tackle.chain().parted >= 0) return AnchorPhase::lost;
    if (holding.landed) {
        if (anchor.wound()) return AnchorPhase::fouled; // which drags as a rule
        if (way_.dragging()) return AnchorPhase::dragging;
        if (way_.moved_in_half_minute() > kDigging && !way_.still()) return AnchorPhase::digging_in;
        return holding.embedment > kGrip ? AnchorPhase::holding : AnchorPhase::on_bottom;
    }
    if (tackle.home()) return AnchorPhase::housed;
    if (was_on_bottom_ && anchor.foul() > 0) return AnchorPhase::fouled;
    if (tackle.at_hawse()) return AnchorPhase::acockbill;
    return was_on_bottom_ ? AnchorPhase::aweigh : AnchorPhase::hanging;
}

void EventDetector::watch(double dt, const physics::GroundTackle& tackle,
                          const physics::EnvironmentDef& environment, const CableStrain& strain,
                          const EventLog& log) {
    const physics::HoldingState& holding = tackle.anchor().holding();
    const physics::ChainState& chain = tackle.chain();
    const bool parted = chain.parted >= 0, taut = chain.tension[0] > 0;
    const Riding riding{.dt = dt,
                        .pull = strain.pull,
                        .asked = strain.asked,
                        .wave_period = strain.wave_period,
                        .dragged = holding.dragged,
                        .embedment = holding.embedment,
                        .setting = setting_distance(tackle.setup().anchor, tackle.anchor().soil(environment)),
                        .landed = holding.landed && !parted,
                        .taut = taut,
                        .held = std::abs(tackle.windlass().state().cable_speed) < kHeldSpeed};
    way_.observe(riding);
    const AnchorPhase now = look(tackle);
    candidate_time_ = now == candidate_ ? candidate_time_ + dt : 0;
    candidate_ = now;
    // Touching the bottom is called at once; the rest when it has settled.
    const bool touched = tackle.anchor().holding().landed && !was_on_bottom_;
    if (touched) {
        was_on_bottom_ = true;
        set(run_, Run::let_go, false);
        phase_ = candidate_ = AnchorPhase::on_bottom;
        log("anchor.on_bottom", side_, tackle.windlass().state().cable_out);
    } else if (now != phase_ && candidate_time_ >= settle_time(phase_, now, holding.landed)) {
        call_phase(now, tackle, log);
    }
    call_cable(tackle, log);
    call_machine(tackle, log);
    call_fast(dt, tackle.windlass(), log);
    if (phase_ == AnchorPhase::fouled) brought_up_ = {};
    if (brought_up_.observe(riding, way_)) {
        const double out = physics::shackles_from_metres(tackle.windlass().state().cable_out);
        log("anchor.brought_up", side_, out);
    }
}

bool EventDetector::runs_away() const {
    return has(run_, Run::away);
}

void EventDetector::call_phase(AnchorPhase now, const physics::GroundTackle& tackle, const EventLog& log) {
    phase_ = now;
    const double used = tackle.anchor().soil_force();
    switch (now) {
    case AnchorPhase::digging_in:
        log("anchor.digging_in", side_, used);
        break;
    case AnchorPhase::holding:
        log("anchor.holding", side_, used);
        break;
    case AnchorPhase::dragging:
        log("anchor.dragging", side_, used);
        break;
    case AnchorPhase::aweigh:
        log("anchor.aweigh", side_, tackle.windlass().state().cable_out);
        break;
    case AnchorPhase::fouled:
        log("anchor.fouled", side_, tackle.windlass().state().cable_out,
            tackle.anchor().holding().landed ? "anchor is foul of her own cable" : "anchor comes up foul");
        break;
    case AnchorPhase::acockbill:
        log("anchor.acockbill", side_, tackle.windlass().state().cable_out);
        was_on_bottom_ = false;
        break;
    case AnchorPhase::housed:
        log("anchor.housed", side_, 0);
        was_on_bottom_ = false;
        break;
    default:
        break;
    }
}

void EventDetector::call_cable(const physics::GroundTackle& tackle, const EventLog& log) {
    const physics::WindlassState& windlass = tackle.windlass().state();
    on_rise(flukes_inboard_, tackle.flukes_inboard(),
            [&] { log("anchor.flukes_inboard", side_, windlass.cable_out); });
    const bool runs =
        windlass.cable_speed > kRunningSpeed && windlass.clutch.position != Clutch::in && !was_on_bottom_;
    if (runs && !has(run_, Run::let_go)) {
        set(run_, Run::let_go, true);
        log("anchor.let_go", side_, windlass.cable_out);
    }
    // It is called once, until the cable is no faster than practice lets it run.
    if (windlass.cable_speed > words::limits::cable_runaway && !has(run_, Run::away)) {
        set(run_, Run::away, true);
        log("cable.runaway", side_, windlass.cable_speed);
    } else if (windlass.cable_speed < words::limits::cable_fast) {
        set(run_, Run::away, false);
    }
    const double out = physics::shackles_from_metres(windlass.cable_out);
    // A quarter of a shackle of play, so that a cable working at a mark is called once: going out, a mark is
    // called at the lip, coming in once it has come as far as the windlass. shackles_ are those that are out
    // in full; the mark that comes in is the next one.
    if (out >= shackles_ + 1) {
        shackles_ = static_cast<int>(out);
        log("cable.shackle", side_, shackles_,
            text(shackles_ == 1 ? "%.0f shackle in the pipe" : "%.0f shackles in the pipe", shackles_));
    } else if (out < shackles_ - 0.25) {
        shackles_ = static_cast<int>(out);
        log("cable.shackle", side_, shackles_ + 1,
            text(shackles_ == 0 ? "%.0f shackle on deck, heaving" : "%.0f shackles on deck, heaving",
                 shackles_ + 1));
    }
    on_rise(end_, windlass.cable_out >= tackle.bitter_end() && !windlass.chain_gone,
            [&] { log("cable.bitter_end", side_, tackle.windlass().loads().deck.bitter_end); });
    on_rise(end_parted_, windlass.bitter_end_parted,
            [&] { log("cable.bitter_end_parted", side_, tackle.windlass().loads().deck.bitter_end); });
    on_rise(turned_, tackle.twist() > physics::free_twist(), [&] {
        log("cable.turns", side_, tackle.turns(),
            text("%.1f turns in the cable: links no longer lie fair", std::abs(tackle.turns())));
    });
    on_rise(wedged_, physics::twisted_efficiency(tackle.twist()) < kWedged,
            [&] { log("cable.wedged", side_, tackle.turns()); });
    on_rise(lost_, tackle.chain().parted >= 0, [&] {
        if (windlass.chain_gone) {
            if (windlass.bitter_end_parted)
                log("cable.lost", side_, windlass.cable_out);
            else
                log("cable.slipped", side_, windlass.cable_out);
        } else {
            log("cable.parted", side_, tackle.strain().parted_by,
                text("cable has parted %.0f m from the anchor: anchor lost",
                     tackle.chain().parted * tackle.setup().chain.node_spacing));
        }
    });
}

void EventDetector::call_machine(const physics::GroundTackle& tackle, const EventLog& log) {
    const physics::Windlass& windlass = tackle.windlass();
    const physics::WindlassState& state = windlass.state();
    const physics::WindlassDef& def = windlass.def();
    const double speed = std::abs(state.cable_speed);
    on_rise(hot_, state.brake.skin > physics::kFadeStart - (hot_ ? kCooled : 0),
            [&] { log("brake.hot", side_, state.brake.skin); });
    on_rise(slipping_, state.brake.position > kHardOn && state.cable_speed > 0.05,
            [&] { log("brake.slipping", side_, windlass.loads().brake); });
    on_rise(tripped_, state.motor.tripped,
            [&] { log("motor.overload_trip", side_, windlass.loads().deck.motor); });
    const bool driven = state.clutch.position == Clutch::in && !state.motor.burst &&
                        speed > physics::kOverspeedTrip * physics::light_line_speed(def);
    on_rise(overspeed_, driven, [&] { log("motor.overspeed", side_, speed); });
    on_rise(overspeed_trip_, state.motor.overspeed,
            [&] { log("motor.overspeed_trip", side_, state.motor.worst_speed); });
    on_rise(burst_, state.motor.burst, [&] { log("motor.burst", side_, state.motor.worst_speed); });
    on_rise(sheared_, state.clutch.sheared,
            [&] { log("clutch.sheared", side_, windlass.loads().deck.gypsy_load); });
    on_rise(jumping_, state.gypsy.jumping,
            [&] { log("gypsy.jumping", side_, windlass.loads().deck.gypsy_load); });
    on_rise(sprung_, state.stopper.sprung,
            [&] { log("stopper.sprung", side_, windlass.loads().deck.gypsy_load); });
    on_rise(heaping_, physics::heaped(state.pipe, state.cable_out) > kHeap,
            [&] { log("spurling_pipe.heaping", side_, state.cable_out); });
    on_rise(glazed_, state.brake.glaze > 0.2, [&] { log("brake.glazed", side_, state.brake.glaze); });
    on_rise(clutch_refused_, state.clutch.refused, [&] {
        log("clutch.refused", side_, state.cable_speed,
            state.clutch.position == Clutch::in ? "clutch is loaded and does not come out"
            : state.clutch.sheared              ? "clutch is broken"
            : std::abs(state.cable_speed) < physics::kEngageSpeed
                ? "clutch teeth are not in line: turn the motor over slowly"
                : "clutch does not go in while the gypsy turns");
    });
    on_rise(brake_waits_, state.brake.waits, [&] { log("brake.waits", side_, state.brake.position); });
    on_rise(stopper_refused_, state.stopper.refused, [&] {
        log("stopper.refused", side_, windlass.loads().stopper,
            state.stopper.closed ? "stopper bar is loaded and does not lift"
                                 : "stopper cannot be closed on running chain");
    });
    on_rise(overstrained_, tackle.chain().stretched > 0,
            [&] { log("cable.overstrained", side_, tackle.strain().worst); });
    const double breaking = physics::breaking_load(tackle.setup().chain);
    on_rise(overload_, windlass.loads().deck.hawse_tension > breaking,
            [&] { log("cable.overload", side_, windlass.loads().deck.hawse_tension); });
}

/// Called once for each try, when it shows: a motor drags cable out through a jam that would hold the
/// anchor's weight, and then nobody can tell that there is one. Without a jam nothing is remembered.
void EventDetector::call_fast(double dt, const physics::Windlass& windlass, const EventLog& log) {
    const physics::WindlassState& state = windlass.state();
    if (!state.pipe.jammed || !is_to_run_out(state)) {
        stood_ = 0;
        return;
    }
    if (stood_ == kCalled) return;
    const double jam = windlass.loads().jam;
    if (state.cable_speed > kRunningSpeed) {
        stood_ = kStandsLong; // of cable that ran it shows at once
    } else if (jam > 0 && state.cable_speed < kStands) {
        stood_ += dt;
        if (stood_ <= kStandsLong) return;
        stood_ = kCalled;
        log("spurling_pipe.fast", side_, jam);
    } else if (stood_ < kStandsLong) {
        stood_ = 0;
    }
}

template <class Visitor, physics::StateOf<EventDetector> Self>
void visit_state(Visitor& v, Self& self) {
    WINDLASS_STATE(v, self.phase_, self.candidate_, self.candidate_time_, self.was_on_bottom_, self.run_,
                   self.shackles_, self.way_, self.brought_up_, self.hot_, self.slipping_, self.tripped_,
                   self.overspeed_, self.overload_, self.overspeed_trip_, self.burst_, self.sheared_,
                   self.jumping_, self.sprung_, self.glazed_, self.end_parted_, self.lost_,
                   self.overstrained_, self.clutch_refused_, self.stopper_refused_, self.brake_waits_,
                   self.end_, self.stood_, self.heaping_, self.turned_, self.wedged_, self.flukes_inboard_);
    v.within({"shackles"}, self.shackles_, 0, kMaxShackles);
    v.within({"stood"}, self.stood_, kCalled, kStandsLong);
}
WINDLASS_STATE_LISTED(EventDetector);

} // namespace windlass::exercise
