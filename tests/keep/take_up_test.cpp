// What was kept is worked again, or refused in a sentence and put aside.

#include "tests/keep/let_go.hpp"
#include "tests/recorder/folder.hpp"

#include "server/config/config.hpp"
#include "server/exercise/prelude.hpp"
#include "server/keep/kept_file.hpp"

#include "idl/payload.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace windlass::keep {
namespace {

using exercise::RunState;
using run::RunAction;
using test::LetGo;
using testing::AllOf;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::SizeIs;

std::string text_of(const run::Session& session, const std::string& code) {
    for (const auto& event : session.events())
        if (event.code == code) return event.text;
    return "";
}

class TakenUpTest : public testing::Test {
protected:
    /// A server runs the let-go up to that tick, and is lost.
    void lose_at(std::uint64_t tick, std::optional<run::Resumption> resumption = {}) {
        KeptExercise kept(path_, "anna", test::let_go_hash());
        LetGo let_go(std::move(resumption));
        let_go.look(&kept);
        kept.write_waiting();
        if (let_go.session().status().state == RunState::paused && tick > let_go.session().now_tick())
            let_go.give(RunAction::start);
        while (let_go.session().now_tick() < tick) {
            let_go.go_to(std::min(let_go.session().now_tick() + 30, tick), &kept);
            kept.write_waiting();
            kept.sync();
        }
        kept.write_waiting();
    }
    std::optional<TakenUp> taken_up(TakeUp wanted = {.definition_hash = test::let_go_hash(),
                                                     .check = {}}) const {
        return take_up(path_, "anna", folder_ / "aside", wanted);
    }
    /// The newest file, with each of its records as another has it; an empty one is left out.
    template <class Change>
    void forge(const Change& change) const {
        const auto file = kept_files(path_).back();
        const auto forged = folder_ / "forged";
        {
            const KeptContents contents(file);
            KeptWriter writer(forged);
            for (const auto& [kind, at, payload] : contents.entries())
                if (const std::vector<std::uint8_t> bytes = change(kind, payload); !bytes.empty())
                    writer.add(kind, bytes);
            writer.write();
        }
        std::filesystem::rename(forged, file);
    }
    static std::vector<std::uint8_t> same(files::Bytes payload) { return {payload.begin(), payload.end()}; }
    static double time(const std::optional<TakenUp>& taken) {
        return taken && taken->def ? LetGo(taken->how).session().now_time() : -1;
    }

