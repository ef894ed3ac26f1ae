// An anchor that was found clear of the ship is left alone: what it touches is the same as if it were looked
// at in every step.

#include "server/physics/anchor/anchor.hpp"
#include "server/physics/tackle/ground_tackle.hpp"
#include "server/physics/tackle/hawse_pipe_fit.hpp"
#include "tests/physics/exercise_step.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace windlass::physics {
namespace {

/// What the touches of a step would do to an anchor in its motion.
struct Entered {
    Matrix7 mass = Matrix7::Zero();
    Vector7 momentum = Vector7::Zero();
    bool full = false;

    Entered(HullTouches& touches, const Anchor& anchor) : full(touches.full()) {
        Vector7 motion;
        motion << anchor.motion(), anchor.fluke_rate();
        touches.enter({kStep, kStep}, motion, mass, momentum);
    }
    bool operator==(const Entered&) const = default;
};

/// Swings about the port bow, the anchor's flukes and pitch with it, so that it meets plating, stem, deck and
/// hawse pipe and leaves them again.
AnchorPose swinging(double t, int seed) {
    AnchorPose pose;
    pose.position = Vec3(107 + 6 * std::sin(0.9 * t + seed), 8 + 6 * std::sin(1.3 * t + 2 * seed),
                         6 + 7 * std::sin(0.7 * t + 3 * seed));
    pose.attitude = Eigen::AngleAxisd(2 * std::sin(0.8 * t), Vec3::UnitX()) *
                    Eigen::AngleAxisd(2 * std::sin(0.5 * t + seed), Vec3::UnitY());
    return pose;
}

/// The same with the motion that brings it to where it is a step later.
AnchorPose moving(double t, int seed) {
    AnchorPose pose = swinging(t, seed);
    const AnchorPose next = swinging(t + kStep, seed);
    pose.velocity = (next.position - pose.position) / kStep;
    const Eigen::AngleAxisd turn(next.attitude * pose.attitude.conjugate());
    pose.spin = turn.angle() / kStep * turn.axis();
    return pose;
}

TEST(AnchorDrift, WhatIsLeftAloneTouchesNothing) {
    const ShipDef ship;
    const TackleSetup parts;
    const ObstacleMesh mesh = hull_mesh(ship, parts.chain.contact_diameter);
    const HawsePipe pipe = fit_hawse_pipe(ship, parts.windlass, parts.chain, parts.anchor, mesh, -1);
    HullSurface hull{&mesh, {}, {}, &pipe};
    hull.motion.attitude = Eigen::AngleAxisd(0.7, Vec3::UnitZ());
    hull.motion.position = Vec3(300, -40, 0.5);
    int touching = 0, clear = 0;
    for (int seed = 0; seed < 8; ++seed) {
        Anchor anchor(parts.anchor, 0, {}, {});
        HullTouches remembers;
        for (int k = 0; k < 3000; ++k) {
            AnchorPose pose = moving(k * kStep, seed);
            pose.position = hull.motion.position + hull.motion.attitude * pose.position;
            pose.attitude = hull.motion.attitude * pose.attitude;
            pose.velocity = hull.motion.attitude * pose.velocity;
            pose.spin = hull.motion.attitude * pose.spin;
            anchor.set_pose(pose);
            anchor.turn_flukes(0.7 * std::sin(0.01 * k));
            remembers.find(anchor, kStep, hull);
            HullTouches looks;
            looks.find(anchor, kStep, hull);
            ASSERT_EQ(remembers.empty(), looks.empty()) << seed << ' ' << k;
            ASSERT_EQ(Entered(remembers, anchor), Entered(looks, anchor)) << seed << ' ' << k;
            ++(looks.empty() ? clear : touching);
        }
    }
    EXPECT_GT(touching, 2000);
    EXPECT_GT(clear, 2000);
}

TEST(AnchorDrift, NoPointGoesFartherThanItIsSaidTo) {
    const AnchorDef def;
    const Anchor anchor(def, 0, {}, {});
    const double reach = anchor.reach();
    AnchorDrift drift;
    const AnchorPlace from{Vec3(1, 2, 3), Eigen::Quaterniond(Eigen::AngleAxisd(1.1, Vec3::UnitY())), 0.2};
    drift.mark(from, 100);
    for (int k = 1; k < 200; ++k) {
        const double angle = 0.03 * k;
        const Vec3 axis = Vec3(std::sin(k), std::cos(2 * k), std::sin(3 * k)).normalized();
        const AnchorPlace to{from.centre + 0.01 * k * axis,
                             Eigen::AngleAxisd(angle, axis.unitOrthogonal()) * from.attitude, 0.2};
        const Vec3 farthest = reach * (from.attitude.conjugate() * axis);
        const double gone =
            (to.centre + to.attitude * farthest - from.centre - from.attitude * farthest).norm();
        EXPECT_LE(drift.clear(to, reach), 100 - gone + 1e-9) << k;
        const AnchorPlace turned{from.centre, from.attitude, 0.2 + angle};
        EXPECT_LE(drift.clear(turned, reach), 100 - angle * def.fluke_length) << k;
    }
    // A clear way is no shorter than it is: the same place has all of it.
    EXPECT_EQ(drift.clear(from, reach), 100);
}

/// reach() is said of the flukes in the shank's plane; of others it is relied on, too.
TEST(AnchorDrift, NoAnglesOfFlukesReachFartherThanTheAnchor) {
    for (const AnchorType type : {AnchorType::hall, AnchorType::spek, AnchorType::ac14, AnchorType::hhp,
                                  AnchorType::shhp, AnchorType::stock}) {
        const AnchorDef def = typical_anchor(type, 9900);
        Anchor anchor(def, 0, {}, {});
        for (double angle = -def.fluke_angle; angle <= def.fluke_angle; angle += 0.05) {
            anchor.turn_flukes(angle);
            for (int k = 0; k < anchor.boxes(); ++k) {
                const AnchorBox box = anchor.box(k);
                for (int corner = 0; corner < 8; ++corner) {
                    const Vec3 sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
                    const Vec3 point = box.centre + box.axes * box.half.cwiseProduct(sign);
                    EXPECT_LE((point - anchor.pose().position).norm(), anchor.reach() + 1e-9);
                }
            }
        }
    }
}

} // namespace
} // namespace windlass::physics
