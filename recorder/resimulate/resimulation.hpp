#pragma once
// A run gone through again from one of its checkpoints, with the orders that it took, held against the states
// that the recording has.

#include "recorder/resimulate/runs.hpp"
#include "server/assess/assessor.hpp"
#include "server/exercise/checkpoint.hpp"
#include "server/run/course.hpp"

#include <functional>
#include <stdexcept>

namespace windlass::recorder {

/// The recording cannot be gone through again: an order or a whole state that is needed is not in it.
struct Gap : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The exercise and its assessment as they were at a checkpoint. Throws Gap when it is none that this program
/// can go on from, mcap::Damage when it is not there any more.
run::Course course_at(recording::Recording& recording, const Run& run, const Mark& checkpoint);

/// Where the states that come of the orders cease to be the recorded ones.
struct Divergence {
    std::uint64_t tick = 0;        ///< the first at which a recorded hash differs
    std::uint64_t agreed_tick = 0; ///< the last at which one agreed
    std::uint64_t shown_tick = 0;  ///< of the checkpoint that the fields are from
    /// first: recorded, second: what came of the orders. At most ten. Empty: no checkpoint follows that could
    /// show them.
    std::vector<exercise::StateDifference> fields;
    std::string text() const; ///< for people, a line each
};

/// What was found.
struct Agreement {
    std::uint64_t from_tick = 0, to_tick = 0;
    double from_time = 0, to_time = 0; ///< s of exercise
    std::size_t orders = 0, hashes = 0, checkpoints = 0;
    std::optional<Divergence> parting; ///< nothing: bit for bit the recorded states
};

/// Times are in s of exercise.
class Resimulation {
public:
    /// Begins at the checkpoint. Throws Gap when it is none that this program can go on from.
    Resimulation(recording::Recording& recording, const Run& run, const Mark& checkpoint);

    /// Goes on to the last recorded state up to that time; each on the way is compared. Stops where one
    /// differs. Throws Gap.
    Agreement compare(double to_time);

    /// The state at that time as a checkpoint, once the states around it have turned out to be the recorded
    /// ones. Throws Gap, also when they are not: another version of the model recorded them.
    std::vector<std::uint8_t> state_at(double time);

    /// The assessment where it has been gone through to; of no lesson where the exercise has none.
    const assess::Assessor& assessor() const { return course_.assessor(); }
    /// Called after each tick and order of an exercise with a lesson.
    void watch(std::function<void(const assess::Assessor&)> look) { look_ = std::move(look); }
    /// Goes to the run's last state, and takes the orders that came then; nothing is compared. Throws Gap.
    void go_through();

private:
    void take_orders(std::uint64_t last);
    void step_to(std::uint64_t tick);
    [[noreturn]] void lost() const;
    bool agrees(const Mark& mark);
    Divergence part_at(const Mark& mark, std::uint64_t agreed_tick);

    recording::Recording& recording_;
    const Run& run_;
    run::Course course_;
    std::size_t next_mark_;  // not compared yet
    std::size_t next_order_; // not applied yet
    std::function<void(const assess::Assessor&)> look_;
};

} // namespace windlass::recorder
