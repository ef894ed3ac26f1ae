// Which events a seat notices, and what of them.

#include "server/perceive/perceive.hpp"
#include "server/perceive/senses.hpp"

#include "common/text.hpp"

namespace windlass::perceive {

namespace {

constexpr Notice kNever = Notice::never, kAlways = Notice::always, kAbove = Notice::anchor_above;

// Columns: code, forecastle, bridge, whether the figure goes with it, text and code in place of its own.
//
// What a figure would give away: cable out, loads, temperatures, speeds. What a text would: the cause of what
// is noticed, a figure, the instructor's title, paths of the server. What a code would: the cause.
constexpr EventRule kRules[]{
    // The anchor. What it does under water only lead, pull and tremor of the cable tell.
    {"anchor.let_go", kAlways, kNever, false}, // the cable runs
    {"anchor.on_bottom", kNever, kNever},
    {"anchor.digging_in", kNever, kNever},
    {"anchor.holding", kNever, kNever},
    {"anchor.dragging", kNever, kNever},
    {"anchor.brought_up", kNever, kNever},
    {"anchor.aweigh", kAbove, kNever, false},
    {"anchor.fouled", kAbove, kNever, false, "anchor comes up foul"},
    {"anchor.flukes_inboard", kAbove, kNever, false,
     "anchor comes up with its flukes against the ship's side"},
    {"anchor.acockbill", kAlways, kNever, false},
    {"anchor.housed", kAlways, kNever, false},

    // The cable, as far as it is on deck
    {"cable.shackle", kAlways, kNever, true}, // a painted mark passes the lip
    {"cable.bitter_end", kAlways, kNever, false},
    {"cable.bitter_end_parted", kAlways, kNever, false},
    {"cable.turns", kAlways, kNever, false, "links at the hawse pipe no longer lie fair"},
    {"cable.wedged", kAlways, kNever, false, "cable wedges at the hawse pipe lip"},
    {"cable.lost", kAlways, kNever, false},
    {"cable.parted", kAlways, kNever, false, "a jerk, and the cable hangs slack", "cable.slack"},
    {"cable.overstrained", kNever, kNever}, // a survey finds it
    {"cable.overload", kNever, kNever},     // of the truth, not of the load cell

    // The foreign simulator that moves the ship is the instructor's business
    {"own_ship.foreign", kNever, kNever},
    {"own_ship.handed_back", kNever, kNever},
    {"own_ship.jumped", kNever, kNever},
    {"own_ship.late", kNever, kNever},
    {"own_ship.lost", kNever, kNever},

    // The windlass: lamps, noise, smoke, and what stands beside the operator
    {"brake.hot", kAlways, kNever, false, "brake lining smokes"},
    {"brake.slipping", kAlways, kNever, false},
    {"brake.glazed", kNever, kNever},
    {"brake.waits", kAlways, kAlways, true},
    {"clutch.refused", kAlways, kAlways, false},
    {"clutch.sheared", kAlways, kNever, false, "a bang: the motor no longer turns the gypsy",
     "gypsy.not_driven"},
    {"gypsy.jumping", kAlways, kNever, false},
    {"motor.overload_trip", kAlways, kNever, false, "windlass motor has tripped", "motor.trip"},
    {"motor.overspeed", kAlways, kNever, false, "windlass motor runs over its speed"},
    {"motor.overspeed_trip", kAlways, kNever, false}, // a lamp of its own
    {"motor.burst", kAlways, kAlways, false},
    {"spurling_pipe.fast", kAlways, kNever, false, "cable does not run out", "cable.stands"},
    {"spurling_pipe.heaping", kAlways, kNever, false, "cable heaps up under the gypsy"},
    {"stopper.refused", kAlways, kAlways, false},
    {"stopper.sprung", kAlways, kNever, false, "stopper bar has sprung open"},

    // The ship: a shudder, and she stands
    {"ship.aground", kAlways, kAlways, false},
    {"ship.afloat", kNever, kAlways, false, "ship moves again"},

    // What is said, and who has what
    {"report.made", kAlways, kAlways, true},
    {"report.not_heard", kAlways, kNever, true}, // the VHF is lost: he hears no answer
    {"report.bell", kAlways, kAlways, false},    // strokes that both can count
    {"order.not_heard", kNever, kAlways, false},
    {"order.*", kAlways, kAlways, true}, // given, repeated, cancelled by voice
    {"levers.taken", kAlways, kAlways, true},
    {"levers.lost", kAlways, kAlways, true},
    {"command.refused", Notice::own_orders, Notice::own_orders, true},
    {"watch.*", kNever, kAlways, true},    // the anchor watch's circle, by GPS
    {"signals.*", kAlways, kAlways, true}, // ball and lights, which all around can see

    // The run of the exercise
    {"exercise.ready", kAlways, kAlways, false, "exercise ready"},
    {"exercise.briefing", kAlways, kAlways, true}, // its part of the text, counted from 1
    {"lesson.over", kAlways, kAlways, false},
    {"exercise.reading", kAlways, kAlways, false, "an exercise is being loaded"},
    {"exercise.loaded", kAlways, kAlways, false},
    {"exercise.reset", kAlways, kAlways, false},
    {"exercise.started", kAlways, kAlways, false},
    {"exercise.resumed", kAlways, kAlways, false},
    {"exercise.paused", kAlways, kAlways, false},
    {"exercise.time_scale", kAlways, kAlways, true},
    {"exercise.checkpoint", kAlways, kAlways, false},
    {"exercise.restored", kAlways, kAlways, true, "exercise restored, paused"},
    {"exercise.finished", kAlways, kAlways, false},
    {"exercise.stopped_by_fault", kAlways, kAlways, false, "exercise stopped by a fault of the simulation"},
    {"exercise.bookmark", kNever, kNever}, // the instructor's note to himself

    // The instructor's hand, and what is beyond the exercise
    {"fault.*", kNever, kNever},
    {"environment.*", kNever, kNever},
    {"assessment.*", kNever, kNever},
    {"classroom.*", kNever, kNever},
    {"model.*", kNever, kNever}, // how well the simulation itself is solved
};

/// "FaultCommand" of "(3 refusals not listed) FaultCommand from instructor: ...".
std::string_view refused_topic(std::string_view text) {
    if (text.starts_with('(')) text.remove_prefix(std::min(text.size(), text.find(')') + 2));
    return text.substr(0, text.find(' '));
}

struct Orders {
    std::string_view topic;
    bool forecastle, bridge;
};
/// Topics that a seat writes. Other refusals are the instructor's: they tell what he is about to do.
constexpr Orders kOwnOrders[]{
    {"WindlassCommand", true, false},        {"Report", true, false},      {"HelmCommand", false, true},
    {"BridgeOrderCommand", false, true},     {"WatchCircle", false, true}, {"AlertCommand", true, true},
    {"LightsAndShapesCommand", false, true},
};

template <class FixedString>
void copy(std::string_view from, FixedString& to) {
    to = std::string(clipped(from, FixedString::max_size));
}

const exercise::AnchorView* anchor_of(const exercise::ExerciseEvent& event,
                                      const exercise::Snapshot& snapshot) {
    for (const exercise::TackleView& tackle : snapshot.tackle)
        if (static_cast<int>(tackle.side) == event.side) return &tackle.anchor;
    return nullptr;
}

bool noticed(Notice when, bool Orders::*seat, const exercise::ExerciseEvent& event,
             const exercise::Snapshot& snapshot) {
    switch (when) {
    case Notice::never:
        return false;
    case Notice::anchor_above: {
        const exercise::AnchorView* anchor = anchor_of(event, snapshot);
        return anchor != nullptr && above_water(*anchor);
    }
    case Notice::own_orders:
        return std::ranges::any_of(kOwnOrders, [&](const Orders& own) {
            return own.*seat && own.topic == refused_topic(event.text);
        });
    case Notice::always:
        return true;
    }
    return false;
}

} // namespace

std::span<const EventRule> event_rules() {
    return kRules;
}

const EventRule* event_rule(std::string_view code) {
    for (const EventRule& rule : kRules) {
        const bool family = rule.code.ends_with(".*");
        if (family ? code.starts_with(rule.code.substr(0, rule.code.size() - 1)) : code == rule.code)
            return &rule;
    }
    return nullptr;
}

std::optional<SeatEvent> perceive_event(const exercise::ExerciseEvent& event,
                                        const exercise::Snapshot& snapshot) {
    const EventRule* rule = event_rule(event.code);
    if (rule == nullptr) return std::nullopt;
    const bool forecastle = noticed(rule->forecastle, &Orders::forecastle, event, snapshot);
    const bool bridge = noticed(rule->bridge, &Orders::bridge, event, snapshot);
    if (!forecastle && !bridge) return std::nullopt;
    SeatEvent to;
    to.tick(event.tick);
    to.time(event.time);
    to.severity(static_cast<EventSeverity>(event.severity));
    copy(rule->seat_code.empty() ? std::string_view(event.code) : rule->seat_code, to.code());
    to.side(event.side);
    to.forecastle(forecastle);
    to.bridge(bridge);
    to.value(rule->value ? event.value : 0);
    copy(rule->text.empty() ? std::string_view(event.text) : rule->text, to.text());
    return to;
}

} // namespace windlass::perceive
