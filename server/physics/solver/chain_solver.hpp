#pragma once
// The direct solver of the chain: all taut links of a step at once, by Newton's method on a tridiagonal
// matrix.

#include "server/physics/base/line_matrix.hpp"
#include "server/physics/chain/chain.hpp"
#include "server/physics/chain/upper_end.hpp"
#include "server/physics/contact/contact.hpp"
#include "server/physics/solver/free_motion.hpp"
#include "server/physics/solver/implicit_step.hpp"

#include <Eigen/Core>

namespace windlass::physics {

/// What one step came to.
struct ChainStepResult {
    Vec3 tail_impulse = Vec3::Zero();  ///< N s, of the chain on whatever hangs at its lower end
    Vec3 hawse_impulse = Vec3::Zero(); ///< N s, of the top link on the hawse pipe lip
    double travel = 0;                 ///< m paid out
    TopLink top;                       ///< as the drive saw it last
    double top_pull = 0;               ///< N, mean pull of the top link in the step
    int iterations = 0;
    bool implicit = false; ///< the step was too long for its tension, or hard to solve: taken by ImplicitStep
    bool unsolved = false; ///< and that one did not come to rest either
    bool friction_given_up = false;  ///< sliding on the seabed was not found: friction in proportion to speed
    bool contacts_unsettled = false; ///< contacts were still coming and going when looking at them was ended
};

/// Takes steps. Holds only memory to work in: everything that matters is in ChainState.
class ChainSolver {
public:
    /// capacity: most links. No memory is taken after this.
    ChainSolver(const ChainDef& def, int capacity);

    /// The first half of a step of dt (s): where the nodes go by themselves. tail: of the lowest node that is
    /// awake; a sleeping chain holds it, then tail is not asked. hawse: where the lip is at the end of the
    /// step (m, world). Contacts with other cables may change what it returns, until solve().
    CableInStep predict(const ChainState& state, const EnvironmentDef& environment, double dt,
                        const ChainTail& tail, const UpperEnd& drive, const Vec3& hawse);
    /// The second half: what the links do about that. ledger: may be null. anchor: at the lower end, for
    /// contacts with it.
    ChainStepResult solve(ChainState& state, const EnvironmentDef& environment, UpperEnd& drive,
                          EnergyLedger* ledger = nullptr, ContactSet* contacts = nullptr,
                          const AnchorEnd* anchor = nullptr);

private:
    /// What was seen while the rows of an iteration were set up.
    struct Rows {
        bool all_taut = false;
        bool turned = false; ///< some link has turned so far that it may pull in vain along its direction
        double shortest = 0; ///< m, the shortest straight piece of chain, between a node and an edge
    };

    /// What the pulls are after an iteration.
    struct Pulls {
        bool steady = false;     ///< each on the same side of its history force as before
        bool push = false;       ///< some are below zero
        double change = 0;       ///< N, the largest
        bool too_strong = false; ///< transverse waves run too far in this step: with the directions of its
                                 ///< start it would not be stable
    };

    /// Length (as a fraction of the spacing) below which a link has no direction.
    static constexpr double kPoint = 1e-9;

    /// Structural damping of a step, as shares of what a link changed its length by: since the step before
    /// last, and of links whose pull counts whole (see measure_links) since the last.
    struct LinkDamping {
        double over_two_steps, over_this_step;
    };
    LinkDamping link_damping(double last) const;
    /// Damps link i by its stretch (m) now and a step earlier. Slack takes no damping.
    void damp(const LinkDamping& damping, int i, double stretch, double stretch_before) {
        const bool was_slack = inverse_weight_[i] == 1;
        damping_[i] = was_slack ? damping.over_this_step : damping.over_two_steps * inverse_weight_[i];
        damped_[i] = damping_[i] * positive_part(was_slack ? stretch : stretch_before);
    }
    void measure_links(const ChainState& state);
    void damp_links(const ChainState& state, double feed_speed);
    void spread_pulls(const ChainState& state);
    void shift_nodes(const ChainState& state, const Field& from, const std::vector<double>& pulls);
    Rows set_up_rows(const ChainState& state, double doubt, double travel);
    void set_up_wrapped(const ChainState& state, double doubt, double travel, Rows& rows);
    void lay_links_round_edges(const ChainState& state, double feed_speed, ContactSet& contacts);
    bool folded(int i, const Vec3& span, double length) const;
    bool turn_folded_links(const ChainState& state);
    void solve_directly(const ChainState& state, UpperEnd& drive, ContactSet* contacts,
                        ChainStepResult& result);
    bool revise(const ChainState& state, ContactSet* contacts);
    Pulls change_pulls(const ChainState& state, UpperEnd& drive, ChainStepResult& result);
    void solve_implicitly(const ChainState& state, UpperEnd& drive, ContactSet* contacts,
                          ChainStepResult& result);
    /// Tension of link i at the end of the step that goes with its mean pull, N. A pull below what earlier
    /// tensions would make up means that the link went slack on the way: chain lets go at once and does not
    /// push.
    double end_tension(int i) const {
        return positive_part(pull_[i] - history_force_[i]) * inverse_weight_[i];
    }
    void take_tensions(ChainState& state, double travel);

    const ChainDef def_;
    StepTime time_;
    double reach_ = 0;                  ///< s2, dt x kick: what a force over a mass becomes of way in a step
    double deck_length_ = 0;            ///< m
    int friction_revisions_ = 0;        ///< in this step
    Vec3 foot_velocity_ = Vec3::Zero(); ///< m/s, of the lowest node before the step

    // Per link
    Field direction_;                    ///< G
    std::vector<double> length_;         ///< m, at the start of the step
    std::vector<double> damping_;        ///< of the change of its length, what damping adds to its stretch
    std::vector<double> damped_;         ///< m, what of that goes for the length before
    std::vector<double> inverse_weight_; ///< inverse of the weight of T(n+1) in the mean pull of the step
    std::vector<double> history_force_;  ///< N, part of the mean pull that earlier tensions would make up
    std::vector<double> pull_;           ///< N, mean pull in the step as far as iterated: what is solved for
    std::vector<double> round_;          ///< m, by which its way round an edge is longer than straight
    LineMatrix matrix_;                  ///< Newton's
    LinkWraps* wraps_ = nullptr;         ///< links round edges in this step; null: none
    // Per node
    FreeMotion motion_;
    Field placed_;    ///< m, under the pulls of this iteration
    Field up_, down_; ///< W_i G_i and W_i G_(i-1)
    ImplicitStep implicit_;
};

} // namespace windlass::physics
