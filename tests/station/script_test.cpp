// Scripts: what a file may say, when a step's time has come, and how a script fails.

#include "common/json_file.hpp"
#include "trainee_client/player.hpp"
#include "trainee_client/progress.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace windlass::trainee {
namespace {

using station::Clock;
using station::Picture;
using testing::HasSubstr;

/// A script file that goes with the test.
class File {
public:
    explicit File(const std::string& text)
        : path_{std::filesystem::temp_directory_path() /
                ("windlass-script-" + std::to_string(getpid()) + ".json")} {
        std::ofstream{path_} << text;
    }
    ~File() { std::filesystem::remove(path_); }
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

Script script(const std::string& text) {
    return load_script(File{text}.path(), Eyes::coach);
}

/// A running exercise at that time with a port windlass at rest.
Picture picture_at(double time) {
    const auto now = Clock::now();
    Picture picture;
    ExerciseStatus status;
    status.time(time);
    status.state(RUN_RUNNING);
    picture.receive(status, now);
    WindlassLoad load;
    load.time(time);
    load.brake_position(1);
    picture.receive(load, now);
    ChainState chain;
    picture.receive(chain, now);
    AnchorState anchor;
    anchor.phase(ANCHOR_HANGING);
    picture.receive(anchor, now);
    picture.receive(ShipState{}, now);
    return picture;
}

Condition condition(const std::string& when) {
    return script(R"({"steps": [{"when": )" + when + "}]}").steps.at(0).when;
}

TEST(Script, ReadsEveryLeverReportAndTime) {
    const Script read = script(R"({
        "title": "all", "side": "starboard", "timeout": 60,
        "steps": [
            {"do": {"brake": 0.4, "speed_lever": -0.5, "clutch": "in", "stopper": "off", "emergency_stop": true,
                    "engine": -0.25, "rudder_deg": 90e-1, "bow_thruster": 0.1, "stern_thruster": -0.2}},
            {"report": {"code": "shackles_in_water", "value": 3, "text": "three in the water"}, "timeout": 5,
             "say": "three shackles"},
            {"show": {"anchor_ball": true, "anchor_lights": false}}]})");
    EXPECT_EQ(read.title, "all");
    EXPECT_EQ(read.side, SIDE_STARBOARD);
    ASSERT_EQ(read.steps.size(), 3U);
    EXPECT_EQ(read.steps[0].timeout, 60);
    EXPECT_EQ(read.steps[1].timeout, 5);
    EXPECT_EQ(read.steps[1].report->code, REPORT_SHACKLES_IN_WATER);
    EXPECT_EQ(read.steps[1].report->value, 3);
    EXPECT_EQ(read.steps[1].report->text, "three in the water");
    EXPECT_EQ(read.steps[1].say, "three shackles");
    EXPECT_EQ(read.steps[1].report->lead, 0); // what is not given stays open
    EXPECT_EQ(read.steps[1].report->stay, STAY_NOT_GIVEN);
    EXPECT_FALSE(read.steps[1].show);
    ASSERT_TRUE(read.steps[2].show);
    EXPECT_TRUE(read.steps[2].show->anchor_ball);
    EXPECT_FALSE(read.steps[2].show->anchor_lights);

