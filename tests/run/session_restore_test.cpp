// An exercise taken up again: what is kept for it, levers that do not lurch, and alerts of what stands in it.

#include "server/exercise/checkpoint.hpp"

#include "tests/run/session_rig.hpp"

namespace windlass::run {
namespace {

using exercise::HelmOrder;
using exercise::Order;
using exercise::RunState;
using exercise::Side;
using exercise::WindlassOrder;
using test::count;
using test::give;
using test::hear_nothing;
using test::levers;
using test::run_order;
using test::text_of;
using SessionRestore = test::SessionTest;

void run(Session& session, int ticks) {
    for (int i = 0; i < ticks; ++i)
        session.tick();
}

/// Another exercise, half a second on, its levers as a trainee left them.
std::vector<std::uint8_t> state_of_another(const WindlassOrder& order = {}, const HelmOrder& helm = {}) {
    exercise::ExerciseDef def;
    def.name = "another";
    def.environment.depth = 33;
    exercise::Exercise another(def);
    another.apply(order);
    another.apply(helm);
    for (int i = 0; i < 150; ++i)
        another.step(1.0 / def.tick_rate_hz);
    return exercise::write_checkpoint(another);
}

/// The alert of that code that was told last, on the port side or neither.
const AlertView* alert(const Session& session, const std::string& code) {
    const auto told =
        std::ranges::find(session.alerts().rbegin(), session.alerts().rend(), code, &AlertView::code);
    return told == session.alerts().rend() ? nullptr : &*told;
}

StateOrder state_order(std::vector<std::uint8_t> checkpoint) {
    return {.from = "monday at 0:00", .checkpoint = std::move(checkpoint)};
}

RunOrder restore_to(double time) {
    RunOrder order = run_order(RunAction::restore);
    order.restore_time = time;
    return order;
}

const WindlassOrder& windlass_order(const Session& session, std::size_t number) {
    return std::get<WindlassOrder>(session.orders().at(number).command);
}

TEST_F(SessionRestore, EveryOrderIsToldWithItsTickNumberAndSource) {
    Session session({}, options());
    give(session, levers(0.5), 10, "trainee-1");
    run(session, 5);
    give(session, Order{exercise::FaultOrder{}}, 10.1);
    ASSERT_EQ(session.orders().size(), 2U);
    EXPECT_EQ(session.orders()[0].tick, 0U);
    EXPECT_EQ(session.orders()[0].number, 1U);
    EXPECT_EQ(session.orders()[0].source, "trainee-1");
    EXPECT_EQ(session.orders()[1].tick, 5U);
    EXPECT_EQ(session.orders()[1].number, 2U);
    session.clear_news();
    hear_nothing(session, 10.1,
                 10.4 + kHandSilent); // nobody is heard any more: the server works the speed lever itself
    ASSERT_EQ(session.orders().size(), 1U);
    EXPECT_EQ(session.orders()[0].source, "server");
    EXPECT_EQ(windlass_order(session, 0).brake, 0.5);
    EXPECT_EQ(session.status().orders_taken, 1U) << "in the state that is shown";
    run(session, 1);
    EXPECT_EQ(session.status().orders_taken, 3U);
}

TEST_F(SessionRestore, EachRunHasItsNumberAndCountsItsOrders) {
    SessionOptions numbered = options();
    numbered.first_run = 1000;
    Session session({}, numbered);
    EXPECT_EQ(session.status().run, 1000U);
    give(session, levers(0.5));
    run(session, 1);
    give(session, run_order(RunAction::reset));
    EXPECT_EQ(session.status().run, 1001U);
    EXPECT_EQ(session.status().orders_taken, 0U);
    give(session, state_order(state_of_another()));
    EXPECT_EQ(session.status().run, 1002U);
    ASSERT_NE(session.checkpoint(), nullptr);
    EXPECT_EQ(session.checkpoint()->run, 1002U);
}

TEST_F(SessionRestore, CheckpointSaysWhichOrdersAreInIt) {
    Session session({}, options());
    run(session, 3);
    give(session, levers(0.5)); // in the exercise, but not yet in the picture
    give(session, run_order(RunAction::snapshot));
    const CheckpointView& checkpoint = *session.checkpoint();
    EXPECT_EQ(checkpoint.orders_taken, 1U);
    exercise::Exercise read = exercise::read_checkpoint(checkpoint.data);
    exercise::Snapshot seen;
    read.view(seen);
    EXPECT_EQ(seen.state_hash, checkpoint.state_hash);
    EXPECT_EQ(exercise::definition_hash(read.def()), checkpoint.definition_hash);
}

// Her coming to anchor is played once: a reset brings back that start, and the same course follows from it.
TEST_F(SessionRestore, ResetOfAnExerciseThatStartsAtAnchorGivesTheSameStartAgain) {
    exercise::ExerciseDef def;
    def.tackle[0].at_anchor = 5;
    Session session(def, options());
    const auto start = session.checkpoint()->data;
    const auto goes_on =
        [&](const char* hand) { // another each time: one's own stays as found until it is moved
            give(session, levers(0), 0, hand);
            run(session, 600);
            give(session, run_order(RunAction::snapshot));
            return session.checkpoint()->data;
        };
    const auto later = goes_on("anna");
    ASSERT_NE(later, start);
    give(session, run_order(RunAction::reset));
    EXPECT_EQ(session.snapshot().tick, 0U);
    EXPECT_EQ(session.checkpoint()->data, start);
    give(session, run_order(RunAction::start));
    EXPECT_EQ(goes_on("ben"), later);
}

TEST_F(SessionRestore, StateOfAnotherExerciseTakesThePlaceOfThisOnePaused) {
    Session session({}, options());
    run(session, 10);
    const unsigned setups = session.setups();
    const auto bytes = state_of_another();
    give(session, state_order(bytes), 5, "instructor");
    EXPECT_EQ(session.status().state, RunState::paused);
    EXPECT_EQ(session.status().exercise, "another");
    EXPECT_EQ(session.snapshot().tick, 150U);
    EXPECT_EQ(session.snapshot().environment.depth, 33);
    EXPECT_GT(session.setups(), setups); // room for its cable, its tick rate
    ASSERT_NE(session.checkpoint(), nullptr);
    EXPECT_EQ(session.checkpoint()->data, bytes);
    EXPECT_EQ(text_of(session, "exercise.restored"),
              "exercise restored to 0:00, paused, from monday at 0:00 by instructor");

    exercise::Exercise on = exercise::read_checkpoint(bytes);
    give(session, run_order(RunAction::start), 5.1);
    run(session, 200);
    for (int i = 0; i < 200; ++i)
        on.step(session.dt());
    exercise::Snapshot expected;
    on.view(expected);
    EXPECT_EQ(session.snapshot().state_hash, expected.state_hash);
}

TEST_F(SessionRestore, BytesThatAreNoStateLeaveTheRunningExerciseAlone) {
    SessionOptions strict = options();
    strict.check = [](const exercise::ExerciseDef& def) {
        if (def.environment.depth == 33) throw std::runtime_error("/environment/depth: 33 is not allowed");
    };
    Session session({}, strict);
    run(session, 10);
    const auto before = session.snapshot().state_hash;
    const auto run_before = session.status().run;
    session.clear_news();
    auto cut = state_of_another();
    cut.resize(cut.size() / 2);
    give(session, state_order(cut));
    give(session, state_order({}), 2);
    give(session, state_order(state_of_another()), 4); // whole, but not allowed
    EXPECT_EQ(count(session, "command.refused"), 3);
    EXPECT_NE(session.events().back().text.find("/environment/depth: 33 is not allowed"), std::string::npos)
        << session.events().back().text;
    EXPECT_EQ(session.status().state, RunState::running);
    EXPECT_EQ(session.snapshot().state_hash, before);
    EXPECT_EQ(session.status().run, run_before);
    EXPECT_EQ(session.checkpoint(), nullptr);
}

TEST_F(SessionRestore, LeversOfTheHandStayAsFoundUntilItMovesThem) {
    Session session({}, options());
    WindlassOrder hand{.brake = 1, .stopper_closed = true};
    give(session, Order{hand}, 10, "trainee-1");
    give(session, state_order(state_of_another({.brake = 0.3, .clutch_in = false})), 10.1);
    session.clear_news();

    give(session, Order{hand}, 10.2, "trainee-1"); // goes on sending where its levers stand
    EXPECT_EQ(windlass_order(session, 0).brake, 0.3);
    EXPECT_FALSE(windlass_order(session, 0).stopper_closed);
    hand.brake = 0.9;
    give(session, Order{hand}, 10.3, "trainee-1");
    EXPECT_EQ(windlass_order(session, 1).brake, 0.9);
    EXPECT_FALSE(windlass_order(session, 1).stopper_closed) << "not moved";
    hand.brake = 1;
    give(session, Order{hand}, 10.4, "trainee-1");
    EXPECT_EQ(windlass_order(session, 2).brake, 1) << "moved, if back to where it was";

    give(session, Order{WindlassOrder{.brake = 0.8, .stopper_closed = true}}, 10.5, "instructor");
    EXPECT_EQ(windlass_order(session, 3).brake, 0.8);
    EXPECT_TRUE(windlass_order(session, 3).stopper_closed) << "another hand is followed at once";
}

TEST_F(SessionRestore, HelmStaysAsFoundUntilItIsMoved) {
    Session session({}, options());
    HelmOrder hand{.engine = 1};
    give(session, Order{hand}, 10, "trainee-1");
    give(session, state_order(state_of_another({}, {.engine = -0.5, .rudder = 0.2})), 10.1);
    session.clear_news();
    give(session, Order{hand}, 10.2, "trainee-1");
    hand.rudder = -0.1;
    give(session, Order{hand}, 10.3, "trainee-1");
    ASSERT_EQ(session.orders().size(), 2U);
    EXPECT_EQ(std::get<HelmOrder>(session.orders()[0].command).engine, -0.5);
    EXPECT_EQ(std::get<HelmOrder>(session.orders()[0].command).rudder, 0.2);
    EXPECT_EQ(std::get<HelmOrder>(session.orders()[1].command).engine, -0.5);
    EXPECT_EQ(std::get<HelmOrder>(session.orders()[1].command).rudder, -0.1);
}

TEST_F(SessionRestore, SpeedLeverThatNoHandHoldsAsFoundSpringsToZero) {
    const auto heaving = state_of_another({.brake = 0.5, .speed_lever = 0.75, .clutch_in = true});
    Session held({}, options());
    give(held, Order{WindlassOrder{.speed_lever = -0.5}}, 10, "trainee-1");
    give(held, state_order(heaving), 10.1);
    held.clear_news();
    give(held, Order{WindlassOrder{.speed_lever = -0.5}}, 10.2, "trainee-1");
    EXPECT_EQ(windlass_order(held, 0).speed_lever, 0);
    EXPECT_EQ(windlass_order(held, 0).brake, 0.5);

    Session nobody({}, options());
    give(nobody, state_order(heaving), 10);
    nobody.carry_out({}, 20);
    EXPECT_TRUE(nobody.orders().empty()) << "paused: as it was";
    give(nobody, run_order(RunAction::start), 20);
    hear_nothing(nobody, 20, 20 + kHandSilent);
    EXPECT_TRUE(nobody.orders().empty());
    hear_nothing(nobody, 20 + kHandSilent, 20.3 + kHandSilent);
    ASSERT_EQ(nobody.orders().size(), 1U);
    EXPECT_EQ(windlass_order(nobody, 0).speed_lever, 0);
    EXPECT_EQ(windlass_order(nobody, 0).brake, 0.5);
    EXPECT_TRUE(windlass_order(nobody, 0).clutch_in);
    EXPECT_EQ(count(nobody, "levers.lost"), 1);
    EXPECT_EQ(text_of(nobody, "levers.lost"),
              "nobody has moved the levers of the port windlass yet: speed lever at zero; brake, clutch and "
              "stopper as they were");
    EXPECT_TRUE(nobody.alerts().empty()) << "a trainee may sit there who has not touched them";

    Session taken({}, options());
    give(taken, state_order(heaving), 10);
    give(taken, run_order(RunAction::start), 20);
    give(taken, Order{WindlassOrder{.brake = 0.5, .speed_lever = 0.75, .clutch_in = true}}, 21, "trainee-1");
    EXPECT_EQ(text_of(taken, "levers.taken"), "trainee-1 has the port windlass") << "from nobody";
}

TEST_F(SessionRestore, AMotorThatHasTrippedInTheStateIsAnAlertThereToldOnce) {
    Session session({}, options());
    const auto lever = [&](double speed) {
        give(session, Order{WindlassOrder{.speed_lever = speed}}, 0, "anna");
    };
    lever(0.5); // out of gear it runs light
    give(session, Order{exercise::FaultOrder{.code = exercise::FaultCode::drive_trip}});
    run(session, 300);
    ASSERT_NE(alert(session, "motor.trip"), nullptr);
    const double raised = alert(session, "motor.trip")->raised_time;
    give(session, run_order(RunAction::snapshot));
    const auto tripped = session.checkpoint()->data;
    const double there = session.now_time();

    session.clear_news();
    give(session, restore_to(there));
    EXPECT_EQ(alert(session, "motor.trip"), nullptr) << "it stands already, and was raised before";
    lever(0);
    give(session, run_order(RunAction::start));
    run(session, 300);
    ASSERT_NE(alert(session, "motor.trip"), nullptr);
    EXPECT_EQ(alert(session, "motor.trip")->condition, AlertCondition::rectified_unacknowledged);

    session.clear_news();
    give(session, restore_to(there));
    ASSERT_EQ(session.alerts().size(), 1U);
    EXPECT_EQ(session.alerts().front().code, "motor.trip");
    EXPECT_EQ(session.alerts().front().condition, AlertCondition::active_unacknowledged);
    EXPECT_EQ(session.alerts().front().raised_time, there);
    session.clear_news();
    give(session, run_order(RunAction::start));
    run(session, 300);
    EXPECT_TRUE(session.alerts().empty()) << "it is told once";
    give(session, restore_to(0));
    ASSERT_NE(alert(session, "motor.trip"), nullptr);
    EXPECT_EQ(alert(session, "motor.trip")->condition, AlertCondition::rectified_unacknowledged)
        << "paused, where it had not tripped yet";
    EXPECT_LT(raised, there);

    Session other({}, options());
    other.clear_news();
    give(other, state_order(tripped));
    ASSERT_NE(alert(other, "motor.trip"), nullptr) << "in a state that was brought from elsewhere";
    SessionOptions lost = options();
    lost.resumption = Resumption{.checkpoint = tripped, .refused = {}, .set_back = {}};
    const Session taken_up({}, lost);
    ASSERT_NE(alert(taken_up, "motor.trip"), nullptr) << "after its server was lost";
    EXPECT_EQ(alert(taken_up, "motor.trip")->condition, AlertCondition::active_unacknowledged);
}

TEST_F(SessionRestore, AnAlertRaisedInWhatWasUndoneIsRaisedAnewWhereItStoodBefore) {
    Session session({}, options());
    const auto watch = [&](bool kept) { // far from the ship
        give(session, Order{exercise::WatchCircleOrder{.kept = kept, .x = 5000, .y = 0, .radius = 10}});
        run(session, 300);
    };
    watch(true);
    give(session, run_order(RunAction::snapshot));
    const double there = session.now_time();
    watch(false);
    watch(true); // another time, which will not have been
    give(session, AlertOrder{.code = "watch.circle", .side = -1, .acknowledge = true});
    session.clear_news();
    give(session, restore_to(there));
    ASSERT_NE(alert(session, "watch.circle"), nullptr);
    EXPECT_EQ(alert(session, "watch.circle")->condition, AlertCondition::active_unacknowledged);
    EXPECT_EQ(alert(session, "watch.circle")->raised_time, there);
}

TEST_F(SessionRestore, AShipOfWhichNothingIsHeardInTheStateIsAnAlertThereAndNoneWhereTheServerSailsHer) {
    Session session({}, options());
    const exercise::ShipView ship = session.snapshot().ship;
    give(session, Order{exercise::OwnShipSample{ship.position, ship.attitude, ship.velocity,
                                                physics::Vec3::Zero(), 1}});
    run(session, 5 * 300);
    ASSERT_NE(alert(session, "own_ship.lost"), nullptr);
    give(session, run_order(RunAction::snapshot));
    Session other({}, options());
    give(other, state_order(session.checkpoint()->data));
    ASSERT_NE(alert(other, "own_ship.lost"), nullptr);
    EXPECT_EQ(alert(other, "own_ship.lost")->condition, AlertCondition::active_unacknowledged);
    give(other, run_order(RunAction::reset));
    EXPECT_EQ(alert(other, "own_ship.lost")->condition, AlertCondition::rectified_unacknowledged);
}

TEST_F(SessionRestore, ACableThatRunsAwayInTheStateIsAnAlertThere) {
    exercise::ExerciseDef def;
    def.environment.depth = 200;
    Session session(def, options());
    give(session, levers(0), 0, "anna");
    for (int tick = 0; tick < 60 * def.tick_rate_hz && alert(session, "cable.runaway") == nullptr; ++tick)
        ASSERT_TRUE(session.tick());
    ASSERT_NE(alert(session, "cable.runaway"), nullptr);
    run(session, 30);
    give(session, run_order(RunAction::snapshot));
    Session other({}, options());
    give(other, state_order(session.checkpoint()->data));
    ASSERT_NE(alert(other, "cable.runaway"), nullptr);
    EXPECT_EQ(alert(other, "cable.runaway")->side, 0);
    EXPECT_EQ(alert(other, "cable.runaway")->value, session.snapshot().tackle[0].windlass.cable_speed);
}

} // namespace
} // namespace windlass::run
