#include "server/dds/check.hpp"

#include "common/text.hpp"
#include "server/run/limits.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <numbers>

namespace windlass::server {

namespace {

// Beyond these no exercise is meaningful; they keep nonsense out of the physics.
constexpr double kWindMax = 60;       // m/s, above the strongest hurricane winds
constexpr double kCurrentMax = 5;     // m/s
constexpr double kTimeScaleMin = 0.1; // as idl says
constexpr double kTimeScaleMax = 20;
constexpr double kTriggerTimeMax = 1e6;  // s, eleven days
constexpr double kTriggerCableMax = 1e4; // m
constexpr double kTriggerLoadMax = 1e8;  // N
constexpr double kReportValueMax = 1e6;
constexpr double kTurn = 2 * std::numbers::pi;

/// Collects the first thing wrong with one sample.
class Checker {
public:
    Checker(const char* topic, const Origin& origin, int side) {
        refusal_.topic = topic;
        refusal_.source = printable(origin.source().to_string());
        refusal_.side = side == 0 || side == 1 ? side : -1;
        if (refusal_.source.empty())
            refuse("origin.source", "\"\"", "the name of the sender, 1..32 characters");
        if (refusal_.source == kServerName)
            refuse("origin.source", '"' + refusal_.source + '"', "any name but the server's own");
        text("origin.source", origin.source().to_string());
        if (origin.serial() == 0) refuse("origin.serial", "0", "counts up from 1");
    }

    Checker& range(const char* field, double value, double low, double high, const char* unit = "") {
        if (value >= low && value <= high) return *this; // false for NaN
        return refuse(field, fmt::format("{}", value), fmt::format("{}..{}{}", low, high, unit), value);
    }

    Checker& side_present(int side, const Limits& limits) {
        if (side >= 0 && side <= 1 && limits.side_present[static_cast<std::size_t>(side)]) return *this;
        const bool both = limits.side_present[0] && limits.side_present[1];
        return refuse("side", fmt::format("{}", side),
                      both                     ? "0 (port) or 1 (starboard)"
                      : limits.side_present[0] ? "0 (port), the only cable of this exercise"
                                               : "1 (starboard), the only cable of this exercise",
                      side);
    }

    Checker& any_side(int side) {
        if (side >= -1 && side <= 1) return *this;
        return refuse("side", fmt::format("{}", side), "0 (port), 1 (starboard) or -1 (neither)", side);
    }

    /// Enumerators arrive as any 32-bit number.
    template <class Enum>
    Checker& known(const char* field, Enum value, Enum last) {
        const auto number = static_cast<std::uint32_t>(value);
        if (number <= static_cast<std::uint32_t>(last)) return *this;
        return refuse(field, fmt::format("{}", number),
                      fmt::format("a code of the IDL, 0..{}", static_cast<std::uint32_t>(last)), number);
    }

    /// No control characters: the text goes into logs and onto terminals.
    Checker& text(const char* field, const std::string& value) {
        if (printable(value) == value) return *this;
        return refuse(field, '"' + printable(value) + '"', "text in UTF-8 without control characters");
    }

    Checker& refuse(const char* field, std::string value, std::string allowed, double number = 0) {
        if (found_) return *this;
        found_ = true;
        refusal_.field = field;
        refusal_.value = std::move(value);
        refusal_.allowed = std::move(allowed);
        refusal_.number = std::isfinite(number) ? number : 0;
        return *this;
    }

