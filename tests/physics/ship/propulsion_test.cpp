// Propeller, rudder, thrusters and engine, of a ship that lies still, makes way, and goes astern.

#include "server/physics/base/units.hpp"
#include "server/physics/ship/ship_dynamics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace windlass::physics {
namespace {

constexpr double kHardOver = 35 * std::numbers::pi / 180;

PlanarForce push(double engine, double rudder, double u, double v = 0, double r = 0) {
    const ShipDef ship;
    return propulsion_force(ship, propulsion_coefficients(ship), kSeaWaterDensity, engine, rudder, u, v, r);
}

EnvironmentDef still() {
    EnvironmentDef sea;
    sea.depth = 1e4, sea.wind_speed = sea.current_speed = 0;
    return sea;
}

TEST(Propeller, GivesTheShipFilesThrustAtRest) {
    const ShipDef ship;
    for (const double order : {0.25, 0.5, 1.0}) {
        EXPECT_NEAR(push(order, 0, 0).x, order * ship.thrust_ahead, 1);
        EXPECT_NEAR(push(-order, 0, 0).x, -order * ship.thrust_astern, 1);
    }
    EXPECT_EQ(push(0, 0, 0).x, 0);
}

TEST(Propeller, PullsLessTheFasterSheGoesAndBrakesAtLast) {
    double before = push(0.5, 0, -2).x;
    for (double u = -1.9; u < 10; u += 0.1) {
        const double now = push(0.5, 0, u).x;
        EXPECT_LT(now, before) << u;
        EXPECT_NEAR(now, before, 0.1 * ShipDef{}.thrust_ahead) << u; // without a jump
        before = now;
    }
    EXPECT_LT(before, 0);
}

TEST(Propeller, BitesHarderAsternWhileSheGoesAhead) {
    const double at_rest = push(-1, 0, 0).x;
    // Hachii's figures: by 1.43 at most, and constant from there.
    EXPECT_NEAR(push(-1, 0, 3).x / at_rest, 1.434, 0.01);
    EXPECT_LT(push(-1, 0, -2).x / at_rest, 0.7);
    EXPECT_GE(push(-1, 0, -2).x / at_rest, 0);
}

TEST(Propeller, GoesFromOneDirectionToTheOtherWithoutAJump) {
    for (const double u : {-3.0, -0.5, 0.5, 3.0, 6.0}) {
        const double ahead = push(1e-9, 0, u).x, astern = push(-1e-9, 0, u).x, stopped = push(0, 0, u).x;
        EXPECT_NEAR(ahead, stopped, 0.01 * std::abs(stopped) + 1) << u;
        EXPECT_NEAR(astern, stopped, 0.01 * std::abs(stopped) + 1) << u;
        EXPECT_LT(stopped * u, 0);
    }
}

// UFC 4-159-03 (2005), eq. 15 to 21: form 5.4, friction 3.0, propeller 4.7 kN of a Panamax in 1 kn.
TEST(Propeller, StoppedOneIsAThirdOfWhatHoldsHerInAStream) {
    const ShipDef ship;
    const double knot = mps_from_knots(1);
    const double hull = -hull_force(hull_coefficients(ship), kSeaWaterDensity, knot, 0, 0).x;
    EXPECT_NEAR(hull - push(0, 0, knot).x, 13e3, 0.2 * 13e3);
    EXPECT_NEAR(-push(0, 0, knot).x, 4.7e3, 0.05 * 4.7e3);
}

// Esso Osaka: 0.14 of the thrust at rest, half of it near J = -0.35.
TEST(Propeller, WalksHerSternToPortGoingAstern) {
    const PlanarForce rest = push(-1, 0, 0);
    EXPECT_NEAR(rest.y / rest.x, 0.14, 0.001);
    EXPECT_GT(rest.moment, 0); // bow to starboard
    const ShipDef ship;
    const double tip = propulsion_coefficients(ship).revolutions * ship.propeller_diameter;
    const PlanarForce way = push(-1, 0, 0.35 * tip);
    EXPECT_NEAR(way.y / way.x, 0.5, 0.03);
    EXPECT_EQ(push(-1, 0, tip).y, 0); // and none at speed
}

TEST(Rudder, TurnsHerInTheRaceWithoutWay) {
    const PlanarForce force = push(1, kHardOver, 0);
    const ShipDef ship;
    EXPECT_LT(force.y, 0); // stern to port
    EXPECT_GT(force.moment, 0);
    // A rudder that fills the race turns half of it aside, and the hull beside it feels 0.39 of that: 0.3 to
    // 0.7 of the bollard pull.
    EXPECT_GT(-force.y, 0.3 * ship.thrust_ahead);
    EXPECT_LT(-force.y, 0.7 * ship.thrust_ahead);
    EXPECT_NEAR(push(0.5, kHardOver, 0).y, 0.5 * force.y, 1e-6 * ship.thrust_ahead);
    EXPECT_EQ(push(0, kHardOver, 0).y, 0);
}

TEST(Rudder, HasWayAloneOnceTheEngineIsStopped) {
    const double u = 3;
    const double running = push(0.5, kHardOver, u).moment, stopped = push(0, kHardOver, u).moment;
    EXPECT_GT(stopped, 0);
    EXPECT_LT(stopped, 0.5 * running);           // the propeller shadows it
    EXPECT_LT(push(0, kHardOver, -u).moment, 0); // and with sternway it works the other way
}

TEST(Rudder, AmidshipsChecksADriftAndATurn) {
    EXPECT_LT(push(0.5, 0, 3, 0.5).y, 0);
    EXPECT_LT(push(0.5, 0, 3, 0, 0.01).moment, 0);
}

TEST(Thruster, LosesHalfItsTurningAtFourKnots) {
    EXPECT_EQ(thruster_share(0), 1);
    EXPECT_NEAR(thruster_share(mps_from_knots(4)), 0.5, 1e-12);
    EXPECT_NEAR(thruster_share(mps_from_knots(-4)), 0.5, 1e-12);
    EXPECT_EQ(thruster_share(mps_from_knots(20)), 1);
}

// Hull, stopped propeller and rudder together, rudder where it may: the water only takes.
TEST(Propulsion, StoppedNeverGivesEnergy) {
    const ShipDef ship;
    const HullCoefficients hull = in_depth(hull_coefficients(ship), 25);
    std::mt19937 random(2);
    std::uniform_real_distribution<double> speed(-4, 4), rate(-0.02, 0.02), angle(-kHardOver, kHardOver);
    for (int k = 0; k < 100000; ++k) {
        const double u = speed(random), v = speed(random), r = rate(random);
        PlanarForce f = hull_force(hull, kSeaWaterDensity, u, v, r);
        f += push(0, angle(random), u, v, r);
        ASSERT_LT(f.x * u + f.y * v + f.moment * r + (hull.added_sway - hull.added_surge) * u * v * r, 0)
            << u << ' ' << v << ' ' << r;
    }
}

TEST(Engine, FollowsTheTelegraph) {
    const ShipDef ship;
    ShipState state;
    for (int k = 0; k < 240; ++k)
        step_engine(ship, 1, true, 0.1, state);
    EXPECT_NEAR(state.engine, 1 - std::exp(-3), 0.01);
    step_engine(ship, -1, true, 0.1, state);
    EXPECT_LT(state.engine, 0.95); // no waiting where nothing must be reversed
}

TEST(Engine, StandsBeforeItTurnsTheOtherWay) {
    ShipDef ship;
    ship.engine_start_time = 20;
    ShipState state;
    state.engine = 1;
    double standing = 0, first_astern = 0, time = 0;
    for (; time < 120 && first_astern == 0; time += 0.1) {
        step_engine(ship, -1, true, 0.1, state);
        if (state.engine == 0) standing += 0.1;
        if (state.engine < 0) first_astern = time;
        EXPECT_LE(state.engine, 1);
    }
    EXPECT_NEAR(standing, 20, 0.3);
    EXPECT_GT(first_astern, 40); // running down took 8 s ln 50
    for (int k = 0; k < 600; ++k)
        step_engine(ship, -1, true, 0.1, state);
    EXPECT_NEAR(state.engine, -1, 0.01);
}

TEST(Engine, RunsDownInABlackoutAndRudderStays) {
    const ShipDef ship;
    ShipDynamics dynamics(ship);
    ShipState state;
    state.engine = 1, state.rudder = 0.1;
    for (int k = 0; k < 600; ++k)
        dynamics.step(still(), {.engine = 1, .rudder = 0.5, .bow_thruster = 1},
                      {.engine_available = false, .steering_available = false, .thrusters_available = false},
                      {}, 0.1, state);
    EXPECT_LT(state.engine, 1e-3);
    EXPECT_EQ(state.rudder, 0.1);
}

// IMO MSC.137(76): 15 lengths, 20 of large ships, from full ahead; and not less than ships are known to take.
TEST(ShipDynamics, StopsInAFewMinutesAndLengths) {
    const ShipDef ship;
    ShipDynamics dynamics(ship);
    ShipState state;
    state.engine = 1, state.surge = 5;
    for (int k = 0; k < 36000; ++k)
        dynamics.step(still(), {.engine = 1}, {}, {}, 0.1, state);
    EXPECT_GT(knots_from_mps(state.surge), 10); // manoeuvring full ahead of a laden Panamax: 11 to 13 kn
    EXPECT_LT(knots_from_mps(state.surge), 14);
    double way = 0, time = 0;
    for (; state.surge > 0; time += 0.1) {
        dynamics.step(still(), {.engine = -1}, {}, {}, 0.1, state);
        way += 0.1 * ship_velocity(state).norm();
    }
    EXPECT_LT(way / ship.length_pp, 15);
    EXPECT_GT(way / ship.length_pp, 3);
    EXPECT_GT(time, 180);
    EXPECT_LT(time, 1200);
    EXPECT_GT(state.heading, 0.05); // and her bow went to starboard meanwhile
}

} // namespace
} // namespace windlass::physics
