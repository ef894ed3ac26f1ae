#include "server/physics/sea/environment.hpp"

namespace windlass::physics {

void visit_state(StateVisitor& v, EnvironmentDef& environment) {
    // Suction, profile and ground are the definition's: nothing changes them.
    auto& [depth, water_density, soil, bed_stiffness, bed_friction, bed_suction, wind_speed, wind_from,
           current_speed, current_towards, current_profile, ground] = environment;
    WINDLASS_STATE(v, depth, water_density, soil, bed_stiffness, bed_friction, wind_speed, wind_from,
                   current_speed, current_towards);
}

} // namespace windlass::physics
