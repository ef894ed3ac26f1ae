#include "server/physics/chain/chain_forces.hpp"

namespace windlass::physics {

double node_potential(const ChainDef& def, const EnvironmentDef& environment, const ChainState& state,
                      int i) {
    const double h = node_length(def, state, i);
    const double z = state.position.z[i];
    // Integral of submerged_share() from z upwards.
    double submerged_height = 0;
    if (z < -0.5 * h) {
        submerged_height = -z;
    } else if (z < 0.5 * h) {
        submerged_height = (0.5 * h - z) * (0.5 * h - z) / (2 * h);
    }
    return kGravity * h *
           (def.mass_per_metre * z + environment.water_density * def.displacement * submerged_height);
}

} // namespace windlass::physics
