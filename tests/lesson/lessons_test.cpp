// Every shipped lesson with its model run, which passes, and its typical errors, which fail for the reason
// that the lesson names. The lesson files are the table.

#include "instructor_console/lesson_files.hpp"
#include "lesson/play.hpp"
#include "server/assess/quantities.hpp"
#include "server/exercise/checkpoint.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace windlass::console {

namespace {

namespace fs = std::filesystem;
using assess::CriterionState;

/// What a model run earns at the least, of 100.
constexpr int kGood = 85;

lesson::Played play(const LessonFile& file, const assess::LessonRun& run) {
    std::vector<fs::path> scripts;
    for (const std::string& script : run.scripts)
        scripts.push_back(file.root / script);
    int kept = 0;
    const lesson::Played played = lesson::play(file.def, load_scripts(scripts), [&](run::Session& session) {
        // What an exercise comes to is what a state may be.
        if (session.checkpoint() == nullptr) return;
        assess::Assessor assessor;
        ++kept;
        EXPECT_NO_THROW(exercise::read_checkpoint(session.checkpoint()->data, {}, &assessor))
            << "at " << session.now_time() << " s";
    });
    EXPECT_GT(kept, 2); // one each ten seconds, and the shortest run takes half a minute
    return played;
}

std::string missed(const lesson::Played& played) {
    std::string text;
    for (const assess::CriterionResult& one : played.result.criteria)
        if (one.state == CriterionState::not_met) text += "\n" + one.code + ": " + one.reason;
    return text + "\n" + played.stuck;
}

void passes(const LessonFile& file) {
    ASSERT_FALSE(file.lesson.model_run.scripts.empty());
    const lesson::Played right = play(file, file.lesson.model_run);
    EXPECT_EQ(right.result.outcome, assess::Outcome::achieved) << missed(right);
    EXPECT_GE(right.result.tenths, 10 * kGood) << missed(right);
    EXPECT_EQ(right.stuck, "");
}

void try_out(const fs::path& path) {
    SCOPED_TRACE(path.filename().string());
    const LessonFile file = read_lesson_file(path);
    check_scripts(file);
    ASSERT_FALSE(file.lesson.errors.empty());
    passes(file);
    for (const assess::LessonRun& other : file.lesson.also_right) {
        SCOPED_TRACE(other.about);
        const lesson::Played played = play(file, other);
        EXPECT_EQ(played.result.outcome, assess::Outcome::achieved) << missed(played);
    }
    for (const assess::LessonRun& error : file.lesson.errors) {
        SCOPED_TRACE(error.about);
        const lesson::Played wrong = play(file, error);
        EXPECT_EQ(wrong.result.outcome, assess::Outcome::not_yet);
        for (const assess::CriterionResult& one : wrong.result.criteria) {
            const bool named = std::ranges::find(error.fails, one.code) != error.fails.end();
            const bool missed = one.state == CriterionState::not_met;
            EXPECT_TRUE(named ? missed : !(missed && one.must)) << one.code << ": " << one.reason;
        }
    }
}

fs::path lesson_file(const char* name) {
    return fs::path(WINDLASS_CONFIG_DIR) / "exercises" / name;
}

} // namespace

TEST(Lessons, OfTheCheckLetGo) {
    try_out(lesson_file("L01_let_go_25m.json"));
}

TEST(Lessons, OfTheCheckBrakeFade) {
    try_out(lesson_file("L12_brake_fade.json"));
}

TEST(Lessons, OfTheCheckMotorOverhauled) {
    try_out(lesson_file("L15_motor_overhauled.json"));
}

TEST(Lessons, OfTheCheckStuckInThePipe) {
    try_out(lesson_file("L18_stuck.json"));
}

/// Lessons whose model run is a matter of seconds: some 95 s of one core, of 330 for all.
class ModelRun : public testing::TestWithParam<const char*> {};

TEST_P(ModelRun, PassesItsLesson) {
    passes(read_lesson_file(lesson_file((std::string(GetParam()) + ".json").c_str())));
}

INSTANTIATE_TEST_SUITE_P(Lessons, ModelRun,
                         testing::Values("L02_lower_and_let_go", "L04_weigh", "L05_standing_moor",
                                         "L06_dredging", "L07_second_anchor", "L08_weigh_in_a_gale",
                                         "L09_foul_anchor", "L10_turns", "L13_runaway", "L14_hydraulic_loss",
                                         "L16_emergency", "L17_blackout", "L20_no_word", "L22_dead_load_cell",
                                         "L23_approach", "L24_not_here", "L25_break_out", "L27_the_conn",
                                         "L31_mediterranean_moor", "A01_stellar_voyager", "A02_tanker_mars",
                                         "A05_royal_pescadores", "A06_clutch_mars_201410", "A08_mariella"),
                         [](const auto& lesson) { return std::string(lesson.param); });

