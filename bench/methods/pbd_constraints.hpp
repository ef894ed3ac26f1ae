#pragma once
// The constraints of position-based dynamics, each as one sweep that takes away a share of its error.
// Sources: Mueller, Heidelberger, Hennix, Ratcliff (2007), "Position based dynamics", J. Visual Communication
// and Image Representation 18(2), equations 9 (projection weighted by inverse masses) and 10, 11 (distance);
// Kelager, Niebe, Erleben (2010), "A triangle bending constraint model for position-based dynamics", VRIPHYS,
// for the bend by distance; Kim, Chentanez, Mueller (2012), "Long range attachments", SCA, for the
// attachment. All in one chain: Jiang, Ren, He (2020), doi 10.1371/journal.pone.0237563.
//
// Places in m, inverse masses in 1/kg (0: held), stiffness k a share 0..1 of the error: after n sweeps over a
// constraint that stands alone (1 - k)^n of it is left.

#include "bench/methods/lumped_line.hpp"

namespace windlass::lab {

/// In which order a sweep goes.
enum class Order {
    upwards,   ///< from node 0, one after the other: Gauss-Seidel as published
    downwards, ///< to node 0
    coloured   ///< every second (bend: third) constraint at once: Gauss-Seidel in another order, vectorised
};

/// Links as distance constraints.
class StretchConstraint {
public:
    /// rest: m; k_stretch for links that are too long, k_slack for those too short.
    StretchConstraint(int links, double rest, double k_stretch, double k_slack);
    /// The same for links that differ in length, m.
    StretchConstraint(std::vector<double> rest, double k_stretch, double k_slack);

    /// Before the first sweep of a step: forgets the multipliers; takes the inverse masses.
    void begin(const std::vector<double>& inverse_mass);
    void sweep(Field& places, Order order);

    /// Multiplier of a link since begin(), kg m: its mean tension times dt^2.
    double multiplier(int link) const { return multiplier_[link]; }

private:
    template <int Step>
    void sweep_in_turn(Field& places);
    void sweep_colour(Field& places, int first);

    double k_stretch_, k_slack_;
    std::vector<double> rest_, below_, above_; ///< m; inverse masses over their sum, of the lower, upper node
    std::vector<double> over_sum_;             ///< kg, inverse of the sum of inverse masses
    std::vector<double> multiplier_;
};

/// Bends of three neighbours: the distance of the middle one from their centroid; straight at rest.
class BendConstraint {
public:
    BendConstraint(int nodes, double k);
    void begin(const std::vector<double>& inverse_mass);
    void sweep(Field& places, Order order);

private:
    void sweep_in_turn(Field& places);
    void sweep_colour(Field& places, int first);

    double k_;
    std::vector<double> inverse_mass_, gain_; ///< gain of the triple below, at and above node i
};

/// Bends of three neighbours by the angle between their links: theta - theta_0, theta 0 where the chain is
/// straight, along its exact gradients. The other form of bending of Jiang, Ren, He (2020), equation 11,
/// after the angle between two triangles of Mueller and others (2007), section 4.1. The angle has no sign:
/// bends to either side are alike, and a straight chain takes its rest angle in a zigzag. Where an angle has
/// no plane (a straight chain that is to bend, a folded one) one that stands still in the world is taken.
class AngleConstraint {
public:
    /// k as for the others; rest: rad, 0 to pi.
    AngleConstraint(int nodes, double k, double rest);
    void begin(const std::vector<double>& inverse_mass) { inverse_mass_ = inverse_mass; }
    void sweep(Field& places, Order order);

private:
    void project(Field& places, int node) const;

    double k_, rest_;
    std::vector<double> inverse_mass_;
};

/// rad, between the links below and above a node; 0: straight.
double bend_angle(const Field& places, int node);

/// No particle further from the hawse than the chain between them is long.
class LongRangeAttachment {
public:
    /// reach: m, chain from each node to the hawse.
    LongRangeAttachment(std::vector<double> reach, double k) : reach_(std::move(reach)), k_(k) {}
    /// Moves all but held particles (inverse mass 0).
    void sweep(Field& places, const Vec3& hawse, const std::vector<double>& inverse_mass) const;
    /// The same for one point at the given reach (m).
    void hold(Vec3& place, const Vec3& hawse, double reach) const;

private:
    std::vector<double> reach_;
    double k_;
};

/// A particle pinned to a body: what a pin moves.
struct Pinned {
    Vec3 place = Vec3::Zero();
    double inverse_mass = 0;
};

/// Brings both together by the share k of their distance.
void pin(Pinned& particle, Pinned& body, double k);

/// Takes away the share of their difference in velocity; momentum stays. Velocities m/s.
void damp_pin(Vec3& particle_velocity, double particle_inverse_mass, Vec3& body_velocity,
              double body_inverse_mass, double share);

} // namespace windlass::lab
