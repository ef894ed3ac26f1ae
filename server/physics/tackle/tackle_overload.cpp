// What overload makes of the cable: links that are weak, stretch and part, and both ends after that.

#include "server/physics/tackle/ground_tackle.hpp"

#include "server/physics/chain/shackle_marks.hpp"

#include <algorithm>

namespace windlass::physics {

/// What the instructor weakens is found when the fault comes up, and is that link from then on.
void GroundTackle::weaken_links(const EquipmentFaults& causes) {
    const double lip = new_length(setup_.chain, chain_, windlass_.state().cable_out);
    const auto weaken = [](double share, double place, double& at, LinkCondition& link) {
        if (share == 0)
            at = -1;
        else if (at < 0)
            at = place;
        link = {.begins = at, .ends = at, .defect = share};
    };
    LinkCondition* link = &*(condition_.end() - kWeakened);
    // Of a length or a shackle that this cable has not, the last one stands for it.
    const int shackles = joining_shackles(setup_.chain);
    const double weak = causes.weak_length == 0
                            ? lip
                            : (std::clamp(causes.weak_length, 1, shackles + 1) - 0.5) * kShackleLength;
    const double open =
        causes.open_shackle == 0
            ? joining_shackle_within(setup_.chain, lip)
            : shackle_mark(setup_.chain, std::clamp(causes.open_shackle, 1, std::max(1, shackles)))
                  .from_anchor;
    weaken(causes.link_weak, std::min(weak, setup_.chain.length), strain_.weak_at, link[0]);
    weaken(causes.shackle_open, open, strain_.open_at, link[1]);
}

void GroundTackle::strain_cable(const EquipmentFaults& causes, const DeckResult& deck, EnergyLedger* ledger) {
    weaken_links(causes);
    const Strained strained =
        strain_links(setup_.chain, condition_, setup_.windlass.hawse_pipe_length, chain_, strain_);
    windlass_.lengthen(strained.longer);
    if (ledger != nullptr) ledger->stretching += strained.work;
    const bool parts = strained.parting.link >= 0 || windlass_.state().chain_gone;
    if (chain_.parted < 0 && parts) part(strained.parting, deck, ledger);
}

void GroundTackle::part(const Parting& parting, const DeckResult& deck, EnergyLedger* ledger) {
    const bool run_out = windlass_.state().chain_gone;
    const double out = windlass_.state().cable_out;
    strain_.parted_by = run_out ? out : parting.tension;
    const double stored = link_energy(setup_.chain, chain_, run_out ? chain_.links - 1 : parting.link,
                                      setup_.windlass.hawse_pipe_length);
    // What ran with the chain stands once the end has passed.
    const double running = run_out ? 0.5 * running_mass() * deck.speed * deck.speed : 0;
    if (ledger != nullptr) ledger->parting += stored + running;
    chain_.parted = run_out ? chain_.links - 1 : parting.link;
    chain_.set_tension(chain_.parted, 0);
    chain_.asleep = 0;
    const bool end_in_pipe = chain_.parted == chain_.links - 1;
    // The bare end can be hove in as far as the lip; an end in the pipe stays there.
    const double last_node =
        stretched_length(setup_.chain, chain_, (chain_.parted + 1) * setup_.chain.node_spacing);
    const double home = end_in_pipe ? out : std::min(out, last_node + 0.5 * setup_.chain.node_spacing);
    windlass_.limit({home, end_in_pipe ? out - setup_.windlass.locker_lift : bitter_end()});
}

} // namespace windlass::physics
