#include "server/dds/check.hpp"

#include "common/json_schema.hpp"
#include "common/text.hpp"
#include "server/dds/last_codes.hpp"
#include "server/exercise/weather/weather_table.hpp"
#include "server/run/limits.hpp"
#include "words/words.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace windlass::dds {

namespace {

// Beyond these no exercise is meaningful; they keep nonsense out of the physics.
constexpr double kTriggerTimeMax = 1e6;  // s, eleven days
constexpr double kTriggerCableMax = 1e4; // m
constexpr double kTriggerLoadMax = 1e8;  // N
constexpr std::size_t kNoteMin = 10;     // characters of an assessor's note
constexpr double kReportValueMax = 1e6;
constexpr double kDayLength = 86400;                           // s
constexpr double kLayerDepthMax = 1000;                        // m, as deep as exercises may be
constexpr double kOrderValueMax = 1000;                        // shackles or m
constexpr double kOrderDeadlineMax = 3600;                     // s
constexpr double kWatchRadiusMin = 10, kWatchRadiusMax = 2000; // m
constexpr double kWatchPlaceMax = 1e7;                         // m
constexpr int kTargetMax = 100;
// A foreign ship: a tsunami lifts none higher, none afloat heels or trims farther than 60 degrees, goes
// faster or turns quicker.
constexpr double kShipHeightMax = 50, kShipTiltCosine = 0.5, kShipSpeedMax = 30,
                 kShipSpinMax = 1;      // m, -, m/s, rad/s
constexpr double kSenderTimeMax = 1e11; // s: Unix time in seconds, and far beyond
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
        if (refusal_.source == run::kServerName)
            refuse("origin.source", '"' + refusal_.source + '"', "any name but the server's own");
        text("origin.source", origin.source().to_string());
        if (origin.serial() == 0) refuse("origin.serial", "0", "counts up from 1");
    }

    Checker& range(const char* field, double value, double low, double high, const char* unit = "") {
        if (value >= low && value <= high) return *this; // false for NaN
        return refuse(field, fmt::format("{}", value), fmt::format("{}..{}{}", low, high, unit), value);
    }

    Checker& side_present(int side, const run::Limits& limits) {
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

    Checker& some_text(const char* field, const std::string& value, const char* allowed) {
        if (value.empty()) return refuse(field, "\"\"", allowed);
        return text(field, value);
    }

    /// The code of one that the exercise itself calls: nothing hears any other.
    Checker& event(const char* field, const std::string& value) {
        if (std::find(words::kEventNames.begin(), words::kEventNames.end(), value) !=
            words::kEventNames.end())
            return *this;
        const std::string nearest =
            nearest_name(value, {words::kEventNames.begin(), words::kEventNames.end()});
        return refuse(
            field, '"' + printable(value) + '"',
            "the code of an event of the exercise, as config/schema/exercise.schema.json lists them" +
                (nearest.empty() ? "" : "; the nearest is \"" + nearest + '"'));
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

    std::optional<run::Refusal> result() const { return found_ ? std::optional(refusal_) : std::nullopt; }

private:
    run::Refusal refusal_;
    bool found_ = false;
};

/// Whether it answers what is asked is the session's business.
std::optional<run::Refusal> refusal_of(const char* topic, const Answer& sample) {
    Checker check(topic, sample.origin(), -1);
    check.some_text("question", sample.question().to_string(), "the id of the question")
        .known("kind", sample.kind(), ANSWER_NOT_KNOWN);
    if (sample.kind() == ANSWER_NUMBER)
        check.range("value", sample.value(), -kReportValueMax, kReportValueMax);
    return check.result();
}

void check_trigger(Checker& check, const FaultCommand& sample) {
    switch (sample.trigger()) {
    case TRIGGER_NOW:
        break;
    case TRIGGER_AT_TIME:
        check.range("trigger_value", sample.trigger_value(), 0, kTriggerTimeMax, " s");
        break;
    case TRIGGER_AT_CABLE_OUT:
    case TRIGGER_AT_CABLE_OUT_AT_MOST:
        check.range("trigger_value", sample.trigger_value(), 0, kTriggerCableMax, " m");
        break;
    case TRIGGER_AT_LOAD:
    case TRIGGER_AT_LOAD_AT_MOST:
        check.range("trigger_value", sample.trigger_value(), 0, kTriggerLoadMax, " N");
        break;
    case TRIGGER_AT_EVENT:
        check.event("trigger_event", sample.trigger_event().to_string());
        break;
    case TRIGGER_AT_ORDER:
        check.known("trigger_order", sample.trigger_order(), static_cast<std::int32_t>(kLastBridgeOrder));
        break;
    case TRIGGER_AT_CHANCE:
        check.range("trigger_value", sample.trigger_value(), 0, kTriggerTimeMax, " s")
            .range("trigger_until", sample.trigger_until(), sample.trigger_value(), kTriggerTimeMax, " s");
        break;
    }
}

/// "pay out to" wants a figure, and none is nought; "hold on" may be bare.
double least_figure(BridgeOrderCode code) {
    constexpr double kLeast = 0.1; // shackles or m
    if (code >= words::kBridgeOrderCode.size()) return 0;
    const auto& row = words::kBridgeOrderCode[code];
    return row.unit == words::Unit::none || !row.said_bare.empty() ? 0 : kLeast;
}

} // namespace

