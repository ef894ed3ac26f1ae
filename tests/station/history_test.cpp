// The history: what goes in comes out, and who is erased is in the file no more.

#include "instructor_console/history/history.hpp"
#include "instructor_console/history/schema.hpp"

#include "recorder/debrief/read_attempt.hpp"
#include "recorder/debrief/records.hpp"
#include "tests/recorder/debriefed.hpp"
#include "tests/recorder/folder.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace windlass::history {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

class HistoryTest : public testing::Test {
protected:
    debrief::Attempt attempt(const char* name, const test::DebriefedRun& of = {}) const {
        recorder::Tape tape({.folder = folder_ / name});
        test::write_run(tape, of);
        tape.close({});
        recording::Recording recording({folder_ / name});
        return debrief::read_attempt(recording);
    }
    std::filesystem::path file() const { return folder_ / "history.sqlite"; }
    /// Every byte that SQLite has left on the disk.
    std::string bytes() const {
        std::string all;
        for (const auto& entry : std::filesystem::directory_iterator(folder_.path()))
            if (entry.path().filename().string().starts_with("history")) all += test::content(entry.path());
        return all;
    }

    test::Folder folder_;
};

TEST_F(HistoryTest, NextIsTheLastLessonUntilItIsAchievedInATestThenTheFirstThatIsNot) {
    const std::vector<Offered> offered{
        {"L01", "Let go", "let-go"}, {"L02", "Lower", "lower"}, {"L03", "Walk back", "walk-back"}};
    History history(file());
    int day = 0;
    const auto done = [&](const char* exercise, const char* outcome, bool practice = false,
                          bool restored = false, const char* part = "", const char* objective = nullptr) {
        test::DebriefedRun run;
        run.run = ++day;
        auto of = attempt(fmt::format("day {}", day).c_str(), run);
        of.origin.began_unix_ns += day * 86'400'000'000'000;
        of.lesson.json = R"({"lesson": {"objectives": [{"id": "run", "text": "Holds the fall"}]}})";
        of.exercise = exercise;
        of.assessment->lesson_hash(static_cast<std::uint64_t>(day));
        of.assessment->outcome(outcome);
        of.assessment->objectives({test::objective("run", objective != nullptr ? objective : outcome, 60)});
        of.assessment->practice(practice);
        if (restored) of.events.emplace_back().code("exercise.restored");
        return history.add(of, {{.pseudonym = "t1", .name = "", .group = "", .part = part}},
                           fmt::format("day {}", day));
    };
    const auto next = [&] { return history.next("t1", offered); };
    EXPECT_THROW(next(), std::invalid_argument) << "nobody of that name";
    done("lower", "not_yet");
    EXPECT_EQ(next()->lesson.id, "L02");
    EXPECT_THAT(next()->why, HasSubstr("not yet: Holds the fall"));
    EXPECT_THAT(next()->recording, HasSubstr("day 1"));
    EXPECT_EQ(next()->began_at, "2023-11-15T22:13:20Z") << "of the attempt whose objectives are told";
    EXPECT_TRUE(next()->practice) << "he missed it";
    done("lower", "achieved", true);
    EXPECT_EQ(next()->lesson.id, "L02") << "practice is no test";
    EXPECT_THAT(next()->why, HasSubstr("without hints"));
    EXPECT_FALSE(next()->practice);
    done("lower", "achieved", false, true);
    EXPECT_EQ(next()->lesson.id, "L02") << "who went on from a moment of an attempt was not tested";
    done("lower", "achieved", false, false, "from 4:00");
    EXPECT_EQ(next()->lesson.id, "L02") << "what was another's work, too, shows nobody's competence";
    EXPECT_THAT(next()->why, HasSubstr("now alone"));
    EXPECT_FALSE(next()->practice) << "he missed nothing";
    done("lower", "achieved", false, false, "", "not_yet");
    EXPECT_EQ(next()->lesson.id, "L02") << "an objective of it was not achieved";
    EXPECT_EQ(next()->why, "not yet: Holds the fall");
    EXPECT_FALSE(next()->practice);
    done("lower", "achieved");
    EXPECT_EQ(next()->lesson.id, "L01");
    EXPECT_EQ(next()->why, "not done yet");
    EXPECT_EQ(next()->began_at, "") << "of none";
    done("let-go", "achieved");
    done("lower", "not_yet"); // once achieved, it is
    EXPECT_EQ(next()->lesson.id, "L03");
    const std::string last = done("walk-back", "achieved", false, false, "", "not_yet");
    EXPECT_EQ(next()->lesson.id, "L03");
    history.confirm(last, {.by = "B. Holm", .outcome = "achieved", .note = "said by hand, I saw it"}, "");
    EXPECT_FALSE(next()) << "an assessor's word on the whole stands for its objectives";
}

