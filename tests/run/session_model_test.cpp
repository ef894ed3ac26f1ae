// What a session says of the model's own steps, of a cable that runs away, and of a motor that has tripped.

#include "tests/run/session_rig.hpp"

namespace windlass::run {
namespace {

using namespace test;

TEST_F(SessionTest, TellsInstructorsThatStepsOfTheModelAreInDoubt) {
    // Links of 0.1 m on 100 m of hanging cable: a whole tick is too long a step for them.
    exercise::ExerciseDef def;
    def.model.adaptive = false;
    def.max_substeps = 1;
    def.environment.depth = 200;
    def.tackle[0].cable_out = 100;
    def.tackle[0].chain.node_spacing = 0.1;
    Session session(def, options());
    session.clear_news();
    for (int k = 0; k < 10 * def.tick_rate_hz; ++k)
        ASSERT_TRUE(session.tick());
    ASSERT_EQ(session.alerts().size(), 1U);
    const AlertView& alert = session.alerts().front();
    EXPECT_EQ(alert.code, "model.in_doubt");
    EXPECT_EQ(alert.priority, AlertPriority::caution);
    EXPECT_FALSE(alert.deck_panel || alert.bridge_panel); // about the simulation, for instructors
    EXPECT_NE(alert.explanation.find("too long"), std::string::npos) << alert.explanation;
    EXPECT_EQ(count(session, "model.in_doubt"), 1);
}

TEST_F(SessionTest, ARunawayIsAnAlarmOnDeckUntilTheCableIsSlow) {
    exercise::ExerciseDef def;
    def.environment.depth = 200;
    Session session(def, options());
    session.clear_news();
    give(session, levers(0), 0, "trainee-1");
    const auto alert = [&]() -> const AlertView* {
        for (const AlertView& each : session.alerts())
            if (each.code == "cable.runaway") return &each;
        return nullptr;
    };
    for (int k = 0; k < 60 * def.tick_rate_hz && alert() == nullptr; ++k)
        ASSERT_TRUE(session.tick());
    ASSERT_NE(alert(), nullptr);
    EXPECT_EQ(alert()->side, 0);
    EXPECT_EQ(alert()->priority, AlertPriority::alarm);
    EXPECT_EQ(alert()->text, "Cable runs away");
    EXPECT_TRUE(alert()->deck_panel);
    EXPECT_FALSE(alert()->bridge_panel); // there it is reported
    session.clear_news();
    give(session, levers(1), 0, "trainee-1");
    for (int k = 0; k < 60 * def.tick_rate_hz && alert() == nullptr; ++k)
        ASSERT_TRUE(session.tick());
    ASSERT_NE(alert(), nullptr);
    EXPECT_EQ(alert()->condition, AlertCondition::rectified_unacknowledged);
    EXPECT_LT(session.snapshot().tackle[0].windlass.cable_speed, 5);
}

TEST_F(SessionTest, AnInstructorHearsOfACableThatNobodyChecksUntilItIsSlowOrRunsAway) {
    exercise::ExerciseDef def;
    def.environment.depth = 200;
    Session session(def, options());
    session.clear_news();
    const auto speed = [&] { return session.snapshot().tackle[0].windlass.cable_speed; };
    const auto alert = [&]() -> const AlertView* {
        for (const AlertView& each : session.alerts())
            if (each.code == "cable.fast") return &each;
        return nullptr;
    };
    const auto work_until_told = [&](double brake) {
        session.clear_news();
        give(session, levers(brake), 0, "trainee-1");
        for (int k = 0; k < 60 * def.tick_rate_hz && alert() == nullptr; ++k)
            ASSERT_TRUE(session.tick());
        ASSERT_NE(alert(), nullptr);
    };
    work_until_told(0);
    EXPECT_EQ(alert()->condition, AlertCondition::active_unacknowledged);
    EXPECT_EQ(alert()->side, 0);
    EXPECT_EQ(alert()->priority, AlertPriority::warning);
    EXPECT_FALSE(alert()->deck_panel || alert()->bridge_panel) << "on deck it is seen and heard";
    EXPECT_GT(speed(), 6);
    EXPECT_LT(speed(), 7) << "as soon as it is so fast, and not where it runs away";
    work_until_told(1);
    EXPECT_EQ(alert()->condition, AlertCondition::rectified_unacknowledged);
    EXPECT_LT(speed(), 5);
    work_until_told(0);
    work_until_told(0);
    EXPECT_EQ(alert()->condition, AlertCondition::rectified_unacknowledged);
    EXPECT_GT(speed(), 9) << "from there on the runaway's alarm stands in its place";
}

TEST_F(SessionTest, ATrippedMotorIsAnAlarmOnDeckUntilItIsReset) {
    const exercise::ExerciseDef def;
    Session session(def, options());
    const auto work = [&](const exercise::WindlassOrder& levers) {
        session.clear_news();
        give(session, exercise::Order{levers}, 0, "trainee-1");
        for (int k = 0; k < def.tick_rate_hz; ++k)
            ASSERT_TRUE(session.tick());
    };
    const auto alert = [&]() -> const AlertView* {
        for (const AlertView& each : session.alerts())
            if (each.code == "motor.trip") return &each;
        return nullptr;
    };
    const auto lamp = [&] { return session.snapshot().tackle[0].windlass.tripped; };
    work({.speed_lever = 0.5, .emergency_stop = true}); // out of gear it would run light
    EXPECT_TRUE(lamp());
    EXPECT_EQ(alert(), nullptr) << "who stops it himself is not told that it has stopped";
    work({.speed_lever = 0});
    work({.speed_lever = 0.5});
    ASSERT_FALSE(lamp());

    give(session, exercise::Order{exercise::FaultOrder{.code = exercise::FaultCode::drive_trip}});
    work({.speed_lever = 0.5});
    ASSERT_NE(alert(), nullptr);
    EXPECT_EQ(alert()->condition, AlertCondition::active_unacknowledged);
    EXPECT_EQ(alert()->side, 0);
    EXPECT_EQ(alert()->priority, AlertPriority::alarm);
    EXPECT_EQ(alert()->text, "Windlass motor has tripped");
    EXPECT_TRUE(alert()->deck_panel);
    EXPECT_FALSE(alert()->bridge_panel); // there it is reported
    work({.speed_lever = 0.5});
    EXPECT_EQ(alert(), nullptr) << "it is told once";
    work({.speed_lever = 0});
    ASSERT_NE(alert(), nullptr);
    EXPECT_EQ(alert()->condition, AlertCondition::rectified_unacknowledged);
    EXPECT_FALSE(lamp());
}

} // namespace
} // namespace windlass::run
