#include "server/physics/anchor/anchor.hpp"

#include "server/physics/base/state_limits.hpp"
#include "server/physics/sea/current.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace windlass::physics {

namespace {

/// Flukes dig that point at least so far below the horizontal (sine; 3 degrees).
constexpr double kPointsDown = 0.05;

/// A cable is taut that pulls by so much of the anchor's weight: a third of what drags one that only lies
/// there. Tuned.
constexpr double kTaut = 0.1;

/// Drag of an anchor broadside to the water over that of one that falls crown first: shank, crown and both
/// flukes flat on are 5 m2 of a Hall of 9 900 kg, with the 1.2 of plates and boxes. Proportions tuned, as in
/// anchor_shape.cpp.
constexpr double kBroadside = 2.5;

/// Of a symmetric positive definite matrix, by blocks that have their inverse in closed form: a fifth of what
/// the general one takes.
Matrix6 inverse(const Matrix6& m) {
    const Eigen::Matrix3d upper = m.topLeftCorner<3, 3>().inverse();
    const Eigen::Matrix3d carried = upper * m.topRightCorner<3, 3>();
    const Eigen::Matrix3d lower =
        (m.bottomRightCorner<3, 3>() - m.bottomLeftCorner<3, 3>() * carried).inverse();
    const Eigen::Matrix3d both = -carried * lower;
    Matrix6 inverse;
    inverse << upper - both * carried.transpose(), both, both.transpose(), lower;
    return inverse;
}

/// m, of any box from the centre of mass.
double farthest(const AnchorShape& shape) {
    double reach = 0;
    for (const AnchorPart& part : shape.parts)
        reach = std::max(reach, (part.centre.cwiseAbs() + part.half).norm());
    return reach;
}

SymmetricMatrix symmetric(const Eigen::Matrix3d& m) {
    return {.xx = m(0, 0), .yy = m(1, 1), .zz = m(2, 2), .xy = m(0, 1), .xz = m(0, 2), .yz = m(1, 2)};
}

} // namespace

Anchor::Anchor(const AnchorDef& def, double extra_mass, const EnvironmentDef& environment,
               const AnchorPose& pose)
    : def_(def),
      shape_(anchor_shape(def)),
      dry_mass_(def.mass + extra_mass),
      displaced_mass_(dry_mass_ * environment.water_density / kSteelDensity),
      reach_(farthest(shape_)),
      body_(shape_, dry_mass_, environment),
      flukes_(shape_.flukes, def.mass, environment.water_density) {
    set_pose(pose);
}

AnchorBox Anchor::box(int k) const {
    assert(k >= 0 && k < boxes() && "it has so many boxes");
    const AnchorPart& part = shape_.parts[k];
    const Eigen::Matrix3d axes = body_.axes();
    if (!part.fluke) return {{body_.place(part.centre), part.half, axes}, false};
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(flukes_.angle(), Vec3::UnitY()).toRotationMatrix();
    return {{body_.place(shape_.crown + turn * (part.centre - shape_.crown)), part.half, axes * turn}, true};
}

Vec3 Anchor::fluke_axis() const {
    return body_.axes().col(1);
}

Vec3 Anchor::flukes() const {
    const double angle = flukes_.angle();
    return body_.axes() * Vec3(std::cos(angle), 0, -std::sin(angle));
}

AnchorPoint Anchor::point(const Vec3& at, bool fluke) const {
    return {.arm = at - body_.position(),
            .lever = fluke ? Vec3(fluke_axis().cross(at - pin())) : Vec3(Vec3::Zero())};
}

void Anchor::push(const Vector7& change, double tension) {
    assert(step_.shackle_inverse_mass.xx != 0 && "begin() comes first");
    step_.pushed += change;
    step_.touching = std::max(step_.touching, tension);
    step_.soil_change += change.head<6>();
    step_.shackle_velocity_free += point_motion(step_.arm) * change.head<6>();
}

Vector7 Anchor::free_motion() const {
    Vector7 free;
    free << body_.motion() + step_.soil_change, step_.free_fluke_rate;
    return free;
}

void Anchor::hang(const Vec3& shackle, const Eigen::Quaterniond& attitude) {
    AnchorPose pose;
    pose.attitude = attitude;
    set_pose(pose);
    pose.position = shackle - Anchor::shackle();
    set_pose(pose);
}

