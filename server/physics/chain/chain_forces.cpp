#include "server/physics/chain/chain_forces.hpp"

namespace windlass::physics {

double node_potential(const ChainDef& def, const EnvironmentDef& environment, const ChainState& state,
                      int i) {
    const double h = node_length(def, state, i);
    const double z = state.position.z[i];
    // Integral of submerged_share() from z upwards.
    const double over_surface = z - environment.level;
    double submerged_height = 0;
    if (over_surface < -0.5 * h) {
        submerged_height = -over_surface;
    } else if (over_surface < 0.5 * h) {
        submerged_height = (0.5 * h - over_surface) * (0.5 * h - over_surface) / (2 * h);
    }
    return kGravity * h *
           (def.mass_per_metre * z + environment.water_density * def.displacement * submerged_height);
}

} // namespace windlass::physics
