#include "server/physics/windlass/drive_line.hpp"

#include "server/physics/base/state_limits.hpp"

#include <algorithm>
#include <array>
#include <cassert>

namespace windlass::physics {

namespace {

/// Root in [from, to] of a function that rises in straight pieces between the given corners; the end where it
/// does not reach zero. from may lie above to.
template <class Function, std::size_t count>
double root_of_pieces(const Function& f, double from, double to, std::array<double, count> corners) {
    if (from == to) return to;
    const bool up = to > from;
    std::sort(corners.begin(), corners.end(), [up](double a, double b) { return up ? a < b : a > b; });
    double left = from, f_left = f(from);
    const auto crossed = [&](double value) { return up ? value >= 0 : value <= 0; };
    const auto crosses = [&](double corner) {
        const double f_right = f(corner);
        if (crossed(f_right)) return true;
        left = corner, f_left = f_right;
        return false;
    };
    const auto root = [&](double corner) { return left + (corner - left) * f_left / (f_left - f(corner)); };
    for (const double corner : corners) {
        if (up ? (corner <= left || corner > to) : (corner >= left || corner < to)) continue;
        if (crosses(corner)) return root(corner);
    }
    return crosses(to) ? root(to) : to;
}

} // namespace

double MotorPull::at(double speed) const {
    if (count == 0) return 0;
    if (speed <= corners[0].speed) return corners[0].pull;
    for (int k = 1; k < count; ++k) {
        const Corner &a = corners[k - 1], &b = corners[k];
        if (speed <= b.speed) return a.pull + (b.pull - a.pull) * ((speed - a.speed) / (b.speed - a.speed));
    }
    return corners[count - 1].pull;
}

double MotorPull::turn() const {
    for (int k = 1; k < count; ++k) {
        const Corner &a = corners[k - 1], &b = corners[k];
        if (a.pull < 0 && b.pull > 0) return a.speed - a.pull * (b.speed - a.speed) / (b.pull - a.pull);
    }
    return 0;
}

double InboardTie::at(double speed) const {
    return std::clamp(pull + slope * speed, 0.0, max);
}

/// What brakes and stopper would have to hold for the chain to move at this speed, with its sign turned:
/// rises with speed. Either way friction in hawse pipe and gear is against the motion.
double DriveLine::excess(const TopLink& link, double speed, Direction direction) const {
    const double efficiency =
        direction == Direction::out ? loads_.hawse_efficiency : 1 / loads_.hawse_efficiency;
    const double motor = loads_.motor.at(speed);
    const double geared =
        direction == Direction::out ? loads_.gear.paying_out(motor) : loads_.gear.heaving_in(motor);
    const double acceleration = (speed - loads_.speed) / link.dt;
    const double outboard = link.pull_at(speed) + link.outboard_pull + loads_.pipe_weight -
                            (link.outboard_mass + loads_.pipe_mass) * acceleration;
    return loads_.gypsy_mass * acceleration - efficiency * outboard + loads_.locker_weight +
           loads_.pick_up * std::max(0.0, speed) + geared + loads_.bitter_end.at(speed) +
           loads_.jam.at(speed);
}

double DriveLine::speed(const TopLink& link) const {
    assert(link.dt > 0 && "a step takes time");
    const MotorPull& motor = loads_.motor;
    const InboardTie &end = loads_.bitter_end, &jam = loads_.jam;
    const std::array<double, 10> corners{link.pull /
                                             (link.yielding * link.dt), // where the top link goes slack
                                         end.reaches(0),
                                         end.reaches(end.max),
                                         jam.reaches(0),
                                         jam.reaches(jam.max),
                                         motor.turn(),
                                         motor.corners[0].speed,
                                         motor.corners[1].speed,
                                         motor.corners[2].speed,
                                         motor.corners[3].speed};
    if (excess(link, 0, Direction::out) + loads_.holding_out < 0) {
        return root_of_pieces([&](double v) { return excess(link, v, Direction::out) + loads_.holding_out; },
                              0, loads_.max_speed, corners);
    }
    if (excess(link, 0, Direction::in) - loads_.holding_in > 0) {
        return root_of_pieces([&](double v) { return excess(link, v, Direction::in) - loads_.holding_in; }, 0,
                              loads_.min_speed, corners);
    }
    return 0;
}

DeckResult DriveLine::result(const TopLink& link) const {
    DeckResult r;
    r.speed = speed(link);
    const double acceleration = (r.speed - loads_.speed) / link.dt;
    const double pull = link.pull_at(r.speed);
    r.hawse_tension = std::max(0.0, pull + link.outboard_pull - link.outboard_mass * acceleration);
    r.pipe_pull = pull + link.outboard_pull + loads_.pipe_weight -
                  (link.outboard_mass + loads_.pipe_mass) * acceleration;
    r.motor = loads_.motor.at(r.speed);
    // What the deck must answer apart from brakes, stopper and the gear's friction; what they hold follows.
    r.bitter_end = loads_.bitter_end.at(r.speed);
    r.jam = loads_.jam.at(r.speed);
    const double rest = loads_.gypsy_mass * acceleration + loads_.locker_weight +
                        loads_.pick_up * std::max(0.0, r.speed) + r.motor + r.bitter_end + r.jam;
    const double gear_out = loads_.gear.paying_out(r.motor) - r.motor; // >= 0
    const double gear_in = loads_.gear.heaving_in(r.motor) - r.motor;  // <= 0
    const double out = loads_.hawse_efficiency * r.pipe_pull, in = r.pipe_pull / loads_.hawse_efficiency;
    const double least = std::min(out, in), most = std::max(out, in);
    // A belt on a drum that stands keeps its pull behind the drum, whatever comes before it, until friction
    // bears no more; then it slips. A move of the gypsy changes that pull by the stretch of the chain on
    // deck.
    r.standing_pull =
        std::clamp(loads_.standing_pull - loads_.pipe_stiffness * r.speed * link.dt, least, most);
    if (r.speed != 0) {
        r.gypsy_load = r.speed > 0 ? out : in;
    } else {
        // What brakes and stopper cannot answer, friction takes, as far as it goes.
        const double answered = std::clamp(r.standing_pull, rest - loads_.holding_in + gear_in,
                                           rest + loads_.holding_out + gear_out);
        r.gypsy_load = r.standing_pull = std::clamp(answered, least, most);
    }
    const double held = r.gypsy_load - rest;
    if (r.speed != 0) {
        r.gear = r.speed > 0 ? gear_out : gear_in;
        r.held = std::clamp(held - r.gear, -loads_.holding_in, loads_.holding_out);
    } else {
        // At rest brakes and stopper hold first, the gear what is left.
        r.held = std::clamp(held, -loads_.holding_in, loads_.holding_out);
        r.gear = std::clamp(held - r.held, gear_in, gear_out);
    }
    r.end_stop = held - r.held - r.gear; // rounding, or the anchor's seat, or no chain left
    return r;
}

template <class Visitor, StateOf<DeckResult> State>
void visit_state(Visitor& v, State& result) {
    auto& [speed, hawse_tension, pipe_pull, gypsy_load, standing_pull, held, motor, gear, bitter_end, jam,
           end_stop] = result;
    WINDLASS_STATE(v, speed, hawse_tension, pipe_pull, gypsy_load, standing_pull, held, motor, gear,
                   bitter_end, jam, end_stop);
    WINDLASS_WITHIN(v, -kFastest, kFastest, speed);
    WINDLASS_WITHIN(v, -kStrongest, kStrongest, hawse_tension, pipe_pull, gypsy_load, standing_pull, held,
                    motor, gear, bitter_end, jam, end_stop);
}
WINDLASS_STATE_LISTED(DeckResult);

} // namespace windlass::physics
