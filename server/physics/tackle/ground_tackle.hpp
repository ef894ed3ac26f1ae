#pragma once
// Ground tackle: one windlass with its cable and anchor, solved together.

#include "server/physics/anchor/anchor.hpp"
#include "server/physics/chain/cable_twist.hpp"
#include "server/physics/chain/overload_history.hpp"
#include "server/physics/lod/model_policy.hpp"
#include "server/physics/lod/quasi_static_cable.hpp"
#include "server/physics/lod/recent_load.hpp"
#include "server/physics/lod/sleep.hpp"
#include "server/physics/solver/step_counts.hpp"
#include "server/physics/tackle/chain_contacts.hpp"
#include "server/physics/windlass/windlass.hpp"

#include <optional>

namespace windlass::physics {

/// What a cable consists of and how it lies at the start.
struct TackleSetup {
    WindlassDef windlass;
    ChainDef chain;
    AnchorDef anchor;
    double cable_out = 5; ///< m, lip to anchor shackle; the anchor hangs below the lip
    bool clutch_in = false;
    bool stopper_closed = false;
    double brake = 1;         ///< 0..1, hand-wheel
    bool self_contact = true; ///< chain lies on itself; without, a heap has no height (closed forms, cost)
    std::vector<LinkCondition> condition = {}; ///< of the cable, where it is not as its certificate says
    std::optional<ModelError> budget = {}; ///< that the model may err to save work; none: nothing is saved
    std::optional<HawsePipe> pipe = {}; ///< that the anchor is hove home into; none: it stays below the lip
    Eigen::Quaterniond ship_attitude = Eigen::Quaterniond::Identity(); ///< ship's axes into the world's
    double anchor_turned = 0; ///< rad, of the hanging anchor about the plumb line, from fore and aft
    /// rad, of its flukes out of the shank's plane; to starboard positive, if not turned. None: as far as
    /// they go on the side away from the ship; without a pipe, and so without a ship, not at all.
    std::optional<double> flukes_turned = {};
};

/// One anchor with its cable and windlass.
class GroundTackle {
public:
    /// lip: hawse pipe lip, m, world. Throws std::invalid_argument when the cable does not fit.
    GroundTackle(const TackleSetup& setup, const EnvironmentDef& environment, const Vec3& lip);

    /// Puts the anchor aboard a ship that moves so: one in the pipe comes to lie on what bears it, and cable
    /// and anchor have the speed of the hull where they are. For the start, before any step.
    void start_aboard(const EnvironmentDef& environment, const HullSurface& hull);

    /// One substep of dt (s), in two halves, between which another cable that lies across this one may press
    /// on it. The lip moves to the given point (m, world). hull: what of the ship the chain may lie against;
    /// may be null. awake: no part of the cable may sleep or be left to the catenary. False when the step is
    /// done already (the cable lies quietly): then finish() is not called.
    bool begin(const EnvironmentDef& environment, double dt, const WindlassLevers& levers,
               const EquipmentFaults& causes, const Vec3& lip, const HullSurface* hull, bool awake = false);
    /// Ends sleep and the catenary: every node moves from here on.
    void wake();
    const CableInStep& in_step() const { return under_way_.cable; }
    StepTime step_time() const { return under_way_.time; }
    CableAfter after_step() const { return {&chain_, under_way_.anchor_after}; }
    /// pushed: change of the anchor's motion that the other cable and anchor made. left_out: there were more
    /// contacts with them than could be kept.
    void finish(const EnvironmentDef& environment, const EquipmentFaults& causes,
                const Vector7& pushed = Vector7::Zero(), bool left_out = false);

    /// Substeps that a tick of dt (s) needs at the present tension: transverse waves run at sqrt(T / mu), and
    /// a step must not carry them over more than half a link (stability needs less than a whole one).
    /// Where the most are too few they are counted as such.
    int substeps(double dt, int max);

    /// Ticks of dt (s) that one step may span: 1 without a budget. At 300 ticks a second the waves in links
    /// as long as a budget allows would be followed three times as finely as they need (see substeps()).
    int stride(double dt) const;

    /// Books energy from now on (tests; costs some ten per cent of the step).
    void keep_ledger() { ledger_kept_ = true; }
    const EnergyLedger& ledger() const { return ledger_; }
    /// J, that contact with another cable took from both.
    void book_contact(double work) { ledger_.contact += ledger_kept_ ? work : 0; }
    /// Kinetic, potential and elastic energy of cable, anchor and gypsy, J. Chain in the locker counts at its
    /// height below the given lip.
    double energy(const EnvironmentDef& environment) const;