void Anchor::hang_at_rest(const Vec3& shackle, const Eigen::Quaterniond& attitude,
                          const EnvironmentDef& environment) {
    hang(shackle, attitude);
    const Vec3 weight_acts =
        body_.position() + flukes_.weight() / weight(environment) * flukes_.shift(body_.axes());
    const Vec3 below = weight_acts - shackle;
    hang(shackle, Eigen::Quaterniond::FromTwoVectors(below, -Vec3::UnitZ()) * attitude);
}

Vec3 Anchor::shackle() const {
    return body_.place(shape_.shackle);
}

Vec3 Anchor::shackle_velocity() const {
    return point_motion(body_.arm(shape_.shackle)) * body_.motion();
}

double Anchor::fastest() const {
    const Vector6 motion = body_.motion();
    return motion.head<3>().norm() + motion.tail<3>().norm() * reach_;
}

double Anchor::clearance(const EnvironmentDef& environment) const {
    return body_.clearance(environment);
}

double Anchor::submerged(const EnvironmentDef& environment) const {
    return submerged_share(body_.position().z() - environment.level, def_.shank_length);
}

double Anchor::mass() const {
    return body_.mass();
}

double Anchor::weight(const EnvironmentDef& environment) const {
    return (dry_mass_ - submerged(environment) * dry_mass_ * environment.water_density / kSteelDensity) *
           kGravity;
}

double Anchor::kinetic_energy() const {
    const Vector6 motion = body_.motion();
    return 0.5 * motion.dot(body_.inertia() * motion); // the flukes' own turn counts with their height
}

double Anchor::potential_energy(const EnvironmentDef& environment) const {
    const double z = body_.position().z(), h = def_.shank_length;
    double submerged_height = 0; // integral of submerged_share() from z upwards
    const double over_surface = z - environment.level;
    if (over_surface < -0.5 * h) {
        submerged_height = -over_surface;
    } else if (over_surface < 0.5 * h) {
        submerged_height = (0.5 * h - over_surface) * (0.5 * h - over_surface) / (2 * h);
    }
    return dry_mass_ * kGravity * (z + environment.water_density / kSteelDensity * submerged_height) +
           flukes_.energy(body_.axes());
}

void Anchor::take_water_along(const EnvironmentDef& environment) {
    const double mass_now = dry_mass_ + kAnchorAddedMass * submerged(environment) * displaced_mass_;
    const double mass_was = mass();
    step_.water_entry_loss = 0;
    if (mass_now == mass_was) return;
    const double energy_was = kinetic_energy();
    body_.set_motion(body_.motion() * (mass_was / mass_now));
    body_.set_mass(mass_now);
    step_.water_entry_loss = energy_was - kinetic_energy();
}

void Anchor::apply_gravity_and_drag(const EnvironmentDef& environment, const StepTime& time) {
    // Quadratic drag, implicit as in chain_forces.hpp, of an area between the two by the square of the
    // cosine. Turning is damped by the broadside at a quarter of the shank's length.
    Vector6 motion = body_.motion();
    const double share = submerged(environment);
    const Vec3 current = share > 0 ? current_at(environment, body_.position().z()) : Vec3(Vec3::Zero());
    const Vec3 through = motion.head<3>() - current;
    const double across = 0.5 * environment.water_density * kBroadside * def_.drag_area * share;
    const double end_on = body_.axes().col(0).dot(through.stableNormalized());
    const double damping = across * (1 - (1 - 1 / kBroadside) * end_on * end_on) * through.norm();
    motion.head<3>() =
        (mass() * motion.head<3>() + time.kick * (damping * current - weight(environment) * Vec3::UnitZ())) /
        (mass() + time.kick * damping);
    step_.drag_force = damping * (motion.head<3>() - current);
    // Turned flukes shift the point where the weight acts, and that of the drag with it: it falls upright.
    const Vec3 shift = flukes_.shift(body_.axes()), load(0, 0, -step_.load);
    step_.drag_moment = -shift.cross(step_.drag_force);
    const Vec3 moment =
        -flukes_.weight() * shift.cross(Vec3::UnitZ()) + step_.drag_moment + step_.crown_arm.cross(load);
    const Matrix6 inertia = body_.inertia();
    motion.head<3>() += time.kick / mass() * load;
    motion.tail<3>() += time.kick * inertia.bottomRightCorner<3, 3>().inverse() * moment;
    const double lever = 0.25 * def_.shank_length;
    const double turning = across * lever * lever * lever * motion.tail<3>().norm();
    const Vec3 spin = motion.tail<3>();
    motion.tail<3>() /= 1 + time.kick * turning / (mass() * shape_.inertia_over_mass.maxCoeff());
    step_.turning_impulse = inertia.bottomRightCorner<3, 3>() * (spin - motion.tail<3>());
    body_.set_motion(motion);
}