    station::LeverSet set;
    set.windlass.stopper_closed = true;
    read.steps[0].orders.apply(set);
    EXPECT_EQ(set.windlass, (station::WindlassLevers{.brake = 0.4,
                                                     .speed_lever = -0.5,
                                                     .clutch_in = true,
                                                     .stopper_closed = false,
                                                     .emergency_stop = true}));
    EXPECT_DOUBLE_EQ(set.helm.engine, -0.25);
    EXPECT_NEAR(set.helm.rudder, 0.15708, 1e-5);
    EXPECT_EQ(set.helm.bow_thruster, 0.1);
    EXPECT_EQ(set.helm.stern_thruster, -0.2);
}

TEST(Script, LeversNotOrderedStay) {
    station::LeverSet set;
    set.windlass = {
        .brake = 0.7, .speed_lever = 0.2, .clutch_in = true, .stopper_closed = true, .emergency_stop = true};
    set.helm = {.engine = 0.3, .rudder = 0.1, .bow_thruster = 0.2, .stern_thruster = 0.4};
    const station::LeverSet before = set;
    script(R"({"steps": [{"do": {"brake": 0.1}}]})").steps[0].orders.apply(set);
    EXPECT_EQ(set.windlass.brake, 0.1);
    set.windlass.brake = before.windlass.brake;
    EXPECT_EQ(set.windlass, before.windlass);
    EXPECT_EQ(set.helm, before.helm);
}

struct BadScript {
    const char* name;
    const char* text;
    const char* pointer;
    const char* complaint;
};
void PrintTo(const BadScript& bad, std::ostream* out) {
    *out << bad.text;
}

class RefusedScript : public testing::TestWithParam<BadScript> {};

TEST_P(RefusedScript, IsNamedWithFilePointerAndWhatIsAllowed) {
    const File file{GetParam().text};
    try {
        load_script(file.path(), Eyes::coach);
        FAIL() << "was taken";
    } catch (const ConfigError& error) {
        EXPECT_THAT(error.what(), HasSubstr(file.path().string()));
        EXPECT_THAT(error.what(), HasSubstr(GetParam().pointer));
        EXPECT_THAT(error.what(), HasSubstr(GetParam().complaint));
    }
}

INSTANTIATE_TEST_SUITE_P(
    Bad, RefusedScript,
    testing::Values(
        BadScript{"BrakeBelowOpen", R"({"steps": [{"do": {"brake": -1}}]})", "/steps/0/do/brake",
                  "from 0 to 1"},
        BadScript{"BrakeBeyondHardOn", R"({"steps": [{"say": "a"}, {"do": {"brake": 1.01}}]})",
                  "/steps/1/do/brake", "1.01"},
        BadScript{"HugeNumber", R"({"steps": [{"do": {"engine": 1e999}}]})", "", "1e999"},
        BadScript{"MisspeltLever", R"({"steps": [{"do": {"brke": 1}}]})", "/steps/0/do/brke", "\"brake\""},
        BadScript{"MisspeltField", R"({"steps": [{"wen": {}}]})", "/steps/0/wen", "\"when\""},
        BadScript{"WordForClutch", R"({"steps": [{"do": {"clutch": "engaged"}}]})", "/steps/0/do/clutch",
                  "\"in\""},
        BadScript{"BoolForStopper", R"({"steps": [{"do": {"stopper": true}}]})", "/steps/0/do/stopper",
                  "\"on\""},
        BadScript{"UnknownPhase", R"({"steps": [{"when": {"anchor_phase": "sunk"}}]})",
                  "/steps/0/when/anchor_phase", "on_bottom"},
        BadScript{"TextForNumber", R"({"steps": [{"when": {"cable_out": "60 m"}}]})",
                  "/steps/0/when/cable_out", "a number"},
        BadScript{"UnknownBound", R"({"steps": [{"when": {"tension": {"over": 1}}}]})",
                  "/steps/0/when/tension/over", "above"},
        BadScript{"EmptyBounds", R"({"steps": [{"when": {"tension": {}}}]})", "/steps/0/when/tension",
                  "1 or more fields"},
        BadScript{"TextForBound", R"({"steps": [{"when": {"tension": {"above": "1 MN"}}}]})",
                  "/steps/0/when/tension/above: \"1 MN\" is not allowed",
                  "a number (N, cable tension at the hawse pipe (the truth: needs --coach))"},
        BadScript{
            "WordForNumber", R"({"steps": [{"when": {"counter": true}}]})",
            "/steps/0/when/counter: true is not allowed: a number or an object {...} of 1 or more fields",
            "(m of cable out by the chain counter, where one is fitted; a number alone means at least "
            "that, {\"above\": x, \"below\": y} gives bounds)"},
        BadScript{"UnknownOrder", R"({"steps": [{"when": {"order": "let_fly"}}]})",
                  "/steps/0/when/order: \"let_fly\" is not allowed: one of \"text\", \"stand_by\"",
                  "(the bridge has given this order, and it waits to be repeated back)"},
        BadScript{"UnknownOrderRepeated",
                  R"({"steps": [{"report": {"code": "order_repeated", "order": "let_fly"}}]})",
                  "/steps/0/report/order", "\"let_go\""},
        BadScript{"SeatEventWithBlanks", R"({"steps": [{"when": {"seat_event": "let go"}}]})",
                  "/steps/0/when/seat_event", "matching ^[a-z_]+(\\.[a-z_]+)+$ (code of an event noticed"},
        BadScript{"EventWithBlanks", R"({"steps": [{"when": {"event": "brought up"}}]})",
                  "/steps/0/when/event", "code of an event"},
        BadScript{"UnknownReport", R"({"steps": [{"report": {"code": "done"}}]})", "/steps/0/report/code",
                  "brought_up"},
        BadScript{"ReportWithoutCode", R"({"steps": [{"report": {"value": 1}}]})", "/steps/0/report/code",
                  "missing"},
        BadScript{"NegativeTimeout", R"({"steps": [{"timeout": -1}]})", "/steps/0/timeout", "above 0"},
        BadScript{"EmptyStep", R"({"steps": [{}]})", "/steps/0", "1 or more fields"},
        BadScript{"NoSteps", R"({"title": "none"})", "/steps", "missing"},
        BadScript{"EmptySteps", R"({"steps": []})", "/steps", ""},
        BadScript{"StepsNoList", R"({"steps": {"do": {}}})", "/steps", "a list"},
        BadScript{"NotJson", "{\"steps\": [\n  {]}", "line 2", "not JSON"},
        BadScript{"EmptyFile", "", "line 1", "not JSON"},
        BadScript{"LeverGivenTwice", R"({"steps": [{"do": {"brake": 0, "brake": 1}}]})", "brake", "twice"}),
    [](const auto& test) { return test.param.name; });

TEST(Script, MissingFileIsNamed) {
    EXPECT_THAT([] { load_script("/nowhere/let_go.json", Eyes::seat); },
                testing::ThrowsMessage<ConfigError>(HasSubstr("/nowhere/let_go.json")));
}

/// What load_script says of it for a trainee; empty: taken.
std::string refusal_at_a_seat(const std::string& text) {
    const File file{text};
    try {
        load_script(file.path(), Eyes::seat);
    } catch (const ConfigError& error) {
        return error.what();
    }
    return "";
}

TEST(Script, OfASeatLooksAtNoTruth) {
    const std::string told = refusal_at_a_seat(R"({"steps": [
        {"when": {"counter_shackles": 2, "clutch": "in"}},
        {"when": {"anchor_on_bottom": true}}, {"when": {"shackles": 6, "event": "anchor.brought_up"}}]})");
    for (const char* part : {".json: /steps/1/when/anchor_on_bottom: this is the truth", "--coach",
                             "/steps/2/when/shackles", "(counter_shackles)", "/steps/2/when/event"})
        EXPECT_THAT(told, HasSubstr(part));
    EXPECT_THAT(told, testing::Not(HasSubstr("/steps/0")));
    EXPECT_EQ(refusal_at_a_seat(R"({"steps": [{"when": {
        "after": 1, "time": 2, "counter": 1, "counter_shackles": 1, "counter_speed": {"below": 1}, "load_cell": 1,
        "cable_speed_seen": {"above": 0}, "brake_position": {"below": 1}, "speed_by_gps": {"below": 1},
        "speed_by_log": {"above": -1}, "clutch": "out", "stopper": "on", "seat_event": "anchor.let_go",
        "order": "let_go"}}]})"),
              "");
}

