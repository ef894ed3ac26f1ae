#pragma once
// The options of "environment": weather as people give it.

#include "instructor_console/orders.hpp"

#include <CLI/CLI.hpp>

namespace windlass::console {

/// An option for each figure of the weather, held to the same table as files and orders.
struct WeatherOptions {
    Environment wanted;

    void add_to(CLI::App& app);
};

/// "0:1,10:0.6:20": m of depth, share of the speed, degrees clockwise; "none": the same at every depth.
/// Nothing when the text is of no such form.
std::optional<std::vector<CurrentLayer>> current_profile_in(const std::string& text);

/// s since midnight of "HH:MM"; nothing when the text is none.
std::optional<double> time_of_day_in(const std::string& text);

} // namespace windlass::console
