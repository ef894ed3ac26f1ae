#pragma once
// A course of pictures that a test draws, with a lesson folded over it.

#include "server/assess/assessor.hpp"
#include "server/assess/questions.hpp"

#include <cmath>

namespace windlass::assess {

inline constexpr int kRate = 10; // Hz: a tick is 0.1 s

/// A course of pictures that a test draws.
class Course {
public:
    explicit Course(const std::string& lesson, int rate = kRate)
        : rate_(rate), lesson_(read_lesson(lesson, {0, 1})), state_(fresh(lesson_)) {
        for (Gear& gear : lesson_.gear)
            gear = {.cable_weight = 1000, .duty_pull = 300e3}; // N/m, N
        seen_.tackle.emplace_back();
        seen_.tackle[0].chain.cable_out = 5;
        assess::begin(lesson_, state_, seen_);
    }
    exercise::WindlassView& windlass() { return seen_.tackle[0].windlass; }
    exercise::ChainView& chain() { return seen_.tackle[0].chain; }
    exercise::Snapshot& seen() { return seen_; }
    std::vector<exercise::Order> due;

    void run(double seconds) {
        for (int k = 0; k < std::lround(seconds * rate_); ++k) {
            ++seen_.tick;
            seen_.time = static_cast<double>(seen_.tick) / rate_;
            fold(lesson_, state_, seen_, rate_, due);
            seen_.events.clear();
        }
    }
    void event(const char* code) { seen_.events.push_back({.code = code, .side = 0, .text = {}}); }
    void report(exercise::ReportCode code, double value = 0) {
        report(exercise::ReportMade{.code = code, .side = 0, .value = value});
    }
    void report(const exercise::ReportMade& made) { hear(lesson_, state_, made, rate_); }
    void end() {
        hear(lesson_, state_, exercise::AssessorsWord{.verdict = exercise::AssessorVerdict::confirmed},
             rate_);
    }
    void draw(double seed) { hear(lesson_, state_, exercise::ChanceDrawn{seed}, rate_); }
    void say(const exercise::AssessorsWord& word) { hear(lesson_, state_, word, rate_); }
    void say(const exercise::AnswerGiven& answer) { hear(lesson_, state_, answer, rate_); }
    int open_question(bool forecastle) const { return assess::open_question(lesson_, state_, forecastle); }
    const State& state() const { return state_; }
    const Lesson& taught() const { return lesson_; }
    Result now() const { return result(lesson_, state_, rate_); }
    CriterionResult mark(std::size_t k = 0) const { return now().criteria.at(k); }

private:
    int rate_;
    Lesson lesson_;
    State state_;
    exercise::Snapshot seen_;
};

/// The text of a lesson with these criteria.
inline std::string lesson(const std::string& criterion, const std::string& rest = "") {
    return R"({"id": "T", "moments": {"bottom": {"event": "anchor.on_bottom"}}, "criteria": [)" + criterion +
           "]" + rest + "}";
}

} // namespace windlass::assess
