#include "recorder/debrief/curves.hpp"

#include "words/words.hpp"

#include <array>

namespace windlass::debrief {

namespace {

constexpr std::string_view kLoads = "Load on the cable";
constexpr std::string_view kSpeeds = "Speed of the cable, paying out positive";
constexpr std::string_view kLengths = "Cable out";
constexpr std::string_view kHeat = "Brake temperature";
constexpr std::string_view kLevers = "Levers";
constexpr std::string_view kShip = "Ship's speed over the ground";
constexpr std::string_view kWindPlot = "Wind";
constexpr std::string_view kSea = "Height of the waves, significant";

using Load = WindlassLoad;
constexpr std::array<Curve<Load>, 12> kWindlass{
    {{kLoads, "tension at the hawse pipe lip", "t",
      [](const Load& l) { return l.hawse_tension() / words::units::tonne; }, true},
     {kLoads, "pull at the gypsy", "t", [](const Load& l) { return l.gypsy_load() / words::units::tonne; }},
     {kLoads, "what the brake could hold", "t",
      [](const Load& l) { return l.brake_capacity() / words::units::tonne; }},
     {kSpeeds, "speed at the gypsy", "m/min",
      [](const Load& l) { return l.cable_speed() / words::units::metre_a_minute; }, true},
     {kLengths, "true", "m", [](const Load& l) { return l.cable_out(); }, true},
     {kLengths, "by the counter", "m", [](const Load& l) { return l.cable_out_indicated(); }},
     {kHeat, "lining", "\u00b0C",
      [](const Load& l) { return l.lining_temperature() - words::limits::ice_point; }},
     {kHeat, "drum", "\u00b0C",
      [](const Load& l) { return l.drum_temperature() - words::limits::ice_point; }},
     {kLevers, "brake wheel, 1 hard on", "", [](const Load& l) { return l.brake_position(); }, true},
     {kLevers, "speed lever, 1 full heave", "", [](const Load& l) { return l.speed_lever(); }, true},
     {kLevers, "clutch in", "", [](const Load& l) { return l.clutch() == CLUTCH_IN ? 1.0 : 0.0; }, true},
     {kLevers, "stopper on", "", [](const Load& l) { return l.stopper_closed() ? 1.0 : 0.0; }, true}}};

constexpr std::array<Curve<ShipState>, 1> kShipCurves{
    {{kShip, "speed", "kn", [](const ShipState& s) { return s.speed_over_ground() / words::units::knot; },
      true}}};

using Air = EnvironmentState;
constexpr std::array<Curve<Air>, 3> kWeather{
    {{kWindPlot, "mean", "kn", [](const Air& e) { return e.now().wind_speed() / words::units::knot; }},
     {kSea, "wind sea", "m", [](const Air& e) { return e.now().wave_height(); }},
     {kSea, "swell", "m", [](const Air& e) { return e.now().swell_height(); }}}};

} // namespace

std::span<const Curve<WindlassLoad>> windlass_curves() {
    return kWindlass;
}
std::span<const Curve<ShipState>> ship_curves() {
    return kShipCurves;
}
std::span<const Curve<EnvironmentState>> weather_curves() {
    return kWeather;
}

} // namespace windlass::debrief
