#pragma once
// Lindahl's tank test (Chalmers, 1985): a chain whose top is driven round a vertical circle. Figures of the
// published series: top tension at most 72.7 +- 0.8 N, mean 26.45 N, 20.7 % of the time below 2 N; at
// rest 22.7 N.

#include "server/physics/chain/chain.hpp"

#include <cmath>
#include <numbers>

namespace windlass::physics::lindahl {

inline constexpr double kLength = 33, kDepth = 3, kPeriod = 1.25, kRadius = 0.2; ///< m, m, s, m
inline const Vec3 kFoot(0, 0, -kDepth), kTop(32.554, 0, 0.3);

inline ChainDef chain() {
    ChainDef def;
    def.diameter = 0.0022;
    def.mass_per_metre = 0.0818;
    def.stiffness = 1e4;
    def.damping_time = 0; // none is given for the tank's chain
    def.displacement = def.mass_per_metre / 7800;
    def.drag_normal = 2.5;
    def.drag_axial = 0.5;
    def.added_mass_normal = 0.01445 / (1000 * def.displacement);
    def.added_mass_axial = 0;
    def.contact_diameter = def.diameter;
    return def;
}

inline EnvironmentDef tank() {
    EnvironmentDef environment;
    environment.depth = kDepth;
    environment.water_density = 1000;
    environment.current_speed = 0;
    environment.wind_speed = 0;
    environment.bed_friction = 0.3;
    environment.bed_stiffness = 3e6; // stiff: the chain sinks in by a tenth of its diameter
    return environment;
}

/// Laid along the floor, then straight up to the top: to settle from. arc: m from the foot.
inline Vec3 laid_out(double arc) {
    const double lying = 20.56; // lying + hypot(32.554 - lying, 3.3) = 33
    const Vec3 touchdown(lying, 0, -kDepth);
    return arc < lying ? Vec3(arc, 0, -kDepth)
                       : Vec3(touchdown + (kTop - touchdown) * ((arc - lying) / (kLength - lying)));
}

/// Where the top is, t seconds after it began to turn; the circle grows in the first turn.
inline Vec3 top_at(double t) {
    const double turn = 2 * std::numbers::pi * t / kPeriod;
    const double grown =
        t < kPeriod ? (1 + std::sin(std::numbers::pi * t / kPeriod - 0.5 * std::numbers::pi)) / 2 : 1;
    return t < 0 ? kTop : Vec3(kTop + grown * kRadius * Vec3(std::cos(turn), 0, -std::sin(turn)));
}

} // namespace windlass::physics::lindahl
