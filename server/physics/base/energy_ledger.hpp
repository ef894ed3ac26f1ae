#pragma once
// The books of a cable's energy.

#include <array>

namespace windlass::physics {

/// Where the energy of a cable went. Sinks and sources in joules since the start; each is summed from force
/// times speed where it acts, so that the balance can fail.
struct EnergyLedger {
    double drag = 0;        ///< given to the water by chain
    double bed = 0;         ///< chain's friction and impact on the seabed
    double contact = 0;     ///< chain on itself, chain and anchor on the hull: friction, impact, springs
    double internal = 0;    ///< structural damping of the links
    double pick_up = 0;     ///< chain jerked from rest in the locker
    double hawse = 0;       ///< friction in the hawse pipe
    double brake = 0;       ///< band brake lining
    double stopper = 0;     ///< chain stopper rendering
    double shaft_brake = 0; ///< motor's own brake
    double pockets = 0;     ///< links jumping over worn pockets of the gypsy
    double jam = 0;      ///< jammed spurling pipe: chain dragged through, heap packed, what its spring holds
    double motor = 0;    ///< taken from the chain by the motor; negative when it lifts
    double gear = 0;     ///< friction of the motor's gear
    double end_stop = 0; ///< bitter end or anchor's seat
    double hull = 0;     ///< work done by the cable on the moving ship
    double anchor_drag = 0; ///< given to the water by the anchor
    double anchor_bed = 0;  ///< anchor's impact and friction on the seabed
    double soil = 0;        ///< resistance of the soil to the anchor's flukes
    double coupling = 0;    ///< motion of motor and gypsy when they are uncoupled from the chain or burst
    double stretching = 0;  ///< links beyond what they were proved to, which stay longer
    double parting = 0;     ///< stretch that a parted link lets go of, motion of the end that is gone
};

/// One account of a ledger.
struct LedgerEntry {
    const char* name;
    double joules;
};

/// Every account by its name. A field that is added above and not here does not compile.
inline auto entries(const EnergyLedger& ledger) {
    const auto& [drag, bed, contact, internal, pick_up, hawse, brake, stopper, shaft_brake, pockets, jam,
                 motor, gear, end_stop, hull, anchor_drag, anchor_bed, soil, coupling, stretching, parting] =
        ledger;
    return std::to_array<LedgerEntry>({{"chain in the water", drag},
                                       {"chain on the seabed", bed},
                                       {"chain on itself and on the hull", contact},
                                       {"damping in the links", internal},
                                       {"pick-up from the locker", pick_up},
                                       {"hawse pipe", hawse},
                                       {"band brake", brake},
                                       {"stopper", stopper},
                                       {"motor's own brake", shaft_brake},
                                       {"worn pockets", pockets},
                                       {"jammed spurling pipe", jam},
                                       {"motor", motor},
                                       {"gear", gear},
                                       {"anchor's seat and bitter end", end_stop},
                                       {"work on the ship", hull},
                                       {"anchor in the water", anchor_drag},
                                       {"anchor on the seabed", anchor_bed},
                                       {"soil", soil},
                                       {"uncoupling", coupling},
                                       {"stretching for good", stretching},
                                       {"parting", parting}});
}

/// What went in all, J.
inline double sum(const EnergyLedger& ledger) {
    double joules = 0;
    for (const LedgerEntry& entry : entries(ledger))
        joules += entry.joules;
    return joules;
}

} // namespace windlass::physics
