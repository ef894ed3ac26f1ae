#include "server/physics/ship/hull_force.hpp"

#include "server/physics/base/units.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace windlass::physics {

namespace {

// Shares of a turn in the flow across that make side force and moment, of a model of the Esso Osaka: Y.
// Yoshimura, I. Nakao, A. Ishibashi (2009), as identified by Y. Miyauchi and others (2022), doi
// 10.1007/s00773-022-00889-3.
constexpr double kTurnInSide = 2.22, kTurnInMoment = 0.81;
constexpr double kAstern = 1.5; ///< resistance astern over that ahead, of the same model

/// Integrals along the hull of |a| a, |a| a x and |a| a x^2, a = v + c r x: exact.
struct CrossFlow {
    double side = 0;   ///< m3/s2
    double moment = 0; ///< m4/s2
    double second = 0; ///< m5/s2
};
/// at_end: m/s, c r L / 2.
CrossFlow cross_flow(double v, double at_end, double half_length) {
    const double h = half_length;
    if (std::abs(v) >= std::abs(at_end))
        return {std::copysign(2 * h * (v * v + at_end * at_end / 3), v),
                4.0 / 3 * h * h * std::abs(v) * at_end,
                std::copysign(2 * h * h * h * (v * v / 3 + at_end * at_end / 5), v)};
    const double s = v / at_end, square = at_end * std::abs(at_end); // it turns about a place in the hull
    return {square * h * s * (2 + 2.0 / 3 * s * s), square * h * h * (0.5 + s * s - s * s * s * s / 6),
            square * h * h * h * s * (1 + s * s * s * s / 15)};
}

/// 1 / (1 - T/h)^n - T/h: Kijima's form of what shallow water makes of a linear term.
double in_shallow(double draught_over_depth, double n) {
    return std::pow(1 - draught_over_depth, -n) - draught_over_depth;
}

} // namespace

HullCoefficients hull_coefficients(const ShipDef& def) {
    const double length = def.length_pp, beam = def.beam, draught = def.draught;
    const double volume = def.displacement / kSeaWaterDensity, block = volume / (length * beam * draught);
    const double slender = length / beam, flat = draught / beam, thin = draught * length / (beam * beam);
    const double aspect = 2 * draught / length;
    HullCoefficients c;
    c.length = length, c.beam = beam, c.draught = draught, c.block = block;
    c.trim = def.trim / draught;
    c.friction_area = 1.7 * draught * length + volume / draught;

    c.mass = def.displacement;
    c.inertia = c.mass * std::pow(def.gyration_radius * length, 2);
    c.added_surge = 0.01 * c.mass *
                    (0.398 + 11.97 * block * (1 + 3.73 * flat) - 2.89 * block * slender * (1 + 1.13 * flat) +
                     0.175 * block * slender * slender * (1 + 0.541 * flat) - 1.107 * slender * flat);
    c.added_sway = c.mass * (0.882 - 0.54 * block * (1 - 1.6 * flat) - 0.156 * slender * (1 - 0.673 * block) +
                             0.826 * thin * (1 - 0.678 * flat) - 0.638 * block * thin * (1 - 0.669 * flat));
    const double radius =
        0.01 * length * (33 - 76.85 * block * (1 - 0.784 * block) + 3.43 * slender * (1 - 0.63 * block));
    c.added_yaw = c.mass * radius * radius;

    const double surge_share = c.added_surge / (0.5 * kSeaWaterDensity * length * length * draught);
    const double fullness = block * beam / length;
    c.side_drift = -(0.5 * std::numbers::pi * aspect + 1.4 * fullness);
    c.side_yaw = 0.25 * std::numbers::pi * aspect * (1 + 0.8 * c.trim) + surge_share;
    c.turn_drift = -aspect - 0.27 * c.trim * c.side_drift;
    c.side_drift *= 1 + 2.0 / 3 * c.trim;
    c.turn_yaw = (-0.54 * aspect + aspect * aspect) * (1 + 0.3 * c.trim);

    constexpr double kMidship = 0.99; // coefficient of the midship section: 0.98 to 0.995
    c.cross_flow = 0.22 * std::sqrt(kMidship * length / (beam * block));
    return c;
}

HullCoefficients in_depth(const HullCoefficients& deep, double depth) {
    const double share = deep.draught / std::max(depth, 1.1 * deep.draught); // T/h
    const double close = share / (1 - share);                                // T/(h - T)
    HullCoefficients c = deep;
    constexpr double kAground = 3.2; // drag coefficient with no water under the keel
    c.cross_flow += (kAground - deep.cross_flow) * share * share;
    c.added_surge *= 1 + close;
    c.added_sway *= 1 + 0.387 / 1.02 * close;
    constexpr double kYawCloses = 0.037; // laid through 1.02 to 1.37 at 3 to 1.1 draughts
    c.added_yaw = (c.inertia + deep.added_yaw) * (1 + kYawCloses * close) - c.inertia;
    const double full = deep.block * deep.beam / deep.draught;
    c.side_drift *= in_shallow(share, 0.40 * full);
    c.turn_drift *= in_shallow(share, 0.41 * full);
    c.turn_yaw *= in_shallow(share, std::max(0.5, 1.5 - 7.14 * 2 * deep.draught / deep.length));
    return c;
}

double resistance_over_speed(const HullCoefficients& hull, double density, double speed) {
    constexpr double kViscosity = 1.19e-6, kLeastReynolds = 1e6; // m2/s, sea at 15 degC; below: as there
    const double reynolds = std::max(kLeastReynolds, speed * hull.length / kViscosity);
    const double friction = 0.075 / std::pow(std::log10(reynolds) - 2, 2);
    // Form, on B T: 0.1 of a ship that lies in a stream of 1.5 m/s at most (UFC 4-159-03, eq. 16); under way
    // 0.02, which makes 2 MN of a laden VLCC at 15.5 kn. Between them a curve is laid (tuned).
    const double quick = speed * speed / 6.25;
    const double form = 0.02 + 0.08 / (1 + quick * quick);
    return 0.5 * density * (form * hull.beam * hull.draught + friction * hull.friction_area) * speed;
}

PlanarForce hull_force(const HullCoefficients& hull, double density, double u, double v, double r) {
    const double length = hull.length, speed = std::hypot(u, v), turn = r * length, half = 0.5 * length;
    const double ahead = speed > 0 ? u / speed : 1;
    const double unit = 0.5 * density * length * hull.draught;
    const double drag = 0.5 * density * hull.draught * hull.cross_flow;
    PlanarForce force;
    force.x = -resistance_over_speed(hull, density, speed) * u * (1 + 0.5 * (kAstern - 1) * (1 - ahead));
    // Her draught grows from bow to stern: T (1 - t x/L).
    const double deeper = hull.trim / length;
    const CrossFlow side = cross_flow(v, kTurnInSide * r * half, half),
                    round = cross_flow(v, kTurnInMoment * r * half, half);
    force.y = unit * (hull.side_drift * v * std::abs(u) + hull.side_yaw * turn * u) -
              drag * (side.side - deeper * side.moment);
    force.moment = unit * length * (hull.turn_drift * v * u + hull.turn_yaw * turn * std::abs(u)) -
                   drag * (round.moment - deeper * round.second);
    return force;
}

} // namespace windlass::physics
