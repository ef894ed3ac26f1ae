#include "server/physics/windlass/electric_drive.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace windlass::physics {

namespace {

constexpr double kVfdSlip =
    0.02; ///< m/s off the target at stall pull: slip and the controller's droop; tuned

/// Straight line through zero pull at target, held at most at the given pulls.
MotorPull around(double target, double slope, double min, double max) {
    MotorPull pull;
    pull.add(target + min / slope, min);
    pull.add(target + max / slope, max);
    return pull;
}

} // namespace

double vfd_limit(const WindlassDef& def, double speed) {
    const double v = std::abs(speed);
    const double gear = 1 / kGearEfficiency;
    if (v > def.rated_speed) return gear * def.rated_pull * def.rated_speed / v;
    return gear * (def.stall_pull + (def.rated_pull - def.stall_pull) * v / def.rated_speed);
}

MotorPull vfd_pull(const WindlassDef& def, double speed, double target, double health) {
    const double limit = vfd_limit(def, speed) * health;
    if (limit <= 0) return {};
    return around(target, def.stall_pull / kGearEfficiency / kVfdSlip, -limit, limit);
}

double pole_step(double lever) {
    assert(lever >= -1 && lever <= 1 && "the lever has stops");
    const double way = std::abs(lever), sign = lever < 0 ? -1 : 1;
    if (way == 0) return 0;
    return sign * (way <= 1.0 / 3 ? 0.25 : way <= 2.0 / 3 ? 0.5 : 1.0);
}

double breakdown_pull(const WindlassDef& def, double synchronous) {
    const double share = std::min(1.0, 0.5 * def.light_line_speed / std::abs(synchronous));
    return share * def.stall_pull / kGearEfficiency;
}

MotorPull pole_changing_pull(const WindlassDef& def, double speed, double target, double health) {
    if (target == 0 || health <= 0) return {};
    // The middle winding gives the rated pull at the rated speed, with a straight line to its synchronous
    // one.
    const double middle = 0.5 * def.light_line_speed;
    const double rated_slip = 1 - def.rated_speed / middle;
    const double breakdown_slip = rated_slip * def.stall_pull / def.rated_pull;
    const double max = breakdown_pull(def, target) * health;
    const auto fallen = [&](double slip, double at) { return 2 * max / (slip / at + at / slip); };
    // slip 0 at synchronous speed, 1 at standstill; the cable pulls towards larger slip while heaving.
    const double slip = 1 - speed / target;
    double motoring = max, braking = max;
    if (slip > 1) motoring = fallen(slip, 1);
    if (slip < -breakdown_slip) braking = fallen(-slip, breakdown_slip);
    const double slope = max / (breakdown_slip * std::abs(target));
    return target < 0 ? around(target, slope, -braking, motoring) : around(target, slope, -motoring, braking);
}

} // namespace windlass::physics
