#include "server/physics/anchor.hpp"

#include "server/physics/current.hpp"
#include "server/physics/state_fields.hpp"

#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace windlass::physics {

namespace {

/// Speed below which the soil's resistance is viscous, m/s: an anchor held by half its holding power creeps
/// 0.2 m an hour.
constexpr double kSoilCreep = 1e-4;

/// The anchor counts as on the bottom while its lowest point is nearer than this, m.
constexpr double kTouching = 0.05;

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

/// A box of the anchor: centre and half sizes, m, from the crown pin along x; share of the mass.
struct Part {
    Vec3 centre, half;
    double share;
};

/// Stockless anchor as four boxes: shank, crown, two flukes. Proportions from common Hall drawings; tuned.
std::array<Part, 4> parts(const AnchorDef& def) {
    const double shank = def.shank_length, fluke = def.fluke_length, width = def.crown_width;
    return {{{{0.5 * shank, 0, 0}, {0.5 * shank, 0.07 * width, 0.09 * width}, 0.35},
             {{0, 0, 0}, {0.12 * shank, 0.5 * width, 0.14 * width}, 0.30},
             {{0.5 * fluke, 0.30 * width, 0}, {0.5 * fluke, 0.13 * width, 0.05 * width}, 0.175},
             {{0.5 * fluke, -0.30 * width, 0}, {0.5 * fluke, 0.13 * width, 0.05 * width}, 0.175}}};
}

} // namespace

struct Anchor::Body {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
    std::vector<std::unique_ptr<btBoxShape>> boxes;
    btCompoundShape shape;
    btStaticPlaneShape bed_shape;
    std::unique_ptr<btRigidBody> bed, anchor;
    Vec3 shackle;                            ///< anchor frame
    Vec3 inertia_over_mass;                  ///< m2, principal
    std::vector<Vec3> corners;               ///< anchor frame, to find the lowest point
    double dry_mass = 0, displaced_mass = 0; ///< kg; the second at full submersion
    double mass = 0;                         ///< kg, as Bullet was last told

    explicit Body(double depth) : bed_shape(btVector3(0, 0, 1), -depth) {}
    ~Body() {
        world.removeRigidBody(anchor.get());
        world.removeRigidBody(bed.get());
    }
    Body(const Body&) = delete;
    Body& operator=(const Body&) = delete;

    Vec3 arm() const { // from centre of mass to shackle, world
        return eigen(anchor->getWorldTransform().getRotation()) * shackle;
    }
    /// Inverse mass of the shackle as a point: 1/m - [r] I^-1 [r].
    SymmetricMatrix shackle_inverse_mass() const {
        const Vec3 r = arm();
        Eigen::Matrix3d cross, inverse_inertia;
        cross << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
        for (int row = 0; row < 3; ++row)
            inverse_inertia.row(row) = eigen(anchor->getInvInertiaTensorWorld()[row]);
        const Eigen::Matrix3d w =
            Eigen::Matrix3d::Identity() * anchor->getInvMass() - cross * inverse_inertia * cross;
        return {.xx = w(0, 0), .yy = w(1, 1), .zz = w(2, 2), .xy = w(0, 1), .xz = w(0, 2), .yz = w(1, 2)};
    }
    void set_mass(double kilograms) {
        mass = kilograms;
        anchor->setMassProps(mass, bullet(Vec3(mass * inertia_over_mass)));
        anchor->updateInertiaTensor();
    }
};