std::optional<run::Refusal> refusal(const WindlassCommand& sample, const run::Limits& limits) {
    return Checker("WindlassCommand", sample.origin(), sample.side())
        .side_present(sample.side(), limits)
        .range("brake", sample.brake(), 0, 1)
        .range("speed_lever", sample.speed_lever(), -1, 1)
        .result();
}

std::optional<run::Refusal> refusal(const HelmCommand& sample, const run::Limits& limits) {
    return Checker("HelmCommand", sample.origin(), -1)
        .range("engine", sample.engine(), -1, 1)
        .range("rudder", sample.rudder(), -limits.rudder_max, limits.rudder_max, " rad")
        .range("bow_thruster", sample.bow_thruster(), -1, 1)
        .range("stern_thruster", sample.stern_thruster(), -1, 1)
        .result();
}

std::optional<run::Refusal> refusal(const ExerciseCommand& sample, const run::Limits& limits) {
    Checker check("ExerciseCommand", sample.origin(), -1);
    check.known("action", sample.action(), EXERCISE_PREDICT);
    switch (sample.action()) {
    case EXERCISE_LOAD: {
        const std::string name = sample.exercise().to_string();
        check.text("exercise", name);
        if (!run::stays_in_folder(name)) {
            check.refuse("exercise", '"' + printable(name) + '"',
                         "a file name inside the server's exercise folder");
        }
        break;
    }
    case EXERCISE_TIME_SCALE: {
        const double scale = sample.time_scale();
        if (scale == 0 && limits.unpaced) break;
        if (scale >= run::kTimeScaleMin && scale <= run::kTimeScaleMax) break;
        check.refuse("time_scale", fmt::format("{}", scale),
                     limits.unpaced ? fmt::format("{}..{}, or 0 for as fast as possible", run::kTimeScaleMin,
                                                  run::kTimeScaleMax)
                                    : fmt::format("{}..{} (0 is not allowed in a real-time run)",
                                                  run::kTimeScaleMin, run::kTimeScaleMax),
                     scale);
        break;
    }
    case EXERCISE_RESTORE:
        check.range("restore_time", sample.restore_time(), 0, kTriggerTimeMax, " s");
        break;
    case EXERCISE_BOOKMARK:
        check.text("text", sample.text().to_string());
        break;
    case EXERCISE_SNAPSHOT:
    case EXERCISE_START:
    case EXERCISE_PAUSE:
    case EXERCISE_RESET:
    case EXERCISE_STOP:
    case EXERCISE_PREDICT:
        break;
    }
    return check.result();
}

std::optional<run::Refusal> refusal(const FaultCommand& sample, const run::Limits& limits) {
    Checker check("FaultCommand", sample.origin(), sample.side());
    check.known("code", sample.code(), kLastFault);
    check.side_present(sample.side(), limits);
    if (sample.clear()) return check.result(); // severity and trigger mean nothing then
    check.range("severity", sample.severity(), 0, 1).known("trigger", sample.trigger(), TRIGGER_AT_CHANCE);
    check.range("ramp", sample.ramp(), 0, kDayLength, " s").range("target", sample.target(), 0, kTargetMax);
    check_trigger(check, sample);
    return check.result();
}

