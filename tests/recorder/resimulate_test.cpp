// A recorded run gone through again: the same bits, or a place and a name where they are not.

#include "recorder/resimulate/resimulation.hpp"

#include "tests/recorder/folder.hpp"
#include "tests/recorder/taped_session.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace windlass::test {
namespace {

using exercise::Order;
using exercise::WindlassOrder;
using recorder::Agreement;
using recorder::Gap;
using recorder::Resimulation;
using recorder::runs_of;
using recording::Recording;
using run::RunAction;
using testing::HasSubstr;

constexpr double kEnd = std::numeric_limits<double>::infinity();
constexpr int kSecond = 300; // ticks

Order levers(double brake, double speed = 0, bool clutch_in = false) {
    return WindlassOrder{.brake = brake, .speed_lever = speed, .clutch_in = clutch_in};
}

/// Lets go, checks her, with faults, weather, reports and a pause; 25 s. Orders come at odd ticks, and
/// several at one.
void let_go(TapedSession& taped) {
    taped.run(37);
    taped.give(levers(0));
    taped.run(7 * kSecond); // nobody is heard: the server works the speed lever
    exercise::FaultOrder fault;
    fault.code = exercise::FaultCode::brake_lining_faded;
    fault.severity = 1.0 / 3;
    fault.ramp = 2;
    fault.trigger = exercise::FaultTrigger::at_cable_out;
    fault.trigger_value = 20;
    taped.give(Order{fault}, "instructor");
    taped.give(levers(0.4));
    taped.run(7 * kSecond + 11);
    taped.give(levers(0.9));
    taped.give(RunAction::pause);
    taped.run(60);
    exercise::EnvironmentOrder squall;
    squall.weather.wind_speed = 14;
    squall.weather.wind_from = 0.5;
    squall.weather.veering = 0.01;
    squall.weather.current_speed = 0.7;
    squall.weather.current_towards = 3;
    squall.weather.current_profile = {{0, 1, 0}, {15, 1.0 / 3, 0.25}};
    squall.ramp = 5;
    taped.give(Order{squall}, "instructor");
    exercise::ReportMade report;
    report.code = exercise::ReportCode::lead;
    report.side = 0;
    report.lead = 12;
    report.text = "ahead";
    taped.give(Order{report});
    taped.give(RunAction::start);
    taped.run(7 * kSecond);
    taped.give(Order{exercise::HelmOrder{.engine = -0.3, .rudder = 0.1}});
    taped.give(levers(0.7, 0.5, true));
    taped.run(7 * kSecond);
}

Agreement gone_through(const std::filesystem::path& folder) {
    Recording recording({folder});
    const auto runs = runs_of(recording);
    return Resimulation(recording, runs.at(0), *runs.at(0).first_checkpoint()).compare(kEnd);
}

std::string gap_in(const std::filesystem::path& folder) {
    try {
        gone_through(folder);
    } catch (const Gap& gap) {
        return gap.what();
    }
    return "none";
}

TEST(Resimulate, AForeignShipIsTheSameBitForBit) {
    const Folder folder;
    TapedSession taped(folder / "r");
    taped.give(RunAction::start);
    exercise::OwnShipSample ship;
    for (int n = 0; n < 60; ++n) { // 3 s, then silence until she lies still
        const auto& seen = taped.session().snapshot().ship;
        if (n == 0) ship = {seen.position, seen.attitude, seen.velocity, physics::Vec3::Zero(), 1e9};
        taped.give(Order{ship}, "bridge");
        taped.run(kSecond / 20);
        ship.position += 0.05 * ship.velocity;
        ship.position.z() = 0.1 * std::sin(0.05 * n);
        ship.time += 0.05;
    }
    taped.run(5 * kSecond);
    taped.give(Order{exercise::HelmOrder{.engine = -0.5}});
    taped.run(3 * kSecond);
    taped.close();
    const Agreement found = gone_through(folder / "r");
    EXPECT_FALSE(found.parting) << found.parting->text();
    EXPECT_GT(found.orders, 60U);
}

TEST(Resimulate, LetGoWithOrdersFaultsWeatherAndALostHandIsTheSameBitForBit) {
    const Folder folder;
    TapedSession taped(folder / "r");
    let_go(taped);
    taped.close();
    const Agreement found = gone_through(folder / "r");
    EXPECT_FALSE(found.parting) << found.parting->text();
    EXPECT_EQ(found.orders, 12U); // four of them the server's own
    EXPECT_EQ(found.checkpoints, 3U);
    EXPECT_GT(found.hashes, 300U);
    EXPECT_EQ(found.to_tick, taped.session().snapshot().tick / 20 * 20);
}

TEST(Resimulate, BeginsAtAnyCheckpoint) {
    const Folder folder;
    TapedSession taped(folder / "r");
    let_go(taped);
    taped.close();
    Recording recording({folder / "r"});
    const auto runs = runs_of(recording);
    ASSERT_EQ(runs.size(), 1U);
    EXPECT_EQ(runs[0].checkpoint_before(9.99)->tick, 0U);
    EXPECT_EQ(runs[0].checkpoint_before(10)->tick, 3000U);
    const auto found = Resimulation(recording, runs[0], *runs[0].checkpoint_before(20)).compare(kEnd);
    EXPECT_FALSE(found.parting) << found.parting->text();
    EXPECT_EQ(found.from_tick, 6000U);
    EXPECT_EQ(found.checkpoints, 1U);
}

TEST(Resimulate, WhatAReplayShowsAtAPositionIsARunAndATimeOfIt) {
    const Folder folder;
    TapedSession taped(folder / "r");
    taped.give(levers(0));
    taped.run(11 * kSecond);
    taped.give(RunAction::restore, 10);
    taped.give(RunAction::start);
    taped.run(kSecond);
    taped.give(RunAction::reset);
    taped.give(RunAction::start);
    taped.run(2 * kSecond);
    taped.close();
    Recording recording({folder / "r"});
    const auto runs = runs_of(recording);
    ASSERT_EQ(runs.size(), 3U);
    const auto shows = [&](double position, std::size_t run, double time) {
        const recorder::Moment shown = recorder::shown_at(recording, runs, position);
        EXPECT_EQ(shown.run, &runs[run]) << "at " << position;
        EXPECT_NEAR(shown.time, time, 0.15)
            << "at " << position; // two of the states that are told, 20 beats apart
        EXPECT_NO_THROW(Resimulation(recording, *shown.run, *shown.run->checkpoint_before(shown.time))
                            .state_at(shown.time));
    };
    shows(5, 0, 5);
    shows(10.9, 0, 10.9);
    shows(11.5, 1, 10.5);
    shows(13, 2, 1);
    shows(100, 2, 2); // its end
    EXPECT_THROW(recorder::shown_at(recording, runs, -1), std::runtime_error);
}

TEST(Resimulate, EachLoadResetAndRestoreIsARunOfItsOwn) {
    const Folder folder;
    TapedSession taped(folder / "r");
    taped.give(levers(0));
    taped.run(11 * kSecond);
    taped.give(RunAction::restore, 10);
    taped.give(RunAction::start);
    taped.give(levers(1), "another");
    taped.run(kSecond);
    taped.give(RunAction::reset);
    taped.give(RunAction::start);
    taped.give(levers(0.2));
    taped.run(2 * kSecond);
    taped.close();
    Recording recording({folder / "r"});
    const auto runs = runs_of(recording);
    ASSERT_EQ(runs.size(), 3U);
    EXPECT_EQ(runs[1].first_checkpoint()->tick, 3000U);
    EXPECT_EQ(runs[2].number, runs[0].number + 2);
    for (const recorder::Run& run : runs) {
        const auto found = Resimulation(recording, run, *run.first_checkpoint()).compare(kEnd);
        EXPECT_FALSE(found.parting) << found.parting->text();
        EXPECT_GT(found.hashes, 10U);
    }
    EXPECT_EQ(&recorder::find_run(runs, 0, 1), &runs[2]) << "the last that has it";
    EXPECT_EQ(&recorder::find_run(runs, 1, 1), &runs[0]);
    EXPECT_EQ(&recorder::find_run(runs, 0, 10.5), &runs[1]);
    try {
        recorder::find_run(runs, 0, 12);
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(),
                     "12 s of exercise is not in the recording, which has run 1 from 0:00.000 to "
                     "0:11.000, run 2 from 0:10.000 to 0:11.000, run 3 from 0:00.000 to 0:02.000");
    }
}