TEST(Script, EachQuantityIsOfASeatOrOfACoach) {
    for (const Quantity& quantity : quantities()) {
        const std::string told =
            refusal_at_a_seat(std::string{R"({"steps": [{"when": {")"} + quantity.name + R"(": 1}}]})");
        EXPECT_EQ(told.empty(), quantity.eyes == Eyes::seat) << quantity.name;
    }
}

TEST(Script, OfAMateHasNoSteps) {
    EXPECT_TRUE(script(R"({"mate": true, "steps": []})").mate);
    EXPECT_EQ(script(R"({"mate": true, "steps": []})").repeats_orders, 2);
    for (const char* neither : {R"({"steps": []})", R"({"mate": true, "steps": [{"say": "I do it"}]})"})
        EXPECT_THAT([&] { script(neither); }, testing::ThrowsMessage<ConfigError>(HasSubstr("/steps: ")));
}

TEST(Script, OfABridgeGivesOrders) {
    const Script read =
        script(R"({"steps": [{"order": {"code": "pay_out", "value": 2, "side": "starboard"}}]})");
    EXPECT_TRUE(read.conns);
    EXPECT_EQ(read.steps.at(0).order->code, BRIDGE_ORDER_PAY_OUT);
    EXPECT_EQ(read.steps.at(0).order->value, 2);
    EXPECT_EQ(read.steps.at(0).order->side, SIDE_STARBOARD);
    EXPECT_FALSE(script(R"({"steps": [{"say": "nothing"}]})").conns);
}

TEST(Script, EveryShippedScriptLoads) {
    int scripts = 0;
    for (const auto& entry : std::filesystem::directory_iterator{WINDLASS_SCRIPTS_DIR}) {
        SCOPED_TRACE(entry.path());
        EXPECT_NO_THROW({
            const Script read = load_script(entry.path(), Eyes::coach);
            EXPECT_EQ(read.steps.empty(), read.mate);
        });
        ++scripts;
    }
    EXPECT_GT(scripts, 0);
}

TEST(Condition, EveryQuantityOfTheCodeIsInTheSchema) {
    for (const Quantity& quantity : quantities()) {
        SCOPED_TRACE(quantity.name);
        const Condition when =
            condition(std::string{"{\""} + quantity.name + R"(": {"above": 1, "below": 2}})");
        ASSERT_EQ(when.bounds.size(), 1U);
        EXPECT_EQ(when.bounds[0].quantity, &quantity);
        EXPECT_EQ(when.bounds[0].above, 1);
        EXPECT_EQ(when.bounds[0].below, 2);
    }
}

