// The line as a row of rigid rods, Bullet bodies in double precision, joined end to end by point-to-point
// constraints: how a chain is made in a physics engine.
// Source: Bullet 3.24 (bulletphysics.org), btPoint2PointConstraint under btSequentialImpulseConstraintSolver.
// Its conjugate gradient solver (btNNCGConstraintSolver) came no further in as many sweeps of a swinging
// chain, and cost a third more. Joints take no softness from EA: Bullet scales a constraint's CFM by the
// bodies' mass in each direction, and diverges where dt^2 k is less than that mass.
//
// Bullet's own contacts know no soft ground: weight, water and seabed are forces on the rods, the same as in
// the other methods. Tension is what the joints measured (btJointFeedback) at both ends of a rod.

#include "bench/methods/list.hpp"
#include "bench/methods/lumped_line.hpp"

#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <btBulletDynamicsCommon.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace windlass::lab {

namespace {

constexpr int kIterations = 10; ///< sweeps in a step; Bullet's own default

/// Share of a joint's gap that a step closes. Bullet's own 0.2 lets a swinging chain stretch visibly.
constexpr double kErrorReduction = 0.8;

btVector3 bullet(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}
Vec3 eigen(const btVector3& v) {
    return {v.x(), v.y(), v.z()};
}

class BulletLinks final : public Method {
public:
    BulletLinks(const Problem& problem, int links, double dt, const MethodSettings& settings)
        : line_(problem, links, dt), dt_(dt), shape_(0.25 * line_.rest) {
        world_.setGravity({0, 0, 0}); // weight is ours: it changes with submersion
        world_.getSolverInfo().m_numIterations = settings.iterations > 0 ? settings.iterations : kIterations;
        line_.start(ends_, end_velocity_);
        for (int i = 0; i < links; ++i)
            add_rod(i);
        joints_.reserve(links + 1);
        feedback_.resize(links + 1);
        add_end(problem.lower, 0, bodies_.front().get(), {0, 0, -0.5 * line_.rest});
        for (int i = 1; i < links; ++i) {
            join(i, std::make_unique<btPoint2PointConstraint>(*bodies_[i - 1], *bodies_[i],
                                                              btVector3(0, 0, 0.5 * line_.rest),
                                                              btVector3(0, 0, -0.5 * line_.rest)));
        }
        add_end(problem.upper, links, bodies_[links - 1].get(), {0, 0, 0.5 * line_.rest});
    }
    ~BulletLinks() override {
        for (const auto& joint : joints_)
            world_.removeConstraint(joint.get());
        for (const auto& body : bodies_)
            world_.removeRigidBody(body.get());
    }
    BulletLinks(const BulletLinks&) = delete;
    BulletLinks& operator=(const BulletLinks&) = delete;

    void step() override {
        ++taken_;
        line_.hold(time(), ends_, end_velocity_);
        if (low_pin_ != nullptr) low_pin_->setPivotB(bullet(ends_.at(0)));
        if (high_pin_ != nullptr) high_pin_->setPivotB(bullet(ends_.at(line_.links)));
        for (int i = 0; i < line_.links; ++i)
            load_rod(i);
        for (const auto& [body, weight] : weights_)
            body->applyCentralForce({0, 0, -weight});
        world_.stepSimulation(dt_, 0);
    }
    double time() const override { return static_cast<double>(taken_) * dt_; }
    int links() const override { return line_.links; }
    Vec3 position(int node) const override {
        if (node == 0) return eigen(point(0, -0.5));
        if (node == line_.links) return eigen(point(node - 1, 0.5));
        return 0.5 * eigen(point(node - 1, 0.5) + point(node, -0.5));
    }
    Vec3 velocity(int node) const override {
        const auto speed = [this](int rod, double end) {
            const btRigidBody& b = *bodies_[rod];
            return eigen(b.getVelocityInLocalPoint(point(rod, end) - b.getCenterOfMassPosition()));
        };
        if (node == 0) return speed(0, -0.5);
        if (node == line_.links) return speed(node - 1, 0.5);
        return 0.5 * (speed(node - 1, 0.5) + speed(node, -0.5));
    }
    double tension(int link) const override {
        // On the rod: at its lower end it is body B of the joint, or A of the pin; at its upper end A.
        const btVector3 axis = axis_of(link);
        const btVector3& up = feedback_[link + 1].m_appliedForceBodyA;
        const btVector3& down =
            link == 0 ? feedback_[0].m_appliedForceBodyA : feedback_[link].m_appliedForceBodyB;
        return 0.5 * (up.dot(axis) - down.dot(axis));
    }
    int iterations() const override { return world_.getSolverInfo().m_numIterations; }

private:
    const btVector3 axis_of(int rod) const {
        return bodies_[rod]->getWorldTransform().getBasis().getColumn(2);
    }
    /// Point of a rod at the given share of its length from its middle, m, world.
    btVector3 point(int rod, double share) const {
        return bodies_[rod]->getCenterOfMassPosition() + share * line_.rest * axis_of(rod);
    }

    /// Mass across the line, added mass included: Bullet's bodies have one mass for all directions.
    double rod_mass(double wet) const {
        return line_.mass[1] + line_.problem.line.added_mass_normal * wet * line_.displaced[1];
    }

