// Snapshot -> IDL types, and when they are due.

#include "server/dds/convert.hpp"
#include "server/dds/rate_gate.hpp"
#include "server/dds/spsc_ring.hpp"
#include "server/dds/wire_fields.hpp"

#include "idl/idl_text.hpp"
#include "idl/json_text.hpp"
#include "idl/payload.hpp"
#include "rigs/leaves.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <numbers>
#include <numeric>
#include <thread>

namespace windlass::dds {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// Attitude of a ship on a heading (clockwise from north), rolled to starboard and bow up.
Eigen::Quaterniond attitude(double heading, double roll, double pitch) {
    return Eigen::AngleAxisd(std::numbers::pi / 2 - heading, Eigen::Vector3d::UnitZ()) *
           Eigen::AngleAxisd(-pitch, Eigen::Vector3d::UnitY()) *
           Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX());
}

TEST(Convert, RollIsPositiveToStarboardAndPitchBowUp) {
    exercise::Snapshot snapshot;
    snapshot.ship.attitude = attitude(60 * kDegree, 10 * kDegree, 4 * kDegree);
    const Eigen::Vector3d starboard = snapshot.ship.attitude * Eigen::Vector3d(0, -1, 0);
    const Eigen::Vector3d bow = snapshot.ship.attitude * Eigen::Vector3d(1, 0, 0);
    ASSERT_LT(starboard.z(), 0); // it is down
    ASSERT_GT(bow.z(), 0);       // and the bow is up
    ShipState ship;
    convert(snapshot, ship);
    EXPECT_NEAR(ship.roll(), 10 * kDegree, 1e-12);
    EXPECT_NEAR(ship.pitch(), 4 * kDegree, 1e-12);
}

TEST(Convert, CourseOverGroundIsClockwiseFromNorth) {
    exercise::Snapshot snapshot;
    snapshot.ship.velocity = {-3, 4, 0}; // west and north
    ShipState ship;
    convert(snapshot, ship);
    EXPECT_DOUBLE_EQ(ship.speed_over_ground(), 5);
    EXPECT_NEAR(ship.course_over_ground(), 2 * std::numbers::pi - std::atan2(3, 4), 1e-12);
}

TEST(Convert, CableIsGivenInShacklesOf27AndAHalfMetres) {
    exercise::Snapshot snapshot;
    exercise::TackleView tackle;
    tackle.side = exercise::Side::starboard;
    tackle.chain.cable_out = 165;
    tackle.chain.nodes = {{0, 0, 6}, {1, 2, -3}};
    tackle.chain.tension = {12345};
    tackle.chain.largest_tension = 4e6;
    tackle.chain.stretched = 1.25;
    tackle.chain.stretch = 0.02;
    ChainState chain;
    convert(snapshot, tackle, chain);
    EXPECT_EQ(chain.side(), SIDE_STARBOARD);
    EXPECT_DOUBLE_EQ(chain.cable_out_shackles(), 6);
    ASSERT_EQ(chain.nodes().size(), 2U);
    EXPECT_EQ(chain.nodes()[1].z(), -3);
    EXPECT_EQ(chain.tension(), std::vector<float>{12345});
    EXPECT_EQ(chain.largest_tension(), 4e6);
    EXPECT_EQ(chain.stretched(), 1.25);
    EXPECT_EQ(chain.stretch(), 0.02);
}

TEST(Convert, ShorterCableLeavesNoNodesOfTheLongerOneBehind) {
    exercise::Snapshot snapshot;
    exercise::TackleView tackle;
    ChainState chain;
    tackle.chain.nodes.resize(300);
    tackle.chain.tension.resize(299);
    convert(snapshot, tackle, chain);
    tackle.chain.nodes.resize(10);
    tackle.chain.tension.resize(9);
    convert(snapshot, tackle, chain);
    EXPECT_EQ(chain.nodes().size(), 10U);
    EXPECT_EQ(chain.tension().size(), 9U);
}