    std::optional<Refusal> result() const { return found_ ? std::optional(refusal_) : std::nullopt; }

private:
    Refusal refusal_;
    bool found_ = false;
};

void check_trigger(Checker& check, const FaultCommand& sample) {
    switch (sample.trigger()) {
    case TRIGGER_NOW:
        break;
    case TRIGGER_AT_TIME:
        check.range("trigger_value", sample.trigger_value(), 0, kTriggerTimeMax, " s");
        break;
    case TRIGGER_AT_CABLE_OUT:
        check.range("trigger_value", sample.trigger_value(), 0, kTriggerCableMax, " m");
        break;
    case TRIGGER_AT_LOAD:
        check.range("trigger_value", sample.trigger_value(), 0, kTriggerLoadMax, " N");
        break;
    }
}

} // namespace

std::optional<Refusal> refusal(const WindlassCommand& sample, const Limits& limits) {
    return Checker("WindlassCommand", sample.origin(), sample.side())
        .side_present(sample.side(), limits)
        .range("brake", sample.brake(), 0, 1)
        .range("speed_lever", sample.speed_lever(), -1, 1)
        .result();
}

std::optional<Refusal> refusal(const HelmCommand& sample, const Limits& limits) {
    return Checker("HelmCommand", sample.origin(), -1)
        .range("engine", sample.engine(), -1, 1)
        .range("rudder", sample.rudder(), -limits.rudder_max, limits.rudder_max, " rad")
        .range("bow_thruster", sample.bow_thruster(), -1, 1)
        .range("stern_thruster", sample.stern_thruster(), -1, 1)
        .result();
}

std::optional<Refusal> refusal(const ExerciseCommand& sample, const Limits& limits) {
    Checker check("ExerciseCommand", sample.origin(), -1);
    check.known("action", sample.action(), EXERCISE_STOP);
    switch (sample.action()) {
    case EXERCISE_LOAD: {
        const std::string name = sample.exercise().to_string();
        check.text("exercise", name);
        if (!stays_in_folder(name)) {
            check.refuse("exercise", '"' + printable(name) + '"',
                         "a file name inside the server's exercise folder");
        }
        break;
    }
    case EXERCISE_TIME_SCALE: {
        const double scale = sample.time_scale();
        if (scale == 0 && limits.unpaced) break;
        if (scale >= kTimeScaleMin && scale <= kTimeScaleMax) break;
        check.refuse(
            "time_scale", fmt::format("{}", scale),
            limits.unpaced
                ? fmt::format("{}..{}, or 0 for as fast as possible", kTimeScaleMin, kTimeScaleMax)
                : fmt::format("{}..{} (0 is not allowed in a real-time run)", kTimeScaleMin, kTimeScaleMax),
            scale);
        break;
    }
    case EXERCISE_ENVIRONMENT:
        check.range("wind_speed", sample.wind_speed(), 0, kWindMax, " m/s")
            .range("wind_from", sample.wind_from(), -kTurn, kTurn, " rad")
            .range("current_speed", sample.current_speed(), 0, kCurrentMax, " m/s")
            .range("current_towards", sample.current_towards(), -kTurn, kTurn, " rad");
        break;
    case EXERCISE_RESTORE:
        check.range("restore_time", sample.restore_time(), 0, kTriggerTimeMax, " s");
        break;
    case EXERCISE_SNAPSHOT:
    case EXERCISE_START:
    case EXERCISE_PAUSE:
    case EXERCISE_RESET:
    case EXERCISE_STOP:
        break;
    }
    return check.result();
}

std::optional<Refusal> refusal(const FaultCommand& sample, const Limits& limits) {
    Checker check("FaultCommand", sample.origin(), sample.side());
    check.known("code", sample.code(), FAULT_CABLE_TWISTED);
    if (!exercise::modelled(static_cast<exercise::FaultCode>(sample.code()))) {
        check.refuse("code", fmt::format("{}", static_cast<int>(sample.code())),
                     "a fault that is modelled (see topics.md); this one is not modelled yet",
                     static_cast<double>(sample.code()));
    }
    check.side_present(sample.side(), limits);
    if (sample.clear()) return check.result(); // severity and trigger mean nothing then
    check.range("severity", sample.severity(), 0, 1).known("trigger", sample.trigger(), TRIGGER_AT_LOAD);
    check_trigger(check, sample);
    return check.result();
}

std::optional<Refusal> refusal(const Report& sample, const Limits&) {
    return Checker("Report", sample.origin(), sample.side())
        .known("code", sample.code(), REPORT_ORDER_REPEATED)
        .any_side(sample.side())
        .range("value", sample.value(), -kReportValueMax, kReportValueMax)
        .known("stay", sample.stay(), STAY_LONG)
        .text("text", sample.text().to_string())
        .result();
}

std::optional<Refusal> refusal(const AlertCommand& sample, const Limits&) {
    return Checker("AlertCommand", sample.origin(), sample.side())
        .text("code", sample.code().to_string())
        .any_side(sample.side())
        .known("action", sample.action(), ALERT_SILENCE)
        .result();
}

std::optional<Refusal> refusal(const RestoreCommand& sample, const Limits&) {
    return Checker("RestoreCommand", sample.origin(), -1).text("from", sample.from().to_string()).result();
}

OrderContent order(const WindlassCommand& sample) {
    return exercise::Order{exercise::WindlassOrder{.side = static_cast<exercise::Side>(sample.side()),
                                                   .brake = sample.brake(),
                                                   .speed_lever = sample.speed_lever(),
                                                   .clutch_in = sample.clutch_in(),
                                                   .stopper_closed = sample.stopper_closed(),
                                                   .emergency_stop = sample.emergency_stop()}};
}

OrderContent order(const HelmCommand& sample) {
    return exercise::Order{exercise::HelmOrder{.engine = sample.engine(),
                                               .rudder = sample.rudder(),
                                               .bow_thruster = sample.bow_thruster(),
                                               .stern_thruster = sample.stern_thruster()}};
}

OrderContent order(const ExerciseCommand& sample) {
    RunOrder run;
    switch (sample.action()) {
    case EXERCISE_LOAD:
        run.action = RunAction::load;
        run.exercise = sample.exercise().to_string();
        break;
    case EXERCISE_PAUSE:
        run.action = RunAction::pause;
        break;
    case EXERCISE_RESET:
        run.action = RunAction::reset;
        break;
    case EXERCISE_TIME_SCALE:
        run.action = RunAction::time_scale;
        run.time_scale = sample.time_scale();
        break;
    case EXERCISE_STOP:
        run.action = RunAction::stop;
        break;
    case EXERCISE_ENVIRONMENT:
        return exercise::Order{exercise::EnvironmentOrder{.wind_speed = sample.wind_speed(),
                                                          .wind_from = sample.wind_from(),
                                                          .current_speed = sample.current_speed(),
                                                          .current_towards = sample.current_towards()}};
    case EXERCISE_SNAPSHOT:
        run.action = RunAction::snapshot;
        break;
    case EXERCISE_RESTORE:
        run.action = RunAction::restore;
        run.restore_time = sample.restore_time();
        break;
    case EXERCISE_START:
        break;
    }
    return run;
}

OrderContent order(const FaultCommand& sample) {
    return exercise::Order{exercise::FaultOrder{
        .code = static_cast<exercise::FaultCode>(sample.code()),
        .side = static_cast<exercise::Side>(sample.side()),
        .severity = sample.clear() ? 0 : sample.severity(),
        .trigger = sample.clear() ? exercise::FaultTrigger::now
                                  : static_cast<exercise::FaultTrigger>(sample.trigger()),
        .trigger_value = sample.clear() || sample.trigger() == TRIGGER_NOW ? 0 : sample.trigger_value(),
        .clear = sample.clear()}};
}

OrderContent order(const Report& sample) {
    return exercise::Order{exercise::ReportMade{.code = static_cast<exercise::ReportCode>(sample.code()),
                                                .side = sample.side(),
                                                .value = sample.value(),
                                                .text = sample.text().to_string()}};
}

OrderContent order(const AlertCommand& sample) {
    return AlertOrder{.code = sample.code().to_string(),
                      .side = sample.side(),
                      .acknowledge = sample.action() == ALERT_ACKNOWLEDGE};
}

OrderContent order(const RestoreCommand& sample) {
    return StateOrder{.from = sample.from().to_string(), .checkpoint = sample.checkpoint()};
}

} // namespace windlass::server
