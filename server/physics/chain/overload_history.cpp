#include "server/physics/chain/overload_history.hpp"

#include "server/physics/base/state_limits.hpp"
#include "server/physics/base/vectorise.hpp"

#include <algorithm>

namespace windlass::physics {

namespace {

constexpr double kStretchAtBreak = 0.1; ///< see yield_load()

/// Shares of the certificate's loads that are left.
struct Strength {
    double section = 1; ///< of proof and breaking load
    double whole = 1;   ///< of the breaking load
};

Strength strength(const LinkCondition& c) {
    const double diameter = std::max(0.0, 1 - c.wear);
    return {diameter * diameter, diameter * diameter * (1 - c.defect)};
}

/// Of the weakest link in a piece of cable, m from the anchor shackle as it was new.
Strength strength_between(std::span<const LinkCondition> conditions, double from, double to) {
    Strength min;
    for (const LinkCondition& c : conditions) {
        if (c.begins >= to || (c.ends <= from && c.begins < from)) continue;
        const Strength here = strength(c);
        min = {std::min(min.section, here.section), std::min(min.whole, here.whole)};
    }
    return min;
}

/// N, below which nothing happens to any link.
double harmless(const ChainDef& def, std::span<const LinkCondition> conditions) {
    double load = proof_load(def);
    for (const LinkCondition& c : conditions) {
        const Strength here = strength(c);
        load = std::min({load, here.section * proof_load(def), here.whole * breaking_load(def)});
    }
    return load;
}

/// Makes a link of the model longer for good. The top link may reach into the next piece of the cable.
void lengthen(const ChainDef& def, int link, double metres, ChainState& chain) {
    double here = metres;
    const bool top = link == chain.links - 1;
    if (top && link + 1 < static_cast<int>(chain.stretch.size())) {
        here *= std::min(1.0, piece_length(def, chain, link) / chain.top_length);
        chain.stretch[link + 1] += (metres - here) / def.node_spacing;
    }
    chain.stretch[link] += here / def.node_spacing;
    chain.stretched = std::max(chain.stretched, link + (here < metres ? 2 : 1));
    if (top) chain.top_length += metres;
}

} // namespace

double yield_load(const ChainDef& def, double stretch) {
    return proof_load(def) + (breaking_load(def) - proof_load(def)) * stretch / kStretchAtBreak;
}

Strained strain_links(const ChainDef& def, std::span<const LinkCondition> conditions, double deck_length,
                      ChainState& chain, OverloadHistory& strain) {
    Strained strained;
    // What stretches a link is its stretch. The dashpot beside it stands for links that rub on each other; of
    // a stop at once its part has no bound as steps get shorter (1.9 to 4.5 MN from 300 to 4800 a second,
    // where the stretch alone makes 1.8 in all).
    const double worst = largest(&chain.elastic_tension[chain.asleep], chain.links - chain.asleep);
    strain.worst = std::max(strain.worst, worst);
    if (!(worst > harmless(def, conditions))) return strained;

    const double breaking = breaking_load(def), hardening = (breaking - proof_load(def)) / kStretchAtBreak;
    double excess = 0; // N, by which the most overloaded link is overloaded
    for (int i = chain.asleep; i < chain.links; ++i) {
        const bool top = i == chain.links - 1;
        const double from = i * def.node_spacing;
        // The link that lies in the lip belongs to the top one.
        const double to =
            top ? new_length(def, chain, chain_length(def, chain)) + kLinksInDiameters * def.diameter
                : from + def.node_spacing;
        const Strength bears = strength_between(conditions, from, to);
        const double over = chain.elastic_tension[i] - bears.section * yield_load(def, chain.stretch[i]);
        if (over > 0) {
            // It gives until what it bears by now and what is left of its pull meet.
            const double spring = def.stiffness / (link_length(def, chain, i) + (top ? deck_length : 0));
            const double longer = over / (spring + bears.section * hardening / def.node_spacing);
            const double stored = link_energy(def, chain, i, deck_length);
            lengthen(def, i, longer, chain);
            // As if it had been so long a step earlier, too: this is not a rate that damping goes by.
            for (std::vector<double>* tension : chain.tensions())
                (*tension)[i] = std::max(0.0, (*tension)[i] - spring * longer);
            strained.work += stored - link_energy(def, chain, i, deck_length);
            strained.longer += longer;
        }
        if (chain.elastic_tension[i] - bears.whole * breaking > excess) {
            excess = chain.elastic_tension[i] - bears.whole * breaking;
            strained.parting = {i, chain.elastic_tension[i]};
        }
    }
    return strained;
}

template <class Visitor, StateOf<OverloadHistory> State>
void visit_state(Visitor& v, State& strain) {
    auto& [worst, weak_at, open_at, parted_by] = strain;
    WINDLASS_STATE(v, worst, weak_at, open_at, parted_by);
    WINDLASS_WITHIN(v, 0, kStrongest, worst, parted_by);
    WINDLASS_WITHIN(v, -kFarthest, kFarthest, weak_at, open_at); // less than 0: at home, up the pipe
}
WINDLASS_STATE_LISTED(OverloadHistory);

} // namespace windlass::physics
