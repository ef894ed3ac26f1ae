// Simulated centres: the same seed is the same centre, and what is done to one on purpose is found.

#include "server/config/config.hpp"
#include "server/exercise/prelude.hpp"
#include "sim/centre.hpp"
#include "sim/checks.hpp"
#include "sim/disk.hpp"
#include "sim/drawn_exercise.hpp"

#include "tests/sim/first_failure.hpp"

#include <gmock/gmock.h>

#include <system_error>

namespace windlass::sim {
namespace {

using testing::HasSubstr;

TEST(Centre, OfTheSameSeedIsTheSame) {
    for (const std::uint64_t seed : {1U, 5U, 7U}) {
        Plan plan;
        plan.seed = seed;
        const Outcome once = run(plan), again = run(plan);
        EXPECT_EQ(once.digest, again.digest) << seed;
        EXPECT_EQ(once.simulated, again.simulated) << seed;
        EXPECT_EQ(once.recordings, again.recordings) << seed;
        EXPECT_EQ(once.recorder_kills, again.recorder_kills) << seed;
        EXPECT_GT(once.ticks, 0U);
    }
}

TEST(Centre, OfAnotherSeedIsAnother) {
    EXPECT_NE(run({.seed = 1}).digest, run({.seed = 2}).digest);
}

TEST(Centre, IsAskedForPredictions) {
    std::uint64_t made = 0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
        made += run({.seed = seed}).predictions;
    EXPECT_GT(made, 0U);
}

TEST(Centre, HasFreezesThatAreAnsweredPassedOverAndStandAgainAfterALoss) {
    Outcome all;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        if (!draws_questions(seed)) continue;
        const Outcome found = run({.seed = seed});
        EXPECT_FALSE(found.failed) << seed;
        all.questions += found.questions, all.answered += found.answered;
        all.passed_over += found.passed_over, all.stood_again += found.stood_again;
    }
    EXPECT_GT(all.answered, 0U);
    EXPECT_GT(all.passed_over, 0U);
    EXPECT_GT(all.stood_again, 0U);
    EXPECT_GT(all.questions, all.stood_again);
}

// A page's hand that goes on within the tick in which another station takes its levers; an alert that is told
// anew behind a restore to before it was raised. The checks did not know of these.
TEST(Centre, OfSeedsForWhichItsChecksWereWrongHoldsNow) {
    for (const std::uint64_t seed : {1502U, 9324U})
        EXPECT_FALSE(run({.seed = seed}).failed) << "seed " << seed;
}

TEST(Centre, HasLetGosAmongItsSeeds) {
    std::size_t held = 0, let_go = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed)
        ++(drawn_exercise(seed).tick_rate_hz == 100 ? held : let_go);
    EXPECT_GT(held, let_go);
    EXPECT_GT(let_go, 3U);
}

TEST(Centre, NotDrawnFromItsSeedAloneIsNotTheSame) {
    const Plan plan{.seed = 1, .minutes = 0.2, .sabotage = Sabotage::chance};
    EXPECT_NE(run(plan).digest, run(plan).digest);
}

TEST(Checks, FindThatTheLastRecordsAreLost) {
    EXPECT_EQ(first_failure(Sabotage::last_record_lost, 10), "kept");
}

TEST(Checks, FindAnOrderThatIsNotTheOneThatWasTaken) {
    EXPECT_EQ(first_failure(Sabotage::order_altered, 10), "state");
}

TEST(Checks, FindMarksThatAreNotThoseOfTheUndisturbedLesson) {
    Plan lesson{.def = exercise::with_prelude_played(
                    config::load_exercise(WINDLASS_CONFIG_DIR "/exercises/L01_let_go_25m.json"))};
    const Outcome well = run(lesson);
    EXPECT_FALSE(well.failed) << well.failed->what.check;
    lesson.sabotage = Sabotage::marks_altered;
    const Outcome found = run(lesson);
    ASSERT_TRUE(found.failed);
    EXPECT_EQ(found.failed->what.check, "marks");
}