Anchor::Anchor(const AnchorDef& def, double extra_mass, const EnvironmentDef& environment,
               const AnchorPose& pose)
    : def_(def), body_(std::make_unique<Body>(environment.depth)) {
    Body& b = *body_;
    b.dry_mass = b.mass = def.mass + extra_mass;
    b.displaced_mass = b.dry_mass * environment.water_density / kSteelDensity;

    double centre = 0;
    for (const Part& part : parts(def))
        centre += part.share * part.centre.x();
    b.inertia_over_mass.setZero();
    for (const Part& part : parts(def)) {
        const Vec3 at = part.centre - Vec3(centre, 0, 0), h = part.half;
        b.inertia_over_mass +=
            part.share * Vec3((h.y() * h.y() + h.z() * h.z()) / 3 + at.y() * at.y() + at.z() * at.z(),
                              (h.x() * h.x() + h.z() * h.z()) / 3 + at.x() * at.x() + at.z() * at.z(),
                              (h.x() * h.x() + h.y() * h.y()) / 3 + at.x() * at.x() + at.y() * at.y());
        b.boxes.push_back(std::make_unique<btBoxShape>(bullet(h)));
        b.shape.addChildShape(btTransform(btQuaternion::getIdentity(), bullet(at)), b.boxes.back().get());
        for (int corner = 0; corner < 8; ++corner) {
            b.corners.push_back(at + Vec3(corner & 1 ? h.x() : -h.x(), corner & 2 ? h.y() : -h.y(),
                                          corner & 4 ? h.z() : -h.z()));
        }
    }
    b.shackle = {def.shank_length - centre, 0, 0};

    b.bed = std::make_unique<btRigidBody>(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &b.bed_shape));
    b.bed->setFriction(1);
    b.anchor = std::make_unique<btRigidBody>(btRigidBody::btRigidBodyConstructionInfo(
        b.dry_mass, nullptr, &b.shape, bullet(Vec3(b.dry_mass * b.inertia_over_mass))));
    b.anchor->setFriction(0); // the soil's resistance, bed friction included, is in the chain's solve (begin)
    b.anchor->setRestitution(0);
    b.anchor->setDamping(0, 0);
    b.anchor->setActivationState(DISABLE_DEACTIVATION);
    b.world.setGravity({0, 0, 0}); // weight is ours: it changes with submersion
    b.world.addRigidBody(b.bed.get());
    b.world.addRigidBody(b.anchor.get());
    set_pose(pose);
}

Anchor::~Anchor() = default;
Anchor::Anchor(Anchor&&) noexcept = default;

AnchorPose Anchor::pose() const {
    const btRigidBody& a = *body_->anchor;
    return {eigen(a.getWorldTransform().getOrigin()), eigen(a.getWorldTransform().getRotation()),
            eigen(a.getLinearVelocity()), eigen(a.getAngularVelocity())};
}

void Anchor::set_pose(const AnchorPose& pose) {
    btRigidBody& a = *body_->anchor;
    a.setWorldTransform(btTransform(bullet(pose.attitude), bullet(pose.position)));
    a.setLinearVelocity(bullet(pose.velocity));
    a.setAngularVelocity(bullet(pose.spin));
    a.updateInertiaTensor();
}

void Anchor::rest() {
    body_->anchor->setLinearVelocity({0, 0, 0});
    body_->anchor->setAngularVelocity({0, 0, 0});
}

Vec3 Anchor::shackle() const {
    return eigen(body_->anchor->getWorldTransform().getOrigin()) + body_->arm();
}

Vec3 Anchor::shackle_velocity() const {
    return eigen(body_->anchor->getLinearVelocity()) +
           eigen(body_->anchor->getAngularVelocity()).cross(body_->arm());
}

double Anchor::clearance(const EnvironmentDef& environment) const {
    const btTransform& t = body_->anchor->getWorldTransform();
    double lowest = 1e300;
    for (const Vec3& corner : body_->corners)
        lowest = std::min(lowest, (t * bullet(corner)).z());
    return lowest + environment.depth;
}

double Anchor::mass() const {
    return 1 / body_->anchor->getInvMass();
}

double Anchor::weight(const EnvironmentDef& environment) const {
    const double share = submerged_share(pose().position.z(), def_.shank_length);
    return (body_->dry_mass - share * body_->dry_mass * environment.water_density / kSteelDensity) * kGravity;
}

double Anchor::kinetic_energy() const {
    const AnchorPose p = pose();
    const Vec3 spin = p.attitude.conjugate() * p.spin;
    return 0.5 * mass() * (p.velocity.squaredNorm() + spin.cwiseProduct(body_->inertia_over_mass).dot(spin));
}

double Anchor::potential_energy(const EnvironmentDef& environment) const {
    const double z = pose().position.z(), h = def_.shank_length;
    double submerged_height = 0; // integral of submerged_share() from z upwards
    if (z < -0.5 * h) {
        submerged_height = -z;
    } else if (z < 0.5 * h) {
        submerged_height = (0.5 * h - z) * (0.5 * h - z) / (2 * h);
    }
    return body_->dry_mass * kGravity * (z + environment.water_density / kSteelDensity * submerged_height);
}

