// What if: changes that are found for lessons played by their typical errors, each then really played.

#include "instructor_console/lesson_command.hpp"
#include "instructor_console/lesson_files.hpp"
#include "lesson/play.hpp"
#include "lesson/whatif/two_courses.hpp"
#include "lesson/whatif/words.hpp"
#include "recorder/command.hpp"
#include "recorder/whatif/recorded_attempt.hpp"
#include "server/assess/quantities.hpp"

#include "tests/recorder/folder.hpp"
#include "tests/recorder/taped_session.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace windlass::whatif {

namespace {

namespace fs = std::filesystem;
using exercise::Side;

/// A lesson played by one of its typical errors.
struct Played {
    explicit Played(const char* name, std::size_t error = 0)
        : file(console::read_lesson_file(fs::path(WINDLASS_CONFIG_DIR) / "exercises" / name)),
          model(console::scripts_of(file, file.lesson.model_run)) {
        played = lesson::play(file.def, console::scripts_of(file, file.lesson.errors.at(error)),
                              [this](const run::Session& session) { put_down(attempt, session); });
    }
    console::LessonFile file;
    std::vector<trainee::Script> model;
    Attempt attempt;
    lesson::Played played;
};

/// The orders of hands run through a session, which gives the lesson's own orders itself. Behind the last of
/// them the hands hold their levers, as stations tell again and again.
assess::Result really_play(const exercise::ExerciseDef& def, const std::vector<run::OrderView>& orders) {
    run::SessionOptions options;
    options.id = def.name;
    options.time_scale = 0;
    options.seed = 1; // as lesson::play()
    run::Session session(def, std::move(options));
    run::Inbox inbox;
    std::optional<run::ReceivedOrder> held;
    std::size_t next = 0;
    while (!session.assessor().ended() && session.now_time() < 3600) {
        inbox.orders.clear();
        for (; next < orders.size() && orders[next].tick <= session.now_tick(); ++next) {
            inbox.orders.push_back({"trainee-1", orders[next].command});
            if (std::holds_alternative<exercise::WindlassOrder>(orders[next].command))
                held = inbox.orders.back();
        }
        if (held && next == orders.size() && session.now_tick() % 30 == 0) inbox.orders.push_back(*held);
        session.carry_out(inbox, session.now_time());
        if (!session.tick()) throw std::runtime_error(session.failure());
        session.clear_news();
    }
    return session.assessor().result();
}

const assess::CriterionResult& criterion_of(const assess::Result& result, const std::string& code) {
    return *std::ranges::find(result.criteria, code, &assess::CriterionResult::code);
}

/// Orders of a brake that goes to those places.
std::vector<run::OrderView> brake(const std::vector<Place>& places) {
    std::vector<run::OrderView> orders;
    orders.reserve(places.size());
    for (const Place& place : places)
        orders.push_back({.run = 1,
                          .tick = place.tick,
                          .number = orders.size() + 1,
                          .source = "trainee-1",
                          .command = exercise::WindlassOrder{.side = Side::port, .brake = place.value}});
    return orders;
}

constexpr Lever kBrake{LeverKind::brake, Side::port};

} // namespace

TEST(WhatIf, IsGivenUpWhenItIsStopped) {
    const Played played("L15_motor_overhauled.json");
    std::stop_source stop;
    Trials trials(played.attempt, played.model, stop.get_token());
    stop.request_stop();
    EXPECT_THROW(what_if(trials, lost_criteria(trials).front()), std::runtime_error);
}

TEST(WhatIfLevers, AMoveIsOneWayWithoutAPause) {
    const auto orders =
        brake({{30, 0.8}, {60, 0.6}, {90, 0.6}, {120, 0.3}, {600, 0.1}, {630, 0.5}, {660, 1}});
    const Track track = track_of(kBrake, orders, {}, 0);
    ASSERT_EQ(track.size(), 7U) << "where it stood, and six places that differ";
    const auto moves = moves_of(track, 300);
    ASSERT_EQ(moves.size(), 3U) << "opened; opened more after a pause; closed";
    EXPECT_EQ(moves[0].last, 3U);
    EXPECT_EQ(moves[1].first, 4U);
    EXPECT_EQ(moves[1].last, 4U);
    EXPECT_EQ(moves[2].last, 6U);
}

