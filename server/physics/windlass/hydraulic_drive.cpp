#include "server/physics/windlass/hydraulic_drive.hpp"

#include <algorithm>
#include <numbers>

namespace windlass::physics {

double hydraulic_area(const WindlassDef& def) {
    return def.hydraulic_displacement * kGearRatio / (2 * std::numbers::pi * def.gypsy_radius);
}

double hydraulic_top_speed(const WindlassDef& def) {
    return def.hydraulic_pumps * def.hydraulic_pump_flow / hydraulic_area(def);
}

MotorPull hydraulic_pull(const WindlassDef& def, double target, const EquipmentFaults& causes) {
    const double area = hydraulic_area(def);
    const double pressure_left = (1 - causes.power_lost) * (1 - causes.hose_burst);
    const double relief = area * def.hydraulic_relief * (1 - causes.relief_low) * pressure_left;
    const double held =
        area * def.hydraulic_counterbalance * (1 - causes.counterbalance_open) * (1 - causes.hose_burst);
    const double slope = area * area / def.hydraulic_leakage; // N s/m: pressure for each m/s that leaks by
    const double fed = target * (1 - causes.pumps_lost);
    MotorPull pull;
    if (fed > 0) { // lowering: the pumps push with relief pressure, the counterbalance valve holds back
        pull.add(fed - relief / slope, -relief);
        pull.add(fed + held / slope, held);
        return pull;
    }
    // Heaving: from the pumps' flow up to relief pressure; then, once the chain runs back, the counterbalance
    // valve is shut and only leakage lets it by.
    pull.add(fed, 0);
    const double at_rest = -fed * slope;
    const double driven = std::min(relief, at_rest);
    pull.add(fed + driven / slope, driven);
    if (driven < at_rest) pull.add(0, driven);
    if (held > driven)
        pull.add((held - driven) / slope + (driven < at_rest ? 0 : fed + driven / slope), held);
    return pull;
}

} // namespace windlass::physics
