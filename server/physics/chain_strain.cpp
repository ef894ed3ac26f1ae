#include "server/physics/chain_strain.hpp"

#include "server/physics/lanes.hpp"

#include <algorithm>

namespace windlass::physics {

namespace {
/// Share of its length by which a link is longer when it breaks; tuned (bar of grade 3 steel: 17 % on the
/// test piece, IACS UR W18; a link gives less before it goes).
constexpr double kStretchAtBreak = 0.1;
} // namespace

double permanent_stretch(const ChainDef& def, double tension) {
    const double proof = proof_load(def);
    return kStretchAtBreak * std::max(0.0, (tension - proof) / (breaking_load(def) - proof));
}

Parting strain_links(const ChainDef& def, double weakness, const ChainState& chain, ChainStrain& strain) {
    const double worst = largest(&chain.tension[chain.asleep], chain.links - chain.asleep);
    if (worst > strain.worst) {
        strain.worst = worst;
        strain.stretch = permanent_stretch(def, worst);
    }
    const double breaking = breaking_load(def);
    if (worst > breaking) {
        const auto first = chain.tension.begin();
        const auto at = std::max_element(first + chain.asleep, first + chain.links);
        return {static_cast<int>(at - first), worst};
    }
    if (strain.weak_at < 0) return {};
    const int weak = std::min(static_cast<int>(strain.weak_at / def.node_spacing), chain.links - 1);
    const bool outboard = strain.weak_at <= chain_length(def, chain) && weak >= chain.asleep;
    if (outboard && chain.tension[weak] > (1 - weakness) * breaking) return {weak, chain.tension[weak]};
    return {};
}

} // namespace windlass::physics
