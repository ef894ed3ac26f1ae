// A ship at anchor in a steady wind is not steady: she sheers from side to side, and her cable's load with
// her.

#include "rigs/drill.hpp"
#include "server/config/config.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace windlass::exercise {

namespace {

struct Sheering {
    double yaw = 0;     ///< deg, farthest off the wind in the last hour
    double period = 0;  ///< s, from one side to the other and back, in the mean; 0: less than one
    double mean = 0;    ///< N, of the cable's load
    double peak = 0;    ///< N
    double dragged = 0; ///< m, in that hour
};

/// A Panamax on 212 m in 30 m, anchor of 9.9 t in sand, wind of so many m/s from the north; half an hour to
/// bring up, and an hour.
Sheering panamax(const std::string& ship, double wind) {
    Drill drill(parse_exercise(
        R"({"environment": {"depth": 30, "wind_speed": 8, "current_speed": 0}, "ship": {"from": ")" + ship +
            R"("}, "ship_start": {"surge": -0.4, "heading_deg": 5}, "tackle": [{"windlass": {"from": "electric_78mm"},
            "chain": {"from": "stud_link_78mm_k3"}, "anchor": {"from": "stockless_9900"}}]})",
        ship, WINDLASS_CONFIG_DIR));
    drill.brake(0);
    EXPECT_TRUE(drill.run_until_event("anchor.on_bottom", 120));
    const physics::Vec3 landed = drill.anchor().position;
    for (int k = 0; k < 2400 && drill.chain().cable_out < 212; ++k) {
        const physics::Vec3 lip = drill.now().tackle[0].hawse;
        const double back = std::hypot(lip.x() - landed.x(), lip.y() - landed.y());
        drill.brake(drill.chain().cable_out < lip.z() + 35 + back ? 0 : 1);
        drill.run(0.5);
    }
    drill.brake(1);
    drill.wind(wind);
    drill.run(1800);
    Sheering s;
    const double dragged = drill.anchor().dragged;
    double first = 0, last = 0;
    int crossings = -1, side = 0, looks = 0;
    for (; looks < 3600; ++looks) {
        drill.run(1);
        const double off =
            std::remainder(drill.now().ship.heading, 2 * std::numbers::pi) * 180 / std::numbers::pi;
        s.yaw = std::max(s.yaw, std::abs(off));
        s.peak = std::max(s.peak, drill.windlass().hawse_tension);
        s.mean += drill.windlass().hawse_tension / 3600;
        constexpr double kFar = 3; // deg, that count as a side
        const int now = off > kFar ? 1 : off < -kFar ? -1 : side;
        if (now == side) continue;
        if (side != 0) {
            if (++crossings == 0) first = looks;
            last = looks;
        }
        side = now;
    }
    s.period = crossings > 0 ? 2 * (last - first) / crossings : 0;
    s.dragged = drill.anchor().dragged - dragged;
    std::printf("%s %g m/s: yaw %.0f deg, period %.1f min, load %.0f kN mean %.0f kN peak, dragged %.1f m\n",
                ship.c_str(), wind, s.yaw, s.period / 60, s.mean / 1000, s.peak / 1000, s.dragged);
    return s;
}

} // namespace

// Practice: 5 to 15 minutes an eight, 20 to 50 degrees to either side, in ballast worse than laden.
TEST(YawAtAnchor, BallastSheersMoreThanLaden) {
    const Sheering ballast = panamax("panamax_ballast", 12), laden = panamax("panamax_laden", 12);
    EXPECT_GT(ballast.yaw, 15);
    EXPECT_LT(ballast.yaw, 50);
    EXPECT_GT(ballast.period, 300);
    EXPECT_LT(ballast.period, 1500);
    EXPECT_LT(laden.yaw, ballast.yaw);
    EXPECT_LT(laden.peak / laden.mean, ballast.peak / ballast.mean);
    EXPECT_LT(ballast.dragged, 20);
}

} // namespace windlass::exercise