TEST(WhatIfLevers, ATrackGoesBetweenTheOrdersAndLeavesTheOtherLevers) {
    auto orders = brake({{30, 1}, {60, 1}, {90, 1}});
    std::get<exercise::WindlassOrder>(orders[1].command).clutch_in = true;
    const auto changed = with_track(orders, kBrake, {{0, 1}, {75, 0.4}, {80, 0.2}}, {});
    ASSERT_EQ(changed.size(), 5U);
    const auto at = [&](std::size_t k) { return std::get<exercise::WindlassOrder>(changed[k].command); };
    EXPECT_EQ(changed[2].tick, 75U);
    EXPECT_EQ(at(1).brake, 1);
    EXPECT_EQ(at(2).brake, 0.4);
    EXPECT_TRUE(at(2).clutch_in) << "as it stood then";
    EXPECT_EQ(at(4).brake, 0.2);
    EXPECT_FALSE(at(4).clutch_in);
}

TEST(WhatIf, AnAttemptGoneThroughUnchangedHasItsMarks) {
    const Played one("L18_stuck.json");
    const Trials trials(one.attempt, one.model);
    EXPECT_EQ(trials.recorded().assessment_hash, one.played.result.assessment_hash);
}

// As a class is that runs out of time: the word that ends it comes at the last tick.
TEST(WhatIf, LessonThatTheInstructorEndedIsSearchedToo) {
    Played one("L01_let_go_25m.json"); // the wheel thrown wide open and left
    Attempt& attempt = one.attempt;
    const std::uint64_t end = criterion_of(one.played.result, "pay-out").lost_tick + 900;
    ASSERT_LT(end, attempt.last_tick);
    std::erase_if(attempt.orders, [&](const run::OrderView& order) { return order.tick >= end; });
    std::erase_if(attempt.checkpoints, [&](const run::CheckpointView& each) { return each.tick > end; });
    attempt.last_tick = end;
    attempt.orders.push_back({.run = 1,
                              .tick = end,
                              .number = attempt.orders.size() + 1,
                              .source = run::kServerName,
                              .command = exercise::AssessorsWord{.criterion = {},
                                                                 .verdict = exercise::AssessorVerdict::ended,
                                                                 .milli = 0,
                                                                 .note = "exercise ended: by anna",
                                                                 .by = run::kServerName}});
    Trials trials(attempt, one.model);
    EXPECT_EQ(trials.recorded().ending, assess::Ending::instructor);
    EXPECT_THAT(lost_criteria(trials), testing::Contains("pay-out"));
    EXPECT_TRUE(what_if(trials, "pay-out").kept) << "the wheel hard on";
}

TEST(WhatIf, ModelHandsThatTakeOverAtTheBeginningGoTheModelRun) {
    const Played one("L15_motor_overhauled.json");
    Trials trials(one.attempt, one.model);
    const auto brake = static_cast<std::size_t>(&criterion_of(trials.recorded(), "brake") -
                                                trials.recorded().criteria.data());
    const Outcome outcome = trials.go({.orders = trials.orders(), .from = 0, .model_from = 0}, {brake, 1000});
    EXPECT_TRUE(outcome.kept);
    EXPECT_EQ(outcome.result.assessment_hash, lesson::play(one.file.def, one.model).result.assessment_hash);
}

// The model's conn goes by what its mate reports.
TEST(WhatIf, ModelHandsOnTheBridgeHearTheForecastle) {
    const Played one("L27_the_conn.json", 1);
    Trials trials(one.attempt, one.model);
    const auto lost = lost_criteria(trials);
    ASSERT_FALSE(lost.empty());
    const auto place = static_cast<std::size_t>(&criterion_of(trials.recorded(), lost.front()) -
                                                trials.recorded().criteria.data());
    const Outcome outcome = trials.go({.orders = trials.orders(), .from = 0, .model_from = 0}, {place, 1000});
    EXPECT_EQ(outcome.result.assessment_hash, lesson::play(one.file.def, one.model).result.assessment_hash);
}

