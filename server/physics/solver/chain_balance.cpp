#include "server/physics/solver/chain_balance.hpp"

#include "server/physics/chain/chain_forces.hpp"
#include "server/physics/sea/current.hpp"

#include <cassert>

namespace windlass::physics {

namespace {

double spring_energy(double stiffness, double stretch) {
    return 0.5 * stiffness * positive_part(stretch) * positive_part(stretch);
}

} // namespace

void balance_chain(const ChainDef& def, const EnvironmentDef& environment, const ChainState& state,
                   const ChainStepTaken& step, EnergyLedger& ledger) {
    assert(step.dt > 0 && "a step takes time");
    assert(state.links <= static_cast<int>(step.pull.size()) && "a pull for every link in use");
    const int n = state.links, foot = state.asleep;
    Vec3 below = step.placed.at(foot);
    Vec3 speed_below = 0.5 * (step.foot_velocity + (below - state.position.at(foot)) / step.dt);
    for (int i = foot; i < n; ++i) {
        const Vec3 above = step.placed.at(i + 1);
        const Vec3 v = (above - state.position.at(i + 1)) / step.dt;
        const Vec3 speed = 0.5 * (state.velocity.at(i + 1) + v);
        const bool top = i == n - 1;
        const double rest = link_length(def, state, i), now = rest + (top ? step.travel : 0),
                     deck = top ? step.deck_length : 0;
        // What the link took from its ends, less what it stores.
        const double stiffness = i == state.parted ? 0 : def.stiffness;
        double lengthening = (speed - speed_below).dot(step.direction.at(i)) - (top ? step.feed_speed : 0);
        double length = (above - below).norm();
        if (const LinkWraps::Wrap* wrap = step.wraps == nullptr ? nullptr : step.wraps->of(i)) {
            const Vec3 edge = wrap->edge.surface_velocity;
            lengthening = (speed - edge).dot(wrap->before.at_upper) -
                          (speed_below - edge).dot(wrap->before.at_lower) - (top ? step.feed_speed : 0);
            length = step.wraps->way_after(*wrap, below, above).length;
        }
        ledger.internal += step.pull[i] * lengthening * step.kick -
                           (spring_energy(stiffness / (now + deck), length - now) -
                            spring_energy(stiffness / (rest + deck), step.length[i] - rest));
        below = above;
        speed_below = speed;
        if (top) break;

        NodeMedium m = node_medium(def, environment, state, i + 1);
        const BedUnder under = bed_under(environment, state.position.at(i + 1));
        set_on_bed(def, under, m);
        const SlopingBed bed = sloping_bed(under);
        const NodeDamping damping = node_damping(def, environment, bed, m, state.velocity.at(i + 1),
                                                 current_at(environment, state.position.z[i + 1]));
        const Vec3 drag = along_and_across(v - damping.current, m.tangent, damping.normal, damping.axial);
        ledger.drag += step.kick * drag.dot(speed);
        NodeMedium after = m;
        set_on_bed(def, bed_under(environment, above), after);
        ledger.bed -= spring_energy(after.bed_stiffness, after.penetration) -
                      spring_energy(m.bed_stiffness, m.penetration);
        if (damping.bed_normal > 0) {
            const double support = bed_push(m, damping, bed.rise(state.velocity.at(i + 1)), step.dt) -
                                   bed_hold(damping, step.dt) * bed.rise(v);
            const Vec3 slide = v - bed.out(bed.rise(v));
            ledger.bed +=
                step.kick * (step.friction.at(i + 1).force(slide).dot(speed) - support * bed.rise(speed));
        }
    }
}

} // namespace windlass::physics
