#include "sim/drawn_exercise.hpp"

#include "sim/world.hpp"

namespace windlass::sim {

namespace {

/// Both seats at one tick, then one after the other; the bridge by what hands do, at any time or never.
constexpr const char* kQuestions =
    R"({"id": "T", "criteria": [)"
    R"({"id": "out", "kind": "question", "ask": "How much is out?", "of": "cable_out", "tolerance": 2,)"
    R"( "when": {"time": 6, "cable_speed": {"below": 99}}},)"
    R"({"id": "gear", "kind": "question", "seat": "bridge", "ask": "Is she in gear?",)"
    R"( "when": {"time": 6, "cable_speed": {"below": 99}},)"
    R"( "choices": [{"answer": "in", "that": {"clutch": "in"}}, {"answer": "out", "that": {"clutch": "out"}}]},)"
    R"({"id": "later", "kind": "question", "ask": "How much is out now?", "of": "cable_out",)"
    R"( "tolerance": 2, "when": {"time": 15, "cable_speed": {"below": 99}}},)"
    R"({"id": "geared", "kind": "question", "seat": "bridge", "ask": "Is she in gear now?",)"
    R"( "when": {"time": 20, "clutch": "in"},)"
    R"( "choices": [{"answer": "in", "that": {"clutch": "in"}}, {"answer": "out", "that": {"clutch": "out"}}]},)"
    R"({"id": "last", "kind": "question", "ask": "How much is out at last?", "of": "cable_out",)"
    R"( "tolerance": 2, "when": {"time": 40, "cable_speed": {"below": 99}}}]})";

Chance chance_of(std::uint64_t seed) {
    return Chance(seed * 0x9E3779B97F4A7C15ULL + 2);
}

} // namespace

exercise::ExerciseDef drawn_exercise(std::uint64_t seed) {
    exercise::ExerciseDef def;
    if (chance_of(seed).in(0.2)) return def;
    def.name = "held-port";
    def.title = "Hold the port anchor, 40 m out";
    def.tick_rate_hz = 100;
    def.environment.depth = 70; // the anchor hangs clear of hull and bottom
    exercise::GroundTackleDef& port = def.tackle.front();
    port.cable_out = 40;
    // Wherever hands put the hand-wheel the band grips: no cable runs out, and none falls in a heap.
    port.windlass.brake_rating = 8e6;
    port.windlass.brake_free_play = 0.1;
    port.windlass.brake_stiffening = 1;
    return def;
}

bool draws_questions(std::uint64_t seed) {
    Chance chance = chance_of(seed);
    chance.unit(); // of the exercise
    return chance.in(1.0 / 3);
}

exercise::ExerciseDef with_questions(exercise::ExerciseDef def) {
    def.lesson = kQuestions;
    return def;
}

} // namespace windlass::sim
