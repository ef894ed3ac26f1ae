#pragma once
// How an exercise would go on for a minute if nobody did anything, by a branch of it that is thrown away.
//
// Nobody does anything: every lever stays where it is (a hand that holds one goes on holding it), nobody
// speaks, answers, orders or changes the weather. The exercise's armed faults come, and its lesson goes on:
// what its bridge orders, breaks and lets blow is part of what comes by itself.

#include "server/run/course.hpp"

#include <optional>

namespace windlass::run {

/// As in idl PredictionState.
enum class PredictionState { off, awaited, whole, asked, dear, stopped, foreign };

/// Names, units and meaning as in idl PredictedCable.
struct PredictedCable {
    exercise::Side side = exercise::Side::port;
    double cable_out = 0, cable_speed = 0, hawse_tension = 0, gypsy_load = 0, brake_load = 0;
    double lining_temperature = 0;
    exercise::AnchorPhase anchor = exercise::AnchorPhase::housed;
};
WINDLASS_FIELDS(PredictedCable, side, cable_out, cable_speed, hawse_tension, gypsy_load, brake_load,
                lining_temperature, anchor)

struct PredictedMoment {
    double time = 0, x = 0, y = 0, heading = 0;
    std::vector<PredictedCable> cables;
};
WINDLASS_FIELDS(PredictedMoment, time, x, y, heading, cables)

/// What a picture of the exercise shows of a moment that is predicted.
PredictedMoment moment_of(const exercise::Snapshot& seen);

/// Names, units and meaning as in idl Prediction.
struct PredictionView {
    std::uint64_t run = 0, tick = 0;
    double time = 0;
    PredictionState state = PredictionState::off;
    std::vector<PredictedMoment> moments;
    std::vector<exercise::ExerciseEvent> events;
    double processor_time = 0;
};
WINDLASS_FIELDS(PredictionView, run, tick, time, state, moments, events, processor_time)

/// The branch, gone through tick by tick.
class Branch {
public:
    static constexpr int kSeconds = 60;            ///< of exercise, as far as it goes
    static constexpr std::size_t kMostEvents = 32; ///< that are kept, the first ones

    /// checkpoint: of an exercise as it stands, with its assessment, in that run. Throws
    /// exercise::CheckpointError.
    Branch(const std::vector<std::uint8_t>& checkpoint, std::uint64_t run);

    /// One tick; false: the branch is at its end, and what was found says why.
    bool step();
    /// It goes no further: it has cost enough.
    void give_up() { found_.state = PredictionState::dear; }

    /// What it has come to, up to now.
    const PredictionView& found() const { return found_; }

private:
    void look();
    void note_events();
    bool asks() const;

    Course course_;
    exercise::Snapshot seen_;
    PredictionView found_;
};

} // namespace windlass::run
