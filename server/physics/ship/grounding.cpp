#include "server/physics/ship/grounding.hpp"

#include "server/physics/sea/ground.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace windlass::physics {

namespace {

/// Of her flat bottom: forward of midships over the length, to starboard over the beam.
struct Place {
    double along, across;
};
constexpr double kBilge = 0.4; // of the beam from the centre line
constexpr std::array kPlaces{Place{-0.5, 0},    Place{-0.25, -kBilge}, Place{-0.25, 0},  Place{-0.25, kBilge},
                             Place{0, -kBilge}, Place{0, 0},           Place{0, kBilge}, Place{0.25, -kBilge},
                             Place{0.25, 0},    Place{0.25, kBilge},   Place{0.5, 0}};
constexpr double kShare = 1.0 / kPlaces.size();

/// What a place that is so far in the ground (m), and goes into it at so many m/s, bears of a weight (N).
double bears(double weight, double depth, double speed) {
    constexpr double kSinks = 0.1;   // m
    constexpr double kRebound = 0.1; // m/s, at which the ground follows no keel that leaves it
    return kShare * weight / kSinks * depth * std::max(0.0, 1 + speed / kRebound);
}

} // namespace

KeelAndGround keel_and_ground(const ShipDef& def, const EnvironmentDef& environment, const ShipState& state,
                              double dt) {
    constexpr double kFriction = 0.4, kCreep = 1e-3; // m/s, below which friction fades
    const double heel = roll(state), trim = pitch(state) + def.trim / def.length_pp; // rad, bow up
    const double keel =
        state.level + (state.waves.heave + state.floats.heave) - def.draught; // m, world, amidships
    KeelAndGround found;
    if (!environment.ground) {
        found.depth = environment.depth + environment.level;
        found.clearance = keel + environment.depth - 0.5 * def.length_pp * std::abs(trim) -
                          kBilge * def.beam * std::abs(heel); // no less than it is
        if (found.clearance > 0) return found;
        found.depth = 0;
    }
    const Vec3 ahead = forward(state), abeam = starboard(state);
    const double rising = wave_velocity(state).z() + state.rise;
    const double trimming = state.waves.pitch_rate + state.floats.trim_rate;
    const double heeling = state.waves.roll_rate + state.floats.heel_rate;
    found.clearance = 1e300;
    for (const Place& place : kPlaces) {
        const double at = place.along * def.length_pp, out = place.across * def.beam;
        const double x = state.x + at * ahead.x() + out * abeam.x();
        const double y = state.y + at * ahead.y() + out * abeam.y();
        const double bed = bed_height(environment, x, y), clear = keel + at * trim - out * heel - bed;
        found.depth += kShare * (environment.level - bed);
        found.clearance = std::min(found.clearance, clear);
        if (clear >= 0) continue;
        const double along = state.surge - out * state.yaw_rate, across = state.sway + at * state.yaw_rate;
        const Vec3 normal = bed_normal(environment, x, y), way = along * ahead + across * abeam;
        const double leaves = rising + at * trimming - out * heeling + normal.dot(way) / normal.z();
        const double weight = bears(def.displacement * kGravity, -clear, -leaves);
        // Never more than stops what of her mass is there within the step.
        const double rub = std::min(kFriction * weight / std::max(std::hypot(along, across), kCreep),
                                    kShare * def.displacement / dt);
        const Vec3 slope = weight / normal.z() * normal;
        const double push = slope.dot(ahead) - rub * along, side = slope.dot(abeam) - rub * across;
        found.force += {push, side, at * side - out * push};
        found.lift.bearing += weight;
        found.lift.heeling -= out * weight;
        found.lift.trimming += at * weight;
    }
    return found;
}

} // namespace windlass::physics
