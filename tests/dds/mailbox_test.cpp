// What clients send: refused with field, value and what is allowed, or turned into an order.

#include "common/text.hpp"
#include "server/dds/mailbox.hpp"
#include "server/exercise/definition/fault_order.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <thread>

namespace windlass::dds {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr wire::WriterId kWriter{1};
constexpr wire::WriterId kNextWriter{2};
const run::Limits kLimits{};

template <class T>
T from(T sample, std::uint64_t serial = 1, const char* source = "trainee-1") {
    sample.origin().source(source);
    sample.origin().serial(serial);
    return sample;
}

WindlassCommand levers(double brake, double speed = 0, std::uint64_t serial = 1) {
    WindlassCommand sample;
    sample.side(SIDE_PORT);
    sample.brake(brake);
    sample.speed_lever(speed);
    return from(sample, serial);
}

ExerciseCommand exercise_command(ExerciseAction action) {
    ExerciseCommand sample;
    sample.action(action);
    return from(sample);
}

FaultCommand fault(FaultCode code) {
    FaultCommand sample;
    sample.code(code);
    sample.severity(1);
    return from(sample);
}

TEST(Check, RefusalNamesTopicSourceFieldValueAndWhatIsAllowed) {
    const auto refused = refusal(levers(-1), kLimits);
    ASSERT_TRUE(refused);
    EXPECT_EQ(refused->text(), "WindlassCommand from trainee-1: brake = -1 refused; allowed: 0..1");
    EXPECT_EQ(refused->number, -1);
}

TEST(Check, BrakeThatIsNotANumberOrOutOfRangeIsRefused) {
    for (const double brake : {kNan, kInfinity, -kInfinity, 1e30, -1.0, 1.0000001}) {
        const auto refused = refusal(levers(brake), kLimits);
        ASSERT_TRUE(refused) << brake;
        EXPECT_EQ(refused->field, "brake");
        EXPECT_TRUE(std::isfinite(refused->number)); // it goes into an event
    }
    for (const double brake : {0.0, 0.4, 1.0})
        EXPECT_FALSE(refusal(levers(brake), kLimits)) << brake;
}

TEST(Check, SpeedLeverBeyondItsTravelIsRefused) {
    EXPECT_EQ(refusal(levers(0, 1.5), kLimits)->field, "speed_lever");
    EXPECT_EQ(refusal(levers(0, kNan), kLimits)->field, "speed_lever");
    EXPECT_FALSE(refusal(levers(0, -1), kLimits));
}

TEST(Check, SideWithoutACableIsRefused) {
    auto sample = levers(0);
    sample.side(SIDE_STARBOARD);
    EXPECT_EQ(refusal(sample, kLimits)->field, "side");
    EXPECT_FALSE(refusal(sample, run::Limits{.side_present = {true, true}}));
    sample.side(7);
    EXPECT_EQ(refusal(sample, run::Limits{.side_present = {true, true}})->value, "7");
}

TEST(Check, HelmIsHeldToTheShipsRudder) {
    HelmCommand sample = from(HelmCommand{});
    sample.rudder(0.5);
    EXPECT_FALSE(refusal(sample, run::Limits{.rudder_max = 0.6}));
    EXPECT_EQ(refusal(sample, run::Limits{.rudder_max = 0.4})->field, "rudder");
    sample.rudder(0);
    sample.stern_thruster(kNan);
    EXPECT_EQ(refusal(sample, kLimits)->field, "stern_thruster");
}

TEST(Check, SenderNeedsANameInPlainTextAndASerial) {
    EXPECT_EQ(refusal(from(levers(0), 1, ""), kLimits)->field, "origin.source");
    EXPECT_EQ(refusal(from(levers(0), 1, "a\x1b[2J"), kLimits)->field, "origin.source");
    EXPECT_EQ(refusal(from(levers(0), 0), kLimits)->field, "origin.serial");
    EXPECT_EQ(refusal(from(levers(0), 1, "server"), kLimits)->field, "origin.source"); // an impostor
}

TEST(Check, FaultThatThereIsNotIsRefused) {
    for (int code = 0; code < exercise::kFaultCodes; ++code)
        EXPECT_FALSE(refusal(fault(static_cast<FaultCode>(code)), kLimits)) << code;
    EXPECT_EQ(refusal(fault(static_cast<FaultCode>(4000000000U)), kLimits)->field, "code");
}

TEST(Check, FaultTriggerNeedsAValueThatFits) {
    auto sample = fault(FAULT_MOTOR_POWER_LOST);
    sample.trigger(TRIGGER_AT_CABLE_OUT);
    sample.trigger_value(60);
    EXPECT_FALSE(refusal(sample, kLimits));
    for (const double value : {kNan, -1.0, 1e30}) {
        sample.trigger_value(value);
        EXPECT_EQ(refusal(sample, kLimits)->field, "trigger_value") << value;
    }
    sample.severity(1.1);
    EXPECT_EQ(refusal(sample, kLimits)->field, "severity");
    sample.clear(true); // only code and side count then
    EXPECT_FALSE(refusal(sample, kLimits));
}

TEST(Check, TimeScaleIsHeldToItsRange) {
    auto sample = exercise_command(EXERCISE_TIME_SCALE);
    for (const double scale : {0.1, 1.0, 20.0, 0.0}) {
        sample.time_scale(scale);
        EXPECT_FALSE(refusal(sample, kLimits)) << scale;
    }
    for (const double scale : {kNan, -1.0, 0.05, 21.0, 1e30}) {
        sample.time_scale(scale);
        EXPECT_EQ(refusal(sample, kLimits)->field, "time_scale") << scale;
    }
    sample.time_scale(0);
    EXPECT_TRUE(refusal(sample, run::Limits{.unpaced = false}));
}

/// Weather that the model can have.
EnvironmentCommand fair() {
    EnvironmentCommand sample = from(EnvironmentCommand{});
    sample.weather().gust_factor(1);
    sample.weather().visibility(20000);
    return sample;
}

TEST(Check, EnvironmentIsHeldToItsRange) {
    auto sample = fair();
    sample.weather().wind_speed(60);
    sample.weather().current_speed(5);
    sample.ramp(600);
    EXPECT_FALSE(refusal(sample, kLimits));
    sample.weather().wind_speed(60.1);
    EXPECT_EQ(refusal(sample, kLimits)->field, "weather.wind_speed");
    sample.weather().wind_speed(10);
    sample.weather().current_towards(kNan);
    EXPECT_EQ(refusal(sample, kLimits)->field, "weather.current_towards");
    sample.weather().current_towards(0);
    sample.ramp(-1);
    EXPECT_EQ(refusal(sample, kLimits)->field, "ramp");
}

TEST(Check, LayersOfTheCurrentGoDownwards) {
    auto sample = fair();
    sample.weather().current_profile().resize(2);
    sample.weather().current_profile()[0].depth(10);
    sample.weather().current_profile()[1].depth(20);
    EXPECT_FALSE(refusal(sample, kLimits));
    sample.weather().current_profile()[1].depth(10);
    EXPECT_EQ(refusal(sample, kLimits)->field, "weather.current_profile.depth");
}

TEST(Check, TideIsHeldToItsRange) {
    auto sample = fair();
    for (const double height : {-5.0, 3.5, 20.0}) {
        sample.weather().tide_height(height);
        EXPECT_FALSE(refusal(sample, kLimits)) << height;
    }
    for (const double height : {-5.1, 20.1, std::nan("")}) {
        sample.weather().tide_height(height);
        const auto refused = refusal(sample, kLimits);
        ASSERT_TRUE(refused) << height;
        EXPECT_EQ(refused->field, std::string("weather.tide_height"));
        EXPECT_EQ(refused->allowed, "-5..20 m");
    }
}

TEST(Check, WavesAndGustsAreHeldToTheirRanges) {
    const auto field = [](const std::function<void(Weather&)>& ask) {
        auto sample = fair();
        ask(sample.weather());
        const auto refused = refusal(sample, kLimits);
        return refused ? std::string(refused->field) : std::string();
    };
    EXPECT_EQ(field([](Weather& w) { w.wave_height(2), w.wave_period(7); }), "");
    EXPECT_EQ(field([](Weather& w) { w.swell_height(3), w.swell_period(14); }), "");
    EXPECT_EQ(field([](Weather& w) { w.gust_factor(1.5), w.gust_period(60); }), "");
    EXPECT_EQ(field([](Weather& w) { w.wave_height(16), w.wave_period(20); }), "weather.wave_height");
    EXPECT_EQ(field([](Weather& w) { w.swell_height(kNan); }), "weather.swell_height");
    EXPECT_EQ(field([](Weather& w) { w.gust_factor(0.9); }), "weather.gust_factor");
    EXPECT_EQ(field([](Weather& w) { w.gust_period(-1); }), "weather.gust_period");
    // 3 m of 5 s: 39 m long, and so steeper than water stands.
    EXPECT_EQ(field([](Weather& w) { w.wave_height(3), w.wave_period(5); }), "weather.wave_period");
    EXPECT_EQ(field([](Weather& w) { w.swell_height(0.1), w.swell_period(0); }), "weather.swell_period");
}

TEST(Check, FaultTriggersNeedWhatTheyWaitFor) {
    auto sample = fault(FAULT_MOTOR_POWER_LOST);
    sample.trigger(TRIGGER_AT_EVENT);
    EXPECT_EQ(refusal(sample, kLimits)->field, "trigger_event");
    sample.trigger_event("anchor.letgo");
    ASSERT_TRUE(refusal(sample, kLimits));
    EXPECT_EQ(refusal(sample, kLimits)->value, "\"anchor.letgo\"");
    EXPECT_NE(refusal(sample, kLimits)->allowed.find("the nearest is \"anchor.let_go\""), std::string::npos);
    sample.trigger_event("levers.taken"); // of the session: no fault hears it
    EXPECT_EQ(refusal(sample, kLimits)->field, "trigger_event");
    sample.trigger_event("anchor.let_go");
    EXPECT_FALSE(refusal(sample, kLimits));
    sample.trigger(TRIGGER_AT_CHANCE);
    sample.trigger_value(900);
    sample.trigger_until(600);
    EXPECT_EQ(refusal(sample, kLimits)->field, "trigger_until");
    sample.trigger_until(1200);
    EXPECT_FALSE(refusal(sample, kLimits));
    sample.trigger(TRIGGER_AT_ORDER);
    sample.trigger_order(99);
    EXPECT_EQ(refusal(sample, kLimits)->field, "trigger_order");
    sample.trigger_order(BRIDGE_ORDER_HEAVE);
    sample.ramp(kNan);
    EXPECT_EQ(refusal(sample, kLimits)->field, "ramp");
}

TEST(Check, BridgeOrderThatSaysNothingIsRefused) {
    auto sample = from(BridgeOrderCommand{});
    EXPECT_EQ(refusal(sample, kLimits)->field, "text");
    sample.code(BRIDGE_ORDER_HOLD_ON);
    sample.value(6);
    EXPECT_FALSE(refusal(sample, kLimits));
    sample.value(kNan);
    EXPECT_EQ(refusal(sample, kLimits)->field, "value");
    sample.value(0);
    EXPECT_FALSE(refusal(sample, kLimits)) << "hold on where you are";
    sample.code(BRIDGE_ORDER_PAY_OUT);
    EXPECT_EQ(refusal(sample, kLimits)->field, "value") << "pay out to nothing";
    sample.code(BRIDGE_ORDER_HEAVE_TO);
    EXPECT_EQ(refusal(sample, kLimits)->field, "value");
    sample.value(2);
    EXPECT_FALSE(refusal(sample, kLimits));
    sample.value(0);
    sample.code(BRIDGE_ORDER_CANCEL);
    EXPECT_EQ(refusal(sample, kLimits)->field, "cancels");
}

TEST(Check, WatchCircleIsHeldToItsRange) {
    auto sample = from(WatchCircle{});
    EXPECT_FALSE(refusal(sample, kLimits)); // no watch
    sample.kept(true);
    EXPECT_EQ(refusal(sample, kLimits)->field, "radius");
    sample.radius(300);
    EXPECT_FALSE(refusal(sample, kLimits));
    sample.y(kInfinity);
    EXPECT_EQ(refusal(sample, kLimits)->field, "y");
}

TEST(Check, ForeignShipIsAUnitUprightFiniteAndInRealTime) {
    const auto afloat = [] {
        auto sample = from(OwnShipInput{});
        sample.attitude().w(1);
        return sample;
    };
    EXPECT_FALSE(refusal(afloat(), kLimits));
    EXPECT_EQ(refusal(from(OwnShipInput{}), kLimits)->field, "attitude"); // all 0
    auto sample = afloat();
    sample.attitude().z(0.1); // longer than 1
    EXPECT_EQ(refusal(sample, kLimits)->field, "attitude");
    sample = afloat();
    sample.attitude().w(0), sample.attitude().x(1); // keel up
    EXPECT_EQ(refusal(sample, kLimits)->field, "attitude");
    sample = afloat();
    sample.position().x(kNan);
    EXPECT_EQ(refusal(sample, kLimits)->field, "position.x");
    sample = afloat();
    sample.velocity().y(31);
    EXPECT_EQ(refusal(sample, kLimits)->field, "velocity");
    sample = afloat();
    sample.angular_velocity().z(kInfinity);
    EXPECT_EQ(refusal(sample, kLimits)->field, "angular_velocity");
    sample = afloat();
    sample.time(kNan);
    EXPECT_EQ(refusal(sample, kLimits)->field, "time");
    run::Limits hurried = kLimits;
    hurried.time_scale = 4;
    EXPECT_NE(refusal(afloat(), hurried)->allowed.find("it is 4"), std::string::npos);
}

TEST(Check, AssessorsWordNeedsANoteThatSaysWhy) {
    AssessmentCommand word;
    word.criterion("fall");
    word.verdict(VERDICT_POINTS);
    word.milli(500);
    word.note("too short");
    EXPECT_EQ(refusal(from(word), kLimits)->field, "note");
    word.note("the lever was stiff");
    EXPECT_FALSE(refusal(from(word), kLimits));
    word.milli(1001);
    EXPECT_EQ(refusal(from(word), kLimits)->field, "milli");
    word.milli(1000);
    word.criterion("");
    EXPECT_EQ(refusal(from(word), kLimits)->field, "criterion");
    word.verdict(VERDICT_CONFIRMED);
    EXPECT_FALSE(refusal(from(word), kLimits));
    word.verdict(VERDICT_ENDED);
    EXPECT_EQ(refusal(from(word), kLimits)->field, "verdict") << "that is the server's to say";
}

TEST(Check, ExerciseOutsideTheFolderIsRefused) {
    auto sample = exercise_command(EXERCISE_LOAD);
    sample.exercise("let-go-port-25m.json");
    EXPECT_FALSE(refusal(sample, kLimits));
    for (const char* name : {"", "/etc/passwd", "../secret.json", "a/../../b", "a\nb"}) {
        sample.exercise(name);
        EXPECT_EQ(refusal(sample, kLimits)->field, "exercise") << name;
    }
}

TEST(Check, ActionThatIsUnknownAndRestoreToBeforeTheStartAreRefused) {
    auto restore = exercise_command(EXERCISE_RESTORE);
    restore.restore_time(20);
    EXPECT_FALSE(refusal(restore, kLimits));
    restore.restore_time(-1);
    EXPECT_EQ(refusal(restore, kLimits)->field, "restore_time");
    EXPECT_EQ(refusal(exercise_command(static_cast<ExerciseAction>(99)), kLimits)->value, "99");
}

TEST(Check, ReportWithControlCharactersIsRefused) {
    Report sample = from(Report{});
    sample.side(-1);
    sample.text("3 shackles on deck, Käpt'n");
    EXPECT_FALSE(refusal(sample, kLimits));
    sample.text("\x1b]0;owned\x07");
    EXPECT_EQ(refusal(sample, kLimits)->field, "text");
    EXPECT_EQ(refusal(sample, kLimits)->value, "\"?]0;owned?\"");
}

TEST(Text, IsClippedAtAWholeCharacter) {
    EXPECT_EQ(clipped("aä", 3), "aä");
    EXPECT_EQ(clipped("aä", 2), "a");
    EXPECT_EQ(printable("a\xff\xc2\x9b"
                        "b"),
              "a??b");
}

TEST(Mailbox, OrdersComeOutOnceInOrderOfArrival) {
    Mailbox mailbox;
    mailbox.put(levers(0.25, 0, 1), kWriter);
    mailbox.put(levers(0.5, -0.5, 2), kWriter);
    run::Inbox inbox;
    mailbox.drain(kLimits, inbox);
    ASSERT_EQ(inbox.orders.size(), 2U);
    const auto& last = std::get<exercise::WindlassOrder>(std::get<exercise::Order>(inbox.orders[1].what));
    EXPECT_EQ(inbox.orders[1].source, "trainee-1");
    EXPECT_EQ(last.brake, 0.5);
    EXPECT_EQ(last.speed_lever, -0.5);
    mailbox.drain(kLimits, inbox);
    EXPECT_TRUE(inbox.orders.empty());
}

TEST(Mailbox, StaleSerialIsRefused) {
    Mailbox mailbox;
    run::Inbox inbox;
    for (const std::uint64_t serial : {5U, 5U, 4U, 6U})
        mailbox.put(levers(0.5, 0, serial), kWriter);
    mailbox.drain(kLimits, inbox);
    EXPECT_EQ(inbox.orders.size(), 2U);
    ASSERT_EQ(inbox.refusals.size(), 2U);
    EXPECT_EQ(
        inbox.refusals[1].text(),
        "WindlassCommand from trainee-1: origin.serial = 4 refused; allowed: above 5, the last one accepted");
}

TEST(Mailbox, RefusedSampleDoesNotUseUpItsSerial) {
    Mailbox mailbox;
    run::Inbox inbox;
    mailbox.put(levers(kNan, 0, 9), kWriter);
    mailbox.put(levers(0.5, 0, 3), kWriter);
    mailbox.drain(kLimits, inbox);
    EXPECT_EQ(inbox.refusals.size(), 1U);
    EXPECT_EQ(inbox.orders.size(), 1U);
}

TEST(Mailbox, RestartedClientCountsFromOneAgain) {
    Mailbox mailbox;
    run::Inbox inbox;
    mailbox.put(levers(0.5, 0, 1000), kWriter);
    mailbox.put(levers(0.6, 0, 1), kNextWriter);
    mailbox.drain(kLimits, inbox);
    EXPECT_EQ(inbox.orders.size(), 2U);
}

TEST(Mailbox, ClockOfASenderShutsNobodyOut) {
    const auto sent_at = [](std::int64_t time, std::uint64_t serial) {
        auto sample = levers(0.5, 0, serial);
        sample.origin().sent_unix_ns(time);
        return sample;
    };
    Mailbox mailbox;
    run::Inbox inbox;
    mailbox.put(sent_at(std::numeric_limits<std::int64_t>::max(), 1),
                kWriter);                       // its clock is centuries ahead
    mailbox.put(sent_at(2000, 2), kWriter);     // and has been set right
    mailbox.put(sent_at(1000, 1), kNextWriter); // the client of this name, started anew
    mailbox.drain(kLimits, inbox);
    EXPECT_EQ(inbox.orders.size(), 3U);
    EXPECT_TRUE(inbox.refusals.empty());
}

TEST(Mailbox, TopicsOfOneClientCountApart) {
    Mailbox mailbox;
    run::Inbox inbox;
    mailbox.put(levers(0.5, 0, 7), kWriter);
    mailbox.put(from(HelmCommand{}, 3), kWriter);
    mailbox.drain(kLimits, inbox);
    EXPECT_EQ(inbox.orders.size(), 2U);
}

TEST(Mailbox, FloodFillsItAndTheRestIsCounted) {
    Mailbox mailbox(8);
    std::thread flood([&] {
        for (std::uint64_t serial = 1; serial <= 100; ++serial)
            mailbox.put(levers(0.5, 0, serial), kWriter);
    });
    flood.join();
    run::Inbox inbox;
    mailbox.drain(kLimits, inbox);
    EXPECT_EQ(inbox.orders.size(), 8U);
    EXPECT_EQ(inbox.overflow, 92U);
    mailbox.put(levers(0.1, 0, 101), kWriter);
    mailbox.drain(kLimits, inbox);
    EXPECT_EQ(inbox.orders.size(), 1U); // it takes orders again
    EXPECT_EQ(inbox.overflow, 0U);
}

TEST(Mailbox, OfStatesThatAreBroughtOneWaitsAtMost) {
    Mailbox mailbox;
    for (std::uint8_t writer = 1; writer <= 5; ++writer) {
        RestoreCommand large;
        large.checkpoint().resize(100'000);
        mailbox.put(from(large, 1), {writer});
    }
    mailbox.put(levers(0.5, 0, 1), kWriter); // other orders go on
    run::Inbox inbox;
    mailbox.drain(kLimits, inbox);
    EXPECT_EQ(inbox.orders.size(), 2U);
    EXPECT_EQ(inbox.overflow, 4U);
}

TEST(Serials, ForgetTheSenderNotHeardForLongest) {
    Serials serials;
    serials.accept(0, kWriter, "keeps talking", 5);
    serials.accept(0, kWriter, "silent", 5);
    for (int i = 0; i < 300; ++i) {
        serials.accept(0, kWriter, "visitor " + std::to_string(i), 1);
        serials.accept(0, kWriter, "keeps talking", 6 + static_cast<std::uint64_t>(i));
    }
    EXPECT_EQ(serials.accept(0, kWriter, "keeps talking", 305), 305U);
    EXPECT_EQ(serials.accept(0, kWriter, "silent", 1), std::nullopt);
}

TEST(Serials, OfOneKindAreNotForgottenInAFloodOfAnother) {
    Serials serials;
    serials.accept(0, kWriter, "trainee-1", 5);
    for (int i = 0; i < 1000; ++i)
        serials.accept(5, kWriter, "flood " + std::to_string(i), 1);
    EXPECT_EQ(serials.accept(0, kWriter, "trainee-1", 4), 5U);
}

TEST(Mailbox, WriterThatIsGoneIsToldOnceBehindItsLastOrders) {
    Mailbox mailbox;
    run::Inbox inbox;
    mailbox.put(levers(0.5), kWriter);
    mailbox.leave(kWriter);
    EXPECT_FALSE(mailbox.empty());
    mailbox.drain(kLimits, inbox);
    ASSERT_EQ(inbox.orders.size(), 1U);
    EXPECT_EQ(inbox.orders[0].writer, kWriter);
    EXPECT_EQ(inbox.left, std::vector{kWriter});
    mailbox.drain(kLimits, inbox);
    EXPECT_TRUE(inbox.left.empty());
    for (int i = 0; i < 1000; ++i)
        mailbox.leave(kNextWriter);
    mailbox.drain(kLimits, inbox);
    EXPECT_LE(inbox.left.size(), 256U);
}

} // namespace
} // namespace windlass::dds
