#pragma once
// A fault as it is ordered: by an instructor, or by the file of an exercise.

#include "common/fields.hpp"
#include "server/physics/base/state_visitor.hpp"
#include "words/codes.hpp"

#include <string>

namespace windlass::exercise {

using words::BridgeOrderCode; ///< what the bridge orders
using words::FaultCode;
inline constexpr int kFaultCodes = static_cast<int>(last_of(FaultCode{})) + 1;

/// Which cable.
enum class Side { port = 0, starboard = 1 };
constexpr Side last_of(Side) {
    return Side::starboard;
}
constexpr Side other(Side side) {
    return side == Side::port ? Side::starboard : Side::port;
}

/// What makes an armed fault active; as in idl FaultTrigger.
enum class FaultTrigger {
    now,
    at_time,
    at_cable_out,
    at_load,
    at_cable_out_at_most,
    at_load_at_most,
    at_event,
    at_order,
    at_chance
};

constexpr FaultTrigger last_of(FaultTrigger) {
    return FaultTrigger::at_chance;
}
/// Arm, raise or clear a fault.
struct FaultOrder {
    FaultCode code = FaultCode::brake_lining_faded;
    Side side = Side::port;
    double severity = 1; ///< 0..1
    double ramp = 0;     ///< s, from active to that severity
    double lasts = 0;    ///< s, from active until it clears by itself; 0: until somebody clears it
    FaultTrigger trigger = FaultTrigger::now;
    double trigger_value = 0;                              ///< s, m or N
    double trigger_until = 0;                              ///< s, at_chance: the window's end
    std::string trigger_event{};                           ///< at_event: its code
    BridgeOrderCode trigger_order = BridgeOrderCode::text; ///< at_order
    int target = 0; ///< which of several, from 1; 0: whichever the model takes
    bool clear = false;
};
WINDLASS_FIELDS(FaultOrder, code, side, severity, ramp, lasts, trigger, trigger_value, trigger_until,
                trigger_event, trigger_order, target, clear)
template <class Visitor, physics::StateOf<FaultOrder> State>
void visit_state(Visitor& v, State& order);

} // namespace windlass::exercise