TEST_F(HistoryTest, MarksAreThoseOfTheRecording) {
    const auto of = attempt("monday");
    {
        History history(file());
        const std::string id =
            history.add(of, {{.pseudonym = "t1", .name = "Anna Lind", .group = "deck 4"}}, "monday");
        EXPECT_EQ(id, debrief::attempt_id(of));
        const auto listed = history.list();
        ASSERT_THAT(listed, SizeIs(1));
        EXPECT_EQ(listed[0].attempt, id);
        EXPECT_EQ(listed[0].trainees, "t1 (forecastle)");
        EXPECT_EQ(listed[0].score, 660); // tenths of the topic's 66
        EXPECT_EQ(listed[0].outcome, "not_yet");
        EXPECT_EQ(listed[0].began_at, "2023-11-14T22:13:20Z") << "the recording's beginning, 1 700 000 000 s";
    }
    Database database(file()); // as anybody else reads it
    const auto marks =
        database.run("SELECT criterion, state, milli, weight, tick, ticks_outside, reason FROM mark");
    ASSERT_THAT(marks, SizeIs(4));
    EXPECT_EQ(text_of(marks[1][0]), "fall");
    EXPECT_EQ(text_of(marks[1][1]), "not_met");
    EXPECT_EQ(integer_of(marks[1][2]), 200);
    EXPECT_EQ(integer_of(marks[1][3]), 15);
    EXPECT_EQ(integer_of(marks[1][4]), 4100);
    EXPECT_EQ(integer_of(marks[1][5]), 320); // 3.2 s of 100 a second
    EXPECT_THAT(text_of(marks[1][6]), HasSubstr("6.9 m/s"));
    const auto said = database.run("SELECT kind, code, delay_ticks FROM said ORDER BY tick");
    ASSERT_THAT(said, SizeIs(3));
    EXPECT_EQ(text_of(said[0][1]), "let_go");
    EXPECT_EQ(integer_of(said[0][2]), 350); // repeated back 3.5 s later
    EXPECT_EQ(integer_of(database.run("PRAGMA user_version")[0][0]), kSchemaVersion);
    EXPECT_EQ(text_of(database.run("PRAGMA journal_mode")[0][0]), "wal");
    EXPECT_THAT(database.run("PRAGMA foreign_key_check"), IsEmpty());
}

TEST_F(HistoryTest, AttemptPutInTwiceIsOneWithBothSeats) {
    const auto of = attempt("monday");
    History history(file());
    history.add(of, {{.pseudonym = "t1", .name = {}, .group = {}}}, "monday");
    history.add(of, {{.pseudonym = "t2", .name = {}, .group = {}, .seat = "bridge"}}, "monday");
    ASSERT_THAT(history.list(), SizeIs(1));
    EXPECT_THAT(history.list()[0].trainees,
                testing::AllOf(HasSubstr("t1 (forecastle)"), HasSubstr("t2 (bridge)")));
    EXPECT_THAT(history.list({.trainee = "t2", .lesson = {}}), SizeIs(1));
    EXPECT_THAT(history.list({.trainee = "t3", .lesson = {}}), IsEmpty());
}

TEST_F(HistoryTest, SeatThatChangedHandsIsOfBothWithTheirParts) {
    const auto of = attempt("monday");
    History history(file());
    const Seated anna{.pseudonym = "t1", .name = {}, .group = {}, .part = "to 4:00"},
        ben{.pseudonym = "t2", .name = {}, .group = {}, .part = "from 4:00"};
    history.add(of, {anna, ben}, "monday");
    const std::string both = "t1 (forecastle to 4:00), t2 (forecastle from 4:00)";
    EXPECT_EQ(history.list()[0].trainees, both);
    history.add(of, {anna, ben}, "monday", true);
    EXPECT_EQ(history.list()[0].trainees, both) << "and not four";
    EXPECT_THAT(history.csv(false), HasSubstr(",forecastle,to 4:00,t1,"));
    history.add(of, {{.pseudonym = "t2", .name = {}, .group = {}}}, "monday", true);
    EXPECT_EQ(history.list()[0].trainees, "t2 (forecastle)");
}

