#pragma once
// A recording of a minute at a windlass, with marks or without, for what is made of it afterwards.

#include "tests/recorder/made_recording.hpp"

namespace windlass::test {

inline constexpr int kTickRate = 100;             // Hz
inline constexpr double kPeakTension = 734'567.0; // N, of one sample of thousands
inline constexpr double kPeakTime = 31.37;        // s

inline std::uint64_t tick_at(double seconds) {
    return static_cast<std::uint64_t>(seconds * kTickRate + 0.5);
}

struct DebriefedRun {
    std::uint64_t run = 7;
    bool assessed = true;
    double peak = kPeakTension; ///< N
    double let_go = 10;         ///< s of exercise
    double waits = 4;           ///< s of the recording before the exercise runs
    std::string exercise = "let-go <port> & \"25m\"";
};

inline Criterion criterion(const char* code, CriterionKind kind, CriterionState state, unsigned weight,
                           unsigned milli, const char* objective, double decided, const char* reason) {
    Criterion made;
    made.code(code);
    made.text(std::string("criterion ") + code);
    made.kind(kind);
    made.state(state);
    made.weight(weight);
    made.milli(milli);
    made.counted(milli);
    made.counts(state != CRITERION_NOT_IN_PLAY);
    made.met(state == CRITERION_MET);
    made.deed(kind != CRITERION_LIMIT && kind != CRITERION_FINAL);
    made.objective(objective);
    made.tick(tick_at(decided));
    made.reason(reason);
    made.limit(5.5);
    made.worst(6.9);
    made.unit("m/s");
    made.time_outside(3.2);
    return made;
}

inline ObjectiveMark objective(const char* id, const char* outcome, double score) {
    ObjectiveMark made;
    made.id(id);
    made.text(std::string("objective ") + id);
    made.stcw("A-II/5");
    made.outcome(outcome);
    made.score(score);
    made.pass(70);
    return made;
}

/// A report as judged. tick: of its OrderTaken.
inline JudgedReport judged(double time, ReportCode code, const char* text, unsigned milli) {
    JudgedReport made;
    made.tick(tick_at(time));
    made.code(code);
    made.side(SIDE_PORT);
    made.criterion("report");
    made.milli(milli);
    made.text(text);
    return made;
}

inline Assessment marks() {
    Assessment marks;
    marks.tick(tick_at(60));
    marks.time(60);
    marks.finished(true);
    marks.ending(LESSON_DONE);
    marks.pass(70);
    marks.outcome("not_yet");
    // 100 * (30 * 1 + 15 * 0.2 + 5 * 0) / 50, the fourth never having come into play
    marks.score(66);
    marks.score_computed(66);
    marks.lesson_hash(0xabc);
    marks.assessment_hash(0x123);
    marks.criteria(
        {criterion("clutch", CRITERION_STATE_AT, CRITERION_MET, 30, 1000, "ready", 9, "0:09 clutch out"),
         criterion("fall", CRITERION_LIMIT, CRITERION_NOT_MET, 15, 200, "run", 41,
                   "0:41 port cable 6.9 m/s, 5.5 allowed"),
         criterion("report", CRITERION_REPORT, CRITERION_NOT_MET, 5, 0, "run", 50, "never <told>"),
         criterion("later", CRITERION_FINAL, CRITERION_NOT_IN_PLAY, 50, 0, "late", 0, "")});
    marks.criteria()[1].lost_tick(tick_at(33)); // it ran too fast from there on
    marks.objectives({objective("ready", "achieved", 100), objective("run", "not_yet", 15),
                      objective("late", "not_shown", 0)});
    OrderDone done;
    done.number(1);
    done.tick(tick_at(14));
    marks.orders({done});
    auto bottom = judged(27, REPORT_ON_THE_BOTTOM, "7.0 s after it was so, at 0:20", 1000);
    bottom.timed(true);
    bottom.delay(7);
    auto shackles = judged(37.5, REPORT_SHACKLES_IN_WATER, "1.96 were so", 0);
    shackles.figure(true);
    shackles.truth(1.96); // where the mark is counted, and not at the lip
    marks.reports({bottom, shackles});
    return marks;
}

/// Sixty seconds of exercise at the wall's speed, in an open tape. after: s of the recording at which it
/// begins.
inline void write_run(recorder::Tape& tape, const DebriefedRun& of, double after = 0) {
    const double zero = after + of.waits; // of exercise, in the recording
    std::uint32_t number = static_cast<std::uint32_t>(1 + of.run * 100'000);
    for (int i = static_cast<int>(-of.waits * 5); i <= 300; ++i) {
        ExerciseStatus status;
        const double time = std::max(0.0, i / 5.0);
        status.time(time);
        status.tick(tick_at(time));
        status.run(of.run);
        status.state(i < 0 ? RUN_READY : i == 300 ? RUN_FINISHED : RUN_RUNNING);
        status.exercise(of.exercise.c_str());
        status.title("Let go");
        tape.write(sample(wire::topics::exercise_status, status, zero + i / 5.0, ++number));
        if (i < 0) continue;
        for (int k = 0; k < 20; ++k) {
            const double now = time + k / 100.0;
            WindlassLoad load;
            load.side(SIDE_PORT);
            load.time(now);
            load.tick(tick_at(now));
            load.hawse_tension(std::abs(now - kPeakTime) < 0.004 ? of.peak : 40'000 + 100 * now);
            load.cable_out(now < of.let_go ? 5 : 5 + 2 * (now - of.let_go));
            load.cable_speed(now < of.let_go ? 0 : 2);
            load.brake_position(now < of.let_go ? 1 : 0.2);
            load.lining_temperature(300);
            load.breaking_load(4.5e6);
            tape.write(sample(wire::topics::windlass_load, load, zero + now, ++number));
        }
        ChainState chain;
        chain.side(SIDE_PORT);
        chain.time(time);
        chain.cable_out(time < of.let_go ? 5 : 5 + 2 * (time - of.let_go));
        Point3f lip, anchor;
        lip.z(6);
        anchor.y(static_cast<float>(time));
        anchor.z(-20);
        chain.nodes({lip, anchor});
        chain.tension({static_cast<float>(40'000 + 100 * time)});
        tape.write(sample(wire::topics::chain_state, chain, zero + time, ++number));
        AnchorState lies;
        lies.side(SIDE_PORT);
        lies.time(time);
        lies.phase(time < of.let_go ? ANCHOR_HOUSED : time < 20 ? ANCHOR_HANGING : ANCHOR_ON_BOTTOM);
        lies.position().z(time < 20 ? 0 : -20);
        tape.write(sample(wire::topics::anchor_state, lies, zero + time, ++number));
        ShipState ship;
        ship.time(time);
        ship.position().y(-time);
        tape.write(sample(wire::topics::ship_state, ship, zero + time, ++number));
    }
    const auto event = [&](double time, const char* code, const char* text, EventSeverity severity) {
        Event made;
        made.time(time);
        made.tick(tick_at(time));
        made.number(++number);
        made.code(code);
        made.text(text);
        made.severity(severity);
        made.side(SIDE_PORT);
        tape.write(sample(wire::topics::event, made, zero + 60, number));
    };
    event(of.let_go, "anchor.let_go", "anchor let go", EVENT_INFO);
    event(20, "anchor.on_bottom", "anchor on the bottom", EVENT_INFO);
    event(29, "model.steps", "of 9000 steps 77 with friction of the step's start", EVENT_INFO);
    event(30, "fault.active", "brake lining faded", EVENT_WARNING);
    BridgeOrder order;
    order.number(1);
    order.run(of.run);
    order.time(8);
    order.tick(tick_at(11.5));
    order.code(BRIDGE_ORDER_LET_GO);
    order.by("bridge-1");
    order.repeat_by(13);
    order.state(ORDER_REPEATED);
    tape.write(sample(wire::topics::bridge_order, order, zero + 60, ++number));
    std::uint64_t taken = 0;
    const auto take = [&](double time, const char* by, OrderTaken what) {
        what.run(of.run);
        what.tick(tick_at(time));
        what.number(++taken);
        what.source(by);
        tape.write(sample(wire::topics::order_taken, what, zero + 60, ++number));
    };
    OrderTaken said;
    said.kind(ORDER_TAKEN_REPORT);
    said.report().code(REPORT_ORDER_REPEATED);
    said.report().order_number(1);
    take(11.5, "anna", said);
    said.report() = Report();
    said.report().code(REPORT_ON_THE_BOTTOM);
    said.report().side(SIDE_PORT);
    take(27, "anna", said);
    said.report().code(REPORT_SHACKLES_IN_WATER);
    said.report().value(2);
    take(37.5, "anna", said);
    OrderTaken lever;
    lever.kind(ORDER_TAKEN_WINDLASS);
    lever.windlass().brake(1);
    take(32.5, "anna", lever);
    if (of.assessed) tape.write(sample(wire::topics::assessment, marks(), zero + 60, ++number));
}

} // namespace windlass::test
