#pragma once
// The options of "environment": weather as people give it.

#include "instructor_console/orders.hpp"

#include <CLI/CLI.hpp>

namespace windlass::console {

/// As typed: degrees, HH:MM and the rest as it is told in --help.
struct WeatherOptions {
    std::optional<double> wind_speed, wind_from_deg, gust_factor, gust_period, veering_deg_min;
    std::optional<double> wave_height, wave_period, wave_from_deg, fetch;
    std::optional<double> swell_height, swell_period, swell_from_deg;
    std::optional<double> current_speed, current_towards_deg, tide_height, visibility, ramp;
    std::optional<std::uint32_t> wave_seed;
    std::string current_profile; ///< "DEPTH:SHARE[:TURN],..."; "none"
    std::string time_of_day;     ///< "HH:MM"

    void add_to(CLI::App& app);
    Environment environment() const;
};

/// "0:1,10:0.6:20": m of depth, share of the speed, degrees clockwise; "none": the same at every depth.
/// Nothing when the text is of no such form.
std::optional<std::vector<CurrentLayer>> current_profile_in(const std::string& text);

/// s since midnight of "HH:MM"; nothing when the text is none.
std::optional<double> time_of_day_in(const std::string& text);

} // namespace windlass::console
