#include "server/assess/quantity_words.hpp"

#include "common/figure_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace windlass::assess {

namespace {

/// The first of two figures that have one unit.
std::string bare_figure(double value, const std::string& unit) {
    const std::string text = figure_text(value, unit);
    return text.substr(0, text.find(' '));
}

/// A lever whose figure is a share of its travel, to either side of a rest.
struct LeverWords {
    std::string_view quantity, rest, back, ahead;
};
constexpr std::array kLeverWords{
    LeverWords{"speed_lever", "at zero", "lower", "heave"},
    LeverWords{"engine", "stopped", "astern", "ahead"},
};
constexpr double kAtRest = 0.05; // of its travel

const LeverWords* lever_words_of(const Quantity& quantity) {
    const auto* found = std::ranges::find(kLeverWords, quantity.name, &LeverWords::quantity);
    return found == kLeverWords.end() ? nullptr : found;
}

bool is_brake_wheel(const Quantity& quantity) {
    return std::string_view(quantity.name) == "brake_position";
}

std::string hundredth_parts(double share) {
    return std::to_string(std::lround(100 * std::abs(share))) + " %";
}

/// "at zero", "30 % heave".
std::string lever_at(const LeverWords& lever, double value) {
    if (std::abs(value) <= kAtRest) return std::string(lever.rest);
    return hundredth_parts(value) + ' ' + std::string(value < 0 ? lever.back : lever.ahead);
}

/// "speed lever at zero", "speed lever on heave", "engine between 4 % astern and 26 % ahead".
std::string lever_bounds(const std::string& lever_name, const LeverWords& lever, const Bounds& bounds) {
    const std::string name = lever_name + ' ';
    const double least = std::max(bounds.above, bounds.at_least), most = bounds.below;
    if (least > -kNoLimit && most < kNoLimit) {
        if (least >= -kAtRest && most <= kAtRest) return name + std::string(lever.rest);
        return name + "between " + lever_at(lever, least) + " and " + lever_at(lever, most);
    }
    if (least >= 0 && least <= kAtRest) return name + "on " + std::string(lever.ahead);
    if (most <= 0 && most >= -kAtRest) return name + "on " + std::string(lever.back);
    if (most > 0 && most <= kAtRest) return name + "not on " + std::string(lever.ahead);
    return name + (least > -kNoLimit ? "above " + lever_at(lever, least) : "below " + lever_at(lever, most));
}

/// "brake hard on", "brake eased", "brake open": what a mate calls it, the figure is the lesson's.
std::string brake_bounds(const Bounds& bounds) {
    // Of the wheel's travel, from which people call it so.
    constexpr double kCalledHardOn = 0.8, kCalledOpen = 0.25;
    const double least = std::max(bounds.above, bounds.at_least);
    if (least > -kNoLimit && bounds.below < kNoLimit)
        return "brake between " + hundredth_parts(least) + " and " + hundredth_parts(bounds.below) + " on";
    if (least > -kNoLimit)
        return least >= kCalledHardOn ? "brake hard on" : "brake above " + hundredth_parts(least);
    return bounds.below <= kCalledOpen ? "brake open" : "brake eased";
}

} // namespace

std::string short_name(const Quantity& quantity) {
    const std::string_view text = quantity.text;
    return std::string(text.substr(0, std::min(text.find(", "), text.find(" ("))));
}

std::string bounds_words(const Bounds& bounds) {
    const Quantity& quantity = quantity_at(bounds.quantity);
    const std::string unit = quantity.unit;
    if (unit == "yes") return bounds.below < kNoLimit ? quantity.not_so : short_name(quantity);
    if (is_brake_wheel(quantity)) return brake_bounds(bounds);
    if (const LeverWords* lever = lever_words_of(quantity))
        return lever_bounds(short_name(quantity), *lever, bounds);
    std::string text = unit.empty() ? quantity.text : short_name(quantity); // a scale wants its ends told
    if (bounds.above > -kNoLimit && bounds.below < kNoLimit)
        return text + " between " + bare_figure(bounds.above, unit) + " and " +
               figure_text(bounds.below, unit);
    if (bounds.at_least > -kNoLimit) text += " at least " + figure_text(bounds.at_least, unit);
    if (bounds.above > -kNoLimit) text += " above " + figure_text(bounds.above, unit);
    if (bounds.below < kNoLimit) text += " below " + figure_text(bounds.below, unit);
    return text;
}

std::string found_words(const Quantity& quantity, double value) {
    const std::string unit = quantity.unit;
    if (unit == "yes") return value > 0.5 ? short_name(quantity) : quantity.not_so;
    if (is_brake_wheel(quantity)) {
        constexpr double kRounded = 0.005;
        if (value < kRounded) return "brake was open";
        return value > 1 - kRounded ? "brake was hard on" : "brake was " + hundredth_parts(value) + " on";
    }
    if (const LeverWords* lever = lever_words_of(quantity))
        return short_name(quantity) + " was " + lever_at(*lever, value);
    return short_name(quantity) + " was " + figure_text(value, unit);
}

} // namespace windlass::assess
