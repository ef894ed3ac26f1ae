#pragma once
// The anchor: a rigid body that hangs in the chain's solve by its shackle, in water and soil.
//
// Anchor frame as in anchor_shape.hpp. World frame as everywhere: z up, metres.

#include "server/physics/anchor/anchor_body.hpp"
#include "server/physics/anchor/bight.hpp"
#include "server/physics/anchor/flukes.hpp"
#include "server/physics/anchor/holding.hpp"
#include "server/physics/anchor/hull_touches.hpp"
#include "server/physics/base/box_separation.hpp"
#include "server/physics/base/equipment_faults.hpp"
#include "server/physics/solver/chain_solver.hpp"

#include <algorithm>

namespace windlass::physics {

/// A box of the anchor in the world.
struct AnchorBox : Box {
    bool fluke = false;
};

/// How the cable pulls at the shackle, as the soil under the anchor feels it.
struct ShacklePull {
    double uplift = 0; ///< rad, above the bed
    double lift = 0;   ///< N, off the bed
};

/// A step is taken in three calls: begin() moves the body under its own forces and Bullet's contacts and says
/// how its shackle yields with the soil holding the body, the chain solves, finish() takes the chain's answer
/// back and lets the soil act.
class Anchor {
public:
    /// extra_mass: kg of chain (half of the last link) that the anchor carries.
    Anchor(const AnchorDef& def, double extra_mass, const EnvironmentDef& environment,
           const AnchorPose& pose);

    /// Weight, buoyancy, drag and soil for a step, with the cable leading at the given angle (rad) above the
    /// seabed. hull: what of the ship it may lie against; may be null. Returns the shackle as the lower end
    /// of the chain.
    ChainTail begin(const EnvironmentDef& environment, const StepTime& time, const ShacklePull& pull,
                    const EquipmentFaults& causes, const HullSurface* hull = nullptr);

    /// shackle_velocity: m/s, what the chain's solve made of it. Books into the ledger (may be null). Returns
    /// its motion as contacts met it, before its flukes came to a stop.
    Vector7 finish(const EnvironmentDef& environment, const StepTime& time, const Vec3& shackle_velocity,
                   EnergyLedger* ledger);

    /// The body in the step under way, for what presses on it between begin() and finish().
    AnchorEnd end() const { return {step_.before, free_motion(), step_.yielding, step_.arm}; }
    /// Between begin() and finish(): what lies against it has changed its motion so.
    /// tension: N, largest of those of its own links that touch it.
    void push(const Vector7& change, double tension = 0);

    /// Its boxes as they lie now.
    int boxes() const { return static_cast<int>(shape_.parts.size()); }
    AnchorBox box(int k) const;
    double reach() const { return reach_; } ///< m, farthest that any box reaches from the centre of mass
    Vector6 motion() const { return body_.motion(); }
    double fastest() const; ///< m/s, that no point of it exceeds
    /// A point of it (m, world), of its flukes or of the rest.
    AnchorPoint point(const Vec3& at, bool fluke) const;
    /// Whether a push there (direction, world) only presses the flukes on one of their stops or on the bed.
    bool stopped(const EnvironmentDef& environment, const AnchorPoint& point, const Vec3& push) const {
        return flukes_.stopped(point.lever.dot(push), around_flukes(environment));
    }

    AnchorPose pose() const { return body_.pose(); }
    void set_pose(const AnchorPose& pose) { body_.set_pose(pose); }
    /// At rest, with its shackle at the given point, m.
    void hang(const Vec3& shackle, const Eigen::Quaterniond& attitude);
    /// The same, leaning as far as its flukes, which stay as they stand, make it lean.
    void hang_at_rest(const Vec3& shackle, const Eigen::Quaterniond& attitude,
                      const EnvironmentDef& environment);
    void set_motion(const Vector6& motion) { body_.set_motion(motion); }
    const HoldingState& holding() const { return holding_; }
    void set_holding(const HoldingState& holding) { holding_ = holding; }
    double fluke_angle() const { return flukes_.angle(); } ///< rad, from the shank's plane
    void turn_flukes(double angle) { flukes_.turn_to(angle); }
    double fluke_rate() const { return flukes_.rate(); }   ///< rad/s
    Vec3 pin() const { return body_.place(shape_.crown); } ///< m, world, of the flukes
    Vec3 fluke_axis() const;                               ///< unit vector, world, that the flukes turn about
    Vec3 flukes() const; ///< unit vector, world, from their pin to their tips
    /// What the ship did to it in the last step (N s, and N m s about the world's origin).
    const ContactLoad& hull_load() const { return hull_load_; }
    /// 0 clear .. 1: how foul it is: of an old cable that hangs on its flukes, or of turns of cable over it.
    double foul() const { return std::max(holding_.fouled, wound() ? bight_.share : 0); }
    /// Whether turns of cable over it take of the pull that should come on its shackle.
    bool wound() const { return bight_.share > kFoul; }
    /// N, level, that the ground can give now, under a cable that leads at the given angle (rad) above it.
    double holding_power(const EnvironmentDef& environment, const ShacklePull& pull) const;
    /// N, along the bed, of all its weight on the bed and none of it dug in.
    double bed_friction(const EnvironmentDef& environment) const;
    /// N, beyond its weight, that pulls it straight up out of the soil now.
    double breakout(const EnvironmentDef& environment) const;
    Soil soil(const EnvironmentDef& environment) const; ///< under the crown
    /// N, downwards at the crown: soil and cables that it carries when it is clear of the bottom.
    double load(const EnvironmentDef& environment) const;

