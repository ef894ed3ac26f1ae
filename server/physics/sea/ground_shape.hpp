#pragma once
// The ground as Bullet touches it: the very surface that the chain lies on, without triangles.
//
// A convex body with corners (boxes, hulls) touches it at its corners, and along its edges where the ground
// stands higher between two corners than at both: each with the ground's own normal below it. A mesh would
// have edges of its own to stumble over, and another surface than the chain's.

#include "server/physics/sea/ground.hpp"

#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionShapes/btConcaveShape.h>

#include <memory>

namespace windlass::physics {

/// The surface; endless, and solid below.
class GroundShape : public btConcaveShape {
public:
    GroundShape(std::shared_ptr<const Ground> ground, double depth);

    double height(double x, double y) const { return ground_->height(x, y) - depth_; } ///< m, world
    Vec3 normal(double x, double y) const { return ground_->normal(x, y); }

    void getAabb(const btTransform& t, btVector3& low, btVector3& high) const override;
    void processAllTriangles(btTriangleCallback*, const btVector3&, const btVector3&) const override {}
    void setLocalScaling(const btVector3&) override {}
    const btVector3& getLocalScaling() const override { return scaling_; }
    void calculateLocalInertia(btScalar, btVector3& inertia) const override { inertia.setZero(); }
    const char* getName() const override { return "Ground"; }

private:
    std::shared_ptr<const Ground> ground_;
    double depth_;
    btVector3 scaling_{1, 1, 1};
};

/// What an environment's bed is to Bullet: a plane where it is one.
std::unique_ptr<btCollisionShape> bed_shape(const EnvironmentDef& environment);

/// Teaches a dispatcher how convex bodies with corners touch a GroundShape.
void meet_ground(btCollisionDispatcher& dispatcher);

} // namespace windlass::physics
