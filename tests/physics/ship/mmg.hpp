#pragma once
// KVLCC2 by the MMG standard method, whose polynomials hold for small drift at speed alone: what the server's
// hull is held against. H. Yasukawa, Y. Yoshimura (2015), doi 10.1007/s00773-014-0293-y.

#include "tests/physics/ship/manoeuvre.hpp"

namespace windlass::physics {

class MmgKvlcc2 {
public:
    /// resistance: coefficient, 0.022 of the model, 0.0095 of the ship. Runs at the revolutions that keep up
    /// the speed (m/s).
    MmgKvlcc2(double resistance, double speed) : resistance_(resistance) {
        double low = 0.3, high = 5;
        while (high - low > 1e-9) {
            turns_ = 0.5 * (low + high);
            const double wanted = kUnit * resistance_ * speed * speed;
            (1 - kDeduction) * thrust(speed * (1 - kWake)) < wanted ? low = turns_ : high = turns_;
        }
    }

    void step(double rudder, double dt, TrialMotion& m) const {
        const TrialMotion first = change(rudder, m);
        const TrialMotion half{m.u + 0.5 * dt * first.u, m.v + 0.5 * dt * first.v, m.r + 0.5 * dt * first.r};
        const TrialMotion middle = change(rudder, half);
        m.u += dt * middle.u, m.v += dt * middle.v, m.r += dt * middle.r;
    }

private:
    static constexpr double kRho = 1025, kL = 320, kD = 20.8, kUnit = 0.5 * kRho * kL * kD;
    static constexpr double kMass = kRho * 312600, kGravity = 11.2;
    static constexpr double kAddedX = 0.022 * kUnit * kL, kAddedY = 0.223 * kUnit * kL;
    static constexpr double kInertia = kMass * 80 * 80 + 0.011 * kUnit * kL * kL * kL;
    static constexpr double kPropeller = 9.86, kDeduction = 0.22, kWake = 0.35;

    double coefficient(double inflow) const {
        const double j = inflow / (turns_ * kPropeller);
        return 0.2931 - 0.2753 * j - 0.1385 * j * j;
    }
    double thrust(double inflow) const {
        return kRho * turns_ * turns_ * std::pow(kPropeller, 4) * coefficient(inflow);
    }

    TrialMotion change(double rudder, const TrialMotion& m) const {
        const double speed = std::hypot(m.u, m.v), v = m.v / speed, r = m.r * kL / speed;
        const double drift = std::atan2(-m.v, m.u), q = kUnit * speed * speed;
        double x = q * (-resistance_ - 0.040 * v * v + 0.002 * v * r + 0.011 * r * r + 0.771 * v * v * v * v);
        double y = q * (-0.315 * v + 0.083 * r - 1.607 * v * v * v + 0.379 * v * v * r - 0.391 * v * r * r +
                        0.008 * r * r * r);
        double n = q * kL *
                   (-0.137 * v - 0.049 * r - 0.030 * v * v * v - 0.294 * v * v * r + 0.055 * v * r * r -
                    0.013 * r * r * r);
        const double at_propeller = drift + 0.48 * r, most = at_propeller > 0 ? 1.6 : 1.1;
        const double share = (1 - kWake) * (1 + (1 - std::exp(-2 * std::abs(at_propeller))) * (most - 1));
        const double inflow = share * m.u, pushed = thrust(inflow);
        x += (1 - kDeduction) * pushed;
        const double at_rudder = drift + 0.710 * r,
                     across = speed * (at_rudder < 0 ? 0.395 : 0.640) * at_rudder;
        const double jet = 8 * pushed / (kRho * std::numbers::pi * kPropeller * kPropeller);
        const double race = inflow + 0.50 * (std::sqrt(inflow * inflow + jet) - inflow);
        const double in_race = kPropeller / 15.8;
        const double along = 1.09 * std::sqrt(in_race * race * race + (1 - in_race) * inflow * inflow);
        const double normal = 0.5 * kRho * 112.5 * 2.747 * (along * along + across * across) *
                              std::sin(rudder - std::atan2(across, along));
        x -= (1 - 0.387) * normal * std::sin(rudder);
        y -= (1 + 0.312) * normal * std::cos(rudder);
        n += (0.5 + 0.312 * 0.464) * kL * normal * std::cos(rudder);
        // Mass and added mass, the centre of gravity forward of midships.
        x += (kMass + kAddedY) * m.v * m.r + kGravity * kMass * m.r * m.r;
        y -= (kMass + kAddedX) * m.u * m.r;
        n -= kGravity * kMass * m.u * m.r;
        const double a = kMass + kAddedY, b = kGravity * kMass, c = kInertia + kGravity * kGravity * kMass;
        const double det = a * c - b * b;
        return {x / (kMass + kAddedX), (c * y - b * n) / det, (a * n - b * y) / det};
    }

    double resistance_, turns_ = 0;
};

} // namespace windlass::physics
