// Every ship of config/ships, with the ground tackle that is hers, lets go and lies to her anchor.

#include "rigs/drill.hpp"
#include "server/config/config.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace windlass::exercise {

namespace {

struct Ship {
    const char *file, *anchor, *size; ///< size of chain and windlass
};

void PrintTo(const Ship& ship, std::ostream* out) {
    *out << ship.file;
}

class EveryShip : public testing::TestWithParam<Ship> {};

ExerciseDef roads(const Ship& ship) {
    const std::string text =
        std::string(R"({"environment": {"depth": 30, "wind_speed": 10, "current_speed": 0.3},
            "ship_start": {"surge": -0.4, "heading_deg": 5}, "ship": {"from": ")") +
        ship.file + R"("}, "tackle": [{"windlass": {"from": "electric_)" + ship.size +
        R"("}, "chain": {"from": "stud_link_)" + ship.size + R"(_k3"}, "anchor": {"from": ")" + ship.anchor +
        R"("}}]})";
    return config::parse_exercise(text, ship.file, WINDLASS_CONFIG_DIR);
}

TEST_P(EveryShip, LiesToHerAnchor) {
    constexpr double kCable = 6 * 27.5; // m
    rigs::Drill drill(roads(GetParam()));
    drill.grip(0);
    ASSERT_TRUE(drill.run_until_event("anchor.on_bottom", 120));
    const physics::Vec3 landed = drill.anchor().position;
    // Cable as she falls back from where the anchor fell, no more.
    const auto pay_out = [&] {
        const physics::Vec3 lip = drill.now().tackle[0].hawse;
        const double back = std::hypot(lip.x() - landed.x(), lip.y() - landed.y());
        const double out = drill.chain().cable_out;
        drill.grip(out < kCable && out < lip.z() + 30 + back + 5 ? 0 : 0.3);
        drill.run(0.5);
        return out >= kCable;
    };
    for (int k = 0; k < 2400 && !pay_out(); ++k)
        continue;
    ASSERT_GE(drill.chain().cable_out, kCable - 1);
    drill.brake(1);
    drill.engine(0.4); // the engine takes her way off, not the anchor
    drill.run_until([&] { return drill.now().ship.surge > -0.1; }, 600);
    drill.engine(0);
    drill.run(300);
    EXPECT_EQ(drill.windlass().cable_speed, 0);
    EXPECT_LT(drill.anchor().dragged, 60); // flukes dig in over some 15 m
    EXPECT_LT(drill.largest_tension(), 0.3 * drill.windlass().breaking_load);
    const auto& ship = drill.now().ship;
    EXPECT_LT(std::hypot(ship.surge, ship.sway), 0.7);
    // Down wind and stream of her anchor, within its circle.
    const physics::Vec3 lip = drill.now().tackle[0].hawse, anchor = drill.anchor().position;
    EXPECT_LT(lip.y(), anchor.y() - 0.4 * kCable);
    EXPECT_LT(std::hypot(lip.x() - anchor.x(), lip.y() - anchor.y()), drill.chain().cable_out);
    EXPECT_GT(drill.windlass().hawse_tension, 20e3);
}

INSTANTIATE_TEST_SUITE_P(Ships, EveryShip,
                         testing::Values(Ship{"general_cargo_118m", "stockless_3540", "46mm"},
                                         Ship{"panamax_laden", "stockless_9900", "78mm"},
                                         Ship{"panamax_ballast", "stockless_9900", "78mm"},
                                         Ship{"capesize_laden", "stockless_16900", "100mm"},
                                         Ship{"capesize_ballast", "stockless_16900", "100mm"},
                                         Ship{"vlcc_laden", "stockless_23000", "117mm"},
                                         Ship{"vlcc_ballast", "stockless_23000", "117mm"},
                                         Ship{"car_carrier_200m", "stockless_10500", "78mm"},
                                         Ship{"container_ship_300m", "stockless_14700", "95mm"}),
                         [](const auto& each) { return std::string(each.param.file); });

} // namespace

} // namespace windlass::exercise