/// Flukes that the ship presses on their stop are one with the body.
void Anchor::lie_against_hull(const StepTime& time, const Vector7& start) {
    constexpr double kStopped = 1e15; // kg m2
    Matrix7 mass = Matrix7::Zero();
    mass.topLeftCorner<6, 6>() = body_.inertia() + time.kick * step_.soil;
    mass(6, 6) = flukes_.inertia();
    Vector7 momentum;
    momentum << body_.inertia() * body_.motion(), flukes_.inertia() * flukes_.rate();
    touches_.enter(time, start, mass, momentum);
    if (flukes_.stopped(touches_.turns_flukes())) mass(6, 6) += kStopped;
    step_.yielding = mass.inverse();
    const Vector7 free = step_.yielding * momentum;
    step_.soil_change = free.head<6>() - body_.motion();
    step_.free_fluke_rate = free[6];
}

ChainTail Anchor::begin(const EnvironmentDef& environment, const StepTime& time, const ShacklePull& pull,
                        const EquipmentFaults& causes, const HullSurface* hull) {
    assert(time.dt > 0 && time.kick > 0 && "a step takes time");
    const Vec3 shackle_before = shackle();
    step_.position_before = body_.position();
    step_.on_bottom = touches(environment);
    step_.pull = pull;
    poor_soil_ = causes.soil_poor;
    // Flukes that do not turn do not fall either: they stand in the shank's plane, but where ship or bottom
    // has them turned. As they fall of themselves it would be chance whether such an anchor digs in.
    const bool seized = causes.flukes_seized > 0;
    if (seized && !may_touch_) flukes_.turn_to(0);
    flukes_.seize(seized);
    step_.load = load(environment);
    step_.arm = body_.arm(shape_.shackle);
    step_.crown_arm = body_.arm(shape_.crown);
    catch_what_lies_there(causes);
    step_.pushed.setZero();
    step_.touching = 0;
    take_water_along(environment);
    Vector7 start;
    start << body_.motion(), flukes_.rate();
    touches_.find(*this, time.dt, hull != nullptr ? *hull : HullSurface{});
    const Matrix6 inertia = body_.inertia();
    hold(environment, time);
    apply_gravity_and_drag(environment, time);
    swing_flukes(environment, time);

    // Bullet first: an anchor that the ground has stopped is what the chain then finds at its end. The other
    // way round, the ground would stretch a chain already solved, and create energy.
    const Vector6 free = body_.motion();
    const bool clear = clear_of_bed(environment, time.dt);
    may_touch_ = !clear || touches_.near_ship();
    body_.step(time.dt, clear);
    const Vector6 contact = body_.motion() - free;
    step_.contact_loss = -0.5 * (inertia * contact).dot(start.head<6>() + body_.motion());
    step_.before = start;
    step_.before.head<6>() += contact;

    // The soil resists where it holds, along the bed: at most its capacity, whatever the speed.
    const Matrix6 of_body = inverse(inertia + time.kick * step_.soil);
    step_.yielding.setZero();
    step_.yielding.topLeftCorner<6, 6>() = of_body;
    step_.yielding(6, 6) = 1 / flukes_.inertia();
    step_.soil_change = of_body * (inertia * body_.motion()) - body_.motion();
    step_.free_fluke_rate = flukes_.rate();

    if (!touches_.empty()) lie_against_hull(time, start);

    const PointMotion at_shackle = point_motion(step_.arm);
    step_.shackle_inverse_mass = symmetric(inverse_mass_at({.arm = step_.arm}, step_.yielding));
    step_.shackle_velocity_free = (shackle() - shackle_before) / time.dt + at_shackle * step_.soil_change;
    return {step_.shackle_inverse_mass, step_.shackle_velocity_free, at_shackle * step_.before.head<6>()};
}

