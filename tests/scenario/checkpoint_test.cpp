// An exercise kept as bytes and taken up again: the same bits from there on, in every phase of an anchoring.

#include "server/config/config.hpp"
#include "server/config/config_json.hpp"
#include "server/exercise/checkpoint.hpp"
#include "words/words.hpp"

#include "rigs/drill.hpp"
#include "rigs/leaves.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <numbers>
#include <sstream>

namespace windlass::exercise {
using namespace rigs;

namespace {

std::uint64_t hash_of(const Exercise& exercise) {
    Snapshot snapshot;
    exercise.view(snapshot);
    return snapshot.state_hash;
}

/// Steps both for so many seconds; the first tick after which they differ, with the field, or nothing.
std::string parting(Exercise& first, Exercise& second, double seconds) {
    const double dt = 1.0 / first.def().tick_rate_hz;
    const auto ticks = static_cast<int>(seconds / dt);
    for (int i = 0; i < ticks; ++i) {
        first.step(dt), second.step(dt);
        if (hash_of(first) == hash_of(second)) continue;
        const auto found = differences(first, second, 1);
        return "tick " + std::to_string(first.tick()) + ": " +
               (found.empty() ? "no field" : found[0].field + " " + found[0].first + " " + found[0].second);
    }
    return "";
}

/// The first field that two exercises show differently, or nothing. Events are of the last tick and no part
/// of what is kept.
std::string shown_differently(const Exercise& first, const Exercise& second) {
    const auto lines = [](const Exercise& exercise) {
        Snapshot snapshot;
        exercise.view(snapshot);
        snapshot.events.clear();
        std::vector<std::string> shown; // every field with all its bits, one a line
        each_leaf("", snapshot, [&](const std::string& path, const auto& value) {
            std::ostringstream line;
            line << std::hexfloat << path << " = ";
            if constexpr (std::is_enum_v<std::decay_t<decltype(value)>>)
                line << static_cast<int>(value);
            else
                line << value;
            shown.push_back(line.str());
        });
        return shown;
    };
    const auto one = lines(first), other = lines(second);
    for (std::size_t k = 0; k < std::min(one.size(), other.size()); ++k)
        if (one[k] != other[k]) return one[k] + " / " + other[k];
    return one.size() == other.size() ? "" : "lists of different length";
}

/// A checkpoint of this instant shows at once what the exercise shows, goes on as the exercise itself does,
/// and taking it changes nothing.
void expect_branch(Drill& drill, double seconds, const char* when) {
    Exercise& live = drill.exercise();
    const auto before = hash_of(live);
    const auto bytes = write_checkpoint(live);
    EXPECT_EQ(hash_of(live), before);
    Exercise first = read_checkpoint(bytes);
    EXPECT_EQ(write_checkpoint(first), bytes) << when;
    EXPECT_EQ(shown_differently(live, first), "") << when << ", before any step";
    Exercise second = read_checkpoint(bytes);
    EXPECT_EQ(parting(first, second, seconds), "") << when << ", two branches";
    Exercise branch = read_checkpoint(bytes);
    EXPECT_EQ(parting(live, branch, seconds), "") << when;
    EXPECT_EQ(shown_differently(live, branch), "") << when;
    EXPECT_EQ(live.tick(), branch.tick());
}

TEST(Checkpoint, GoesOnBitForBitFromHangingRunningLyingAndHeldAnchor) {
    Drill drill(let_go_def());
    drill.run(0.5);
    expect_branch(drill, 0.5, "hanging");
    drill.brake(0);
    drill.run(2);
    expect_branch(drill, 2, "running out");
    ASSERT_TRUE(drill.run_until_event("anchor.on_bottom", 30));
    expect_branch(drill, 3, "on the bottom");
    drill.brake(1);
    drill.run(20);
    expect_branch(drill, 20, "held by the brake");
}

TEST(Checkpoint, TakesAnAnchorThatIsHomeOrLeavesItsPipe) {
    Drill drill(anchor_home_def(25, 1.2));
    drill.run(1);
    expect_branch(drill, 1, "home");
    drill.brake(0);
    ASSERT_TRUE(drill.run_until([&] { return drill.chain().cable_out > -1.5; }, 10));
    ASSERT_LT(drill.chain().cable_out, 0);
    expect_branch(drill, 2, "half out");
}

TEST(Checkpoint, KeepsFaultsWeatherAndLevers) {
    Drill drill(let_go_def());
    drill.fault(FaultCode::brake_lining_faded, 0.5, FaultTrigger::at_cable_out, 20);
    drill.fault(FaultCode::load_cell_dead, 1);
    drill.fault(FaultCode::brake_lining_worn, 0.4); // what is shown of the wear is worked out, not kept
    drill.brake(0);
    drill.run(1);
    expect_branch(drill, 6, "with faults"); // the armed one comes up on the way
}

// What a fault makes of a state is within what a state may be (state_limits.hpp), at home and let go.
TEST(Checkpoint, UnderEveryFaultIsReadBack) {
    Drill home(anchor_home_def(25, 1.2)), hangs(let_go_def()), lies(steady_breeze_def());
    home.run(1), hangs.run(1);
    ASSERT_TRUE(lie_quietly(lies));
    for (const Drill* moment : {&home, &hangs, &lies}) {
        const auto bytes = write_checkpoint(moment->exercise());
        for (int fault = 0; fault < kFaultCodes; ++fault)
            for (const double brake : {0.0, 1.0}) {
                const auto code = static_cast<FaultCode>(fault);
                SCOPED_TRACE(words::row_of(code).name);
                Exercise exercise = read_checkpoint(bytes);
                exercise.apply(FaultOrder{.code = code, .severity = 1});
                exercise.apply(WindlassOrder{.side = Side::port, .brake = brake});
                for (int tick = 0; tick < 600; ++tick) {
                    ASSERT_TRUE(exercise.step(1.0 / exercise.def().tick_rate_hz));
                    if (tick % 200 == 1 || tick == 599) {
                        ASSERT_NO_THROW(read_checkpoint(write_checkpoint(exercise))) << tick;
                    }
                }
            }
    }
}

TEST(Checkpoint, TakesACableThatSleepsOrIsLeftToTheCatenary) {
    Drill drill(steady_breeze_def());
    ASSERT_TRUE(lie_quietly(drill));
    expect_branch(drill, 10, "catenary");
}

/// The catenary has laid out nodes that the windlass hove in since; a state that is brought back without them
/// is the same when the cable is as long again.
TEST(Checkpoint, KnowsNothingOfNodesThatWereHoveIn) {
    Drill drill(steady_breeze_def());
    ASSERT_TRUE(lie_quietly(drill));
    const double lay = drill.chain().cable_out;
    drill.clutch(true);
    drill.run(10);
    drill.brake(0);
    drill.run(5);
    drill.speed_lever(0.5);
    ASSERT_TRUE(drill.run_until([&] { return drill.chain().cable_out < lay - 3; }, 120));
    drill.speed_lever(-0.4);
    expect_branch(drill, 60, "hove in, and walked back");
    Snapshot after;
    drill.exercise().view(after);
    EXPECT_GT(after.tackle.front().chain.cable_out, lay) << "all of it is out again";
}

TEST(Checkpoint, OfAQuietCableKnowsWhereThePipeIs) {
    // She drifts to starboard of where she started, head to the wind at last: seen from where the port pipe
    // was at the start the anchor would be up it, flukes towards the ship's side.
    ExerciseDef def = steady_breeze_def();
    def.ship_start.heading = 0.3 * std::numbers::pi;
    def.ship_start.surge = 0;
    Drill drill(def);
    drill.run(400);
    ASSERT_TRUE(lie_quietly(drill));
    Exercise branch = read_checkpoint(write_checkpoint(drill.exercise()));
    EXPECT_EQ(parting(drill.exercise(), branch, 5), "");
}

TEST(Checkpoint, DamagedBytesAreRefusedWithAReason) {
    Exercise exercise(let_go_def());
    auto bytes = write_checkpoint(exercise);
    const auto reason = [](const std::vector<std::uint8_t>& damaged) -> std::string {
        try {
            read_checkpoint(damaged);
        } catch (const CheckpointError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(reason(bytes), "");
    auto cut = bytes;
    cut.resize(bytes.size() / 2);
    EXPECT_EQ(reason(cut), "a checkpoint ends in the middle");
    auto longer = bytes;
    longer.push_back(0);
    EXPECT_EQ(reason(longer), "a checkpoint goes on behind its end");
    auto later = bytes;
    later[4] = 99;
    EXPECT_EQ(reason(later),
              "a checkpoint of format 99; this program reads " + std::to_string(kCheckpointFormat));
    EXPECT_EQ(reason({'a', 'b', 'c', 'd', 1, 0, 0, 0}), "these bytes are no checkpoint");
    for (std::size_t at = bytes.size() / 2; at < bytes.size(); at += 997) { // in the state
        auto flipped = bytes;
        flipped[at] ^= 1;
        EXPECT_NE(reason(flipped), "") << at;
    }
}

TEST(Checkpoint, TakesTwoCablesThatLieAcrossEachOther) {
    // Hawse pipes at the stem, closer together than the anchors are wide, and both let go.
    ExerciseDef def = let_go_def();
    def.ship.hawse_forward = 110.5, def.ship.hawse_outboard = 0.7;
    def.tackle.push_back(def.tackle[0]);
    def.tackle[1].side = Side::starboard;
    Drill drill(def);
    Exercise& live = drill.exercise();
    for (const Side side : {Side::port, Side::starboard})
        live.apply(WindlassOrder{.side = side, .brake = 0});
    for (const double seconds : {1.5, 2.5, 4.0}) {
        drill.run(seconds);
        expect_branch(drill, 2, "two cables");
    }
}

TEST(Checkpoint, KeepsEveryValueOfTheDefinition) {
    ExerciseDef def = let_go_def();
    const auto plain = definition_hash(def);
    def.weather.current_profile = {{.depth = 0, .share = 1, .turn = 0.5}, {.depth = 20, .share = 0.2}};
    const auto with_profile = definition_hash(def);
    EXPECT_NE(with_profile, plain);
    def.tackle[0].condition = {{.begins = 0, .ends = 82.5, .wear = 0.08}, {.begins = 27.5, .ends = 27.5}};
    EXPECT_NE(definition_hash(def), with_profile);
    for (const auto& change : {+[](ExerciseDef& d) { d.title_trainee = "anchor work"; },
                               +[](ExerciseDef& d) { d.seats.load_cell = false; },
                               +[](ExerciseDef& d) { d.seats.underwater = true; },
                               +[](ExerciseDef& d) { d.weather.visibility = 300; },
                               +[](ExerciseDef& d) { d.weather.wind_speed += 1; }}) {
        const auto before = definition_hash(def);
        change(def);
        EXPECT_NE(definition_hash(def), before);
    }
    Exercise exercise(def);
    Exercise read = read_checkpoint(write_checkpoint(exercise));
    EXPECT_EQ(definition_hash(read.def()), definition_hash(def));
    EXPECT_EQ(config::to_json(read.def()), config::to_json(def)); // every value that a file can give
    exercise.apply(WindlassOrder{.brake = 0});
    read.apply(WindlassOrder{.brake = 0});
    EXPECT_EQ(parting(exercise, read, 2), "");
}

TEST(Checkpoint, AnotherDefinitionUnderItsStateIsRefused) {
    Exercise exercise(let_go_def());
    auto bytes = write_checkpoint(exercise);
    ExerciseDef other = let_go_def();
    other.tackle[0].windlass.gypsy_inertia += 1;
    Exercise different(other);
    const auto others = write_checkpoint(different);
    ASSERT_EQ(bytes.size(), others.size());
    // The fields of the definition from the other checkpoint, the hash and the state of this one.
    std::size_t first = 0;
    while (bytes[first] == others[first])
        ++first;
    std::copy_n(others.begin() + static_cast<std::ptrdiff_t>(first), 8,
                bytes.begin() + static_cast<std::ptrdiff_t>(first));
    try {
        read_checkpoint(bytes);
        FAIL() << "was read";
    } catch (const CheckpointError& error) {
        EXPECT_STREQ(error.what(), "a checkpoint is damaged: the hash of its definition differs");
    }
}

TEST(Checkpoint, WithAnotherTextOfItsLessonIsTheSameStateAndGoesOnBitForBit) {
    Drill drill(let_go_def());
    drill.run(5);
    const auto bytes = write_checkpoint(drill.exercise());
    const auto same = with_lesson(bytes, [](const std::string& text) { return text; });
    EXPECT_EQ(same, bytes);
    const auto changed = with_lesson(bytes, [](const std::string&) { return "{}"; });
    Exercise first = read_checkpoint(bytes), second = read_checkpoint(changed);
    EXPECT_EQ(second.def().lesson, "{}");
    EXPECT_EQ(hash_of(second), hash_of(first));
    EXPECT_EQ(parting(first, second, 5), "");
    const std::vector<std::uint8_t> torn(bytes.begin(), bytes.begin() + 40);
    for (const auto& none : {torn, std::vector<std::uint8_t>(64, 7), std::vector<std::uint8_t>()})
        EXPECT_THROW(with_lesson(none, [](const std::string& text) { return text; }), CheckpointError);
}

TEST(Checkpoint, DefinitionIsCheckedBeforeAnythingIsMadeOfIt) {
    ExerciseDef endless = let_go_def();
    endless.tackle[0].chain.length = 900;
    Exercise exercise(endless);
    const auto bytes = write_checkpoint(exercise);
    EXPECT_NO_THROW(read_checkpoint(bytes, config::check_definition));
    endless.environment.depth = -3;
    endless.tick_rate_hz = 0;
    EXPECT_THROW(config::check_definition(endless), ConfigError);
    try {
        read_checkpoint(bytes, [&](const ExerciseDef&) { config::check_definition(endless); });
        FAIL() << "was read";
    } catch (const CheckpointError& error) {
        EXPECT_NE(std::string(error.what()).find("/environment/depth: -3"), std::string::npos)
            << error.what();
    }
}

TEST(Checkpoint, NamesTheFieldsThatDiffer) {
    Exercise one(let_go_def()), other(let_go_def());
    EXPECT_TRUE(differences(one, other).empty());
    other.apply(HelmOrder{.rudder = 0.25});
    const auto found = differences(one, other);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].field, "helm.rudder");
    EXPECT_EQ(found[0].first, "0");
    EXPECT_EQ(found[0].second, "0.25");
}

} // namespace
} // namespace windlass::exercise