TEST(Resimulate, AnotherOrderThanTheOneTakenIsCaughtWithItsTickAndField) {
    const Folder folder;
    TapedSession taped(folder / "r");
    taped.orders = [](OrderTaken& order) {
        if (order.number() == 2) order.windlass().brake(std::nextafter(order.windlass().brake(), 1));
        return true;
    };
    taped.give(levers(0));
    taped.run(70);
    taped.give(levers(0.4)); // in the last bit another one on the tape
    taped.give(RunAction::snapshot);
    taped.run(kSecond);
    taped.close();
    const auto found = gone_through(folder / "r");
    ASSERT_TRUE(found.parting);
    EXPECT_EQ(found.parting->tick, 70U);
    EXPECT_EQ(found.parting->agreed_tick, 60U);
    EXPECT_EQ(found.parting->text(),
              "the state at tick 70 is not the recorded one; at tick 60 it still was\n"
              "  tick 70: port.levers.brake was 0.40000000000000002, and is 0.40000000000000008");
}

TEST(Resimulate, AStateThatDidNotComeOfTheOrdersIsCaughtWithItsField) {
    const Folder folder;
    TapedSession taped(folder / "r");
    taped.checkpoints = [](Checkpoint& checkpoint) {
        if (checkpoint.tick() != 3000) return true;
        auto changed = exercise::read_checkpoint(checkpoint.data());
        changed.apply(exercise::HelmOrder{.rudder = 0.25});
        checkpoint.data(exercise::write_checkpoint(changed)); // whole, with a hash that is true of it
        exercise::Snapshot seen;
        changed.view(seen);
        checkpoint.state_hash(seen.state_hash);
        return true;
    };
    taped.run(11 * kSecond);
    taped.close();
    const auto found = gone_through(folder / "r");
    ASSERT_TRUE(found.parting);
    EXPECT_EQ(found.parting->tick, 3000U);
    ASSERT_EQ(found.parting->fields.size(), 1U);
    EXPECT_EQ(found.parting->fields[0].field, "helm.rudder");
    EXPECT_EQ(found.parting->fields[0].first, "0.25");
}

