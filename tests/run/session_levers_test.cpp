// Who has the levers in a run, and what becomes of levers that nobody has.

#include "tests/run/session_rig.hpp"

namespace windlass::run {
namespace {

using test::count;
using test::give;
using test::hear_nothing;
using test::levers;
using test::run_order;
using SessionTest = test::SessionTest;
using test::text_of;

/// How often the alert of levers that nobody has was told since the last clear_news().
int unattended(const Session& session) {
    return static_cast<int>(
        std::ranges::count(session.alerts(), std::string("levers.unattended"), &AlertView::code));
}

/// How grave the log says it is that nobody has the levers, as it was told last.
exercise::Severity severity_of_lost(const Session& session) {
    const auto told = std::ranges::find(session.events().rbegin(), session.events().rend(),
                                        std::string("levers.lost"), &exercise::ExerciseEvent::code);
    EXPECT_NE(told, session.events().rend());
    return told == session.events().rend() ? exercise::Severity::alarm : told->severity;
}

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

    hear_nothing(session, 10, 10 + kHandSilent); // silent, but not for long enough
    EXPECT_EQ(count(session, "levers.lost"), 0);
    hear_nothing(session, 10 + kHandSilent, 10.3 + kHandSilent);
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
    hear_nothing(session, 10.3 + kHandSilent, 20);
    EXPECT_EQ(count(session, "levers.lost"), 1); // told once

