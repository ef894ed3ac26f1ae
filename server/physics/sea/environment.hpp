#pragma once
// Sea, seabed and wind of an exercise.
// World frame everywhere: x east, y north, z up, metres, z = 0 at the chart's datum: the bed and what lies on
// it stay, the surface comes and goes with the tide. Without one it is at z = 0.

#include "server/physics/base/state_visitor.hpp"
#include "server/physics/base/units.hpp"
#include "server/physics/base/vec3.hpp"
#include "server/physics/sea/soil.hpp"

#include <cmath>
#include <memory>
#include <vector>

namespace windlass::physics {

class Ground;

/// The current at a depth, beside the one that is named: so that an order for more current moves the whole.
struct CurrentLayer {
    double depth = 0; ///< m below the surface
    double share = 1; ///< of the current's speed
    double turn = 0;  ///< rad clockwise, from where the current flows to
};

/// Everything outside the ship. Plain values with working defaults.
struct EnvironmentDef {
    double depth = 25;                         ///< m, of the level bed, below the world's origin
    double level = 0;                          ///< m, of the still water's surface over it: the tide's height
    double water_density = kSeaWaterDensity;   ///< kg/m3; 0 takes the water away (tests in air)
    Soil soil = Soil::sand;                    ///< under the anchor; lay_bed() gives the chain its bed, too
    double bed_stiffness = 1.0e5;              ///< as in ChainBed, all three
    double bed_friction = 0.75;                ///< -
    double bed_suction = 0;                    ///< -
    double wind_speed = 8;                     ///< m/s
    double wind_from = 0;                      ///< rad clockwise from north, where it blows from
    double current_speed = 0.3;                ///< m/s
    double current_towards = std::numbers::pi; ///< rad clockwise from north, where it flows to
    std::vector<CurrentLayer> current_profile; ///< downwards, straight lines between; none: the same at every
                                               ///< depth, which costs least
    std::shared_ptr<const Ground> ground;      ///< what departs from a level bed of one soil; none: nothing
};
template <class Visitor, StateOf<EnvironmentDef> State>
void visit_state(Visitor& v, State& environment);

/// Makes the seabed of a soil, under anchor and chain.
inline void lay_bed(EnvironmentDef& environment, Soil soil) {
    const ChainBed& bed = chain_bed(soil);
    environment.soil = soil;
    environment.bed_stiffness = bed.stiffness;
    environment.bed_friction = bed.friction;
    environment.bed_suction = bed.suction;
}

/// Unit vector of a compass direction (rad clockwise from north) in the world frame.
inline Vec3 compass(double direction) {
    return {std::sin(direction), std::cos(direction), 0};
}

} // namespace windlass::physics
