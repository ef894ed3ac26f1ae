#pragma once
// What an exercise step may be told. Values are already checked (see dds/mailbox): finite and in range.

#include "server/exercise/exercise_def.hpp"
#include "server/exercise/fault_code.hpp"

#include <variant>

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

/// Bridge orders.
struct HelmOrder {
    double engine = 0;         ///< -1 full astern .. 1 full ahead
    double rudder = 0;         ///< rad, starboard positive
    double bow_thruster = 0;   ///< -1..1
    double stern_thruster = 0; ///< -1..1
};

enum class FaultTrigger { now, at_time, at_cable_out, at_load };
constexpr FaultTrigger last_of(FaultTrigger) {
    return FaultTrigger::at_load;
}

/// Arm, raise or clear a fault.
struct FaultOrder {
    FaultCode code = FaultCode::brake_lining_faded;
    Side side = Side::port;
    double severity = 1; ///< 0..1
    FaultTrigger trigger = FaultTrigger::now;
    double trigger_value = 0; ///< s, m or N
    bool clear = false;
};

/// Instructor's change of wind and current.
struct EnvironmentOrder {
    double wind_speed = 0;
    double wind_from = 0;
    double current_speed = 0;
    double current_towards = 0;
};

/// A report made by the trainee; goes into the log with its time.
enum class ReportCode {
    text,
    standing_by,
    anchor_ready,
    let_go,
    shackles_on_deck,
    shackles_in_water,
    lead,
    brought_up,
    heaving,
    short_stay,
    up_and_down,
    anchor_aweigh,
    clear_anchor,
    foul_anchor,
    anchor_home,
    dragging,
    order_repeated
};

struct ReportMade {
    ReportCode code = ReportCode::text;
    int side = -1;
    double value = 0;
    std::string text;
};

/// One command, applied at the tick in which it is drained from the mailbox.
using Order = std::variant<WindlassOrder, HelmOrder, FaultOrder, EnvironmentOrder, ReportMade>;

} // namespace windlass::exercise