TEST_F(HistoryTest, ErasedTraineeIsInTheFileNoMore) {
    const auto of = attempt("recording-of-anna");
    History history(file());
    history.add(of, {{.pseudonym = "alind", .name = "Anna Lind", .group = "deck 4"}},
                folder_ / "recording-of-anna");
    history.confirm(debrief::attempt_id(of).substr(0, 8),
                    {.by = "assessor", .score = 69, .note = "Anna saw the smoke first"},
                    "2026-11-22T15:00:00Z");
    ASSERT_THAT(bytes(), HasSubstr("Anna Lind"));
    const auto erased = history.erase("alind", "2026-11-23T10:00:00Z");
    EXPECT_THAT(erased.recordings, ElementsAre(HasSubstr("recording-of-anna")));
    for (const char* trace : {"Anna", "alind", "deck 4", "recording-of-anna"})
        EXPECT_THAT(bytes(), Not(HasSubstr(trace)));
    ASSERT_THAT(history.list(), SizeIs(1)) << "what was done stays, of nobody";
    EXPECT_EQ(history.list()[0].score, 690);
    EXPECT_EQ(history.list()[0].trainees, erased.pseudonym + " (forecastle)");
    EXPECT_THROW(history.erase("alind", ""), std::invalid_argument);
}

TEST_F(HistoryTest, AConfirmedScoreStandsBesideTheComputedOne) {
    const auto of = attempt("monday");
    History history(file());
    const std::string id = history.add(of, {{.pseudonym = "t1", .name = {}, .group = {}}}, "monday");
    const History::Word word{
        .by = "assessor", .score = 80.5, .outcome = "achieved", .note = "the counter had failed"};
    History::Word brief = word;
    brief.note = "too short";
    EXPECT_THROW(history.confirm(id, brief, ""), std::invalid_argument);
    EXPECT_THROW(history.confirm("zzzz", word, ""), std::invalid_argument);
    EXPECT_THROW(history.confirm("", word, ""), std::invalid_argument);
    EXPECT_EQ(history.confirm(id, word, "2026-11-22T15:00:00Z"), "80.5 points, achieved");
    history.add(of, {{.pseudonym = "t1", .name = {}, .group = {}}}, "monday");
    EXPECT_EQ(history.list()[0].score, 805) << "brought up to date, the assessor's word stays";
    EXPECT_EQ(history.list()[0].outcome, "achieved");
    EXPECT_EQ(history.list()[0].confirmed_by, "assessor");
    EXPECT_THAT(history.csv(false), HasSubstr(",66.0,80.5,achieved,not_yet,"));
}

TEST_F(HistoryTest, PracticeStandsThereAsPracticeAndIsNoTest) {
    auto of = attempt("monday");
    of.assessment->practice(true);
    of.assessment->outcome("achieved");
    of.assessment->hints().resize(2);
    History history(file());
    const std::string id = history.add(of, {{.pseudonym = "t1", .name = {}, .group = {}}}, "monday");
    ASSERT_THAT(history.list(), SizeIs(1));
    EXPECT_EQ(history.list()[0].outcome, "practice");
    EXPECT_EQ(history.list()[0].hints, 2);
    EXPECT_THAT(history.csv(false), HasSubstr(",practice,achieved,"));
    EXPECT_THROW(history.confirm(id, {.by = "Ann", .outcome = "achieved", .note = "seen it all"}, ""),
                 std::invalid_argument);
}

