#pragma once
// The run of the exercise as seen from outside, beside the snapshot of its world.

#include "common/fields.hpp"
#include "server/exercise/picture/snapshot.hpp"

#include <array>
#include <cstdint>
#include <string>

namespace windlass::run {

/// Names, units and meaning as in idl ExerciseStatus.
struct RunStatus {
    exercise::RunState state = exercise::RunState::ready;
    double time_scale = 1;
    double time_scale_achieved = 0;
    std::string exercise, title_instructor, title_trainee;
    double lateness = 0;
    std::uint64_t overruns = 0, commands_refused = 0, samples_dropped = 0;
    int tick_rate_hz = 300;
    std::uint64_t definition_hash = 0, run = 0, orders_taken = 0;
    std::array<bool, 2> asked{}; ///< forecastle, bridge: it is asked something, and is not to read its gauges
};
WINDLASS_FIELDS(RunStatus, state, time_scale, time_scale_achieved, exercise, title_instructor, title_trainee,
                lateness, overruns, commands_refused, samples_dropped, tick_rate_hz, definition_hash, run,
                orders_taken, asked)

using AlertPriority = words::Priority;
enum class AlertCondition {
    active_unacknowledged,
    active_silenced,
    active_acknowledged,
    rectified_unacknowledged,
    normal
};

/// One alert, at its last change.
struct AlertView {
    std::string code;
    int side = -1;
    std::uint64_t tick = 0;
    double time = 0, raised_time = 0;
    AlertPriority priority = AlertPriority::alarm;
    AlertCondition condition = AlertCondition::active_unacknowledged;
    double value = 0;
    std::string text, explanation;
    bool deck_panel = false,
         bridge_panel = false; ///< where it is shown; neither: to instructors alone
    double silenced_until = 0; ///< s of wall time; 0: not silenced
    double silenced_left = 0;  ///< s of wall time, as of the last change
};
WINDLASS_FIELDS(AlertView, code, side, tick, time, raised_time, priority, condition, value, text, explanation,
                deck_panel, bridge_panel, silenced_until, silenced_left)

/// The whole state of an exercise at one tick; see exercise/checkpoint.hpp.
struct CheckpointView {
    std::uint64_t tick = 0;
    double time = 0;
    std::uint64_t state_hash = 0, definition_hash = 0, run = 0, orders_taken = 0;
    std::uint32_t format = 0;
    std::vector<std::uint8_t> data;
};
WINDLASS_FIELDS(CheckpointView, tick, time, state_hash, definition_hash, run, orders_taken, format, data)

/// What a seat is asked from now on; names, units and meaning as in idl Question.
struct QuestionView {
    std::uint64_t run = 0, tick = 0;
    double time = 0;
    bool forecastle = true; ///< who is asked; false: the bridge
    std::string id{}, text{}, unit{};
    double step = 0;
    struct Choice {
        std::string text;
    };
    std::vector<Choice> choices{};
    double meant_for = 0;
};
WINDLASS_FIELDS(QuestionView::Choice, text)
WINDLASS_FIELDS(QuestionView, run, tick, time, forecastle, id, text, unit, step, choices, meant_for)

/// What went into the exercise; see idl OrderTaken.
struct OrderView {
    std::uint64_t run = 0, tick = 0, number = 0;
    std::string source;
    exercise::Order command;
};
WINDLASS_FIELDS(OrderView, run, tick, number, source, command)

} // namespace windlass::run
