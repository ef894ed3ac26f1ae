// Contact in the chain's step: what bears, rubs, sticks and lets go, against closed forms.

#include "tests/physics/exercise_step.hpp"
#include "tests/physics/solver/chain_rig.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace windlass::physics {
namespace {

/// Every node between the ends against a plane through the origin.
struct Plane {
    Vec3 normal = Vec3::UnitZ();
    double stiffness = 1e6, friction = 0, adhesion = 0; ///< N/m, -, N: of a node
    double reach = 0.05;                                ///< m above it in which a contact is announced

    void find(const ChainDef& def, const ChainState& chain, ContactSet& set) const {
        for (int i = 1; i < chain.links; ++i) {
            const double height = chain.position.at(i).dot(normal);
            if (height > reach) continue;
            set.add(NodeContact{.node = i,
                                .touch = set.new_touch(),
                                .normal = normal,
                                .penetration = -height,
                                .stiffness = stiffness,
                                .damping = 2 * std::sqrt(stiffness * def.mass_per_metre * def.node_spacing),
                                .friction = friction,
                                .adhesion = adhesion});
        }
    }
};

/// One step of a rig with what the plane does to it.
ContactLoad step_on(ChainRig& rig, const Plane& plane, ContactSet& set, double dt = kStep) {
    set.clear();
    plane.find(rig.def, rig.state, set);
    rig.step(dt, &set);
    return set.settle(rig.state);
}

const ChainDef kChain = stud_link_chain(0.078, Grade::k3, 330);

TEST(Contact, FoundButCarryingNothingLeavesTheLoadAsItWas) {
    // A plane just out of reach beside a swinging chain: announced in every step, never touched.
    ChainRig with(kChain, in_air(), {18, 0, -24}, {0, 0, 0}, 30, Foot::hanging, 9900), without = with;
    const Plane plane{.normal = Vec3::UnitY(), .reach = 1};
    ContactSet set(64, 0);
    for (ChainRig* rig : {&with, &without})
        for (int i = 0; i <= rig->state.links; ++i)
            rig->state.position.y[i] += 0.2;
    with.hawse.y() = without.hawse.y() = 0.2;
    for (int k = 0; k < 1500; ++k) {
        step_on(with, plane, set);
        without.step(kStep);
        ASSERT_EQ(set.node_contacts().size(), 29u);
        ASSERT_NEAR(with.top_tension(), without.top_tension(), 1e-6 * 9900 * kGravity);
    }
}

TEST(Contact, BearsTheWeightThatLiesOnIt) {
    // A chain laid along a plane: what the plane bears is the weight of the nodes between its ends.
    ChainRig rig(kChain, in_air(), {0, 0, 0}, {20, 0, 0}, 20.2, Foot::fixed);
    ContactSet set(64, 0);
    ContactLoad load;
    for (int k = 0; k < 3000; ++k)
        load = step_on(rig, {}, set);
    const double weight = 19.1 * weight_in_air(kChain); // half links at the ends hang on these
    EXPECT_EQ(load.borne, 19);
    EXPECT_NEAR(load.impulse.z() / kStep / weight, 1, 0.01); // a little is carried by the two end links
}

/// A chain lying down a slope (rad), let down it at 0.2 m/s by the lip: mean pull at the lip, N.
double pull_on_slope(double slope, double friction, double dt) {
    const Plane plane{.normal = {std::sin(slope), 0, std::cos(slope)}, .friction = friction};
    const Vec3 down(std::cos(slope), 0, -std::sin(slope));
    const double sunk = kChain.mass_per_metre * kGravity * std::cos(slope) / plane.stiffness;
    const Vec3 top = -sunk * plane.normal;
    ChainRig rig(kChain, in_air(), top + 40 * down, top, 40, Foot::hanging, 0);
    rig.tail_weight = 0; // the half link at the foot touches nothing: let it weigh nothing
    ContactSet set(64, 0);
    double sum = 0;
    const long steps = std::lround(6 / dt);
    for (long k = 0; k < steps; ++k) {
        rig.hawse += 0.2 * dt * down;
        step_on(rig, plane, set, dt);
        if (k >= steps / 2) sum += rig.top_tension();
    }
    return sum / static_cast<double>(steps - steps / 2);
}

TEST(Contact, FrictionHoldsBelowItsAngleAndSlidesAbove) {
    const double friction = 0.5, angle = std::atan(friction);
    EXPECT_EQ(pull_on_slope(0.95 * angle, friction, kStep), 0); // it stays, the cable goes slack
    for (const double dt : {1.0 / 120, kStep, 1.0 / 1200}) {
        const double slope = 1.5 * angle;
        const double weight = 39 * weight_in_air(kChain);
        const double expected = weight * (std::sin(slope) - friction * std::cos(slope));
        EXPECT_NEAR(pull_on_slope(slope, friction, dt) / expected, 1, 0.005) << dt;
    }
}

TEST(Contact, AdhesionAddsItsAmountToTheLiftOff) {
    // A chain hanging from the lip, one node of it stuck in the mud; the lip rises slowly until it lets go.
    ChainRig rig(kChain, in_air(), {0, 0, -1.005}, {0, 0, 3.995}, 5, Foot::hanging, 0);
    rig.tail_weight = 0;
    const double adhesion = 2000, stiffness = 1e5;
    ContactSet set(8, 0);
    double held = 0; // top load when it last stuck
    for (int k = 0; k < 3000; ++k) {
        set.clear();
        const double height = rig.state.position.z[1];
        set.add(NodeContact{.node = 1,
                            .touch = set.new_touch(),
                            .penetration = -height,
                            .stiffness = stiffness,
                            .damping = 2 * std::sqrt(stiffness * kChain.mass_per_metre),
                            .adhesion = adhesion});
        rig.hawse.z() += 0.01 * kStep;
        rig.step(kStep, &set);
        if (set.settle(rig.state).borne == 1) held = rig.top_tension();
    }
    // Afterwards the chain hangs free: what the load was above that is what the mud held. 1 %: the lip still
    // rises in the last step that it holds.
    EXPECT_NEAR((held - rig.top_tension()) / adhesion, 1, 0.01);
}

} // namespace
} // namespace windlass::physics