    const windlass::test::Folder folder_;
    const std::filesystem::path path_ = folder_ / "exercise-anna";
};

TEST_F(TakenUpTest, StandsPausedWithTheSameStateAndEverybodyIsTold) {
    lose_at(3725);
    const auto taken = taken_up();
    ASSERT_TRUE(taken && taken->def);
    LetGo again(taken->how), undisturbed;
    undisturbed.go_to(3725);
    const run::Session& session = again.session();
    EXPECT_EQ(session.snapshot().state_hash, undisturbed.session().snapshot().state_hash);
    EXPECT_EQ(session.status().state, RunState::paused);
    EXPECT_EQ(text_of(session, "exercise.taken_up"),
              "taken up again at 0:12 after the server was lost, paused");
    EXPECT_THAT(session.alerts(), ElementsAre(Field(&run::AlertView::code, "cable.fast"))) << "as it runs";
    ASSERT_NE(session.checkpoint(), nullptr) << "a recording goes on with it";
    EXPECT_EQ(session.checkpoint()->data, taken->how.checkpoint);
}

TEST_F(TakenUpTest, LeversAreNobodysUntilAHandMovesThem) {
    lose_at(450);
    const auto taken = taken_up();
    ASSERT_TRUE(taken && taken->def);
    LetGo again(taken->how);
    run::Session& session = again.session();
    session.clear_news();
    run::Inbox inbox; // a hand from before, that goes on sending where its own stand
    inbox.orders.push_back({.source = "trainee",
                            .what = exercise::Order(exercise::WindlassOrder{.brake = 1}),
                            .writer = {1},
                            .moved_in_run = session.status().run + 1000});
    session.carry_out(inbox, 0.1);
    ASSERT_THAT(session.orders(), SizeIs(1));
    const auto& order = std::get<exercise::WindlassOrder>(session.orders().front().command);
    EXPECT_EQ(order.brake, std::get<exercise::WindlassOrder>(*test::order_at(435)).brake)
        << "as it was found";
}

TEST_F(TakenUpTest, RunsOnWhereThatIsWantedAndItRan) {
    lose_at(450);
    const auto taken = taken_up({.definition_hash = test::let_go_hash(), .check = {}, .running = true});
    ASSERT_TRUE(taken && taken->def);
    EXPECT_EQ(LetGo(taken->how).session().status().state, RunState::running);
    lose_at(450, taken->how); // and once more, as it stands paused
    KeptExercise kept(path_, "anna", test::let_go_hash());
    LetGo paused(taken->how);
    paused.give(RunAction::pause);
    paused.look(&kept);
    kept.write_waiting();
    const auto again = taken_up({.definition_hash = test::let_go_hash(), .check = {}, .running = true});
    ASSERT_TRUE(again && again->def);
    EXPECT_EQ(LetGo(again->how).session().status().state, RunState::paused) << "somebody had paused it";
}

TEST_F(TakenUpTest, HoldsForItsQuestionAgainWhereItWasToRunOnAndGoesOnOnceThatIsAnswered) {
    exercise::ExerciseDef def;
    def.lesson = R"({"id": "T", "criteria": [)"
                 R"({"id": "out", "kind": "question", "ask": "How much is out?", "of": "cable_out",)"
                 R"( "tolerance": 2, "when": {"time": 1, "cable_speed": {"below": 99}}}]})";
    const std::uint64_t hash = exercise::definition_hash(def);
    for (const bool paused : {false, true}) { // besides, by an instructor
        KeptExercise kept(path_, "anna", hash);
        LetGo let_go({}, def);
        let_go.look(&kept);
        let_go.go_to(600, &kept);
        ASSERT_TRUE(let_go.session().held());
        if (paused) let_go.give(RunAction::pause);
        let_go.look(&kept);
        kept.write_waiting();
        const auto taken = taken_up({.definition_hash = hash, .check = {}, .running = true});
        ASSERT_TRUE(taken && taken->def) << (taken ? taken->how.refused : "nothing is kept");
        LetGo again(taken->how, def);
        run::Session& session = again.session();
        EXPECT_EQ(session.now_tick(), 300U);
        EXPECT_EQ(session.status().state, RunState::paused);
        EXPECT_EQ(session.held(), !paused);
        ASSERT_FALSE(session.questions().empty());
        EXPECT_EQ(session.questions().back().id, "out");
        run::Inbox inbox;
        inbox.orders.push_back(
            {"trainee",
             run::AnswerOrder{true, {.question = "out", .kind = exercise::AnswerKind::number, .value = 5}}});
        session.carry_out(inbox, session.now_time());
        EXPECT_EQ(session.running(), !paused);
    }
}

TEST_F(TakenUpTest, ComesBackAgainAndAgainWhenTheServerIsLostAgainAndAgain) {
    lose_at(1000);
    for (const std::uint64_t tick : {4000, 7100, 10'200}) { // each time behind its next checkpoint
        const auto taken = taken_up();
        ASSERT_TRUE(taken && taken->def);
        EXPECT_EQ(taken->how.set_back, "");
        lose_at(tick, taken->how);
    }
    LetGo undisturbed;
    undisturbed.go_to(10'200);
    const auto taken = taken_up();
    ASSERT_TRUE(taken && taken->def);
    EXPECT_EQ(LetGo(taken->how).session().snapshot().state_hash, undisturbed.session().snapshot().state_hash);
}

TEST_F(TakenUpTest, LessonIsMarkedOnAsIfNothingHadHappened) {
    const auto def = config::load_exercise(WINDLASS_CONFIG_DIR "/exercises/L01_let_go_25m.json");
    const std::uint64_t hash = exercise::definition_hash(def);
    const auto run_to = [&](LetGo& let_go, std::uint64_t tick, KeptExercise* kept) {
        while (let_go.session().now_tick() < tick) {
            let_go.go_to(std::min(let_go.session().now_tick() + 30, tick), kept);
            if (kept != nullptr) kept->write_waiting();
        }
    };
    {
        KeptExercise kept(path_, "anna", hash);
        LetGo let_go({}, def);
        let_go.look(&kept);
        run_to(let_go, 3500, &kept);
    }
    const auto taken = taken_up({.definition_hash = hash, .check = config::check_definition});
    ASSERT_TRUE(taken && taken->def) << (taken ? taken->how.refused : "nothing is kept");
    LetGo again(taken->how, def), undisturbed({}, def);
    again.give(RunAction::start);
    run_to(again, 5000, nullptr);
    run_to(undisturbed, 5000, nullptr);
    EXPECT_EQ(again.hash(), undisturbed.hash());
    EXPECT_EQ(again.session().assessor().result().assessment_hash,
              undisturbed.session().assessor().result().assessment_hash);
}

TEST_F(TakenUpTest, StateThatEndsTheServerTwiceIsLeftForTheCheckpointBeforePausedWithAnAlarm) {
    lose_at(3600);
    EXPECT_EQ(time(taken_up()), 12); // the first start dies of it
    const auto second = taken_up();  // and the second, once it has stood there
    EXPECT_EQ(time(second), 12);
    lose_at(3600, second->how);
    const auto third = taken_up({.definition_hash = test::let_go_hash(), .check = {}, .running = true});
    ASSERT_TRUE(third && third->def);
    LetGo back(third->how);
    EXPECT_EQ(back.session().now_time(), 10);
    EXPECT_EQ(back.session().status().state, RunState::paused) << "though it was to run on";
    ASSERT_THAT(back.session().alerts(), SizeIs(1));
    EXPECT_EQ(back.session().alerts().front().code, "exercise.set_back");
    EXPECT_EQ(back.session().alerts().front().priority, run::AlertPriority::alarm);
    EXPECT_THAT(back.session().alerts().front().explanation,
                AllOf(HasSubstr("its state at 0:12 ended the server 2 times"), HasSubstr("aside")));
    EXPECT_FALSE(kept_files(folder_ / "aside" / "anna-1").empty());
    EXPECT_EQ(time(taken_up()), 10) << "lost again before it kept anything: without what came behind that";
}

TEST_F(TakenUpTest, StateThatEndsTheServerTwiceWithoutACheckpointBeforeBeginsFromTheFileAndWaits) {
    lose_at(600);
    taken_up();
    taken_up();
    const auto third = taken_up();
    ASSERT_TRUE(third && !third->def);
    LetGo anew(third->how);
    EXPECT_EQ(anew.session().now_tick(), 0U);
    EXPECT_EQ(anew.session().status().state, RunState::ready);
    EXPECT_EQ(anew.session().alerts().front().code, "exercise.set_back");
    EXPECT_FALSE(taken_up()) << "nothing is kept any more";
}

TEST_F(TakenUpTest, OtherExerciseFileIsNotTakenForAStateThatEndsTheServer) {
    lose_at(600);
    taken_up();
    taken_up();
    const auto third = taken_up({.definition_hash = 1, .check = {}});
    ASSERT_TRUE(third && !third->def);
    EXPECT_EQ(third->how.set_back, "");
    EXPECT_THAT(third->how.refused, HasSubstr("it was changed, or is another one"));
}

TEST_F(TakenUpTest, ExerciseThatCameToItsNextCheckpointIsNoLongerCounted) {
    lose_at(600);
    taken_up();
    const auto second = taken_up();
    ASSERT_TRUE(second && second->def);
    lose_at(3330, second->how);
    EXPECT_EQ(time(taken_up()), 3330 / 300.0) << "the third start";
}

TEST_F(TakenUpTest, NewestFileThatWasTornBeforeItWasWholeGivesWayToTheOneBefore) {
    lose_at(3000);
    const auto newest = kept_files(path_).back();
    windlass::test::put(newest, windlass::test::content(newest).substr(0, 500));
    EXPECT_EQ(time(taken_up()), 10) << "the same tick, by its orders";
}

TEST_F(TakenUpTest, DamagedFileIsNamedAndLiesAsideAndTheExerciseBeginsAnew) {
    lose_at(1000);
    const auto file = kept_files(path_).back();
    std::string wrong = windlass::test::content(file);
    wrong[2000] = static_cast<char>(wrong[2000] ^ 1);
    windlass::test::put(file, wrong);
    const auto taken = taken_up();
    ASSERT_TRUE(taken && !taken->def);
    EXPECT_THAT(taken->how.refused, AllOf(HasSubstr(file.string() + ": damaged: the record at byte"),
                                          HasSubstr("the file lies in " + (folder_ / "aside").string())));
    EXPECT_EQ(windlass::test::content(folder_ / "aside" / "anna-1" / file.filename()), wrong);
    EXPECT_FALSE(std::filesystem::exists(path_));
    LetGo anew(taken->how);
    EXPECT_EQ(anew.session().status().state, RunState::running);
    EXPECT_THAT(text_of(anew.session(), "exercise.not_taken_up"), HasSubstr("damaged"));
}

TEST_F(TakenUpTest, AsideAreTheStatesThatWerePutThereLast) {
    namespace fs = std::filesystem;
    const auto old = fs::file_time_type::clock::now() - std::chrono::hours(1);
    for (std::size_t k = 1; k <= kMaxAside; ++k) {
        const fs::path place = folder_ / "aside" / ("anna-" + std::to_string(k));
        fs::create_directories(place);
        windlass::test::put(place / "state", "of before");
        fs::last_write_time(place, old + std::chrono::minutes(k == 7 ? 0 : k)); // the seventh is the oldest
    }
    lose_at(400);
    ASSERT_TRUE(taken_up({.definition_hash = 1, .check = {}}));
    const auto places = std::distance(fs::directory_iterator(folder_ / "aside"), fs::directory_iterator());
    EXPECT_EQ(static_cast<std::size_t>(places), kMaxAside);
    EXPECT_FALSE(fs::exists(folder_ / "aside" / "anna-7" / "state")) << "in its place lies the new one";
    EXPECT_TRUE(fs::exists(folder_ / "aside" / "anna-1" / "state"));
}

TEST_F(TakenUpTest, TimeScaleThatNoExerciseMayHaveIsRefused) {
    for (const double scale : {std::nan(""), -1.0, 1e9}) {
        lose_at(400);
        forge([&](Record kind, files::Bytes payload) {
            if (kind != Record::status) return same(payload);
            auto status = wire::decode<ExerciseStatus>(payload);
            status.time_scale(scale);
            return wire::encode(status);
        });
        const auto taken = taken_up();
        ASSERT_TRUE(taken && !taken->def) << scale;
        EXPECT_THAT(taken->how.refused, HasSubstr("ExerciseStatus.time_scale"));
    }
}

TEST_F(TakenUpTest, TickThatNoServerCanHaveComeToHoldsUpNoStart) {
    for (const bool of_order : {false, true}) {
        lose_at(400);
        forge([&](Record kind, files::Bytes payload) {
            if (kind == Record::reached && !of_order) {
                auto reached = wire::decode<Checkpoint>(payload);
                reached.tick(std::uint64_t{1} << 60);
                return wire::encode(reached);
            }
            if (kind == Record::order && of_order) {
                auto order = wire::decode<OrderTaken>(payload);
                order.tick(2'000'000);
                return wire::encode(order);
            }
            return same(payload);
        });
        const auto taken = taken_up();
        ASSERT_TRUE(taken && !taken->def) << of_order;
        EXPECT_THAT(taken->how.refused, HasSubstr("s behind its checkpoint at tick 0; allowed are 3600 s"));
    }
}

TEST_F(TakenUpTest, FileThatCannotBePutAsideHindersNoStart) {
    lose_at(1000);
    windlass::test::put(folder_ / "aside", "no folder");
    const auto taken = taken_up({.definition_hash = 1, .check = {}});
    ASSERT_TRUE(taken && !taken->def);
    EXPECT_THAT(taken->how.refused, HasSubstr("aside"));
    lose_at(400); // and is kept all the same
    EXPECT_EQ(time(taken_up()), 400 / 300.0);
}

TEST_F(TakenUpTest, ExerciseFileThatWasChangedIsRefusedInASentence) {
    lose_at(1000);
    exercise::ExerciseDef other;
    other.environment.depth = 33;
    const auto taken = taken_up({.definition_hash = exercise::definition_hash(other), .check = {}});
    ASSERT_TRUE(taken && !taken->def);
    EXPECT_THAT(taken->how.refused, HasSubstr("it was changed, or is another one; the file lies in"));
}

TEST_F(TakenUpTest, DefinitionThatNoFileCouldGiveIsRefused) {
    lose_at(1000);
    const auto taken =
        taken_up({.definition_hash = test::let_go_hash(), .check = [](const exercise::ExerciseDef&) {
                      throw std::runtime_error("/environment/depth: 33 is not allowed");
                  }});
    ASSERT_TRUE(taken && !taken->def);
    EXPECT_THAT(taken->how.refused, HasSubstr("/environment/depth: 33 is not allowed"));
}

TEST_F(TakenUpTest, AnotherExercisesFileIsRefused) {
    lose_at(1000);
    std::filesystem::rename(path_, folder_ / "exercise-ben");
    const auto taken = take_up(folder_ / "exercise-ben", "ben", folder_ / "aside", {});
    ASSERT_TRUE(taken && !taken->def);
    EXPECT_THAT(taken->how.refused, HasSubstr("of exercise anna, where ben is looked for"));
}

TEST_F(TakenUpTest, AnotherModelThatComesToAnotherStateIsRefused) {
    lose_at(1000);
    forge([](Record kind, files::Bytes payload) { // as a model would have it that brakes differently
        auto bytes = same(payload);
        if (kind == Record::reached) bytes[4 + 16] ^= 1; // of the state's hash
        if (kind == Record::synced) bytes.clear();
        return bytes;
    });
    const auto taken = taken_up();
    ASSERT_TRUE(taken && !taken->def);
    EXPECT_THAT(taken->how.refused, HasSubstr("another state comes of its orders at tick 1000"));
}

TEST_F(TakenUpTest, OrderThatIsMissingIsNamed) {
    lose_at(1000);
    int orders = 0;
    forge([&](Record kind, files::Bytes payload) {
        const bool left_out = kind == Record::synced || (kind == Record::order && ++orders == 20);
        return left_out ? std::vector<std::uint8_t>() : same(payload);
    });
    const auto taken = taken_up();
    ASSERT_TRUE(taken && !taken->def);
    EXPECT_THAT(taken->how.refused, HasSubstr("order 20 is missing at tick"));
}

} // namespace
} // namespace windlass::keep
