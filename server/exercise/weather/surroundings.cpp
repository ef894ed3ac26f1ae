#include "server/exercise/weather/surroundings.hpp"

#include "server/exercise/weather/weather_table.hpp"
#include "server/physics/base/state_limits.hpp"

#include <algorithm>

namespace windlass::exercise {

using namespace physics;

namespace {

// m/s, of a state that is brought back: as of the files and orders, in the strongest gust
constexpr double kMaxWind = weather_row("wind_speed").high * 4, kMaxCurrent = 15;
constexpr double kMaxTide = 50; ///< m; of both what orders may ask for and a tide adds to it

/// m/s, at which the water rises and falls at most: twenty times the fastest tide's, and a Panamax's snubbed
/// cable takes it up without a swing.
constexpr double kFastestRise = 0.01;
constexpr double kWavesCount = 0.3; ///< m, significant: lower ones do nothing to a cable's pull

} // namespace

Surroundings::Surroundings(const EnvironmentDef& environment, const Weather& weather,
                           std::vector<TideRow> tide, double depth)
    : environment_(environment), weather_(weather), tide_(std::move(tide)), sea_(sea_of(weather), depth) {
    lay_weather(weather, environment_);
}

void Surroundings::begin_anew(const Weather& weather, std::vector<TideRow> tide, double depth) {
    weather_ = WeatherInRamp(weather);
    lay();
    tide_ = std::move(tide);
    sea_ = SeaSurface({}, depth);
    if (weather.wave_height > 0 || weather.swell_height > 0) sea_.order(sea_of(weather), 0, kSeaFade);
}

/// All of the weather but the water's level, which follows it at its own pace.
void Surroundings::lay() {
    const double level = environment_.level;
    lay_weather(weather_.now(), environment_);
    environment_.level = level;
}

double Surroundings::advance(double dt, double time) {
    if (!tide_.empty()) {
        const Tide now = tide_at(tide_, time), was = tide_at(tide_, time - dt);
        weather_.run_tide({now.height - was.height, now.stream - was.stream});
    }
    if (weather_.advance(dt) || !tide_.empty()) lay();
    const Weather& now = weather_.now();
    // The sea is wide: what is ordered at once comes at a pace that throws no ship.
    const double rise =
        std::clamp(now.tide_height - environment_.level, -kFastestRise * dt, kFastestRise * dt);
    environment_.level += rise;
    const WindNow wind =
        gusts_.wind({now.wind_speed, now.wind_from, now.gust_factor, now.gust_period, now.wave_seed}, time);
    environment_.wind_speed = wind.speed, environment_.wind_from = wind.from;
    sea_.advance(time);
    return rise / dt;
}

void Surroundings::order(const Weather& weather, double ramp, double time) {
    weather_.order(weather, ramp);
    lay();
    sea_.order(sea_of(weather), time, ramp);
}

double Surroundings::wave_period() const {
    const Weather& now = weather_.now();
    const double waves = now.wave_height >= kWavesCount ? now.wave_period : 0;
    return std::max(waves, now.swell_height >= kWavesCount ? now.swell_period : 0);
}

void Surroundings::hold_to(const EnvironmentDef& defined, const StateVisitor& v) const {
    const EnvironmentDef& environment = environment_; // by the name that the state has it under
    const auto same = [&](const char* name, double value, double was) { v.within({name}, value, was, was); };
    same("environment.depth", environment.depth, defined.depth);
    same("environment.water_density", environment.water_density, defined.water_density);
    same("environment.soil", static_cast<double>(environment.soil), static_cast<double>(defined.soil));
    same("environment.bed_stiffness", environment.bed_stiffness, defined.bed_stiffness);
    same("environment.bed_friction", environment.bed_friction, defined.bed_friction);
    v.within({"environment.wind_speed"}, environment.wind_speed, 0, kMaxWind);
    v.within({"environment.current_speed"}, environment.current_speed, 0, kMaxCurrent);
    v.within({"environment.level"}, environment.level, -kMaxTide, kMaxTide);
    WINDLASS_WITHIN(v, -kMostTurned, kMostTurned, environment.wind_from, environment.current_towards);
}

template <class Visitor, StateOf<Surroundings> Self>
void visit_state(Visitor& v, Self& self) {
    WINDLASS_STATE(v, self.environment_, self.weather_, self.sea_);
    if constexpr (Visitor::kRestores) // which no state has twice
        self.environment_.current_profile = self.weather_.now().current_profile;
}
WINDLASS_STATE_LISTED(Surroundings);

} // namespace windlass::exercise
