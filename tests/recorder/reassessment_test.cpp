// A recorded lesson is marked again from its orders, to the same bits.

#include "recorder/debrief/judgement.hpp"
#include "recorder/debrief/read_attempt.hpp"
#include "recorder/debrief/records.hpp"
#include "recorder/debrief/said.hpp"
#include "recorder/resimulate/reassessment.hpp"

#include "tests/recorder/folder.hpp"
#include "tests/recorder/taped_session.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace windlass::test {

namespace {

using recorder::reassess;

constexpr int kBeats = 300; // a second

exercise::ExerciseDef lesson_def() {
    return config::load_exercise(WINDLASS_CONFIG_DIR "/exercises/L01_let_go_25m.json");
}

void levers(TapedSession& taped, double brake) {
    taped.give(exercise::Order{exercise::WindlassOrder{.side = exercise::Side::port, .brake = brake}});
}

/// Let go, checked, back to before that and let go again in another way, a word of the assessor, the end.
void teach(TapedSession& taped) {
    taped.run(15 * kBeats);
    levers(taped, 0);
    taped.run(8 * kBeats);
    taped.give(exercise::Order{exercise::ReportMade{.code = exercise::ReportCode::on_the_bottom, .side = 0}});
    taped.run(3 * kBeats);
    taped.give(run::RunAction::restore, 10);
    taped.give(run::RunAction::start);
    taped.run(5 * kBeats);
    levers(taped, 0.02);
    taped.run(10 * kBeats);
    taped.give(exercise::Order{exercise::AssessorsWord{.criterion = "lead",
                                                       .verdict = exercise::AssessorVerdict::not_applicable,
                                                       .note = "was not asked for it",
                                                       .by = "Ann"}},
               "instructor");
    taped.run(2 * kBeats);
    taped.give(run::RunAction::stop);
    taped.run(1 * kBeats);
    taped.close();
}

} // namespace

TEST(Reassessment, RecordedMarksComeOutAgainBitForBit) {
    const Folder folder;
    std::uint64_t live = 0;
    {
        TapedSession taped(folder.path(), lesson_def());
        teach(taped);
        EXPECT_TRUE(taped.session().assessor().ended());
        live = taped.session().assessor().result().assessment_hash;
    }
    recording::Recording recording({folder.path()});
    const auto found = reassess(recording);
    ASSERT_EQ(found.runs.size(), 2u); // before the restore, and after
    EXPECT_GT(found.recorded, 30u);   // one a second
    EXPECT_EQ(found.equal, found.recorded) << found.first_that_differs;
    EXPECT_EQ(found.runs.back().result.assessment_hash, live);
    EXPECT_NE(found.runs.front().result.assessment_hash, live);
}

// A lesson across a loss of its server is one attempt, with a mark where it was lost, and is marked as one.
TEST(Reassessment, LessonAcrossALossOfItsServerIsOneAttempt) {
    const Folder folder;
    std::uint64_t live = 0;
    double taken_up = 0;
    {
        TapedSession taped(folder.path(), lesson_def());
        taped.run(15 * kBeats);
        levers(taped, 0);
        taped.run(6 * kBeats);
        const auto kept = taped.kept();
        taken_up = taped.session().now_time();
        taped.run(1);
        levers(taped, 1); // in ticks that are lost with the server, and so is this
        taped.give(
            exercise::Order{exercise::ReportMade{.code = exercise::ReportCode::brought_up, .side = 0}});
        taped.run(kBeats / 3);
        taped.lose_server(kept);
        taped.run(2 * kBeats); // paused
        taped.give(run::RunAction::start, 0);
        taped.run(5 * kBeats);
        levers(taped, 0.02);
        taped.run(3 * kBeats);
        taped.give(run::RunAction::stop);
        taped.run(1 * kBeats);
        live = taped.session().assessor().result().assessment_hash;
        taped.close();
    }
    recording::Recording recording({folder.path()});
    const debrief::Attempt attempt = debrief::read_attempt(recording);
    EXPECT_EQ(attempt.origin.runs, 1U);
    EXPECT_EQ(attempt.origin.taken_up_from.size(), 1U);
    EXPECT_LT(attempt.began, 1) << "from its beginning";
    EXPECT_NEAR(attempt.ended, taken_up + 8, 1);
    const auto at = [&](const char* code) {
        const auto found =
            std::ranges::find_if(attempt.events, [&](const Event& each) { return each.code() == code; });
        return found == attempt.events.end() ? -1 : found->time();
    };
    EXPECT_NEAR(at("anchor.let_go"), 17, 2) << "before the loss, when the wheel has been turned";
    EXPECT_NEAR(at("exercise.taken_up"), taken_up, 0.01) << "the mark";
    EXPECT_TRUE(attempt.reports.empty()) << "of ticks that were lost with the server";
    EXPECT_EQ(attempt.lever_moves.size(), 2U) << "one before the loss and one after it";
    ASSERT_TRUE(attempt.assessment);
    EXPECT_EQ(attempt.assessment->assessment_hash(), live);
    EXPECT_EQ(reassess(recording).runs.back().result.assessment_hash, live) << "marked again from its orders";
}

