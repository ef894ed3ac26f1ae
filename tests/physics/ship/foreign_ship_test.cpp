// A ship that another simulator moves: where she is between its samples, over late and lost ones.

#include "server/physics/ship/foreign_ship.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace windlass::physics {
namespace {

constexpr double kTick = 1.0 / 300, kSample = 0.05; // s
constexpr double kDegree = std::numbers::pi / 180;

ShipDef ship_def() {
    ShipDef def;
    def.hawse_forward = 100, def.hawse_outboard = 7, def.hawse_height = 10;
    return def;
}

/// What a simulator would say of a ship in this state at t of its clock.
ForeignSample sample_of(const ShipState& ship, double t) {
    return {midships(ship), attitude(ship), ship_velocity(ship) + wave_velocity(ship), spin(ship), t};
}

/// A ship on a straight course at a steady speed.
ShipState on_course(double t) {
    ShipState ship;
    ship.heading = 30 * kDegree;
    ship.surge = 1.5, ship.sway = 0.2;
    const Vec3 at = t * ship_velocity(ship);
    ship.x = at.x(), ship.y = at.y();
    return ship;
}

/// A ship that heaves, rolls and pitches in a swell of 10 s.
ShipState in_swell(double t) {
    ShipState ship;
    const double w = 2 * std::numbers::pi / 10;
    const auto swing = [&](double size, double phase, double& place, double& rate) {
        place = size * std::sin(w * t + phase), rate = size * w * std::cos(w * t + phase);
    };
    swing(2, 0, ship.waves.heave, ship.waves.heave_speed);
    swing(8 * kDegree, 1, ship.waves.roll, ship.waves.roll_rate);
    swing(3 * kDegree, 2, ship.waves.pitch, ship.waves.pitch_rate);
    swing(2 * kDegree, 0.5, ship.heading, ship.yaw_rate);
    return ship;
}

/// Samples of a motion at 20 Hz, each some time on its way, into a ForeignShip; look() after every tick from
/// `from` on.
void sail(ForeignShip& foreign, ShipState& ship, const std::function<ShipState(double)>& motion,
          const std::function<double(int)>& delay, double from, double seconds,
          const std::function<void(double)>& look) {
    int sent = 0;
    std::vector<std::pair<double, ForeignSample>> under_way;
    for (int tick = 1; tick * kTick <= seconds; ++tick) {
        const double t = tick * kTick;
        for (; sent * kSample <= t; ++sent)
            under_way.emplace_back(sent * kSample + delay(sent),
                                   sample_of(motion(sent * kSample), sent * kSample + 5000));
        std::erase_if(under_way, [&](const auto& each) {
            if (each.first > t - kTick) return false;
            foreign.hear(each.second, t - kTick, ship); // as an exercise does: between two ticks
            return true;
        });
        if (foreign.drive(t) != ForeignShip::Drive::none) foreign.place(t, ship);
        if (t >= from) look(t);
    }
}

double hardly_any(int) {
    return 0.002;
}
double jitter(int n) { // 5 to 50 ms, and every twentieth is lost
    return n % 20 == 19 ? 1e9 : 0.005 + 0.045 * ((n * 7919) % 97) / 96;
}

TEST(ForeignShip, HerAttitudeAndTurningAreThoseOfTheSample) {
    // A ship that turns to starboard while she goes north-east, and rolls and pitches meanwhile.
    ShipState was;
    was.x = 10, was.y = 20, was.heading = 45 * kDegree, was.surge = 3, was.yaw_rate = 0.01;
    was.waves.roll = 0.2, was.waves.pitch = -0.1, was.waves.heave = 1;
    was.waves.roll_rate = 0.03, was.waves.pitch_rate = 0.02, was.waves.heave_speed = -0.4;
    ForeignShip foreign;
    ShipState ship = was;
    ASSERT_EQ(foreign.hear(sample_of(was, 7), 0, ship), ForeignShip::Answer::took_over);
    foreign.place(0, ship);
    EXPECT_NEAR((midships(ship) - midships(was)).norm(), 0, 1e-12);
    EXPECT_NEAR(attitude(ship).angularDistance(attitude(was)), 0, 1e-7); // an arc cosine of nearly 1
    EXPECT_NEAR((spin(ship) - spin(was)).norm(), 0, 1e-12);
    EXPECT_GT(ship.yaw_rate, 0) << "to starboard";
    for (const double side : {-1.0, 1.0}) {
        EXPECT_NEAR((hawse_position(ship_def(), ship, side) - hawse_position(ship_def(), was, side)).norm(),
                    0, 1e-9);
        EXPECT_NEAR((hawse_velocity(ship_def(), ship, side) - hawse_velocity(ship_def(), was, side)).norm(),
                    0, 1e-9);
    }
}

TEST(ForeignShip, OnAStraightCourseJitterAndLossAreNotSeen) {
    ForeignShip foreign;
    ShipState ship = on_course(0);
    // The clock is set by the sample that was least on its way, 5 ms and later: she is that much behind
    // herself.
    const double speed = ship_velocity(ship).norm();
    sail(foreign, ship, on_course, jitter, 10, 30, [&](double t) {
        EXPECT_NEAR((midships(ship) - midships(on_course(t))).norm(), 0, 0.009 * speed) << t;
        EXPECT_NEAR((ship_velocity(ship) - ship_velocity(on_course(t))).norm(), 0, 0.02) << t;
        EXPECT_EQ(foreign.drive(t), ForeignShip::Drive::fresh);
    });
}

TEST(ForeignShip, InASwellHerLipIsWithinTwoCentimetresAndNeverJumps) {
    ForeignShip foreign;
    ShipState ship = in_swell(0);
    Vec3 before = hawse_position(ship_def(), ship, -1), speed_before = hawse_velocity(ship_def(), ship, -1);
    double off_max = 0, jump_max = 0;
    sail(foreign, ship, in_swell, hardly_any, 0, 60, [&](double t) {
        const Vec3 lip = hawse_position(ship_def(), ship, -1), speed = hawse_velocity(ship_def(), ship, -1);
        if (t > 2) {
            off_max = std::max(off_max, (lip - hawse_position(ship_def(), in_swell(t), -1)).norm());
            // What she moved in a tick is what her velocity says: a trapezium's error is a dt^3 / 12 of what
            // bends it.
            jump_max = std::max(jump_max, (lip - before - 0.5 * kTick * (speed + speed_before)).norm());
        }
        before = lip, speed_before = speed;
    });
    // 4.3 m/s2 at the lip, of pitch, yaw and heave: 0.5 a (50 ms)^2 is 5 mm; and 2 ms on the way at 6 m/s are
    // 12 mm.
    EXPECT_LT(off_max, 0.02);
    EXPECT_LT(jump_max, 1e-4); // 0.3 kN on the tautest cable
}

TEST(ForeignShip, WhatIsOffAtTheTakeOverIsTakenUpSlowly) {
    ForeignShip foreign;
    ShipState ship; // at rest at the origin
    ShipState other;
    other.x = 0.6, other.y = -0.5, other.heading = 3 * kDegree;
    double fastest = 0;
    sail(
        foreign, ship, [&](double) { return other; }, hardly_any, 0, 20,
        [&](double) { fastest = std::max(fastest, ship_velocity(ship).norm()); });
    EXPECT_NEAR(ship.x, 0.6, 1e-3);
    EXPECT_NEAR(ship.y, -0.5, 1e-3);
    EXPECT_NEAR(ship.heading, 3 * kDegree, 1e-4);
    EXPECT_GT(fastest, 0.1);
    EXPECT_LT(fastest, 0.5); // 0.2 m/s each way in the mean, 1.5 times that in the middle of a cubic
}

TEST(ForeignShip, AJumpAndAnOldSampleChangeNothing) {
    ForeignShip foreign;
    ShipState ship;
    ForeignSample far = sample_of(ship, 1);
    far.position.x() = 1.1;
    EXPECT_EQ(foreign.hear(far, 0, ship), ForeignShip::Answer::jumped);
    EXPECT_EQ(foreign.drive(0), ForeignShip::Drive::none);
    ForeignSample turned = sample_of(ship, 1);
    turned.attitude = Eigen::AngleAxisd(6 * kDegree, Vec3::UnitZ()) * turned.attitude;
    EXPECT_EQ(foreign.hear(turned, 0, ship), ForeignShip::Answer::jumped);
    EXPECT_EQ(foreign.hear(sample_of(ship, 1), 0, ship), ForeignShip::Answer::took_over);
    EXPECT_EQ(foreign.hear(sample_of(ship, 1), 0.1, ship), ForeignShip::Answer::out_of_order);
    EXPECT_EQ(foreign.hear(sample_of(ship, 0.9), 0.1, ship), ForeignShip::Answer::out_of_order);
    far.time = 1.1;
    EXPECT_EQ(foreign.hear(far, 0.1, ship), ForeignShip::Answer::jumped);
    foreign.place(0.2, ship);
    EXPECT_EQ(ship.x, 0);
}

TEST(ForeignShip, SilenceTakesHerWayOffWithoutAJerk) {
    ForeignShip foreign;
    ShipState ship = on_course(0);
    const double speed = ship_velocity(ship).norm();
    foreign.hear(sample_of(ship, 100), 0, ship);
    double before = speed;
    for (int tick = 1; tick * kTick < 6; ++tick) {
        const double t = tick * kTick;
        foreign.place(t, ship);
        const double now = ship_velocity(ship).norm();
        EXPECT_LE(now, before + 1e-12);
        EXPECT_LT(before - now, 2 * speed * kTick / (ForeignShip::kStill - ForeignShip::kLate)) << t;
        before = now;
        EXPECT_EQ(foreign.drive(t), t < ForeignShip::kLate    ? ForeignShip::Drive::fresh
                                    : t < ForeignShip::kStill ? ForeignShip::Drive::late
                                                              : ForeignShip::Drive::held);
    }
    EXPECT_EQ(before, 0);
    const double way = speed * (ForeignShip::kLate + 0.5 * (ForeignShip::kStill - ForeignShip::kLate));
    EXPECT_NEAR(std::hypot(ship.x, ship.y), way, 1e-9);
}

TEST(ForeignShip, HandedBackSheGoesOnFromWhereSheIs) {
    ForeignShip foreign;
    ShipState ship = in_swell(0);
    const double end = 12.34;
    sail(foreign, ship, in_swell, hardly_any, 0, end, [](double) {});
    const Vec3 lip = hawse_position(ship_def(), ship, 1), speed = hawse_velocity(ship_def(), ship, 1);
    WaveMotion sea; // the server's own sea moves her otherwise
    sea.surge = 0.4, sea.sway = -0.3, sea.surge_speed = 0.1, sea.heave = -0.5, sea.pitch_rate = 0.01;
    foreign.release(end, sea, ship);
    foreign.fade(end, ship.waves = sea);
    EXPECT_NEAR((hawse_position(ship_def(), ship, 1) - lip).norm(), 0, 1e-9);
    // Surge and sway are hers in the plane now: their turning with the heading is what is left out.
    EXPECT_NEAR((hawse_velocity(ship_def(), ship, 1) - speed).norm(), 0,
                0.5 * std::abs(ship.yaw_rate) + 1e-9);
    EXPECT_EQ(foreign.drive(end), ForeignShip::Drive::none);
    WaveMotion later = sea;
    foreign.fade(end + 20, later);
    EXPECT_EQ(later.heave, sea.heave) << "nothing of it is left";
}

} // namespace
} // namespace windlass::physics
