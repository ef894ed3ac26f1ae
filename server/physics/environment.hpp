#pragma once
// Sea, seabed and wind of an exercise.
// World frame everywhere: x east, y north, z up, metres, z = 0 at the still water surface.

#include "server/physics/units.hpp"

#include <Eigen/Core>

#include <cmath>
#include <vector>

namespace windlass::physics {

using Vec3 = Eigen::Vector3d;

/// What the seabed is made of; picks the holding coefficients of the anchor.
enum class Soil { mud, sand, clay, gravel, rock };

/// The current at a depth, beside the one that is named: so that an order for more current moves the whole.
struct CurrentLayer {
    double depth = 0; ///< m below the surface
    double share = 1; ///< of the current's speed
    double turn = 0;  ///< rad clockwise, from where the current flows to
};

/// Everything outside the ship. Plain values with working defaults.
struct EnvironmentDef {
    double depth = 25;                       ///< m, flat seabed at z = -depth
    double water_density = kSeaWaterDensity; ///< kg/m3; 0 takes the water away (tests in air)
    Soil soil = Soil::sand;
    double bed_stiffness =
        1.0e5; ///< N/m per m of chain and per m of chain width (OrcaFlex default 100 kN/m/m2)
    double bed_friction = 0.75;                ///< chain on the seabed, -; New Asian handout: lambda_c 0.75
    double wind_speed = 8;                     ///< m/s
    double wind_from = 0;                      ///< rad clockwise from north, where it blows from
    double current_speed = 0.3;                ///< m/s
    double current_towards = std::numbers::pi; ///< rad clockwise from north, where it flows to
    std::vector<CurrentLayer> current_profile; ///< downwards, straight lines between; none: the same at every
                                               ///< depth, which costs least
};

/// Unit vector of a compass direction (rad clockwise from north) in the world frame.
inline Vec3 compass(double direction) {
    return {std::sin(direction), std::cos(direction), 0};
}

} // namespace windlass::physics