// The pass is 70: points and outcome that stand together do not contradict each other unless somebody says
// both.
TEST_F(HistoryTest, OutcomeFollowsFromAConfirmedScore) {
    auto of = attempt("monday");
    History history(file());
    const std::string missed = history.add(of, {{.pseudonym = "t1", .name = {}, .group = {}}}, "monday");
    const auto say = [](std::optional<double> score, const char* outcome = "") {
        return History::Word{
            .by = "Ann", .score = score, .outcome = outcome, .note = "the counter had failed"};
    };
    try {
        history.confirm(missed, say(80), "2026-11-22T15:00:00Z");
        FAIL() << "80 points and not yet";
    } catch (const std::invalid_argument& refused) {
        EXPECT_THAT(refused.what(),
                    HasSubstr("80 points reach the lesson's pass of 70, and not yet was computed"));
        EXPECT_THAT(refused.what(), HasSubstr("--outcome achieved, not_yet or not_shown"));
    }
    EXPECT_EQ(history.list()[0].confirmed_by, "") << "refused, it has changed nothing";
    EXPECT_EQ(history.confirm(missed, say({}), ""), "66.0 points, not yet");
    EXPECT_EQ(history.confirm(missed, say({}, "achieved"), ""), "66.0 points, achieved");
    EXPECT_THROW(history.confirm(missed, say(80, "passed"), ""), std::invalid_argument);

    of = attempt("tuesday", {.run = 8});
    of.assessment->outcome("achieved");
    const std::string reached = history.add(of, {{.pseudonym = "t1", .name = {}, .group = {}}}, "tuesday");
    EXPECT_EQ(history.confirm(reached, say(70), ""), "70.0 points, achieved, by the lesson's pass of 70");
    EXPECT_EQ(history.confirm(reached, say(60), ""), "60.0 points, not yet, by the lesson's pass of 70");
    EXPECT_EQ(history.confirm(reached, say(69.96), ""), "69.9 points, not yet, by the lesson's pass of 70");
    Database database(file());
    const auto row = database.run("SELECT outcome, outcome_final FROM attempt WHERE id = ?", {reached});
    EXPECT_EQ(text_of(row.at(0)[0]), "achieved") << "what was computed stays beside it";
    EXPECT_EQ(text_of(row.at(0)[1]), "not_yet");
}

TEST_F(HistoryTest, ExerciseThatWasEndedEarlyIsConfirmedByNobody) {
    auto of = attempt("monday");
    debrief::AssessorWord word{.time = 60, .by = "server", .command = {}};
    word.command.verdict(VERDICT_ENDED);
    of.words = {word};
    of.assessment->ending(LESSON_ENDED_EARLY);
    History history(file());
    history.add(of, {{.pseudonym = "t1", .name = {}, .group = {}}}, "monday");
    EXPECT_EQ(history.list()[0].confirmed_by, "");
    EXPECT_EQ(history.list()[0].ended, "instructor");
    EXPECT_THAT(Database(file()).run("SELECT * FROM override"), IsEmpty());
}

TEST_F(HistoryTest, WhatAnAssessorHasSetOfACriterionCountsBeforeTheWholeIsConfirmed) {
    auto of = attempt("monday");
    debrief::AssessorWord word;
    word.time = 30;
    word.by = "Ann";
    word.command.criterion("stance");
    word.command.verdict(VERDICT_MET);
    word.command.note("stood well clear");
    of.words = {word};
    of.assessment->score(66.3);
    History history(file());
    const std::string id = history.add(of, {{.pseudonym = "t1", .name = {}, .group = {}}}, "monday");
    EXPECT_EQ(history.list()[0].score, 663);
    EXPECT_EQ(history.list()[0].confirmed_by, "") << "the whole is confirmed by nobody yet";
    EXPECT_EQ(history.confirm(id, {.by = "Ann", .note = "as it stands"}, ""), "66.3 points, not yet");
}

// An assessor's word stands until he says another.
TEST_F(HistoryTest, ConfirmedOnceMoreWithoutAScoreItStandsAsItWasConfirmed) {
    History history(file());
    const std::string id =
        history.add(attempt("monday"), {{.pseudonym = "t1", .name = {}, .group = {}}}, "monday");
    const auto confirm = [&](std::optional<double> score, const char* outcome) {
        return history.confirm(
            id, {.by = "Ann", .score = score, .outcome = outcome, .note = "looked at once more"}, "");
    };
    EXPECT_EQ(confirm(80.5, "achieved"), "80.5 points, achieved");
    EXPECT_EQ(confirm({}, ""), "80.5 points, achieved");
    EXPECT_EQ(confirm({}, "not_yet"), "80.5 points, not yet");
    EXPECT_EQ(confirm({}, ""), "80.5 points, not yet");
    EXPECT_EQ(confirm(66, ""), "66.0 points, not yet, by the lesson's pass of 70")
        << "unless he says another";
    EXPECT_EQ(confirm({}, ""), "66.0 points, not yet");
    EXPECT_THAT(history.csv(false), HasSubstr(",66.0,66.0,not_yet,not_yet,"));
}