TEST(Checks, FindALeverThatNoHandMoves) {
    EXPECT_EQ(first_failure(Sabotage::ghost_hand, 10), "levers");
}

TEST(Checks, FindLeversThatAreToldToBeAnotherHands) {
    EXPECT_EQ(first_failure(Sabotage::taking_altered, 10), "takings");
}

TEST(Checks, FindAQuestionThatIsNotTold) {
    EXPECT_EQ(first_failure(Sabotage::question_untold, 10), "questions");
}

TEST(Checks, FindAFreezeThatNoInstructorAndNoAnswerEnded) {
    EXPECT_EQ(first_failure(Sabotage::question_passed_over, 10), "questions");
}

TEST(Checks, FindAnEventThatIsNotTold) {
    EXPECT_EQ(first_failure(Sabotage::event_lost, 10), "events");
}

TEST(Checks, FindAnAlertThatIsNotTold) {
    EXPECT_EQ(first_failure(Sabotage::alert_untold, 10), "alerts");
}

/// A session whose orders come as they are sent, looked at by the checks.
class Checked {
public:
    explicit Checked(exercise::ExerciseDef def = {}) : session_(std::move(def), options()) {
        checks_.begins(session_, {.first = true});
    }

    void send(Sent sent) {
        mailbox_.put(sent.sample, sent.writer, sent.instructor, sent.moved_in_run);
        checks_.hears(sent);
    }
    void leave(const wire::WriterId& writer) {
        mailbox_.leave(writer);
        checks_.leaves(writer);
    }
    /// A word of a hand at the port windlass, of a writer of that number. moved_at: s, each of its levers.
    void say(std::uint8_t writer, std::uint64_t serial, WindlassCommand levers, double moved_at = 0,
             std::uint64_t moved_in_run = 0) {
        levers.origin().source("anna"), levers.origin().serial(serial);
        Sent sent{.sample = levers, .writer = {writer}, .moved_in_run = moved_in_run};
        sent.moved_at.fill(moved_at);
        send(sent);
    }
    void order(ExerciseAction action, double restore_time = 0) {
        ExerciseCommand command;
        command.action(action);
        command.time_scale(1), command.restore_time(restore_time);
        command.origin().source("desk"), command.origin().serial(++serial_);
        mailbox_.put(command, {255});
    }
    /// The forecastle's, that it cannot tell.
    void answer(const char* question) {
        dds::ForecastleAnswer answer;
        answer.question(question), answer.kind(ANSWER_NOT_KNOWN);
        answer.origin().source("anna"), answer.origin().serial(++serial_);
        mailbox_.put(answer, {254});
    }
    /// Ticks for so many seconds, or once.
    void go_on(double seconds = 0) {
        for (const double until = now_ + seconds; now_ <= until; now_ += session_.dt()) {
            mailbox_.drain(session_.limits(), inbox_);
            session_.carry_out(inbox_, now_);
            session_.tick();
            checks_.look(session_, inbox_, now_, "");
            session_.clear_news();
        }
    }
    /// What the checks find until the end.
    std::string failure(double seconds = 0) {
        try {
            go_on(seconds);
            checks_.end();
        } catch (const Failure& found) {
            return found.check + ": " + found.expected + ", " + found.found;
        }
        return "";
    }
    /// What they find of the next server, where what ran is to run on, as it takes the exercise up so.
    std::string taken_up(exercise::RunState state) {
        checks_.handed_over(checks_.place());
        checks_.starts({});
        run::SessionOptions next = options();
        next.first_run = 200;
        run::Resumption& how = next.resumption.emplace();
        how.checkpoint = session_.state();
        how.state = state;
        const run::Session taken(session_.def(), std::move(next));
        try {
            checks_.begins(taken, {.taken_up = true, .running = true});
        } catch (const Failure& found) {
            return found.check + ": " + found.expected + ", " + found.found;
        }
        return "";
    }

private:
    static run::SessionOptions options() {
        run::SessionOptions options;
        options.first_run = 100;
        options.seed = 1;
        return options;
    }

