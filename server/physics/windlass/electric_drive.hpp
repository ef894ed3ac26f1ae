#pragma once
// Electric prime movers: fed by a converter (VFD), or by three windings for three speeds (pole-changing).
// Pulls in N at the gypsy's pitch line before the gear, speeds in m/s of chain, paying out positive.

#include "server/physics/windlass/drive_line.hpp"
#include "server/physics/windlass/windlass_def.hpp"

namespace windlass::physics {

/// Largest pull of the converter-fed motor at a speed: from stall to rated pull at the rated speed, and
/// constant power above it.
double vfd_limit(const WindlassDef& def, double speed);

/// The converter holds its target speed as long as that pull suffices. health: 0..1 of the pull.
MotorPull vfd_pull(const WindlassDef& def, double speed, double target, double health);

/// Which winding a lever position (-1..1) switches on, as a share of the top speed: a quarter up to a third
/// of the lever's way, half up to two thirds, full beyond. 0 at zero.
double pole_step(double lever);

/// Breakdown pull of a winding of the given synchronous speed, N: constant power above half the top speed.
double breakdown_pull(const WindlassDef& def, double synchronous);

/// Induction motor of a synchronous speed (the target): straight through it up to the breakdown pull; a
/// deep-bar rotor keeps that down to standstill; driven against its field, or beyond it, by Kloss's formula
/// T = 2 T_b / (s / s_b + s_b / s). health: 0..1 of the pull.
MotorPull pole_changing_pull(const WindlassDef& def, double speed, double target, double health);

} // namespace windlass::physics
