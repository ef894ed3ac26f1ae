#include "server/physics/anchor/flukes.hpp"

#include "server/physics/base/state_limits.hpp"
#include "server/physics/base/turn.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace windlass::physics {

namespace {

/// Force on a short plate across it, over dynamic pressure and area, for each unit of the sine of its angle
/// to the stream: square on 1.2 (Hoerner 1965, from memory).
constexpr double kNormalForce = 1.2;

} // namespace

Flukes::Flukes(const FlukeShape& shape, double mass, double water_density)
    : shape_(shape),
      weight_(mass * (1 - water_density / kSteelDensity) * kGravity),
      moment_(weight_ * shape.moment_over_mass),
      inertia_(shape.inertia_over_mass * mass),
      // Plates as wide as the spread, turning about one edge: C_D 2 x 1/2 rho x width x length^4 / 4.
      drag_(0.25 * water_density * shape.spread * std::pow(shape.length, 4)),
      trail_(0.25 * kNormalForce * water_density * shape.width * shape.length * shape.length) {}

/// The flukes point along (cos, 0, -sin) of the angle; what a turn does to the height of that, per radian.
double Flukes::height_slope(const Eigen::Matrix3d& axes, double angle) const {
    return -axes(2, 0) * std::sin(angle) - axes(2, 2) * std::cos(angle);
}

double Flukes::dip(const Eigen::Matrix3d& axes) const {
    if (!shape_.hinged) return std::abs(axes(2, 2));
    return -(axes(2, 0) * std::cos(state_.angle) - axes(2, 2) * std::sin(state_.angle));
}

Vec3 Flukes::shift(const Eigen::Matrix3d& axes) const {
    if (!shape_.hinged) return Vec3::Zero();
    const Vec3 turned(std::cos(state_.angle) - 1, 0, -std::sin(state_.angle));
    return axes * (shape_.moment_over_mass * turned);
}

double Flukes::energy(const Eigen::Matrix3d& axes) const {
    if (!shape_.hinged) return 0;
    return 0.5 * inertia_ * state_.rate * state_.rate + moment_ * (-dip(axes) - axes(2, 0));
}

/// Stops, and soil that the tips have not dug into: tips no deeper than it lets them.
double Flukes::within(const FlukeSurroundings& s, double angle) const {
    const double reach = std::hypot(s.axes(2, 0), s.axes(2, 2));
    const double min = (shape_.spread * std::abs(s.axes(2, 1)) - s.dug - s.pin_height) / shape_.length;
    if (min > -reach) {
        // Height of the flukes' direction: reach x cos(angle + slant).
        const double slant = std::atan2(s.axes(2, 2), s.axes(2, 0));
        const double max = std::acos(std::clamp(min / reach, -1.0, 1.0));
        const double turned = remainder_of_turn(angle + slant, 2 * std::numbers::pi);
        angle += std::clamp(turned, -max, max) - turned;
    }
    return std::clamp(angle, -shape_.limit, shape_.limit);
}

bool Flukes::stopped(double moment) const {
    return !shape_.hinged || seized_ ||
           (moment > 0 ? state_.angle >= shape_.limit : state_.angle <= -shape_.limit);
}

bool Flukes::stopped(double moment, const FlukeSurroundings& s) const {
    constexpr double kTurn = 1e-4; // rad
    const double turned = state_.angle + std::copysign(kTurn, moment);
    return !shape_.hinged || seized_ || within(s, turned) != turned;
}

void Flukes::swing(const FlukeSurroundings& s, const StepTime& time) {
    assert(time.kick > 0 && s.friction >= 0 && "friction is a size, a step takes time");
    if (!shape_.hinged) return;
    energy_ = energy(s.axes);
    if (seized_) {
        state_.rate = 0;
        return;
    }
    const double down = s.axes(2, 2) >= 0 ? 1 : -1; // sense that turns them towards the lower side
    const double torque = -moment_ * height_slope(s.axes, state_.angle) + down * s.push;
    double momentum = inertia_ * state_.rate + time.kick * torque;
    // Water that streams past makes them trail behind their pin, as a vane: those of an anchor that falls
    // crown first lie along its shank. Their own turn adds 2/3 of the tips' speed to it.
    const Vec3 along = s.axes.transpose() * s.through;
    const double across = -along.x() * std::sin(state_.angle) - along.z() * std::cos(state_.angle);
    const double trail = time.kick * s.submerged * trail_ * along.norm();
    momentum -= trail * across;
    momentum -= std::clamp(momentum, -time.kick * s.friction, time.kick * s.friction);
    state_.rate = momentum / (inertia_ + trail * 2 / 3 * shape_.length +
                              time.kick * s.submerged * drag_ * std::abs(state_.rate));
}

double Flukes::turn(const FlukeSurroundings& s, const StepTime& time) {
    if (!shape_.hinged) return 0;
    if (seized_) {
        state_.rate = 0;
        return energy_ - energy(s.axes);
    }
    state_.angle += time.dt * state_.rate;
    const double free = state_.angle;
    state_.angle = within(s, free);
    if (state_.angle != free) state_.rate = 0;
    return energy_ - energy(s.axes);
}

template <class Visitor, StateOf<Flukes> Self>
void visit_state(Visitor& v, Self& self) {
    auto& [angle, rate] = self.state_;
    WINDLASS_STATE(v, angle, rate);
    WINDLASS_WITHIN(v, -kMostTurned, kMostTurned, angle);
    WINDLASS_WITHIN(v, -kFastestTurn, kFastestTurn, rate);
}
WINDLASS_STATE_LISTED(Flukes);

} // namespace windlass::physics
