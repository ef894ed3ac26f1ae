#pragma once
// A lesson's scripts played from a state that was kept, as of a recording: the same beginning, the same
// chances, the same weather, and other hands.

#include "lesson/seat.hpp"
#include "server/run/course.hpp"
#include "trainee_client/script.hpp"

#include <functional>
#include <vector>

namespace windlass::lesson {

/// The scripts at their seats, tick by tick.
class PlayedOn {
public:
    /// course: must outlive this. Throws std::runtime_error when the exercise has no lesson.
    PlayedOn(run::Course& course, const std::vector<trainee::Script>& scripts);

    /// What else goes into the exercise, before the next tick.
    void take(const exercise::Order& order);
    /// One tick: what the hands do, the step, and what the lesson orders then. Throws std::runtime_error when
    /// the state ceases to be finite.
    void step();
    /// The lesson is over, or could not be any more.
    bool over() const;
    /// A script gives the orders of the bridge.
    bool conned() const;

    /// The picture of the last tick, as a server shows it: with what the lesson has ordered at it.
    const exercise::Snapshot& seen();

private:
    run::Course& course_;
    std::vector<Seat> seats_;
    run::RunStatus status_;
    std::uint64_t look_every_, last_; // ticks; tick
    exercise::Snapshot seen_;
    bool seen_is_now_ = false;
};

/// Plays the scripts on from there until the lesson is over, as play() does. others: what else went into the
/// exercise, by tick: an instructor's faults and weather. look: the picture before the first tick, and after
/// each. Throws std::runtime_error when the exercise has no lesson, or its state ceases to be finite.
void play_on(run::Course& course, const std::vector<trainee::Script>& scripts,
             const std::vector<run::OrderView>& others,
             const std::function<void(const exercise::Snapshot&)>& look);

} // namespace windlass::lesson