TEST(Convert, UtilisationIsTensionOverBreakingLoad) {
    exercise::Snapshot snapshot;
    exercise::TackleView tackle;
    tackle.windlass.hawse_tension = 1e6;
    tackle.windlass.breaking_load = 4e6;
    WindlassLoad load;
    convert(snapshot, tackle, load);
    EXPECT_DOUBLE_EQ(load.utilisation(), 0.25);
    tackle.windlass.breaking_load = 0; // unknown: no infinity goes out
    convert(snapshot, tackle, load);
    EXPECT_EQ(load.utilisation(), 0);
}

TEST(Convert, EventTextTooLongForTheWireIsCutNotLost) {
    exercise::ExerciseEvent event;
    event.number = 7;
    event.severity = exercise::Severity::alarm;
    event.code = "command.refused";
    event.text = std::string(300, 'x');
    Event out;
    convert(event, out);
    EXPECT_EQ(out.number(), 7U);
    EXPECT_EQ(out.severity(), EVENT_ALARM);
    EXPECT_EQ(out.text().to_string(), std::string(256, 'x'));
}

TEST(Convert, TruthCarriesAtMostAsManyFaultsAsTheTypeHolds) {
    exercise::Snapshot snapshot;
    snapshot.faults.resize(100);
    snapshot.faults[1] = {.order = {.code = exercise::FaultCode::motor_power_lost,
                                    .severity = 0.5,
                                    .ramp = 30,
                                    .trigger = exercise::FaultTrigger::at_event,
                                    .trigger_event = "anchor.let_go"},
                          .phase = exercise::FaultPhase::active,
                          .severity_now = 0.25};
    ExerciseTruth truth;
    convert(snapshot, run::RunStatus{}, truth);
    ASSERT_EQ(truth.faults().size(), 96U);
    const FaultStatus& fault = truth.faults()[1];
    EXPECT_EQ(fault.code(), FAULT_MOTOR_POWER_LOST);
    EXPECT_EQ(fault.phase(), FAULT_PHASE_ACTIVE);
    EXPECT_EQ(fault.severity(), 0.5);
    EXPECT_EQ(fault.severity_now(), 0.25);
    EXPECT_EQ(fault.ramp(), 30);
    EXPECT_EQ(fault.trigger(), TRIGGER_AT_EVENT);
    EXPECT_EQ(fault.trigger_event().to_string(), "anchor.let_go");
}

TEST(Convert, StatusTellsTheTraineesTitleAndTruthTheInstructors) {
    run::RunStatus run;
    run.state = exercise::RunState::running;
    run.exercise = "a2";
    run.title_instructor = "Motor fails with four shackles in";
    run.title_trainee = "Weigh anchor, gale";
    ExerciseStatus status;
    convert(exercise::Snapshot{}, run, status);
    EXPECT_EQ(status.state(), RUN_RUNNING);
    EXPECT_EQ(status.exercise().to_string(), "a2");
    EXPECT_EQ(status.title().to_string(), "Weigh anchor, gale");
    ExerciseTruth truth;
    convert(exercise::Snapshot{}, run, truth);
    EXPECT_EQ(truth.title().to_string(), "Motor fails with four shackles in");
}

TEST(Convert, CableForceTellsWhatEachCableDoesAtItsHawse) {
    exercise::Snapshot snapshot;
    snapshot.cable_force = {1, 2, 3};
    snapshot.cable_moment = {4, 5, 6};
    snapshot.tackle.resize(1);
    snapshot.tackle[0].side = exercise::Side::starboard;
    snapshot.tackle[0].hawse = {100, 2, 9};
    snapshot.tackle[0].force = {-7, 0, -8};
    CableForce force;
    convert(snapshot, force);
    EXPECT_EQ(force.moment().x(), 4);
    EXPECT_EQ(force.moment().z(), 6);
    ASSERT_EQ(force.hawse().size(), 1U);
    EXPECT_EQ(force.hawse()[0].side(), SIDE_STARBOARD);
    EXPECT_EQ(force.hawse()[0].position().z(), 9);
    EXPECT_EQ(force.hawse()[0].force().x(), -7);
}

