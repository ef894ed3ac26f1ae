#pragma once
// What loads do to a cable for good: beyond what it was proved to it stretches, and it parts at its weakest
// link. What a link bears is the certificate's strength less what wear, corrosion and defects have taken.

#include "server/physics/base/link_condition.hpp"
#include "server/physics/base/state_visitor.hpp"
#include "server/physics/chain/chain.hpp"

#include <span>

namespace windlass::physics {

/// What a cable has been through.
struct OverloadHistory {
    double worst = 0; ///< N, largest tension of any link so far, of its stretch alone
    double weak_at =
        -1; ///< m of new cable from the anchor shackle, link that the instructor weakened; -1: none
    double open_at = -1;  ///< the same of the joining shackle that opens
    double parted_by = 0; ///< N, tension that parted the cable; m of cable when its end ran out
};
template <class Visitor, StateOf<OverloadHistory> State>
void visit_state(Visitor& v, State& strain);

/// A link that has had too much; link -1: none.
struct Parting {
    int link = -1;
    double tension = 0; ///< N
};

/// What one step did to a cable for good.
struct Strained {
    Parting parting;
    double longer = 0; ///< m, by which the cable outboard has grown
    double work = 0;   ///< J, that went into it
};

/// Load at which sound chain with so much permanent stretch stretches on, N: the proof load when new, and
/// from there in a straight line to the breaking load at a tenth of its length. Tuned: bar of grade 3 steel
/// gives 17 % on the test piece (IACS UR W18), a link less before it goes.
double yield_load(const ChainDef& def, double stretch);

/// Looks at the tension (of the stretch alone) of every link that is awake after a step: the excess over what
/// it yields at becomes permanent stretch, and what is still above its strength parts. Nodes stay where they
/// are: a link that is longer pulls less. deck_length: as UpperEnd::deck_length().
Strained strain_links(const ChainDef& def, std::span<const LinkCondition> conditions, double deck_length,
                      ChainState& chain, OverloadHistory& strain);

} // namespace windlass::physics
