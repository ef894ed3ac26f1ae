// Who has the levers in a run, and what becomes of levers that nobody has.

#include "tests/run/session_rig.hpp"

namespace windlass::server {
namespace {

using test::count;
using test::give;
using test::levers;
using test::run_order;
using SessionTest = test::SessionTest;
using test::text_of;

TEST_F(SessionTest, ForeignShipThatFallsSilentIsAnAlertUntilTheHelmIsMoved) {
    Session session({}, options());
    give(session, run_order(RunAction::start));
    const auto& ship = session.snapshot().ship;
    give(session,
         exercise::Order{
             exercise::OwnShipSample{ship.position, ship.attitude, ship.velocity, physics::Vec3::Zero(), 1}},
         0, "bridge");
    const auto run = [&session](double seconds) {
        for (int tick = 0; tick < seconds * session.def().tick_rate_hz; ++tick)
            session.tick();
    };
    const auto lost = [&session] { // as it was told last
        const auto told = std::ranges::find(session.alerts().rbegin(), session.alerts().rend(),
                                            std::string("own_ship.lost"), &AlertView::code);
        return told != session.alerts().rend() && told->condition == AlertCondition::active_unacknowledged;
    };
    run(3);
    EXPECT_FALSE(lost());
    run(2);
    EXPECT_TRUE(lost());
    give(session, exercise::Order{exercise::HelmOrder{}}, 0, "trainee-1"); // taken up as it is found
    give(session, exercise::Order{exercise::HelmOrder{.engine = 0.25}}, 0, "trainee-1");
    run(1);
    EXPECT_FALSE(lost());
}

TEST_F(SessionTest, LogTellsWhoTookTheLevers) {
    Session session({}, options());
    give(session, levers(1), 0, "trainee-1");
    give(session, levers(1), 0, "trainee-1");
    EXPECT_EQ(count(session, "levers.taken"), 1);
    session.clear_news();
    give(session, levers(1), 0, "instructor");
    EXPECT_EQ(text_of(session, "levers.taken"), "instructor has the port windlass, taken from trainee-1");
}

TEST_F(SessionTest, LeversThatNobodyHasAreLeftAsARealWindlassIsLeft) {
    exercise::ExerciseDef def;
    def.tackle[0].clutch_in = true;
    Session session(def, options());
    exercise::WindlassOrder heaving{.brake = 0.25, .speed_lever = 0.5, .clutch_in = true};
    give(session, exercise::Order{heaving}, 10, "trainee-1");
    for (int i = 0; i < 30; ++i)
        session.tick();
    EXPECT_EQ(session.snapshot().tackle[0].windlass.speed_lever, 0.5);
    const double brake = session.snapshot().tackle[0].windlass.brake_position;
    session.clear_news();

    session.take({}, 10.29); // silent, but not for long enough
    EXPECT_EQ(count(session, "levers.lost"), 0);
    session.take({}, 10.31);
    EXPECT_EQ(text_of(session, "levers.lost"),
              "trainee-1 is no longer heard and nobody has the port windlass: speed lever at zero; brake, "
              "clutch and stopper as they were");
    ASSERT_EQ(session.alerts().size(), 1U);
    EXPECT_EQ(session.alerts()[0].code, "levers.unattended");
    EXPECT_EQ(session.alerts()[0].side, 0);
    EXPECT_EQ(session.alerts()[0].priority, AlertPriority::warning);
    for (int i = 0; i < 30; ++i)
        session.tick();
    const auto& windlass = session.snapshot().tackle[0].windlass;
    EXPECT_EQ(windlass.speed_lever, 0);
    EXPECT_EQ(windlass.clutch, exercise::ClutchState::in);
    EXPECT_LE(windlass.brake_position, brake); // it goes on to where the hand-wheel was left, 0.25
    session.take({}, 11);
    EXPECT_EQ(count(session, "levers.lost"), 1); // told once

    session.clear_news();
    give(session, exercise::Order{heaving}, 12, "instructor");
    EXPECT_EQ(text_of(session, "levers.taken"), "instructor has the port windlass");
    ASSERT_EQ(session.alerts().size(), 1U);
    EXPECT_EQ(session.alerts()[0].condition, AlertCondition::rectified_unacknowledged);
}

TEST_F(SessionTest, HelmThatNobodyHasStaysAsItIsAndAnAlertTellsOfIt) {
    Session session({}, options());
    give(session, exercise::Order{exercise::HelmOrder{.engine = -0.5, .rudder = 0.1, .bow_thruster = 0.25}},
         10, "trainee-1");
    session.clear_news();
    session.take({}, 11);
    session.tick();
    EXPECT_EQ(count(session, "levers.lost"), 1);
    EXPECT_EQ(session.alerts().size(), 1U);
    EXPECT_EQ(session.snapshot().ship.bow_thruster, 0.25);
}

TEST_F(SessionTest, ResetTakesTheLeversOutOfEveryHandWithoutAnAlert) {
    Session session({}, options());
    give(session, levers(0.5), 10, "trainee-1");
    give(session, run_order(RunAction::reset), 10.1);
    session.clear_news();
    session.take({}, 20);
    EXPECT_EQ(count(session, "levers.lost"), 0);
    EXPECT_TRUE(session.alerts().empty());
}

TEST_F(SessionTest, InstructorsLeversAreHeardBeforeATraineesWhateverHisStrength) {
    Session session({}, options());
    test::give_as_instructor(session, levers(0.5), 10, "instructor");
    session.clear_news();
    give(session, levers(0), 10.05, "trainee-1"); // heard over the trainees' topic
    EXPECT_EQ(count(session, "levers.taken"), 0);
    EXPECT_TRUE(session.orders().empty());
    test::give_as_instructor(session, levers(0.5), 10.1, "instructor");
    give(session, levers(0), 10.29, "trainee-1");
    EXPECT_EQ(count(session, "levers.taken"), 0);
    give(session, levers(0), 10.31, "trainee-1"); // he has been silent for 0.21 s
    EXPECT_EQ(text_of(session, "levers.taken"), "trainee-1 has the port windlass, taken from instructor");
}

} // namespace
} // namespace windlass::server
