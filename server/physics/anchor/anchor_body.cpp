#include "server/physics/anchor/anchor_body.hpp"

#include "server/physics/base/state_limits.hpp"
#include "server/physics/sea/ground_shape.hpp"

#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace windlass::physics {

namespace {

constexpr double kMinMass = 1, kMaxMass = 1e7; ///< kg, of an anchor in a state that is brought back
constexpr double kRounding = 1e-6;             ///< of its axes
constexpr double kMaxParts = 1000;             ///< of what touches
constexpr int kOldest = 1'000'000'000;         ///< steps that a point of contact lives
constexpr double kAtRest = 1e-12; ///< m2/s2; sweeps over contacts end that change no speed by 1e-6 m/s

btVector3 bullet(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}
btQuaternion bullet(const Eigen::Quaterniond& q) {
    return {q.x(), q.y(), q.z(), q.w()};
}
Vec3 eigen(const btVector3& v) {
    return {v.x(), v.y(), v.z()};
}
Eigen::Quaterniond eigen(const btQuaternion& q) {
    return {q.w(), q.x(), q.y(), q.z()};
}

/// Bullet takes a point of contact as it is: with one far from the anchor, or with options that nobody here
/// sets, its sums cease to be numbers, and it writes beside the point's memory.
void check_point(const StateVisitor& v, const btManifoldPoint& p) {
    const auto each = [&](const char* name, const btVector3& vector, double max) {
        v.all_within({name}, &vector[0], 3, -max, max);
    };
    each("m_localPointA", p.m_localPointA, kFarthest);
    each("m_localPointB", p.m_localPointB, kFarthest);
    each("m_positionWorldOnA", p.m_positionWorldOnA, kFarthest);
    each("m_positionWorldOnB", p.m_positionWorldOnB, kFarthest);
    v.within({"m_normalWorldOnB"}, p.m_normalWorldOnB.length2(), 1 - kRounding, 1 + kRounding);
    each("m_lateralFrictionDir1", p.m_lateralFrictionDir1, 1 + kRounding);
    each("m_lateralFrictionDir2", p.m_lateralFrictionDir2, 1 + kRounding);
    WINDLASS_WITHIN(v, -kFarthest, kFarthest, p.m_distance1);
    WINDLASS_WITHIN(v, 0, 1, p.m_combinedFriction, p.m_combinedRollingFriction, p.m_combinedSpinningFriction,
                    p.m_combinedRestitution, p.m_contactCFM, p.m_contactERP, p.m_frictionCFM);
    WINDLASS_WITHIN(v, -1, kMaxParts, p.m_partId0, p.m_partId1, p.m_index0, p.m_index1);
    v.within({"m_contactPointFlags"}, p.m_contactPointFlags, 0,
             int{BT_CONTACT_FLAG_LATERAL_FRICTION_INITIALIZED});
    WINDLASS_WITHIN(v, -kStrongest, kStrongest, p.m_appliedImpulse, p.m_prevRHS, p.m_appliedImpulseLateral1,
                    p.m_appliedImpulseLateral2);
    WINDLASS_WITHIN(v, -kFastest, kFastest, p.m_contactMotion1, p.m_contactMotion2);
    v.within({"m_lifeTime"}, p.m_lifeTime, 0, kOldest);
}

/// All of a point of contact that the next step starts from.
template <class Visitor, StateOf<btManifoldPoint> Point>
void visit_point(Visitor& v, Point& p) {
    const auto vector = [&](const char* name, auto& of) { v.numbers({name}, &of[0], 3); };
    vector("m_localPointA", p.m_localPointA);
    vector("m_localPointB", p.m_localPointB);
    vector("m_positionWorldOnB", p.m_positionWorldOnB);
    vector("m_positionWorldOnA", p.m_positionWorldOnA);
    vector("m_normalWorldOnB", p.m_normalWorldOnB);
    vector("m_lateralFrictionDir1", p.m_lateralFrictionDir1);
    vector("m_lateralFrictionDir2", p.m_lateralFrictionDir2);
    WINDLASS_STATE(v, p.m_distance1, p.m_combinedFriction, p.m_combinedRollingFriction,
                   p.m_combinedSpinningFriction, p.m_combinedRestitution, p.m_partId0, p.m_partId1,
                   p.m_index0, p.m_index1, p.m_contactPointFlags, p.m_appliedImpulse, p.m_prevRHS,
                   p.m_appliedImpulseLateral1, p.m_appliedImpulseLateral2, p.m_contactMotion1,
                   p.m_contactMotion2, p.m_contactCFM, p.m_contactERP, p.m_frictionCFM, p.m_lifeTime);
    if constexpr (Visitor::kRestores) check_point(v, p);
}

/// A body's axes are at right angles and of length one: what Bullet turns by others it stretches.
void check_axes(const StateVisitor& v, const btMatrix3x3& axes) {
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k <= i; ++k) {
            const double product = axes[i].dot(axes[k]), wanted = i == k ? 1 : 0;
            v.within({"axes"}, product, wanted - kRounding, wanted + kRounding);
        }
}

