// The rigid body by itself.

#include "rigs/tackle_rig.hpp"
#include "server/physics/anchor/anchor_body.hpp"

#include <gtest/gtest.h>

namespace windlass::physics {
namespace {

/// A thrown, tumbling anchor high over the bed after two seconds. clear: said to be.
AnchorPose thrown(bool clear) {
    AnchorDef def;
    AnchorBody body(anchor_shape(def), def.mass, rigs::quiet_water(200));
    AnchorPose pose;
    pose.position = {1, 2, -20};
    pose.attitude = Eigen::Quaterniond(0.9, 0.1, -0.3, 0.2).normalized();
    pose.velocity = {0.3, -0.4, -1.5};
    pose.spin = {0.7, 2.1, -1.3};
    body.set_pose(pose);
    for (int k = 0; k < 600; ++k) {
        body.step(1.0 / 300, clear);
        Vector6 push;
        push << 1e-3, 0, -2e-3, 1e-3, -1e-3, 5e-4;
        body.add_motion(push, 1.0 / 300);
    }
    return body.pose();
}

TEST(AnchorBody, ClearOfTheBedMovesToTheBitAsBulletHasIt) {
    const AnchorPose looked = thrown(false), spared = thrown(true);
    EXPECT_EQ(looked.position, spared.position);
    EXPECT_EQ(looked.velocity, spared.velocity);
    EXPECT_EQ(looked.spin, spared.spin);
    EXPECT_EQ(looked.attitude.coeffs(), spared.attitude.coeffs());
}

TEST(AnchorBody, TumblingFreelyKeepsItsMomentumOfTurning) {
    AnchorDef def;
    AnchorBody body(anchor_shape(def), def.mass, rigs::quiet_water(200));
    AnchorPose pose;
    pose.spin = {0.7, 2.1, -1.3};
    body.set_pose(pose);
    const auto turning = [&] { return Vec3(body.inertia().bottomRightCorner<3, 3>() * body.pose().spin); };
    const Vec3 before = turning();
    for (int k = 0; k < 300; ++k)
        body.step(1.0 / 300, true);
    // A second of tumbling; Bullet's implicit gyroscopic term is of first order.
    EXPECT_LT((turning() - before).norm(), 0.03 * before.norm());
    EXPECT_GT((body.pose().spin - pose.spin).norm(), 0.1); // and it does tumble
}

} // namespace
} // namespace windlass::physics
