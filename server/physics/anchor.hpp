#pragma once
// The anchor: a Bullet rigid body that hangs in the chain's solve by its shackle.
//
// Anchor frame: origin at the centre of mass, x from the crown to the shackle, y along the crown, z out of
// the plane of the flukes. World frame as everywhere: z up, metres.

#include "server/physics/anchor_def.hpp"
#include "server/physics/chain_solver.hpp"
#include "server/physics/holding.hpp"
#include "server/physics/state_visitor.hpp"

#include <Eigen/Geometry>

#include <memory>

namespace windlass::physics {

/// Position and motion of the anchor; a plain value.
struct AnchorPose {
    Vec3 position = Vec3::Zero();                                 ///< m, centre of mass
    Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity(); ///< anchor axes into world axes
    Vec3 velocity = Vec3::Zero();                                 ///< m/s
    Vec3 spin = Vec3::Zero();                                     ///< rad/s, world
};

/// A step is taken in three calls: begin() moves the body under its own forces and Bullet's contacts and says
/// how its shackle yields, the chain solves, finish() takes the chain's answer back.
class Anchor {
public:
    /// extra_mass: kg of chain (half of the last link) that the anchor carries.
    Anchor(const AnchorDef& def, double extra_mass, const EnvironmentDef& environment,
           const AnchorPose& pose);
    ~Anchor();
    Anchor(Anchor&&) noexcept;

    /// Weight, buoyancy, drag and soil for a step, with the cable leading at the given angle (rad) above the
    /// seabed. Returns the shackle as the lower end of the chain.
    ChainTail begin(const EnvironmentDef& environment, const StepTime& time, double uplift);

    /// shackle_velocity: m/s, what the chain's solve made of it. Books into the ledger (may be null).
    void finish(const StepTime& time, double uplift, const Vec3& shackle_velocity, EnergyLedger* ledger);

    AnchorPose pose() const;
    void set_pose(const AnchorPose& pose);
    void rest(); ///< stops it where it is
    const HoldingState& holding() const { return holding_; }
    void set_holding(const HoldingState& holding) { holding_ = holding; }

    Vec3 shackle() const;                                      ///< m, world
    Vec3 shackle_velocity() const;                             ///< m/s, world
    double clearance(const EnvironmentDef& environment) const; ///< m, lowest point above the seabed
    double soil_force() const { return soil_force_; }          ///< N, horizontal, of the last step
    double mass() const;                                       ///< kg, with what it carries and added mass
    double weight(const EnvironmentDef& environment) const;    ///< N, less buoyancy
    /// J: kinetic (with added mass) and potential (zero at the water surface).
    double kinetic_energy() const;
    double potential_energy(const EnvironmentDef& environment) const;

    /// All that one step leaves to the next, Bullet's contacts with the bottom included.
    void visit_state(StateVisitor& v);

private:
    struct Body; // Bullet stays in the source file

    AnchorDef def_;
    HoldingState holding_;
    double soil_force_ = 0;
    // Of the step between begin() and finish():
    SymmetricMatrix shackle_mass_; ///< kg, effective mass of the shackle without soil
    Vec3 arm_ = Vec3::Zero();      ///< m, centre of mass to shackle at the start
    Vec3 shackle_velocity_before_ = Vec3::Zero(), velocity_before_ = Vec3::Zero(); ///< m/s, contacts included
    Vec3 free_velocity_ = Vec3::Zero(); ///< m/s, of the shackle, without soil and chain
    Vec3 drag_force_ = Vec3::Zero();    ///< N, against the motion
    bool on_bottom_ = false;
    double soil_damping_ = 0;                        ///< N s/m
    double water_entry_loss_ = 0, contact_loss_ = 0; ///< J
    std::unique_ptr<Body> body_;
};

} // namespace windlass::physics