TEST(Condition, NumberAloneIncludesItsLimitAndBoundsDoNot) {
    Picture picture = picture_at(0);
    ChainState chain;
    chain.cable_out(60);
    picture.receive(chain, Clock::now());
    EXPECT_TRUE(condition(R"({"cable_out": 60})").holds(picture, SIDE_PORT, 0));
    EXPECT_FALSE(condition(R"({"cable_out": {"above": 60}})").holds(picture, SIDE_PORT, 0));
    EXPECT_FALSE(condition(R"({"cable_out": {"below": 60}})").holds(picture, SIDE_PORT, 0));
    EXPECT_TRUE(condition(R"({"cable_out": {"above": 59, "below": 61}})").holds(picture, SIDE_PORT, 0));
}

TEST(Condition, WhatHasNotBeenHeardDoesNotHold) {
    const Picture nothing;
    for (const Quantity& quantity : quantities()) {
        SCOPED_TRACE(quantity.name);
        const Condition when =
            condition(std::string{"{\""} + quantity.name + R"(": {"above": -1e9, "below": 1e9}})");
        EXPECT_FALSE(when.holds(nothing, SIDE_PORT, 0));
        EXPECT_THAT(when.unmet(nothing, SIDE_PORT, 0), HasSubstr("not heard yet"));
    }
    EXPECT_FALSE(condition(R"({"anchor_phase": "housed"})").holds(nothing, SIDE_PORT, 0));
    EXPECT_FALSE(condition(R"({"anchor_on_bottom": false})").holds(nothing, SIDE_PORT, 0));
    EXPECT_FALSE(condition(R"({"clutch": "out"})").holds(nothing, SIDE_PORT, 0));
    EXPECT_FALSE(condition(R"({"stopper": "off"})").holds(nothing, SIDE_PORT, 0));
}

