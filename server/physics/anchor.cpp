#include "server/physics/anchor.hpp"

#include "server/physics/current.hpp"
#include "server/physics/state_fields.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace windlass::physics {

namespace {

/// Speed below which the soil's resistance is viscous, m/s: an anchor held by half its holding power creeps
/// 0.2 m an hour.
constexpr double kSoilCreep = 1e-4;

/// A point of the anchor counts as on the bottom while it is nearer than this, m.
constexpr double kTouching = 0.05;

double level_speed(const Vec3& velocity) {
    return std::hypot(velocity.x(), velocity.y());
}

SymmetricMatrix symmetric(const Eigen::Matrix3d& m) {
    return {.xx = m(0, 0), .yy = m(1, 1), .zz = m(2, 2), .xy = m(0, 1), .xz = m(0, 2), .yz = m(1, 2)};
}

} // namespace

Anchor::Anchor(const AnchorDef& def, double extra_mass, const EnvironmentDef& environment,
               const AnchorPose& pose)
    : def_(def),
      shape_(anchor_shape(def)),
      body_(shape_, def.mass + extra_mass, environment),
      dry_mass_(def.mass + extra_mass),
      displaced_mass_(dry_mass_ * environment.water_density / kSteelDensity) {
    set_pose(pose);
    for (const AnchorPart& part : shape_.parts)
        reach_ = std::max(reach_, (part.centre.cwiseAbs() + part.half).norm());
}

AnchorBox Anchor::box(int k) const {
    const AnchorPart& part = shape_.parts[k];
    return {body_.place(part.centre), part.half, pose().attitude.toRotationMatrix()};
}

void Anchor::push(const Vector6& change) {
    soil_change_ += change;
    shackle_velocity_free_ += point_motion(arm_) * change;
}

Vec3 Anchor::shackle() const {
    return body_.place(shape_.shackle);
}

Vec3 Anchor::shackle_velocity() const {
    return point_motion(body_.arm(shape_.shackle)) * body_.motion();
}

double Anchor::clearance(const EnvironmentDef& environment) const {
    return body_.lowest() + environment.depth;
}

double Anchor::submerged() const {
    return submerged_share(pose().position.z(), def_.shank_length);
}

double Anchor::mass() const {
    return body_.mass();
}

double Anchor::weight(const EnvironmentDef& environment) const {
    return (dry_mass_ - submerged() * dry_mass_ * environment.water_density / kSteelDensity) * kGravity;
}

double Anchor::kinetic_energy() const {
    const Vector6 motion = body_.motion();
    return 0.5 * motion.dot(body_.inertia() * motion);
}

double Anchor::potential_energy(const EnvironmentDef& environment) const {
    const double z = pose().position.z(), h = def_.shank_length;
    double submerged_height = 0; // integral of submerged_share() from z upwards
    if (z < -0.5 * h) {
        submerged_height = -z;
    } else if (z < 0.5 * h) {
        submerged_height = (0.5 * h - z) * (0.5 * h - z) / (2 * h);
    }
    return dry_mass_ * kGravity * (z + environment.water_density / kSteelDensity * submerged_height);
}

void Anchor::take_water_along() {
    const double mass_now = dry_mass_ + def_.added_mass * submerged() * displaced_mass_;
    const double mass_was = mass(), energy_was = kinetic_energy();
    if (mass_now != mass_was) {
        body_.set_motion(body_.motion() * (mass_was / mass_now));
        body_.set_mass(mass_now);
    }
    water_entry_loss_ = energy_was - kinetic_energy();
}

void Anchor::drift(const EnvironmentDef& environment, const StepTime& time) {
    // Quadratic drag, implicit as in chain_forces.hpp. Turning is damped by the same area at a quarter of the
    // shank's length.
    Vector6 motion = body_.motion();
    const double share = submerged();
    const Vec3 current = share > 0 ? current_at(environment, pose().position.z()) : Vec3(Vec3::Zero());
    const double drag = 0.5 * environment.water_density * def_.drag_area * share;
    const double damping = drag * (motion.head<3>() - current).norm();
    motion.head<3>() =
        (mass() * motion.head<3>() + time.kick * (damping * current - weight(environment) * Vec3::UnitZ())) /
        (mass() + time.kick * damping);
    drag_force_ = damping * (motion.head<3>() - current);
    const double lever = 0.25 * def_.shank_length;
    const double turning = drag * lever * lever * lever * motion.tail<3>().norm();
    motion.tail<3>() /= 1 + time.kick * turning / (mass() * shape_.inertia_over_mass.maxCoeff());
    body_.set_motion(motion);
}