    session.clear_news();
    give(session, exercise::Order{heaving}, 20, "instructor");
    EXPECT_EQ(text_of(session, "levers.taken"), "instructor has the port windlass");
    ASSERT_EQ(session.alerts().size(), 1U);
    EXPECT_EQ(session.alerts()[0].condition, AlertCondition::rectified_unacknowledged);
}

TEST_F(SessionTest, HelmThatNobodyHasStaysAsItIsAndAnAlertTellsOfIt) {
    Session session({}, options());
    give(session, exercise::Order{exercise::HelmOrder{.engine = -0.5, .rudder = 0.1, .bow_thruster = 0.25}},
         10, "trainee-1");
    session.clear_news();
    hear_nothing(session, 10, 10.3 + kHandSilent);
    session.tick();
    EXPECT_EQ(count(session, "levers.lost"), 1);
    EXPECT_EQ(session.alerts().size(), 1U);
    EXPECT_EQ(session.snapshot().ship.bow_thruster, 0.25);
}

// A page that comes to the helm takes it by this picture, whoever ordered what it shows.
TEST_F(SessionTest, PictureHasTheHelmAsAnybodyOrderedItLastAlsoWhileTheExerciseStandsStill) {
    Session session({}, options());
    const auto ordered = [&] {
        const auto& ship = session.snapshot().ship;
        return exercise::HelmOrder{ship.engine_ordered, ship.rudder_ordered, ship.bow_thruster_ordered,
                                   ship.stern_thruster_ordered};
    };
    const exercise::HelmOrder slow{.engine = 0.4, .rudder = 0.1, .bow_thruster = 0.5, .stern_thruster = -0.5};
    const exercise::HelmOrder stop{.rudder = 0.1};
    give(session, exercise::Order{slow}, 10, "trainee-1");
    session.tick();
    EXPECT_EQ(ordered(), slow);
    EXPECT_LT(session.snapshot().ship.engine, 0.4) << "it has only begun to follow";
    give(session, exercise::Order{stop}, 10.1, "trainee-2");
    hear_nothing(session, 10.1, 20);
    session.tick();
    EXPECT_EQ(ordered(), stop) << "nobody has the helm any more";
    give(session,
         exercise::Order{exercise::FaultOrder{.code = exercise::FaultCode::telegraph_failed, .severity = 1}},
         20);
    give(session, exercise::Order{slow}, 20, "trainee-1");
    session.tick();
    EXPECT_EQ(ordered(), slow) << "the telegraph stands there, though nobody hears it";
    give(session, run_order(RunAction::pause), 20.1);
    give(session, exercise::Order{stop}, 20.2, "trainee-1");
    EXPECT_EQ(ordered(), stop);
}

TEST_F(SessionTest, PictureHasASpeedLeverAndAnEmergencyStopThatAreMovedWhileTheExerciseStandsStill) {
    Session session({}, options());
    give(session, run_order(RunAction::pause));
    const exercise::WindlassOrder moved{.speed_lever = -0.5, .emergency_stop = true};
    give(session, exercise::Order{moved}, 10, "trainee-1");
    EXPECT_EQ(session.snapshot().tackle[0].windlass.speed_lever, -0.5);
    EXPECT_TRUE(session.snapshot().tackle[0].windlass.emergency_stop);
}

TEST_F(SessionTest, ResetTakesTheLeversOutOfEveryHandWithoutAnAlert) {
    Session session({}, options());
    give(session, levers(0.5), 10, "trainee-1");
    give(session, run_order(RunAction::reset), 10.1);
    session.clear_news();
    hear_nothing(session, 10.1, 20);
    EXPECT_EQ(count(session, "levers.lost"), 0);
    EXPECT_TRUE(session.alerts().empty());
}

// A hand that lies on an open wheel lets go no anchor in the run that comes after.
TEST_F(SessionTest, AfterAResetLeversStayAsTheFileHasThemUntilTheHandMovesThem) {
    Session session({}, options());
    const auto set = [&] { return std::get<exercise::WindlassOrder>(session.orders().back().command).brake; };
    give(session, levers(0));
    EXPECT_EQ(set(), 0);
    give(session, run_order(RunAction::reset));
    give(session, levers(0));
    EXPECT_EQ(set(), exercise::ExerciseDef{}.tackle[0].brake);
    give(session, levers(0.25));
    EXPECT_EQ(set(), 0.25);
    give(session, levers(0));
    EXPECT_EQ(set(), 0);
}

/// Of a hand that says in which run it moved a lever last.
void give_as_moved_in(std::uint64_t run, Session& session, OrderContent order, const char* source) {
    Inbox inbox;
    inbox.orders.push_back({.source = source, .what = std::move(order), .moved_in_run = run});
    session.carry_out(inbox, 0);
}

// A server that is started anew knows no hand, and hears of each whether it lay there before.
TEST_F(SessionTest, HandThatMovedItsLeversLastInAnotherRunMovesNoneUntilItMovesOne) {
    SessionOptions numbered = options();
    numbered.first_run = 1000;
    Session session({}, numbered);
    const double as_filed = exercise::ExerciseDef{}.tackle[0].brake;
    const auto set = [&] { return std::get<exercise::WindlassOrder>(session.orders().back().command).brake; };
    give_as_moved_in(999, session, levers(0), "trainee-1");
    EXPECT_EQ(set(), as_filed);
    give_as_moved_in(1000, session, levers(0.25), "trainee-1");
    EXPECT_EQ(set(), 0.25);
    give_as_moved_in(1000, session, levers(0), "trainee-2");
    EXPECT_EQ(set(), 0) << "another hand, that moved its levers in this run";
    give_as_moved_in(0, session, levers(0.75), "trainee-3");
    EXPECT_EQ(set(), 0.75) << "another hand, that says nothing of it";
}

// A network that is slow has the words of killed programs come behind those of the next, and behind a reset.
class LateWordsOfAHandsKilledPrograms : public SessionTest {
protected:
    /// Where the brake is set by the word of a program, which says in which run its hand moved a lever last.
    double say(std::uint8_t program, std::uint64_t moved_in_run, double brake) {
        Inbox inbox;
        inbox.orders.push_back({.source = "trainee-1",
                                .what = levers(brake),
                                .writer = {program},
                                .moved_in_run = moved_in_run});
        session.carry_out(inbox, 0);
        return std::get<exercise::WindlassOrder>(session.orders().back().command).brake;
    }
    static SessionOptions numbered(SessionOptions options) {
        options.first_run = 1000;
        return options;
    }