TEST(Condition, LooksAtItsOwnSide) {
    Picture picture = picture_at(0);
    ChainState starboard;
    starboard.side(SIDE_STARBOARD);
    starboard.cable_out_shackles(5);
    picture.receive(starboard, Clock::now());
    const Condition when = condition(R"({"shackles": 4})");
    EXPECT_TRUE(when.holds(picture, SIDE_STARBOARD, 0));
    EXPECT_FALSE(when.holds(picture, SIDE_PORT, 0));
}

TEST(Condition, AnchorIsOnTheBottomFromLandingUntilItIsBrokenOut) {
    const Condition when = condition(R"({"anchor_on_bottom": true})");
    for (const auto phase : {ANCHOR_HOUSED, ANCHOR_ACOCKBILL, ANCHOR_HANGING, ANCHOR_AWEIGH, ANCHOR_LOST,
                             ANCHOR_ON_BOTTOM, ANCHOR_DIGGING_IN, ANCHOR_HOLDING, ANCHOR_DRAGGING}) {
        Picture picture = picture_at(0);
        AnchorState anchor;
        anchor.phase(phase);
        picture.receive(anchor, Clock::now());
        const bool on_bottom = phase == ANCHOR_ON_BOTTOM || phase == ANCHOR_DIGGING_IN ||
                               phase == ANCHOR_HOLDING || phase == ANCHOR_DRAGGING;
        EXPECT_EQ(when.holds(picture, SIDE_PORT, 0), on_bottom) << phase;
    }
}

TEST(Condition, OfASeatIsReadFromItsViews) {
    const auto now = Clock::now();
    Picture picture;
    ExerciseStatus status;
    status.state(RUN_RUNNING);
    picture.receive(status, now);
    ForecastleView view;
    view.counter_fitted(true);
    view.cable_out_indicated(55);
    view.brake_position(0.4);
    view.clutch(CLUTCH_IN);
    view.gypsy_load_indicated(9e4); // of a cell that is not fitted
    picture.receive(view, now);
    BridgeView bridge;
    bridge.speed_over_ground(0.5);
    bridge.gps_works(true);
    bridge.position().x(-120);
    bridge.position().y(40);
    bridge.heading(1.5); // of a gyro that does not work
    picture.receive(bridge, now);
    const auto holds = [&](const char* when) { return condition(when).holds(picture, SIDE_PORT, 0); };
    EXPECT_TRUE(holds(R"({"counter": 55, "counter_shackles": {"above": 1.99, "below": 2.01}})"));
    EXPECT_TRUE(holds(R"({"brake_position": 0.4, "clutch": "in", "stopper": "off", "speed_by_gps": 0.5})"));
    EXPECT_TRUE(holds(R"({"gps_x": {"below": -100}, "gps_y": {"above": 39, "below": 41}})"));
    EXPECT_FALSE(holds(R"({"heading_deg": {"below": 360}})"));
    EXPECT_FALSE(holds(R"({"load_cell": 1})"));
    EXPECT_FALSE(holds(R"({"speed_by_log": {"below": 9}})")); // it does not work
    EXPECT_FALSE(holds(R"({"seat_event": "anchor.let_go"})"));
    SeatEvent event;
    event.number(1);
    event.code() = "anchor.let_go";
    picture.take_forecastle_event(event, now);
    EXPECT_TRUE(holds(R"({"seat_event": "anchor.let_go"})"));
    EXPECT_FALSE(holds(R"({"event": "anchor.let_go"})"));
    EXPECT_FALSE(holds(R"({"seat_event": "watch.circle"})"));
    event.code() = "watch.circle";
    picture.take_bridge_event(event, now);
    EXPECT_TRUE(holds(R"({"seat_event": "watch.circle"})"));
    EXPECT_FALSE(holds(R"({"order": "let_go"})"));
    BridgeOrder order;
    order.number(1);
    order.code(BRIDGE_ORDER_LET_GO);
    picture.receive(order, now);
    EXPECT_TRUE(holds(R"({"order": "let_go"})"));
    EXPECT_THAT(condition(R"({"order": "secure"})").unmet(picture, SIDE_PORT, 0),
                HasSubstr("order secure (now let_go)"));
}