TEST_F(HistoryTest, WhatWasSetOfACriterionStandsWhenTheWholeIsConfirmedOnceMore) {
    auto of = attempt("monday");
    debrief::AssessorWord set{.time = 30, .by = "Ann", .command = {}},
        whole{.time = 40, .by = "Ann", .command = {}};
    set.command.criterion("stance");
    set.command.verdict(VERDICT_MET);
    set.command.note("stood well clear");
    whole.command.verdict(VERDICT_CONFIRMED);
    whole.command.note("as it stands");
    of.words = {set, whole};
    of.assessment->score(72);
    of.assessment->outcome("achieved");
    History history(file());
    const std::string id = history.add(of, {{.pseudonym = "t1", .name = {}, .group = {}}}, "monday");
    EXPECT_EQ(history.list()[0].confirmed_by, "Ann");
    EXPECT_EQ(history.confirm(id, {.by = "Ben", .note = "seen by two"}, "2026-11-22T15:00:00Z"),
              "72.0 points, achieved");
    EXPECT_THAT(history.csv(false), HasSubstr(",66.0,72.0,achieved,achieved,"));
}

TEST_F(HistoryTest, TwoHandsDoNotGetOneSeat) {
    const auto of = attempt("monday");
    History history(file());
    const Seated anna{.pseudonym = "anna", .name = {}, .group = {}},
        ben{.pseudonym = "ben", .name = {}, .group = {}};
    try {
        history.add(of, {anna, ben}, "monday");
        FAIL() << "one would be lost";
    } catch (const std::invalid_argument& refused) {
        EXPECT_THAT(refused.what(), HasSubstr("anna and ben cannot both have the seat \"forecastle\""));
    }
    EXPECT_THAT(history.list(), IsEmpty());
    history.add(of, {anna}, "monday");
    EXPECT_THROW(history.add(of, {ben}, "monday"), std::invalid_argument) << "nor one after the other";
    EXPECT_EQ(history.list()[0].trainees, "anna (forecastle)");
    history.add(of, {ben}, "monday", true);
    EXPECT_EQ(history.list()[0].trainees, "ben (forecastle)") << "unless that is said";
    Seated starboard = anna;
    starboard.seat = "starboard";
    history.add(of, {ben, starboard}, "monday");
    EXPECT_THAT(history.list()[0].trainees, HasSubstr("anna (starboard)"));
}

// Of the version before: what it called confirmed by the server was confirmed by nobody.
TEST_F(HistoryTest, FileOfVersionOneIsTakenOver) {
    {
        Database old(file());
        old.run_all(R"(
CREATE TABLE trainee(id INTEGER PRIMARY KEY, pseudonym TEXT UNIQUE NOT NULL, name TEXT, group_name TEXT, removed_at TEXT);
CREATE TABLE lesson(hash TEXT PRIMARY KEY, name TEXT NOT NULL, title TEXT NOT NULL, json TEXT NOT NULL);
CREATE TABLE attempt(id TEXT PRIMARY KEY, lesson_hash TEXT NOT NULL REFERENCES lesson, parent TEXT REFERENCES attempt,
  began_at TEXT NOT NULL, seed INTEGER NOT NULL, run INTEGER NOT NULL, recording TEXT, recording_sha256 TEXT,
  server_version TEXT, ended TEXT CHECK(ended IN('good','time','abort','instructor')), score_computed INTEGER,
  score_final INTEGER, outcome TEXT, assessment_hash TEXT, confirmed_by TEXT, confirmed_at TEXT);
CREATE TABLE seat(attempt TEXT REFERENCES attempt, trainee INTEGER REFERENCES trainee, seat TEXT, PRIMARY KEY(attempt, seat));
CREATE TABLE override(attempt TEXT REFERENCES attempt, criterion TEXT, by TEXT, at TEXT, verdict TEXT, milli INTEGER,
  note TEXT NOT NULL);
INSERT INTO lesson VALUES('h', 'l01', 'Let go', '');
INSERT INTO attempt(id, lesson_hash, began_at, seed, run, score_computed, score_final, outcome, confirmed_by, confirmed_at)
  VALUES('a1', 'h', '2026-01-01T00:00:00Z', 1, 1, 800, 800, 'achieved', 'server', '2026-01-01T00:00:00Z'),
        ('a2', 'h', '2026-01-02T00:00:00Z', 1, 2, 800, 750, 'achieved', 'Ann', '2026-01-02T00:00:00Z');
INSERT INTO trainee VALUES(1, 't1', NULL, NULL, NULL);
INSERT INTO seat VALUES('a2', 1, 'forecastle');
INSERT INTO override VALUES('a1', '', 'server', '2026-01-01T00:00:00Z', 'confirmed', 0, 'exercise ended: end');
PRAGMA user_version = 1;)");
    }
    History history(file());
    const auto listed = history.list();
    ASSERT_THAT(listed, SizeIs(2));
    EXPECT_EQ(listed[0].confirmed_by, "");
    EXPECT_EQ(listed[1].confirmed_by, "Ann");
    EXPECT_EQ(listed[1].score, 750);
    EXPECT_EQ(listed[1].trainees, "t1 (forecastle)") << "his from beginning to end";
    EXPECT_EQ(listed[1].outcome, "achieved") << "of a time when every attempt was a test";
    EXPECT_THROW(history.confirm("a2", {.by = "Ann", .score = 60, .note = "seen once more"}, ""),
                 std::invalid_argument)
        << "its pass is not known";
    EXPECT_EQ(
        history.confirm("a2", {.by = "Ann", .score = 60, .outcome = "not_yet", .note = "seen once more"}, ""),
        "60.0 points, not yet");
    EXPECT_THAT(History(file()).list(), SizeIs(2)) << "opened again";
}

