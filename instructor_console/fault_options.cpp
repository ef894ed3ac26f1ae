#include "instructor_console/fault_options.hpp"

#include "station/names.hpp"
#include "words/words.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/fmt/ranges.h>

#include <algorithm>
#include <string>

namespace windlass::console {

namespace {

Trigger trigger_of(const FaultOptions& options) {
    constexpr double kKilo = 1000; // N in kN
    if (options.at_time) return {.what = TRIGGER_AT_TIME, .value = *options.at_time};
    if (options.at_cable_out) return {.what = TRIGGER_AT_CABLE_OUT, .value = *options.at_cable_out};
    if (options.at_cable_out_at_most)
        return {.what = TRIGGER_AT_CABLE_OUT_AT_MOST, .value = *options.at_cable_out_at_most};
    if (options.at_load_kn) return {.what = TRIGGER_AT_LOAD, .value = *options.at_load_kn * kKilo};
    if (options.at_load_at_most_kn)
        return {.what = TRIGGER_AT_LOAD_AT_MOST, .value = *options.at_load_at_most_kn * kKilo};
    if (options.at_event) return {.what = TRIGGER_AT_EVENT, .event = *options.at_event};
    if (options.at_order)
        return {.what = TRIGGER_AT_ORDER, .order = station::bridge_order_code(*options.at_order).value()};
    if (!options.between.empty())
        return {.what = TRIGGER_AT_CHANCE, .value = options.between.at(0), .until = options.between.at(1)};
    return {};
}

} // namespace

void FaultOptions::add_to(CLI::App& app) {
    app.add_option("code", code, "see the subcommand faults")->required()->check([](const std::string& text) {
        return station::fault_code(text) ? "" : text + " is no fault code; the subcommand faults lists them";
    });
    std::vector<CLI::Option*> raising{
        app.add_option("--severity", severity, "0 to 1; 1: the part does nothing at all")
            ->check(CLI::Range(0.0, 1.0))
            ->capture_default_str(),
        app.add_option("--ramp", ramp, "s from active to that severity")->check(CLI::NonNegativeNumber),
        app.add_option("--target", target,
                       "which of several, from 1: joining shackle, pump; 0: whichever the model takes")
            ->check(CLI::Range(0, 1000))};
    std::vector<CLI::Option*> triggers{
        app.add_option("--at", at_time, "s of exercise time")->check(CLI::NonNegativeNumber),
        app.add_option("--at-cable-out", at_cable_out, "m of cable out, or more")
            ->check(CLI::NonNegativeNumber),
        app.add_option("--at-cable-out-at-most", at_cable_out_at_most,
                       "m of cable out, or less: while heaving in, once there was more")
            ->check(CLI::NonNegativeNumber),
        app.add_option("--at-load", at_load_kn, "kN of load on the gypsy, or more")
            ->check(CLI::NonNegativeNumber),
        app.add_option("--at-load-at-most", at_load_at_most_kn,
                       "kN of load on the gypsy, or less, once there was more")
            ->check(CLI::NonNegativeNumber),
        app.add_option("--at-event", at_event, "CODE of an event of the exercise, e.g. anchor.on_bottom")
            ->check([](const std::string& text) {
                return std::ranges::count(words::kEventNames, text)
                           ? ""
                           : text + " is no event of the exercise; there are " +
                                 fmt::format("{}", fmt::join(words::kEventNames, ", "));
            }),
        app.add_option("--at-order", at_order, "CODE of an order of the bridge, e.g. let-go")
            ->check([](const std::string& text) {
                return station::bridge_order_code(text) ? "" : text + " is no order of the bridge";
            }),
        app.add_option("--between", between, "A B: s of exercise time, at a moment drawn by the server")
            ->expected(2)
            ->check(CLI::NonNegativeNumber)};
    auto* ends = app.add_flag("--clear", clear, "end the fault, armed or active");
    for (auto* option : raising)
        ends->excludes(option);
    for (std::size_t i = 0; i < triggers.size(); ++i) {
        ends->excludes(triggers[i]);
        for (std::size_t k = i + 1; k < triggers.size(); ++k)
            triggers[i]->excludes(triggers[k]);
    }
}

FaultOrder FaultOptions::order(int side) const {
    const FaultCode which = station::fault_code(code).value();
    if (clear) return clear_order(which, side);
    return fault_order(which, side, severity, trigger_of(*this), ramp, target);
}

} // namespace windlass::console
