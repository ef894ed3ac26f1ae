#pragma once
// A centre in one process: the server's own session, mailbox, pacer and keeping, and the recorder's tape, on
// a simulated clock, network and disks, worked by scripted stations, lost and started again, and checked
// after each tick.

#include "server/exercise/definition/exercise_def.hpp"
#include "sim/world.hpp"

#include <cstdint>
#include <optional>

namespace windlass::sim {

/// What somebody does to the centre so that a check must fail: tests that the checks can.
enum class Sabotage {
    none,
    last_record_lost, ///< of the newest file, at each restart
    order_altered,    ///< one, between the session and what is told of it
    ghost_hand,       ///< an order in the name of a station that did not give it
    marks_altered,    ///< once, of what is told of a lesson
    event_lost,
    taking_altered,       ///< once: whose hand is told to have taken levers
    question_untold,      ///< a seat is asked, and not told
    question_passed_over, ///< and no instructor has started the exercise
    alert_untold,         ///< a disk that refuses, and nobody is told
    recording_shortened,  ///< the newest, each time that a recorder has gone
    recording_doubled,    ///< one sample of it
    recording_deaf,       ///< to one sample
    recording_unflushed,  ///< as if it were
    chance,               ///< from outside the seed
    // Between a station's program and its pages, which then are in every seed:
    page_event_lost,
    page_state_lost,    ///< each status from some time on
    page_sees_truth,    ///< its program hears what its seat may not
    page_lever_altered, ///< on its way out
    page_taking_untold, ///< another station has its levers, and it is not told
    page_hand_stays,    ///< on levers that another station has
    page_works_on       ///< behind its end
};

struct Plan {
    std::uint64_t seed = 1;
    double minutes = 1;                         ///< of exercise, of all servers one after the other
    std::optional<exercise::ExerciseDef> def{}; ///< nothing: drawn as well
    Sabotage sabotage = Sabotage::none;
    World::Story story{}; ///< hears what is drawn; may be empty
};

struct Outcome {
    std::uint64_t ticks = 0; ///< of exercise
    double exercised = 0;    ///< s, of it
    double simulated = 0;    ///< s, of the world
    std::uint64_t kills = 0, power_cuts = 0, taken_up = 0, set_back = 0, anew = 0, rotten = 0;
    std::uint64_t left = 0; ///< servers that were told to begin anew, and did
    std::uint64_t predictions = 0;
    std::uint64_t takings = 0; ///< of levers, from another hand
    std::uint64_t questions = 0, answered = 0, passed_over = 0, stood_again = 0; ///< at freezes
    std::uint64_t recordings = 0, recorder_kills = 0;
    std::uint64_t pages = 0, sent_away = 0; ///< connections, and those that their gateway ended
    std::uint64_t taken = 0;                ///< that a page was told that another station has its levers
    std::uint64_t stations = 0;             ///< programs with pages that were killed
    std::uint64_t digest = 0; ///< of all that was told; the recorder, which alters nothing, has no part in it
    struct Failed {
        Failure what;
        std::uint64_t tick = 0;
        double at = 0; ///< s, of the world
    };
    std::optional<Failed> failed;
};

/// Runs the centre of that seed, until it has come so far or a check fails.
Outcome run(const Plan& plan);

} // namespace windlass::sim