TEST(Resimulate, AHashThatWasChangedIsNamedAsSuch) {
    const Folder folder;
    TapedSession taped(folder / "r");
    taped.truths = [](ExerciseTruth& truth) {
        if (truth.tick() == 600) truth.state_hash(truth.state_hash() ^ 1U);
        return true;
    };
    taped.run(11 * kSecond);
    taped.close();
    const auto found = gone_through(folder / "r");
    ASSERT_TRUE(found.parting);
    EXPECT_EQ(found.parting->tick, 600U);
    ASSERT_EQ(found.parting->fields.size(), 1U);
    EXPECT_EQ(found.parting->fields[0].field, "ExerciseTruth.state_hash");
}

TEST(Resimulate, LostOrdersAndDamagedCheckpointsAreToldNotGuessed) {
    const Folder folder;
    {
        TapedSession taped(folder / "lost");
        taped.orders = [](OrderTaken& order) { return order.number() != 2; };
        taped.give(levers(0));
        taped.run(70);
        taped.give(levers(0)); // changes nothing, and is missing all the same
        taped.run(30);
        taped.give(levers(0.5));
        taped.run(kSecond);
        taped.close();
    }
    EXPECT_EQ(gap_in(folder / "lost"),
              "order 2 is not in the recording; behind tick 80 it cannot be gone through again");
    {
        TapedSession taped(folder / "damaged");
        taped.checkpoints = [](Checkpoint& checkpoint) {
            checkpoint.data()[checkpoint.data().size() / 2] ^= 1U;
            return true;
        };
        taped.run(kSecond);
        taped.close();
    }
    EXPECT_THAT(gap_in(folder / "damaged"), HasSubstr("the checkpoint at 0.00 s: a checkpoint "));
}

TEST(Resimulate, GivesTheStateOfAnyInstantAsItWas) {
    const Folder folder;
    TapedSession taped(folder / "r");
    taped.give(levers(0));
    taped.run(4 * kSecond + 7); // no hash and no checkpoint is of this tick
    taped.session().carry_out({}, 0);
    const auto then = taped.session().snapshot();
    taped.give(levers(1));
    taped.run(8 * kSecond);
    taped.close();

    Recording recording({folder / "r"});
    const auto runs = runs_of(recording);
    const recorder::Run& run = recorder::find_run(runs, 0, then.time);
    const auto bytes = Resimulation(recording, run, *run.checkpoint_before(then.time)).state_at(then.time);
    auto state = exercise::read_checkpoint(bytes);
    exercise::Snapshot seen;
    state.view(seen);
    EXPECT_EQ(seen.tick, then.tick);
    EXPECT_EQ(seen.state_hash, then.state_hash);
}

TEST(Resimulate, GivesNoStateThatTheRecordingContradicts) {
    const Folder folder;
    TapedSession taped(folder / "r");
    taped.orders = [](OrderTaken& order) {
        order.windlass().brake(0.9);
        return true;
    };
    taped.give(levers(0));
    taped.run(11 * kSecond);
    taped.close();
    Recording recording({folder / "r"});
    const auto runs = runs_of(recording);
    // Before the first hash that differs, too: the next one behind the instant is looked at.
    for (const double time : {0.01, 5.0}) {
        try {
            Resimulation(recording, runs[0], *runs[0].first_checkpoint()).state_at(time);
            FAIL() << time;
        } catch (const Gap& gap) {
            EXPECT_THAT(gap.what(), HasSubstr("at tick 20 is not the recorded one"));
        }
    }
}

} // namespace
} // namespace windlass::test