    Session session{{}, numbered(options())};
    const double as_filed = exercise::ExerciseDef{}.tackle[0].brake;
};

TEST_F(LateWordsOfAHandsKilledPrograms, MoveNothingInTheNextRun) {
    EXPECT_EQ(say(1, 1000, 0.5), 0.5);
    EXPECT_EQ(say(2, 1000, 0.75), 0.75);
    give(session, run_order(RunAction::reset));
    EXPECT_EQ(say(1, 1000, 0), as_filed) << "where it lay, at last";
    EXPECT_EQ(say(1, 1000, 0.25), as_filed) << "moved before the reset";
    EXPECT_EQ(say(2, 1000, 0.75), as_filed) << "nor has the present one been moved";
    EXPECT_EQ(say(2, 1001, 0.625), 0.625);
    EXPECT_EQ(say(3, 1000, 0.125), 0.625) << "a third, that knew of no reset";
    EXPECT_EQ(say(3, 1001, 0), 0) << "its hand moves it";
}

TEST_F(LateWordsOfAHandsKilledPrograms, OfWhichThereWereTwoDoNotHideWhereThePresentOneLay) {
    EXPECT_EQ(say(1, 1000, 0.5), 0.5);
    EXPECT_EQ(say(2, 1000, 0.625), 0.625);
    EXPECT_EQ(say(3, 1000, 0.75), 0.75);
    give(session, run_order(RunAction::reset));
    EXPECT_EQ(say(2, 1000, 0.625), as_filed);
    EXPECT_EQ(say(1, 1000, 0.5), as_filed);
    EXPECT_EQ(say(3, 1001, 0.75), as_filed) << "its hand has moved another lever since, not this one";
    EXPECT_EQ(say(3, 1001, 0.25), 0.25);
}

TEST_F(SessionTest, WordsThatCameWithTheResetAreNoMovesBehindIt) {
    SessionOptions numbered = options();
    numbered.first_run = 1000;
    Session session({}, numbered);
    const double as_filed = exercise::ExerciseDef{}.tackle[0].brake;
    const auto word = [](double brake) {
        return ReceivedOrder{
            .source = "trainee-1", .what = levers(brake), .writer = {1}, .moved_in_run = 1000};
    };
    const auto brake = [&] {
        return std::get<exercise::WindlassOrder>(session.orders().back().command).brake;
    };
    Inbox inbox; // of a server that stood still meanwhile
    inbox.orders = {
        {.source = "instructor", .what = run_order(RunAction::reset)}, word(0.25), word(0.75), word(0.5)};
    session.carry_out(inbox, 0);
    EXPECT_EQ(brake(), as_filed) << "moved before the reset, all of it";
    inbox.orders = {word(0.5)};
    session.carry_out(inbox, 0.1);
    EXPECT_EQ(brake(), as_filed) << "and not since";
    inbox.orders = {word(0.625)};
    session.carry_out(inbox, 0.2);
    EXPECT_EQ(brake(), 0.625) << "by a hand that has not heard of the reset yet";
}

TEST_F(SessionTest, HandThatLetsGoIsNotSaidToBeUnheard) {
    Session session({}, options());
    WriterKey writer{7};
    const auto hold = [&](double now) {
        Inbox inbox;
        inbox.orders.push_back({"instructor", levers(0.5), true, writer});
        session.carry_out(inbox, now);
    };
    const auto let_go = [&](double now) {
        Inbox inbox;
        inbox.left.push_back(writer);
        session.carry_out(inbox, now);
    };
    hold(10);
    let_go(10.1);
    session.clear_news();
    hear_nothing(session, 10.1, 10.5);
    EXPECT_EQ(text_of(session, "levers.lost"),
              "instructor is not at the levers: nobody has the port windlass; speed lever at zero; brake, "
              "clutch and stopper as they were");
    ASSERT_EQ(session.alerts().size(), 1U);
    EXPECT_EQ(session.alerts()[0].explanation,
              "instructor had it and is not at the levers; speed lever at zero; brake, clutch and stopper "
              "as they were. Whoever moves the levers next has them.");
    writer = {8}; // each hand of a station has one of its own
    hold(11);
    let_go(11.1);
    session.clear_news();
    give(session, levers(0), 11.15, "trainee-1"); // who lay there all the while
    EXPECT_EQ(text_of(session, "levers.taken"), "trainee-1 has the port windlass, handed back by instructor");
    EXPECT_EQ(count(session, "levers.lost"), 0);
}

TEST_F(SessionTest, WhoLetsGoOfASecuredWindlassIsNoAlertAndNoWarning) {
    Session session({}, options());
    WriterKey writer{7};
    const auto leave = [&](const exercise::WindlassOrder& as, double now) {
        Inbox inbox;
        inbox.orders.push_back({"trainee-1", exercise::Order{as}, false, writer});
        session.carry_out(inbox, now);
        for (int i = 0; i < 300; ++i)
            session.tick();
        session.clear_news();
        Inbox left;
        left.left.push_back(writer);
        session.carry_out(left, now + 0.1);
        hear_nothing(session, now + 0.1, now + 0.5);
    };
    leave({.brake = 1, .stopper_closed = true}, 10);
    EXPECT_EQ(count(session, "levers.lost"), 1) << "it is told all the same";
    EXPECT_EQ(severity_of_lost(session), exercise::Severity::info);
    EXPECT_EQ(unattended(session), 0);
    writer = {8}; // each hand of a station has one of its own
    leave({.brake = 1}, 20);
    EXPECT_EQ(unattended(session), 1) << "the brake alone";
    EXPECT_EQ(severity_of_lost(session), exercise::Severity::warning);
}

/// Hands that come, speak and go; each of a station has a writer of its own.
class Hands : public SessionTest {
protected:
    void speak(const exercise::Order& order, std::uint8_t writer, const char* source = "trainee-1",
               bool instructor = false) {
        Inbox inbox;
        inbox.orders.push_back({source, order, instructor, {writer}});
        session.carry_out(inbox, now += 0.05);
    }
    void let_go(std::uint8_t writer) {
        Inbox inbox;
        inbox.left.push_back({writer});
        session.carry_out(inbox, now += 0.05);
    }
    void nobody_speaks() {
        hear_nothing(session, now, now + 0.3);
        now += 0.3;
    }
    /// As the alert of those levers was told last; nothing: it was not, since the last clear_news().
    std::optional<AlertCondition> alert_of(int side) const {
        std::optional<AlertCondition> told;
        for (const AlertView& alert : session.alerts())
            if (alert.code == "levers.unattended" && alert.side == side) told = alert.condition;
        return told;
    }

