#include "instructor_console/bridge_options.hpp"

#include "station/names.hpp"

#include <cmath>

namespace windlass::console {

namespace {

double number_in(const std::string& text, const std::string& what) {
    double value = 0;
    if (!CLI::detail::lexical_cast(text, value) || !std::isfinite(value))
        throw CLI::ValidationError("order", text + " is not allowed: " + what);
    return value;
}

} // namespace

void BridgeOrderOptions::add_to(CLI::App& app) {
    app.add_option("code", code,
                   "stand-by, clear-away, walk-out, let-go, pay-out, veer, check, hold-on, "
                   "walk-back, gear-in, gear-out, heave, heave-to, stop-heaving, secure, how-much, "
                   "how-leading, how-growing, how-much-weight, brought-up, stand-clear, text, cancel")
        ->required()
        ->check([](const std::string& text) {
            return station::bridge_order_code(text) ? "" : text + " is no order of the bridge";
        });
    app.add_option(
        "value", value,
        "shackles in the pipe, m for walk-out, the words of text, the number of the order to cancel");
    app.add_option("--side", side, "windlass concerned")
        ->check(CLI::IsMember({"port", "starboard", "both"}))
        ->capture_default_str();
    app.add_option("--text", text, "said beside it");
    app.add_option("--repeat-within", repeat_within, "s until it is to be repeated back; 0: the order's own")
        ->check(CLI::NonNegativeNumber);
    app.add_option("--do-within", do_within, "s until it is to be done; 0: the order's own")
        ->check(CLI::NonNegativeNumber);
}

BridgeOrderWish BridgeOrderOptions::wish() const {
    BridgeOrderWish wish{.code = station::bridge_order_code(code).value(),
                         .side = side == "both"        ? -1
                                 : side == "starboard" ? SIDE_STARBOARD
                                                       : SIDE_PORT,
                         .text = text,
                         .repeat_within = repeat_within,
                         .do_within = do_within};
    const std::string unit{station::value_unit(wish.code)};
    if (wish.code == BRIDGE_ORDER_TEXT) {
        if (value.empty()) throw CLI::ValidationError("order", "text needs its words");
        wish.text = value;
    } else if (wish.code == BRIDGE_ORDER_CANCEL) {
        if (value.empty()) throw CLI::ValidationError("order", "cancel needs the number of an order");
        wish.cancels = static_cast<int>(number_in(value, "the number of an order"));
    } else if (!value.empty()) {
        if (unit.empty()) throw CLI::ValidationError("order", code + " takes no number");
        wish.value = number_in(value, "a number of " + unit);
    } else if (!station::value_may_be_left_out(wish.code)) {
        throw CLI::ValidationError("order", code + " needs a number of " + unit);
    }
    return wish;
}

void WatchOptions::add_to(CLI::App& app) {
    auto* ends = app.add_flag("--off", off, "keep no watch");
    auto* wide = app.add_option("--radius", radius, "m, 10 to 2000")->check(CLI::Range(10.0, 2000.0));
    auto* east = app.add_option("--x", x, "m east, of the centre; without it the ship's place now");
    auto* north = app.add_option("--y", y, "m north, of the centre");
    east->needs(north)->needs(wide);
    north->needs(east);
    ends->excludes(wide)->excludes(east)->excludes(north);
}

void SignalOptions::add_to(CLI::App& app) {
    auto* hoisted = app.add_flag("--ball", ball, "the anchor ball");
    auto* lit = app.add_flag("--lights", lights, "the anchor lights");
    app.add_flag("--none", none, "neither")->excludes(hoisted)->excludes(lit);
}

} // namespace windlass::console
