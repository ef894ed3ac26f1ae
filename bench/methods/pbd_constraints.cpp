#include "bench/methods/pbd_constraints.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

// The arrays do not overlap, nor do the links of one colour.
#define WINDLASS_VECTORISE _Pragma("GCC ivdep")

namespace windlass::lab {

namespace {

constexpr double kPoint = 1e-30; ///< m2, so that a link of no length has a direction: none

double over(double value) {
    return value > 0 ? 1 / value : 0;
}

} // namespace

StretchConstraint::StretchConstraint(int links, double rest, double k_stretch, double k_slack)
    : StretchConstraint(std::vector<double>(links, rest), k_stretch, k_slack) {}

StretchConstraint::StretchConstraint(std::vector<double> rest, double k_stretch, double k_slack)
    : k_stretch_(k_stretch),
      k_slack_(k_slack),
      rest_(std::move(rest)),
      below_(rest_.size()),
      above_(rest_.size()),
      over_sum_(rest_.size()),
      multiplier_(rest_.size()) {}

void StretchConstraint::begin(const std::vector<double>& inverse_mass) {
    std::ranges::fill(multiplier_, 0);
    for (std::size_t i = 0; i < rest_.size(); ++i) {
        over_sum_[i] = over(inverse_mass[i] + inverse_mass[i + 1]);
        below_[i] = inverse_mass[i] * over_sum_[i];
        above_[i] = inverse_mass[i + 1] * over_sum_[i];
    }
}

void StretchConstraint::sweep(Field& places, Order order) {
    switch (order) {
    case Order::upwards:
        return sweep_in_turn<1>(places);
    case Order::downwards:
        return sweep_in_turn<-1>(places);
    case Order::coloured:
        sweep_colour(places, 0);
        return sweep_colour(places, 1);
    }
}

/// What the next link waits for is kept short: the node that both share stays in registers, and length and
/// direction come of one root and one division.
template <int Step>
void StretchConstraint::sweep_in_turn(Field& places) {
    const int n = static_cast<int>(rest_.size());
    const int start = Step > 0 ? 0 : n;
    Vec3 near = places.at(start);
    for (int k = 0; k < n; ++k) {
        const int link = Step > 0 ? k : n - 1 - k;
        const int next = start + Step * (k + 1);
        Vec3 far = places.at(next);
        const Vec3 span = far - near;
        const double size = std::sqrt(span.squaredNorm() + kPoint);
        const double rest = rest_[link];
        const double stiffness = size > rest ? k_stretch_ : k_slack_;
        const double share = stiffness - stiffness * rest / size; // of the span, that both ends come nearer
        const double near_share = Step > 0 ? below_[link] : above_[link];
        const double far_share = Step > 0 ? above_[link] : below_[link];
        near += (near_share * share) * span;
        far -= (far_share * share) * span;
        multiplier_[link] += stiffness * (size - rest) * over_sum_[link];
        places.set(next - Step, near);
        near = far;
    }
    places.set(start + Step * n, near);
}

void StretchConstraint::sweep_colour(Field& places, int first) {
    const int pairs = (static_cast<int>(rest_.size()) - first + 1) / 2;
    double *x = places.x.data() + first, *y = places.y.data() + first, *z = places.z.data() + first;
    const double *rest = rest_.data() + first, *below = below_.data() + first, *above = above_.data() + first;
    const double* over_sum = over_sum_.data() + first;
    double* multiplier = multiplier_.data() + first;
    const double k_stretch = k_stretch_, k_slack = k_slack_;
    WINDLASS_VECTORISE
    for (int k = 0; k < pairs; ++k) {
        const int i = 2 * k;
        const double dx = x[i + 1] - x[i], dy = y[i + 1] - y[i], dz = z[i + 1] - z[i];
        const double size = std::sqrt(dx * dx + dy * dy + dz * dz + kPoint);
        const double stiffness = size > rest[i] ? k_stretch : k_slack;
        const double share = stiffness - stiffness * rest[i] / size;
        const double up = below[i] * share, down = above[i] * share;
        x[i] += up * dx, y[i] += up * dy, z[i] += up * dz;
        x[i + 1] -= down * dx, y[i + 1] -= down * dy, z[i + 1] -= down * dz;
        multiplier[i] += stiffness * (size - rest[i]) * over_sum[i];
    }
}

BendConstraint::BendConstraint(int nodes, double k) : k_(k), inverse_mass_(nodes), gain_(nodes) {}

void BendConstraint::begin(const std::vector<double>& inverse_mass) {
    inverse_mass_ = inverse_mass;
    for (std::size_t i = 1; i + 1 < gain_.size(); ++i) {
        // d = (2 p_i - p_below - p_above) / 3, C = |d|: gradients 2/3, -1/3, -1/3 of d's direction.
        gain_[i] = 3 * k_ * over(4 * inverse_mass[i] + inverse_mass[i - 1] + inverse_mass[i + 1]);
    }
}

void BendConstraint::sweep(Field& places, Order order) {
    if (order != Order::coloured) return sweep_in_turn(places);
    for (int first = 0; first < 3; ++first)
        sweep_colour(places, first);
}

void BendConstraint::sweep_in_turn(Field& places) {
    const int last = static_cast<int>(gain_.size()) - 1;
    Vec3 below = places.at(0), at = places.at(1);
    for (int i = 1; i < last; ++i) {
        Vec3 above = places.at(i + 1);
        const Vec3 move = (gain_[i] / 3) * (2 * at - below - above);
        below += inverse_mass_[i - 1] * move;
        at -= 2 * inverse_mass_[i] * move;
        above += inverse_mass_[i + 1] * move;
        places.set(i - 1, below);
        below = at;
        at = above;
    }
    places.set(last - 1, below);
    places.set(last, at);
}

void BendConstraint::sweep_colour(Field& places, int first) {
    const int triples = static_cast<int>(gain_.size()) - 2;
    const double *w = inverse_mass_.data() + first, *gain = gain_.data() + first + 1;
    const auto one = [&](double* p) {
        WINDLASS_VECTORISE
        for (int i = 0; i < triples - first; i += 3) {
            const double move = (gain[i] / 3) * (2 * p[i + 1] - p[i] - p[i + 2]);
            p[i] += w[i] * move;
            p[i + 1] -= 2 * w[i + 1] * move;
            p[i + 2] += w[i + 2] * move;
        }
    };
    one(places.x.data() + first);
    one(places.y.data() + first);
    one(places.z.data() + first);
}

AngleConstraint::AngleConstraint(int nodes, double k, double rest)
    : k_(k), rest_(rest), inverse_mass_(nodes) {}

void AngleConstraint::sweep(Field& places, Order order) {
    const int last = places.size() - 1;
    switch (order) {
    case Order::upwards:
        for (int i = 1; i < last; ++i)
            project(places, i);
        return;
    case Order::downwards:
        for (int i = last - 1; i > 0; --i)
            project(places, i);
        return;
    case Order::coloured:
        for (int first = 1; first <= 3; ++first)
            for (int i = first; i < last; i += 3)
                project(places, i);
        return;
    }
}

void AngleConstraint::project(Field& places, int node) const {
    const Vec3 below = places.at(node - 1), at = places.at(node), above = places.at(node + 1);
    Vec3 into = at - below, out = above - at;
    const double in_size = into.norm(), out_size = out.norm();
    if (in_size * out_size <= kPoint) return; // a link of no length has no direction
    into /= in_size, out /= out_size;
    const double error = bend_angle(places, node) - rest_;
    if (error == 0) return;

    // The angle's gradients, in the plane of the bend and square to each link.
    Vec3 axis = into.cross(out);
    const double sine = axis.norm();
    axis = sine > 1e-9 ? Vec3(axis / sine)
                       : into.cross(std::abs(into.y()) < 0.9 ? Vec3::UnitY() : Vec3::UnitX()).normalized();
    const Vec3 from_below = axis.cross(into) / in_size, from_above = axis.cross(out) / out_size;

    const Vec3 at_gradient = -from_below - from_above;
    const double* w = inverse_mass_.data() + node;
    const double weight =
        w[-1] * from_below.squaredNorm() + w[0] * at_gradient.squaredNorm() + w[1] * from_above.squaredNorm();
    const double share = k_ * error * over(weight);
    places.set(node - 1, below - share * w[-1] * from_below);
    places.set(node, at - share * w[0] * at_gradient);
    places.set(node + 1, above - share * w[1] * from_above);
}

double bend_angle(const Field& places, int node) {
    const Vec3 into = places.at(node) - places.at(node - 1), out = places.at(node + 1) - places.at(node);
    return std::atan2(into.cross(out).norm(), into.dot(out));
}

void LongRangeAttachment::sweep(Field& places, const Vec3& hawse,
                                const std::vector<double>& inverse_mass) const {
    const int n = static_cast<int>(reach_.size());
    double *x = places.x.data(), *y = places.y.data(), *z = places.z.data();
    const double hx = hawse.x(), hy = hawse.y(), hz = hawse.z(), k = k_;
    const double *reach = reach_.data(), *w = inverse_mass.data();
    WINDLASS_VECTORISE
    for (int i = 0; i < n; ++i) {
        const double dx = x[i] - hx, dy = y[i] - hy, dz = z[i] - hz;
        const double size = std::sqrt(dx * dx + dy * dy + dz * dz + kPoint);
        const double share = size > reach[i] && w[i] > 0 ? k - k * reach[i] / size : 0;
        x[i] -= share * dx, y[i] -= share * dy, z[i] -= share * dz;
    }
}

void LongRangeAttachment::hold(Vec3& place, const Vec3& hawse, double reach) const {
    const Vec3 span = place - hawse;
    const double size = span.norm();
    if (size > reach) place -= k_ * (1 - reach / size) * span;
}

void pin(Pinned& particle, Pinned& body, double k) {
    const double share = k * over(particle.inverse_mass + body.inverse_mass);
    const Vec3 gap = body.place - particle.place;
    particle.place += share * particle.inverse_mass * gap;
    body.place -= share * body.inverse_mass * gap;
}

void damp_pin(Vec3& particle_velocity, double particle_inverse_mass, Vec3& body_velocity,
              double body_inverse_mass, double share) {
    const Vec3 impulse =
        share * over(particle_inverse_mass + body_inverse_mass) * (body_velocity - particle_velocity);
    particle_velocity += particle_inverse_mass * impulse;
    body_velocity -= body_inverse_mass * impulse;
}

} // namespace windlass::lab