Report reported(ReportCode code, int side, double value = 0, int lead = 0) {
    Report report;
    report.code(code);
    report.side(side);
    report.value(value);
    report.lead(lead);
    return report;
}

TEST(Condition, HearsAReportOfTheForecastleBySideAndFigure) {
    Picture picture = picture_at(10);
    const auto holds = [&](const char* when) { return condition(when).holds(picture, SIDE_PORT, 0); };
    EXPECT_THAT(
        condition(R"({"reported": "shackles_in_pipe", "reported_value": 3})").unmet(picture, SIDE_PORT, 0),
        HasSubstr("shackles_in_pipe at least 3 to be reported (not heard)"));
    picture.receive(reported(REPORT_SHACKLES_IN_PIPE, SIDE_STARBOARD, 3), Clock::now());
    picture.receive(reported(REPORT_LEAD, SIDE_PORT, 0, 7), Clock::now());
    EXPECT_FALSE(holds(R"({"reported": "shackles_in_pipe"})")); // of the other side
    EXPECT_TRUE(holds(R"({"reported": "shackles_in_pipe", "reported_side": "starboard"})"));
    EXPECT_TRUE(
        holds(R"({"reported": "shackles_in_pipe", "reported_side": "starboard", "reported_value": 3})"));
    EXPECT_FALSE(
        holds(R"({"reported": "shackles_in_pipe", "reported_side": "starboard", "reported_value": 4})"));
    EXPECT_TRUE(holds(R"({"reported": "lead", "reported_value": {"above": 5, "below": 9}})"));
    EXPECT_FALSE(holds(R"({"reported": "lead", "reported_value": {"below": 7}})"));
}

TEST(Condition, HearsNoReportWhileTheRadioIsDead) {
    Picture picture = picture_at(10);
    BridgeView bridge;
    bridge.vhf_works(false);
    picture.receive(bridge, Clock::now());
    picture.receive(reported(REPORT_BROUGHT_UP, SIDE_PORT), Clock::now());
    EXPECT_FALSE(condition(R"({"reported": "brought_up"})").holds(picture, SIDE_PORT, 0));
    bridge.vhf_works(true);
    picture.receive(bridge, Clock::now());
    picture.receive(reported(REPORT_BROUGHT_UP, SIDE_PORT), Clock::now());
    EXPECT_TRUE(condition(R"({"reported": "brought_up"})").holds(picture, SIDE_PORT, 0));
}

