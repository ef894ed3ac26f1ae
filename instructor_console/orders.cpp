#include "instructor_console/orders.hpp"

#include "station/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace windlass::console {

using station::Picture;

namespace {

RunOrder run_order(ExerciseAction action, std::string done, CarriedOut carried_out) {
    RunOrder order{.sample = {}, .carried_out = std::move(carried_out), .done = std::move(done)};
    order.sample.action(action);
    return order;
}

CarriedOut state_is(RunState wanted) {
    return [wanted](const Picture& now, const std::string&) {
        return now.status && now.status->state() == wanted;
    };
}

const FaultStatus* find(const Picture& picture, FaultCode code, int side) {
    if (!picture.status) return nullptr;
    const auto& faults = picture.status->faults();
    const auto found = std::ranges::find_if(
        faults, [&](const FaultStatus& fault) { return fault.code() == code && fault.side() == side; });
    return found == faults.end() ? nullptr : &*found;
}

bool near(double a, double b) {
    return std::abs(a - b) <= 1e-9 * std::max(1.0, std::abs(b));
}

} // namespace

// The server's log names who ordered it: a state or a tick of 0 alone may be older than the order, and so
// may any event of the log that is still arriving.
CarriedOut logged(std::string code) {
    return [code = std::move(code)](const Picture& now, const std::string& name) {
        return std::ranges::any_of(now.events, [&](const Event& event) {
            return event.code() == code.c_str() && event.text().to_string().ends_with(" by " + name);
        });
    };
}

RunOrder start_order() {
    return run_order(EXERCISE_START, "running", state_is(RUN_RUNNING));
}
RunOrder pause_order() {
    return run_order(EXERCISE_PAUSE, "paused", state_is(RUN_PAUSED));
}
RunOrder reset_order() {
    return run_order(EXERCISE_RESET, "back at the start", logged("exercise.reset"));
}

RunOrder stop_order() {
    return run_order(EXERCISE_STOP, "finished", [](const Picture& now, const std::string&) {
        return now.status &&
               (now.status->state() == RUN_FINISHED || now.status->state() == RUN_STOPPED_BY_FAULT);
    });
}

RunOrder time_scale_order(double scale) {
    RunOrder order = run_order(EXERCISE_TIME_SCALE, fmt::format("time scale {:g}", scale),
                               [scale](const Picture& now, const std::string&) {
                                   return now.status && near(now.status->time_scale(), scale);
                               });
    order.sample.time_scale(scale);
    return order;
}

RunOrder restore_order(double time) {
    RunOrder order = run_order(EXERCISE_RESTORE,
                               fmt::format("restored to the checkpoint at or before {:g} s, paused", time),
                               logged("exercise.restored"));
    order.sample.restore_time(time);
    return order;
}

RunOrder load_order(const std::string& file) {
    RunOrder order = run_order(EXERCISE_LOAD, "loaded " + file, logged("exercise.loaded"));
    order.sample.exercise() = file;
    return order;
}

RunOrder environment_order(const Environment& environment, const Picture& picture) {
    const ExerciseStatus& now = *picture.status;
    const double wind_speed = environment.wind_speed.value_or(now.wind_speed());
    const double wind_from = environment.wind_from.value_or(now.wind_from());
    const double current_speed = environment.current_speed.value_or(now.current_speed());
    const double current_towards = environment.current_towards.value_or(now.current_towards());
    RunOrder order =
        run_order(EXERCISE_ENVIRONMENT, "environment changed", [=](const Picture& p, const std::string&) {
            return p.status && near(p.status->wind_speed(), wind_speed) &&
                   near(p.status->wind_from(), wind_from) && near(p.status->current_speed(), current_speed) &&
                   near(p.status->current_towards(), current_towards);
        });
    order.sample.wind_speed(wind_speed);
    order.sample.wind_from(wind_from);
    order.sample.current_speed(current_speed);
    order.sample.current_towards(current_towards);
    return order;
}

FaultOrder fault_order(FaultCode code, int side, double severity, FaultTrigger trigger, double value) {
    FaultOrder order;
    order.sample.code(code);
    order.sample.side(side);
    order.sample.severity(severity);
    order.sample.trigger(trigger);
    order.sample.trigger_value(value);
    order.sample.clear(false);
    order.done = fmt::format("{} {}", station::name(code), trigger == TRIGGER_NOW ? "active" : "armed");
    order.carried_out = [=](const Picture& now, const std::string&) {
        const FaultStatus* fault = find(now, code, side);
        return fault && fault->phase() != FAULT_PHASE_CLEARED && near(fault->severity(), severity) &&
               fault->trigger() == trigger &&
               (trigger == TRIGGER_NOW || near(fault->trigger_value(), value)) &&
               (trigger != TRIGGER_NOW || fault->phase() == FAULT_PHASE_ACTIVE);
    };
    return order;
}

FaultOrder clear_order(FaultCode code, int side) {
    FaultOrder order;
    order.sample.code(code);
    order.sample.side(side);
    order.sample.clear(true);
    order.done = fmt::format("{} cleared", station::name(code));
    order.carried_out = [=](const Picture& now, const std::string&) {
        const FaultStatus* fault = find(now, code, side);
        return now.status && (!fault || fault->phase() == FAULT_PHASE_CLEARED);
    };
    return order;
}

} // namespace windlass::console
