#pragma once
// What a figure of the weather may be, and what it is: the one table, config/schema/exercise.schema.json.
// Files are held against it as they are read; names in files, the check of orders, the console's options and
// the limits of a state that is brought back are taken from it here.

#include "server/physics/base/units.hpp"

#include <array>
#include <string_view>

namespace windlass::exercise {

struct WeatherRow {
    std::string_view file_name; ///< "wind_from_deg"
    std::string_view file_unit; ///< "deg", "deg/s", "h" or one of SI; empty: none
    double low, high, usual;    ///< in that unit
    std::string_view about;     ///< one line for people, beginning with the unit

    /// Of the field of Weather.
    constexpr std::string_view name() const {
        for (const std::string_view unit : {"_deg", "_h"})
            if (file_name.ends_with(unit)) return file_name.substr(0, file_name.size() - unit.size());
        return file_name;
    }
    /// One of the file's unit, in the field's.
    constexpr double si() const {
        return file_unit.starts_with("deg") ? physics::radians_from_degrees(1) : file_unit == "h" ? 3600 : 1;
    }
    /// The field's unit.
    constexpr std::string_view unit() const {
        return file_unit == "deg"     ? "rad"
               : file_unit == "deg/s" ? "rad/s"
               : file_unit == "h"     ? "s"
                                      : file_unit;
    }
    /// A direction: it may be gone round either way.
    constexpr bool is_direction() const { return file_unit == "deg"; }
};

} // namespace windlass::exercise

#include "server/exercise/weather/weather_rows.hpp"

namespace windlass::exercise {

/// The row of a field of Weather. One that has none does not compile.
consteval WeatherRow weather_row(std::string_view name) {
    for (const WeatherRow& row : kWeatherRows)
        if (row.name() == name) return row;
    throw "exercise.schema.json has no figure of this name below \"environment\"";
}

} // namespace windlass::exercise
