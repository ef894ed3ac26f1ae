// The evolutions that are shipped without a lesson, an exercise and a coach's script of the same name each,
// played to their end: what a let-go, a weighing and a walk-back should leave behind.

#include "lesson/play.hpp"
#include "server/config/config.hpp"
#include "trainee_client/script.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace windlass::lesson {

namespace {

/// How a script ended, and what was largest on its way.
struct Evolution {
    Played played;
    exercise::WindlassView end;
    double largest_load = 0, largest_brake_load = 0; // N
    double largest_pay_out_speed = 0;                // m/s

    Evolution(const std::string& name) {
        const std::filesystem::path config = WINDLASS_CONFIG_DIR;
        played = play(config::load_exercise(config / "exercises" / (name + ".json")),
                      std::vector{Part{.script = trainee::load_script(config / "scripts" / (name + ".json"),
                                                                      trainee::Eyes::coach),
                                       .coach = true}},
                      [this](const run::Session& session) {
                          end = session.snapshot().tackle.at(0).windlass;
                          largest_load = std::max(largest_load, end.hawse_tension);
                          largest_brake_load = std::max(largest_brake_load, end.brake_load);
                          largest_pay_out_speed = std::max(largest_pay_out_speed, end.cable_speed);
                      });
    }
    bool told(const std::string& event) const {
        return std::ranges::any_of(played.told, [&](const Told& one) { return one.who == event; });
    }
};

TEST(ShippedScripts, LetGoEndsBroughtUpAtSixShackles) {
    const Evolution let_go("let_go_port_25m");
    EXPECT_EQ(let_go.played.stuck, "");
    for (const char* event : {"anchor.let_go", "anchor.on_bottom", "cable.shackle", "anchor.brought_up"})
        EXPECT_TRUE(let_go.told(event)) << event;
    EXPECT_NEAR(let_go.end.cable_out, 6 * 27.5, 3); // the cable that runs while the wheel closes
    EXPECT_GT(let_go.largest_load, 100e3);          // it came to strain
    EXPECT_LT(let_go.largest_load, 0.15 * let_go.end.breaking_load);
    EXPECT_LT(let_go.largest_brake_load, 0.5 * let_go.end.brake_rating);
    EXPECT_LT(let_go.largest_pay_out_speed, 9);
    EXPECT_GT(let_go.end.brake_energy, 0.5e6);
}

TEST(ShippedScripts, ClearLetGoBringUpAndWeighEndsHangingAtTheWater) {
    const Evolution whole("anchor_and_weigh_25m");
    EXPECT_EQ(whole.played.stuck, "");
    EXPECT_NEAR(whole.end.cable_out, 5, 0.5);
    EXPECT_LT(whole.largest_load, 0.15 * whole.end.breaking_load);
}

TEST(ShippedScripts, WalkBackEndsBroughtUpAtNineShacklesWithACoolBrake) {
    const Evolution walk_back("walk_back_60m");
    EXPECT_EQ(walk_back.played.stuck, "");
    EXPECT_NEAR(walk_back.end.cable_out, 9 * 27.5, 3);
    EXPECT_LT(walk_back.largest_pay_out_speed, 0.3); // in gear it never ran
    EXPECT_LT(walk_back.end.brake_energy, 0.1e6);
}

} // namespace
} // namespace windlass::lesson