    /// Whether at the start of the last step it was near enough to touch ship or bottom before a long step
    /// ends.
    bool may_touch() const { return may_touch_; }
    bool touches_left_out() const { return touches_.full(); }  ///< of the hull, in the last step
    Vec3 shackle() const;                                      ///< m, world
    Vec3 shackle_velocity() const;                             ///< m/s, world
    double clearance(const EnvironmentDef& environment) const; ///< m, lowest point above the seabed
    double soil_force() const { return soil_force_; }          ///< N, along the bed, of the last step
    double mass() const;                                       ///< kg, with what it carries and added mass
    double weight(const EnvironmentDef& environment) const;    ///< N, less buoyancy
    /// J: kinetic (with added mass) and potential (zero at the water surface).
    double kinetic_energy() const;
    double potential_energy(const EnvironmentDef& environment) const;

    /// All that one step leaves to the next, Bullet's contacts with the bottom included.
    template <class Visitor, StateOf<Anchor> Self>
    friend void visit_state(Visitor& v, Self& self);

private:
    double submerged(const EnvironmentDef& environment) const; ///< 0..1
    bool touches(const EnvironmentDef& environment) const;
    bool clear_of_bed(const EnvironmentDef& environment, double dt) const;
    /// Added mass comes and goes with submersion; the momentum stays, and water set in motion takes energy.
    void take_water_along(const EnvironmentDef& environment);
    /// Weight, buoyancy and drag for the step.
    void apply_gravity_and_drag(const EnvironmentDef& environment, const StepTime& time);
    /// All but what pushes them.
    FlukeSurroundings around_flukes(const EnvironmentDef& environment) const;
    void swing_flukes(const EnvironmentDef& environment, const StepTime& time);
    /// The ship's touches join the soil in how the body yields, with the flukes as a seventh of its motions.
    /// start: its motion at the start of the step.
    void lie_against_hull(const StepTime& time, const Vector7& start);
    /// The whole motion after the step, if nothing pulled or pushed.
    Vector7 free_motion() const;
    /// How the soil holds the body in a step; before it moves.
    void hold(const EnvironmentDef& environment, const StepTime& time);
    /// What is left of it along the bed under the crown.
    Vec3 along_bed(const Vec3& v) const { return v - v.dot(step_.bed) * step_.bed; }
    void catch_what_lies_there(const EquipmentFaults& causes);
    void bend(double along, double couple);

    /// What begin() finds of a step, for push() and finish().
    struct Step {
        ShacklePull pull;
        Vec3 arm = Vec3::Zero(), crown_arm = Vec3::Zero(); ///< m, from centre of mass, at the start
        Vec3 bed = Vec3::UnitZ();                          ///< normal of the bed under the crown
        Vec3 slides_before = Vec3::Zero();                 ///< m/s, of the crown along the bed, at the start
        Matrix6 soil = Matrix6::Zero(); ///< N s/m and so on: soil's resistance to a motion of the body
        double yaw_damping = 0;         ///< N m s, of it against turning
        FlukeSurroundings around_flukes;
        Vec3 position_before = Vec3::Zero(); ///< m
        Vector7 before = Vector7::Zero();    ///< motion at the start, Bullet's contacts included
        Vector6 soil_change =
            Vector6::Zero();                ///< of the motion, by soil and contacts if the chain did not pull
        double free_fluke_rate = 0;         ///< rad/s, after the step, if nothing pushed them
        double touching = 0;                ///< N, tension of cable that touches it
        Vector7 pushed = Vector7::Zero();   ///< of the motion, by cables and another anchor on it
        Matrix7 yielding = Matrix7::Zero(); ///< inverse mass, what soil and hull resist included
        SymmetricMatrix shackle_inverse_mass;      ///< 1/kg, of the shackle by itself, soil included
        Vec3 shackle_velocity_free = Vec3::Zero(); ///< m/s, if the chain did not pull
        Vec3 drag_force = Vec3::Zero();            ///< N, against the motion
        Vec3 drag_moment = Vec3::Zero();           ///< N m
        Vec3 turning_impulse = Vec3::Zero();       ///< N m s, of the water against turning
        double load = 0;                           ///< N
        bool on_bottom = false;
        double water_entry_loss = 0, contact_loss = 0; ///< J
    };

    const AnchorDef def_;
    const AnchorShape shape_;
    const double dry_mass_, displaced_mass_; ///< kg; the second at full submersion
    const double reach_;                     ///< m

    AnchorBody body_;
    Flukes flukes_;
    HoldingState holding_;
    BightState bight_;
    double soil_force_ = 0;
    Vec3 driven_ = Vec3::Zero(); ///< N, along the bed: all but the soil that moved the crown in the last step
    bool may_touch_ = false;
    double poor_soil_ = 0; ///< share of the soil's holding that a fault takes, as of the last step

    Step step_; ///< under way
    HullTouches touches_;
    ContactLoad hull_load_;
};

} // namespace windlass::physics