std::optional<run::Refusal> refusal(const Report& sample, const run::Limits&) {
    Checker check("Report", sample.origin(), sample.side());
    check.known("code", sample.code(), kLastReport)
        .any_side(sample.side())
        .range("value", sample.value(), -kReportValueMax, kReportValueMax)
        .range("lead", sample.lead(), 0, 12)
        .known("stay", sample.stay(), STAY_GIVEN_LONG)
        .known("growing", sample.growing(), GROWING_TIGHT)
        .known("weight", sample.weight(), WEIGHT_TOO_MUCH)
        .range("order_number", sample.order_number(), 0, kReportValueMax)
        .known("order_code", sample.order_code(), kLastBridgeOrder)
        .text("text", sample.text().to_string());
    return check.result();
}

std::optional<run::Refusal> refusal(const EnvironmentCommand& sample, const run::Limits&) {
    const Weather& to = sample.weather();
    Checker check("EnvironmentCommand", sample.origin(), -1);
    for_each_field<exercise::Weather>([&](auto field) {
        const auto& value = field.on_wire(to);
        if constexpr (std::is_arithmetic_v<std::decay_t<decltype(value)>>) {
            constexpr exercise::WeatherRow kRow = exercise::weather_row(field.name);
            check.range(fmt::format("weather.{}", field.name).c_str(), value, kRow.low * kRow.si(),
                        kRow.high * kRow.si(),
                        kRow.unit().empty() ? "" : fmt::format(" {}", kRow.unit()).c_str());
        }
    });
    check.range("ramp", sample.ramp(), 0, kDayLength, " s");
    // Waves that are there have a length, and stand up to it.
    for (const auto& [field, height, period] :
         {std::tuple("weather.wave_period", to.wave_height(), to.wave_period()),
          std::tuple("weather.swell_period", to.swell_height(), to.swell_period())}) {
        const double least = exercise::least_wave_period(height);
        if (period < least)
            check.refuse(field, fmt::format("{}", period),
                         fmt::format("at least {:.1f} s for {} m: steeper waves break",
                                     std::ceil(10 * least) / 10, height),
                         period);
    }
    double above = -1;
    for (const CurrentLayer& layer : to.current_profile()) {
        check.range("weather.current_profile.depth", layer.depth(), 0, kLayerDepthMax, " m")
            .range("weather.current_profile.share", layer.share(), 0, 5)
            .range("weather.current_profile.turn", layer.turn(), -kTurn, kTurn, " rad");
        if (layer.depth() <= above)
            check.refuse("weather.current_profile.depth", fmt::format("{}", layer.depth()),
                         "deeper than the layer before", layer.depth());
        above = layer.depth();
    }
    return check.result();
}

std::optional<run::Refusal> refusal(const BridgeOrderCommand& sample, const run::Limits&) {
    Checker check("BridgeOrderCommand", sample.origin(), sample.side());
    check.known("code", sample.code(), kLastBridgeOrder)
        .any_side(sample.side())
        .range("value", sample.value(), least_figure(sample.code()), kOrderValueMax)
        .text("text", sample.text().to_string())
        .range("repeat_within", sample.repeat_within(), 0, kOrderDeadlineMax, " s")
        .range("do_within", sample.do_within(), 0, kOrderDeadlineMax, " s");
    if (sample.code() == BRIDGE_ORDER_CANCEL) check.range("cancels", sample.cancels(), 1, kReportValueMax);
    if (sample.code() == BRIDGE_ORDER_TEXT)
        check.some_text("text", sample.text().to_string(), "the order in words, 1..256 characters");
    return check.result();
}

std::optional<run::Refusal> refusal(const WatchCircle& sample, const run::Limits&) {
    Checker check("WatchCircle", sample.origin(), -1);
    if (!sample.kept()) return check.result(); // the rest means nothing then
    return check.range("x", sample.x(), -kWatchPlaceMax, kWatchPlaceMax, " m")
        .range("y", sample.y(), -kWatchPlaceMax, kWatchPlaceMax, " m")
        .range("radius", sample.radius(), kWatchRadiusMin, kWatchRadiusMax, " m")
        .result();
}

