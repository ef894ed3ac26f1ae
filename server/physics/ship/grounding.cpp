#include "server/physics/ship/grounding.hpp"

#include "server/physics/sea/ground.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::physics {

KeelAndGround keel_and_ground(const ShipDef& def, const EnvironmentDef& environment, const ShipState& state,
                              double dt) {
    constexpr int kPlaces = 5;
    constexpr double kFriction = 0.4, kWaterplane = 0.85; // the second of length times beam
    constexpr double kCreep = 1e-3;                       // m/s, below which friction fades
    KeelAndGround found;
    const double level_bed = environment.depth + environment.level; // m of water over it
    if (!environment.ground && level_bed > def.draught) {
        found.depth = level_bed;
        found.clearance = level_bed - def.draught;
        return found;
    }
    const Vec3 ahead = forward(state), abeam = starboard(state);
    const double share = kWaterplane * def.length_pp * def.beam / kPlaces; // m2
    const double heaviest = def.displacement * kGravity / kPlaces;         // N
    found.clearance = 1e300;
    for (int k = 0; k < kPlaces; ++k) {
        const double at = def.length_pp * (static_cast<double>(k) / (kPlaces - 1) - 0.5);
        const double x = state.x + at * ahead.x(), y = state.y + at * ahead.y();
        const double depth = environment.level - bed_height(environment, x, y), clear = depth - def.draught;
        found.depth += depth / kPlaces;
        found.clearance = std::min(found.clearance, clear);
        if (clear >= 0) continue;
        const double bears = std::min(kSeaWaterDensity * kGravity * share * -clear, heaviest);
        const double across = state.sway + at * state.yaw_rate;
        const double speed = std::hypot(state.surge, across);
        // Never more than stops what of her mass is there within the step.
        const double rub =
            std::min(kFriction * bears / std::max(speed, kCreep), def.displacement / kPlaces / dt);
        const Vec3 normal = bed_normal(environment, x, y), slope = bears / normal.z() * normal;
        const double side = slope.dot(abeam) - rub * across;
        found.bearing += bears;
        found.force += {slope.dot(ahead) - rub * state.surge, side, at * side};
    }
    return found;
}

} // namespace windlass::physics