/// A ball, or a corner, which has no radius; m, anchor frame.
struct Corner {
    Vec3 centre;
    double radius;
};

/// Room for the pairs of one body's parts with the bed: three were wanted at most. Bullet's own is for 4096
/// of each, 7 MB; where more are wanted it allocates.
btDefaultCollisionConstructionInfo small_pools() {
    constexpr int kPairs = 16;
    btDefaultCollisionConstructionInfo pools;
    pools.m_defaultMaxPersistentManifoldPoolSize = kPairs;
    pools.m_defaultMaxCollisionAlgorithmPoolSize = kPairs;
    return pools;
}

} // namespace

struct AnchorBody::World {
    btDefaultCollisionConfiguration configuration{small_pools()};
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
    std::vector<std::unique_ptr<btConvexShape>> parts;
    btCompoundShape shape;
    std::unique_ptr<btCollisionShape> bed_shape;
    std::unique_ptr<btRigidBody> bed, anchor;
    Vec3 inertia_over_mass;      ///< m2, principal
    std::vector<Corner> corners; ///< to find the lowest point
    double mass = 0;             ///< kg, as Bullet was last told

    explicit World(const EnvironmentDef& environment) : bed_shape(windlass::physics::bed_shape(environment)) {
        meet_ground(dispatcher);
    }
    ~World() {
        world.removeRigidBody(anchor.get());
        world.removeRigidBody(bed.get());
    }
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    /// Whether it did when last looked at.
    bool touches() {
        for (int k = 0; k < dispatcher.getNumManifolds(); ++k)
            if (dispatcher.getManifoldByIndexInternal(k)->getNumContacts() > 0) return true;
        return false;
    }

    /// Finds the contacts and gives the anchor what they push in dt (s).
    void meet(double dt) {
        dispatcher.dispatchAllCollisionPairs(broadphase.getOverlappingPairCache(), world.getDispatchInfo(),
                                             &dispatcher);
        btContactSolverInfo& info = world.getSolverInfo();
        info.m_timeStep = dt;
        btCollisionObject* moves = anchor.get();
        solver.solveGroup(&moves, 1, dispatcher.getInternalManifoldPointer(), dispatcher.getNumManifolds(),
                          nullptr, 0, info, nullptr, &dispatcher);
    }

    const btTransform& transform() const { return anchor->getWorldTransform(); }

    /// Whether the anchor is anywhere, and its motion is one: what Bullet asks of all that it is given.
    bool is_somewhere() const {
        const auto below = [](const btVector3& v, double max) {
            return std::abs(v.x()) < max && std::abs(v.y()) < max && std::abs(v.z()) < max;
        };
        return below(transform().getOrigin(), kFarthest) && below(anchor->getLinearVelocity(), kFastest) &&
               below(anchor->getAngularVelocity(), kFastestTurn);
    }

    void add(std::unique_ptr<btConvexShape> part, const Vec3& at) {
        shape.addChildShape(btTransform(btQuaternion::getIdentity(), bullet(at)), part.get());
        parts.push_back(std::move(part));
    }
    void rest_on_corners(const AnchorPart& part) {
        const Vec3 h = part.half;
        add(std::make_unique<btBoxShape>(bullet(h)), part.centre);
        for (const double x : {-h.x(), h.x()})
            for (const double y : {-h.y(), h.y()})
                for (const double z : {-h.z(), h.z()})
                    corners.push_back({part.centre + Vec3(x, y, z), 0});
    }
    /// A roller touches level ground between its ends nowhere else than at them.
    void rest_on_balls(const AnchorPart& part) {
        const double to_end = part.half.y() - part.roller;
        for (const double y : {-to_end, to_end}) {
            const Vec3 centre = part.centre + y * Vec3::UnitY();
            add(std::make_unique<btSphereShape>(part.roller), centre);
            corners.push_back({centre, part.roller});
        }
    }
};

