#pragma once
// What a recording knows of an exercise's course: states by their hash, and the orders between them.

#include "recorder/recording/recording.hpp"
#include "server/run/status.hpp"

#include <span>

namespace windlass::recorder {

/// A state that the recording has: its hash, or all of it.
struct Mark {
    std::uint64_t tick = 0;
    std::uint64_t orders_taken = 0; ///< up to this state
    double time = 0;                ///< s of exercise
    std::uint64_t state_hash = 0;
    bool checkpoint = false;             ///< the whole state is in the recording
    recording::Nanoseconds log_time = 0; ///< where its message is
};

/// One course of an exercise, from a set-up, reset or restore to the next.
struct Run {
    std::uint64_t number = 0;           ///< as the server counts
    std::string exercise;               ///< its name; empty when no ExerciseStatus of it was heard
    bool taken_up = false;              ///< goes on with the run before it, whose server was lost
    std::vector<Mark> marks;            ///< in the order in which they came to be
    std::vector<run::OrderView> orders; ///< by number, each once

    /// Whether its states reach over that time (s of exercise), beginning with a checkpoint.
    bool covers(double time) const;
    /// The last checkpoint at or before that time (s of exercise); none: nullptr.
    const Mark* checkpoint_before(double time) const;
    const Mark* first_checkpoint() const;
};

/// The runs of a recording, in the order of their beginning. Throws mcap::Damage when a message of these
/// topics is not of its type.
std::vector<Run> runs_of(recording::Recording& recording);

/// One for each attempt: a run, and those that went on with it after its server was lost.
std::vector<std::span<const Run>> attempts_of(const std::vector<Run>& runs);

/// The run wanted (1: the first of the recording; 0: the last that covers the time). Throws
/// std::runtime_error, saying what there is, when none covers the time.
const Run& find_run(const std::vector<Run>& runs, std::size_t wanted, double time);

/// A state of a run.
struct Moment {
    const Run* run = nullptr;
    double time = 0; ///< s of exercise
};

/// What a replay of the recording shows at a position (s from its beginning). Throws std::runtime_error when
/// nothing is known of it, or the run has no state to go on from.
Moment shown_at(recording::Recording& recording, const std::vector<Run>& runs, double position);

/// "M:SS.mmm", to the millisecond: what is shown can be typed again.
std::string clock_text(double seconds);

/// The bytes of a checkpoint of the recording. Throws mcap::Damage when they are not there any more.
std::vector<std::uint8_t> checkpoint_bytes(recording::Recording& recording, const Run& run, const Mark& mark);

} // namespace windlass::recorder
