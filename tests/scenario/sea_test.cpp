// A ship at anchor in a sea: what waves do to the load, and how well it is computed.

#include "rigs/drill.hpp"
#include "server/exercise/checkpoint.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace windlass::exercise {
using namespace rigs;

namespace {

/// Six shackles in 25 m in a fresh breeze, in the swell that is asked for; cable held by the brake.
ExerciseDef swell_def(double height, double period) {
    ExerciseDef def = steady_breeze_def();
    def.weather.swell_height = height;
    def.weather.swell_period = period;
    def.weather.swell_from = def.weather.wind_from;
    return def;
}

struct Loads {
    double mean = 0, deviation = 0, least = 1e300, most = 0; ///< N, at the hawse
    double lip = 0;                                          ///< m, of the lip's height: deviation
};

Loads ride(Drill& drill, double seconds) {
    Loads loads;
    double sum = 0, squares = 0, height = 0, heights = 0;
    int count = 0;
    const double end = drill.now().time + seconds;
    while (drill.now().time < end) {
        drill.tick();
        const double load = drill.windlass().hawse_tension, z = drill.now().tackle[0].hawse.z();
        sum += load, squares += load * load, height += z, heights += z * z;
        loads.least = std::min(loads.least, load), loads.most = std::max(loads.most, load);
        ++count;
    }
    loads.mean = sum / count;
    loads.deviation = std::sqrt(std::max(0.0, squares / count - loads.mean * loads.mean));
    loads.lip = std::sqrt(heights / count - height * height / count / count);
    return loads;
}

TEST(Sea, MovesTheHawseAndTheLoadAndKeepsTheCableDynamic) {
    Drill calm(swell_def(0, 12)), swell(swell_def(3, 12));
    ASSERT_TRUE(let_go_and_pay_out(calm, 5));
    ASSERT_TRUE(let_go_and_pay_out(swell, 5));
    calm.brake(1), swell.brake(1);
    calm.run(120), swell.run(120);
    const Loads flat = ride(calm, 120), rides = ride(swell, 120);
    EXPECT_EQ(flat.lip, 0);
    // 3 m of 12 s, 170 m long in this depth, lift the bow of a ship of 225 m by 0.3 m, root mean square.
    EXPECT_GT(rides.lip, 0.15);
    EXPECT_LT(rides.lip, 0.6);
    EXPECT_GT(rides.deviation, 3 * flat.deviation);
    EXPECT_EQ(swell.now().model_level, ModelLevel::dynamic);
    EXPECT_TRUE(std::isfinite(rides.most));
    // Roll, pitch and heave are in the picture.
    const auto axes = swell.now().ship.attitude.toRotationMatrix();
    EXPECT_NE(axes(2, 0), 0);
    EXPECT_NE(swell.now().ship.position.z(), 0);
}

TEST(Sea, IsOrderedWhileItRuns) {
    Drill drill(quiet_def(25, 5));
    drill.run(1);
    EXPECT_TRUE(drill.now().sea.waves.empty());
    EnvironmentOrder order{.weather = drill.now().environment.now, .ramp = 60};
    order.weather.swell_height = 2;
    drill.give(order);
    drill.run(30);
    EXPECT_EQ(drill.now().sea.waves.size(), 14U);
    EXPECT_NEAR(drill.now().environment.now.swell_height, 1, 0.01);
    EXPECT_EQ(drill.now().sea.ramp_end - drill.now().sea.ramp_begin, 60);
    drill.run(31);
    EXPECT_EQ(drill.now().sea.ramp_end, drill.now().sea.ramp_begin);
    EXPECT_GT(std::abs(drill.now().ship.position.z()), 0);
    order.weather.swell_height = 0;
    order.ramp = 0; // at once is half a minute
    drill.give(order);
    drill.run(31);
    EXPECT_TRUE(drill.now().sea.waves.empty());
    EXPECT_EQ(drill.now().ship.position.z(), 0);
}

TEST(Sea, IsKeptInACheckpointInTheMiddleOfARamp) {
    ExerciseDef def = swell_def(2, 11);
    def.weather.gust_factor = 1.3;
    Drill drill(def);
    EnvironmentOrder order{.weather = drill.now().environment.now, .ramp = 40};
    order.weather.swell_from = 2, order.weather.wave_height = 1;
    drill.give(order);
    drill.run(5);
    order.weather.swell_from = 3; // waits until the first is gone
    drill.give(order);
    drill.run(5);
    auto& live = const_cast<Exercise&>(drill.exercise());
    Exercise read = read_checkpoint(write_checkpoint(live));
    for (int k = 0; k < 300 * 40; ++k) {
        live.step(1.0 / live.def().tick_rate_hz);
        read.step(1.0 / read.def().tick_rate_hz);
    }
    const auto found = differences(live, read);
    EXPECT_TRUE(found.empty()) << found[0].field << ' ' << found[0].first << ' ' << found[0].second;
}

TEST(Sea, OfAnotherSeedIsAnotherSeaOfTheSameKind) {
    ExerciseDef def = swell_def(2, 11);
    Drill one(def), same(def);
    def.weather.wave_seed = 9;
    Drill other(def);
    one.run(10), same.run(10), other.run(10);
    EXPECT_EQ(one.now().state_hash, same.now().state_hash);
    EXPECT_NE(one.now().ship.position.z(), other.now().ship.position.z());
    EXPECT_EQ(one.now().sea.waves[3].omega, other.now().sea.waves[3].omega);
}

TEST(Sea, GustsReachTheShipAndTheAnemometer) {
    ExerciseDef def = quiet_def(25, 5);
    def.weather.wind_speed = 15, def.weather.gust_factor = 1.4;
    Drill drill(def);
    double most = 0, least = 0;
    for (int k = 0; k < 300; ++k) {
        drill.run(1);
        most = std::max(most, drill.now().environment.gust);
        least = std::min(least, drill.now().environment.gust);
    }
    EXPECT_GT(most, 2); // 0.4 of 15 m/s is the largest of ten minutes
    EXPECT_LT(most, 10);
    EXPECT_LT(least, -2);
    EXPECT_EQ(drill.now().environment.now.wind_speed, 15);
}

} // namespace
} // namespace windlass::exercise