    Vec3 pull_on_ship() const { return pull_on_ship_; } ///< N, world, at the lip, of the last substep
    /// What the hull did to chain and anchor in the last substep (N, and N m about the world's origin).
    const ContactLoad& hull_load() const { return hull_load_; }
    Vec3 cable_direction() const; ///< unit vector from the lip along the top link, world
    /// rad, of the lowest link above the seabed
    double uplift(const EnvironmentDef& environment) const;
    /// The same as the soil under the anchor feels it: how holding falls with uplift is known of cables that
    /// pull an anchor until it drags. One that pulls less than the anchor rubs hardly digs it out, wherever
    /// it leads.
    ShacklePull shackle_pull(const EnvironmentDef& environment) const;
    bool home() const; ///< whether the anchor is within 0.1 m of its seat in the hawse pipe
    /// Whether it is at the hawse, and not home: its shackle within two of its lengths of the lip.
    bool at_hawse() const;
    /// Whether its shank is in the pipe and its flukes point at the ship's side: so it does not come home.
    bool flukes_inboard() const;
    bool finite() const; ///< no NaN or infinity in the state

    ModelLevel level() const; ///< how the cable is computed now
    /// Estimated, of what the model does now; not estimated from when its anchor gives way to the cable that
    /// is hove in, or is foul of its own cable on the bottom, until it is home.
    ModelError error(const EnvironmentDef& environment) const;

    const TackleSetup& setup() const { return setup_; }
    const ChainState& chain() const { return chain_; }
    const Windlass& windlass() const { return windlass_; }
    const Anchor& anchor() const { return anchor_; }
    QuietState quiet() const { return quiet_ ? quiet_->state() : QuietState{}; }
    SleepState sleep() const { return sleep_ ? sleep_->state() : SleepState{}; }
    const OverloadHistory& strain() const { return strain_; }
    double turns() const { return twist_.turns; } ///< in the cable, clockwise as the ship turned
    /// rad, of each link against the next.
    double twist() const { return twist_per_link(setup_.chain, twist_.turns, windlass_.state().cable_out); }
    double bitter_end() const { return windlass_.limits().bitter_end; } ///< m, cable out when all has run out
    const ChainStepResult& last_step() const { return last_; }
    const StepCounts& step_counts() const { return counts_; } ///< since the start
    /// What the steps have cost since it was set up: the links that are awake and the contacts, each time
    /// that an iteration went over them. No part of the state.
    std::int64_t visits() const { return visits_; }
    /// The next step takes what is left of a tick, whatever its tension asks for; it is counted as such.
    void hurry();

    /// All that one step leaves to the next. Whoever brings a state back takes links as they are there.
    template <class Visitor, StateOf<GroundTackle> Self>
    friend void visit_state(Visitor& v, Self& self);

private:
    /// What the second half of a step takes over from the first.
    struct UnderWay {
        StepTime time;
        std::optional<DriveLine> drive;
        CableInStep cable;                      ///< as predicted
        AnchorEnd anchor;                       ///< yields nothing while it sleeps
        Vector7 anchor_after = Vector7::Zero(); ///< its motion
        Vec3 lip_before = Vec3::Zero();
        ContactSet* contacts = nullptr;
        bool awake = false;
        Vec3 lip = Vec3::Zero(); ///< m, and the ship's axes, at the end of the step
        Eigen::Quaterniond ship = Eigen::Quaterniond::Identity();
        double drawn_in = 0; ///< m, before it
    };
    static constexpr std::size_t kWeakened = 2; ///< links that the instructor weakens

    double up_the_pipe() const;
    double bend_in_pipe(const Eigen::Quaterniond& ship) const;
    Vec3 upper_end(double drawn_in) const;
    void draw_in(EnergyLedger* ledger);
    void start_in_pipe(const EnvironmentDef& environment);
    void settle_in_pipe(const EnvironmentDef& environment, const HullSurface& hull);
    void weaken_links(const EquipmentFaults& causes);
    void strain_cable(const EquipmentFaults& causes, const DeckResult& deck, EnergyLedger* ledger);
    void part(const Parting& parting, const DeckResult& deck, EnergyLedger* ledger);
    double running_mass() const;
    double stretch_on_gypsy() const;
    bool lie_quietly(const EnvironmentDef& environment, const EquipmentFaults& causes, double dt,
                     const DriveLine& drive, const Vec3& lip);
    AnchorAtRest anchor_at_rest(const EnvironmentDef& environment) const;
    void save_work(const EnvironmentDef& environment, double dt);
    bool count_step(bool left_out);

    const TackleSetup setup_;
    ChainState chain_;
    ChainSolver solver_;
    ChainContacts contacts_;
    ContactLoad hull_load_;
    Windlass windlass_;
    Anchor anchor_;
    UnderWay under_way_;
    ChainStepResult last_;
    StepCounts counts_;
    OverloadHistory strain_;
    CableTwistState twist_;
    std::vector<LinkCondition> condition_; ///< the cable's, and behind it what the causes do
    Vec3 pull_on_ship_ = Vec3::Zero();
    ModelError spacing_error_; ///< of cutting the cable into links
    RecentLoad recent_load_;
    /// Where the anchor comes to lie: it gave way while it was hove, or lay foul of its cable; not home yet.
    bool luck_decides_ = false;
    bool too_long_ = false; ///< the steps of this tick
    std::int64_t visits_ = 0;
    std::optional<Sleep> sleep_; ///< both, if there is a budget
    std::optional<QuasiStaticCable> quiet_;
    EnergyLedger ledger_;
    bool ledger_kept_ = false;
};

} // namespace windlass::physics