    const World world_{1};
    Checks checks_{world_};
    run::Session session_;
    dds::Mailbox mailbox_;
    run::Inbox inbox_;
    std::uint64_t serial_ = 0;
    double now_ = 0; // s
};

TEST(Checks, FindACourseThatIsSetBackForLossesOfTheOneBefore) {
    for (int losses = 0; losses < 3; ++losses) {
        const World world(1);
        Checks checks(world);
        const run::Session session({}, {});
        checks.begins(session, {.first = true});
        checks.handed_over(checks.place());
        for (int k = 0; k <= losses; ++k)
            checks.starts({});
        const Beginning back{.refused = "lost twice", .set_back = "lost twice", .attempts = 2};
        if (losses < 2)
            EXPECT_THROW(checks.begins(session, back), Failure) << losses;
        else
            EXPECT_NO_THROW(checks.begins(session, back));
    }
}

// At their beginnings two courses of an exercise have one state; a power cut may bring back the one that a
// disk which refused kept from being put aside, with its losses (seed 60463).
TEST(Checks, CountTheLossesOfAnOldCourseThatMayBeTheOneThatWasTakenUp) {
    for (const int losses : {0, 2}) {
        const World world(1);
        Checks checks(world);
        const run::Session session({}, {});
        checks.begins(session, {.first = true});
        for (int k = 0; k < losses; ++k)
            checks.starts({});
        checks.begins(session, {}); // anew
        checks.starts({.lost_by = Loss::power_cut});
        checks.begins(session, {.lost_by = Loss::power_cut, .taken_up = true});
        checks.starts({.lost_by = Loss::power_cut});
        const Beginning back{
            .lost_by = Loss::power_cut, .refused = "lost twice", .set_back = "lost twice", .attempts = 2};
        if (losses == 0)
            EXPECT_THROW(checks.begins(session, back), Failure);
        else
            EXPECT_NO_THROW(checks.begins(session, back));
    }
}

TEST(Checks, FindALossThatIsCountedOfAServerThatEndedByItself) {
    const World world(1);
    for (const std::size_t attempts : {0U, 1U}) {
        Checks checks(world);
        checks.begins(run::Session({}, {}), {.first = true});
        checks.left_whole();
        if (attempts > 0)
            EXPECT_THROW(checks.starts({.attempts = attempts}), Failure);
        else
            EXPECT_NO_THROW(checks.starts({.attempts = attempts}));
    }
}

TEST(Checks, FindACourseThatIsSetBackForLossesBeforeAServerThatEndedByItself) {
    const World world(1);
    const run::Session session({}, {});
    for (const bool left : {false, true}) {
        Checks checks(world);
        checks.begins(session, {.first = true});
        checks.handed_over(checks.place());
        for (int k = 0; k < 3; ++k) {
            checks.starts({});
            if (left && k == 0) checks.left_whole();
        }
        const Beginning back{.refused = "lost twice", .set_back = "lost twice", .attempts = 2};
        if (left)
            EXPECT_THROW(checks.begins(session, back), Failure);
        else
            EXPECT_NO_THROW(checks.begins(session, back));
    }
}

TEST(Centre, BeginsAnewWhenItIsTold) {
    std::uint64_t left = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed)
        left += run({.seed = seed, .minutes = 0.5}).left;
    EXPECT_GT(left, 0U);
}

WindlassCommand levers(double brake, double speed_lever = 0) {
    WindlassCommand levers;
    levers.brake(brake), levers.speed_lever(speed_lever);
    return levers;
}

TEST(Checks, TakeNoWordForTheOneThatWasTakenWhichCameBehindALaterOne) {
    Checked centre;
    centre.say(1, 1, levers(1), 0, 99); // lies there from another run
    centre.say(1, 3, levers(0.5), 3);
    centre.say(1, 2, levers(1), 0); // refused
    centre.say(1, 4, levers(1), 4);
    EXPECT_EQ(centre.failure(), "");
}