    const exercise::Order heaving = exercise::WindlassOrder{.brake = 0.5, .speed_lever = 0.5};
    const exercise::Order slow_ahead = exercise::HelmOrder{.engine = 0.4};
    Session session{{}, options()};
    double now = 10;
};

TEST_F(Hands, ThatGoFromTheWindlassToTheHelmOfTheirOwnSeatsAreNoAlert) {
    speak(heaving, 1);
    let_go(1);
    nobody_speaks();
    EXPECT_EQ(alert_of(0), AlertCondition::active_unacknowledged) << "he may have gone for good";
    speak(slow_ahead, 2);
    EXPECT_EQ(alert_of(0), AlertCondition::rectified_unacknowledged) << "he is at the helm";
    speak(heaving, 3);
    session.clear_news();
    let_go(3);
    for (int word = 0; word < 10; ++word)
        speak(slow_ahead, 2);
    EXPECT_EQ(count(session, "levers.lost"), 1) << "it is told all the same";
    EXPECT_EQ(severity_of_lost(session), exercise::Severity::info);
    EXPECT_EQ(alert_of(0), std::nullopt);
    speak(heaving, 4);
    let_go(2); // and back
    for (int word = 0; word < 10; ++word)
        speak(heaving, 4);
    EXPECT_EQ(alert_of(-1), std::nullopt);
}

TEST_F(Hands, ThatLeaveTheOtherPlaceTooAreAnAlertOfBoth) {
    speak(heaving, 1);
    speak(slow_ahead, 2);
    let_go(1);
    for (int word = 0; word < 10; ++word)
        speak(slow_ahead, 2);
    EXPECT_EQ(alert_of(0), std::nullopt);
    let_go(2);
    nobody_speaks();
    EXPECT_EQ(alert_of(0), AlertCondition::active_unacknowledged);
    EXPECT_EQ(alert_of(-1), AlertCondition::active_unacknowledged);
}

TEST_F(Hands, OfTwoTraineesEachIsMissedAtHisOwnPlace) {
    speak(heaving, 1, "trainee-1");
    speak(slow_ahead, 2, "trainee-2");
    let_go(1);
    for (int word = 0; word < 10; ++word)
        speak(slow_ahead, 2, "trainee-2");
    EXPECT_EQ(alert_of(0), AlertCondition::active_unacknowledged);
}

TEST_F(Hands, ThatAreNotHeardAtThePlaceTheyLeftAreAnAlert) {
    speak(heaving, 1);
    while (now < 10 + kHandSilent + 0.5)
        speak(slow_ahead, 2);
    EXPECT_EQ(alert_of(0), AlertCondition::active_unacknowledged);
    EXPECT_EQ(severity_of_lost(session), exercise::Severity::warning);
}

TEST_F(Hands, OfAnInstructorLeaveAHelmThatNobodyHadAsTheyFoundIt) {
    speak(slow_ahead, 1, "desk-1", true);
    let_go(1);
    nobody_speaks();
    EXPECT_EQ(count(session, "levers.lost"), 1) << "it is told all the same";
    EXPECT_EQ(severity_of_lost(session), exercise::Severity::info);
    EXPECT_EQ(alert_of(-1), std::nullopt);

    speak(slow_ahead, 2);
    speak(slow_ahead, 3, "desk-1", true);
    let_go(3);
    nobody_speaks(); // whose the helm was has left it meanwhile
    EXPECT_EQ(alert_of(-1), AlertCondition::active_unacknowledged);
}

TEST_F(SessionTest, WhoFallsSilentAtASecuredWindlassIsAnAlert) {
    Session session({}, options());
    give(session, exercise::Order{exercise::WindlassOrder{.brake = 1, .stopper_closed = true}}, 10,
         "trainee-1");
    for (int i = 0; i < 300; ++i)
        session.tick();
    hear_nothing(session, 10, 10.3 + kHandSilent);
    EXPECT_EQ(unattended(session), 1);
    EXPECT_EQ(severity_of_lost(session), exercise::Severity::warning);
}

TEST_F(SessionTest, InstructorsLeversAreHeardBeforeATraineesWhateverHisStrength) {
    Session session({}, options());
    test::give_as_instructor(session, levers(0.5), 10, "instructor");
    session.clear_news();
    give(session, levers(0), 10.05, "trainee-1"); // heard over the trainees' topic
    EXPECT_EQ(count(session, "levers.taken"), 0);
    EXPECT_TRUE(session.orders().empty());
    test::give_as_instructor(session, levers(0.5), 10.1, "instructor");
    hear_nothing(session, 10.1, 10.05 + kHandSilent);
    give(session, levers(0), 10.06 + kHandSilent, "trainee-1");
    EXPECT_EQ(count(session, "levers.taken"), 0);
    give(session, levers(0), 10.15 + kHandSilent, "trainee-1");
    EXPECT_EQ(text_of(session, "levers.taken"), "trainee-1 has the port windlass, taken from instructor");
    EXPECT_EQ(count(session, "levers.lost"), 0);
}

/// A hand heaves from wall time 10 s on, and speaks after each of these gaps (s); the server looks each 0.05
/// s. When it was heard last.
double speak(Session& session, std::initializer_list<double> gaps) {
    const exercise::Order heaving = exercise::WindlassOrder{.speed_lever = 0.5};
    double now = 10;
    give(session, heaving, now, "trainee-1");
    for (const double gap : gaps) {
        hear_nothing(session, now + 0.05, now + gap);
        give(session, heaving, now += gap, "trainee-1");
    }
    return now;
}

TEST_F(SessionTest, HandAtASlowComputerKeepsTheLeversAtAnyTimeScale) {
    for (const double scale : {1.0, 10.0}) {
        SessionOptions hurried = options();
        hurried.time_scale = scale;
        Session session({}, hurried);
        speak(session,
              {0.8, 0.05, 3.1, 0.05, 0.05, 4.9, 0.05, 2, 0.8}); // 3.1: as measured (hand_silence.hpp)
        EXPECT_EQ(count(session, "levers.lost"), 0) << scale;
        EXPECT_EQ(count(session, "levers.taken"), 1) << scale;
    }
}

TEST_F(SessionTest, HandThatDiesLosesTheLeversHoweverItSpokeBefore) {
    const auto lost_after = [this](std::initializer_list<double> gaps) {
        Session session({}, options());
        const double last = speak(session, gaps);
        double now = last;
        while (count(session, "levers.lost") == 0 && now < last + 10)
            session.carry_out({}, now += 0.05);
        return now - last;
    };
    EXPECT_NEAR(lost_after({0.05, 0.05, 0.05}), kHandSilent + 0.2, 0.1);
    EXPECT_NEAR(lost_after({1.1, 2.3, 2.3}), kHandSilent + 0.2, 0.1);
}

TEST_F(SessionTest, HandThatWasGivenUpHasTheLeversAgainWhenItSpeaks) {
    Session session({}, options());
    speak(session, {0.05, kHandSilent + 0.5});
    EXPECT_EQ(count(session, "levers.lost"), 1);
    EXPECT_EQ(count(session, "levers.taken"), 2);
}

TEST_F(SessionTest, TimeInWhichTheServerItselfDidNotRunIsNobodysSilence) {
    Session session({}, options());
    give(session, levers(0.5), 10, "trainee-1");
    session.carry_out({}, 60); // what he sent meanwhile has not been looked at yet
    EXPECT_EQ(count(session, "levers.lost"), 0);
}

TEST_F(SessionTest, HandThatLetsGoIsGoneAtOnceUnlessAnotherTakesTheLevers) {
    constexpr WriterKey kHis{1}, kOther{2};
    const auto let_go = [](Session& session, const WriterKey& writer) {
        Inbox inbox;
        inbox.orders.push_back({"trainee-1", levers(0.5), false, kHis});
        session.carry_out(inbox, 10);
        inbox.clear();
        inbox.left.push_back(writer);
        session.carry_out(inbox, 10.05);
    };
    Session session({}, options());
    let_go(session, kHis);
    hear_nothing(session, 10.1, 10.35);
    EXPECT_EQ(count(session, "levers.lost"), 1);

    Session taken({}, options());
    let_go(taken, kHis);
    taken.clear_news();
    give(taken, levers(0.5), 10.1, "trainee-2");
    // His station let go of what it saw another take, and was heard first.
    EXPECT_EQ(text_of(taken, "levers.taken"), "trainee-2 has the port windlass, taken from trainee-1");
    hear_nothing(taken, 10.1, 10.35);
    EXPECT_EQ(count(taken, "levers.lost"), 0);

    Session another({}, options());
    let_go(another, kOther);
    hear_nothing(another, 10.1, 10.35);
    EXPECT_EQ(count(another, "levers.lost"), 0);
}

TEST_F(SessionTest, HandWhoseWriterGoesAfterASilenceHasNotLetGo) {
    constexpr WriterKey kHis{1};
    Session session({}, options());
    Inbox inbox;
    inbox.orders.push_back({"trainee-1", levers(0.5), false, kHis});
    session.carry_out(inbox, 10);
    hear_nothing(session, 10.05, 14); // killed: DDS misses it after its lease
    inbox.clear();
    inbox.left.push_back(kHis);
    session.carry_out(inbox, 14.05);
    hear_nothing(session, 14.1, 14.4);
    EXPECT_EQ(text_of(session, "levers.lost"),
              "trainee-1 is no longer heard and nobody has the port windlass: speed lever at zero; brake, "
              "clutch and stopper as they were");
}

// Between the end of its time and the moment that is left to the next hand.
TEST_F(SessionTest, HandWhoseWriterGoesOnceItWasGivenUpIsGoneNoLater) {
    constexpr WriterKey kHis{1};
    Session session({}, options());
    Inbox inbox;
    inbox.orders.push_back({"trainee-1", levers(0.5), false, kHis});
    session.carry_out(inbox, 10);
    hear_nothing(session, 10.05, 10 + kHandSilent + 0.1);
    inbox.clear();
    inbox.left.push_back(kHis);
    session.carry_out(inbox, 10 + kHandSilent + 0.15);
    EXPECT_EQ(count(session, "levers.lost"), 0);
    session.carry_out({}, 10 + kHandSilent + 0.25);
    EXPECT_EQ(count(session, "levers.lost"), 1);
}

// Its program was held up for longer than DDS waits: what it says then is no late word of a writer that is
// there no more, and the levers do not fall out of its hand with each.
TEST_F(SessionTest, HandThatWasMissedAndIsThereAgainHoldsItsLevers) {
    constexpr WriterKey kHis{1};
    Session session({}, options());
    Inbox inbox;
    inbox.came.push_back(kHis);
    inbox.orders.push_back({"trainee-1", levers(0.5), false, kHis});
    session.carry_out(inbox, 10);
    inbox.clear();
    hear_nothing(session, 10.05, 15);
    inbox.left.push_back(kHis);
    session.carry_out(inbox, 15.05);
    hear_nothing(session, 15.1, 15.4);
    EXPECT_EQ(count(session, "levers.lost"), 1);

    session.clear_news();
    inbox.clear();
    inbox.came.push_back(kHis);
    session.carry_out(inbox, 16);
    inbox.clear();
    inbox.orders.push_back({"trainee-1", levers(0.5), false, kHis});
    for (double now = 16; now < 18; now += 0.05)
        session.carry_out(inbox, now);
    EXPECT_EQ(count(session, "levers.taken"), 1);
    EXPECT_EQ(count(session, "levers.lost"), 0);
}

TEST_F(SessionTest, NoMoreThanThreeSecondsOfExerciseAreHurriedOnTheWordOfAHandThatIsNotHeard) {
    for (const double scale : {0.5, 1.0, 2.0, 10.0, 20.0, 0.0}) {
        SessionOptions hurried = options();
        hurried.time_scale = scale;
        Session session({}, hurried);
        EXPECT_FALSE(session.hand_is_late()) << scale << ": nobody has them";
        const double last = speak(session, {0.05, 0.05});
        double now = last;
        while (!session.hand_is_late() && now < last + kHandSilent)
            session.carry_out({}, now += 0.01);
        if (scale <= 1 && scale > 0)
            EXPECT_FALSE(session.hand_is_late()) << scale << ": nothing is hurried";
        else
            EXPECT_NEAR((now - last) * (scale > 0 ? scale : 20), 3, 0.3) << scale;
        give(session, exercise::WindlassOrder{.speed_lever = 0.5}, now, "trainee-1");
        EXPECT_FALSE(session.hand_is_late()) << scale << ": heard again";
    }
}

} // namespace
} // namespace windlass::run
