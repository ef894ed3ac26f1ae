// The chain against nature: statics, catenary, modes, momentum.

#include "tests/physics/solver/chain_rig.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace windlass::physics {
namespace {

TEST(Chain, TopTensionEqualsWeightBelow) {
    // 100 m in deep water with a 9.9 t anchor's weight at its end. The tension of a link is that of its
    // middle.
    const ChainDef def = stud_link_chain(0.078, Grade::k3, 330);
    ChainRig rig(def, still_water(1000), {0, 0, -110}, {0, 0, -10}, 100, Foot::hanging, 9900);
    rig.run(30, 1.0 / 240);
    const double weight = weight_in_water(def, kSeaWaterDensity);
    const double anchor = 9900 * kGravity;
    EXPECT_NEAR(rig.top_tension() / (anchor + 99.5 * weight), 1, 1e-4); // bar 1e-3; what is left is ringing
    EXPECT_NEAR(rig.state.tension[0] / (anchor + 0.5 * weight), 1, 1e-4);
}

/// Closed form of the elastic catenary with its foot level: s metres of unstretched chain from the foot,
/// under the horizontal pull H, with weight w per metre and stiffness EA (Irvine, Cable Structures, 1981): x
/// = H s / EA + H / w asinh(s w / H), z = w s^2 / 2 EA + hypot(H / w, s) - H / w, T = hypot(H, w s).
struct Catenary {
    double horizontal, weight, stiffness;
    double tension(double s) const { return std::hypot(horizontal, weight * s); }
    Vec3 at(double s) const {
        const double a = horizontal / weight;
        return {horizontal * s / stiffness + a * std::asinh(s / a), 0,
                0.5 * weight * s * s / stiffness + std::hypot(a, s) - a};
    }
};

class CatenaryTest : public testing::TestWithParam<double> {};

TEST_P(CatenaryTest, HangsAsTheClosedForm) {
    // The table of 78 mm chain in 40 m, H 100 to 800 kN.
    ChainDef def = stud_link_chain(0.078, Grade::k3, 330);
    const double weight = weight_in_water(def, kSeaWaterDensity), height = 40;
    const Catenary catenary{GetParam(), weight, def.stiffness};
    const double length = std::sqrt(height * height + 2 * height * GetParam() / weight);
    def.node_spacing = length / 200;
    const EnvironmentDef sea = still_water(1000);
    const Vec3 foot(0, 0, -100);
    ChainRig rig(def, sea, foot, foot + catenary.at(length), length, Foot::fixed);
    // Start from a shape that is 0.2 m out in the middle, and let water and time settle it.
    for (int i = 0; i <= rig.state.links; ++i) {
        const double s = length * i / rig.state.links;
        rig.state.position.set(i, foot + catenary.at(s) +
                                      Vec3(0, 0.2 * std::sin(std::numbers::pi * i / rig.state.links), 0));
    }
    rig.run(120, 1.0 / 120);

    // The top link's tension is that of its middle.
    EXPECT_NEAR(rig.top_tension() / catenary.tension(length - 0.5 * def.node_spacing), 1, 1e-3);
    double worst = 0;
    for (int i = 0; i <= rig.state.links; ++i) {
        const Vec3 expected = foot + catenary.at(length * i / rig.state.links);
        worst = std::max(worst, (rig.state.position.at(i) - expected).norm());
    }
    EXPECT_LT(worst / height, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(HorizontalPull, CatenaryTest, testing::Values(1e5, 2e5, 4e5, 8e5));

/// Angular frequency (rad/s) at which a hanging chain of length L swings in mode n, from the model.
double modelled_frequency(int mode, double root) {
    const double length = 100;
    const int links = 200;
    ChainDef def = stud_link_chain(0.078, Grade::k3, 330);
    def.node_spacing = length / links;
    ChainRig rig(def, in_air(), {0, 0, -length}, {0, 0, 0}, length, Foot::hanging);
    std::vector<double> shape(links + 1);
    for (int i = 0; i <= links; ++i) {
        // Mode shape J0(j0n sqrt(s / L)), s from the free end.
        shape[i] = std::cyl_bessel_j(0.0, root * std::sqrt(double(i) / links));
        rig.state.position.x[i] = 1e-3 * length * shape[i];
    }
    shape[links] = 0;
    // The zero crossings of the modal coordinate over ten periods.
    const double dt = 1.0 / 480;
    double before = 0, first = 0, last = 0;
    int crossings = 0;
    for (int k = 1; crossings < 21 && k * dt < 400; ++k) {
        rig.step(dt);
        double now = 0;
        for (int i = 0; i <= links; ++i)
            now += shape[i] * rig.state.position.x[i];
        if (k > 1 && (before > 0) != (now > 0)) {
            const double when = (k - now / (now - before)) * dt;
            if (crossings == 0) first = when;
            last = when;
            ++crossings;
        }
        before = now;
    }
    EXPECT_EQ(crossings, 21) << "mode " << mode;
    return std::numbers::pi * (crossings - 1) / (last - first);
}

/// Ticks of 1/240 s in the k-th step.
using TicksOfStep = std::function<int(int k)>;

class ChangingSteps : public testing::TestWithParam<TicksOfStep> {};

TEST_P(ChangingSteps, LeaveAHangingChainInPeace) {
    // Links far too stiff for such steps, let go unstretched: the anchor bounces, and comes to rest by the
    // chain's structural damping. Weights of the three tensions that did not follow the steps kept it ringing
    // with up to five times the weight below.
    const ChainDef def = stud_link_chain(0.078, Grade::k3, 330);
    ChainRig rig(def, in_air(), {0, 0, -100}, {0, 0, 0}, 100, Foot::hanging, 9900);
    const double second = 240;
    double worst = 0; // of the weight below
    for (int k = 0, tick = 0; tick < 40 * second; ++k) {
        const int ticks = GetParam()(k);
        rig.step(ticks / second);
        tick += ticks;
        if (tick < 20 * second) continue; // the bounce, 21 rad/s, has gone to e^-8
        for (int i = 0; i < rig.state.links; ++i) {
            const double below = rig.tail_weight + i * weight_in_air(def) * def.node_spacing;
            worst = std::max(worst, std::abs(rig.state.tension[i] / below - 1));
        }
    }
    EXPECT_LT(worst, 0.005); // e^-8 of a bounce as high as the weight, and what links do among themselves
}

INSTANTIATE_TEST_SUITE_P(Chain, ChangingSteps,
                         testing::Values([](int) { return 1; }, [](int) { return 3; },
                                         [](int k) { return (k / 7) % 2 == 0 ? 3 : 1; },
                                         [](int k) { return (k * k) % 5 < 2 ? 3 : 1; }));

/// What an anchor that hangs and bounces on undamped chain does in some seconds: m by which it bounces up and
/// down, and N of the top tension that change sign from one step to the next (a sixteenth of its fourth
/// difference, in which what takes twenty steps and more does not count).
struct Bounce {
    double height = 0, rattle = 0;
};
Bounce bounce(ChainRig& rig, double seconds, double dt) {
    double lowest = rig.state.position.z[0], highest = lowest;
    std::vector<double> tensions;
    for (; seconds > 0; seconds -= dt) {
        rig.step(dt);
        lowest = std::min(lowest, rig.state.position.z[0]);
        highest = std::max(highest, rig.state.position.z[0]);
        tensions.push_back(rig.top_tension());
    }
    Bounce seen{.height = highest - lowest};
    for (const double* t = tensions.data(); t + 4 < tensions.data() + tensions.size(); ++t)
        seen.rattle = std::max(seen.rattle, std::abs(t[0] - 4 * t[1] + 6 * t[2] - 4 * t[3] + t[4]) / 16);
    return seen;
}

// Bounces of 21 rad/s, links' own of 3400: Newmark's rule keeps both for good (0.7 to 0.9 of the rattle),
// implicit Euler neither.
TEST(Chain, UndampedLosesItsRattleAndKeepsItsBounce) {
    ChainDef def = stud_link_chain(0.078, Grade::k3, 330);
    def.damping_time = 0;
    for (const double dt : {1.0 / 300, 1.0 / 600}) {
        SCOPED_TRACE(dt);
        ChainRig rig(def, in_air(), {0, 0, -100}, {0, 0, 0}, 100, Foot::hanging, 9900);
        // Let go with half of the stretch that it will hang with, so that no link goes slack.
        const double hangs = 9900 * kGravity + 50 * weight_in_air(def);
        for (double& z : rig.state.position.z)
            z *= 1 + 0.5 * hangs / def.stiffness;
        const Bounce first = bounce(rig, 1, dt);
        rig.run(9, dt);
        const Bounce last = bounce(rig, 1, dt);
        EXPECT_LT(last.rattle / first.rattle, 0.2);
        EXPECT_NEAR(last.height / first.height, 1, 0.02); // faster waves of the chain beat with it
    }
}

TEST(Chain, SwingsInTheModesOfAHangingChain) {
    // omega_n = j0n / 2 sqrt(g / L), j0n the zeros of the Bessel function J0.
    const double roots[] = {2.404825557695773, 5.520078110286311, 8.653727912911013};
    for (int mode = 1; mode <= 3; ++mode) {
        const double expected = 0.5 * roots[mode - 1] * std::sqrt(kGravity / 100);
        EXPECT_NEAR(modelled_frequency(mode, roots[mode - 1]) / expected, 1, 1e-3) << "mode " << mode;
    }
}

} // namespace
} // namespace windlass::physics
