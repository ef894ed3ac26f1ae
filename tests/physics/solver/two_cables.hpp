#pragma once
// Two ground tackles that may touch each other, on lips that do as they are told.

#include "rigs/tackle_rig.hpp"
#include "server/physics/tackle/cable_crossing.hpp"

namespace windlass::physics {

inline constexpr double kTick = 1.0 / 300; ///< s

inline TackleSetup held(double cable_out) {
    TackleSetup setup;
    setup.cable_out = cable_out;
    return setup; // brake on
}

/// Two tackles in the hand of the test. Between them nothing is but their contacts.
struct TwoCables {
    EnvironmentDef environment;
    GroundTackle a, b;
    CableCrossing crossing;
    TackleStep of_a, of_b;
    bool touching = true; ///< whether they feel each other
    int finer = 1;        ///< substeps for each that the tauter cable asks for

    TwoCables(const EnvironmentDef& sea, const TackleSetup& setup_a, const Vec3& lip_a,
              const TackleSetup& setup_b, const Vec3& lip_b)
        : environment(sea), a(setup_a, sea, lip_a), b(setup_b, sea, lip_b), crossing(a, b) {
        of_a.lip = lip_a, of_b.lip = lip_b;
        of_a.levers.brake = setup_a.brake, of_b.levers.brake = setup_b.brake;
        a.keep_ledger(), b.keep_ledger();
    }

    /// One tick, as finely as the tauter cable asks for; the lips move at these speeds (m/s).
    void step(const Vec3& speed_a = Vec3::Zero(), const Vec3& speed_b = Vec3::Zero()) {
        const int steps = finer * std::max(a.substeps(kTick, 16), b.substeps(kTick, 16));
        const double dt = kTick / steps;
        for (int k = 0; k < steps; ++k) {
            of_a.lip += dt * speed_a, of_b.lip += dt * speed_b;
            substep(dt);
        }
    }
    void substep(double dt) {
        if (touching) return crossing.step(a, b, environment, dt, of_a, of_b);
        rigs::step_tackle(a, environment, dt, of_a.levers, of_a.causes, of_a.lip);
        rigs::step_tackle(b, environment, dt, of_b.levers, of_b.causes, of_b.lip);
    }
    std::size_t contacts() const { return touching ? crossing.ties().all().size() : 0; }
    double energy() const { return a.energy(environment) + b.energy(environment); }
    double booked() const { return sum(a.ledger()) + sum(b.ledger()); }
};

} // namespace windlass::physics
