// What the cable of a ship at anchor carries is what wind, stream and waves ask of her, and what takes her
// way off her is in the books.

#include "rigs/drill.hpp"
#include "server/exercise/prelude.hpp"
#include "server/physics/ship/hull_force.hpp"
#include "server/physics/ship/propulsion.hpp"
#include "server/physics/ship/wave_response.hpp"
#include "server/physics/ship/wind.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace windlass::exercise {
using namespace rigs;

namespace {

using physics::Vec3;

constexpr double kTick = 1.0 / 300; // s

/// N, along her, of wind and stream from right ahead and of the mean drift of a head sea's waves, each alone.
double asked_ahead(const ExerciseDef& def, double wind, double current, const SeaView& sea) {
    const physics::ShipDef& ship = def.ship;
    const auto hull = in_depth(physics::hull_coefficients(ship), def.environment.depth);
    double force = wind_force(ship, wind, 0).x + hull_force(hull, 1025, current, 0, 0).x +
                   propulsion_force(ship, propulsion_coefficients(ship), 1025, 0, 0, current, 0, 0).x;
    for (const physics::WaveComponent& c : sea.waves) {
        // She heads north; waves of atan2(k_x, k_y) clockwise from there run anticlockwise from ahead by:
        const auto r = wave_response(ship, c.omega, std::hypot(c.k_x, c.k_y), def.environment.depth,
                                     -std::atan2(c.k_x, c.k_y));
        force += c.amplitude_after * c.amplitude_after * r.drift_surge * std::abs(r.drift_surge);
    }
    return force;
}

// Held head on by her thrusters, as an officer would to measure it, for forty minutes; 1 % of the load is
// what is asked for. What she gained of speed meanwhile is her mass times it, and is taken off.
TEST(SteadyLoad, IsThatOfWindStreamAndWaveDrift) {
    ExerciseDef def = let_go_def();
    def.weather.wind_speed = 15, def.weather.wind_from = 0;
    def.weather.current_speed = 0.8, def.weather.current_towards = std::numbers::pi;
    def.weather.swell_height = 1.2, def.weather.swell_period = 9, def.weather.swell_from = 0;
    def.tackle[0].at_anchor = 6;
    Drill drill(with_prelude_played(def));
    const auto run = [&](double seconds, double& pull) {
        for (int k = 0; k < seconds * 300; ++k) {
            const double off = std::remainder(drill.now().ship.heading, 2 * std::numbers::pi);
            const double turn = std::clamp(-20 * off - 400 * drill.now().ship.yaw_rate, -1.0, 1.0);
            if (k % 30 == 0) drill.helm(0, turn, -turn);
            drill.tick();
            pull += drill.now().cable_force.y() * kTick;
        }
    };
    double ignored = 0, impulse = 0;
    run(1200, ignored);
    const double before = drill.now().ship.velocity.y(), seconds = 2400;
    run(seconds, impulse);
    const auto hull = physics::hull_coefficients(def.ship);
    const double gained = (hull.mass + hull.added_surge) * (drill.now().ship.velocity.y() - before);
    const double asked = -asked_ahead(def, 15, 0.8, drill.now().sea);
    EXPECT_GT(asked, 80e3);
    EXPECT_NEAR((impulse - gained) / seconds, asked, 0.01 * asked);
    RecordProperty("asked_kN", static_cast<int>(asked / 1e3));
}

// Half a knot astern at let-go in still air and water: what she loses of kinetic energy until she lies is the
// work on her cable and on the water about her. The cable's own books are those of EnergyTest.
TEST(SteadyLoad, WayAtLetGoIsInCableAndDrag) {
    ExerciseDef def = quiet_def(25, 5);
    def.ship_start.surge = -0.5;
    Drill drill(def);
    const auto hull = in_depth(physics::hull_coefficients(def.ship), def.environment.depth);
    const auto propulsion = propulsion_coefficients(def.ship);
    const auto energy = [&] {
        const ShipView& s = drill.now().ship;
        return 0.5 * ((hull.mass + hull.added_surge) * s.surge * s.surge +
                      (hull.mass + hull.added_sway) * s.sway * s.sway +
                      (hull.inertia + hull.added_yaw) * s.yaw_rate * s.yaw_rate);
    };
    const double start = energy();
    double cable = 0, water = 0;
    drill.brake(0);
    for (int k = 0; k < 400 * 300; ++k) {
        if (drill.chain().cable_out > 110) drill.brake(1);
        const ShipView was = drill.now().ship;
        drill.tick();
        const ShipView& now = drill.now().ship;
        // Middle of the tick; the pull that moves her in a tick is that of the last one's, a 300th of a
        // second.
        const double u = 0.5 * (was.surge + now.surge), v = 0.5 * (was.sway + now.sway);
        const double r = 0.5 * (was.yaw_rate + now.yaw_rate), heading = now.heading;
        const Vec3 ahead(std::sin(heading), std::cos(heading), 0),
            abeam(std::cos(heading), -std::sin(heading), 0);
        const Vec3 force = drill.now().cable_force;
        cable += kTick * (u * force.dot(ahead) + v * force.dot(abeam) - r * drill.now().cable_moment.z());
        auto drag = hull_force(hull, 1025, u, v, r);
        drag += propulsion_force(def.ship, propulsion, 1025, 0, 0, u, v, r);
        const Vec3 wind = -drill.now().ship.velocity;
        drag += wind_force(def.ship, wind.norm(), std::atan2(-wind.dot(abeam), -wind.dot(ahead)));
        // What the water that goes with her hands from one motion to another (hull_force.hpp).
        const double handed = (hull.added_sway - hull.added_surge) * u * v * r;
        water += kTick * (drag.x * u + drag.y * v + drag.moment * r + handed);
    }
    EXPECT_GT(start, 8e6); // J: 77 kt at a knot
    EXPECT_LT(energy(), 0.2 * start);
    EXPECT_LT(cable, -0.3 * start);
    EXPECT_NEAR(energy() - start, cable + water, 0.01 * start);
}

} // namespace
} // namespace windlass::exercise