    void add_body(double mass, const btVector3& inertia, const btTransform& place) {
        bodies_.push_back(std::make_unique<btRigidBody>(
            btRigidBody::btRigidBodyConstructionInfo(mass, nullptr, &shape_, inertia)));
        btRigidBody& body = *bodies_.back();
        body.setDamping(0, 0);
        body.setActivationState(DISABLE_DEACTIVATION);
        body.setCenterOfMassTransform(place);
        world_.addRigidBody(&body, 0, 0); // joints alone, no collisions
    }

    void add_rod(int i) {
        const Vec3 below = ends_.at(i), span = ends_.at(i + 1) - below;
        const Eigen::Quaterniond turn =
            Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), span.norm() > 0 ? span : Vec3::UnitZ());
        const double mass = rod_mass(wet(below.z() + 0.5 * span.z()));
        const double width = 0.5 * line_.problem.line.contact_diameter, rest = line_.rest;
        const double across = mass * (rest * rest / 12 + width * width / 4),
                     along = 0.5 * mass * width * width;
        add_body(mass, {across, across, along},
                 btTransform(btQuaternion(turn.x(), turn.y(), turn.z(), turn.w()),
                             bullet(Vec3(below + 0.5 * span))));
    }

    void add_end(const End& end, int node, btRigidBody* rod, const btVector3& pivot) {
        if (held(end)) {
            auto pin = std::make_unique<btPoint2PointConstraint>(*rod, pivot);
            pin->setPivotB(bullet(ends_.at(node)));
            (node == 0 ? low_pin_ : high_pin_) = pin.get();
            join(node, std::move(pin));
        } else if (end.kind == EndKind::mass) {
            const double size = 0.25 * line_.rest, inertia = 0.4 * end.mass * size * size;
            add_body(end.mass, {inertia, inertia, inertia},
                     btTransform(btQuaternion::getIdentity(), bullet(ends_.at(node))));
            weights_.emplace_back(bodies_.back().get(), end.weight);
            join(node,
                 std::make_unique<btPoint2PointConstraint>(*rod, *bodies_.back(), pivot, btVector3(0, 0, 0)));
        }
    }

    void join(int node, std::unique_ptr<btPoint2PointConstraint> joint) {
        joint->setParam(BT_CONSTRAINT_ERP, kErrorReduction);
        joint->setJointFeedback(&feedback_[node]);
        world_.addConstraint(joint.get(), true);
        joints_.push_back(std::move(joint));
    }

    double wet(double z) const { return line_.in_water() ? std::clamp(0.5 - z / line_.rest, 0.0, 1.0) : 0; }

    /// Weight, water and seabed on a rod, as forces at its middle (water) and at its ends (seabed).
    /// Resistances are held to what stops the rod in a step: they are known only from its start.
    void load_rod(int i) {
        const physics::ChainDef& def = line_.problem.line;
        const physics::EnvironmentDef& sea = line_.problem.environment;
        btRigidBody& body = *bodies_[i];
        const double share = wet(body.getCenterOfMassPosition().z());
        const double mass = 1 / body.getInvMass();
        body.applyCentralForce({0, 0, -(line_.mass[1] - share * line_.displaced[1]) * physics::kGravity});
        if (share > 0) {
            const double area = 0.5 * sea.water_density * def.diameter * line_.rest * share;
            const Vec3 t = eigen(axis_of(i)), flow = eigen(body.getLinearVelocity()) - line_.current;
            const double along = flow.dot(t);
            const Vec3 across = flow - along * t;
            const auto rate = [&](double c) { return c / (1 + dt_ * c / mass); };
            body.applyCentralForce(bullet(Vec3(-rate(area * def.drag_normal * across.norm()) * across -
                                               rate(area * def.drag_axial * std::abs(along)) * along * t)));
        }
        for (const double end : {-0.5, 0.5}) {
            const btVector3 at = point(i, end), arm = at - body.getCenterOfMassPosition();
            const double sunk = -sea.depth - at.z(), spring = 0.5 * line_.bed_spring[1], half = 0.5 * mass;
            if (sunk <= 0) continue;
            const btVector3 v = body.getVelocityInLocalPoint(arm);
            const double damper = 2 * std::sqrt(spring * half);
            const double support =
                (spring * sunk - (damper + dt_ * spring) * v.z()) /
                (1 + dt_ * damper / half + dt_ * dt_ * spring / half); // implicit in the rod's half
            if (support <= 0) continue;                                // mud does not pull
            const double slide = std::hypot(v.x(), v.y());
            const double friction = std::min(sea.bed_friction * support / std::max(slide, 1e-12), half / dt_);
            body.applyForce({-friction * v.x(), -friction * v.y(), support}, arm);
        }
    }

    LumpedLine line_;
    double dt_;
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
    btSphereShape shape_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_; ///< rods from the lower end, then attached masses
    std::vector<std::unique_ptr<btTypedConstraint>> joints_;
    std::vector<btJointFeedback> feedback_; ///< per node
    std::vector<std::pair<btRigidBody*, double>> weights_;
    btPoint2PointConstraint *low_pin_ = nullptr, *high_pin_ = nullptr;
    Field ends_, end_velocity_;
    long taken_ = 0;
};

} // namespace

MethodEntry bullet_links_method() {
    return {"bullet_links",
            "rigid rods as Bullet bodies, joined by point-to-point constraints",
            "added mass along the line is that across it; joints push as well as pull: slack shows in the "
            "rods' folding",
            [](const Problem& problem, int links, double dt,
               const MethodSettings& settings) -> std::unique_ptr<Method> {
                return std::make_unique<BulletLinks>(problem, links, dt, settings);
            },
            false,
            true};
}

} // namespace windlass::lab
