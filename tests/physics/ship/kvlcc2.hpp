#pragma once
// KVLCC2 at full scale, as measured at a model: H. Yasukawa, Y. Yoshimura (2015), Introduction of MMG
// standard method for ship maneuvering predictions, J. Mar. Sci. Technol. 20, doi 10.1007/s00773-014-0293-y.

#include "server/physics/base/units.hpp"
#include "server/physics/ship/hull_force.hpp"

namespace windlass::physics {

inline ShipDef kvlcc2() {
    ShipDef ship;
    ship.length_overall = 333, ship.length_pp = 320, ship.beam = 58, ship.draught = 20.8;
    ship.displacement = 312600 * kSeaWaterDensity;
    return ship;
}

/// Linear derivatives and added masses, nondimensional as in HullCoefficients.
struct Kvlcc2Measured {
    static constexpr double m_x = 0.022, m_y = 0.223, j_z = 0.011;
    static constexpr double y_v = -0.315, y_r = 0.083, n_v = -0.137, n_r = -0.049;
    static constexpr double gravity = 11.2; ///< m, centre of gravity forward of midships
};

} // namespace windlass::physics