/// Nothing in a listed struct is 0, false, empty or the first enumerator.
template <class T>
void fill(T& object) {
    int next = 1;
    rigs::each_leaf("", object, [&](const std::string&, auto& value) {
        using Leaf = std::remove_reference_t<decltype(value)>;
        if constexpr (std::is_same_v<Leaf, std::string>)
            value = "text";
        else if constexpr (std::is_enum_v<Leaf>)
            value = static_cast<Leaf>(1);
        else
            value = static_cast<Leaf>(next++ % 100 + 1);
    });
}

/// No field of the sample is 0, false, empty or the first enumerator: somebody has set each.
template <class T>
void expect_set(const T& sample) {
    const idl::Type& type = idl::own_type<T>();
    std::string text;
    idl::append_json(type, wire::encode(sample), text);
    const auto object = nlohmann::json::parse(text);
    const auto nothing = [](const nlohmann::json& value) {
        return value == 0 || value == false || value == "" || value.empty();
    };
    const nlohmann::json flat = object.flatten();
    for (const auto& [path, value] : flat.items())
        EXPECT_FALSE(nothing(value)) << type.name << path << " = " << value;
    // Enumerators by name: the first of each type is what nobody has set.
    for (const idl::Member& member : type.members) {
        if (member.type->kind != idl::Kind::enumeration) continue;
        EXPECT_NE(object[member.name], member.type->enumerators[0]) << type.name << '.' << member.name;
    }
}

TEST(Convert, SetsEveryFieldThatTheWireHas) {
    exercise::Snapshot snapshot;
    snapshot.tackle.resize(1);
    exercise::TackleView& tackle = snapshot.tackle[0];
    tackle.chain.nodes.resize(2), tackle.chain.tension.resize(1), tackle.chain.marks.resize(1);
    snapshot.environment.now.current_profile.resize(1), snapshot.environment.after.current_profile.resize(1);
    snapshot.faults.resize(1);
    fill(snapshot);
    snapshot.ship.attitude = attitude(1, 0.2, 0.1);
    run::RunStatus run;
    fill(run);
    const auto converted = [](auto sample, const auto&... from) {
        convert(from..., sample);
        expect_set(sample);
    };
    converted(ExerciseStatus(), snapshot, run);
    converted(ExerciseTruth(), snapshot, run);
    converted(EnvironmentState(), snapshot);
    converted(ShipState(), snapshot);
    converted(CableForce(), snapshot);
    converted(AnchorState(), snapshot, tackle);
    converted(ChainState(), snapshot, tackle);
    converted(WindlassLoad(), snapshot, tackle);
    exercise::ExerciseEvent event;
    fill(event);
    converted(Event(), event);
    run::AlertView alert;
    fill(alert);
    converted(Alert(), alert);
    run::CheckpointView checkpoint;
    checkpoint.data.resize(3);
    fill(checkpoint);
    converted(Checkpoint(), checkpoint);
    exercise::BridgeOrderView order;
    fill(order);
    converted(BridgeOrder(), order, std::uint64_t{7});
}

/// The bound that the IDL gives the sequence of a type.
std::uint64_t bound_in(const idl::Type& type, const char* sequence) {
    for (const idl::Member& member : type.members)
        if (member.name == sequence) return member.bound;
    return 0;
}

TEST(Convert, CutsSequencesAtTheBoundsOfTheIdl) {
    EXPECT_EQ(bound_in(idl::own_type<ExerciseTruth>(), "faults"), kMostOnWire<FaultStatus>);
    EXPECT_EQ(bound_in(idl::own_type<ChainState>(), "marks"), kMostOnWire<CableMark>);
    EXPECT_EQ(bound_in(*idl::own_type<EnvironmentState>().members[2].type, "current_profile"),
              kMostOnWire<CurrentLayer>);
    const idl::Type& assessment = idl::own_type<Assessment>();
    EXPECT_EQ(bound_in(assessment, "criteria"), kMostOnWire<Criterion>);
    EXPECT_EQ(bound_in(assessment, "objectives"), kMostOnWire<ObjectiveMark>);
    EXPECT_EQ(bound_in(assessment, "orders"), kMostOnWire<OrderDone>);
    EXPECT_EQ(bound_in(assessment, "reports"), kMostOnWire<JudgedReport>);
}

