// A mate who works the windlass as the bridge orders: on the ships and in the depths of shipped exercises,
// with the model itself.

#include "lesson/play.hpp"
#include "server/config/config.hpp"
#include "trainee_client/mate_answers.hpp"
#include "words/words.hpp"

#include <gmock/gmock.h>

#include <algorithm>

namespace windlass::lesson {
namespace {

constexpr double kShackle = words::units::shackle;

/// An order so many s after the one before.
struct Ordered {
    double after;
    BridgeOrderCode code;
    double value = 0;
    std::optional<int> side = {};
};

/// What the bridge orders, and a word after `last` s, with which it is over.
Part bridge(const std::vector<Ordered>& orders, double last) {
    trainee::Script script;
    script.conns = true;
    for (const Ordered& order : orders) {
        trainee::Step& step = script.steps.emplace_back();
        step.when.after = order.after;
        step.order = trainee::BridgesOrder{order.code, order.value, order.side, {}};
        step.timeout = 3600;
    }
    script.steps.emplace_back().when.after = last;
    script.steps.back().timeout = 3600;
    return {.script = script};
}

Part mate() {
    trainee::Script script;
    script.mate = true;
    script.repeats_orders = 2;
    return {.script = script};
}

/// What became of the port windlass.
struct Came {
    Played played;
    exercise::TackleView last;
    double fastest = 0;    ///< m/s of cable, out
    double bottom_at = -1; ///< s
    int endangered = 0;    ///< how often the cable moved under men's hands
    bool slipped = false;
    bool told(const std::string& words) const {
        return std::ranges::any_of(
            played.told, [&](const Told& one) { return one.text.find(words) != std::string::npos; });
    }
    double when_told(const std::string& words) const {
        const auto found = std::ranges::find_if(
            played.told, [&](const Told& one) { return one.text.find(words) != std::string::npos; });
        return found == played.told.end() ? -1 : found->time;
    }
};

Came carried_out(const std::string& exercise, const std::vector<Ordered>& orders, double last,
                 bool counter = true) {
    Came came;
    auto def = config::load_exercise(std::string(WINDLASS_CONFIG_DIR "/exercises/") + exercise + ".json");
    def.seats.counter = counter;
    came.played = play(def, {bridge(orders, last), mate()}, [&](run::Session& session) {
        came.last = session.snapshot().tackle[0];
        came.fastest = std::max(came.fastest, came.last.windlass.cable_speed);
        for (const exercise::ExerciseEvent& event : session.events())
            if (event.code == "anchor.on_bottom" && came.bottom_at < 0)
                came.bottom_at = event.time;
            else if (event.code == "deck_work.endangered")
                ++came.endangered;
            else if (event.code == "cable.slipped")
                came.slipped = true;
    });
    return came;
}

TEST(Mate, LetsGoChecksPaysOutAndSecuresAsOrdered) {
    const Came came = carried_out("let_go_port_25m",
                                  {{5, BRIDGE_ORDER_STAND_BY},
                                   {10, BRIDGE_ORDER_LET_GO},
                                   {60, BRIDGE_ORDER_PAY_OUT, 2},
                                   {90, BRIDGE_ORDER_HOLD_ON, 3},
                                   {5, BRIDGE_ORDER_HOW_LEADING},
                                   {90, BRIDGE_ORDER_SECURE}},
                                  60);
    EXPECT_NEAR(came.last.windlass.cable_out / kShackle, 3, 0.25) << "a whole mark is half a shackle off";
    EXPECT_LT(came.fastest, words::limits::cable_fast);
    EXPECT_TRUE(came.last.windlass.stopper_closed);
    EXPECT_TRUE(came.told("port anchor is let go"));
    EXPECT_NEAR(came.when_told("port anchor is on the bottom"), came.bottom_at, 8) << "15 s late is right";
    EXPECT_TRUE(came.told("reported: 2 shackles in the pipe"));
    EXPECT_TRUE(came.told("reported: 3 shackles in the pipe"));
    EXPECT_TRUE(came.told("port cable is leading"));
    EXPECT_TRUE(came.told("port anchor is secured"));
    EXPECT_FALSE(came.told("reported: port anchor is dragging"))
        << "an anchor that works its way in is not called";
}

TEST(Mate, GoesByThePaintedMarksWhereNoCounterIsFitted) {
    const Came came =
        carried_out("let_go_port_25m", {{5, BRIDGE_ORDER_LET_GO}, {60, BRIDGE_ORDER_HOLD_ON, 3}}, 90, false);
    EXPECT_NEAR(came.last.windlass.cable_out / kShackle, 3, 0.25);
    EXPECT_NEAR(came.when_told("port anchor is on the bottom"), came.bottom_at, 8);
}

TEST(Mate, GoesByTheMarksThatComeInWhereNoCounterIsFitted) {
    const Came came = carried_out("at_anchor_25m", {{5, BRIDGE_ORDER_HEAVE_TO, 4}}, 900, false);
    EXPECT_NEAR(came.last.windlass.cable_out / kShackle, 4, 0.15)
        << "a mark is called a quarter of a shackle after it has passed the lip";
}

TEST(Mate, WalksBackInGearWhereItIsTooDeepToLetGo) {
    const Came came = carried_out("walk_back_60m", {{5, BRIDGE_ORDER_WALK_BACK, 2}}, 700);
    EXPECT_NEAR(came.last.windlass.cable_out / kShackle, 2, 0.25);
    EXPECT_LT(came.fastest, 0.5) << "in gear";
    EXPECT_GT(came.last.windlass.brake_position, 0.99);
    EXPECT_TRUE(came.told("reported: 2 shackles in the pipe"));
}

TEST(Mate, HeavesToTheFigureAndStopsWhenOrdered) {
    const Came heaved = carried_out("at_anchor_25m", {{5, BRIDGE_ORDER_HEAVE_TO, 5}}, 500);
    EXPECT_NEAR(heaved.last.windlass.cable_out / kShackle, 5, 0.25);
    EXPECT_TRUE(heaved.told("heaving port cable"));
    const Came stopped =
        carried_out("at_anchor_25m", {{5, BRIDGE_ORDER_HEAVE}, {120, BRIDGE_ORDER_STOP_HEAVING}}, 30);
    EXPECT_LT(stopped.last.windlass.cable_out, 6 * kShackle - 5);
    EXPECT_GT(stopped.last.windlass.cable_out, 4 * kShackle);
    EXPECT_NEAR(stopped.last.windlass.cable_speed, 0, 0.02);
    EXPECT_GT(stopped.last.windlass.brake_position, 0.99);
}

TEST(Mate, HoldsOnAtOnceWhateverHeWasDoing) {
    const Came came = carried_out(
        "let_go_port_25m",
        {{5, BRIDGE_ORDER_LET_GO}, {60, BRIDGE_ORDER_PAY_OUT, 6}, {20, BRIDGE_ORDER_HOLD_ON}}, 30);
    EXPECT_LT(came.last.windlass.cable_out, 3.5 * kShackle);
    EXPECT_NEAR(came.last.windlass.cable_speed, 0, 0.02);
}

TEST(Mate, StopsWhenHisOrderIsTakenBackAndNotWhenToldToStandClear) {
    const Came belayed =
        carried_out("let_go_port_25m",
                    {{5, BRIDGE_ORDER_LET_GO}, {60, BRIDGE_ORDER_PAY_OUT, 6}, {20, BRIDGE_ORDER_CANCEL}}, 30);
    EXPECT_LT(belayed.last.windlass.cable_out, 3.5 * kShackle);
    EXPECT_NEAR(belayed.last.windlass.cable_speed, 0, 0.02);
    const Came clear =
        carried_out("let_go_port_25m", {{5, BRIDGE_ORDER_LET_GO}, {1.5, BRIDGE_ORDER_STAND_CLEAR}}, 60);
    EXPECT_TRUE(clear.told("port anchor is on the bottom"));
}

TEST(Mate, BuoysBreaksAndSlipsTheCableAsOrdered) {
    const Came came = carried_out(
        "at_anchor_25m",
        {{5, BRIDGE_ORDER_BUOY_CABLE}, {900, BRIDGE_ORDER_STAND_CLEAR}, {20, BRIDGE_ORDER_SLIP}}, 60);
    EXPECT_GE(came.when_told("port cable is buoyed and ready for slipping"), 600) << "ten minutes of work";
    EXPECT_TRUE(came.told("reported: stand clear"));
    EXPECT_TRUE(came.told("port cable is slipped"));
    EXPECT_TRUE(came.slipped);
    EXPECT_EQ(came.endangered, 0);
}

TEST(Mate, CallsTheMenBackBeforeTheCableIsWorkedAgain) {
    const std::vector<Ordered> buoys{{5, BRIDGE_ORDER_BUOY_CABLE}, {200, BRIDGE_ORDER_STAND_CLEAR}};
    const Came clear = carried_out("at_anchor_25m", buoys, 30);
    EXPECT_EQ(clear.last.deck_work.set, exercise::DeckWork::none);
    const Came veers = carried_out("at_anchor_25m", {buoys.front(), {200, BRIDGE_ORDER_VEER, 8}}, 120);
    EXPECT_NEAR(veers.last.windlass.cable_out / kShackle, 8, 0.25);
    EXPECT_EQ(veers.endangered, 0);
}

TEST(Mate, SaysWhyMenCannotDoIt) {
    const Came came =
        carried_out("at_anchor_25m", {{5, BRIDGE_ORDER_SLIP}, {60, BRIDGE_ORDER_CLEAR_ANCHOR}}, 90);
    EXPECT_TRUE(came.told("reported: unsafe, the cable is not broken yet"));
    EXPECT_TRUE(came.told("reported: unsafe, the anchor is not at the water"));
    EXPECT_FALSE(came.told("reported: port anchor is clear"));
    EXPECT_EQ(came.last.deck_work.set, exercise::DeckWork::none);
}

TEST(Mate, SaysThatHeCannotAndDoesNotRepeatIt) {
    const Ordered starboard{5, BRIDGE_ORDER_PAY_OUT, 7, 1};
    const Came other = carried_out("let_go_port_25m", {starboard}, 30);
    EXPECT_TRUE(other.told("reported: unsafe, there is no starboard windlass, to order 1"));
    EXPECT_FALSE(other.told("repeats"));
    const Came nothing = carried_out("let_go_port_25m", {{5, BRIDGE_ORDER_PAY_OUT, 0}}, 30);
    EXPECT_TRUE(nothing.told("reported: unsafe, that is no figure, to order 1"));
    EXPECT_FALSE(nothing.told("repeats"));
}

TEST(Mate, StopsWithTheLastShackleOnDeck) {
    const Came came = carried_out("at_anchor_25m", {{5, BRIDGE_ORDER_VEER, 14}}, 600);
    EXPECT_TRUE(came.told("the last shackle is on deck"));
    EXPECT_NEAR(came.last.windlass.cable_out / kShackle, 10.8, 0.25) << "of 12, the last is the 11th";
    EXPECT_NEAR(came.last.windlass.cable_speed, 0, 0.02);
}

TEST(Mate, CallsNoDraggingBeforeTheDeckHasTrembledForAMinute) {
    trainee::Answers answers;
    ForecastleView view;
    bool dragged = false;
    const auto look = [&](double from, double to) {
        for (double time = from; time < to; time += 0.5) {
            answers.look(view, time);
            dragged = dragged || answers.drags();
        }
    };
    look(0, 130);
    view.vibration(1);
    look(130, 185);
    EXPECT_FALSE(dragged);
    look(185, 195);
    EXPECT_TRUE(dragged);
}

TEST(Mate, AnswersByWhatTheLoadCellShows) {
    trainee::Answers answers;
    ForecastleView view;
    view.load_cell_fitted(true);
    view.leads(true);
    view.lead_clock(11);
    view.top_angle(static_cast<float>(30 * words::units::degree));
    const auto look = [&](double from, double to, auto load) {
        for (double time = from; time < to; time += 0.5) {
            view.gypsy_load_indicated(load(time));
            answers.look(view, time);
        }
    };
    look(0, 60, [](double) { return 50e3; });
    EXPECT_EQ(answers.growing().growing, GROWING_SLACK);
    EXPECT_EQ(answers.brought_up().code, REPORT_GROWING) << "nothing has come yet";
    look(60, 100, [](double time) { return 50e3 + 5e3 * (time - 60); });
    EXPECT_EQ(answers.growing().growing, GROWING_GROWING);
    look(100, 130, [](double) { return 250e3; });
    EXPECT_EQ(answers.growing().growing, GROWING_TIGHT);
    EXPECT_EQ(answers.brought_up().code, REPORT_GROWING) << "she still lies on it";
    look(130, 260, [](double) { return 160e3; });
    EXPECT_EQ(answers.brought_up().code, REPORT_BROUGHT_UP);
    EXPECT_TRUE(answers.comes_up());
    EXPECT_FALSE(answers.comes_up()) << "told once";
    view.top_angle(static_cast<float>(80 * words::units::degree)); // the ship lies over a heap of it
    look(260, 260.5, [](double) { return 160e3; });
    EXPECT_EQ(answers.brought_up().code, REPORT_GROWING);
    view.top_angle(static_cast<float>(30 * words::units::degree));
    view.lead_clock(5); // she has gone ahead over it
    look(260.5, 261, [](double) { return 160e3; });
    EXPECT_EQ(answers.brought_up().code, REPORT_GROWING);
    view.lead_clock(11);
    look(261, 261.5, [](double) { return 160e3; });
    EXPECT_EQ(answers.brought_up().code, REPORT_BROUGHT_UP);
    view.vibration(1); // the anchor gives way
    look(262, 264, [](double) { return 160e3; });
    EXPECT_EQ(answers.brought_up().code, REPORT_GROWING);
}

} // namespace
} // namespace windlass::lesson
