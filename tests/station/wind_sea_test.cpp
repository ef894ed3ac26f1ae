// The sea that belongs to a wind and a fetch.

#include "station/wind_sea.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <numbers>

namespace windlass::station {
namespace {

constexpr double kDeep = 1000; // m

/// The wind at 10 m (m/s) of a wind-stress factor (m/s).
double wind_of(double factor) {
    return std::pow(factor / 0.71, 1 / 1.23);
}

} // namespace

// Worked by hand from equations 3-39 and 3-40: 22.4 m/s of wind-stress factor over 24.4 km, 10.7 m deep.
TEST(WindSea, IsTheManualsOverAFetchInShallowWater) {
    const WindSea sea = wind_sea(wind_of(22.4), 24400, 10.7);
    EXPECT_NEAR(sea.height, 1.5, 0.051);
    EXPECT_NEAR(sea.period, 4.4, 0.11);
}

// In deep water, far from full growth, the growth of JONSWAP: g H / u^2 = 0.0016 (g F / u^2)^(1/2).
TEST(WindSea, GrowsAsJonswapInDeepWater) {
    constexpr double kGravity = 9.80665;
    for (const double wind : {10.0, 20.0, 30.0}) {
        const double u = 0.71 * std::pow(wind, 1.23), fetch = 50e3;
        const double growth = u * u / kGravity * 0.0016 * std::sqrt(kGravity * fetch / (u * u));
        EXPECT_NEAR(wind_sea(wind, fetch, kDeep).height, growth, 0.06 * growth + 0.05) << wind;
    }
}

TEST(WindSea, GrowsWithWindFetchAndDepthAndForce8IsNoMillPond) {
    double wind_before = 0, fetch_before = 0, depth_before = 0;
    for (const double step : {1.0, 2.0, 4.0}) {
        const double by_wind = wind_sea(8 * step, 50e3, 25).height;
        const double by_fetch = wind_sea(19, 5e3 * step, 25).height;
        const double by_depth = wind_sea(19, 50e3, 10 * step).height;
        EXPECT_GT(by_wind, wind_before);
        EXPECT_GT(by_fetch, fetch_before);
        EXPECT_GT(by_depth, depth_before);
        wind_before = by_wind, fetch_before = by_fetch, depth_before = by_depth;
    }
    EXPECT_GT(wind_sea(19, 50e3, 25).height, 2);
}

// What is offered is what a server takes: no steeper than waves break, none that cannot be told.
TEST(WindSea, BreaksNowhereAndIsNoneWithoutWind) {
    EXPECT_EQ(wind_sea(0, 50e3, 25).height, 0);
    EXPECT_EQ(wind_sea(0.5, 100, 25).period, 0);
    for (double wind = 0.5; wind <= 60; wind += 0.5)
        for (const double fetch : {100.0, 1e3, 1e4, 1e5, 1e6, 1e7})
            for (const double depth : {2.0, 10.0, 100.0, 5000.0}) {
                const WindSea sea = wind_sea(wind, fetch, depth);
                const double length = 9.80665 * sea.period * sea.period / (2 * std::numbers::pi);
                EXPECT_LE(14 * sea.height, length) << wind << " m/s, " << fetch << " m, " << depth << " m";
                EXPECT_LE(sea.period, 60);
            }
}

} // namespace windlass::station