TEST(WhatIf, ALeverThatIsFoundKeepsTheMustWhenItIsReallyPlayed) {
    const Played one("L15_motor_overhauled.json");
    Trials trials(one.attempt, one.model);
    EXPECT_FALSE(criterion_of(trials.recorded(), "brake").met);
    const Answer answer = what_if(trials, "brake");
    ASSERT_TRUE(answer.kept) << answer_words(trials, answer);
    const auto variation = varied(trials, answer.kept->change);
    ASSERT_TRUE(variation);
    const assess::Result again = really_play(one.file.def, variation->orders);
    EXPECT_TRUE(criterion_of(again, "brake").met) << answer_words(trials, answer);
    EXPECT_EQ(again.assessment_hash, answer.kept->result.assessment_hash) << "to the bit";
    EXPECT_TRUE(answer.kept->sure.stands());

    // A step less than the least does not.
    Change smaller = answer.kept->change;
    ASSERT_EQ(smaller.kind, ChangeKind::one_more);
    smaller.tick += trials.ticks((smaller.steps - answer.kept->least_steps + 1) * kStep);
    EXPECT_FALSE(trials.go(*varied(trials, smaller), {answer.criterion, 1000}).kept);

    Trials others(one.attempt, one.model);
    const Answer twice = what_if(others, "brake");
    EXPECT_EQ(json_of(others, {twice}).dump(), json_of(trials, {answer}).dump()) << "the same, again";
}

// A wheel is not set to a hundredth.
TEST(WhatIf, ALeverThatGoesFurtherBearsALittleMoreAndALittleLess) {
    const Played one("L01_let_go_25m.json");
    Trials trials(one.attempt, one.model);
    const Answer answer = what_if(trials, "pay-out");
    ASSERT_TRUE(answer.kept) << answer_words(trials, answer);
    ASSERT_EQ(answer.kept->change.kind, ChangeKind::more);
    EXPECT_GT(answer.kept->change.steps, answer.kept->least_steps) << "the least is a knife's edge";
    EXPECT_EQ(answer.kept->sure.more, true);
    EXPECT_EQ(answer.kept->sure.less, true);
    for (const double by : {-0.02, 0.02}) {
        Change change = answer.kept->change;
        change.value += by;
        const assess::Result again = really_play(one.file.def, varied(trials, change)->orders);
        EXPECT_TRUE(criterion_of(again, "pay-out").met) << by;
    }
}

// The least is the wheel a hundredth more at the move before, which two hundredths are not.
TEST(WhatIfAtLength, WhereChanceDecidesTheLeastAnotherIsFoundThatStands) {
    const Played one("L06_dredging.json");
    Trials trials(one.attempt, one.model);
    const Answer answer = what_if(trials, "cable");
    ASSERT_TRUE(answer.kept) << answer_words(trials, answer);
    EXPECT_TRUE(answer.kept->sure.stands()) << answer_words(trials, answer);
    const assess::Result again = really_play(one.file.def, varied(trials, answer.kept->change)->orders);
    EXPECT_TRUE(criterion_of(again, "cable").met) << answer_words(trials, answer);
}

TEST(WhatIf, AReportThatWasNotMadeIsFound) {
    const Played one("L18_stuck.json");
    Trials trials(one.attempt, one.model);
    const Answer answer = what_if(trials, "report");
    ASSERT_TRUE(answer.kept);
    EXPECT_EQ(answer.kept->change.kind, ChangeKind::report_given);
    const assess::Result again = really_play(one.file.def, varied(trials, answer.kept->change)->orders);
    EXPECT_EQ(criterion_of(again, "report").milli, 1000) << answer_words(trials, answer);
}

