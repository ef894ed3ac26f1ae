#pragma once
// Where the nodes of the chain would end a step if no link pulled.

#include "server/physics/chain/chain.hpp"
#include "server/physics/chain/chain_forces.hpp"
#include "server/physics/chain/step_time.hpp"

namespace windlass::physics {

/// The bed under each node within its reach, where it is not level; an array for each figure.
struct BedField {
    Field normal;
    std::vector<double> penetration, stiffness, friction, suction; ///< as in BedUnder

    explicit BedField(int nodes)
        : normal(nodes), penetration(nodes), stiffness(nodes), friction(nodes), suction(nodes) {}
    BedUnder at(int i) const { return {normal.at(i), penetration[i], stiffness[i], friction[i], suction[i]}; }
    void set(int i, const BedUnder& bed) {
        normal.set(i, bed.normal);
        penetration[i] = bed.penetration, stiffness[i] = bed.stiffness;
        friction[i] = bed.friction, suction[i] = bed.suction;
    }
};

/// What the nodes in use do by themselves, and how they yield to a pull: what it gives them of speed, a
/// newton for a second.
struct FreeMotion {
    Field place;                 ///< m, at the end of the step
    SymmetricField inverse_mass; ///< 1/kg, added mass and implicit resistances included

    Field current; ///< m/s, where it has a profile
    BedField bed;  ///< where it is not level
    bool level = true;
    int bed_first = 0, bed_last = -1; ///< nodes within reach of the seabed are among these
    FrictionField friction;           ///< of the seabed on these

    explicit FreeMotion(int nodes)
        : place(nodes), inverse_mass(nodes), current(nodes), bed(nodes), friction(nodes) {}
};

/// Fills motion for the nodes that are awake. tail: of the lowest of them; hawse: where the lip is at the
/// end, m.
void move_freely(const ChainDef& def, const EnvironmentDef& environment, const ChainState& state,
                 const StepTime& time, const ChainTail& tail, const Vec3& hawse, FreeMotion& motion);

} // namespace windlass::physics
