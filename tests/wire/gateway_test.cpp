// Pages of the stations with a real server: what they hear, their levers and orders, and what they never
// hear.

#include "tests/wire/gateway_rig.hpp"

namespace windlass::test {
using namespace rigs;

namespace {

using nlohmann::json;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using namespace std::chrono_literals;

class Gateway : public GatewayRig {};

TEST_F(Gateway, LeversOfAPageReachTheServerAndEndWhenThePageFallsSilent) {
    const auto station = seat("forecastle");
    PageClient page(station->address);
    EXPECT_TRUE(eventually([&] {
        page.say(brake(0.5));
        return has_event("levers.taken", "trainee");
    })) << station->text();
    EXPECT_TRUE(eventually([&] {
        page.say(brake(0.25));
        const auto heard = levers();
        return !heard.empty() && heard.back().brake() == 0.25 && heard.back().origin().source() == "trainee";
    }));
    EXPECT_EQ(page.wait_for("levers", {{"held", true}})["by"], "this");
    // Not another word, though the connection stands.
    EXPECT_EQ(page.wait_for("levers", {{"held", false}})["side"], 0);
    EXPECT_TRUE(eventually([&] { return has_event("levers.lost"); }));
    const auto written = [this](int side) {
        return std::ranges::count(levers(), side, [](const WindlassCommand& each) { return each.side(); });
    };
    const auto before = written(SIDE_PORT);
    EXPECT_TRUE(eventually([&] { // a hand's words go on, on the other side
        page.say(brake(0.25, SIDE_STARBOARD));
        pace(50ms);
        return written(SIDE_STARBOARD) >= 10;
    }));
    EXPECT_EQ(written(SIDE_PORT), before);
    page.say({{"op", "let_go_levers"}, {"side", 1}});

    // A page that is closed with the levers in its hand lets go of them too.
    const auto of_port = [this](const std::string& code) {
        const std::lock_guard lock(mutex_);
        return std::ranges::count_if(
            events_, [&](const Event& event) { return event.code() == code.c_str() && event.side() == 0; });
    };
    const auto taken = of_port("levers.taken"), lost = of_port("levers.lost");
    {
        PageClient other(station->address);
        EXPECT_TRUE(eventually([&] {
            other.say(brake(0.75));
            return of_port("levers.taken") > taken;
        }));
    }
    EXPECT_TRUE(eventually([&] { return of_port("levers.lost") > lost; }));
    EXPECT_FALSE(page.closed());
}

TEST_F(Gateway, OnePageOfAStationHasTheLeversOfASideAtATime) {
    const auto station = seat("ship");
    PageClient first(station->address), second(station->address);
    ASSERT_FALSE(first.wait_for("hello").is_null());
    ASSERT_FALSE(second.wait_for("hello").is_null());
    std::atomic<bool> held = true;
    const auto hold = [&held](PageClient& page, double brake_at) {
        while (held) {
            page.say(brake(brake_at));
            pace(100ms);
        }
    };
    std::thread hand(hold, std::ref(first), 0.5);
    EXPECT_EQ(second.wait_for("levers", {{"held", true}})["by"], "another");
    second.say(brake(1));
    EXPECT_THAT(second.wait_for("refused", {{"topic", "WindlassCommand"}}).value("text", ""),
                HasSubstr("another page"));
    second.say(brake(1, 1)); // starboard is free
    EXPECT_FALSE(second.wait_for("levers", {{"side", 1}, {"by", "this"}}).is_null());
    held = false;
    hand.join();
    first.say({{"op", "let_go_levers"}, {"side", 0}});
    held = true; // two sockets: the first word may overtake the other page's farewell, and be refused
    std::thread other(hold, std::ref(second), 1.0);
    EXPECT_FALSE(first.wait_for("levers", {{"side", 0}, {"by", "another"}}).is_null());
    held = false;
    other.join();
}

TEST_F(Gateway, APageThatComesLateHasTheWholeState) {
    const auto station = seat("forecastle");
    const auto desk = instructor();
    PageClient teacher(desk->address), early(station->address);
    const auto order = [&](const json& sample) { give(teacher, "BridgeOrderCommand", sample); };
    order({{"code", "BRIDGE_ORDER_LET_GO"}, {"side", 0}});
    order({{"code", "BRIDGE_ORDER_HOLD_ON"}, {"side", 0}, {"value", 3}});
    ASSERT_TRUE(eventually([&] { return early.samples("BridgeOrder").size() >= 2; })) << desk->text();
    give(teacher, "ExerciseCommand", {{"action", "EXERCISE_PAUSE"}});
    ASSERT_TRUE(eventually([&] { return status().state() == RUN_PAUSED; }));

    ASSERT_TRUE(eventually([&] { // what was told before the pause is through
        return std::ranges::any_of(early.all<SeatEvent>("ForecastleEvent"),
                                   [](const SeatEvent& event) { return event.code() == "exercise.paused"; });
    }));
    PageClient late(station->address);
    ASSERT_TRUE(eventually([&] {
        return late.samples("ForecastleEvent").size() >= early.samples("ForecastleEvent").size() &&
               !late.samples("SceneDescription").empty() && !late.samples("ForecastleView").empty();
    }));
    EXPECT_EQ(late.samples("ForecastleEvent"), early.samples("ForecastleEvent"));
    EXPECT_EQ(late.samples("SceneDescription"), early.samples("SceneDescription"));
    EXPECT_EQ(late.all<ExerciseStatus>("ExerciseStatus").front().state(), RUN_PAUSED);
    // Of each order its last state.
    std::map<int, PageClient::Payload> now, kept;
    for (const auto& payload : early.samples("BridgeOrder"))
        now[recording::decode<BridgeOrder>(payload).number()] = payload;
    for (const auto& payload : late.samples("BridgeOrder"))
        kept[recording::decode<BridgeOrder>(payload).number()] = payload;
    EXPECT_EQ(kept, now);
    EXPECT_EQ(late.samples("BridgeOrder").size(), kept.size());
}

TEST_F(Gateway, AForecastleHearsNoTruthAndNoneOfWhatIsNotItsOwn) {
    const auto station = seat("forecastle");
    PageClient page(station->address);
    const json hello = page.wait_for("hello");
    EXPECT_EQ(hello["seat"], "forecastle");
    EXPECT_EQ(hello["wire_version"], WIRE_VERSION);
    EXPECT_EQ(hello["commands"],
              json({"WindlassCommand", "Report", "DeckWorkCommand", "ForecastleAnswer", "AlertCommand"}));
    ASSERT_TRUE(eventually([&] { return page.samples("ForecastleView").size() > 30; }));
    const std::set<std::string> own{
        "ExerciseStatus",     "ForecastleEvent",
        "ForecastleAlert",    "BridgeOrder",
        "SeatAssessment",     "SceneDescription",
        "Landmarks",          "Daylight",
        "LightsAndShapes",    "SeaState",
        "ReplayStatus",       "ForecastleView",
        "WindlassCommand",    "InstructorWindlassCommand",
        "HelmCommand",        "InstructorHelmCommand",
        "ClassroomStatus",    "ForecastleInstruction",
        "ForecastleQuestion", "ForecastleGhost"}; // silent unless the seat practises and asks for it
    for (const auto& [number, name] : page.channels())
        EXPECT_TRUE(own.contains(name)) << name << " is advertised";
    for (const std::string& name : page.heard())
        EXPECT_TRUE(own.contains(name)) << name << " was sent";

    // Nor by asking for it: every number that a channel may have.
    json all = json::array();
    const auto channels = page.channels();
    for (std::uint32_t number = 0; number < 300; ++number)
        if (!channels.contains(number)) all.push_back({{"id", 1000 + number}, {"channelId", number}});
    page.say({{"op", "subscribe"}, {"subscriptions", all}});
    EXPECT_FALSE(page.wait_for("refused").is_null());
    const auto views = page.samples("ForecastleView").size();
    EXPECT_TRUE(eventually([&] { return page.samples("ForecastleView").size() > views + 20; }));
    for (const std::string& name : page.heard())
        EXPECT_TRUE(own.contains(name)) << name << " was sent";

    for (const char* topic :
         {"BridgeAnswer", "FaultCommand", "ExerciseCommand", "BridgeOrderCommand", "HelmCommand",
          "InstructorWindlassCommand", "RestoreCommand", "ClassroomCommand", "ShipState", "x"}) {
        page.say({{"op", "order"}, {"id", topic}, {"topic", topic}, {"sample", json::object()}});
        EXPECT_FALSE(page.wait_for("refused", {{"id", topic}}).is_null()) << topic;
    }
    page.say({{"op", "helm"}, {"engine", 1}, {"rudder", 0}, {"bow_thruster", 0}, {"stern_thruster", 0}});
    EXPECT_FALSE(page.wait_for("refused", {{"topic", "HelmCommand"}}).is_null());
    for (const char* op : {"record", "continue_live"}) {
        page.say({{"op", op},
                  {"id", op},
                  {"on", true},
                  {"name", "mine"},
                  {"recording", "mine"},
                  {"position", 1},
                  {"exercise", "gateway"}});
        EXPECT_FALSE(page.wait_for("refused", {{"id", op}}).is_null()) << op;
    }
    PageClient::Options other;
    other.exercise = "second";
    EXPECT_THROW(PageClient(station->address, other), std::runtime_error);
}

TEST_F(Gateway, ABridgeIsShownTheForecastleByItsCameraAndIsGivenNoMoreOfIt) {
    const auto helm = seat("bridge");
    const auto desk = instructor();
    PageClient bridge(helm->address), teacher(desk->address);
    ASSERT_TRUE(eventually([&] { return !bridge.samples("ForecastleCamera").empty(); }));
    for (const auto& [number, name] : bridge.channels())
        EXPECT_NE(name, "ForecastleView");
    for (const ForecastleView& seen : bridge.all<ForecastleView>("ForecastleCamera")) {
        EXPECT_EQ(seen.gypsy_load_indicated(), 0);
        EXPECT_EQ(seen.cable_out_indicated(), 0);
        EXPECT_TRUE(seen.nodes().empty());
    }
    // A camera that has failed: nothing comes any more, whatever a page may draw.
    give(teacher, "FaultCommand", {{"code", "FAULT_CCTV_LOST"}, {"severity", 1}});
    const auto works = [&] { return bridge.all<BridgeView>("BridgeView").back().cctv_works(); };
    ASSERT_TRUE(eventually([&] { return !works(); }));
    const double failed = bridge.all<BridgeView>("BridgeView").back().time();
    ASSERT_TRUE(eventually([&] { return bridge.all<BridgeView>("BridgeView").back().time() > failed + 1; }));
    EXPECT_LE(bridge.all<ForecastleView>("ForecastleCamera").back().time(), failed);
}

TEST_F(Gateway, WhatABridgeShowsAtAnchorIsSeenByEverybodyAndToldInTheLog) {
    const auto deck = seat("forecastle"), helm = seat("bridge");
    PageClient forecastle(deck->address), bridge(helm->address);
    const auto shown = [](PageClient& page) { return page.all<LightsAndShapes>("LightsAndShapes"); };
    ASSERT_TRUE(eventually([&] { return !shown(forecastle).empty(); }));
    EXPECT_FALSE(shown(forecastle).back().anchor_ball());
    // Again until it is heard: what goes out before the server is met is lost.
    EXPECT_TRUE(eventually([&] {
        give(bridge, "LightsAndShapesCommand", {{"anchor_ball", true}});
        pace(300ms);
        return shown(forecastle).back().anchor_ball();
    }));
    EXPECT_FALSE(shown(bridge).back().anchor_lights());
    EXPECT_TRUE(eventually([&] { return events("signals.anchor_ball") == 1; }));
    EXPECT_TRUE(eventually([&] {
        const auto told = forecastle.all<SeatEvent>("ForecastleEvent");
        return std::ranges::any_of(
            told, [](const SeatEvent& event) { return event.text() == "anchor ball hoisted"; });
    }));
    forecastle.say(
        {{"op", "order"}, {"id", "mine"}, {"topic", "LightsAndShapesCommand"}, {"sample", json::object()}});
    EXPECT_FALSE(forecastle.wait_for("refused", {{"id", "mine"}}).is_null());
}

TEST_F(Gateway, OrdersAndReportsGoFromPageToPage) {
    const auto deck = seat("forecastle"), helm = seat("bridge");
    PageClient forecastle(deck->address), bridge(helm->address);
    give(bridge, "BridgeOrderCommand", {{"code", "BRIDGE_ORDER_HOLD_ON"}, {"side", 0}, {"value", 6}});
    ASSERT_TRUE(eventually([&] { return !forecastle.samples("BridgeOrder").empty(); }));
    const auto order = forecastle.all<BridgeOrder>("BridgeOrder").front();
    EXPECT_EQ(order.value(), 6);
    // Again until both have heard it: stations find each other one by one, and who is not found yet misses
    // it.
    EXPECT_TRUE(eventually([&] {
        give(forecastle, "Report",
             {{"code", "REPORT_ORDER_REPEATED"},
              {"side", 0},
              {"value", 6},
              {"order_number", order.number()},
              {"order_code", "BRIDGE_ORDER_HOLD_ON"}});
        pace(300ms);
        return bridge.all<BridgeOrder>("BridgeOrder").back().state() == ORDER_REPEATED &&
               !bridge.samples("Report").empty();
    }));
    EXPECT_TRUE(forecastle.samples("Report").empty()) << "a forecastle writes reports and reads none";
}

TEST_F(Gateway, WhatTheServerRefusesComesBackAsAnEvent) {
    const auto desk = instructor();
    PageClient teacher(desk->address);
    EXPECT_TRUE(eventually([&] {
        teacher.say({{"op", "order"},
                     {"id", 1},
                     {"topic", "ExerciseCommand"},
                     {"sample", {{"action", "EXERCISE_TIME_SCALE"}, {"time_scale", 99}}}});
        const auto events = teacher.all<Event>("Event");
        return std::ranges::any_of(events, [](const Event& event) {
            return event.code() == "command.refused" &&
                   event.text().to_string().find("teacher") != std::string::npos;
        });
    }));
}

TEST_F(Gateway, AnInstructorOpensAnyExerciseAndSeesWhichThereAre) {
    const auto desk = instructor();
    PageClient::Options second;
    second.exercise = "second";
    PageClient here(desk->address), there(desk->address, second);
    EXPECT_FALSE(
        here.wait_for("hello", {{"exercise", "gateway"}, {"live", {"gateway", "second"}}}).is_null());
    EXPECT_FALSE(
        there.wait_for("hello", {{"exercise", "second"}, {"live", {"gateway", "second"}}}).is_null());
    EXPECT_TRUE(eventually([&] { return !there.samples("ChainState").empty(); }));
    int id = 0;
    EXPECT_TRUE(eventually([&] { // this exercise alone
        there.say({{"op", "order"},
                   {"id", ++id},
                   {"topic", "ExerciseCommand"},
                   {"sample", {{"action", "EXERCISE_PAUSE"}}}});
        const auto states = there.all<ExerciseStatus>("ExerciseStatus");
        return !states.empty() && states.back().state() == RUN_PAUSED;
    }));
    EXPECT_EQ(status().state(), RUN_RUNNING);
    EXPECT_TRUE(eventually([&] { return !here.samples("ClassroomStatus").empty(); }));
    EXPECT_THAT(here.heard(), Not(Contains("Checkpoint")));
}

TEST_F(Gateway, TwoServersOneAfterTheOtherLeaveNoStateOfTheFirst) {
    const auto station = seat("forecastle");
    {
        PageClient page(station->address);
        EXPECT_TRUE(eventually([&] { return !page.samples("ExerciseStatus").empty(); }));
        EXPECT_EQ(page.wait_for("hello")["exercise"], "gateway");
    }
    server_.signal(SIGINT);
    server_.exit_code();
    PageClient page(station->address);
    page.say({{"op", "order"}, {"id", 1}, {"topic", "Report"}, {"sample", {{"code", "REPORT_LET_GO"}}}});
    EXPECT_TRUE(eventually([&] {
        page.say({{"op", "order"}, {"id", 2}, {"topic", "Report"}, {"sample", {{"code", "REPORT_LET_GO"}}}});
        return !page.told("refused").empty();
    })) << "nobody is there to take it";
}

} // namespace
} // namespace windlass::test
