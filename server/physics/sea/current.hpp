#pragma once
// The current over depth.

#include "server/physics/sea/environment.hpp"

#include <span>

namespace windlass::physics {

/// m/s, world, of a current and its profile at a height over the surface (m). Between two layers of the
/// profile the velocity changes along a straight line; above the first and below the last it stays.
Vec3 current_at(double speed, double towards, std::span<const CurrentLayer> profile, double over_surface);
/// z: m, world.
Vec3 current_at(const EnvironmentDef& environment, double z);

/// m/s, world, mean from the surface down to the draught (m): what a hull feels.
Vec3 mean_current(const EnvironmentDef& environment, double draught);

} // namespace windlass::physics
