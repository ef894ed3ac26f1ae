#include "instructor_console/orders.hpp"

#include "server/exercise/weather/weather.hpp"
#include "server/exercise/weather/weather_table.hpp"
#include "station/names.hpp"
#include "station/wind_sea.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

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
    if (!picture.truth) return nullptr;
    const auto& faults = picture.truth->faults();
    const auto found = std::ranges::find_if(
        faults, [&](const FaultStatus& fault) { return fault.code() == code && fault.side() == side; });
    return found == faults.end() ? nullptr : &*found;
}

bool near(double a, double b) {
    return std::abs(a - b) <= 1e-9 * std::max(1.0, std::abs(b));
}

bool same_direction(double a, double b) {
    return std::abs(std::remainder(a - b, 2 * std::numbers::pi)) <= 1e-9;
}

/// To 0.01 m/s, which a tide takes half a minute for.
bool same_stream(const Weather& a, const Weather& b) {
    const auto part = [](const Weather& w, double turn) {
        return w.current_speed() * std::cos(w.current_towards() - turn);
    };
    constexpr double kEast = std::numbers::pi / 2;
    return std::hypot(part(a, 0) - part(b, 0), part(a, kEast) - part(b, kEast)) <= 0.01;
}

/// Time of day, a veering wind and the tide run on from the moment on at which they are taken.
bool same(const Weather& a, const Weather& b) {
    bool same = std::ranges::equal(
        a.current_profile(), b.current_profile(), [](const CurrentLayer& one, const CurrentLayer& other) {
            return near(one.depth(), other.depth()) && near(one.share(), other.share()) &&
                   same_direction(one.turn(), other.turn());
        });
    same = same && same_stream(a, b) && std::abs(a.tide_height() - b.tide_height()) <= 0.01;
    for_each_field<exercise::Weather>([&](auto field) {
        constexpr bool kApart =
            field.name == "time_of_day" || field.name == "tide_height" || field.name.starts_with("current_");
        if constexpr (!kApart) {
            const auto one = field.on_wire(a), other = field.on_wire(b);
            if constexpr (!exercise::weather_row(field.name).is_direction())
                same = same && near(one, other);
            else if (field.name != "wind_from" || b.veering() == 0)
                same = same && same_direction(one, other);
        }
    });
    return same;
}

/// The wind sea of the wind that is wanted, as far as it was not given itself.
void raise_sea(Weather& wanted, const Environment& given, const Picture& picture) {
    constexpr double kDeep = 1000; // m
    const double depth = picture.truth && picture.truth->depth() > 0 ? picture.truth->depth() : kDeep;
    const station::WindSea sea = station::wind_sea(wanted.wind_speed(), *given.fetch, depth);
    if (!given.figures.contains("wave_height")) wanted.wave_height(sea.height);
    if (!given.figures.contains("wave_period") && sea.height > 0) wanted.wave_period(sea.period);
    if (!given.figures.contains("wave_from")) wanted.wave_from(wanted.wind_from());
}

/// Within a minute of the day, either way round midnight: it runs on between order and answer.
bool same_hour(double a, double b) {
    return std::abs(std::remainder(a - b, 24 * 3600.0)) <= 60;
}

} // namespace

