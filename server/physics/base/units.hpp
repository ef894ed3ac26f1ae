#pragma once
// The one place where units are converted. Inside the physics everything is SI and radians.

#include <numbers>

namespace windlass::physics {

inline constexpr double kGravity = 9.80665;      ///< m/s2, standard gravity (ISO 80000-3)
inline constexpr double kSeaWaterDensity = 1025; ///< kg/m3
inline constexpr double kSteelDensity = 7850;    ///< kg/m3
inline constexpr double kAirDensity = 1.224;     ///< kg/m3, Isherwood (1972)
inline constexpr double kShackleLength = 27.5;   ///< m of cable in one shackle (ISO 1704)
inline constexpr double kMetresPerNauticalMile = 1852;
inline constexpr double kCelsiusZero = 273.15; ///< K

constexpr double shackles_from_metres(double metres) {
    return metres / kShackleLength;
}
constexpr double metres_from_shackles(double shackles) {
    return shackles * kShackleLength;
}
constexpr double knots_from_mps(double mps) {
    return mps * 3600 / kMetresPerNauticalMile;
}
constexpr double mps_from_knots(double knots) {
    return knots * kMetresPerNauticalMile / 3600;
}
constexpr double degrees_from_radians(double radians) {
    return radians * 180 / std::numbers::pi;
}
constexpr double radians_from_degrees(double degrees) {
    return degrees * std::numbers::pi / 180;
}
constexpr double celsius_from_kelvin(double kelvin) {
    return kelvin - kCelsiusZero;
}
constexpr double kelvin_from_celsius(double celsius) {
    return celsius + kCelsiusZero;
}

} // namespace windlass::physics
