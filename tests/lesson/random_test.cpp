// Whatever hands do: the fold of every shipped lesson over courses drawn at random.

#include "instructor_console/lesson_files.hpp"
#include "server/assess/assessor.hpp"
#include "server/assess/names.hpp"
#include "server/config/config.hpp"
#include "words/words.hpp"

#include <gtest/gtest.h>

#include <random>

namespace windlass::assess {

namespace {

constexpr int kRuns = 2'000; // of all lessons together
constexpr int kTicks = 60;   // of a run
constexpr double kTick = 10; // s: a lesson's orders come within some minutes

using Random = std::mt19937_64;

double between(Random& random, double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
}
bool seldom(Random& random, double share) {
    return between(random, 0, 1) < share;
}

/// A picture beside the one before: levers, cable, loads and what is seen, anything that the fields can hold.
void draw(Random& random, exercise::Snapshot& seen) {
    for (exercise::TackleView& tackle : seen.tackle) {
        exercise::WindlassView& windlass = tackle.windlass;
        if (seldom(random, 0.3)) windlass.brake_position = between(random, 0, 1);
        if (seldom(random, 0.3)) windlass.speed_lever = between(random, -1, 1);
        if (seldom(random, 0.2)) windlass.stopper_closed = seldom(random, 0.5);
        if (seldom(random, 0.2)) windlass.clutch = static_cast<exercise::ClutchState>(random() % 3);
        windlass.cable_speed = seldom(random, 0.3) ? 0 : between(random, -0.4, 8);
        tackle.chain.cable_out = std::clamp(tackle.chain.cable_out + between(random, -40, 40), -3.0, 330.0);
        windlass.hawse_tension = windlass.gypsy_load = windlass.motor_load = between(random, 0, 2e6);
        windlass.lining_temperature = between(random, 280, 800);
        windlass.motor_burst = windlass.motor_burst || seldom(random, 0.01);
        tackle.chain.top_angle = between(random, 0, 1.5);
        tackle.anchor.phase = static_cast<exercise::AnchorPhase>(random() % words::kAnchorPhaseNames.size());
        tackle.anchor.embedment = between(random, 0, 1);
        tackle.anchor.dragged += between(random, 0, 5);
    }
    seen.ship.velocity.x() = between(random, -1, 1);
    seen.environment.now.wind_speed = between(random, 0, 30);
    if (seldom(random, 0.5))
        seen.events.push_back({.code = std::string(words::kEventNames[random() % words::kEventNames.size()]),
                               .side = static_cast<int>(random() % 2),
                               .text = {}});
}

/// What the bridge ordered becomes an order that is repeated well, badly or not.
void take_orders(Random& random, std::vector<exercise::Order>& due, exercise::Snapshot& seen) {
    for (const exercise::Order& order : due)
        if (const auto* given = std::get_if<exercise::BridgeOrderGiven>(&order))
            seen.bridge_orders.push_back({.number = static_cast<int>(seen.bridge_orders.size()) + 1,
                                          .tick = seen.tick,
                                          .time = seen.time,
                                          .repeat_by = seen.time + 20,
                                          .do_by = seen.time + 60,
                                          .given = *given});
    due.clear();
    for (exercise::BridgeOrderView& order : seen.bridge_orders)
        if (seldom(random, 0.3)) order.state = static_cast<exercise::BridgeOrderState>(random() % 4);
}

exercise::Order any_report(Random& random) {
    return exercise::ReportMade{.code =
                                    static_cast<exercise::ReportCode>(random() % words::kReportNames.size()),
                                .side = static_cast<int>(random() % 3) - 1,
                                .value = between(random, 0, 12),
                                .lead = static_cast<int>(random() % 13),
                                .stay = static_cast<exercise::StayGiven>(random() % 5),
                                .growing = static_cast<exercise::Growing>(random() % 4),
                                .weight = static_cast<exercise::CableWeight>(random() % 5)};
}

void expect_sound(const Result& result) {
    std::int64_t sum = 0, weights = 0;
    for (const CriterionResult& one : result.criteria) {
        ASSERT_GE(one.milli, 0) << one.code;
        ASSERT_LE(one.milli, 1000) << one.code;
        if (one.state == CriterionState::not_in_play) continue;
        sum += std::int64_t{one.weight} * one.milli;
        weights += one.weight;
    }
    // Tenths of a point, rounded once: never above what the criteria have earned.
    ASSERT_GE(result.tenths, 0);
    if (weights > 0) {
        ASSERT_LE(result.tenths, static_cast<double>(sum) / static_cast<double>(weights) + 0.5);
    }
    for (const ObjectiveResult& one : result.objectives) {
        ASSERT_GE(one.tenths, 0) << one.id;
        ASSERT_LE(one.tenths, 1000) << one.id;
    }
    ASSERT_EQ(result.outcome != Outcome::none, result.finished);
}

} // namespace

TEST(RandomHands, NeverGetMarksThatAreNone) {
    const auto files = console::lesson_files(std::filesystem::path(WINDLASS_CONFIG_DIR) / "exercises");
    ASSERT_FALSE(files.empty());
    std::vector<exercise::ExerciseDef> defs;
    for (const auto& file : files) {
        defs.push_back(config::load_exercise(file));
        defs.back().tick_rate_hz = 1; // of the pictures here, which are no exercise's
    }
    int finished = 0;
    for (int run = 0; run < kRuns; ++run) {
        const exercise::ExerciseDef& def = defs[static_cast<std::size_t>(run) % defs.size()];
        SCOPED_TRACE(def.name + ", seed " + std::to_string(run));
        Random random(static_cast<std::uint64_t>(run));
        Assessor assessor(def);
        exercise::Snapshot seen;
        for (const auto& tackle : def.tackle) {
            seen.tackle.emplace_back().side = tackle.side;
            seen.tackle.back().windlass.breaking_load = 4.5e6;
        }
        assessor.begin(seen);
        std::vector<exercise::Order> due;
        for (int k = 0; k < kTicks; ++k) {
            seen.tick += static_cast<std::uint64_t>(kTick);
            seen.time += kTick;
            draw(random, seen);
            ASSERT_NO_THROW(assessor.fold(seen, due));
            seen.events.clear();
            take_orders(random, due, seen);
            if (seldom(random, 0.3)) assessor.hear(any_report(random));
        }
        expect_sound(assessor.result());
        assessor.hear(exercise::AssessorsWord{.verdict = exercise::AssessorVerdict::confirmed});
        expect_sound(assessor.result());
        finished += assessor.ended();
        if (testing::Test::HasFatalFailure()) return;
    }
    EXPECT_EQ(finished, kRuns);
}

} // namespace windlass::assess
