// An anchor foul of its own cable or of an old one, and one that is bent: brought about by handling, and
// avoided by right handling with everything else the same.

#include "tests/scenario/drill.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace windlass::exercise {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;

constexpr double kStream = 0.75; // m/s

/// So much cable (m) let go in 25 m: in a heap under a ship that is all but dead in the water, or laid out as
/// she falls back before a stream that sets in some direction (rad clockwise from north).
Drill paid_out(bool heap, double cable, double towards) {
    ExerciseDef def = quiet_def(25, 5);
    def.environment.current_speed = heap ? 0.1 : kStream;
    def.environment.current_towards = heap ? 0 : towards;
    if (!heap) def.ship_start.heading = towards + 0.5 * kTurn, def.ship_start.surge = -kStream;
    Drill drill(def);
    drill.brake(0);
    EXPECT_TRUE(drill.run_until_event("anchor.on_bottom", 30));
    const physics::Vec3 anchor = drill.anchor().shackle;
    const auto out = [&] {
        // As much as lies on the ground and hangs; in a heap all that there is.
        const physics::Vec3 lip = drill.chain().nodes.front().cast<double>();
        const double laid = 35 + std::hypot(lip.x() - anchor.x(), lip.y() - anchor.y());
        drill.brake(!heap && drill.chain().cable_out > laid ? 0.1 : 0);
        return drill.chain().cable_out > cable;
    };
    EXPECT_TRUE(drill.run_until(out, 400));
    drill.brake(1);
    drill.run(5);
    return drill;
}

/// The stream sets her off until the cable has come taut and the anchor holds or has been dragged 20 m.
void set_off(Drill& drill, double towards) {
    drill.current(kStream, towards);
    const double dragged = drill.anchor().dragged;
    drill.run_until([&] { return drill.anchor().dragged > dragged + 20 || drill.anchor().embedment > 0.9; },
                    1200);
}

/// The stream goes once and a half round the compass in ten minutes, as in an eddy, and then sets her off.
void set_about(Drill& drill, double from) {
    constexpr double kRound = 400, kLook = 5; // s
    constexpr int kLooks = 120;               // once and a half round
    for (int k = 0; k < kLooks; ++k) {
        drill.current(kStream, from + kTurn * k * kLook / kRound);
        drill.run(kLook);
    }
    set_off(drill, from + 0.5 * kTurn);
}

} // namespace

// "Never pile the cable on the anchor." Drawn out straight a heap comes clear, from its top; but it does not
// keep the ship off, so that a stream that turns takes her about over the anchor with all her cable slack,
// and may lay it round in rings, which catch it (tests/physics/foul_test.cpp). Cable that was laid out keeps
// her on one side.
// Disabled: which heap is caught is chance. One of the first four was, until the weights of the chain's step
// moved; since then neither of the two tried again, nor any of seven in streams that went round twice and a
// half: the ship herself then makes one turn at most about her anchor. Nothing else than contact decides it,
// and how often one should be caught is not known.
TEST(FoulAnchor, DISABLED_CableLetOutInAHeapFoulsTheAnchorInATurningStream) {
    constexpr double kCable = 110; // m
    bool foul = false;
    for (int way = 0; way < 16 && !foul; ++way) {
        const double from = way * kTurn * 5 / 16;
        Drill heap = paid_out(true, kCable, from);
        set_about(heap, from);
        foul = heap.anchor().phase == AnchorPhase::fouled;
        EXPECT_EQ(foul, heap.anchor().fouled > 0) << way;
        if (!foul) continue;
        EXPECT_GT(heap.count("anchor.fouled"), 0);
        EXPECT_LT(heap.anchor().embedment, 0.5);        // comes home crown first
        EXPECT_LT(heap.anchor().holding_capacity, 1e5); // it only slides: sound it holds 340 kN

        Drill laid_out = paid_out(false, kCable, from);
        set_about(laid_out, from);
        EXPECT_EQ(laid_out.count("anchor.fouled"), 0);
        EXPECT_EQ(laid_out.anchor().fouled, 0);
        EXPECT_GE(laid_out.anchor().embedment, 0.5); // holds
    }
    EXPECT_TRUE(foul);
}

TEST(FoulAnchor, CableLaidOutWithSternwayStaysClear) {
    for (int eighth = 0; eighth < 8; ++eighth) {
        const double towards = eighth * kTurn / 8;
        Drill drill = paid_out(false, 165, towards);
        set_off(drill, towards);
        EXPECT_EQ(drill.anchor().phase == AnchorPhase::fouled, false) << eighth;
        EXPECT_EQ(drill.anchor().fouled, 0) << eighth;
        EXPECT_GE(drill.anchor().embedment, 0.5) << eighth; // holds
    }
}

