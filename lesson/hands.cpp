#include "lesson/hands.hpp"

#include "server/assess/marks.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace windlass::lesson {

namespace {

using trainee::Script;
using trainee::Step;

constexpr double kRepeats = 2; // s, after which hands repeat an order back

constexpr std::array kRows{
    HandRow{"idle", "does nothing and says nothing", Should::fail},
    HandRow{"repeats", "repeats every order back and does nothing", Should::fail},
    HandRow{"spams", "repeats orders, and cries every report over and over", Should::fail},
    HandRow{"refuses", "repeats every order back, calls it unsafe and does nothing", Should::fail},
    HandRow{"closes", "closes brake and stopper, gear out, before anything is ordered, and says so",
            Should::fail},
    HandRow{"silent", "does all as it should be done, and says nothing", Should::fail},
    HandRow{"wrong_repeats", "does all as it should be done, and repeats every order back wrongly",
            Should::fail},
    HandRow{"reports_first", "makes all its reports at the beginning and none later", Should::fail},
    HandRow{"cries", "does all right, and makes its reports early and often besides", Should::fail},
    HandRow{"tenth_over", "stops a tenth of a shackle too late each time", Should::pass},
    HandRow{"half_over", "stops half a shackle too late each time", Should::end},
    HandRow{"one_over", "stops a shackle too late each time", Should::end},
    HandRow{"slams", "wide open or hard on, and nothing between", Should::end},
    HandRow{"keys", "works the wheel with keys, a twentieth of its way at a time", Should::end},
    HandRow{"patient", "takes three seconds more to begin with each order", Should::pass},
};

bool is_shackles(ReportCode code) {
    return code == REPORT_SHACKLES_ON_DECK || code == REPORT_SHACKLES_IN_WATER ||
           code == REPORT_SHACKLES_IN_PIPE;
}

Script empty_at(int side) {
    return {.title = {}, .side = side, .repeats_orders = {}, .steps = {}};
}

Step cry(double after, const trainee::ReportOrder& report) {
    Step step;
    step.when.after = after;
    step.report = report;
    step.timeout = 1e9;
    return step;
}

/// Every report, each with something in its fields.
std::vector<trainee::ReportOrder> every_report() {
    std::vector<trainee::ReportOrder> all;
    for (std::size_t k = 0; k < words::kReportNames.size(); ++k) {
        const auto code = static_cast<ReportCode>(k);
        if (code == REPORT_TEXT || code == REPORT_ORDER_REPEATED) continue;
        all.push_back({.code = code,
                       .value = 3,
                       .lead = 12,
                       .stay = STAY_GIVEN_MEDIUM,
                       .growing = GROWING_GROWING,
                       .weight = WEIGHT_MODERATE,
                       .side = {},
                       .order = {},
                       .text = {}});
    }
    return all;
}

/// The reports of a script, each code once.
std::vector<trainee::ReportOrder> own_reports(const Script& script) {
    std::vector<trainee::ReportOrder> all;
    std::set<ReportCode> seen;
    for (const Step& step : script.steps)
        if (step.report && seen.insert(step.report->code).second) all.push_back(*step.report);
    return all;
}

Script repeats(const Script& model) {
    Script script = empty_at(model.side);
    script.repeats_orders = kRepeats;
    return script;
}

Script spams(const Script& model) {
    constexpr double kEvery = 4; // s
    constexpr int kRounds = 12;
    Script script = repeats(model);
    for (int round = 0; round < kRounds; ++round)
        for (const trainee::ReportOrder& report : every_report())
            script.steps.push_back(cry(kEvery, report));
    return script;
}

/// Calls every order unsafe that is none of the bridge's questions, and proposes to secure.
Script refuses(const Script& model, const assess::Lesson& lesson) {
    Script script = repeats(model);
    script.follows_orders = true;
    for (const assess::LessonOrder& order : lesson.orders) {
        const bool his = order.given.side < 0 || order.given.side == model.side;
        if (!his || assess::repeat_within(order.given) <= 0) continue;
        Step step =
            cry(kRepeats + 1, {.code = REPORT_UNSAFE, .side = {}, .order = BRIDGE_ORDER_SECURE, .text = {}});
        step.when.ordered = static_cast<BridgeOrderCode>(order.given.code);
        if (order.given.value > 0) step.when.ordered_value = order.given.value;
        script.steps.push_back(step);
    }
    return script;
}

Script closes(const Script& model) {
    Script script = repeats(model);
    Step brake;
    brake.orders.brake = 1;
    brake.orders.speed_lever = 0;
    Step rest;
    rest.when.after = 3;
    rest.orders.stopper_closed = true;
    rest.orders.clutch_in = false;
    rest.timeout = 1e9;
    script.steps = {brake, rest, cry(4, {.code = REPORT_SECURED, .side = {}, .order = {}, .text = {}})};
    return script;
}

/// Without its words: on a bridge those are its orders.
Script silent(Script script) {
    script.repeats_orders.reset();
    for (Step& step : script.steps) {
        step.report.reset();
        step.order.reset();
    }
    return script;
}

Script wrong_repeats(Script script) {
    script.repeats_wrongly = true;
    return script;
}

Script reports_first(const Script& model) {
    Script script = silent(model);
    script.repeats_orders = model.repeats_orders;
    std::vector<Step> first;
    for (const Step& step : model.steps)
        if (step.report) first.push_back(cry(0.5, *step.report));
    script.steps.insert(script.steps.begin(), first.begin(), first.end());
    return script;
}

/// The second voice of one who cries everything that he is going to report, all of it at once at the
/// beginning and then over and over.
Script crier(const Script& model) {
    constexpr double kAtOnce = 0.5; // s
    constexpr double kEvery = 20;   // s
    constexpr int kRounds = 30;
    Script script = empty_at(model.side);
    const auto reports = own_reports(model);
    if (reports.empty()) return script;
    for (int round = 0; round < kRounds; ++round)
        for (const trainee::ReportOrder& report : reports)
            script.steps.push_back(
                cry(round == 0 ? kAtOnce : kEvery / static_cast<double>(reports.size()), report));
    return script;
}

void move_up(std::optional<double>& limit, double by) {
    if (limit) *limit += by;
}

/// Whose stops come `over` shackles late as cable goes out: the figures of the counter that he goes by are
/// moved, and he reports what the counter shows him. Where the first shackle is on its way he lets it be.
Script overshoots(Script script, double over) {
    constexpr double kFirst = 1.3; // shackles
    script.follows_orders = true;
    bool is_over = false; // since he last looked at the counter
    for (Step& step : script.steps) {
        for (trainee::Bounds& bounds : step.when.bounds) {
            const std::string name = bounds.quantity->name;
            const double unit = name == "counter_shackles" ? 1
                                : name == "counter"        ? words::units::shackle
                                                           : 0;
            if (unit == 0) continue;
            is_over = bounds.at_least.value_or(bounds.above.value_or(0)) >= kFirst * unit;
            if (!is_over) continue;
            move_up(bounds.at_least, over * unit);
            move_up(bounds.above, over * unit);
        }
        if (step.report && is_shackles(step.report->code) && is_over) step.report->value += over;
    }
    return script;
}

/// The wheel wide open where it was cracked open, hard on where it was on; never eased.
Script slams(Script script) {
    constexpr double kCracked = 0.7; // of the wheel; below this cable runs
    double was = 1;
    for (Step& step : script.steps) {
        if (!step.orders.brake) continue;
        double& brake = *step.orders.brake;
        const bool eases = brake < kCracked && was < kCracked && brake > was;
        was = brake;
        if (eases)
            step.orders.brake.reset();
        else
            brake = brake < kCracked ? 0 : 1;
    }
    return script;
}

Script patient(Script script) {
    return later(std::move(script), 3);
}

bool same(const Script& a, const Script& b) {
    if (a.steps.size() != b.steps.size()) return false;
    for (std::size_t k = 0; k < a.steps.size(); ++k) {
        const Step &x = a.steps[k], &y = b.steps[k];
        if (x.when.after != y.when.after || x.orders.brake != y.orders.brake ||
            x.when.bounds.size() != y.when.bounds.size())
            return false;
        for (std::size_t i = 0; i < x.when.bounds.size(); ++i)
            if (x.when.bounds[i].at_least != y.when.bounds[i].at_least ||
                x.when.bounds[i].above != y.when.bounds[i].above)
                return false;
    }
    return true;
}

/// Whether keys make another course: they cannot set what lies between two of their steps.
bool finer_than_keys(const Script& script) {
    return std::ranges::any_of(script.steps, [](const Step& step) {
        const double steps = step.orders.brake.value_or(0) / kKeyStep;
        return std::abs(steps - std::round(steps)) > 1e-6;
    });
}

/// Whether the bridge expects an order of this lesson to be repeated back: a question is answered instead.
bool has_what_is_repeated(const assess::Lesson& lesson) {
    return std::ranges::any_of(lesson.orders, [](const assess::LessonOrder& order) {
        return assess::repeat_within(order.given) > 0;
    });
}

/// The parts of a hand, one for each script of the model run; nothing: he differs in nothing from it.
std::optional<std::vector<Part>> parts_of(std::string_view name, const assess::Lesson& lesson,
                                          const std::vector<Script>& model) {
    std::vector<Part> parts;
    bool differs = false;
    const auto each = [&](const auto& make) {
        for (const Script& script : model) {
            parts.push_back({.script = make(script)});
            differs = differs || !same(script, parts.back().script);
        }
    };
    if (name == "idle") return parts;
    if ((name == "wrong_repeats" || name == "refuses") && !has_what_is_repeated(lesson)) return std::nullopt;
    if (name == "repeats" || name == "spams" || name == "refuses" || name == "closes" || name == "silent" ||
        name == "wrong_repeats" || name == "reports_first") {
        each([&](const Script& script) {
            return name == "repeats"         ? repeats(script)
                   : name == "spams"         ? spams(script)
                   : name == "refuses"       ? refuses(script, lesson)
                   : name == "closes"        ? closes(script)
                   : name == "silent"        ? silent(script)
                   : name == "wrong_repeats" ? wrong_repeats(script)
                                             : reports_first(script);
        });
        return parts;
    }
    if (name == "cries") {
        for (const Script& script : model) {
            parts.push_back({.script = script});
            parts.push_back({.script = crier(script), .voice_only = true});
        }
        return parts;
    }
    if (name == "keys") {
        if (std::ranges::none_of(model, finer_than_keys)) return std::nullopt;
        for (const Script& script : model)
            parts.push_back({.script = script, .keys = true});
        return parts;
    }
    if (name == "slams")
        each(slams);
    else if (name == "patient")
        each(patient);
    else
        each([&](const Script& script) {
            return overshoots(script, name == "tenth_over" ? 0.1 : name == "half_over" ? 0.5 : 1.0);
        });
    return differs ? std::optional(std::move(parts)) : std::nullopt;
}

Should should_of(const std::string& name) {
    for (const Should should : {Should::fail, Should::pass})
        if (name == should_name(should)) return should;
    return Should::end;
}

/// The others differ in how they take the bridge's orders, which a trainee on the bridge gives himself.
bool is_for_a_bridge(std::string_view hand) {
    return hand == "idle" || hand == "silent";
}

} // namespace

