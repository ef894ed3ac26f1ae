#pragma once
// What is plotted: one row a curve.

#include "idl/types.hpp"

#include <span>
#include <string_view>

namespace windlass::debrief {

/// Curves with one plot share its axes.
template <class From>
struct Curve {
    std::string_view plot; ///< title of the plot that it belongs to
    std::string_view name; ///< in the plot's key
    std::string_view unit; ///< of what `of` gives
    double (*of)(const From& sample);
    bool ghost = false; ///< a ghost's is drawn behind it
};

/// Places of rows that are looked for by others than the plots.
enum WindlassCurve {
    kTension,
    kGypsyLoad,
    kBrakeCapacity,
    kCableSpeed,
    kCableOut,
    kCounter,
    kLining,
    kDrum,
    kBrake,
    kLever,
    kClutch,
    kStopper
};
enum ShipCurve { kSpeedOverGround };
enum WeatherCurve { kWind, kWaves, kSwell };

std::span<const Curve<WindlassLoad>> windlass_curves();
std::span<const Curve<ShipState>> ship_curves();
std::span<const Curve<EnvironmentState>> weather_curves();

} // namespace windlass::debrief
