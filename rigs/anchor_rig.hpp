#pragma once
// An anchor let go, dug in and pulled as a ship pulls it, and what it then holds: of the tests and of the
// tables of docs/acceptance.md.

#include "rigs/tackle_rig.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::rigs {

/// Let go and paid out as the hull falls away, then pulled slowly until the flukes are in. Cable in m.
inline TackleRig dug_in(physics::AnchorType type, physics::Soil soil, double cable) {
    physics::EnvironmentDef environment = quiet_water(25);
    physics::lay_bed(environment, soil);
    physics::TackleSetup setup;
    setup.anchor = physics::typical_anchor(type);
    TackleRig rig(setup, environment);
    rig.levers.brake = 0;
    rig.lip_velocity = {0.4, 0, 0};
    rig.run_until([&] { return rig.windlass().cable_out > 35; }, 60);
    rig.lip_velocity = {0.8, 0, 0};
    rig.run_until(
        [&] {
            rig.grip(rig.windlass().cable_out > 35 + rig.lip.x() ? 0.1 : 0);
            return rig.windlass().cable_out > cable;
        },
        600);
    rig.levers.brake = 1;
    rig.lip_velocity = {0.15, 0, 0};
    rig.run_until([&] { return rig.tackle.anchor().holding().embedment > 0.99; }, 900);
    return rig;
}

/// Hove in to a length (m), the lip coming up so that the cable hangs slack and the anchor is left as it
/// lies.
inline bool hove_in(TackleRig& rig, double cable) {
    rig.lip_velocity.setZero();
    rig.levers.clutch_in = true;
    if (!rig.run_until([&] { return rig.windlass().clutch.position == physics::Clutch::in; }, 60))
        return false;
    rig.levers.brake = 0;
    rig.levers.speed = 1;
    const double height = rig.lip.z() + rig.environment.depth;
    const auto come_up = [&] {
        const double out = rig.windlass().cable_out;
        const double slack = rig.tackle.anchor().shackle().x() + 0.9 * std::sqrt(out * out - height * height);
        rig.lip_velocity.x() = std::clamp(slack - rig.lip.x(), -0.5, 0.0);
        return out < cable;
    };
    const bool done = rig.run_until(come_up, 900);
    rig.levers.brake = 1;
    rig.levers.speed = 0;
    rig.lip_velocity.setZero();
    return done;
}

/// What ground tackle holds, N, level.
struct Held {
    double anchor = 0; ///< closed form: its weight in air times the soil's factor, times the share of uplift
    double cable = 0;  ///< closed form: weight in water of what lies on the bottom, times the bed's friction
    double measured = 0; ///< at the hawse pipe
    double uplift = 0;   ///< rad, at the shackle, simulated
    double closed_form() const { return anchor + cable; }
};

inline double level_pull(const TackleRig& rig) {
    const physics::Vec3 lead = rig.tackle.cable_direction();
    return rig.deck().hawse_tension * std::hypot(lead.x(), lead.y());
}

/// A Hall anchor dug in with so much cable (m) that its shank lies flat.
inline Held held_flat(physics::Soil soil, double cable) {
    const TackleRig rig = dug_in(physics::AnchorType::hall, soil, cable);
    const physics::ChainState& chain = rig.tackle.chain();
    double lying = 0; // m
    for (int i = 0; i < chain.links; ++i)
        if (0.5 * (chain.position.z[i] + chain.position.z[i + 1]) < -rig.environment.depth + 0.1)
            lying += physics::link_length(rig.setup.chain, chain, i);
    return {.anchor =
                rig.setup.anchor.mass * physics::kGravity * physics::holding_factor(rig.setup.anchor, soil),
            .cable = physics::weight_in_water(rig.setup.chain, physics::kSeaWaterDensity) *
                     rig.environment.bed_friction * lying,
            .measured = level_pull(rig),
            .uplift = rig.tackle.uplift(rig.environment)};
}

/// A length of cable, and by closed form its angle at the anchor when that begins to drag and what holding is
/// left then.
struct ShortCable {
    double cable;   ///< m, with the hawse pipe 31 m over the bed
    double degrees; ///< by the catenary of that length whose level pull is what the anchor holds then
    double share;   ///< of what it holds with its shank flat: practice, see uplift_share()
};
inline constexpr ShortCable kShortCables[] = {{104, 5, 0.75}, {70, 15, 0.5}, {45.5, 30, 0.2}};

/// The same anchor dug in in sand, hove short and pulled until it drags: its largest hold. Embedment too
/// small, or cable not in: nothing is held.
inline Held held_short(const ShortCable& shortened) {
    TackleRig rig = dug_in(physics::AnchorType::hall, physics::Soil::sand, 165);
    Held held{.anchor = shortened.share * rig.setup.anchor.mass * physics::kGravity *
                        physics::holding_factor(rig.setup.anchor, physics::Soil::sand)};
    if (!hove_in(rig, shortened.cable) || rig.tackle.anchor().holding().embedment < 0.98) return held;
    rig.lip_velocity = {0.05, 0, 0};
    for (int second = 0; second < 240; ++second) {
        rig.run(1);
        if (level_pull(rig) < held.measured) continue;
        held.measured = level_pull(rig);
        held.uplift = rig.tackle.uplift(rig.environment);
    }
    return held;
}

} // namespace windlass::rigs
