#include "server/physics/sea/ground_shape.hpp"

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btCollisionCreateFunc.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btPolyhedralConvexShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>

#include <cmath>

namespace windlass::physics {

namespace {

constexpr double kEdgeStep = 0.4; ///< m between the points at which an edge is looked at

/// A body's point over the ground, as far as it is to the ground along the normal, m.
struct Foot {
    Vec3 at, normal;
    double gap;
};

class GroundContact final : public btCollisionAlgorithm {
public:
    GroundContact(const btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* body,
                  const btCollisionObjectWrapper* ground)
        : btCollisionAlgorithm(info),
          manifold_(m_dispatcher->getNewManifold(body->getCollisionObject(), ground->getCollisionObject())) {}
    ~GroundContact() override { m_dispatcher->releaseManifold(manifold_); }
    GroundContact(const GroundContact&) = delete;
    GroundContact& operator=(const GroundContact&) = delete;

    void processCollision(const btCollisionObjectWrapper* one, const btCollisionObjectWrapper* other,
                          const btDispatcherInfo&, btManifoldResult* result) override {
        const bool swapped = one->getCollisionShape()->getShapeType() == CUSTOM_CONCAVE_SHAPE_TYPE;
        const btCollisionObjectWrapper &body = swapped ? *other : *one, &bed = swapped ? *one : *other;
        const auto& ground = *static_cast<const GroundShape*>(bed.getCollisionShape());
        const btTransform& place = body.getWorldTransform();
        result->setPersistentManifold(manifold_);
        const double reach = manifold_->getContactBreakingThreshold();
        const auto touch = [&](const Foot& foot) {
            if (foot.gap >= reach) return;
            const Vec3 on_bed = foot.at - foot.gap * foot.normal;
            result->addContactPoint({foot.normal.x(), foot.normal.y(), foot.normal.z()},
                                    {on_bed.x(), on_bed.y(), on_bed.z()}, foot.gap);
        };
        if (body.getCollisionShape()->getShapeType() == SPHERE_SHAPE_PROXYTYPE) {
            const auto& ball = *static_cast<const btSphereShape*>(body.getCollisionShape());
            Foot foot = foot_of(ground, place.getOrigin());
            foot.at -= ball.getRadius() * foot.normal;
            foot.gap -= ball.getRadius();
            touch(foot);
        } else {
            const auto& shape = *static_cast<const btPolyhedralConvexShape*>(body.getCollisionShape());
            for (int k = 0; k < shape.getNumVertices(); ++k) {
                btVector3 corner;
                shape.getVertex(k, corner);
                touch(foot_of(ground, place * corner));
            }
            for (int k = 0; k < shape.getNumEdges(); ++k) {
                btVector3 from, to;
                shape.getEdge(k, from, to);
                Foot deepest;
                if (stands_on(ground, place * from, place * to, deepest)) touch(deepest);
            }
        }
        result->refreshContactPoints();
    }
    btScalar calculateTimeOfImpact(btCollisionObject*, btCollisionObject*, const btDispatcherInfo&,
                                   btManifoldResult*) override {
        return 1;
    }
    void getAllContactManifolds(btManifoldArray& all) override { all.push_back(manifold_); }

private:
    static Foot foot_of(const GroundShape& ground, const btVector3& point) {
        const Vec3 at(point.x(), point.y(), point.z()), normal = ground.normal(at.x(), at.y());
        return {at, normal, (at.z() - ground.height(at.x(), at.y())) * normal.z()};
    }
    /// The deepest point between two corners, if it is deeper than both.
    static bool stands_on(const GroundShape& ground, const btVector3& from, const btVector3& to,
                          Foot& deepest) {
        const int pieces = static_cast<int>(std::ceil((to - from).length() / kEdgeStep));
        deepest = foot_of(ground, from);
        int at = 0;
        for (int k = 1; k <= pieces; ++k) {
            const Foot foot = foot_of(ground, from + (to - from) * (static_cast<double>(k) / pieces));
            if (foot.gap < deepest.gap) deepest = foot, at = k;
        }
        return at > 0 && at < pieces;
    }

    btPersistentManifold* manifold_;
};

struct GroundContactFactory final : btCollisionAlgorithmCreateFunc {
    explicit GroundContactFactory(bool swap) { m_swapped = swap; }
    btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                   const btCollisionObjectWrapper* one,
                                                   const btCollisionObjectWrapper* other) override {
        void* memory = info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(GroundContact));
        return new (memory) GroundContact(info, m_swapped ? other : one, m_swapped ? one : other);
    }
};

} // namespace

GroundShape::GroundShape(std::shared_ptr<const Ground> ground, double depth)
    : ground_(std::move(ground)), depth_(depth) {
    m_shapeType = CUSTOM_CONCAVE_SHAPE_TYPE;
}

void GroundShape::getAabb(const btTransform&, btVector3& low, btVector3& high) const {
    low.setValue(-BT_LARGE_FLOAT, -BT_LARGE_FLOAT, -BT_LARGE_FLOAT);
    high.setValue(BT_LARGE_FLOAT, BT_LARGE_FLOAT, BT_LARGE_FLOAT);
}

std::unique_ptr<btCollisionShape> bed_shape(const EnvironmentDef& environment) {
    if (environment.ground && environment.ground->has_grid())
        return std::make_unique<GroundShape>(environment.ground, environment.depth);
    const Vec3 n = bed_normal(environment, 0, 0);
    return std::make_unique<btStaticPlaneShape>(btVector3(n.x(), n.y(), n.z()),
                                                n.z() * bed_height(environment, 0, 0));
}

void meet_ground(btCollisionDispatcher& dispatcher) {
    static GroundContactFactory as_given(false), swapped(true);
    for (const int body : {BOX_SHAPE_PROXYTYPE, CONVEX_HULL_SHAPE_PROXYTYPE, SPHERE_SHAPE_PROXYTYPE}) {
        dispatcher.registerCollisionCreateFunc(body, CUSTOM_CONCAVE_SHAPE_TYPE, &as_given);
        dispatcher.registerCollisionCreateFunc(CUSTOM_CONCAVE_SHAPE_TYPE, body, &swapped);
    }
}

} // namespace windlass::physics
