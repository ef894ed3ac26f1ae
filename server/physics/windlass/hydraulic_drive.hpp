#pragma once
// Hydraulic prime mover: pumps, relief valve, motor with leakage, counterbalance valve.
// Pulls in N at the gypsy's pitch line before the gear, speeds in m/s of chain, paying out positive.

#include "server/physics/base/equipment_faults.hpp"
#include "server/physics/windlass/drive_line.hpp"
#include "server/physics/windlass/windlass_def.hpp"

namespace windlass::physics {

/// m3 of oil for each metre of chain; with a pressure it gives the pull.
double hydraulic_area(const WindlassDef& def);

/// Chain speed with all pumps at full lever and no load, m/s.
double hydraulic_top_speed(const WindlassDef& def);

/// Flow balance: the pumps' flow turns the motor or leaks past it, and what the relief valve does not let by
/// is the pressure. Heaving, chain that pulls harder than relief pressure is held by the counterbalance
/// valve, up to its own setting, but for the leakage; with that valve stuck open it drives the motor back.
/// Lowering, the same valve lets out what the pumps put in.
MotorPull hydraulic_pull(const WindlassDef& def, double target, const EquipmentFaults& causes);

} // namespace windlass::physics
