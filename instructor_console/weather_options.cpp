#include "instructor_console/weather_options.hpp"
#include "words/words.hpp"

#include <cmath>
#include <sstream>

namespace windlass::console {

namespace {

using words::units::degree;

std::optional<double> radians(const std::optional<double>& degrees) {
    return degrees ? std::optional{*degrees * degree} : std::nullopt;
}

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
    app.add_option("--wind-speed", wind_speed, "m/s, mean over ten minutes at 10 m: 0 to 60");
    // Typed in degrees, refused in degrees: the server knows radians only.
    const auto in_degrees = [&app](const char* name, std::optional<double>& value, const char* about) {
        app.add_option(name, value, about)->check(CLI::Range(-360.0, 360.0));
    };
    in_degrees("--wind-from", wind_from_deg, "degrees clockwise from north, where it blows from");
    app.add_option("--veering", veering_deg_min, "degrees a minute by which it goes on turning, clockwise")
        ->check(CLI::Range(-343.0, 343.0)); // 0.1 rad/s, quicker than any squall
    app.add_option("--gust-factor", gust_factor, "largest of 3 s over the mean; 1: none");
    app.add_option("--gust-period", gust_period, "s, of the spectrum's peak; 0: the model's own");
    app.add_option("--wave-height", wave_height, "m, significant, of the wind sea; 0: none");
    app.add_option("--wave-period", wave_period, "s, of the spectrum's peak");
    in_degrees("--wave-from", wave_from_deg, "degrees, where they come from");
    app.add_option(
           "--fetch", fetch,
           "m of open water to windward: waves that belong to it and to the wind, but for what of them "
           "is given")
        ->check(CLI::Range(100.0, 1e7));
    app.add_option("--swell-height", swell_height, "m, significant; 0: none");
    app.add_option("--swell-period", swell_period, "s, of the spectrum's peak");
    in_degrees("--swell-from", swell_from_deg, "degrees, where it comes from");
    app.add_option("--wave-seed", wave_seed, "of the waves' phases");
    app.add_option("--current-speed", current_speed, "m/s, 0 to 5");
    in_degrees("--current-towards", current_towards_deg, "degrees clockwise from north, where it flows");
    app.add_option("--current-profile", current_profile,
                   "DEPTH:SHARE[:TURN],... in m, share of the speed, degrees clockwise; none: the same at "
                   "every depth")
        ->check([](const std::string& text) {
            return current_profile_in(text) ? "" : text + " is no list of DEPTH:SHARE[:TURN]";
        });
    app.add_option("--tide-height", tide_height, "m, of the water over the chart's datum");
    app.add_option("--visibility", visibility, "m");
    app.add_option("--time-of-day", time_of_day, "HH:MM, local time")->check([](const std::string& text) {
        return time_of_day_in(text) ? "" : text + " is no time of day, HH:MM";
    });
    app.require_option(1, 0);
    app.add_option("--ramp", ramp,
                   "s of exercise time in which it comes so; without it the rest of a ramp that "
                   "runs, or at once")
        ->check(CLI::NonNegativeNumber);
}

Environment WeatherOptions::environment() const {
    Environment wanted;
    wanted.wind_speed = wind_speed;
    wanted.wind_from = radians(wind_from_deg);
    wanted.gust_factor = gust_factor;
    wanted.gust_period = gust_period;
    if (veering_deg_min) wanted.veering = *veering_deg_min * degree / 60;
    wanted.wave_height = wave_height;
    wanted.wave_period = wave_period;
    wanted.wave_from = radians(wave_from_deg);
    wanted.fetch = fetch;
    wanted.swell_height = swell_height;
    wanted.swell_period = swell_period;
    wanted.swell_from = radians(swell_from_deg);
    wanted.wave_seed = wave_seed;
    wanted.current_speed = current_speed;
    wanted.current_towards = radians(current_towards_deg);
    if (!current_profile.empty()) wanted.current_profile = current_profile_in(current_profile);
    wanted.tide_height = tide_height;
    wanted.visibility = visibility;
    if (!time_of_day.empty()) wanted.time_of_day = time_of_day_in(time_of_day);
    wanted.ramp = ramp;
    return wanted;
}

} // namespace windlass::console
