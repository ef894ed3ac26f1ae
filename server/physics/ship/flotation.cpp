#include "server/physics/ship/flotation.hpp"

#include "server/physics/base/state_limits.hpp"
#include "server/physics/base/units.hpp"
#include "server/physics/ship/wave_response.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace windlass::physics {

namespace {

/// One step of a motion about its rest: acceleration from outside, frequency (rad/s), damping (of critical).
void swing(double push, double frequency, double damping, double dt, double& place, double& rate) {
    rate += dt * (push - frequency * frequency * place - 2 * damping * frequency * rate);
    place += dt * rate;
}

} // namespace

Hydrostatics::Hydrostatics(const ShipDef& def) {
    const double volume = def.displacement / kSeaWaterDensity;
    block = volume / (def.length_pp * def.beam * def.draught);
    const double plane = (1 + 2 * block) / 3;
    waterplane = plane * def.length_pp * def.beam;
    metacentric_radius = (0.1216 * plane - 0.0410) * def.length_pp * std::pow(def.beam, 3) / volume;
    metacentre = def.draught * (5.0 / 6 - block / (3 * plane)) + metacentric_radius;
    const double along = (0.350 * plane * plane - 0.405 * plane + 0.146) * std::pow(def.length_pp, 3);
    trim_stiffness = kSeaWaterDensity * kGravity * along * def.beam;
}

double squat(const ShipDef& def, double depth, double speed) {
    constexpr double kSlow = 1, kWhole = 1.5; // m/s
    const double share = std::clamp((std::abs(speed) - kSlow) / (kWhole - kSlow), 0.0, 1.0);
    if (share == 0) return 0;
    const double block = def.displacement / (kSeaWaterDensity * def.length_pp * def.beam * def.draught);
    const double width = 7.04 / std::pow(block, 0.85);                            // in beams
    const double blockage = def.draught / (width * std::max(depth, def.draught)); // of that width's water
    return share * block * std::pow(blockage, 0.81) * std::pow(knots_from_mps(std::abs(speed)), 2.08) / 20;
}

void step_flotation(const ShipDef& def, const Hydrostatics& hull, double squat, const GroundLift& ground,
                    double dt, Flotation& f) {
    constexpr double kDamping = 0.5, kNothing = 1e-9; // m, rad and their rates
    const auto largest = [&] {
        return std::max({std::abs(f.heave), std::abs(f.heel), std::abs(f.trim), std::abs(f.heave_speed),
                         std::abs(f.heel_rate), std::abs(f.trim_rate)});
    };
    const bool nothing_lifts = ground.bearing == 0 && squat == 0;
    if (nothing_lifts && largest() == 0) return;
    const double weight = def.displacement * kGravity, mass = 2 * def.displacement;
    const double heave_stiffness = kSeaWaterDensity * kGravity * hull.waterplane;
    swing((ground.bearing - heave_stiffness * squat) / mass, std::sqrt(heave_stiffness / mass), kDamping, dt,
          f.heave, f.heave_speed);

    const double gyration = def.gyration_radius * def.length_pp, pitching = mass * gyration * gyration;
    swing(ground.trimming / pitching, std::sqrt(hull.trim_stiffness / pitching), kDamping, dt, f.trim,
          f.trim_rate);

    const double rolls = 2 * std::numbers::pi / roll_period(def); // rad/s
    const double rolling = weight * def.metacentric_height / (rolls * rolls);
    const double wall_sided = 0.5 * weight * hull.metacentric_radius * f.heel * f.heel * f.heel;
    swing((ground.heeling + ground.bearing * hull.metacentre * f.heel - wall_sided) / rolling, rolls,
          def.roll_damping, dt, f.heel, f.heel_rate);
    if (std::abs(f.heel) > kMostHeel) {
        f.heel = std::copysign(kMostHeel, f.heel);
        f.heel_rate = 0;
    }
    // Afloat and at rest again she floats as she did, to the bit.
    if (nothing_lifts && largest() < kNothing) f = {};
}

template <class Visitor, StateOf<Flotation> State>
void visit_state(Visitor& v, State& flotation) {
    auto& [heave, heel, trim, heave_speed, heel_rate, trim_rate] = flotation;
    WINDLASS_STATE(v, heave, heel, trim, heave_speed, heel_rate, trim_rate);
    constexpr double kHighest = 100; // m, and m/s: more than any tide leaves her
    constexpr double kMostRate = 10; // rad/s
    v.within({"heave"}, heave, -kHighest, kHighest);
    v.within({"heel"}, heel, -kMostHeel, kMostHeel);
    v.within({"trim"}, trim, -kMostHeel, kMostHeel);
    WINDLASS_WITHIN(v, -kHighest, kHighest, heave_speed);
    WINDLASS_WITHIN(v, -kMostRate, kMostRate, heel_rate, trim_rate);
}
WINDLASS_STATE_LISTED(Flotation);

} // namespace windlass::physics