AnchorBody::AnchorBody(const AnchorShape& shape, double mass, const EnvironmentDef& environment)
    : world_(std::make_unique<World>(environment)) {
    World& w = *world_;
    w.inertia_over_mass = shape.inertia_over_mass;
    for (const AnchorPart& part : shape.parts) {
        if (part.fluke) continue; // goes into the soil
        if (part.roller > 0) {
            w.rest_on_balls(part);
        } else {
            w.rest_on_corners(part);
        }
    }
    w.bed = std::make_unique<btRigidBody>(
        btRigidBody::btRigidBodyConstructionInfo(0, nullptr, w.bed_shape.get()));
    w.bed->setFriction(1);
    w.anchor = std::make_unique<btRigidBody>(btRigidBody::btRigidBodyConstructionInfo(
        mass, nullptr, &w.shape, bullet(Vec3(mass * w.inertia_over_mass))));
    w.anchor->setFriction(0); // the soil's resistance, bed friction included, is in the chain's solve
    w.anchor->setRestitution(0);
    w.anchor->setDamping(0, 0);
    w.anchor->setActivationState(DISABLE_DEACTIVATION);
    w.world.getSolverInfo().m_leastSquaresResidualThreshold = kAtRest;
    w.world.setGravity({0, 0, 0}); // weight is the caller's: it changes with submersion
    w.world.addRigidBody(w.bed.get());
    w.world.addRigidBody(w.anchor.get());
    set_mass(mass);
    w.world.performDiscreteCollisionDetection(); // so that it has its sets of points, in their order
}

AnchorBody::~AnchorBody() = default;
AnchorBody::AnchorBody(AnchorBody&&) noexcept = default;

Vec3 AnchorBody::position() const {
    return eigen(world_->transform().getOrigin());
}

Eigen::Matrix3d AnchorBody::axes() const {
    const btMatrix3x3& basis = world_->transform().getBasis();
    Eigen::Matrix3d axes;
    for (int row = 0; row < 3; ++row)
        axes.row(row) = eigen(basis[row]);
    return axes;
}

AnchorPose AnchorBody::pose() const {
    const btRigidBody& a = *world_->anchor;
    return {position(), eigen(world_->transform().getRotation()), eigen(a.getLinearVelocity()),
            eigen(a.getAngularVelocity())};
}

void AnchorBody::set_pose(const AnchorPose& pose) {
    btRigidBody& a = *world_->anchor;
    a.setWorldTransform(btTransform(bullet(pose.attitude), bullet(pose.position)));
    a.setLinearVelocity(bullet(pose.velocity));
    a.setAngularVelocity(bullet(pose.spin));
    a.updateInertiaTensor();
}

Vector6 AnchorBody::motion() const {
    Vector6 motion;
    motion << eigen(world_->anchor->getLinearVelocity()), eigen(world_->anchor->getAngularVelocity());
    return motion;
}

void AnchorBody::set_motion(const Vector6& motion) {
    world_->anchor->setLinearVelocity(bullet(motion.head<3>()));
    world_->anchor->setAngularVelocity(bullet(motion.tail<3>()));
}

double AnchorBody::mass() const {
    return world_->mass;
}

void AnchorBody::set_mass(double kilograms) {
    assert(!(kilograms <= 0) && "a body without mass would go anywhere");
    World& w = *world_;
    w.mass = kilograms;
    w.anchor->setMassProps(kilograms, bullet(Vec3(kilograms * w.inertia_over_mass)));
    w.anchor->updateInertiaTensor();
}

Vec3 AnchorBody::arm(const Vec3& point) const {
    return eigen(world_->transform().getBasis() * bullet(point));
}

Vec3 AnchorBody::place(const Vec3& point) const {
    return eigen(world_->transform() * bullet(point));
}

double AnchorBody::clearance(const EnvironmentDef& environment) const {
    double min = 1e300;
    for (const Corner& corner : world_->corners)
        min = std::min(min, height_over_bed(environment, place(corner.centre)) - corner.radius);
    return min;
}

