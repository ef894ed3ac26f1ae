#include "server/physics/ship/wind.hpp"

#include "server/physics/base/units.hpp"

#include <cmath>
#include <numbers>

namespace windlass::physics {

PlanarForce wind_force(const ShipDef& ship, double speed, double angle) {
    const double off = std::abs(angle), cosine = std::cos(off), sine = std::sin(off);
    const double along = cosine > 0 ? ship.wind_ahead : ship.wind_astern;
    // Of both coefficients on the lateral area: how much less wind from the quarters counts.
    const double share = along * ship.frontal_windage / (ship.lateral_windage * ship.wind_across);
    const double twice = 2 * sine * cosine;
    const double less = 1 - 0.5 * ship.wind_crossing * (1 - share) * twice * twice;
    const double pressure = 0.5 * kAirDensity * speed * speed;
    // Wind from starboard pushes to port; a positive arm turns the bow the same way.
    const double leeward = angle >= 0 ? -1 : 1;
    const double side = pressure * ship.lateral_windage * ship.wind_across * sine / less;
    const double arm = ship.windage_lever - 0.18 * ship.length_overall * (off - 0.5 * std::numbers::pi);
    return {-pressure * ship.frontal_windage * along * cosine / less, leeward * side, leeward * side * arm};
}

} // namespace windlass::physics
