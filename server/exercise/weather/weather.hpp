#pragma once
// Everything outside the ship that may change while an exercise runs, and how it gets from one state to
// another.

#include "common/fields.hpp"
#include "server/exercise/weather/tide.hpp"
#include "server/physics/sea/environment.hpp"
#include "server/physics/sea/sea_surface.hpp"

#include <cstdint>
#include <numbers>
#include <vector>

namespace windlass::physics {

WINDLASS_FIELDS(CurrentLayer, depth, share, turn)

} // namespace windlass::physics

namespace windlass::exercise {

/// Names, units and meaning as in idl Weather; what each may be: weather_table.hpp.
struct Weather {
    double wind_speed = 8, wind_from = 0, gust_factor = 1, gust_period = 0, veering = 0;
    double wave_height = 0, wave_period = 6, wave_from = 0;
    double swell_height = 0, swell_period = 12, swell_from = 0;
    std::uint32_t wave_seed = 1;
    double current_speed = 0.3, current_towards = std::numbers::pi;
    std::vector<physics::CurrentLayer> current_profile{};
    double tide_height = 0, visibility = 20000, time_of_day = 12 * 3600;
};
WINDLASS_FIELDS(Weather, wind_speed, wind_from, gust_factor, gust_period, veering, wave_height, wave_period,
                wave_from, swell_height, swell_period, swell_from, wave_seed, current_speed, current_towards,
                current_profile, tide_height, visibility, time_of_day)
template <class Visitor, physics::StateOf<Weather> State>
void visit_state(Visitor& v, State& weather);

inline constexpr std::size_t kMaxCurrentLayers = 64;
inline constexpr double kDay = 86400; ///< s

/// s, of the spectrum's peak, below which a sea of a significant height (m) would break: its length in deep
/// water is 14 heights. 2 s at least of any waves; 0 of none.
double least_wave_period(double height);

/// Gives the model what it knows of the weather: mean wind, current, and the water's level. Gusts and the sea
/// it is given by themselves.
void lay_weather(const Weather& weather, physics::EnvironmentDef& environment);

/// The sea of a weather.
physics::SeaDef sea_of(const Weather& weather);

/// The weather that is, and the one that is coming. A ramp is a straight line in every value, the short way
/// round in every angle, and layer by layer in the current's profile. Meanwhile the clock goes on, a wind
/// that veers goes on veering and a tide goes on running: what was ordered is what holds at the time of the
/// order.
class WeatherInRamp {
public:
    explicit WeatherInRamp(const Weather& start) : now_(start), before_(start), after_(start) {}

    /// ramp: s; 0: at once.
    void order(const Weather& weather, double ramp);

    /// dt (s) on. Whether what the model knows may have changed.
    bool advance(double dt);

    /// The tide has risen and its stream changed by so much, whatever is ordered meanwhile.
    void run_tide(const Tide& change);

    const Weather& now() const { return now_; }
    const Weather& after() const { return after_; } ///< as now() where no ramp runs
    double left() const { return left_; }           ///< s of the ramp

    template <class Visitor, physics::StateOf<WeatherInRamp> Self>
    friend void visit_state(Visitor& v, Self& self);

private:
    Weather now_, before_, after_;
    double ramp_ = 0, left_ = 0; ///< s, of the whole ramp and of what is left of it
};

} // namespace windlass::exercise
