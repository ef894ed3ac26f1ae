#include "server/physics/sea/environment.hpp"

namespace windlass::physics {

template <class Visitor, StateOf<EnvironmentDef> State>
void visit_state(Visitor& v, State& environment) {
    // Suction, profile and ground are the definition's: nothing changes them.
    auto& [depth, level, water_density, soil, bed_stiffness, bed_friction, bed_suction, wind_speed, wind_from,
           current_speed, current_towards, current_profile, ground] = environment;
    WINDLASS_STATE(v, depth, level, water_density, soil, bed_stiffness, bed_friction, wind_speed, wind_from,
                   current_speed, current_towards);
}
WINDLASS_STATE_LISTED(EnvironmentDef);

} // namespace windlass::physics