int sent_in(RateGate& gate, int ticks, int tick_rate, double scale) {
    int sent = 0;
    for (int tick = 1; tick <= ticks; ++tick)
        sent += gate.due(static_cast<std::uint64_t>(tick), tick_rate, tick / (tick_rate * scale)) ? 1 : 0;
    return sent;
}

TEST(RateGate, SendsSixtyTimesASecondAtRealTime) {
    RateGate gate(60, 5);
    EXPECT_NEAR(sent_in(gate, 3000, 300, 1), 600, 2);
}

TEST(RateGate, SendsARateThatDoesNotDivideTheTickRate) {
    RateGate gate(100, 5);
    EXPECT_NEAR(sent_in(gate, 2500, 250, 1), 1000, 2);
}

TEST(RateGate, HurriedExerciseSendsNoMorePerWallSecond) {
    RateGate gate(60, 5);
    EXPECT_NEAR(sent_in(gate, 24000, 300, 8), 600, 6); // 80 s in 10
}

TEST(RateGate, SlowExerciseSendsEachExerciseTimeOnce) {
    RateGate gate(60, 5);
    EXPECT_NEAR(sent_in(gate, 300, 300, 0.25), 60, 1);
}

TEST(RateGate, StandingExerciseIsRepeatedSlowly) {
    RateGate gate(60, 5);
    int sent = 0;
    for (int i = 0; i < 1000; ++i)
        sent += gate.due(42, 300, i * 0.01) ? 1 : 0;
    EXPECT_NEAR(sent, 50, 2);
}

TEST(RateGate, WithoutTimePassingNoMoreThanAFewGoOut) {
    RateGate gate(60, 5);
    int sent = 0;
    for (std::uint64_t tick = 1; tick <= 10000; ++tick)
        sent += gate.due(tick, 300, 1.0) ? 1 : 0;
    EXPECT_LE(sent, 5);
}

TEST(SpscRing, HandsEverythingOverInOrderAcrossThreads) {
    SpscRing<int> ring(4);
    constexpr int kCount = 20000;
    std::vector<int> got;
    std::thread emptier([&] {
        while (got.size() < kCount) {
            if (const int* value = ring.oldest()) {
                got.push_back(*value);
                ring.pop();
            } else {
                std::this_thread::yield();
            }
        }
    });
    for (int i = 0; i < kCount;) {
        if (int* slot = ring.free_slot()) {
            *slot = i++;
            ring.push();
        } else {
            std::this_thread::yield();
        }
    }
    emptier.join();
    std::vector<int> expected(kCount);
    std::iota(expected.begin(), expected.end(), 0);
    EXPECT_EQ(got, expected);
    EXPECT_TRUE(ring.empty());
}

TEST(SpscRing, MakesASlotWhenItIsFirstNeededAndOnce) {
    static int made = 0;
    struct Slot {
        Slot() { ++made; }
    };
    SpscRing<Slot> ring(3);
    EXPECT_EQ(made, 0);
    for (int lap = 1; lap <= 7; ++lap) {
        ASSERT_NE(ring.free_slot(), nullptr);
        ring.push();
        EXPECT_EQ(made, std::min(lap, 3));
        ring.pop();
    }
    SpscRing<Slot> set_up(3);
    set_up.for_each([](Slot&) {});
    EXPECT_EQ(made, 6);
}

TEST(SpscRing, FullRingGivesNoSlot) {
    SpscRing<int> ring(2);
    for (int i = 0; i < 2; ++i) {
        ASSERT_NE(ring.free_slot(), nullptr);
        ring.push();
    }
    EXPECT_EQ(ring.free_slot(), nullptr);
    ring.pop();
    EXPECT_NE(ring.free_slot(), nullptr);
}

} // namespace
} // namespace windlass::dds