TEST(Player, WaitsForAReportThatComesAfterTheStepBefore) {
    Player player{script(R"({"steps": [{"say": "asks"}, {"when": {"reported": "lead"}, "say": "and again"},
                                        {"when": {"reported": "lead"}, "say": "heard"}]})"),
                  SIDE_PORT};
    Picture picture = picture_at(10);
    picture.receive(reported(REPORT_LEAD, SIDE_PORT), Clock::now()); // before the script: of no step of it
    EXPECT_EQ(player.advance(picture).size(), 1U);
    picture.receive(reported(REPORT_LEAD, SIDE_PORT), Clock::now());
    EXPECT_EQ(player.advance(picture).size(), 1U); // one report answers one question
    EXPECT_TRUE(player.advance(picture).empty());
    picture.receive(reported(REPORT_LEAD, SIDE_PORT), Clock::now());
    EXPECT_EQ(player.advance(picture).size(), 1U);
    EXPECT_TRUE(player.finished());
}

TEST(Script, AFigureOfNoReportIsAFault) {
    try {
        script(R"({"steps": [{"when": {"reported_value": 3}, "say": "a"}]})");
        FAIL() << "taken";
    } catch (const ConfigError& error) {
        EXPECT_THAT(error.what(), HasSubstr("/steps/0/when/reported_value: 3 is not allowed alone"));
    }
}

TEST(Player, GoesByAViewAsWellAsByTheLoads) {
    Player player{script(R"({"steps": [{"say": "a"}]})"), SIDE_PORT};
    Picture picture;
    picture.receive(ExerciseStatus{}, Clock::now());
    EXPECT_TRUE(player.advance(picture).empty());
    picture.receive(ForecastleView{}, Clock::now());
    EXPECT_EQ(player.advance(picture).size(), 1U);
}

TEST(Condition, AllMustHoldAndTheUnmetOnesAreTold) {
    Picture picture = picture_at(10);
    WindlassLoad load;
    load.cable_speed(3);
    picture.receive(load, Clock::now());
    const Condition when =
        condition(R"({"after": 5, "cable_speed": {"above": 2}, "event": "anchor.brought_up"})");
    EXPECT_FALSE(when.holds(picture, SIDE_PORT, 4));
    EXPECT_THAT(when.unmet(picture, SIDE_PORT, 4), HasSubstr("5 s after the step before (now 4.0 s)"));
    EXPECT_THAT(when.unmet(picture, SIDE_PORT, 5), testing::Not(HasSubstr("cable_speed")));
    EXPECT_FALSE(when.holds(picture, SIDE_PORT, 5));
    Event event;
    event.number(1);
    event.code() = "anchor.brought_up";
    picture.receive(event, Clock::now());
    EXPECT_TRUE(when.holds(picture, SIDE_PORT, 5));
}

TEST(Player, TakesStepsInOrderAndEachOnce) {
    Player player{script(R"({"steps": [{"do": {"brake": 0}}, {"when": {"time": 5}, "do": {"brake": 0.4}},
                                       {"when": {"after": 2}, "do": {"brake": 1}}]})"),
                  SIDE_PORT};
    EXPECT_EQ(player.advance(picture_at(0)).size(), 1U);
    EXPECT_EQ(player.advance(picture_at(4.9)).size(), 0U);
    const auto second = player.advance(picture_at(5.5));
    ASSERT_EQ(second.size(), 1U);
    EXPECT_EQ(second[0]->orders.brake, 0.4);
    EXPECT_EQ(player.advance(picture_at(7.4)).size(), 0U); // "after" counts from 5.5, when the step was taken
    EXPECT_FALSE(player.finished());
    EXPECT_EQ(player.advance(picture_at(7.5)).size(), 1U);
    EXPECT_TRUE(player.finished());
    EXPECT_EQ(player.advance(picture_at(8)).size(), 0U);
    EXPECT_FALSE(player.failure());
}

TEST(Player, StepsWithoutConditionFollowAtOnce) {
    Player player{script(R"({"steps": [{"say": "a"}, {"say": "b"}, {"say": "c"}]})"), SIDE_PORT};
    EXPECT_EQ(player.advance(picture_at(0)).size(), 3U);
    EXPECT_TRUE(player.finished());
}