Matrix6 AnchorBody::inertia() const {
    const Eigen::Matrix3d axes = AnchorBody::axes();
    Matrix6 inertia = Matrix6::Zero();
    inertia.topLeftCorner<3, 3>().diagonal().setConstant(mass());
    inertia.bottomRightCorner<3, 3>() =
        axes * (mass() * world_->inertia_over_mass).asDiagonal() * axes.transpose();
    return inertia;
}

void AnchorBody::step(double dt, bool clear) {
    assert(dt > 0 && "a step takes time");
    World& w = *world_;
    btRigidBody& a = *w.anchor;
    if (!w.is_somewhere()) return; // the tick ends as a fault
    // What Bullet's step comes to for two bodies that always are a pair and never sleep: contacts, their
    // impulses, way and turn. Its solver adds the gyroscopic torque, which is all that it does without
    // contacts.
    if (!clear || w.touches())
        w.meet(dt);
    else
        a.setAngularVelocity(a.getAngularVelocity() + a.computeGyroscopicImpulseImplicit_Body(dt));
    btTransform place;
    a.predictIntegratedTransform(dt, place);
    a.proceedToTransform(place);
}

void AnchorBody::add_motion(const Vector6& change, double dt) {
    btRigidBody& a = *world_->anchor;
    set_motion(motion() + change);
    const btVector3 turn = bullet(Vec3(dt * change.tail<3>()));
    btTransform place = a.getWorldTransform();
    place.setOrigin(place.getOrigin() + bullet(Vec3(dt * change.head<3>())));
    if (turn.length2() > 0)
        place.setRotation(
            (btQuaternion(turn.normalized(), turn.length()) * place.getRotation()).normalized());
    a.setWorldTransform(place);
    a.updateInertiaTensor();
}

/// Bullet makes one set of points (manifold) for each box as soon as it looks for contacts, always in the
/// same order; so that the points of a step can be given back to a body that has not taken one yet.
template <class Visitor, StateOf<AnchorBody> Self>
void visit_state(Visitor& v, Self& self) {
    constexpr bool kRestores = Visitor::kRestores;
    std::conditional_t<kRestores, AnchorBody::World, const AnchorBody::World>& w = *self.world_;
    AnchorPose at = self.pose();
    double mass = w.mass;
    btMatrix3x3 axes = w.transform().getBasis();
    WINDLASS_STATE(v, at.position, at.velocity, at.spin, mass);
    for (int row = 0; row < 3; ++row)
        v.numbers({"axes"}, &axes[row][0], 3);
    if constexpr (kRestores) {
        v.within({"mass"}, mass, kMinMass, kMaxMass);
        WINDLASS_WITHIN(v, -kFarthest, kFarthest, at.position);
        WINDLASS_WITHIN(v, -kFastest, kFastest, at.velocity);
        WINDLASS_WITHIN(v, -kFastestTurn, kFastestTurn, at.spin);
        check_axes(v, axes);
        self.set_mass(mass);
        btRigidBody& a = *w.anchor;
        a.setWorldTransform(btTransform(axes, bullet(at.position)));
        a.setLinearVelocity(bullet(at.velocity));
        a.setAngularVelocity(bullet(at.spin));
        a.updateInertiaTensor();
    }

    int manifolds = w.dispatcher.getNumManifolds();
    v.field({"manifolds"}, manifolds);
    if constexpr (kRestores) {
        if (manifolds != w.dispatcher.getNumManifolds()) w.world.performDiscreteCollisionDetection();
        v.within({"manifolds"}, manifolds, 0, w.dispatcher.getNumManifolds());
    }
    for (int k = 0; k < manifolds; ++k) {
        auto& manifold = *w.dispatcher.getManifoldByIndexInternal(k);
        int points = manifold.getNumContacts();
        v.field({"points"}, points);
        if constexpr (kRestores) {
            v.within({"points"}, points, 0, MANIFOLD_CACHE_SIZE);
            manifold.clearManifold();
            for (int i = 0; i < points; ++i)
                manifold.addManifoldPoint(btManifoldPoint(), true);
        }
        for (int i = 0; i < points; ++i)
            visit_point(v, manifold.getContactPoint(i));
    }
}
WINDLASS_STATE_LISTED(AnchorBody);

} // namespace windlass::physics