TEST(WhatIf, ABranchThatChangesNothingComesToTheMarksOfTheWhole) {
    const Played one("L18_stuck.json");
    Trials trials(one.attempt, one.model);
    EXPECT_EQ(really_play(one.file.def, trials.orders()).assessment_hash, trials.recorded().assessment_hash);
    trials.look_at(static_cast<std::uint64_t>(trials.state().ended), [&](run::Course& course) {
        EXPECT_EQ(course.assessor().result().assessment_hash, trials.recorded().assessment_hash);
    });
}

// A motor that has burst is whole again by nobody's hand.
TEST(WhatIf, NothingHelpsBehindTheLastMoment) {
    const Played one("L15_motor_overhauled.json");
    Trials trials(one.attempt, one.model);
    const assess::CriterionResult& whole = criterion_of(trials.recorded(), "whole");
    const auto place = static_cast<std::size_t>(&whole - trials.recorded().criteria.data());
    const auto last = last_moment(trials, "whole");
    ASSERT_TRUE(last);
    EXPECT_LT(last->time, trials.seconds(whole.tick));
    const auto kept = [&](double time) {
        const std::uint64_t tick = trials.ticks(time);
        return trials.go({.orders = trials.orders(), .from = tick, .model_from = tick}, {place, 500}).kept;
    };
    EXPECT_TRUE(kept(last->time));
    for (const double behind : {0.1, 10.1, 20.1})
        EXPECT_FALSE(kept(trials.seconds(whole.tick) + behind)) << behind;
}

TEST(WhatIf, ACriterionThatWasKeptHasNoAnswer) {
    const Played one("L18_stuck.json");
    Trials trials(one.attempt, one.model);
    EXPECT_TRUE(criterion_of(trials.recorded(), "fall").met);
    EXPECT_THROW(what_if(trials, "fall"), std::invalid_argument);
}

// The curves of an answer are alike until the change, and the one keeps to what the other does not.
TEST(WhatIf, BothCoursesPartAtTheChangeAndOnlyOneKeepsToWhatIsAsked) {
    const Played one("L15_motor_overhauled.json");
    Trials trials(one.attempt, one.model);
    const Answer answer = what_if(trials, "brake"); // hard on by a certain moment
    ASSERT_TRUE(answer.kept);
    const auto both = two_courses(trials, answer);
    ASSERT_TRUE(both);
    ASSERT_EQ(both->curves.size(), 1U);
    const TwoCurves& wheel = both->curves[0];
    EXPECT_STREQ(assess::quantity_at(wheel.quantity).name, "brake_position");
    EXPECT_EQ(both->lost, answer.lost_time);
    EXPECT_NEAR(wheel.was.front().time, both->changed - kWindowBefore, 0.11);
    EXPECT_NEAR(wheel.was.back().time, both->lost, 0.11) << "with the motor's burst the lesson was over";
    EXPECT_NEAR(wheel.would.back().time, both->lost + kWindowBehind, 0.11);
    const auto at = [](const std::vector<Point>& points, double time) {
        return std::ranges::lower_bound(points, time - 1e-6, {}, &Point::time)->value;
    };
    for (const Point& point : wheel.was) {
        if (point.time > both->changed) break;
        ASSERT_EQ(at(wheel.would, point.time), point.value) << point.time;
    }
    EXPECT_LE(wheel.was.back().value, wheel.least);
    EXPECT_GT(at(wheel.would, both->lost), wheel.least);
    const auto again = two_courses(trials, answer);
    EXPECT_EQ(again->curves[0].would, wheel.would) << "the same, again";
}

TEST(WhatIf, AWordMovesNoCurve) {
    const Played one("L18_stuck.json");
    Trials trials(one.attempt, one.model);
    const auto both = two_courses(trials, what_if(trials, "report"));
    ASSERT_TRUE(both);
    EXPECT_TRUE(both->curves.empty());
}