const char* should_name(Should should) {
    switch (should) {
    case Should::fail:
        return "fail";
    case Should::pass:
        return "pass";
    case Should::end:
        break;
    }
    return "end";
}

std::span<const HandRow> hand_rows() {
    return kRows;
}

std::vector<Hand> hands(const assess::Lesson& lesson, const std::vector<Script>& model) {
    std::vector<Hand> all;
    for (const HandRow& row : kRows) {
        if (lesson.bridge_manned && !is_for_a_bridge(row.name)) continue;
        auto parts = parts_of(row.name, lesson, model);
        if (!parts) continue;
        Hand hand{.name = row.name, .about = row.about, .should = row.should, .parts = std::move(*parts)};
        for (const auto& [name, should] : lesson.hands)
            if (name == hand.name) hand.should = should_of(should);
        all.push_back(std::move(hand));
    }
    return all;
}

std::string fault_of(const Hand& hand, const Played& played) {
    const assess::Result& result = played.result;
    const std::string now = fmt::format("{}, {}.{} points", assess::outcome_name(result.outcome),
                                        result.tenths / 10, result.tenths % 10);
    if (hand.name == "idle" && result.tenths >= 10 * kIdleMost)
        return fmt::format("{}: nothing done gets below {}", now, kIdleMost);
    switch (hand.should) {
    case Should::fail:
        if (result.outcome == assess::Outcome::achieved || result.tenths > 10 * kWrongMost)
            return fmt::format("{}: wrong conduct is not achieved, and gets {} at most", now, kWrongMost);
        break;
    case Should::pass:
        if (result.outcome != assess::Outcome::achieved)
            return fmt::format("{}: right conduct is achieved", now);
        break;
    case Should::end:
        break;
    }
    return "";
}

} // namespace windlass::lesson
