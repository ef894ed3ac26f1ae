#include "server/physics/anchor/anchor_meeting.hpp"

#include <cmath>

namespace windlass::physics {

namespace {

/// A meganewton presses them in by a centimetre, the plating by three. N/m; tuned.
constexpr double kSteel = 1e8;

/// m, that the spring counts at most, which is 5 MN: anchors that begin in each other are not thrown apart,
/// but part with k d / c, 2 m/s.
constexpr double kMaxPressed = 0.05;

/// Of critical damping for the lighter anchor, and Coulomb's coefficient, as of chain on an anchor; tuned.
constexpr double kDamping = 1, kFriction = 0.4;

/// m/s, that no point of an anchor exceeds.
double fastest(const Anchor& anchor) {
    const Vector6 motion = anchor.motion();
    return motion.head<3>().norm() +
           (motion.tail<3>().norm() + std::abs(anchor.fluke_rate())) * anchor.reach();
}

Vector7 motion(const Anchor& anchor) {
    Vector7 motion;
    motion << anchor.motion(), anchor.fluke_rate();
    return motion;
}

/// What a push there finds: flukes that it presses on their stop are one with the body.
AnchorPoint point(const EnvironmentDef& environment, const Anchor& anchor, bool fluke, const Vec3& at,
                  const Vec3& push) {
    const AnchorPoint point = anchor.point(at, fluke);
    return fluke && anchor.stopped(environment, point, push) ? AnchorPoint{.arm = point.arm} : point;
}

} // namespace

bool anchors_near(const Anchor& a, const Anchor& b, double distance) {
    const double reach = a.reach() + b.reach() + distance;
    return (a.pose().position - b.pose().position).squaredNorm() < reach * reach;
}

void find_anchor_meetings(const EnvironmentDef& environment, const Anchor& a, const Anchor& b, double dt,
                          PairContacts& ties) {
    const double room = dt * (fastest(a) + fastest(b));
    if (!anchors_near(a, b, room)) return;
    const double damping = 2 * kDamping * std::sqrt(kSteel * std::min(a.mass(), b.mass()));
    const Vector7 motion_a = motion(a), motion_b = motion(b);
    for (int i = 0; i < a.boxes(); ++i) {
        const AnchorBox one = a.box(i);
        for (int j = 0; j < b.boxes(); ++j) {
            const AnchorBox other = b.box(j);
            const BoxSeparation met = separation(one, other, room);
            if (met.distance > room) continue;
            const AnchorPoint on_a = point(environment, a, one.fluke, met.point, met.normal),
                              on_b = point(environment, b, other.fluke, met.point, -met.normal);
            const double parting =
                met.normal.dot(point_velocity(on_a, motion_a) - point_velocity(on_b, motion_b));
            if (met.distance + dt * parting > 0) continue;
            ties.add({.normal = met.normal,
                      .penetration = std::min(-met.distance, kMaxPressed),
                      .stiffness = kSteel,
                      .damping = damping,
                      .friction = kFriction,
                      .cable_a = 0,
                      .cable_b = 1,
                      .body_a = Body::anchor,
                      .body_b = Body::anchor,
                      .on_a = on_a,
                      .on_b = on_b});
        }
    }
}

} // namespace windlass::physics
