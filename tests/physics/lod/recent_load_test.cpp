// How unsteady the load is, as the estimate of its error goes by it.

#include "server/physics/lod/recent_load.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace windlass::physics {
namespace {

/// So many seconds of a load that is a function of time.
RecentLoad after(double seconds, double dt, const std::function<double(double)>& load,
                 RecentLoad recent = {}) {
    for (double t = dt; t < seconds; t += dt)
        follow_load(load(t), false, dt, recent);
    return recent;
}

} // namespace

TEST(RecentLoad, SteadyLoadIsNotUnsteadyWhateverItIs) {
    for (const double load : {0.0, 1e3, 1e6}) {
        const ModelError error = unsteady_error(after(60, 0.01, [&](double) { return load; }));
        EXPECT_EQ(error.load, 0);
        EXPECT_EQ(error.shape, 0);
    }
}

TEST(RecentLoad, SwingOfALoadIsSeenByItsShareAtEveryStep) {
    // 10 s, between the two means: some of it is in each. Half of its amplitude over root two at least.
    for (const double dt : {1.0 / 300, 0.01, 1.0 / 1200}) {
        const auto swell = [](double t) { return 1e5 * (1 + 0.3 * std::sin(2 * std::numbers::pi * t / 10)); };
        const double seen = unsteadiness(after(100, dt, swell));
        EXPECT_GT(seen, 0.5 * 0.3 / std::numbers::sqrt2) << dt;
        EXPECT_LT(seen, 0.4) << dt;
    }
}

TEST(RecentLoad, RattleFasterThanAGaugeShowsIsNotSeen) {
    const auto rattle = [](double t) { return 1e5 * (1 + 0.5 * std::sin(2 * std::numbers::pi * t * 20)); };
    EXPECT_LT(unsteadiness(after(60, 1.0 / 300, rattle)), 0.01);
}

TEST(RecentLoad, SnapIsForgottenWithinMinutes) {
    const auto snap = [](double t) { return t > 30 && t < 32 ? 3e5 : 1e5; };
    const RecentLoad at_once = after(33, 0.01, snap);
    EXPECT_GT(unsteady_error(at_once).load, 0.1);
    const auto calm = [](double) { return 1e5; };
    const double minute = unsteady_error(after(60, 0.01, calm, at_once)).load;
    EXPECT_GT(minute, 0.01); // the other computation's may yet come
    EXPECT_LT(minute, 0.3 * unsteady_error(at_once).load);
    EXPECT_LT(unsteady_error(after(600, 0.01, calm, at_once)).load, 1e-4);
}

TEST(RecentLoad, StepsOfFirstOrderCount) {
    RecentLoad recent;
    for (int k = 0; k < 3000; ++k)
        follow_load(1e5, k % 10 == 0, 0.01, recent);
    EXPECT_NEAR(recent.poor, 0.1, 0.01);
    EXPECT_GT(unsteady_error(recent).load, 1e-3);
}

} // namespace windlass::physics
