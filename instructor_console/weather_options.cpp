#include "instructor_console/weather_options.hpp"

#include "server/exercise/weather/weather.hpp"
#include "server/exercise/weather/weather_table.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace windlass::console {

namespace {

using words::units::degree;

std::optional<double> number_in(const std::string& text) {
    double value = 0;
    const bool whole = CLI::detail::lexical_cast(text, value) && std::isfinite(value);
    return whole ? std::optional(value) : std::nullopt;
}

} // namespace

std::optional<std::vector<CurrentLayer>> current_profile_in(const std::string& text) {
    std::vector<CurrentLayer> layers;
    if (text == "none") return layers;
    std::istringstream rows{text};
    for (std::string row; std::getline(rows, row, ',');) {
        std::vector<double> figures;
        std::istringstream parts{row};
        for (std::string part; std::getline(parts, part, ':');) {
            const auto number = number_in(part);
            if (!number) return std::nullopt;
            figures.push_back(*number);
        }
        if (figures.size() != 2 && figures.size() != 3) return std::nullopt;
        CurrentLayer layer;
        layer.depth(figures[0]);
        layer.share(figures[1]);
        layer.turn(figures.size() == 3 ? figures[2] * degree : 0);
        layers.push_back(layer);
    }
    return layers.empty() ? std::nullopt : std::optional(layers);
}

std::optional<double> time_of_day_in(const std::string& text) {
    const auto colon = text.find(':');
    if (colon == std::string::npos) return std::nullopt;
    const auto hours = number_in(text.substr(0, colon)), minutes = number_in(text.substr(colon + 1));
    const bool fits = hours && minutes && *hours >= 0 && *hours < 24 && *hours == std::floor(*hours) &&
                      *minutes >= 0 && *minutes < 60;
    return fits ? std::optional(*hours * 3600 + *minutes * 60) : std::nullopt;
}

void WeatherOptions::add_to(CLI::App& app) {
    for_each_field<exercise::Weather>([&](auto field) {
        using Figure = std::decay_t<decltype(field.of(std::declval<exercise::Weather&>()))>;
        if constexpr (std::is_arithmetic_v<Figure>) {
            constexpr exercise::WeatherRow kRow = exercise::weather_row(field.name);
            std::string option = "--" + std::string(field.name);
            std::ranges::replace(option, '_', '-');
            if constexpr (kRow.file_unit == "h") {
                app.add_option_function<std::string>(
                       option,
                       [this, name = field.name](const std::string& text) {
                           wanted.figures[name] = *time_of_day_in(text);
                       },
                       "HH:MM, local time")
                    ->check([](const std::string& text) {
                        return time_of_day_in(text) ? "" : text + " is no time of day, HH:MM";
                    });
            } else {
                // So slow a turn is typed by the minute.
                constexpr bool kByTheMinute = kRow.file_unit == "deg/s";
                constexpr double kTyped = kByTheMinute ? 60 : 1, kSi = kRow.si() / kTyped;
                const auto low = static_cast<Figure>(kRow.low * kTyped),
                           high = static_cast<Figure>(kRow.high * kTyped);
                const std::string about(kRow.about);
                app.add_option_function<Figure>(
                       option,
                       [this, name = field.name](Figure typed) { wanted.figures[name] = typed * kSi; },
                       kByTheMinute ? "deg a minute" + about.substr(kRow.file_unit.size()) : about)
                    ->check(CLI::Range(low, high));
            }
        }
    });
    app.add_option(
           "--fetch", wanted.fetch,
           "m of open water to windward: waves that belong to it and to the wind, but for what of them "
           "is given")
        ->check(CLI::Range(100.0, 1e7));
    app.add_option_function<std::string>(
           "--current-profile",
           [this](const std::string& text) { wanted.current_profile = current_profile_in(text); },
           "DEPTH:SHARE[:TURN],... in m, share of the speed, degrees clockwise; none: the same at every "
           "depth")
        ->check([](const std::string& text) {
            return current_profile_in(text) ? "" : text + " is no list of DEPTH:SHARE[:TURN]";
        });
    app.require_option(1, 0);
    app.add_option("--ramp", wanted.ramp,
                   "s of exercise time in which it comes so; without it the rest of a ramp that "
                   "runs, or at once")
        ->check(CLI::NonNegativeNumber);
}

} // namespace windlass::console