TEST(Player, WaitsUntilTheExerciseIsHeard) {
    Player player{script(R"({"steps": [{"say": "a"}]})"), SIDE_PORT};
    EXPECT_TRUE(player.advance(Picture{}).empty());
    EXPECT_FALSE(player.finished());
}

TEST(Player, TimeOutTellsStepWishAndValue) {
    Player player{
        script(R"({"steps": [{"say": "a"}, {"when": {"shackles": 6}, "say": "six", "timeout": 30}]})"),
        SIDE_PORT};
    player.advance(picture_at(100));
    player.advance(picture_at(129.9));
    EXPECT_FALSE(player.failure());
    player.advance(picture_at(130.5));
    ASSERT_TRUE(player.failure());
    EXPECT_THAT(*player.failure(), HasSubstr("step 2 of 2"));
    EXPECT_THAT(*player.failure(), HasSubstr("\"six\""));
    EXPECT_THAT(*player.failure(), HasSubstr("timed out after 30 s"));
    EXPECT_THAT(*player.failure(), HasSubstr("shackles at least 6 shackles (now 0)"));
}

TEST(Player, FailsWhenTheExerciseStopsUnderIt) {
    for (const auto state : {RUN_STOPPED_BY_FAULT, RUN_FINISHED}) {
        Player player{script(R"({"steps": [{"when": {"time": 100}}]})"), SIDE_PORT};
        Picture picture = picture_at(1);
        picture.status.sample.state(state);
        player.advance(picture);
        EXPECT_TRUE(player.failure()) << state;
    }
}

TEST(Player, FailsWhenTheExerciseBeginsAgain) {
    Player player{script(R"({"steps": [{"when": {"time": 100}}]})"), SIDE_PORT};
    player.advance(picture_at(50));
    player.advance(picture_at(49.5)); // topics of one moment may come in any order
    EXPECT_FALSE(player.failure());
    player.advance(picture_at(0));
    ASSERT_TRUE(player.failure());
    EXPECT_THAT(*player.failure(), HasSubstr("went back"));
}

/// Looks each 0.01 s of wall time for so long, while the exercise runs at that speed. When it looked last.
Progress::Time look(Progress& progress, Progress::Time from, double seconds, double speed, double& time,
                    bool running = true) {
    for (int i = 0; i < 100 * seconds; ++i)
        progress.look(time += 0.01 * speed, 10, running, from += std::chrono::milliseconds{10});
    return from;
}

TEST(Progress, SaysHowFastTheMachineRunsAndWhetherThatIsLessThanAsked) {
    Progress progress;
    double time = 100;
    EXPECT_EQ(progress.speed(), "this machine has not run the exercise for a second yet");
    auto now = look(progress, {}, 5, 0, time, false); // not started yet: this is nobody's slowness
    now = look(progress, now, 20, 10, time);
    EXPECT_EQ(progress.speed(), "this machine runs at x10 of the x10 asked");
    EXPECT_FALSE(progress.slow());
    look(progress, now, 20, 2.4, time);
    EXPECT_EQ(progress.speed(), "this machine runs at x6.2 of the x10 asked");
    EXPECT_TRUE(progress.slow());
    EXPECT_FALSE(progress.stands_still());
}

TEST(Progress, ExerciseThatRunsStandsStillWhenItsTimeDoesNotMoveForAMinute) {
    Progress progress;
    double time = 100;
    auto now = look(progress, {}, 300, 0.001, time); // hardly
    EXPECT_FALSE(progress.stands_still());
    now = look(progress, now, 300, 0, time, false); // paused
    EXPECT_FALSE(progress.stands_still());
    now = look(progress, now, Progress::kStandstill - 1, 0, time);
    progress.look(time, 10, true, now += std::chrono::hours{1}); // the computer slept
    EXPECT_FALSE(progress.stands_still());
    look(progress, now, 2, 0, time);
    EXPECT_TRUE(progress.stands_still());
}

} // namespace
} // namespace windlass::trainee