TEST_F(HistoryTest, ExportHasNamesOnlyWhereTheyAreAskedFor) {
    History history(file());
    history.add(attempt("monday"), {{.pseudonym = "t1", .name = "Lind, \"Anna\"", .group = {}}}, "monday");
    EXPECT_THAT(history.csv(false), Not(HasSubstr("Lind")));
    EXPECT_THAT(history.csv(false), HasSubstr(",forecastle,,t1,"));
    EXPECT_THAT(history.csv(true), HasSubstr("\"Lind, \"\"Anna\"\"\"\r\n"));
    EXPECT_THAT(history.csv(true), HasSubstr("\"let-go <port> & \"\"25m\"\"\""));
}

TEST_F(HistoryTest, WhatIsOlderIsRemovedWithWhatHangsOnIt) {
    History history(file());
    history.add(attempt("monday"), {{.pseudonym = "t1", .name = "Anna Lind", .group = {}}}, "monday");
    EXPECT_EQ(history.keep_since("2023-11-14T22:13:20Z"), 0) << "as old as that, and no older";
    EXPECT_EQ(history.keep_since("2023-11-14T22:13:21Z"), 1);
    EXPECT_THAT(history.list(), IsEmpty());
    EXPECT_THAT(bytes(), Not(HasSubstr("Anna Lind")));
    Database database(file());
    for (const char* table :
         {"trainee", "lesson", "attempt", "seat", "mark", "objective", "override", "said"})
        EXPECT_THAT(database.run(std::string("SELECT * FROM ") + table), IsEmpty()) << table;
}

TEST_F(HistoryTest, BadInputLosesNothing) {
    const auto of = attempt("monday");
    History history(file());
    for (const char* wrong : {"", "a,b", "anna@school.example", "a\nb"})
        EXPECT_THROW(history.add(of,
                                 {{.pseudonym = "t1", .name = {}, .group = {}},
                                  {.pseudonym = wrong, .name = {}, .group = {}, .seat = "bridge"}},
                                 "monday"),
                     std::invalid_argument)
            << wrong;
    EXPECT_THAT(history.list(), IsEmpty()) << "not half of it";
    history.add(of, {{.pseudonym = "t1'); DROP TABLE seat; --", .name = {}, .group = {}}}, "monday");
    EXPECT_THAT(history.list(), SizeIs(1));
}

TEST_F(HistoryTest, FileOfSomethingElseIsLeftAlone) {
    test::put(file(), "this is no database, but a letter of some length that is to stay as it is");
    EXPECT_THROW(History{file()}, std::runtime_error);
    EXPECT_THAT(test::content(file()), HasSubstr("letter"));
    {
        Database other(folder_ / "other.sqlite");
        other.run("CREATE TABLE things(a)");
    }
    EXPECT_THROW(History{folder_ / "other.sqlite"}, std::runtime_error);
    Database(folder_ / "later.sqlite").run_all("PRAGMA user_version = 99");
    EXPECT_THROW(History{folder_ / "later.sqlite"}, std::runtime_error);
}

TEST_F(HistoryTest, FileIsItsOwnersAlone) {
    History history(file());
    namespace fs = std::filesystem;
    EXPECT_EQ(fs::status(file()).permissions() & (fs::perms::group_all | fs::perms::others_all),
              fs::perms::none);
}

} // namespace
} // namespace windlass::history