/// Flukes hold at the crown, and the shank's end rubs with its share of the weight: so that the anchor lies
/// down and turns into the pull as one does that is dragged by its shackle.
void Anchor::hold(const EnvironmentDef& environment, double uplift) {
    holds_ = {Hold{body_.arm(shape_.crown)}, Hold{arm_}};
    if (!on_bottom_) return;
    const double half_width = 0.09 * def_.crown_width;
    const bool lies = shackle().z() + environment.depth < half_width + kTouching;
    const double rubs = lies ? 0.5 * def_.bed_friction * weight(environment) : 0;
    const double flukes = holding_capacity(def_, environment.soil, holding_, uplift);
    const Vector6 motion = body_.motion();
    const auto damping = [&](const Hold& hold, double force) {
        return force / std::max(level_speed(point_motion(hold.arm) * motion), kSoilCreep);
    };
    holds_[0].damping = damping(holds_[0], std::max(0.0, flukes - rubs));
    holds_[1].damping = damping(holds_[1], std::min(rubs, flukes));
}

ChainTail Anchor::begin(const EnvironmentDef& environment, const StepTime& time, double uplift) {
    const Vec3 shackle_before = shackle();
    on_bottom_ = clearance(environment) < kTouching;
    arm_ = body_.arm(shape_.shackle);
    take_water_along();
    motion_before_ = body_.motion();
    const Matrix6 inertia = body_.inertia();
    hold(environment, uplift);
    drift(environment, time);

    // Bullet first: an anchor that the ground has stopped is what the chain then finds at its end. The other
    // way round, the ground would stretch a chain already solved, and create energy.
    const Vector6 free = body_.motion();
    body_.step(time.dt);
    const Vector6 contact = body_.motion() - free;
    contact_loss_ = -0.5 * (inertia * contact).dot(motion_before_ + body_.motion());
    motion_before_ += contact;

    // The soil resists where it holds, level: at most its capacity, whatever the speed.
    Matrix6 held = inertia;
    for (const Hold& hold : holds_) {
        const PointMotion at = point_motion(hold.arm);
        held += time.kick * hold.damping * at.topRows<2>().transpose() * at.topRows<2>();
    }
    yielding_ = held.inverse();
    soil_change_ = yielding_ * (inertia * body_.motion()) - body_.motion();

    const PointMotion at_shackle = point_motion(arm_);
    shackle_inverse_mass_ = symmetric(at_shackle * yielding_ * at_shackle.transpose());
    shackle_velocity_free_ = (shackle() - shackle_before) / time.dt + at_shackle * soil_change_;
    return {shackle_inverse_mass_, shackle_velocity_free_, at_shackle * motion_before_};
}

void Anchor::finish(const StepTime& time, double uplift, const Vec3& shackle_velocity, EnergyLedger* ledger) {
    // The impulse of the chain is what changed the shackle's speed. Bullet has moved the body already; it
    // moves on by what chain and soil add.
    const Vec3 impulse = shackle_inverse_mass_.inverse() * Vec3(shackle_velocity - shackle_velocity_free_);
    body_.add_motion(soil_change_ + yielding_ * (point_motion(arm_).transpose() * impulse), time.dt);

    const Vector6 motion = body_.motion(), mean = 0.5 * (motion_before_ + motion);
    Vec3 soil = Vec3::Zero();
    double soil_work = 0;
    for (const Hold& hold : holds_) {
        const PointMotion at = point_motion(hold.arm);
        Vec3 force = hold.damping * (at * motion);
        force.z() = 0;
        soil += force;
        soil_work += time.kick * force.dot(at * mean);
    }
    soil_force_ = soil.norm();
    const double moved = time.dt * level_speed(point_motion(holds_[0].arm) * mean);
    update_holding(def_, holding_, on_bottom_, moved, time.dt, uplift);
    if (ledger == nullptr) return;
    ledger->anchor_bed += contact_loss_;
    ledger->soil += soil_work;
    ledger->anchor_drag += water_entry_loss_ + time.kick * drag_force_.dot(mean.head<3>());
}

void Anchor::visit_state(StateVisitor& v) {
    WINDLASS_STATE(v, body_, holding_, soil_force_);
}

} // namespace windlass::physics
