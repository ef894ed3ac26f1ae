// Two cables across each other: they bear on each other, and neither makes momentum nor energy.

#include "rigs/tackle_rig.hpp"
#include "tests/physics/base/bits.hpp"
#include "tests/physics/solver/chain_rig.hpp"
#include "tests/physics/solver/two_cables.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace windlass::physics {
namespace {

Vec3 momentum(const GroundTackle& tackle) {
    const ChainState& chain = tackle.chain();
    const ChainDef& def = tackle.setup().chain;
    Vec3 sum = tackle.anchor().mass() * tackle.anchor().motion().head<3>();
    for (int i = 1; i < chain.links; ++i)
        sum += def.mass_per_metre * node_length(def, chain, i) * chain.velocity.at(i);
    return sum;
}

double weight_in_air_of(const GroundTackle& tackle) {
    const ChainState& chain = tackle.chain();
    const ChainDef& def = tackle.setup().chain;
    double mass = tackle.anchor().mass();
    for (int i = 1; i < chain.links; ++i)
        mass += def.mass_per_metre * node_length(def, chain, i);
    return mass * kGravity;
}

/// The first cable's lip is moved over to beyond the other cable's, m/s.
Vec3 pushed(double time) {
    return time < 4 ? Vec3(1, 0.1, 0) : Vec3(Vec3::Zero());
}

/// Two cables hanging in air, one swung into the other below its lip: what is done to a lip is not booked.
TwoCables colliding() {
    return {in_air(), held(24), {0, 0, 0}, held(15), {1.5, 0.1, -6}};
}

TEST(Crossing, KeepsMomentum) {
    TwoCables rig = colliding();
    double worst = 0;
    std::size_t touched = 0;
    for (int k = 0; k < 300 * 8; ++k) {
        const double dt = kTick / 2;
        const double kick_a = step_kick(rig.a.chain(), dt), kick_b = step_kick(rig.b.chain(), dt);
        const Vec3 before = momentum(rig.a) + momentum(rig.b);
        rig.of_a.lip += dt * pushed(k * dt);
        rig.substep(dt);
        const double weight = kick_a * weight_in_air_of(rig.a) + kick_b * weight_in_air_of(rig.b);
        const Vec3 given =
            -rig.a.last_step().hawse_impulse - rig.b.last_step().hawse_impulse - Vec3(0, 0, weight);
        bool free = !rig.a.last_step().implicit && !rig.b.last_step().implicit;
        for (const PairContact& pair : rig.crossing.ties().all()) { // of the held ends, which take momentum
            free = free && pair.link_a < (pair.cable_a == 0 ? rig.a : rig.b).chain().links - 1;
            free = free && (pair.body_b == Body::anchor || pair.link_b < rig.b.chain().links - 1);
        }
        if (!free) continue;
        touched += rig.contacts();
        worst = std::max(worst, (momentum(rig.a) + momentum(rig.b) - before - given).norm() / weight);
    }
    EXPECT_GT(touched, 100u);
    EXPECT_LT(worst, 1e-9); // as wanted, in each step
}

TEST(Crossing, NeverMakesEnergyAndBooksWhatItTakes) {
    for (const bool water : {false, true}) {
        TwoCables rig{water ? still_water(200) : in_air(), held(24), {0, 0, 0}, held(15), {1.5, 0.1, -6}};
        rig.finer = 4; // the anchors turn at first order
        const double start = rig.energy();
        std::size_t touched = 0;
        double stirred = 0, max = -1e300; // J
        for (int k = 0; k < 300 * 12; ++k) {
            const double before = rig.a.ledger().hull + rig.b.ledger().hull;
            rig.step(pushed(k * kTick));
            touched += rig.contacts();
            stirred += std::abs(rig.a.ledger().hull + rig.b.ledger().hull - before);
            max = std::max(max, rig.energy() - start + rig.booked());
            ASSERT_TRUE(rig.a.finite() && rig.b.finite()) << k;
        }
        EXPECT_GT(touched, 300u);
        EXPECT_GT(rig.a.ledger().contact, 0.05 * stirred);
        EXPECT_LT(max / stirred, 0.005) << water; // one cable hauled about by itself closes to 0.1 %
        EXPECT_NEAR((rig.energy() - start + rig.booked()) / stirred, 0, 0.01) << water;
    }
}

TEST(Crossing, GivesTheSameBitsTwice) {
    const auto run = [] {
        TwoCables rig = colliding();
        for (int k = 0; k < 900; ++k)
            rig.step(pushed(k * kTick));
        return rig.b.chain();
    };
    const ChainState one = run(), other = run();
    EXPECT_EQ(bits(one.position.x), bits(other.position.x));
    EXPECT_EQ(bits(one.velocity.z), bits(other.velocity.z));
}

TEST(Crossing, SeesCablesThatAreNearAndNoneThatAreNot) {
    TwoCables apart{still_water(60), held(40), {0, 0, 6}, held(40), {14, 0, 6}};
    EXPECT_FALSE(apart.crossing.near(apart.a, apart.b, 2)); // anchors of 4 m, lips of 14
    EXPECT_TRUE(apart.crossing.near(apart.a, apart.b, 15));
    TwoCables close{still_water(60), held(40), {0, 0, 6}, held(12), {3.5, 0, 6}};
    EXPECT_TRUE(close.crossing.near(close.a, close.b, 4));
    EXPECT_FALSE(close.crossing.near(close.a, close.b, 0.5));
}

/// Let out 50 m with the lip moving on, then held.
void lay_out(TwoCables& rig, bool first, const Vec3& along) {
    const auto both = [&](const Vec3& speed) {
        rig.step(first ? speed : Vec3::Zero(), first ? Vec3::Zero() : speed);
    };
    TackleStep& mine = first ? rig.of_a : rig.of_b;
    const GroundTackle& tackle = first ? rig.a : rig.b;
    mine.levers.brake = 0;
    while (tackle.windlass().state().cable_out < 25)
        both(Vec3::Zero());
    mine.levers.brake = 1;
    for (int k = 0; k < 300 * 3; ++k)
        both(Vec3::Zero());
    double gone = 0;
    while (gone < 34) { // brake eased and closed, so that it lies straight
        mine.levers.brake = position_of_grip(tackle.windlass().def(),
                                             tackle.windlass().state().cable_out < 24 + gone ? 0 : 0.3);
        both(1.5 * along);
        gone += 1.5 * kTick;
    }
    mine.levers.brake = 1;
    for (int k = 0; k < 300 * 5; ++k)
        both(Vec3::Zero());
}

TEST(Crossing, OneHoveAcrossTheOtherLiftsItAndFeelsItsWeight) {
    double rise[2] = {},
           load[2] = {}; // m; N, mean of three seconds: the cable swings as it comes off the bottom
    for (const bool touching : {false, true}) {
        TwoCables rig{still_water(15), held(8), {0, 0, 6}, held(8), {16, -18, 6}};
        rig.touching = touching;
        lay_out(rig, true, Vec3::UnitX());
        lay_out(rig, false, Vec3::UnitY());
        const auto height_at = [&] { // of the upper cable where it crosses
            double highest = -1e9;
            const ChainState& chain = rig.b.chain();
            for (int i = 0; i <= chain.links; ++i)
                if (std::abs(chain.position.y[i]) < 2) highest = std::max(highest, chain.position.z[i]);
            return highest;
        };
        const double before = height_at();
        for (int k = 0; k < 300 * 20; ++k) {
            rig.step(Vec3(-0.5, 0, 1.2));
            if (k >= 300 * 12 && k < 300 * 15) // later what she bears besides moves her anchor
                load[touching] += rig.a.last_step().top_pull / (300 * 3);
        }
        rise[touching] = height_at() - before;
        if (!touching) continue;
        EXPECT_GT(rig.contacts(), 0u);
    }
    EXPECT_NEAR(rise[0], 0, 0.05);
    EXPECT_GT(rise[1], 1);             // 1.4 m
    EXPECT_GT(load[1] - load[0], 5e3); // 6.3 kN: 5 m of the other's weight
}

TEST(Crossing, ATurnInTheHawseBearsLoad) {
    // Two cables to anchors broad on either bow; the ship swings right round, and then lies back on them.
    // Where they are turned about each other they bear, and hold her shorter than they would side by side.
    double pull[2], pressed = 0;
    for (const bool touching : {false, true}) {
        TwoCables rig{still_water(15), held(8), {-30, 12, 6}, held(8), {-30, -12, 6}};
        rig.touching = touching;
        lay_out(rig, true, Vec3(30, -8, 0) / 34);
        lay_out(rig, false, Vec3(30, 8, 0) / 34);
        const Vec3 middle(0, 0, 6), lip_a = rig.of_a.lip - middle, lip_b = rig.of_b.lip - middle;
        Vec3 moving_a, moving_b;
        for (int k = 1; k <= 300 * 90; ++k) { // once round in 90 s
            const Eigen::AngleAxisd turn(2 * std::numbers::pi * k / (300 * 90), Vec3::UnitZ());
            rig.step((middle + turn * lip_a - rig.of_a.lip) / kTick,
                     (middle + turn * lip_b - rig.of_b.lip) / kTick);
        }
        double sum = 0;
        for (int k = 0; k < 300 * 10; ++k) { // back, by 3 m
            rig.step(Vec3(0.3, 0, 0), Vec3(0.3, 0, 0));
            if (k < 300 * 9) continue;
            sum += (rig.a.pull_on_ship() + rig.b.pull_on_ship()).head<2>().norm() / 300;
            if (touching) pressed += rig.crossing.ties().pressing(); // N, the mean of this second
        }
        pull[touching] = sum;
        ASSERT_TRUE(rig.a.finite() && rig.b.finite());
    }
    EXPECT_GT(pressed, 5e3);           // 20 kN
    EXPECT_GT(pull[1], 1.3 * pull[0]); // 15.4 kN for 8.5
}

} // namespace
} // namespace windlass::physics