ChainTail Anchor::begin(const EnvironmentDef& environment, const StepTime& time, double uplift) {
    Body& b = *body_;
    btRigidBody& a = *b.anchor;
    const Vec3 shackle_before = shackle();
    shackle_velocity_before_ = shackle_velocity();
    on_bottom_ = clearance(environment) < kTouching;
    const double sliding = std::hypot(shackle_velocity_before_.x(), shackle_velocity_before_.y());

    // Added mass comes and goes with submersion; the momentum stays, and water set in motion takes energy.
    const double share = submerged_share(pose().position.z(), def_.shank_length);
    const double mass_now = b.dry_mass + def_.added_mass * share * b.displaced_mass;
    const double mass_was = mass(), energy_was = kinetic_energy();
    if (mass_now != mass_was) {
        a.setLinearVelocity(a.getLinearVelocity() * (mass_was / mass_now));
        a.setAngularVelocity(a.getAngularVelocity() * (mass_was / mass_now));
        b.set_mass(mass_now);
    }
    water_entry_loss_ = energy_was - kinetic_energy();
    shackle_mass_ = b.shackle_inverse_mass().inverse();
    arm_ = b.arm();

    // Quadratic drag, implicit as in chain_forces.hpp. Turning is damped by the same area at a quarter of the
    // shank's length.
    const Vec3 current = share > 0 ? current_at(environment, pose().position.z()) : Vec3(Vec3::Zero());
    velocity_before_ = eigen(a.getLinearVelocity());
    const Vec3 spin_before = eigen(a.getAngularVelocity());
    const double drag = 0.5 * environment.water_density * def_.drag_area * share;
    const double damping = drag * (velocity_before_ - current).norm();
    const Vec3 velocity = (mass_now * velocity_before_ +
                           time.kick * (damping * current - weight(environment) * Vec3::UnitZ())) /
                          (mass_now + time.kick * damping);
    drag_force_ = damping * (velocity - current);
    const double lever = 0.25 * def_.shank_length;
    const double turning = drag * lever * lever * lever * eigen(a.getAngularVelocity()).norm();
    a.setLinearVelocity(bullet(velocity));
    a.setAngularVelocity(a.getAngularVelocity() /
                         (1 + time.kick * turning / (mass_now * b.inertia_over_mass.maxCoeff())));

    // Bullet first: an anchor that the ground has stopped is what the chain then finds at its end. The other
    // way round, the ground would stretch a chain already solved, and create energy.
    const Vec3 free_speed = eigen(a.getLinearVelocity()), free_spin = eigen(a.getAngularVelocity());
    b.world.stepSimulation(time.dt, 0);
    const Vec3 contact_speed = eigen(a.getLinearVelocity()) - free_speed;
    const Vec3 contact_spin = eigen(a.getAngularVelocity()) - free_spin;
    const auto inertia = [&](const Vec3& spin) { // kg m2/s, angular momentum
        const Eigen::Quaterniond q = pose().attitude;
        return Vec3(q * (mass_now * b.inertia_over_mass.cwiseProduct(q.conjugate() * spin)));
    };
    contact_loss_ = -mass_now * contact_speed.dot(velocity_before_ + eigen(a.getLinearVelocity())) / 2 -
                    inertia(contact_spin).dot(spin_before + eigen(a.getAngularVelocity())) / 2;
    velocity_before_ += contact_speed;
    shackle_velocity_before_ += contact_speed + contact_spin.cross(arm_);
    free_velocity_ = (shackle() - shackle_before) / time.dt;

    // Soil holds the shackle, level: at most its capacity, whatever the speed.
    soil_damping_ = 0;
    if (on_bottom_) {
        soil_damping_ =
            holding_capacity(def_, environment.soil, holding_, uplift) / std::max(sliding, kSoilCreep);
    }
    SymmetricMatrix held = shackle_mass_;
    held.xx += time.kick * soil_damping_;
    held.yy += time.kick * soil_damping_;
    ChainTail tail;
    tail.inverse_mass = held.inverse();
    tail.velocity_before = shackle_velocity_before_;
    tail.velocity = tail.inverse_mass * (shackle_mass_ * free_velocity_);
    return tail;
}

