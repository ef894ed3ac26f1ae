#include "server/physics/drive_line.hpp"

#include <algorithm>
#include <array>

namespace windlass::physics {

namespace {

/// Root in [from, to] of a function that rises in straight pieces between the given corners; the end where it
/// does not reach zero. from may lie above to.
template <class Function>
double root_of_pieces(const Function& f, double from, double to, std::array<double, 3> corners) {
    const bool up = to > from;
    std::sort(corners.begin(), corners.end(), [up](double a, double b) { return up ? a < b : a > b; });
    double left = from, f_left = f(from);
    const auto crossed = [&](double value) { return up ? value >= 0 : value <= 0; };
    for (const double corner : {corners[0], corners[1], corners[2], to}) {
        if (up ? (corner <= left || corner > to) : (corner >= left || corner < to)) continue;
        const double f_right = f(corner);
        if (crossed(f_right)) return left + (corner - left) * f_left / (f_left - f_right);
        left = corner, f_left = f_right;
    }
    return to;
}

} // namespace

double MotorPull::at(double speed) const {
    return std::clamp(droop * (speed - target_speed), -limit, limit);
}

double DriveLine::pull(const TopLink& link, double speed) const {
    return std::max(0.0, link.pull - link.yielding * speed * link.dt);
}

/// What brakes and stopper would have to hold for the chain to move at this speed, with its sign turned:
/// rises with speed. efficiency: share of the outboard pull that reaches the gypsy.
double DriveLine::excess(const TopLink& link, double speed, double efficiency) const {
    const double acceleration = (speed - loads_.speed) / link.dt;
    const double outboard = pull(link, speed) + link.outboard_pull + loads_.pipe_weight -
                            (link.outboard_mass + loads_.pipe_mass) * acceleration;
    return loads_.gypsy_mass * acceleration - efficiency * outboard + loads_.locker_weight +
           loads_.pick_up * std::max(0.0, speed) + loads_.motor.at(speed);
}

double DriveLine::solve(const TopLink& link) const {
    const double out = loads_.hawse_efficiency, in = 1 / loads_.hawse_efficiency;
    const double slack_from = link.pull / (link.yielding * link.dt);
    const double motor_reach = loads_.motor.droop > 0 ? loads_.motor.limit / loads_.motor.droop : 0;
    const std::array<double, 3> corners{slack_from, loads_.motor.target_speed - motor_reach,
                                        loads_.motor.target_speed + motor_reach};
    if (excess(link, 0, out) + loads_.holding_out < 0) {
        return root_of_pieces([&](double v) { return excess(link, v, out) + loads_.holding_out; }, 0,
                              loads_.most_speed, corners);
    }
    if (excess(link, 0, in) - loads_.holding_in > 0) {
        return root_of_pieces([&](double v) { return excess(link, v, in) - loads_.holding_in; }, 0,
                              loads_.least_speed, corners);
    }
    return 0;
}

DeckResult DriveLine::result(const TopLink& link) const {
    DeckResult r;
    r.speed = solve(link);
    const double acceleration = (r.speed - loads_.speed) / link.dt;
    r.hawse_tension =
        std::max(0.0, pull(link, r.speed) + link.outboard_pull - link.outboard_mass * acceleration);
    r.pipe_pull = pull(link, r.speed) + link.outboard_pull + loads_.pipe_weight -
                  (link.outboard_mass + loads_.pipe_mass) * acceleration;
    r.motor = loads_.motor.at(r.speed);
    // What the deck must answer apart from brakes and stopper; what they hold follows.
    const double rest = loads_.gypsy_mass * acceleration + loads_.locker_weight +
                        loads_.pick_up * std::max(0.0, r.speed) + r.motor;
    const double out = loads_.hawse_efficiency * r.pipe_pull, in = r.pipe_pull / loads_.hawse_efficiency;
    if (r.speed != 0) {
        r.gypsy_load = r.speed > 0 ? out : in;
    } else {
        // At rest the hawse pipe holds as it did when the chain last moved, unless brakes and stopper cannot
        // answer that: then it takes what they leave, as far as friction goes.
        const double as_before = loads_.last_direction > 0 ? out : in;
        const double answered = std::clamp(as_before, rest - loads_.holding_in, rest + loads_.holding_out);
        r.gypsy_load = std::clamp(answered, std::min(out, in), std::max(out, in));
    }
    r.held = std::clamp(r.gypsy_load - rest, -loads_.holding_in, loads_.holding_out);
    r.end_stop = r.gypsy_load - rest - r.held; // rounding, or the bitter end, or the anchor's seat
    return r;
}

} // namespace windlass::physics
