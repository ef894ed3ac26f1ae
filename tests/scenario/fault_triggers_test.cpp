// When a fault comes, how fast it grows, which of several parts it is; and the one table of faults.

#include "server/exercise/checkpoint.hpp"
#include "server/exercise/faults/faults.hpp"

#include "rigs/drill.hpp"
#include "words/words.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace windlass::exercise {
using namespace rigs;

namespace {

/// Heaving at full lever from so many metres (m), brake off, a harmless fault armed.
Drill heaving_from(double cable_out) {
    Drill drill(quiet_def(60, cable_out));
    drill.run(1);
    drill.clutch(true);
    drill.brake(0);
    drill.run(3);
    drill.speed_lever(1);
    return drill;
}

FaultOrder dead_cell(FaultTrigger trigger, double value = 0) {
    return {.code = FaultCode::load_cell_dead, .trigger = trigger, .trigger_value = value};
}

const FaultView& fault(const Drill& drill, std::size_t place = 0) {
    return drill.now().faults.at(place);
}

TEST(FaultRamp, GrowsInAStraightLineFromTheMomentThatItIsActive) {
    Drill drill(quiet_def(60, 25)), steady(quiet_def(60, 25));
    drill.run(1);
    steady.fault(FaultCode::brake_lining_faded, 0.2);
    steady.run(1);
    drill.give(FaultOrder{.code = FaultCode::brake_lining_faded, .severity = 0.8, .ramp = 10});
    drill.run(2.5);
    EXPECT_EQ(fault(drill).phase, FaultPhase::active);
    EXPECT_NEAR(fault(drill).severity_now, 0.2, 1e-9);
    EXPECT_NEAR(drill.windlass().brake_capacity / steady.windlass().brake_capacity, 1, 1e-6);
    drill.run(10);
    EXPECT_EQ(fault(drill).severity_now, 0.8);
    drill.clear(FaultCode::brake_lining_faded);
    drill.tick();
    EXPECT_EQ(fault(drill).severity_now, 0);
}

TEST(FaultRamp, OneThatIsThereGrowsOnFromWhereItIs) {
    Drill drill(quiet_def(60, 25));
    drill.give(FaultOrder{.code = FaultCode::brake_lining_faded, .severity = 0.4});
    drill.run(1);
    drill.give(FaultOrder{.code = FaultCode::brake_lining_faded, .severity = 0.8, .ramp = 10});
    drill.run(5);
    EXPECT_NEAR(fault(drill).severity_now, 0.6, 1e-9);
}

TEST(Triggers, AtMostComesWhileHeavingAndNotAtOnce) {
    Drill drill = heaving_from(40);
    drill.give(dead_cell(FaultTrigger::at_cable_out_at_most, 38));
    drill.give(FaultOrder{.code = FaultCode::brake_wet, // below it from the start: nothing comes down to it
                          .trigger = FaultTrigger::at_cable_out_at_most,
                          .trigger_value = 100});
    ASSERT_TRUE(drill.run_until_event("fault.active", 60));
    EXPECT_NEAR(drill.chain().cable_out, 38, 0.01);
    drill.run(3);
    EXPECT_EQ(drill.count("fault.active"), 1);
}

TEST(Triggers, AtMostLoadComesWhenTheLoadHasBeenAbove) {
    Drill drill(quiet_def(60, 25));
    drill.run(2);
    drill.give(dead_cell(FaultTrigger::at_load_at_most, 1.2e5)); // hanging it is 85 kN
    drill.run(2);
    EXPECT_EQ(drill.count("fault.active"), 0);
    drill.clutch(true);
    drill.brake(0);
    drill.run(3);
    drill.speed_lever(1); // some 160 kN
    drill.run(3);
    EXPECT_EQ(drill.count("fault.active"), 0);
    drill.speed_lever(-1); // the pipe's friction now bears a part of it
    EXPECT_TRUE(drill.run_until_event("fault.active", 10));
    EXPECT_LE(drill.windlass().gypsy_load, 1.2e5);
}

TEST(Triggers, AtEventComesWithItAndFaultsFollowEachOther) {
    Drill drill(quiet_def(60, 25));
    FaultOrder follows = dead_cell(FaultTrigger::at_event);
    follows.trigger_event = "fault.active";
    drill.give(follows);
    drill.run(1);
    EXPECT_EQ(drill.count("fault.active"), 0); // its own arming is none
    FaultOrder first{.code = FaultCode::brake_wet, .severity = 0.1, .trigger = FaultTrigger::at_event};
    first.trigger_event = "anchor.let_go";
    drill.give(first);
    drill.brake(0);
    ASSERT_TRUE(drill.run_until_event("anchor.let_go", 10));
    EXPECT_EQ(drill.count("fault.active"), 2); // in the same tick
}

/// All that the sources of server/exercise say.
std::string sources_of_the_exercise() {
    std::string text;
    for (const auto& file : std::filesystem::recursive_directory_iterator(
             std::filesystem::path(WINDLASS_CONFIG_DIR) / "../server/exercise")) {
        if (!file.is_regular_file()) continue;
        std::ostringstream all;
        all << std::ifstream(file.path()).rdbuf();
        text += all.str();
    }
    return text;
}

TEST(Triggers, EveryEventThatMayBeWaitedForIsCalledByTheExerciseAndComes) {
    const std::string sources = sources_of_the_exercise();
    for (const std::string_view code : words::kEventNames) {
        SCOPED_TRACE(code);
        EXPECT_NE(sources.find('"' + std::string(code) + '"'), std::string::npos);
        const auto event = [](const std::string& of) {
            ExerciseEvent called;
            called.time = 2;
            called.code = of;
            return called;
        };
        FaultBook book;
        const EventLog log([](const words::Event&, int, double, const std::string&) {});
        FaultOrder waits = dead_cell(FaultTrigger::at_event);
        waits.trigger_event = code;
        book.order(waits, 1, log);
        book.watch(Side::port, {.time = 2}, {event("another.code")}, log);
        EXPECT_EQ(book.list().front().phase, FaultPhase::armed);
        book.watch(Side::port, {.time = 2}, {event(std::string(code))}, log);
        EXPECT_EQ(book.list().front().phase, FaultPhase::active);
    }
}

TEST(Triggers, AtOrderComesWithTheBridgesOrderForThatSide) {
    Drill drill(quiet_def(60, 25));
    FaultOrder order = dead_cell(FaultTrigger::at_order);
    order.trigger_order = BridgeOrderCode::let_go;
    drill.give(order);
    drill.give(BridgeOrderGiven{.code = BridgeOrderCode::heave, .side = 0});
    drill.give(BridgeOrderGiven{.code = BridgeOrderCode::let_go, .side = 1});
    drill.run(1);
    EXPECT_EQ(drill.count("fault.active"), 0);
    drill.give(BridgeOrderGiven{.code = BridgeOrderCode::let_go, .side = -1});
    drill.tick();
    EXPECT_EQ(drill.count("fault.active"), 1);
}

TEST(Triggers, AtChanceComesAtTheMomentDrawnFromItsWindow) {
    Drill drill(quiet_def(60, 25));
    const auto armed = [&](FaultCode code, double from, double until) {
        drill.give(FaultOrder{.code = code,
                              .severity = 0.1,
                              .trigger = FaultTrigger::at_chance,
                              .trigger_value = from,
                              .trigger_until = until});
    };
    armed(FaultCode::load_cell_dead, 2, 6);
    drill.give(ChanceDrawn{0.25});
    armed(FaultCode::brake_wet, 10, 20);
    drill.give(ChanceDrawn{0.5});
    drill.give(ChanceDrawn{0}); // nobody waits for it
    ASSERT_TRUE(drill.run_until_event("fault.active", 30));
    EXPECT_NEAR(drill.now().time, 3, 0.004);
    ASSERT_TRUE(drill.run_until_event("fault.active", 30));
    EXPECT_NEAR(drill.now().time, 15, 0.004);
}

TEST(Triggers, AllThatTheyRememberIsInACheckpoint) {
    Drill drill = heaving_from(40);
    drill.give(dead_cell(FaultTrigger::at_cable_out_at_most, 37));
    drill.give(FaultOrder{.code = FaultCode::brake_wet, .severity = 0.2, .ramp = 20});
    drill.give(FaultOrder{.code = FaultCode::clutch_jumps_out,
                          .severity = 0.1,
                          .trigger = FaultTrigger::at_chance,
                          .trigger_value = 6,
                          .trigger_until = 8});
    drill.give(ChanceDrawn{0.5});
    drill.run(1);
    Exercise& live = drill.exercise();
    Exercise read = read_checkpoint(write_checkpoint(live));
    for (int k = 0; k < 5000; ++k) {
        live.step(1.0 / live.def().tick_rate_hz);
        read.step(1.0 / read.def().tick_rate_hz);
    }
    EXPECT_TRUE(differences(live, read).empty());
    Snapshot end;
    read.view(end);
    for (const FaultView& view : end.faults)
        EXPECT_EQ(view.phase, FaultPhase::active) << words::row_of(view.order.code).name;
}

TEST(Triggers, OneThatLastsForAWhileClearsItself) {
    Drill drill(quiet_def(60, 25));
    drill.give(FaultOrder{.code = FaultCode::motor_power_lost,
                          .lasts = 5,
                          .trigger = FaultTrigger::at_time,
                          .trigger_value = 2});
    drill.run(4);
    EXPECT_EQ(fault(drill).phase, FaultPhase::active);
    EXPECT_FALSE(drill.windlass().power);
    ASSERT_TRUE(drill.run_until_event("fault.cleared", 10));
    EXPECT_NEAR(drill.now().time, 7, 0.01);
    drill.tick();
    EXPECT_TRUE(drill.windlass().power);
}

TEST(Triggers, MomentInAWindowOfTheFileIsTheSeedsAndInTheWindow) {
    ExerciseDef def = quiet_def(60, 25);
    def.faults = {{.code = FaultCode::load_cell_dead,
                   .trigger = FaultTrigger::at_chance,
                   .trigger_value = 1,
                   .trigger_until = 3}};
    const auto moment = [&](int seed) {
        def.chance_seed = seed;
        Drill drill(def);
        EXPECT_TRUE(drill.run_until_event("fault.active", 4));
        return drill.now().time;
    };
    std::set<double> moments;
    for (int seed = 0; seed < 5; ++seed) {
        moments.insert(moment(seed));
        EXPECT_GE(*moments.begin(), 1);
        EXPECT_LE(*moments.rbegin(), 3 + 0.004); // a tick
    }
    EXPECT_EQ(moments.size(), 5U);
    EXPECT_EQ(moment(2), moment(2));
}

TEST(FaultTarget, JoiningShackleThatIsNamedIsTheOneThatOpens) {
    // Hanging in deep water over a hundred metres: the first joining shackle bears less than the last.
    const auto parts_at = [](int target) {
        Drill drill(quiet_def(200, 120));
        drill.run(1);
        drill.give(FaultOrder{.code = FaultCode::joining_shackle_open, .severity = 0.99, .target = target});
        EXPECT_TRUE(drill.run_until_event("cable.parted", 5)) << target;
        return drill.first("cable.parted")->text;
    };
    EXPECT_NE(parts_at(1).find("parted 2"), std::string::npos) << parts_at(1); // 27.5 m from the anchor
    EXPECT_NE(parts_at(3).find("parted 8"), std::string::npos) << parts_at(3); // 82.5 m
    EXPECT_NE(parts_at(0).find("parted 1"), std::string::npos) << parts_at(0); // 110 m
}

TEST(FaultTarget, WeakLinkIsTheMiddleOneOfTheLengthThatIsNamed) {
    Drill drill(quiet_def(200, 120));
    drill.run(1);
    drill.give(FaultOrder{.code = FaultCode::chain_link_weak, .severity = 0.99, .target = 2});
    ASSERT_TRUE(drill.run_until_event("cable.parted", 5));
    EXPECT_NE(drill.first("cable.parted")->text.find("parted 4"), std::string::npos) // 41 m from the anchor
        << drill.first("cable.parted")->text;
}

TEST(Faults, BiasedLoadCellShowsTooMuch) {
    Drill drill(quiet_def(60, 25));
    drill.give(FaultOrder{.code = FaultCode::load_cell_bias, .severity = 0.3});
    drill.run(1);
    EXPECT_NEAR(drill.windlass().gypsy_load_indicated / drill.windlass().gypsy_load, 1.3, 1e-12);
}

TEST(FaultTable, EveryFaultHasEveryTextAndCanBeNoticed) {
    for (int k = 0; k < kFaultCodes; ++k) {
        const words::Fault& row = words::row_of(static_cast<FaultCode>(k));
        EXPECT_TRUE(row.forecastle || row.bridge) << row.name; // else nobody could learn anything from it
        EXPECT_EQ(physics::kFaultCauses[static_cast<std::size_t>(k)].target != nullptr, !row.targets.empty())
            << row.name;
    }
    EXPECT_THROW(words::row_of(static_cast<FaultCode>(kFaultCodes)), std::out_of_range);
}

TEST(FaultTable, EveryFaultIsACauseOfItsOwnSideAndABlackoutOfBoth) {
    const EventLog log([](const words::Event&, int, double, const std::string&) {});
    for (const auto& [code, cause, target] : physics::kFaultCauses) {
        const words::Fault& row = words::row_of(code);
        FaultBook book;
        book.order({.code = code, .side = Side::starboard, .severity = 0.25, .target = 2}, 0, log);
        EXPECT_EQ(book.causes(Side::starboard).*cause, 0.25) << row.name;
        EXPECT_EQ(book.causes(Side::port).*cause, row.both_sides ? 0.25 : 0) << row.name;
        if (target == nullptr) continue;
        EXPECT_EQ(book.causes(Side::starboard).*target, 2) << row.name;
    }
}

} // namespace
} // namespace windlass::exercise