void Anchor::finish(const StepTime& time, double uplift, const Vec3& shackle_velocity, EnergyLedger* ledger) {
    Body& b = *body_;
    btRigidBody& a = *b.anchor;
    // Chain and soil together changed the shackle's speed: that impulse is the body's. Bullet has moved the
    // body already; it moves on by what the impulse adds.
    const btVector3 velocity = a.getLinearVelocity(), spin = a.getAngularVelocity();
    a.applyImpulse(bullet(shackle_mass_ * (shackle_velocity - free_velocity_)), bullet(arm_));
    const btVector3 turn = time.dt * (a.getAngularVelocity() - spin);
    btTransform place = a.getWorldTransform();
    place.setOrigin(place.getOrigin() + time.dt * (a.getLinearVelocity() - velocity));
    if (turn.length2() > 0)
        place.setRotation(
            (btQuaternion(turn.normalized(), turn.length()) * place.getRotation()).normalized());
    a.setWorldTransform(place);
    a.updateInertiaTensor();

    const Vec3 mean_shackle_velocity = 0.5 * (shackle_velocity_before_ + shackle_velocity);
    const Vec3 soil = soil_damping_ * Vec3(shackle_velocity.x(), shackle_velocity.y(), 0);
    soil_force_ = soil.norm();
    update_holding(def_, holding_, on_bottom_,
                   time.dt * std::hypot(mean_shackle_velocity.x(), mean_shackle_velocity.y()), time.dt,
                   uplift);
    if (ledger == nullptr) return;
    ledger->anchor_bed += contact_loss_;
    ledger->soil += time.kick * soil.dot(mean_shackle_velocity);
    ledger->anchor_drag +=
        water_entry_loss_ +
        time.kick * drag_force_.dot(0.5 * (velocity_before_ + eigen(a.getLinearVelocity())));
}

/// The body's place as Bullet holds it (a matrix), its mass with the water it carries, and the points at
/// which it touched the bottom, whose impulses the next step starts from. Bullet makes one set of points
/// (manifold) for each box as soon as it looks for contacts, always in the same order; so that the points of
/// a step can be given back to a body that has not taken one yet.
void Anchor::visit_state(StateVisitor& v) {
    Body& b = *body_;
    btRigidBody& a = *b.anchor;
    AnchorPose at = pose();
    const double mass_before = b.mass;
    btMatrix3x3 axes = a.getWorldTransform().getBasis();
    WINDLASS_STATE(v, at.position, at.velocity, at.spin, b.mass, holding_, soil_force_);
    for (int row = 0; row < 3; ++row)
        v.numbers({"axes"}, &axes[row][0], 3);
    if (b.mass != mass_before) b.set_mass(b.mass);
    if (axes != a.getWorldTransform().getBasis() || at.position != eigen(a.getWorldTransform().getOrigin())) {
        a.setWorldTransform(btTransform(axes, bullet(at.position)));
    }
    a.setLinearVelocity(bullet(at.velocity));
    a.setAngularVelocity(bullet(at.spin));
    a.updateInertiaTensor();

    int manifolds = b.dispatcher.getNumManifolds();
    v.field({"manifolds"}, manifolds);
    if (manifolds != b.dispatcher.getNumManifolds()) b.world.performDiscreteCollisionDetection();
    for (int k = 0; k < std::min(manifolds, b.dispatcher.getNumManifolds()); ++k) {
        btPersistentManifold& manifold = *b.dispatcher.getManifoldByIndexInternal(k);
        int points = manifold.getNumContacts();
        v.field({"points"}, points);
        if (points != manifold.getNumContacts()) {
            manifold.clearManifold();
            for (int i = 0; i < std::min(points, MANIFOLD_CACHE_SIZE); ++i)
                manifold.addManifoldPoint(btManifoldPoint(), true);
        }
        for (int i = 0; i < manifold.getNumContacts(); ++i) {
            btManifoldPoint& p = manifold.getContactPoint(i);
            for (btVector3* vector :
                 {&p.m_localPointA, &p.m_localPointB, &p.m_positionWorldOnB, &p.m_positionWorldOnA,
                  &p.m_normalWorldOnB, &p.m_lateralFrictionDir1, &p.m_lateralFrictionDir2}) {
                v.numbers({"point"}, &(*vector)[0], 3);
            }
            WINDLASS_STATE(v, p.m_distance1, p.m_combinedFriction, p.m_combinedRollingFriction,
                           p.m_combinedSpinningFriction, p.m_combinedRestitution, p.m_partId0, p.m_partId1,
                           p.m_index0, p.m_index1, p.m_contactPointFlags, p.m_appliedImpulse, p.m_prevRHS,
                           p.m_appliedImpulseLateral1, p.m_appliedImpulseLateral2, p.m_contactMotion1,
                           p.m_contactMotion2, p.m_contactCFM, p.m_contactERP, p.m_frictionCFM, p.m_lifeTime);
        }
    }
}

} // namespace windlass::physics