// It lost two musts, the brake first.
TEST(WhatIf, OfTheFirstMustAloneIsARowForEachError) {
    CLI::App app;
    std::function<int()> chosen;
    console::add_lesson(app, [&](std::function<int()> work) { chosen = std::move(work); });
    app.parse("lesson whatif --first-must " WINDLASS_CONFIG_DIR "/exercises/L15_motor_overhauled.json");
    testing::internal::CaptureStdout();
    EXPECT_EQ(chosen(), 0);
    const std::string told = testing::internal::GetCapturedStdout();
    EXPECT_EQ(std::ranges::count(told, '\n'), 2 + 1) << told;
    EXPECT_THAT(told,
                testing::HasSubstr("| L15 | stands by the motor and gives it more lever | brake (must) |"));
}

// Through a recording and back.
TEST(WhatIf, OfARecordingIsThatOfTheAttempt) {
    const Played one("L18_stuck.json");
    Trials live(one.attempt, one.model);
    const test::Folder folder;
    {
        test::TapedSession taped(folder.path(), one.file.def);
        for (const run::OrderView& order : live.orders()) {
            taped.run(static_cast<int>(order.tick - taped.session().now_tick()));
            taped.give(order.command);
        }
        while (!taped.session().assessor().ended())
            taped.run(20);
        taped.close();
    }
    recording::Recording recording({folder.path()});
    const auto runs = recorder::runs_of(recording);
    ASSERT_EQ(runs.size(), 1U);
    const Attempt attempt = recorder::recorded_attempt(recording, runs);
    EXPECT_EQ(recorder::model_scripts(attempt), one.file.lesson.model_run.scripts);
    Trials trials(attempt, one.model);
    const std::string answer = json_of(trials, {what_if(trials, "report")}).dump(2);
    EXPECT_EQ(answer, json_of(live, {what_if(live, "report")}).dump(2));

    CLI::App app;
    recorder::Command chosen;
    recorder::add_whatif(app, chosen);
    app.parse("whatif " + folder.path().string() + " --json --criterion report --config " +
              WINDLASS_CONFIG_DIR);
    testing::internal::CaptureStdout();
    const int code = chosen();
    EXPECT_EQ(testing::internal::GetCapturedStdout(), answer + "\n");
    EXPECT_EQ(code, recorder::kOk);
}

// The server is lost twice: once as it is killed, once behind a state from which it is set back.
TEST(WhatIf, OfAnAttemptAcrossALossIsThatOfTheWhole) {
    const Played one("L18_stuck.json");
    Trials live(one.attempt, one.model);
    const test::Folder folder;
    {
        test::TapedSession taped(folder.path(), one.file.def);
        const std::uint64_t third = one.attempt.last_tick / 3;
        const auto run_to = [&](std::uint64_t tick) {
            taped.run(static_cast<int>(tick - taped.session().now_tick()));
        };
        int losses = 0;
        for (const run::OrderView& order : live.orders()) {
            if (losses < 2 && order.tick > (losses + 1) * third) {
                run_to((losses + 1) * third);
                const auto kept = taped.kept();
                if (losses == 1) {
                    taped.give(exercise::Order{exercise::WindlassOrder{.brake = 0.5}});
                    taped.run(200);
                }
                taped.lose_server(kept);
                taped.give(run::RunAction::start);
                ++losses;
            }
            run_to(order.tick);
            taped.give(order.command);
        }
        ASSERT_EQ(losses, 2);
        while (!taped.session().assessor().ended())
            taped.run(20);
        taped.close();
    }
    recording::Recording recording({folder.path()});
    ASSERT_EQ(recorder::runs_of(recording).size(), 3U);
    const Attempt attempt = recorder::recorded_attempt(recording, std::size_t{0});
    Trials trials(attempt, one.model);
    EXPECT_EQ(trials.recorded().assessment_hash, live.recorded().assessment_hash);
    EXPECT_EQ(json_of(trials, {what_if(trials, "report")}).dump(2),
              json_of(live, {what_if(live, "report")}).dump(2));
    EXPECT_THROW(recorder::recorded_attempt(recording, 2), std::runtime_error) << "it is one attempt";
}

} // namespace windlass::whatif
