#pragma once
// What a wave does to a ship at rest: first-order motions and mean drift, in closed form.

#include "server/physics/ship/ship_def.hpp"

#include <complex>

namespace windlass::physics {

/// Motions per metre of amplitude. Where the surface amidships is a cos(psi), each is Re(value a e^(i psi)).
struct WaveResponse {
    std::complex<double> surge; ///< m, forward
    std::complex<double> sway;  ///< m, to port
    std::complex<double> heave; ///< m, up
    std::complex<double> roll;  ///< rad, starboard down
    std::complex<double> pitch; ///< rad, bow up
    double drift_surge = 0;     ///< root of N/m2, with its sign: forward, squared
    double drift_sway = 0;      ///< the same, to port
};

/// Of a wave of omega (rad/s) and wave number k (rad/m), that runs so many rad anticlockwise from ahead (0:
/// it follows her, pi: a head sea, pi / 2: from starboard).
///
/// Heave and pitch: J. J. Jensen, A. E. Mansour, A. S. Olsen (2004), Estimation of ship motions using
/// closed-form expressions, Ocean Engineering 31, 61-85, at no speed, with the water's motion taken at half
/// the draught. Of the vertical motion of a laden tanker's bow a panel code has more: in a head sea of 10,
/// 12, 14, 16 s by 44, 30, 16 and 11 %; 120 degrees off by up to 10 %; abeam by none to a quarter. Surge and
/// sway: hull and water move alike, in the mean over hull and draught. Roll: one degree of freedom under the
/// mean slope. Drift: curves laid through that panel code's figures, to a third of them.
WaveResponse wave_response(const ShipDef& def, double omega, double k, double depth, double towards);

/// s, of roll in still water: IMO, 2008 IS Code, 2.3.4.
double roll_period(const ShipDef& def);

} // namespace windlass::physics
