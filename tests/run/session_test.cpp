// The run of an exercise: states, orders, log, and what happens when the simulation fails.

#include "server/exercise/picture/published.hpp"

#include "tests/run/session_rig.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <fstream>
#include <limits>

namespace windlass::run {
namespace {

using exercise::RunState;
using test::count;
using test::give;
using test::hear_nothing;
using test::levers;
using test::run_order;
using SessionTest = test::SessionTest;
using test::text_of;

/// Wind beyond every number: no model stays finite in it. Files cannot say this, but a fault of ours could.
exercise::ExerciseDef impossible() {
    exercise::ExerciseDef def;
    def.name = "impossible/wind";
    def.weather.wind_speed = std::numeric_limits<double>::infinity();
    return def;
}

TEST_F(SessionTest, RunsAtOnceUnlessToldToWait) {
    Session at_once({}, options());
    EXPECT_EQ(at_once.status().state, RunState::running);
    EXPECT_TRUE(at_once.tick());
    EXPECT_EQ(at_once.snapshot().tick, 1U);

    SessionOptions waiting = options();
    waiting.wait = true;
    Session later({}, waiting);
    EXPECT_EQ(later.status().state, RunState::ready);
    EXPECT_FALSE(later.tick());
    give(later, run_order(RunAction::start));
    EXPECT_TRUE(later.tick());
}

TEST_F(SessionTest, PausedExerciseStandsStillAndGoesOn) {
    Session session({}, options());
    session.tick();
    give(session, run_order(RunAction::pause));
    EXPECT_EQ(session.status().state, RunState::paused);
    EXPECT_FALSE(session.tick());
    EXPECT_EQ(session.snapshot().tick, 1U);
    give(session, run_order(RunAction::start));
    EXPECT_TRUE(session.tick());
    EXPECT_EQ(session.snapshot().tick, 2U);
}

TEST_F(SessionTest, FaultAndWeatherOrderedWhilePausedAreSeenAtOnce) {
    Session session({}, options());
    session.tick();
    give(session, run_order(RunAction::pause));
    give(session, exercise::Order{exercise::EnvironmentOrder{.weather = {.wind_speed = 17}}});
    give(session, exercise::Order{exercise::FaultOrder{.code = exercise::FaultCode::load_cell_dead}});
    EXPECT_EQ(session.snapshot().environment.now.wind_speed, 17);
    ASSERT_EQ(session.snapshot().faults.size(), 1U);
    EXPECT_EQ(session.snapshot().faults[0].phase, exercise::FaultPhase::active);
    EXPECT_EQ(session.snapshot().tick, 1U);
}

TEST_F(SessionTest, ResetGoesBackToTheSameStart) {
    Session session({}, options());
    const auto start = session.snapshot().state_hash;
    give(session, levers(0));
    for (int i = 0; i < 30; ++i)
        session.tick();
    ASSERT_NE(session.snapshot().state_hash, start);
    give(session, run_order(RunAction::reset));
    EXPECT_EQ(session.status().state, RunState::ready);
    EXPECT_EQ(session.snapshot().tick, 0U);
    EXPECT_EQ(session.snapshot().state_hash, start);
}

TEST_F(SessionTest, SameOrdersAtTheSameTicksGiveTheSameState) {
    const auto run = [&] {
        Session session({}, options());
        for (int i = 0; i < 300; ++i) {
            if (i == 20) give(session, levers(0));
            if (i == 200) give(session, levers(0.6));
            session.tick();
        }
        return session.snapshot().state_hash;
    };
    EXPECT_EQ(run(), run());
}

TEST_F(SessionTest, EndsAfterTheSetDuration) {
    SessionOptions short_run = options();
    short_run.duration = 0.5;
    Session session({}, short_run);
    int ticks = 0;
    while (session.tick())
        ++ticks;
    EXPECT_EQ(session.status().state, RunState::finished);
    EXPECT_TRUE(session.ended());
    EXPECT_EQ(session.snapshot().tick, 150U);
    EXPECT_EQ(count(session, "exercise.finished"), 1);
}

TEST_F(SessionTest, ExerciseThatCannotBeLoadedLeavesTheRunningOneAlone) {
    SessionOptions with_loader = options();
    with_loader.load = [](const std::string&) {
        std::promise<exercise::ExerciseDef> read;
        read.set_exception(
            std::make_exception_ptr(std::runtime_error("config/exercises/nonsense.json: no such file")));
        return Reading{read.get_future(), nullptr};
    };
    Session session({}, with_loader);
    session.tick();
    auto order = run_order(RunAction::load);
    order.exercise = "nonsense";
    give(session, order);
    EXPECT_TRUE(session.running());
    EXPECT_TRUE(session.tick());
    EXPECT_NE(text_of(session, "command.refused").find("no such file"), std::string::npos);
    EXPECT_EQ(session.status().commands_refused, 1U);
}

TEST_F(SessionTest, LoadedExerciseIsReadyAndTellsItsName) {
    SessionOptions with_loader = options();
    with_loader.load = [](const std::string& name) {
        exercise::ExerciseDef def;
        def.name = name;
        def.tick_rate_hz = 600;
        std::promise<exercise::ExerciseDef> read;
        read.set_value(def);
        return Reading{read.get_future(), nullptr};
    };
    Session session({}, with_loader);
    session.tick();
    auto order = run_order(RunAction::load);
    order.exercise = "deep";
    give(session, order);
    EXPECT_EQ(session.status().state, RunState::ready);
    EXPECT_EQ(session.status().exercise, "deep");
    EXPECT_EQ(session.dt(), 1.0 / 600);
    EXPECT_EQ(session.setups(), 2U);
}

/// A disk that takes its time.
class SessionWithSlowFiles : public test::SessionTest {
protected:
    SessionOptions with_slow_files() {
        SessionOptions slow = options();
        slow.load = [this](const std::string&) { return Reading{file_.get_future(), in_hand_}; };
        return slow;
    }
    static RunOrder load() {
        auto order = run_order(RunAction::load);
        order.exercise = "deep";
        return order;
    }
    void read() {
        exercise::ExerciseDef def;
        def.name = "deep";
        file_.set_value(def);
    }
    std::promise<exercise::ExerciseDef> file_;
    std::shared_ptr<std::atomic<bool>> in_hand_ = std::make_shared<std::atomic<bool>>(false);
};

TEST_F(SessionWithSlowFiles, ExerciseGoesOnWhileAFileIsReadAndOrdersBehindTheLoadWait) {
    Session session({}, with_slow_files());
    give(session, load(), 10);
    give(session, run_order(RunAction::start), 10.1); // for the exercise that is being read
    give(session, levers(0.25), 10.1);                // for the one that runs
    EXPECT_TRUE(session.tick());
    EXPECT_NE(session.status().exercise, "deep");
    EXPECT_EQ(session.orders().size(), 1U);
    read();
    session.carry_out({}, 10.2);
    EXPECT_EQ(session.status().exercise, "deep");
    EXPECT_TRUE(session.running());
    EXPECT_EQ(session.setups(), 2U);
    EXPECT_EQ(count(session, "command.refused"), 0);
}

TEST_F(SessionWithSlowFiles, FileThatIsNotReadInTimeIsRefusedAndOrdersGoOn) {
    Session session({}, with_slow_files());
    give(session, load(), 10);
    give(session, run_order(RunAction::pause), 10.1);
    session.carry_out({}, 10 + 0.9 * kReadingTime);
    EXPECT_TRUE(session.running());
    session.carry_out({}, 10 + 1.1 * kReadingTime);
    EXPECT_EQ(session.status().state, RunState::paused);
    EXPECT_EQ(
        text_of(session, "command.refused"),
        fmt::format(
            "ExerciseCommand from instructor: exercise = \"deep\" refused; allowed: a file that can be read "
            "within {:.0f} s",
            kReadingTime));
    read();
    session.carry_out({}, 20);
    EXPECT_EQ(session.setups(), 1U);
}

TEST_F(SessionWithSlowFiles, PreludeOfAFileThatHasBeenReadIsWaitedForHoweverSlowTheMachineAndIsTold) {
    Session session({}, with_slow_files());
    give(session, load(), 10);
    EXPECT_EQ(text_of(session, "exercise.reading"), "exercise \"deep\" is being read for instructor");
    *in_hand_ = true;
    session.carry_out({}, 10 + 100 * kReadingTime);
    EXPECT_EQ(count(session, "command.refused"), 0);
    read();
    session.carry_out({}, 10.1 + 100 * kReadingTime);
    EXPECT_EQ(session.status().exercise, "deep");
}

TEST_F(SessionTest, OrderThatDoesNotFitTheStateIsRefusedWithTheState) {
    Session session({}, options());
    give(session, run_order(RunAction::stop));
    give(session, run_order(RunAction::start));
    EXPECT_EQ(text_of(session, "command.refused"),
              "ExerciseCommand from instructor: action = START refused; "
              "allowed: the exercise is finished; load or reset it first");
    EXPECT_EQ(session.status().state, RunState::finished);
}

TEST_F(SessionTest, RestoreGoesOnFromTheCheckpointBitForBit) {
    Session session({}, options());
    ASSERT_NE(session.checkpoint(), nullptr); // of the start
    EXPECT_EQ(session.checkpoint()->tick, 0U);
    session.clear_news();
    give(session, levers(0));
    for (int i = 0; i < 3000; ++i)
        session.tick();
    ASSERT_NE(session.checkpoint(), nullptr); // of every tenth second
    EXPECT_EQ(session.checkpoint()->tick, 3000U);
    EXPECT_EQ(session.checkpoint()->state_hash, session.snapshot().state_hash);
    EXPECT_LT(session.checkpoint()->data.size(), 100'000U);
    session.clear_news();
    give(session, levers(1));
    std::vector<std::uint64_t> hashes;
    for (int i = 0; i < 500; ++i) {
        session.tick();
        hashes.push_back(session.snapshot().state_hash);
    }
    EXPECT_EQ(session.checkpoint(), nullptr);

    auto back = run_order(RunAction::restore);
    back.restore_time = 11;
    give(session, back);
    EXPECT_EQ(session.status().state, RunState::paused);
    EXPECT_EQ(session.snapshot().tick, 3000U);
    ASSERT_NE(session.checkpoint(), nullptr);
    EXPECT_EQ(session.checkpoint()->tick, 3000U);
    give(session, run_order(RunAction::start));
    give(session, levers(1), 0, "another"); // whose levers are followed at once
    for (const std::uint64_t hash : hashes) {
        session.tick();
        ASSERT_EQ(session.snapshot().state_hash, hash) << session.snapshot().tick;
    }
}

TEST_F(SessionTest, RestoreToWhatIsYetToComeIsRefusedAndDropsNothing) {
    Session session({}, options());
    for (int i = 0; i < 3150; ++i)
        session.tick();
    const std::uint64_t hash = session.snapshot().state_hash;
    auto ahead = run_order(RunAction::restore);
    ahead.restore_time = 5940; // 99:00
    give(session, ahead);
    EXPECT_EQ(text_of(session, "command.refused"),
              "ExerciseCommand from instructor: restore_time = 5940 refused; allowed: up to 10.50 s, the "
              "exercise's time now");
    EXPECT_EQ(session.status().state, RunState::running);
    EXPECT_EQ(session.snapshot().tick, 3150U);
    EXPECT_EQ(session.snapshot().state_hash, hash);
    auto now = run_order(RunAction::restore);
    now.restore_time = 10.5;
    give(session, now);
    EXPECT_EQ(session.snapshot().tick, 3000U);
}

TEST_F(SessionTest, SnapshotTakesACheckpointAtOnce) {
    Session session({}, options());
    session.clear_news();
    for (int i = 0; i < 70; ++i)
        session.tick();
    give(session, run_order(RunAction::snapshot));
    ASSERT_NE(session.checkpoint(), nullptr);
    EXPECT_EQ(session.checkpoint()->tick, 70U);
    EXPECT_EQ(count(session, "exercise.checkpoint"), 1);
}

TEST_F(SessionTest, EventsAreNumberedWithoutGaps) {
    Session session({}, options());
    give(session, levers(0));
    give(session, run_order(RunAction::pause));
    give(session, run_order(RunAction::start));
    for (int i = 0; i < 300; ++i)
        session.tick();
    ASSERT_GE(session.events().size(), 4U);
    for (std::size_t i = 0; i < session.events().size(); ++i)
        EXPECT_EQ(session.events()[i].number, i + 1);
}

TEST_F(SessionTest, FloodOfRefusalsIsCountedButDoesNotFloodTheLog) {
    Session session({}, options());
    session.clear_news();
    Inbox inbox;
    inbox.refusals.resize(1000, {.topic = "T", .source = "s", .field = "f", .value = "v", .allowed = "a"});
    inbox.overflow = 500;
    session.carry_out(inbox, 10);
    EXPECT_EQ(session.status().commands_refused, 1500U);
    EXPECT_LE(count(session, "command.refused"), 25);
    session.clear_news();
    inbox.refusals.resize(1);
    inbox.overflow = 0;
    session.carry_out(inbox, 11);
    EXPECT_NE(text_of(session, "command.refused").find("not listed"), std::string::npos);
}

TEST_F(SessionTest, RefusalThatFloodLeavesNoRoomForIsToldWhenThereIsRoom) {
    Session session({}, options());
    session.clear_news();
    const Refusal flood{.topic = "T", .source = "s", .field = "f", .value = "v", .allowed = "a"};
    Inbox inbox;
    inbox.refusals.resize(100, flood);
    inbox.refusals.push_back(
        {.topic = "U", .source = "", .field = "g", .value = "w", .allowed = "b", .side = 1});
    session.carry_out(inbox, 10);
    session.clear_news();
    inbox.refusals.resize(10, flood);
    double now = 10;
    for (int i = 0; i < 100; ++i) // it goes on, and may not push in
        session.carry_out(inbox, now += 0.01);
    EXPECT_TRUE(std::ranges::any_of(session.events(), [](const auto& event) {
        return event.text == "U from (unnamed): g = w refused; allowed: b" && event.side == 1;
    }));
    EXPECT_LE(count(session, "command.refused"), 11);
    session.clear_news();
    session.carry_out({}, now + 1); // nothing is refused any more
    EXPECT_EQ(count(session, "command.refused"), 1);
    EXPECT_EQ(text_of(session, "command.refused").substr(0, 1), "(");
    session.carry_out({}, now + 2);
    EXPECT_EQ(count(session, "command.refused"), 1) << "told once";
}

TEST_F(SessionTest, ExerciseThatCeasesToBeFiniteIsStoppedWithAlarmAlertAndDump) {
    Session session(impossible(), options());
    give(session, levers(0.5), 0, "trainee-1");
    for (int i = 0; i < 3000 && session.running(); ++i)
        session.tick();
    ASSERT_EQ(session.status().state, RunState::stopped_by_fault);
    EXPECT_TRUE(session.snapshot().ship.position.allFinite());
    EXPECT_EQ(count(session, "exercise.stopped_by_fault"), 1);
    ASSERT_EQ(session.alerts().size(), 1U);
    EXPECT_EQ(session.alerts()[0].priority, AlertPriority::alarm);

    std::vector<std::filesystem::path> dumps;
    for (const auto& entry : std::filesystem::directory_iterator(folder_))
        dumps.push_back(entry.path());
    ASSERT_EQ(dumps.size(), 1U);
    std::ifstream file(dumps[0]);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    EXPECT_NE(text.find("\"brake\": 0.5"), std::string::npos);
    EXPECT_NE(text.find("\"exercise\": \"impossible/wind\""), std::string::npos);
}

TEST_F(SessionTest, AlertOfAStoppedExerciseIsAcknowledgedAndRectifiedByReset) {
    Session session(impossible(), options());
    for (int i = 0; i < 3000 && session.running(); ++i)
        session.tick();
    ASSERT_EQ(session.status().state, RunState::stopped_by_fault);
    session.clear_news();
    give(session, AlertOrder{.code = "exercise.stopped_by_fault", .side = -1, .acknowledge = true});
    ASSERT_EQ(session.alerts().size(), 1U);
    EXPECT_EQ(session.alerts()[0].condition, AlertCondition::active_acknowledged);
    session.clear_news();
    give(session, run_order(RunAction::reset));
    ASSERT_EQ(session.alerts().size(), 1U);
    EXPECT_EQ(session.alerts()[0].condition, AlertCondition::normal);
    give(session, AlertOrder{.code = "no.such.alert"});
    EXPECT_NE(text_of(session, "command.refused").find("no.such.alert"), std::string::npos);
}

TEST_F(SessionTest, SilencedAlertSoundsAgainAfterThirtySecondsAndAnAcknowledgedOneDoesNot) {
    Session session({}, options());
    give(session, exercise::Order{exercise::HelmOrder{.engine = -0.5}}, 10, "trainee-1");
    hear_nothing(session, 10, 10.3 + kHandSilent); // nobody has the helm
    session.clear_news();
    give(session, AlertOrder{.code = "levers.unattended", .side = -1, .acknowledge = false}, 20);
    ASSERT_EQ(session.alerts().size(), 1U);
    EXPECT_EQ(session.alerts()[0].condition, AlertCondition::active_silenced);
    EXPECT_EQ(session.alerts()[0].silenced_left, 30);
    session.clear_news();
    session.carry_out({}, 49.9);
    EXPECT_TRUE(session.alerts().empty());
    session.carry_out({}, 50);
    ASSERT_EQ(session.alerts().size(), 1U);
    EXPECT_EQ(session.alerts()[0].condition, AlertCondition::active_unacknowledged);
    session.clear_news();
    give(session, AlertOrder{.code = "levers.unattended", .side = -1, .acknowledge = true}, 51);
    session.clear_news();
    session.carry_out({}, 200);
    EXPECT_TRUE(session.alerts().empty());
}

TEST_F(SessionTest, BookmarkIsAnEventWithItsWord) {
    Session session({}, options());
    session.clear_news();
    RunOrder bookmark = run_order(RunAction::bookmark);
    bookmark.text = "brake opened too far";
    give(session, bookmark);
    EXPECT_EQ(text_of(session, "exercise.bookmark"), "brake opened too far");
}

TEST_F(SessionTest, ChanceOfAFaultIsDrawnOnceAndKeptAsAnOrder) {
    Session session({}, options());
    session.clear_news();
    give(session, exercise::Order{exercise::FaultOrder{.code = exercise::FaultCode::motor_power_lost,
                                                       .trigger = exercise::FaultTrigger::at_chance,
                                                       .trigger_value = 10,
                                                       .trigger_until = 20}});
    ASSERT_EQ(session.orders().size(), 2U); // a resimulation needs no luck
    const auto* drawn = std::get_if<exercise::ChanceDrawn>(&session.orders()[1].command);
    ASSERT_NE(drawn, nullptr);
    EXPECT_GE(drawn->chance, 0);
    EXPECT_LE(drawn->chance, 1);
}

TEST_F(SessionTest, LimitsFollowTheExercise) {
    exercise::ExerciseDef def;
    def.tackle[0].side = exercise::Side::starboard;
    def.ship.rudder_max = 0.3;
    SessionOptions realtime = options();
    realtime.realtime = true;
    const Session session(def, realtime);
    EXPECT_FALSE(session.limits().side_present[0]);
    EXPECT_TRUE(session.limits().side_present[1]);
    EXPECT_EQ(session.limits().rudder_max, 0.3);
    EXPECT_FALSE(session.limits().unpaced);
}

TEST(Finite, OneBadNumberAnywhereIsFound) {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    exercise::Snapshot good;
    good.tackle.resize(2);
    good.tackle[1].chain.nodes.assign(3, {1, 2, 3});
    good.tackle[1].chain.tension.assign(2, 4);
    good.events.resize(1);
    EXPECT_TRUE(is_finite(good));
    auto bad = good;
    bad.tackle[1].chain.nodes[2].y() = kNan;
    EXPECT_FALSE(is_finite(bad));
    bad = good;
    bad.tackle[1].chain.tension[1] = kNan;
    EXPECT_FALSE(is_finite(bad));
    bad = good;
    bad.tackle[0].windlass.motor_temperature = kNan;
    EXPECT_FALSE(is_finite(bad));
    bad = good;
    bad.tackle[0].anchor.attitude.w() = kNan;
    EXPECT_FALSE(is_finite(bad));
    bad = good;
    bad.ship.yaw_rate = kNan;
    EXPECT_FALSE(is_finite(bad));
    bad = good;
    bad.events[0].value = kNan;
    EXPECT_FALSE(is_finite(bad));
}

} // namespace
} // namespace windlass::run