// The server's log names who ordered it: a state or a tick of 0 alone may be older than the order, and so
// may any event of the log that is still arriving.
CarriedOut logged(std::string code) {
    return [code = std::move(code)](const Picture& now, const std::string& name) {
        return std::ranges::any_of(now.events.kept, [&](const Event& event) {
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
    RunOrder order = run_order(EXERCISE_STOP, "finished", [](const Picture& now, const std::string&) {
        return now.status &&
               (now.status->state() == RUN_FINISHED || now.status->state() == RUN_STOPPED_BY_FAULT);
    });
    order.ends_server = true; // that with --duration ends with its exercises
    return order;
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

RunOrder load_order(const std::string& file, bool practice) {
    RunOrder order = run_order(EXERCISE_LOAD, "loaded " + file, logged("exercise.loaded"));
    order.sample.exercise() = file;
    order.sample.practice(practice);
    return order;
}

RunOrder bookmark_order(const std::string& text, const Picture& picture) {
    RunOrder order =
        run_order(EXERCISE_BOOKMARK, "bookmark kept",
                  [text, from = picture.events.received](const Picture& now, const std::string&) {
                      return std::ranges::any_of(now.events.after(from), [&](const Event& event) {
                          return event.code() == "exercise.bookmark" &&
                                 event.text().to_string().find(text) != std::string::npos;
                      });
                  });
    order.sample.text() = text;
    return order;
}

RunOrder predict_order(bool predict) {
    RunOrder order =
        run_order(EXERCISE_PREDICT, fmt::format("predictions {}", predict ? "on: a minute ahead" : "off"),
                  [](const Picture&, const std::string&) { return true; });
    order.sample.predict(predict);
    return order;
}

ServerOrder<EnvironmentCommand> environment_order(const Environment& environment, const Picture& picture) {
    Weather wanted = picture.environment->after();
    wanted.time_of_day(picture.environment->now().time_of_day()); // it has gone on
    for_each_field<exercise::Weather>([&](auto field) {
        auto& figure = field.on_wire(wanted);
        const auto given = environment.figures.find(field.name);
        if constexpr (std::is_arithmetic_v<std::decay_t<decltype(figure)>>)
            if (given != environment.figures.end())
                figure = static_cast<std::decay_t<decltype(figure)>>(given->second);
    });
    if (environment.fetch) raise_sea(wanted, environment, picture);
    if (environment.current_profile) wanted.current_profile(*environment.current_profile);

    ServerOrder<EnvironmentCommand> order;
    order.sample.weather(wanted);
    order.sample.ramp(environment.ramp.value_or(picture.environment->ramp_left()));
    order.done = order.sample.ramp() > 0
                     ? fmt::format("environment changes within {:g} s", order.sample.ramp())
                     : "environment changed";
    const bool hour_given = environment.figures.contains("time_of_day");
    order.carried_out = [wanted, hour_given](const Picture& now, const std::string&) {
        return now.environment && same(now.environment->after(), wanted) &&
               (!hour_given || same_hour(now.environment->after().time_of_day(), wanted.time_of_day()));
    };
    return order;
}

FaultOrder fault_order(FaultCode code, int side, double severity, const Trigger& trigger, double ramp,
                       int target) {
    FaultOrder order;
    order.sample.code(code);
    order.sample.side(side);
    order.sample.severity(severity);
    order.sample.ramp(ramp);
    order.sample.trigger(trigger.what);
    order.sample.trigger_value(trigger.value);
    order.sample.trigger_until(trigger.until);
    order.sample.trigger_event() = trigger.event;
    order.sample.trigger_order(static_cast<std::int32_t>(trigger.order));
    order.sample.target(target);
    order.sample.clear(false);
    order.done = fmt::format("{} {}", station::name(code), trigger.what == TRIGGER_NOW ? "active" : "armed");
    order.carried_out = [=](const Picture& now, const std::string&) {
        const FaultStatus* fault = find(now, code, side);
        if (!fault || fault->phase() == FAULT_PHASE_CLEARED) return false;
        const bool same = near(fault->severity(), severity) && near(fault->ramp(), ramp) &&
                          fault->target() == target && fault->trigger() == trigger.what;
        if (trigger.what == TRIGGER_NOW) return same && fault->phase() == FAULT_PHASE_ACTIVE;
        return same && near(fault->trigger_value(), trigger.value) &&
               near(fault->trigger_until(), trigger.until) &&
               fault->trigger_event().to_string() == trigger.event &&
               (trigger.what != TRIGGER_AT_ORDER ||
                fault->trigger_order() == static_cast<std::int32_t>(trigger.order));
    };
    return order;
}

ServerOrder<BridgeOrderCommand> bridge_order(const BridgeOrderWish& wish, const Picture& picture) {
    ServerOrder<BridgeOrderCommand> order;
    order.sample.code(wish.code);
    order.sample.side(wish.side);
    order.sample.value(wish.value);
    order.sample.text() = wish.text;
    order.sample.repeat_within(wish.repeat_within);
    order.sample.do_within(wish.do_within);
    order.sample.cancels(wish.cancels);
    if (wish.code == BRIDGE_ORDER_CANCEL) {
        order.done = fmt::format("order {} cancelled", wish.cancels);
        order.carried_out = [number = wish.cancels](const Picture& now, const std::string&) {
            return std::ranges::any_of(now.orders, [number](const BridgeOrder& one) {
                return one.number() == number && one.state() == ORDER_CANCELLED;
            });
        };
        return order;
    }
    order.done =
        "ordered " +
        (wish.code == BRIDGE_ORDER_TEXT ? wish.text : station::words(wish.code, wish.side, wish.value));
    const std::uint64_t run = picture.orders.empty() ? 0 : picture.orders.back().run();
    const std::int32_t last = picture.orders.empty() ? 0 : picture.orders.back().number();
    order.carried_out = [wish, run, last](const Picture& now, const std::string& name) {
        return std::ranges::any_of(now.orders, [&](const BridgeOrder& one) {
            return (one.run() != run || one.number() > last) && one.code() == wish.code &&
                   one.side() == wish.side && one.by() == name.c_str();
        });
    };
    return order;
}

ServerOrder<WatchCircle> watch_circle(bool kept, double x, double y, double radius) {
    ServerOrder<WatchCircle> order;
    order.sample.kept(kept);
    order.sample.x(x);
    order.sample.y(y);
    order.sample.radius(radius);
    order.done = kept ? fmt::format("anchor watch: {:g} m round {:.1f}, {:.1f}", radius, x, y)
                      : std::string{"no anchor watch"};
    order.carried_out = [](const Picture&, const std::string&) { return true; };
    return order;
}

ServerOrder<LightsAndShapesCommand> lights_and_shapes(bool ball, bool lights) {
    ServerOrder<LightsAndShapesCommand> order;
    order.sample.anchor_ball(ball);
    order.sample.anchor_lights(lights);
    order.done =
        fmt::format("anchor ball {}, anchor lights {}", ball ? "shown" : "down", lights ? "on" : "off");
    order.carried_out = [](const Picture&, const std::string&) { return true; };
    return order;
}

ServerOrder<AlertCommand> alert_order(const Alert& alert, AlertAction action) {
    ServerOrder<AlertCommand> order;
    order.sample.code(alert.code());
    order.sample.side(alert.side());
    order.sample.action(action);
    order.done =
        fmt::format("{} {}", alert.code().c_str(), action == ALERT_ACKNOWLEDGE ? "acknowledged" : "silenced");
    order.carried_out = [alert, action](const Picture& now, const std::string&) {
        const auto found = std::ranges::find_if(now.alerts, [&](const Alert& one) {
            return one.code() == alert.code() && one.side() == alert.side();
        });
        if (found == now.alerts.end()) return true; // back to normal
        if (action == ALERT_SILENCE) return found->condition() != ALERT_ACTIVE_UNACKNOWLEDGED;
        return found->condition() == ALERT_ACTIVE_ACKNOWLEDGED;
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
        return now.truth && (!fault || fault->phase() == FAULT_PHASE_CLEARED);
    };
    return order;
}

} // namespace windlass::console