// One judge: what the debriefing says of a report and of the end is what the server has judged and recorded.
TEST(Reassessment, DebriefingHasTheServersJudgement) {
    const Folder folder;
    {
        TapedSession taped(folder.path(), lesson_def());
        teach(taped);
    }
    recording::Recording recording({folder.path()});
    const auto first = debrief::read_attempt(recording, 1), last = debrief::read_attempt(recording, 2);
    const auto reports = debrief::reports_said(first);
    ASSERT_EQ(reports.size(), 1U);
    ASSERT_EQ(first.assessment->reports().size(), 1U);
    EXPECT_EQ(first.assessment->reports()[0].tick(), first.reports[0].tick) << "of the order that was taken";
    EXPECT_EQ(reports[0].milli, first.assessment->reports()[0].milli());
    EXPECT_EQ(reports[0].delay, first.assessment->reports()[0].delay());
    EXPECT_EQ(last.assessment->ending(), LESSON_ENDED_EARLY);
    EXPECT_EQ(debrief::ended_by(last), "instructor");
    EXPECT_TRUE(debrief::json_of(last)["assessment"]["confirmed_by"].is_null())
        << "it was ended, and no more";
    const auto objectives = debrief::achievements_of(last);
    ASSERT_EQ(objectives.size(), last.assessment->objectives().size());
    EXPECT_FALSE(objectives.empty());
}

// The fall of the first try, wide open, is not in the marks of the second, which went on from before it.
TEST(Reassessment, GoingOnFromACheckpointGoesOnFromItsMarks) {
    const Folder folder;
    TapedSession taped(folder.path(), lesson_def());
    taped.run(15 * kBeats);
    levers(taped, 0);
    taped.run(8 * kBeats);
    const auto fall = [&] { return taped.session().assessor().result().criteria.at(1); };
    EXPECT_GT(fall().worst, 5);
    taped.give(run::RunAction::restore, 10);
    EXPECT_LT(fall().worst, 0.1);
    EXPECT_EQ(taped.session().assessor().state().orders.at(0).number, 1); // given at 3 s
    taped.close();
}

TEST(Reassessment, MarksThatSomebodyChangedAreTold) {
    const Folder folder;
    {
        TapedSession taped(folder.path(), lesson_def());
        int count = 0;
        taped.assessments = [&count](Assessment& sample) {
            if (++count == 12) sample.assessment_hash(sample.assessment_hash() + 1);
            return true;
        };
        teach(taped);
    }
    recording::Recording recording({folder.path()});
    const auto found = reassess(recording);
    EXPECT_EQ(found.equal + 1, found.recorded);
    EXPECT_NE(found.first_that_differs.find("at tick"), std::string::npos);
}

TEST(Reassessment, RecordingThatLacksAnOrderGivesNoMarks) {
    const Folder folder;
    {
        TapedSession taped(folder.path(), lesson_def());
        taped.orders = [](OrderTaken& sample) { return sample.kind() != ORDER_TAKEN_REPORT; };
        teach(taped);
    }
    recording::Recording recording({folder.path()});
    EXPECT_THROW(reassess(recording), recorder::Gap);
}

} // namespace windlass::test