TEST(Checks, KnowALateWordOfAHandsKilledProgram) {
    Checked centre;
    centre.say(1, 1, levers(1), 0, 99);
    centre.say(2, 1, levers(0.5), 2, 100);
    centre.say(1, 2, levers(1), 0, 99);
    EXPECT_EQ(centre.failure(), "");
}

TEST(Checks, KnowALateWordOfAnInstructorWhoHasLetGo) {
    Checked centre;
    Sent desk{.sample = levers(0.5), .writer = {3}, .instructor = true};
    std::get<WindlassCommand>(desk.sample).origin().source("desk");
    for (std::uint64_t serial = 1; serial <= 2; ++serial) {
        std::get<WindlassCommand>(desk.sample).origin().serial(serial);
        centre.send(desk);
        if (serial == 1) centre.leave(desk.writer);
        centre.go_on(0.1);
    }
    centre.go_on(0.5);
    centre.say(1, 1, levers(1));
    EXPECT_EQ(centre.failure(), "");
}

TEST(Checks, FindAHandThatLayThereAndMovesALeverWithoutAHand) {
    Checked centre;
    centre.say(1, 1, levers(1), 0);
    centre.go_on();
    centre.order(EXERCISE_RESET);
    centre.go_on();
    centre.say(1, 2, levers(0.5), 0); // as no hand can have it
    EXPECT_THAT(centre.failure(), HasSubstr("levers: lever 0 of the port windlass stays at 1"));
}

TEST(Checks, KnowARunWhoseFirstCheckpointThatIsToldHasOrdersInIt) {
    for (const ExerciseAction action : {EXERCISE_RESET, EXERCISE_RESTORE}) {
        Checked centre;
        centre.say(1, 1, levers(1));
        centre.go_on(1);
        centre.order(EXERCISE_SNAPSHOT);
        centre.go_on(1);
        centre.order(action, 1.5);
        centre.say(1, 2, levers(0.5), 2);
        centre.order(EXERCISE_SNAPSHOT);
        centre.order(EXERCISE_START);
        EXPECT_EQ(centre.failure(1), "") << action;
    }
}

// Its state would be the same had it been set up anew: the word says where every lever is.
TEST(Checks, KnowARunThatIsRestoredToItsVeryBeginningByTheLeversThatLayThere) {
    Checked centre;
    centre.say(1, 1, levers(0.5), 0);
    centre.order(EXERCISE_SNAPSHOT);
    centre.go_on(1);
    centre.order(EXERCISE_RESTORE, 0);
    centre.say(1, 2, levers(0.5), 0);
    centre.order(EXERCISE_SNAPSHOT);
    centre.order(EXERCISE_START);
    EXPECT_EQ(centre.failure(1), "");
}

// It is an order of the tick at which the exercise stood, and changes nothing but the lesson.
TEST(Checks, KnowThatAnAnswerIsNotInTheMomentBeforeItThatIsRestored) {
    Checked centre(with_questions({}));
    centre.go_on(6.5);
    centre.order(EXERCISE_SNAPSHOT);
    centre.go_on();
    centre.answer("out");
    centre.go_on(0.1);
    centre.order(EXERCISE_RESTORE, 6);
    EXPECT_EQ(centre.failure(0.1), "");
}

TEST(Checks, FindAnExerciseThatHeldForAQuestionAndStandsUntilSomebodyStartsIt) {
    using exercise::RunState;
    for (const bool paused : {false, true}) { // besides, by an instructor
        Checked one(with_questions({})), other(with_questions({}));
        for (Checked* centre : {&one, &other}) {
            centre->go_on(6.5);
            if (paused) centre->order(EXERCISE_PAUSE);
            centre->go_on();
        }
        const std::string holds = one.taken_up(RunState::running), stands = other.taken_up(RunState::paused);
        EXPECT_EQ(holds, paused ? "kept: the exercise stands, it goes on" : "");
        EXPECT_EQ(stands, paused ? ""
                                 : "kept: the exercise runs on, or holds for its question, "
                                   "it stands until somebody starts it");
    }
}

