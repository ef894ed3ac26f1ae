#pragma once
// What an exercise step may be told. Values are already checked (see dds/mailbox): finite and in range.

#include "server/exercise/definition/exercise_def.hpp"
#include "server/exercise/definition/fault_order.hpp"
#include "server/exercise/weather/weather.hpp"
#include "server/physics/ship/foreign_ship.hpp"

#include <string>
#include <variant>

namespace windlass::physics {

WINDLASS_FIELDS(Helm, engine, rudder, bow_thruster, stern_thruster)
WINDLASS_FIELDS(ForeignSample, position, attitude, velocity, angular_velocity, time)

} // namespace windlass::physics

namespace windlass::exercise {

/// Levers of one windlass.
struct WindlassOrder {
    Side side = Side::port;
    double brake = 1;       ///< 0 open .. 1 hard on
    double speed_lever = 0; ///< -1 full lower .. 1 full heave
    bool clutch_in = false;
    bool stopper_closed = false;
    bool emergency_stop = false;
};
WINDLASS_FIELDS(WindlassOrder, side, brake, speed_lever, clutch_in, stopper_closed, emergency_stop)

/// Levers of the bridge.
using HelmOrder = physics::Helm;

/// Wind, waves, current, tide and light as they shall be, and in how many seconds.
struct EnvironmentOrder {
    Weather weather{};
    double ramp = 0; ///< s
};
WINDLASS_FIELDS(EnvironmentOrder, weather, ramp)

using words::ReportCode; ///< what the trainee reports

/// What the trainee entered, and nothing else.
enum class StayGiven { not_given, up_and_down, short_stay, medium_stay, long_stay };
constexpr StayGiven last_of(StayGiven) {
    return StayGiven::long_stay;
}
enum class Growing { not_given, slack, growing, tight };
constexpr Growing last_of(Growing) {
    return Growing::tight;
}
enum class CableWeight { not_given, none, moderate, much, too_much };
constexpr CableWeight last_of(CableWeight) {
    return CableWeight::too_much;
}

struct ReportMade {
    ReportCode code = ReportCode::text;
    int side = -1;
    double value = 0;
    int lead = 0; ///< clock hour 1..12; 0: not given
    StayGiven stay = StayGiven::not_given;
    Growing growing = Growing::not_given;
    CableWeight weight = CableWeight::not_given;
    int order_number = 0;                               ///< of the bridge's order that it answers; 0: none
    BridgeOrderCode order_code = BridgeOrderCode::text; ///< order_repeated: what was understood;
                                                        ///< unsafe: what is proposed, text: nothing
    std::string text{};
};
WINDLASS_FIELDS(ReportMade, code, side, value, lead, stay, growing, weight, order_number, order_code, text)

/// The bridge orders something of the forecastle.
struct BridgeOrderGiven {
    BridgeOrderCode code = BridgeOrderCode::text;
    int side = -1; ///< 0 port, 1 starboard, -1 both
    double value = 0;
    std::string text{};
    std::string by{};         ///< who gave it
    double repeat_within = 0; ///< s; 0: the code's own
    double do_within = 0;     ///< s; 0: the code's own
    int cancels = 0;          ///< cancel: number of the order that is taken back
};
WINDLASS_FIELDS(BridgeOrderGiven, code, side, value, text, by, repeat_within, do_within, cancels)

/// The bridge's anchor watch.
struct WatchCircleOrder {
    bool kept = false;
    double x = 0, y = 0; ///< m, world
    double radius = 0;   ///< m
};
WINDLASS_FIELDS(WatchCircleOrder, kept, x, y, radius)

/// What a vessel at anchor shows (COLREG 72, rule 30 (a)), as it is or as it shall be.
struct LightsAndShapes {
    bool anchor_ball = false;   ///< one ball in her fore part
    bool anchor_lights = false; ///< all-round white, forward and, lower, at the stern
};
WINDLASS_FIELDS(LightsAndShapes, anchor_ball, anchor_lights)

using words::DeckWork; ///< what men do by hand at a windlass

/// What the mate sets them to, from now on.
struct DeckWorkOrder {
    Side side = Side::port;
    DeckWork work = DeckWork::none;
};
WINDLASS_FIELDS(DeckWorkOrder, side, work)

enum class AssessorVerdict {
    met,
    not_met,
    not_applicable,
    points,
    confirmed,
    ended ///< no assessor's word: the server says that the exercise was ended, and its lesson with it
};
constexpr AssessorVerdict last_of(AssessorVerdict) {
    return AssessorVerdict::ended;
}

/// An assessor's word beside a computed mark. Nothing in the exercise comes of it.
struct AssessorsWord {
    std::string criterion{}; ///< empty: the whole is confirmed or ended; either ends it
    AssessorVerdict verdict = AssessorVerdict::met;
    int milli = 0; ///< points: 0..1000
    std::string note{};
    std::string by{}; ///< who says it
};
WINDLASS_FIELDS(AssessorsWord, criterion, verdict, milli, note, by)

enum class AnswerKind {
    number,
    choice,
    not_known,
    passed_over ///< no seat's answer: the server says that the exercise went on without one
};
constexpr AnswerKind last_of(AnswerKind) {
    return AnswerKind::passed_over;
}

/// A seat answers what it is asked at a freeze. Nothing in the exercise comes of it.
struct AnswerGiven {
    std::string question{}; ///< code of its criterion
    AnswerKind kind = AnswerKind::not_known;
    double value = 0; ///< number: in the question's unit
    int choice = 0;   ///< choice: place in the question's choices
};
WINDLASS_FIELDS(AnswerGiven, question, kind, value, choice)

/// A draw for an armed fault's window: 0..1. Made outside, so that a step needs no chance.
struct ChanceDrawn {
    double chance = 0;
};
WINDLASS_FIELDS(ChanceDrawn, chance)

/// Where another simulator has the ship.
using OwnShipSample = physics::ForeignSample;

/// One order, applied at the tick in which it is drained from the mailbox.
using Order = std::variant<WindlassOrder, HelmOrder, FaultOrder, EnvironmentOrder, ReportMade,
                           BridgeOrderGiven, WatchCircleOrder, LightsAndShapes, DeckWorkOrder, ChanceDrawn,
                           OwnShipSample, AssessorsWord, AnswerGiven>;

} // namespace windlass::exercise
