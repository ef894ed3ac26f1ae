// Published loads can be explained from one another, whatever holds the cable.

#include "rigs/drill.hpp"

#include <gtest/gtest.h>

namespace windlass::exercise {

using namespace rigs;

namespace {

/// N, what the machinery on deck bears of the gypsy's load.
double borne(const WindlassView& w) {
    return w.brake_load + w.stopper_load + w.motor_load + w.bitter_end_load + w.spurling_pipe_load +
           w.locker_load;
}

} // namespace

TEST(Outputs, AtRestTheGypsysLoadIsThatOfBrakeStopperAndMotorsBrake) {
    enum class Holder { brake, stopper, shaft_brake };
    for (const Holder holder : {Holder::brake, Holder::stopper, Holder::shaft_brake}) {
        Drill drill(quiet_def(60, 40));
        drill.run(1);
        if (holder == Holder::stopper) drill.stopper(true);
        if (holder == Holder::shaft_brake) drill.clutch(true);
        drill.run(10);
        if (holder != Holder::brake) drill.brake(0);
        drill.run(30);
        const WindlassView& w = drill.windlass();
        ASSERT_EQ(w.cable_speed, 0);
        EXPECT_NEAR(borne(w) / w.gypsy_load, 1, 1e-9) << static_cast<int>(holder); // rounding
        EXPECT_EQ(w.brake_load > 0, holder == Holder::brake);
        EXPECT_EQ(w.stopper_load > 0, holder == Holder::stopper);
        EXPECT_EQ(w.shaft_brake_load > 0, holder == Holder::shaft_brake);
    }
}

TEST(Outputs, AtRestOnAJamTheGypsysLoadIsThatOfTheJam) {
    Drill drill(quiet_def(60, 40));
    drill.run(1);
    drill.fault(FaultCode::spurling_pipe_jammed);
    drill.brake(0);
    drill.run(60);
    const WindlassView& w = drill.windlass();
    EXPECT_NEAR(w.cable_speed, 0, 1e-9); // held by a spring alone
    EXPECT_GT(w.spurling_pipe_load, 5e4);
    EXPECT_NEAR(borne(w) / w.gypsy_load, 1, 1e-6);
}

TEST(Outputs, HangingCableWeighsWhatAnchorAndChainWeigh) {
    Drill drill(quiet_def(60, 40));
    drill.run(60);
    const physics::ChainDef& chain = drill.exercise().def().tackle[0].chain;
    const auto& nodes = drill.chain().nodes;
    double weight = drill.anchor().weight + drill.anchor().carried;
    for (std::size_t i = 1; i < nodes.size(); ++i) {
        const bool in_air = 0.5f * (nodes[i - 1].z() + nodes[i].z()) > 0;
        weight += (nodes[i] - nodes[i - 1]).norm() *
                  (in_air ? physics::weight_in_air(chain)
                          : physics::weight_in_water(chain, physics::kSeaWaterDensity));
    }
    EXPECT_NEAR(drill.windlass().hawse_tension / weight, 1, 0.01); // the link across the surface
}

TEST(Outputs, EachMarkIsCalledOnceAsItComesIn) {
    Drill drill(quiet_def(100, 70));
    drill.run(1);
    drill.clutch(true);
    ASSERT_TRUE(drill.run_until([&] { return drill.windlass().clutch == ClutchState::in; }, 60));
    drill.brake(0);
    drill.speed_lever(1);
    ASSERT_TRUE(drill.run_until([&] { return drill.chain().cable_out < 15; }, 600));
    std::vector<double> called;
    for (const ExerciseEvent& event : drill.log())
        if (event.code == "cable.shackle") called.push_back(event.value);
    EXPECT_EQ(called, (std::vector<double>{2, 1}));
    // By then it lies on deck, between lip and windlass; the counter shows less than that many shackles.
    EXPECT_EQ(drill.first("cable.shackle")->text, "2 shackles on deck, heaving");
}

TEST(Outputs, EachMarkIsCalledInThePipeAsItGoesOut) {
    Drill drill(quiet_def(100, 25));
    drill.run(1);
    drill.brake(0);
    ASSERT_TRUE(drill.run_until_event("cable.shackle", 10));
    EXPECT_EQ(drill.first("cable.shackle")->text, "1 shackle in the pipe");
    EXPECT_NEAR(drill.chain().cable_out, physics::kShackleLength, 0.2); // a tick of running cable
}

} // namespace windlass::exercise
