// What the ground does to the anchor: how it holds and is held, turns its flukes, fouls and bends it.

#include "server/physics/anchor/anchor.hpp"

#include "server/physics/sea/current.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::physics {

namespace {

/// Speed below which the soil's resistance is viscous, m/s: an anchor held by half its holding power creeps
/// 0.2 m an hour.
constexpr double kSoilCreep = 1e-4;

/// A point of the anchor counts as on the bottom while it is nearer than this, m.
constexpr double kTouching = 0.05;

/// Share of the soil's force on the crown that the tripping palms take, and their lever over the crown's
/// width; tuned.
constexpr double kPalmShare = 0.3, kPalmLever = 0.15;

/// An old cable on the flukes: both parts of a 78 mm chain hang in water from the crown, N for each m of
/// height (1136 N/m each); what holds it on the bottom is twice the anchor's proof load. Tuned.
constexpr double kOldCable = 2 * 1136, kOldCableHolds = 2;

/// Anchors yield above so many times their proof load and are bent all the way at 1.5 times that; tuned.
constexpr double kYield = 1.5, kBentAllTheWay = 1.5;

/// Whether nothing within this reach (m) of its middle can be so near (m) to a level bed: of an anchor that
/// hangs in deep water that says as much as all of its corners. Twice the reach, so that no rounding counts.
bool far_above_bed(const EnvironmentDef& environment, const Vec3& middle, double reach, double near) {
    return !environment.ground && height_over_bed(environment, middle) - 2 * reach > near;
}

} // namespace

Soil Anchor::soil(const EnvironmentDef& environment) const {
    const Vec3 crown = body_.place(shape_.crown);
    return soil_at(environment, crown.x(), crown.y());
}

/// Flukes that are still in hold it while the crown rises.
bool Anchor::touches(const EnvironmentDef& environment) const {
    const bool lies = !far_above_bed(environment, body_.position(), reach_, kTouching) &&
                      clearance(environment) < kTouching;
    return lies || holding_.dug.squaredNorm() > 0;
}

/// Whether no part of it comes near a level bed in a step of dt (s), however it turns.
bool Anchor::clear_of_bed(const EnvironmentDef& environment, double dt) const {
    constexpr double kNear = 0.5; // m; Bullet looks for contacts some centimetres ahead
    const double near = kNear + dt * fastest();
    return far_above_bed(environment, body_.position(), reach_, near) ||
           (!environment.ground && clearance(environment) > near);
}

/// Whatever uplift does to flukes that are in: what is left of the weight on the bed rubs.
double Anchor::holding_power(const EnvironmentDef& environment, const ShacklePull& pull) const {
    const double soil = holding_capacity(def_, Anchor::soil(environment), holding_, pull.uplift, poor_soil_);
    const double rubs = bed_friction(environment) - kAnchorBedFriction * pull.lift;
    return std::max(soil, rubs) + holding_.fouled * kOldCableHolds * def_.proof_load;
}

double Anchor::bed_friction(const EnvironmentDef& environment) const {
    return kAnchorBedFriction * weight(environment);
}

double Anchor::breakout(const EnvironmentDef& environment) const {
    return breakout_capacity(def_, soil(environment), holding_);
}

double Anchor::load(const EnvironmentDef& environment) const {
    if (touches(environment)) return 0;
    const double height = height_over_bed(environment, body_.place(shape_.crown));
    return holding_.ball + holding_.fouled * kOldCable * height;
}

