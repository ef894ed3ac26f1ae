// The main job from "stand by" to "brought up", worked as config/scripts/let_go_port_25m.json works it.

#include "rigs/drill.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace windlass::exercise {

using namespace rigs;

namespace {

using physics::kGravity;

/// Weight of cable hanging from the lip down to the seabed, N for each metre of height, summed over air and
/// water.
double weight_of_plumb_cable(const ExerciseDef& def) {
    const physics::ChainDef& chain = def.tackle[0].chain;
    return def.ship.hawse_height * physics::weight_in_air(chain) +
           def.environment.depth * physics::weight_in_water(chain, def.environment.water_density);
}

/// Tension at the hawse pipe by the catenary: horizontal part of the tension plus weight times height (N),
/// with the horizontal part taken from the lead of the cable.
double catenary_tension(const Drill& drill) {
    return drill.windlass().hawse_tension * std::cos(drill.chain().top_angle) +
           weight_of_plumb_cable(drill.exercise().def());
}

} // namespace

/// One let-go, run once and looked at by every test below.
class LetGo : public testing::Test {
protected:
    static void SetUpTestSuite() {
        drill_ = std::make_unique<Drill>(let_go_def());
        paid_out_ = let_go_and_pay_out(*drill_, 6);
        speed_at_brake_on_ = drill_->fastest_payout();
        // The cable comes to strain; the engine takes most of her way off, the anchor the rest.
        drill_->run_until([] { return drill_->windlass().gypsy_load > 75e3; }, 300);
        drill_->engine(0.5);
        drill_->run_until([] { return drill_->now().ship.surge > -0.15; }, 300);
        drill_->engine(0);
        drill_->run_until([] { return drill_->count("anchor.brought_up") > 0; }, 300);
    }
    static void TearDownTestSuite() { drill_.reset(); }

    static std::unique_ptr<Drill> drill_;
    static bool paid_out_;
    static double speed_at_brake_on_;
};

std::unique_ptr<Drill> LetGo::drill_;
bool LetGo::paid_out_ = false;
double LetGo::speed_at_brake_on_ = 0;

TEST_F(LetGo, BrakeHoldsAtSixShackles) {
    ASSERT_TRUE(paid_out_);
    EXPECT_NEAR(drill_->shackles(), 6, 0.15);
    EXPECT_EQ(drill_->windlass().cable_speed, 0);
    EXPECT_EQ(drill_->count("brake.slipping"), 0);
    EXPECT_LT(drill_->windlass().brake_load, drill_->windlass().brake_capacity);
}

TEST_F(LetGo, EventsComeInTheOrderOfTheJob) {
    std::uint64_t before = 0;
    for (const char* code :
         {"anchor.let_go", "anchor.on_bottom", "anchor.digging_in", "anchor.holding", "anchor.brought_up"}) {
        const auto event = drill_->first(code);
        ASSERT_TRUE(event) << code;
        EXPECT_GT(event->number, before) << code;
        before = event->number;
    }
    EXPECT_EQ(drill_->count("anchor.let_go"), 1);
    EXPECT_EQ(drill_->count("anchor.on_bottom"), 1);
    EXPECT_EQ(drill_->count("anchor.brought_up"), 1);
    EXPECT_EQ(drill_->count("cable.bitter_end"), 0);
}

TEST_F(LetGo, EventsAreNumberedWithoutGaps) {
    std::uint64_t number = 0;
    for (const ExerciseEvent& event : drill_->log())
        EXPECT_EQ(event.number, ++number) << event.code;
    EXPECT_GT(number, 0u);
}

TEST_F(LetGo, AnchorLandsWithCableForTheDepth) {
    const auto landed = drill_->first("anchor.on_bottom");
    ASSERT_TRUE(landed);
    // Lip 6 m above the water, 25 m of water, less the anchor that stands under its shackle.
    const ExerciseDef& def = drill_->exercise().def();
    EXPECT_NEAR(landed->value,
                def.ship.hawse_height + def.environment.depth - def.tackle[0].anchor.shank_length, 1);
}

TEST_F(LetGo, CableRunsAtASeamansSpeed) {
    EXPECT_GT(speed_at_brake_on_, 3); // domain: the anchor alone settles at about 5 m/s
    EXPECT_LT(speed_at_brake_on_, 9); // above this a runaway
}

TEST_F(LetGo, LoadStaysFarBelowTheBreakingLoad) {
    EXPECT_LT(drill_->largest_tension(), 0.2 * drill_->windlass().breaking_load);
    // At the least the cable carried its own weight and the anchor's.
    EXPECT_GT(drill_->largest_tension(), 8.0e4);
    EXPECT_EQ(drill_->count("cable.overload"), 0);
}

TEST_F(LetGo, HawseTensionIsTheWeightOfTheCablePlusItsHorizontalPull) {
    EXPECT_NEAR(drill_->windlass().hawse_tension, catenary_tension(*drill_),
                0.02 * drill_->windlass().hawse_tension);
}

TEST_F(LetGo, ShipLiesToHerAnchorWithCableOnTheBottom) {
    EXPECT_EQ(drill_->anchor().phase, AnchorPhase::holding);
    EXPECT_GT(drill_->chain().on_bottom, 20);
    EXPECT_LT(std::hypot(drill_->now().ship.surge, drill_->now().ship.sway), 0.2);
    // The anchor took her way off: more than cable on the bottom could by friction alone.
    EXPECT_GT(drill_->anchor().holding_used, 1e5);
    EXPECT_LE(drill_->anchor().holding_used, 1.001 * drill_->anchor().holding_capacity);
}

TEST_F(LetGo, CableForceOnTheShipIsTheCablesTension) {
    // Pull on the ship is the tension along the lead, plus the weight of half the top link.
    const double tension = drill_->windlass().hawse_tension;
    EXPECT_NEAR(drill_->now().cable_force.norm(), tension, 0.02 * tension);
    EXPECT_LT(drill_->now().cable_force.z(), 0);
}

} // namespace windlass::exercise
