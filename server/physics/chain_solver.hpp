#pragma once
// The direct solver of the chain: all taut links of a step at once, by Newton's method on a tridiagonal
// matrix.

#include "server/physics/chain.hpp"
#include "server/physics/chain_forces.hpp"
#include "server/physics/contact.hpp"

#include <Eigen/Core>

namespace windlass::physics {

/// How the tensions of three instants share the force of a step: T(n+1), T(n), T(n-1). Their sum is 1.
struct ForceWeights {
    double next = 0.25, now = 0.5, before = 0.25;
};

/// The lower end as the chain meets it in one step: a point with an inverse mass, moving freely unless
/// pulled.
struct ChainTail {
    SymmetricMatrix inverse_mass;        ///< 1/kg, of the point; zero for a fixed end
    Vec3 velocity = Vec3::Zero();        ///< m/s, after the step if the chain did not pull
    Vec3 velocity_before = Vec3::Zero(); ///< m/s, before it; for the energy balance
};

/// The top link as the windlass meets it: its mean pull in the step is a straight line in the travel, as long
/// as it is not slack.
struct TopLink {
    double dt = 0;            ///< s
    double pull = 0;          ///< N, if nothing is paid out in this step
    double yielding = 0;      ///< N/m, pull lost for each metre paid out
    double outboard_mass = 0; ///< kg, half of the top link: it moves with the gypsy
    double outboard_pull = 0; ///< N, weight of that half along the chain
};

/// What holds or moves the chain at the top.
class TopDrive {
public:
    virtual ~TopDrive() = default;
    /// Metres paid out in this step. Asked once for each Newton iteration; must not change anything.
    virtual double travel(const TopLink& link) = 0;
    /// m/s at which chain was paid out before the step; for the energy balance.
    virtual double speed_before() const { return 0; }
    /// m of chain between hawse pipe lip and gypsy, whose stretch the top link takes over.
    virtual double deck_length() const { return 0; }
};

/// A top that holds: bitter end made fast at the hawse pipe.
class LockedTop final : public TopDrive {
public:
    double travel(const TopLink& /*link*/) override { return 0; }
};

/// What one step came to.
struct ChainStepResult {
    Vec3 tail_impulse = Vec3::Zero();  ///< N s, of the chain on whatever hangs at its lower end
    Vec3 hawse_impulse = Vec3::Zero(); ///< N s, of the top link on the hawse pipe lip
    double travel = 0;                 ///< m paid out
    TopLink top;                       ///< as the drive saw it last
    double top_pull = 0;               ///< N, mean pull of the top link in the step
    int iterations = 0;
    bool converged = true;
};

/// Takes steps. Holds only memory to work in: everything that matters is in ChainState.
class ChainSolver {
public:
    /// capacity: most links. No memory is taken after this.
    ChainSolver(const ChainDef& def, int capacity, ForceWeights weights = {});

    /// One step of dt (s). hawse: where the lip is at its end (m, world). ledger: may be null. contacts: what
    /// the chain touches in this step, besides the flat bed; may be null.
    ChainStepResult step(ChainState& state, const EnvironmentDef& environment, double dt,
                         const ChainTail& tail, TopDrive& drive, const Vec3& hawse,
                         EnergyLedger* ledger = nullptr, ContactSet* contacts = nullptr);

private:
    void measure_links(const ChainState& state);
    void weigh_tensions(const ChainState& state);
    void predict(const ChainState& state, const EnvironmentDef& environment, double dt, const ChainTail& tail,
                 const Vec3& hawse);
    void predict_in_water(const ChainState& state, const EnvironmentDef& environment, double dt, int first,
                          int last, double length);
    void predict_in_air(const ChainState& state, double dt, int first, int last, double length);
    void predict_on_bed(const ChainState& state, const EnvironmentDef& environment, double dt);
    void spread_pulls(int links);
    void place_nodes(int links);
    void set_up_rows(const ChainState& state, bool first, const ChainStepResult& result);
    bool turn_folded_links(int links, bool all);
    double eliminate(const ChainState& state, double dt, TopDrive& drive, ChainStepResult& result);
    double end_tension(int i) const;
    void account(const ChainState& state, const EnvironmentDef& environment, double dt, const ChainTail& tail,
                 double feed_speed, double travel, EnergyLedger& ledger) const;
    void finish(ChainState& state, double dt, ChainStepResult& result);

    ChainDef def_;
    ForceWeights weights_;
    double dt2_ = 0;              ///< s2
    double damping_ = 0;          ///< structural damping time over dt
    double deck_length_ = 0;      ///< m
    Vec3 current_ = Vec3::Zero(); ///< m/s, of the water in this step
    bool steady_ = false;         ///< all links taut, none of them on its way to slack, in this iteration

    // Per link
    Field direction_;            ///< G
    Field unit_;                 ///< direction under the pulls of this iteration
    std::vector<double> length_; ///< m, at the start of the step
    std::vector<double> span_;   ///< m, under the pulls of this iteration
    std::vector<double> weight_; ///< weight of T(n+1) in the mean pull of the step
    std::vector<double> known_;  ///< N, part of the mean pull that earlier tensions would make up
    std::vector<double> pull_;   ///< N, mean pull in the step as far as iterated: what is solved for
    std::vector<double> diagonal_, lower_, upper_, change_; ///< Newton's matrix and right-hand side
    // Per node
    Field predicted_;             ///< p*, m
    Field placed_;                ///< m, under the pulls of this iteration
    Field up_, down_;             ///< W_i G_i and W_i G_(i-1)
    SymmetricField inverse_mass_; ///< W, 1/kg
};

} // namespace windlass::physics