Vector7 Anchor::finish(const EnvironmentDef& environment, const StepTime& time, const Vec3& shackle_velocity,
                       EnergyLedger* ledger) {
    assert(step_.shackle_inverse_mass.xx != 0 && "begin() comes first");
    // The impulse of the chain is what changed the shackle's speed. Bullet has moved the body already; it
    // moves on by what chain and soil add.
    const Vec3 impulse =
        step_.shackle_inverse_mass.inverse() * Vec3(shackle_velocity - step_.shackle_velocity_free);
    const Vector7 pulled = pushed_by(impulse, {.arm = step_.arm}, step_.yielding);
    body_.add_motion(step_.soil_change + pulled.head<6>(), time.dt);
    Vector7 after;
    after << body_.motion(), step_.free_fluke_rate + step_.pushed[6] + pulled[6];
    flukes_.set_rate(after[6]);

    const Vec3 crown_goes = point_motion(step_.crown_arm) * body_.motion();
    const Vector7 pushes =
        step_.pushed.isZero(0) ? Vector7::Zero() : Vector7(step_.yielding.ldlt().solve(step_.pushed));
    update_bight({.body = pushes.head<3>() / time.kick,
                  .shackle = impulse / time.kick,
                  .shank = body_.axes().col(0),
                  .touching = step_.touching,
                  .taut = kTaut * def_.mass * kGravity,
                  .slides = bed_friction(environment) - kAnchorBedFriction * step_.pull.lift,
                  .moved = time.dt * std::min(crown_goes.norm(), shackle_velocity.norm()),
                  .dt = time.dt},
                 bight_);

    const Vector6 motion = body_.motion(), mean = 0.5 * (step_.before.head<6>() + motion);
    hull_load_ = touches_.settle(step_.position_before, step_.before, after);
    const double fluke_loss = flukes_.turn(step_.around_flukes, time) +
                              touches_.work_on_flukes(step_.before, after) +
                              0.5 * pushes[6] * (step_.before[6] + after[6]);
    const Vector6 soil = step_.soil * motion;
    const Vec3 resists = along_bed(soil.head<3>());
    soil_force_ = resists.norm();
    driven_.setZero();
    if (step_.on_bottom)
        driven_ = resists + mass() / time.kick * (along_bed(crown_goes) - step_.slides_before);
    const Vec3 crown_speed = point_motion(step_.crown_arm) * mean;
    const Eigen::Matrix3d axes = body_.axes();
    const Vec3 shank(axes(0, 0), axes(1, 0), 0);
    const GroundMotion ground{.touches = step_.on_bottom,
                              .height = height_over_bed(environment, body_.place(shape_.crown)),
                              .moved = time.dt * crown_speed,
                              .shank = shank.norm() > 0 ? Vec3(shank.normalized()) : Vec3::UnitX(),
                              .flukes_down = flukes_.dip(axes) > kPointsDown,
                              .uplift = step_.pull.uplift,
                              .dt = time.dt};
    update_holding(def_, Anchor::soil(environment), ground, holding_);
    // A step in which the soil begins to slide resists by more than it can.
    if (step_.on_bottom)
        bend(std::min(soil_force_, holding_power(environment, step_.pull)),
             std::abs(step_.yaw_damping * motion[5]));
    if (ledger == nullptr) return after;
    ledger->anchor_bed += step_.contact_loss + fluke_loss;
    ledger->soil += time.kick * (soil.dot(mean) + step_.load * crown_speed.z());
    const double drag = step_.drag_force.dot(mean.head<3>()) - step_.drag_moment.dot(mean.tail<3>());
    ledger->anchor_drag +=
        step_.water_entry_loss + time.kick * drag + step_.turning_impulse.dot(mean.tail<3>());
    return after;
}

template <class Visitor, StateOf<Anchor> Self>
void visit_state(Visitor& v, Self& self) {
    WINDLASS_STATE(v, self.body_, self.flukes_, self.holding_, self.bight_, self.soil_force_, self.driven_,
                   self.may_touch_, self.poor_soil_);
    WINDLASS_WITHIN(v, -kStrongest, kStrongest, self.soil_force_, self.driven_);
    WINDLASS_WITHIN(v, 0, 1, self.poor_soil_);
}
WINDLASS_STATE_LISTED(Anchor);

} // namespace windlass::physics
