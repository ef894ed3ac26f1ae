#include "server/physics/windlass/motor_heat.hpp"

#include "server/physics/base/state_limits.hpp"
#include "server/physics/windlass/gearbox.hpp"

#include <cassert>
#include <cmath>

namespace windlass::physics {

namespace {

/// The relay lets 1.05 times the rated current pass for ever, and must trip at 1.2 times (IEC 60947-4-1,
/// table 2): halfway. h is the square.
constexpr double kRelayOpens = 1.15 * 1.15;
/// Share of that at which its bimetal has gone back far enough: 1.2 time constants, 3 minutes as it is set by
/// default; makers give 1 to 10; tuned.
constexpr double kRelayCloses = 0.3 * kRelayOpens;
/// s at twice the rated pull, cold, after which it trips: 4 s at 7.2 times, as class 10A asks (the same
/// table).
constexpr double kRelayTripTime = 60;
/// s at the rated pull, cold, that the winding bears: S2-30 (UR A3 3.1.2).
constexpr double kDutyTime = 1800;
/// K above the air after the duty time at rated pull: class F, by resistance (IEC 60034-1, table 8).
constexpr double kClassRise = 105;
constexpr double kThermistorOpens = 155 + 273.15; ///< K: class F (IEC 60085), thermistors for that class
constexpr double kThermistorCloses = kThermistorOpens - 10; ///< K; tuned

/// A step of tau dh/dt = heating - h, taken at its end.
double warmed(double h, double heating, double dt, double tau) {
    return (h + dt / tau * heating) / (1 + dt / tau);
}

/// s, of the relay, so that from cold it opens after its time at twice the rated pull.
double relay_time_constant() {
    return kRelayTripTime / std::log(4 / (4 - kRelayOpens));
}

} // namespace

double winding_temperature(const MotorHeat& heat) {
    // One time constant is the duty time itself: 1 - 1/e of the final rise is the class's; tuned.
    const double final_rise = kClassRise / (1 - std::exp(-1.0));
    return kAirTemperature + final_rise * heat.winding;
}

void heat_motor(const WindlassDef& def, double dt, double pull, double seen_by_relay, MotorHeat& heat) {
    assert(dt > 0 && "a step takes time");
    const double rated = def.rated_pull / kGearEfficiency, share = pull / rated, seen = seen_by_relay / rated;
    heat.relay = warmed(heat.relay, seen * seen, dt, relay_time_constant());
    heat.winding = warmed(heat.winding, share * share, dt, kDutyTime);
    const double temperature = winding_temperature(heat);
    if (heat.relay > kRelayOpens || temperature > kThermistorOpens) heat.open = true;
    if (heat.relay < kRelayCloses && temperature < kThermistorCloses) heat.open = false;
}

template <class Visitor, StateOf<MotorHeat> State>
void visit_state(Visitor& v, State& state) {
    auto& [relay, winding, open] = state;
    WINDLASS_STATE(v, relay, winding, open);
    WINDLASS_WITHIN(v, -kHottest, kHottest, relay, winding);
}
WINDLASS_STATE_LISTED(MotorHeat);

} // namespace windlass::physics