/// Flukes hold at the crown, and the shank's end rubs with its share of the weight: so that the anchor lies
/// down and turns into the pull as one does that is dragged by its shackle. Flukes that are in resist being
/// turned, and being pulled up.
///
/// The soil's force is divided by a speed to make it a damping: along the bed by that of the step's end, as
/// what drove the anchor in the last step, and all that the soil holds, make it of the present one. Divided
/// by the present one, the speed would grow or fall by pull over holding power in every step, however short.
void Anchor::hold(const EnvironmentDef& environment, const StepTime& time) {
    step_.soil.setZero();
    step_.slides_before.setZero();
    step_.yaw_damping = 0;
    const Vec3 pin = body_.place(shape_.crown);
    step_.bed = bed_normal(environment, pin.x(), pin.y());
    if (!step_.on_bottom) return;
    const bool lies = height_over_bed(environment, shackle()) < shape_.shank_half + kTouching;
    const double power = holding_power(environment, step_.pull);
    const double rubs = lies ? std::min(power, 0.5 * bed_friction(environment)) : 0;
    const Vector6 motion = body_.motion();
    const PointMotion crown = point_motion(step_.crown_arm), shank_end = point_motion(step_.arm);
    const auto damping = [](double force, double speed) { return force / std::max(speed, kSoilCreep); };
    step_.slides_before = along_bed(crown * motion);
    const Vec3 unheld = step_.slides_before + time.kick / mass() * driven_;
    const double slides = std::max(0.0, unheld.norm() - time.kick / mass() * power);
    const Vec3 change = slides * unheld.normalized() - step_.slides_before;
    const auto resist = [&](const PointMotion& at, double force, double speed) {
        const PointMotion along = at - step_.bed * (step_.bed.transpose() * at);
        step_.soil += damping(force, speed) * along.transpose() * along;
    };
    resist(crown, power - rubs, slides);
    resist(shank_end, rubs, (along_bed(shank_end * motion) + change).norm());
    const double breakout = Anchor::breakout(environment);
    const Eigen::Matrix<double, 1, 6> out = step_.bed.transpose() * crown;
    step_.soil += damping(breakout, std::abs(out.dot(motion))) * out.transpose() * out;
    const double spread = shape_.flukes.spread, couple = (power - rubs) * spread * holding_.dug.norm();
    step_.yaw_damping = spread * damping(couple / spread, spread * std::abs(motion[5])) * spread;
    step_.soil(5, 5) += step_.yaw_damping;
}

FlukeSurroundings Anchor::around_flukes(const EnvironmentDef& environment) const {
    return {.axes = body_.axes(),
            .pin_height = height_over_bed(environment, body_.place(shape_.crown)),
            .dug = holding_.dug.norm() * def_.fluke_length * std::sin(def_.fluke_angle),
            .submerged = submerged(environment)};
}

/// Gravity drops the flukes to the lower side, the soil's push on the palms helps, and the tips go as deep as
/// they have dug.
void Anchor::swing_flukes(const EnvironmentDef& environment, const StepTime& time) {
    step_.around_flukes = around_flukes(environment);
    const Vec3 pin = body_.place(shape_.crown);
    step_.around_flukes.through =
        point_motion(step_.crown_arm) * body_.motion() - current_at(environment, pin.z());
    if (step_.on_bottom) step_.around_flukes.push = kPalmShare * soil_force_ * kPalmLever * def_.crown_width;
    flukes_.swing(step_.around_flukes, time);
}

/// What lies on the bottom hooks on to flukes that are in it, and stays on until the cause is cleared (hung
/// off and slipped).
void Anchor::catch_what_lies_there(const EquipmentFaults& causes) {
    constexpr double kHooked = 0.2; // dug in so far
    if (causes.anchor_fouled == 0) holding_.fouled = 0;
    if (holding_.dug.norm() > kHooked) holding_.fouled = std::max(holding_.fouled, causes.anchor_fouled);
}

/// along: N, on the flukes; couple: N m, of the flukes on the shank, across it. Bending across is the shank's
/// section at the crown, which the proof test loads by the flukes' lever in its strong plane (0.8: tuned).
void Anchor::bend(double along, double couple) {
    const double lever = 2.0 / 3 * def_.fluke_length * std::sin(std::max(def_.fluke_angle, 0.5));
    const double strain =
        std::max(along / def_.proof_load, couple / (0.8 * def_.proof_load * lever)) / kYield;
    holding_.bent = std::max(holding_.bent, std::clamp((strain - 1) / (kBentAllTheWay - 1), 0.0, 1.0));
}

} // namespace windlass::physics
