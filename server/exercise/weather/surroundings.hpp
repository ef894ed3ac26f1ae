#pragma once
// What is about the ship in a tick: the weather and where it is going, tide, sea and gusts, and what of all
// this the model is given.

#include "server/exercise/weather/weather.hpp"
#include "server/physics/sea/gusts.hpp"

namespace windlass::exercise {

class Surroundings {
public:
    /// environment: of the exercise; depth: m, of the level bed below its water.
    Surroundings(const physics::EnvironmentDef& environment, const Weather& weather,
                 std::vector<TideRow> tide, double depth);

    /// Another weather, whose sea comes up from none. The water stays at its level.
    void begin_anew(const Weather& weather, std::vector<TideRow> tide, double depth);
    /// The tide that runs, from the weather's level and stream on; none: no tide.
    void set_tide(std::vector<TideRow> tide) { tide_ = std::move(tide); }

    /// dt (s) on, to the time (s): weather, water, wind as it blows now, waves. Returns the speed at which
    /// the water rises, m/s.
    double advance(double dt, double time);

    /// ramp: s; 0: at once.
    void order(const Weather& weather, double ramp, double time);

    const physics::EnvironmentDef& environment() const {
        return environment_;
    } ///< as the model is given it now
    const WeatherInRamp& weather() const { return weather_; }
    const physics::SeaSurface& sea() const { return sea_; }
    /// s, of the longest waves that count; 0: none do.
    double wave_period() const;

    /// Throws physics::StateError where a state that was brought back has what never changes otherwise than
    /// the definition has it, or wind, stream and level as no order makes them.
    void hold_to(const physics::EnvironmentDef& defined, const physics::StateVisitor& v) const;

    template <class Visitor, physics::StateOf<Surroundings> Self>
    friend void visit_state(Visitor& v, Self& self);

private:
    void lay();

    physics::EnvironmentDef environment_;
    WeatherInRamp weather_;
    std::vector<TideRow> tide_; ///< as the definition has it, or none
    physics::SeaSurface sea_;
    physics::Gusts gusts_; ///< keeps nothing that the rest does not say
};

} // namespace windlass::exercise