// Much is looked at for the first time then, and comes from nowhere.
TEST(Lessons, FirstTicksOfEachAreReadBack) {
    int looked_at = 0;
    for (const fs::path& path : lesson_files(fs::path(WINDLASS_CONFIG_DIR) / "exercises")) {
        const exercise::ExerciseDef def = read_lesson_file(path).def;
        if (std::ranges::any_of(def.tackle, [](const auto& one) { return one.at_anchor > 0; }))
            continue; // whose first tick comes after the prelude's many
        SCOPED_TRACE(path.filename().string());
        exercise::Exercise exercise(def);
        for (int tick = 0; tick < 8; ++tick, ++looked_at) {
            EXPECT_NO_THROW(exercise::read_checkpoint(exercise::write_checkpoint(exercise))) << tick;
            exercise.step(1.0 / 300);
        }
    }
    EXPECT_GE(looked_at, 80);
}

TEST(Lessons, EveryShippedOneIsPassedByItsModelRunAndFailedByItsErrors) {
    const auto files = lesson_files(fs::path(WINDLASS_CONFIG_DIR) / "exercises");
    EXPECT_FALSE(files.empty());
    for (const fs::path& file : files)
        try_out(file);
}

// Orders say "in the pipe": a hand who stops the mark there, at the lip or 1.5 m inboard of it, has what
// every lesson asks for at its end, and what the order asks for.
TEST(Lessons, AHandThatStopsTheOrderedMarkInThePipeMeetsWhatCountsTheCable) {
    const int shackles = assess::quantity_of("shackles");
    int looked_at = 0;
    for (const fs::path& path : lesson_files(fs::path(WINDLASS_CONFIG_DIR) / "exercises")) {
        const LessonFile file = read_lesson_file(path);
        for (const assess::LessonOrder& order : file.lesson.orders)
            for (const assess::Criterion& criterion : file.lesson.criteria) {
                if (criterion.kind != assess::CriterionKind::final || criterion.that.side != order.given.side)
                    continue;
                for (const assess::Bounds& bounds : criterion.that.bounds) {
                    const auto within = [&](double out) { return out > bounds.above && out < bounds.below; };
                    const double value = order.given.value;
                    if (bounds.quantity != shackles || value == 0 || !within(value)) continue;
                    ++looked_at;
                    SCOPED_TRACE(path.filename().string() + ": " + criterion.id);
                    EXPECT_TRUE(within(value - 1.5 / 27.5));
                    for (const assess::Condition& windlass : order.done)
                        for (const assess::Bounds& done : windlass.bounds)
                            if (done.quantity == shackles) {
                                EXPECT_GT(value - 1.5 / 27.5, done.above);
                                EXPECT_LT(value, done.below);
                            }
                }
            }
    }
    EXPECT_GE(looked_at, 5);
}

// What chance may make of an attempt is the same each time that it is asked for by its number.
TEST(Lessons, LuckIsTheSameTwiceAndAnotherForEachNumber) {
    const LessonFile file =
        read_lesson_file(fs::path{WINDLASS_CONFIG_DIR} / "exercises" / "L15_motor_overhauled.json");
    struct Seen {
        std::uint64_t state = 0;
        double tide = 0; ///< m
        std::uint32_t waves = 0;
        bool operator==(const Seen&) const = default;
    };
    const auto seen = [&](unsigned number) {
        Seen last;
        lesson::play(
            file.def, std::vector<lesson::Part>{},
            [&](run::Session& session) {
                if (!session.seen()) return;
                const auto& now = session.snapshot().environment.now;
                last = {session.snapshot().state_hash, now.tide_height, now.wave_seed};
            },
            lesson::luck(number));
        return last;
    };
    const Seen first = seen(0), third = seen(2);
    EXPECT_EQ(first.tide, 0);
    EXPECT_NEAR(third.tide, 0.002, 1e-9);
    EXPECT_EQ(third.waves, first.waves + 2);
    EXPECT_NE(third.state, first.state);
    EXPECT_EQ(seen(2), third);
}

} // namespace windlass::console