namespace {

/// The anchor dug in in 100 m and an old cable hooked on its flukes; hove in at full lever.
Drill heaving_foul() {
    ExerciseDef def = quiet_def(100, 100);
    def.environment.current_speed = 1; // sets her back on her cable
    def.environment.current_towards = 0.5 * kTurn;
    def.ship_start.surge = -0.5;
    Drill drill(def);
    drill.fault(FaultCode::anchor_fouled);
    drill.brake(0);
    EXPECT_TRUE(drill.run_until([&] { return drill.chain().cable_out > 115; }, 60));
    for (double brake = 0.1; drill.chain().cable_out < 270 && drill.now().time < 900; drill.run(0.1)) {
        brake =
            std::clamp(brake + 0.002 * (drill.windlass().cable_speed - 0.7), 0.0, 1.0); // at her own speed
        drill.brake(brake);
    }
    drill.brake(1);
    // Hooked: more than any soil gives.
    EXPECT_TRUE(drill.run_until([&] { return drill.anchor().holding_capacity > 1e6; }, 600));
    drill.current(0, 0); // fetched up, she comes ahead on her cable
    EXPECT_TRUE(drill.run_until([&] { return drill.now().ship.surge > 0.1; }, 600));
    drill.clutch(true);
    EXPECT_TRUE(drill.run_until([&] { return drill.windlass().clutch == ClutchState::in; }, 60));
    drill.brake(0);
    drill.speed_lever(1);
    return drill;
}

} // namespace

// Fouled and heavy: stopper, brake, declutch at once before anything else; a shaft that had had its knocks
// gave way, three shackles ran, shaft and claw coupling were replaced (MARS 201410). Hung off, and the old
// cable slipped, the same shaft brings the anchor home.
TEST(FoulAnchor, HeavingOnShearsTheShaftAndHangingOffClearsTheAnchor) {
    for (const bool hung_off : {false, true}) {
        Drill drill = heaving_foul();
        // Aweigh, and the load grows with every metre.
        ASSERT_TRUE(drill.run_until([&] { return drill.anchor().height_above_bottom > 5; }, 2500));
        EXPECT_EQ(drill.anchor().phase, AnchorPhase::fouled);
        EXPECT_GT(drill.count("anchor.fouled"), 0);
        drill.fault(FaultCode::clutch_shaft_damaged, 0.8); // 400 kN are left
        if (hung_off) {
            drill.speed_lever(0);
            drill.brake(1);
            drill.run(5);
            drill.clutch(false);
            drill.run(2);
            drill.stopper(true);
            drill.run(10);
            drill.clear(FaultCode::anchor_fouled); // slipped
            drill.run(5);
            EXPECT_EQ(drill.anchor().phase, AnchorPhase::aweigh);
            EXPECT_EQ(drill.anchor().carried, 0);
            drill.clutch(true);
            ASSERT_TRUE(drill.run_until([&] { return drill.windlass().clutch == ClutchState::in; }, 60));
            drill.stopper(false);
            drill.brake(0);
            drill.run(5); // not against a brake that is still on
            drill.speed_lever(1);
        }
        const double out = drill.chain().cable_out;
        drill.run_until([&] { return drill.chain().cable_out < 8 || drill.count("clutch.sheared") > 0; },
                        900);
        drill.run(15);
        EXPECT_EQ(drill.count("clutch.sheared") > 0, !hung_off);
        EXPECT_EQ(drill.chain().cable_out < 8, hung_off);
        EXPECT_EQ(drill.chain().cable_out > out + 27.5, !hung_off) << drill.chain().cable_out; // it ran
    }
}

namespace {

/// rad, between the anchor's shank and the bearing of the hawse pipe from it.
double off_the_shank(const Drill& drill) {
    const physics::Vec3 shank = drill.anchor().attitude * physics::Vec3::UnitX();
    const physics::Vec3 lead = drill.chain().nodes.front().cast<double>() - drill.anchor().shackle;
    return std::abs(std::atan2(shank.cross(lead).z(), shank.dot(lead)));
}

/// Six shackles laid out, the anchor dug in and then caught on something that holds more than any soil; and a
/// slack tide athwart, on which she drifts past until her cable leads off across the shank.
Drill athwart_of_caught_anchor() {
    Drill drill = paid_out(false, 165, 0);
    set_off(drill, 0);
    drill.run(600);
    drill.fault(FaultCode::anchor_fouled);
    drill.run(300);
    drill.current(0.4, 0.25 * kTurn);
    drill.run(700);
    EXPECT_GT(drill.anchor().holding_capacity, 1e6);
    EXPECT_EQ(drill.anchor().bent, 0);
    EXPECT_GT(off_the_shank(drill), 0.2 * kTurn);
    return drill;
}

} // namespace

// An anchor fast in rock or under a cable is not torn out by the engine: she gathers way on her slack cable,
// fetches up across the shank and bends it. Left to come into her cable on the tide, the anchor turns to the
// pull and stays whole.
TEST(BentAnchor, BendsWhenTornAtAthwartAndNotWhenSheComesIntoHerCableSlowly) {
    for (const bool torn : {true, false}) {
        Drill drill = athwart_of_caught_anchor();
        drill.engine(torn ? -1 : 0);
        drill.run(torn ? 300 : 1600);
        EXPECT_LT(off_the_shank(drill), 0.2 * kTurn);
        EXPECT_EQ(drill.anchor().bent > 0, torn) << drill.anchor().bent;
    }
}

} // namespace windlass::exercise