// The one's word is of a run that another followed in the same tick, and is not looked at.
TEST(Checks, KnowALossOfAHandOfWhichTwoProgramsWereHeardTogether) {
    Checked centre;
    centre.order(EXERCISE_RESET);
    centre.say(1, 1, levers(1));
    centre.order(EXERCISE_RESET);
    centre.say(2, 1, levers(1));
    centre.order(EXERCISE_START);
    centre.go_on();
    centre.leave({2});
    EXPECT_EQ(centre.failure(1), "");
}

TEST(Checks, CountTheSilenceOfARunFromItsBeginning) {
    Checked centre;
    centre.say(1, 1, levers(1, -0.5));
    centre.go_on(1);
    centre.order(EXERCISE_SNAPSHOT);
    centre.go_on(kHandSilent);
    centre.order(EXERCISE_RESTORE, 1.5);
    centre.order(EXERCISE_START);
    EXPECT_EQ(centre.failure(2 * kHandSilent), "");
}

/// Bytes for a file.
std::vector<std::uint8_t> bytes(std::size_t count) {
    return std::vector<std::uint8_t>(count, 'x');
}

TEST(SimDisk, HasAfterAPowerCutWhatItWasWaitedForAndOfTheRestAnyPart) {
    bool less = false, all = false;
    for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
        World world(seed);
        SimDisk disk(world);
        disk.make_folder("/kept");
        const auto file = disk.make("/kept/a", files::ReadBy::owner);
        file->append(bytes(100));
        file->sync();
        disk.sync_folder("/kept");
        file->append(bytes(100));
        disk.lose(Loss::power_cut);
        const auto left = disk.read("/kept/a");
        ASSERT_GE(left.size(), 100U);
        EXPECT_EQ(std::vector(left.begin(), left.begin() + 100), bytes(100));
        less = less || left.size() < 200;
        all = all || left == bytes(200);
    }
    EXPECT_TRUE(less);
    EXPECT_TRUE(all);
}

TEST(SimDisk, AddsUpWhatItTakesForWhoWillSitItOut) {
    World world(1);
    SimDisk disk(world);
    disk.took = 0;
    disk.write_takes = 2, disk.sync_takes = 3;
    const auto file = disk.make("/a", files::ReadBy::all);
    file->append(bytes(100));
    file->sync();
    EXPECT_EQ(disk.took, 5.0);
    EXPECT_EQ(world.now(), 0) << "the world has not gone on";
}

TEST(SimDisk, HasAllThatAKilledServerHandedOver) {
    World world(1);
    SimDisk disk(world);
    disk.make("/a", files::ReadBy::owner)->append(bytes(100));
    disk.lose(Loss::killed);
    EXPECT_EQ(disk.read("/a"), bytes(100));
}

TEST(SimDisk, ThatIsFullTakesWhatItHasRoomForAndRefusesTheRest) {
    World world(1);
    SimDisk disk(world);
    disk.room = 60;
    const auto file = disk.make("/a", files::ReadBy::owner);
    EXPECT_EQ(file->append(bytes(100)), 60U);
    EXPECT_THROW(file->append(bytes(1)), std::system_error);
}

TEST(SimDisk, LosesTheServerAtTheCallThatWasDrawn) {
    World world(1);
    SimDisk disk(world);
    const auto file = disk.make("/a", files::ReadBy::owner);
    disk.lose_in(2, Loss::killed);
    file->append(bytes(10));
    EXPECT_THROW(file->append(bytes(10)), Crash);
    EXPECT_THROW(disk.make("/b", files::ReadBy::owner), Crash) << "it makes no more calls";
    disk.lose(Loss::killed);
    EXPECT_GE(disk.read("/a").size(), 10U);
}

} // namespace
} // namespace windlass::sim
