#include "bench/acceptance/ur_a3.hpp"

#include "rigs/gypsy_bench.hpp"
#include "rigs/tackle_rig.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace windlass::lab {

using namespace rigs;
using namespace physics;

namespace {

constexpr double kN = 1e-3;
constexpr double kHanging = 82.5; ///< m of cable out with the anchor hanging: three shots (UR A3 3.1.4)
constexpr double kDeep = 200;     ///< m, water in which it hangs clear of the bottom all the while

/// What the motor did under a constant pull.
struct Duty {
    double time = 0;  ///< s, until it tripped, stalled or the time was up
    double speed = 0; ///< m/s, mean, heaving positive
};

/// Heaves against a constant pull (N, behind the gear) for as long as it does, at most the given seconds.
Duty heave_against(const Machine& machine, double pull, double seconds) {
    constexpr double kNeverHome = 1e4; // m of cable out; half an hour brings in 300
    GypsyBench bench(machine.setup.windlass, machine.setup.chain, kNeverHome);
    // Of three windings the middle one is made for the pull, the fast one for light line.
    bench.drive(bench.def.drive == DriveKind::electric_pole_changing ? 0.5 : 1);
    constexpr double kStart = 5; // s, to take up the load
    bench.run(kStart, bench.heaving_pull(pull));
    const double from = bench.state().cable_out;
    Duty duty;
    const auto done = [&] {
        const PrimeMoverState& motor = bench.state().motor;
        return motor.tripped || motor.overspeed || motor.burst || bench.speed() >= 0;
    };
    for (; duty.time < seconds && !done(); duty.time += bench.dt)
        bench.run(0.5 * bench.dt, bench.heaving_pull(pull));
    if (duty.time > 0) duty.speed = (from - bench.state().cable_out) / duty.time;
    return duty;
}

/// m/s over two shots, from three shots out with the anchor hanging.
double mean_hoist_speed(const Machine& machine) {
    TackleSetup setup = machine.setup;
    setup.cable_out = kHanging;
    setup.clutch_in = true;
    TackleRig rig(setup, quiet_water(kDeep));
    rig.levers.brake = 0;
    rig.levers.speed = 1;
    const double home = kHanging - 2 * kShackleLength;
    double seconds = 0;
    while (rig.windlass().cable_out > home && seconds < 3600) {
        rig.step();
        seconds += rig.dt;
    }
    return (kHanging - rig.windlass().cable_out) / seconds;
}

/// Largest load on the gypsy (N) under which the chain stood still, in steps of a thousandth of the breaking
/// load; twice the breaking load when nothing gave.
double holds(GypsyBench& bench) {
    const double breaking = breaking_load(bench.chain);
    double held = 0;
    for (int thousandths = 1; thousandths <= 2000; ++thousandths) {
        const double load = 1e-3 * thousandths * breaking;
        bench.run(0.02, bench.pull_for(load));
        if (bench.speed() > 0) break;
        held = load;
    }
    return held;
}

/// The brake opened with three shots hanging, and put hard on when one more has run out.
Finding stop_paying_out(const Machine& machine) {
    TackleSetup setup = machine.setup;
    setup.cable_out = kHanging;
    TackleRig rig(setup, quiet_water(kDeep));
    rig.levers.brake = 0;
    rig.run_until([&] { return rig.windlass().cable_out > kHanging + kShackleLength; }, 60);
    rig.levers.brake = 1;
    const double from = rig.windlass().cable_speed, out = rig.windlass().cable_out;
    double peak = 0;                // N, at the lip
    constexpr double kMaxTime = 10; // s: soon, not when the chain comes to its end
    rig.run_until(
        [&] {
            peak = std::max(peak, rig.deck().hawse_tension);
            return rig.windlass().cable_speed == 0;
        },
        kMaxTime);
    return {"3.1.5",
            "speed that the brake leaves of anchor and chain paying out",
            "m/s",
            Bound::at_most,
            0,
            rig.windlass().cable_speed,
            fmt::format("from {:.1f} m/s in {:.0f} m, {:.0f} kN at the lip, lining {:.0f} °C", from,
                        rig.windlass().cable_out - out, kN * peak,
                        celsius_from_kelvin(rig.windlass().brake.skin))};
}

/// A brake of the given holding pull (N), in whole kN as brakes are sold.
Machine with_brake(Machine machine, double rating) {
    machine.setup.windlass.brake_rating = 1e3 * std::ceil(kN * rating);
    return machine;
}

} // namespace

double brake_holds(const Machine& machine) {
    GypsyBench bench(machine.setup.windlass, machine.setup.chain);
    return holds(bench);
}

double stopper_holds(const Machine& machine) {
    GypsyBench bench(machine.setup.windlass, machine.setup.chain);
    // Some chain hangs on it: what hangs to the locker would draw it in as far as the bar has play.
    const double light = bench.pull_for(1e-3 * breaking_load(bench.chain));
    bench.levers.stopper_closed = true;
    bench.run(0.1, light);
    bench.levers.brake = 0;
    bench.run(bench.def.brake_travel_time + 1, light);
    return holds(bench);
}

double continuous_duty_pull(const ChainDef& chain) {
    constexpr double kBySquare[]{37.5, 42.5, 47.5}; // N/mm2, by grade
    const double mm = 1000 * chain.diameter;
    return kBySquare[static_cast<int>(chain.grade)] * mm * mm;
}

std::vector<Finding> accept(const Machine& machine) {
    constexpr double kMinSpeed = 0.15; // m/s (UR A3 3.1.4)
    const double breaking = breaking_load(machine.setup.chain);
    const double pull = continuous_duty_pull(machine.setup.chain);
    const Duty continuous = heave_against(machine, pull, 1800);
    const Duty overload = heave_against(machine, 1.5 * pull, 120);
    const auto at_least = [](const char* clause, const char* requirement, const char* unit, double required,
                             double measured, std::string note = {}) {
        return Finding{clause, requirement, unit, Bound::at_least, required, measured, std::move(note)};
    };
    return {
        at_least("3.1.2", "continuous duty pull without a trip", "min", 30, continuous.time / 60,
                 fmt::format("against {:.0f} kN", kN * pull)),
        at_least("3.1.4", "mean speed at that pull", "m/s", kMinSpeed, continuous.speed),
        at_least("3.1.3", "1.5 times that pull without trip or stall", "min", 2, overload.time / 60,
                 fmt::format("at {:.2f} m/s", overload.speed)),
        at_least("3.1.4", "mean speed over two shots from 82.5 m, anchor hanging", "m/s", kMinSpeed,
                 mean_hoist_speed(machine)),
        at_least("3.1.1", "brake as fitted holds 0.45 BL (there is a stopper)", "kN", kN * (0.45 * breaking),
                 kN * brake_holds(machine)),
        at_least("3.1.1", "a brake of 0.8 BL, for want of a stopper, holds it", "kN", kN * (0.8 * breaking),
                 kN * brake_holds(with_brake(machine, 0.8 * breaking))),
        stop_paying_out(machine),
        at_least("3.1.6", "stopper holds 0.8 BL", "kN", kN * (0.8 * breaking), kN * stopper_holds(machine)),
    };
}

} // namespace windlass::lab