std::optional<run::Refusal> refusal(const LightsAndShapesCommand& sample, const run::Limits&) {
    return Checker("LightsAndShapesCommand", sample.origin(), -1)
        .result(); // two flags: nothing to be out of range
}

std::optional<run::Refusal> refusal(const DeckWorkCommand& sample, const run::Limits& limits) {
    Checker check("DeckWorkCommand", sample.origin(), sample.side());
    return check.side_present(sample.side(), limits).known("work", sample.work(), kLastDeckWork).result();
}

std::optional<run::Refusal> refusal(const OwnShipInput& sample, const run::Limits& limits) {
    const auto& at = sample.position();
    const auto& turned = sample.attitude();
    Checker check("OwnShipInput", sample.origin(), -1);
    check.range("position.x", at.x(), -kWatchPlaceMax, kWatchPlaceMax, " m")
        .range("position.y", at.y(), -kWatchPlaceMax, kWatchPlaceMax, " m")
        .range("position.z", at.z(), -kShipHeightMax, kShipHeightMax, " m");
    const double norm = std::sqrt(turned.w() * turned.w() + turned.x() * turned.x() +
                                  turned.y() * turned.y() + turned.z() * turned.z());
    if (!(std::abs(norm - 1) < 1e-3)) // what single precision and rounded text make of a unit is far nearer
        check.refuse("attitude", fmt::format("a norm of {}", norm), "a unit quaternion", norm);
    const auto upright = 1 - 2 * (turned.x() * turned.x() + turned.y() * turned.y()); // cosine of her tilt
    if (!(upright >= kShipTiltCosine))
        check.refuse("attitude", fmt::format("a heel or trim of which the cosine is {}", upright),
                     "60 degrees", upright);
    const auto each = [&check](const char* field, const windlass::Vec3& value, double max, const char* unit) {
        for (const double one : {value.x(), value.y(), value.z()})
            check.range(field, one, -max, max, unit);
    };
    each("velocity", sample.velocity(), kShipSpeedMax, " m/s");
    each("angular_velocity", sample.angular_velocity(), kShipSpinMax, " rad/s");
    check.range("time", sample.time(), -kSenderTimeMax, kSenderTimeMax, " s");
    if (limits.time_scale != 1)
        check.refuse("time", fmt::format("{}", sample.time()),
                     fmt::format("the exercise at time scale 1 (it is {}): a foreign ship sails in real time",
                                 limits.time_scale),
                     sample.time());
    return check.result();
}

std::optional<run::Refusal> refusal(const AssessmentCommand& sample, const run::Limits&) {
    Checker check("AssessmentCommand", sample.origin(), -1);
    check.known("verdict", sample.verdict(), VERDICT_CONFIRMED)
        .text("criterion", sample.criterion().to_string())
        .range("milli", sample.milli(), 0, 1000)
        .text("note", sample.note().to_string());
    if (sample.criterion().size() == 0 && sample.verdict() != VERDICT_CONFIRMED)
        check.refuse("criterion", "\"\"", "the code of a criterion; empty goes with VERDICT_CONFIRMED alone");
    if (sample.note().size() < kNoteMin)
        check.refuse("note", '"' + sample.note().to_string() + '"',
                     fmt::format("why, in {} characters or more", kNoteMin));
    return check.result();
}

std::optional<run::Refusal> refusal(const ForecastleAnswer& sample, const run::Limits&) {
    return refusal_of("ForecastleAnswer", sample);
}

std::optional<run::Refusal> refusal(const BridgeAnswer& sample, const run::Limits&) {
    return refusal_of("BridgeAnswer", sample);
}

std::optional<run::Refusal> refusal(const AlertCommand& sample, const run::Limits&) {
    return Checker("AlertCommand", sample.origin(), sample.side())
        .text("code", sample.code().to_string())
        .any_side(sample.side())
        .known("action", sample.action(), ALERT_SILENCE)
        .result();
}

std::optional<run::Refusal> refusal(const RestoreCommand& sample, const run::Limits&) {
    return Checker("RestoreCommand", sample.origin(), -1).text("from", sample.from().to_string()).result();
}
} // namespace windlass::dds
