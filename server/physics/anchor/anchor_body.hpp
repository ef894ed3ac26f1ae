#pragma once
// The anchor's rigid body: its place, its motion, and Bullet's contacts with the bottom.

#include "server/physics/anchor/anchor_shape.hpp"
#include "server/physics/base/state_visitor.hpp"
#include "server/physics/contact/anchor_point.hpp"

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

/// Alone in a Bullet world with the bed. Contacts push, without friction; everything else is the caller's.
class AnchorBody {
public:
    AnchorBody(const AnchorShape& shape, double mass, const EnvironmentDef& environment);
    ~AnchorBody();
    AnchorBody(AnchorBody&&) noexcept;

    AnchorPose pose() const;
    Vec3 position() const;        ///< m, world, of the centre of mass
    Eigen::Matrix3d axes() const; ///< of the anchor frame, world
    void set_pose(const AnchorPose& pose);
    Vector6 motion() const;
    void set_motion(const Vector6& motion);
    double mass() const; ///< kg
    void set_mass(double kilograms);

    Vec3 arm(const Vec3& point) const;   ///< m, world, from the centre of mass to a point of the anchor frame
    Vec3 place(const Vec3& point) const; ///< m, world, of the same
    double clearance(const EnvironmentDef& environment) const; ///< m, of the nearest corner over the bed
    Matrix6 inertia() const; ///< kg and kg m2, world: what a motion is of momentum

    /// Contacts, then moves for dt (s). Contacts act on the motion at once. clear: nothing of it can meet the
    /// bed in this step, so that nothing is looked for.
    void step(double dt, bool clear);
    /// Adds to the motion, and moves for dt (s) by what was added.
    void add_motion(const Vector6& change, double dt);

    /// The body's place as Bullet holds it (a matrix), its mass with the water it carries, and the points at
    /// which it touched the bottom, whose impulses the next step starts from.
    template <class Visitor, StateOf<AnchorBody> Self>
    friend void visit_state(Visitor& v, Self& self);

private:
    struct World; // Bullet stays in the source file
    std::unique_ptr<World> world_;
};

} // namespace windlass::physics
