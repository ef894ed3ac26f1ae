// Each constraint of the PBD baseline alone against its closed form.

#include "bench/methods/pbd_constraints.hpp"
#include "bench/methods/pbd_self_collision.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace windlass::lab {
namespace {

constexpr double kRounding = 1e-12;

Field places_of(const std::vector<Vec3>& points) {
    Field field(static_cast<int>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i)
        field.set(static_cast<int>(i), points[i]);
    return field;
}

/// A chain of n nodes that wanders about in space, its links between 0.3 and 1.7 m.
Field wandering(int n) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> some(-1, 1);
    Field field(n);
    Vec3 at = Vec3::Zero();
    for (int i = 0; i < n; ++i) {
        field.set(i, at);
        at += Vec3(1 + 0.7 * some(random), 0.1 * some(random), 0.1 * some(random));
    }
    return field;
}

std::vector<double> masses(int n) {
    std::vector<double> inverse;
    for (int i = 0; i < n; ++i)
        inverse.push_back(1.0 / (1 + i % 3));
    return inverse;
}

Vec3 moment(const Field& places, const std::vector<double>& inverse_mass) {
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < places.size(); ++i)
        sum += places.at(i) / inverse_mass[i];
    return sum;
}

Vec3 turning_moment(const Field& from, const Field& to, const std::vector<double>& inverse_mass) {
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < from.size(); ++i)
        sum += from.at(i).cross(Vec3(to.at(i) - from.at(i))) / inverse_mass[i];
    return sum;
}

class Sweeps : public testing::TestWithParam<Order> {};

TEST_P(Sweeps, LeaveOfALonelyStretchedLinkWhatItsStiffnessDoesNotTake) {
    for (const double k : {0.1, 0.5, 0.99}) {
        StretchConstraint link(1, 2.0, k, 0);
        link.begin({1, 0.25});
        Field places = places_of({{0, 0, 0}, {0, 3, 4}}); // 5 m: 3 m too long
        for (int n = 1; n <= 5; ++n) {
            link.sweep(places, GetParam());
            EXPECT_NEAR((places.at(1) - places.at(0)).norm() - 2, 3 * std::pow(1 - k, n), kRounding);
        }
        // Both moved by their inverse masses, and the multiplier tells by how much.
        const double closed = 3 * (1 - std::pow(1 - k, 5));
        EXPECT_NEAR(places.at(0).norm(), 0.8 * closed, kRounding);
        EXPECT_NEAR(link.multiplier(0), closed / 1.25, kRounding);
    }
}

TEST_P(Sweeps, LeaveAShortLinkToItsSlackStiffness) {
    for (const double k_slack : {0.0, 0.3}) {
        StretchConstraint link(1, 2.0, 0.99, k_slack);
        link.begin({1, 1});
        Field places = places_of({{0, 0, 0}, {0.5, 0, 0}});
        for (int n = 1; n <= 3; ++n) {
            link.sweep(places, GetParam());
            EXPECT_NEAR(2 - (places.at(1) - places.at(0)).norm(), 1.5 * std::pow(1 - k_slack, n), kRounding);
        }
    }
}

TEST_P(Sweeps, LeaveOfALonelyBendWhatItsStiffnessDoesNotTake) {
    for (const double k : {0.02, 0.5}) {
        BendConstraint bend(3, k);
        bend.begin({1, 0.5, 0.25});
        Field places = places_of({{0, 0, 0}, {1, 0.6, 0}, {2, 0, 0}});
        const auto off = [&] {
            return (places.at(1) - (places.at(0) + places.at(1) + places.at(2)) / 3).norm();
        };
        const double before = off();
        for (int n = 1; n <= 5; ++n) {
            bend.sweep(places, GetParam());
            EXPECT_NEAR(off(), before * std::pow(1 - k, n), kRounding);
        }
    }
}

TEST_P(Sweeps, OfInternalConstraintsKeepMomentumAndAngularMomentum) {
    for (const int nodes : {29, 30, 31}) {
        const std::vector<double> inverse = masses(nodes);
        StretchConstraint stretch(nodes - 1, 1.0, 0.99, 0.5);
        BendConstraint bend(nodes, 0.3);
        AngleConstraint angle(nodes, 0.3, 0.2);
        stretch.begin(inverse), bend.begin(inverse), angle.begin(inverse);
        const Field start = wandering(nodes);
        Field places = start;
        const auto sweep = [&](auto& constraint) {
            const Field before = places;
            constraint.sweep(places, GetParam());
            EXPECT_GT((places.at(1) - before.at(1)).norm(), 1e-3);
            EXPECT_LT((moment(places, inverse) - moment(start, inverse)).norm(), 1e-9);
        };
        // The moments of single moves are about the places between them: exact for one constraint at a time.
        sweep(stretch);
        sweep(bend);
        sweep(angle);
    }
}

TEST_P(Sweeps, NeverMoveAHeldEnd) {
    std::vector<double> inverse = masses(12);
    inverse.front() = inverse.back() = 0;
    StretchConstraint stretch(11, 0.9, 0.99, 1);
    BendConstraint bend(12, 0.5);
    AngleConstraint angle(12, 0.5, 0.1);
    stretch.begin(inverse), bend.begin(inverse), angle.begin(inverse);
    Field places = wandering(12);
    const Vec3 lower = places.at(0), upper = places.at(11);
    for (int n = 0; n < 10; ++n)
        stretch.sweep(places, GetParam()), bend.sweep(places, GetParam()), angle.sweep(places, GetParam());
    EXPECT_EQ(places.at(0), lower);
    EXPECT_EQ(places.at(11), upper);
}

TEST_P(Sweeps, ReachTheRestLengthsInTheEnd) {
    const std::vector<double> inverse = masses(10);
    StretchConstraint stretch(9, 1.0, 0.99, 0.99);
    stretch.begin(inverse);
    Field places = wandering(10);
    for (int n = 0; n < 2000; ++n) // Gauss-Seidel takes about n^2 sweeps over n links
        stretch.sweep(places, GetParam());
    for (int i = 0; i < 9; ++i)
        EXPECT_NEAR((places.at(i + 1) - places.at(i)).norm(), 1, 1e-10);
}

TEST_P(Sweeps, BendAChainToItsRestAngle) {
    const int nodes = 9;
    const double rest = 0.2;
    for (const double before : {0.0, 0.15}) {
        AngleConstraint angle(nodes, 0.5, rest);
        StretchConstraint stretch(nodes - 1, 1.0, 1, 1);
        const std::vector<double> inverse = masses(nodes);
        angle.begin(inverse), stretch.begin(inverse);
        Field places(nodes);
        Vec3 at = Vec3::Zero();
        for (int i = 0; i < nodes; ++i) {
            places.set(i, at);
            at += Vec3(std::cos(before * i), std::sin(before * i), 0);
        }
        for (int n = 0; n < 3000; ++n)
            angle.sweep(places, GetParam()), stretch.sweep(places, GetParam());
        for (int i = 1; i + 1 < nodes; ++i)
            EXPECT_NEAR(bend_angle(places, i), rest, 1e-6);
        // Bent to one side already: eight chords of one circle. The angle has no sign, and a straight chain
        // comes out as a zigzag.
        const double radius = 0.5 / std::sin(rest / 2), arc = 2 * radius * std::sin(4 * rest);
        const double across = (places.at(8) - places.at(0)).norm();
        if (before > 0)
            EXPECT_NEAR(across, arc, 1e-6);
        else
            EXPECT_GT(across, arc + 0.1);
    }
}

std::string order_name(const testing::TestParamInfo<Order>& entry) {
    static constexpr std::array names{"upwards", "downwards", "coloured"};
    return names[static_cast<std::size_t>(entry.param)];
}

INSTANTIATE_TEST_SUITE_P(Orders, Sweeps, testing::Values(Order::upwards, Order::downwards, Order::coloured),
                         order_name);

TEST(StretchConstraint, KeepsAngularMomentumOfEveryLink) {
    const std::vector<double> inverse{1, 0.4};
    StretchConstraint link(1, 1.0, 0.7, 0.7);
    link.begin(inverse);
    const Field before = places_of({{1, 2, 3}, {2, -1, 5}});
    Field after = before;
    link.sweep(after, Order::upwards);
    EXPECT_LT(turning_moment(before, after, inverse).norm(), kRounding);
}

TEST(BendConstraint, LeavesAStraightChainAlone) {
    BendConstraint bend(4, 1);
    bend.begin({1, 1, 1, 1});
    Field places = places_of({{0, 0, 0}, {1, 1, 0}, {2, 2, 0}, {3, 3, 0}});
    bend.sweep(places, Order::upwards);
    for (int i = 0; i < 4; ++i)
        EXPECT_LT((places.at(i) - Vec3(i, i, 0)).norm(), kRounding);
}

TEST(AngleConstraint, LeavesOfALonelyBendWhatItsStiffnessDoesNotTake) {
    // Along gradients the moves are straight: the share is exact to the second order of what one move turns.
    for (const double k : {0.02, 0.2})
        for (const double rest : {0.0, 0.3}) {
            AngleConstraint angle(3, k, rest);
            angle.begin({1, 0.5, 0.25});
            Field places = places_of({{0, 0, 0}, {1, 0.05, 0}, {2, 0, 0.02}});
            double off = bend_angle(places, 1) - rest;
            for (int n = 1; n <= 5; ++n) {
                angle.sweep(places, Order::upwards);
                const double now = bend_angle(places, 1) - rest;
                EXPECT_NEAR(now, off * (1 - k), 0.5 * k * k * off * off) << k << ' ' << rest << ' ' << n;
                off = now;
            }
        }
}

TEST(AngleConstraint, MovesAlongTheGradientOfTheAngle) {
    const std::vector<double> inverse{1, 0.5, 0.25};
    const Field before = places_of({{0.1, 0, 0.3}, {1, 0.6, -0.2}, {1.7, 0.1, 0.9}});
    const double rest = 0.4, small = 1e-6;
    AngleConstraint angle(3, small, rest);
    angle.begin(inverse);
    Field after = before;
    angle.sweep(after, Order::upwards);
    // Differences of the angle itself, place by place.
    std::array<Vec3, 3> gradient;
    double weight = 0;
    for (int i = 0; i < 3; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            Field up = before, down = before;
            up.set(i, before.at(i) + 1e-5 * Vec3::Unit(axis));
            down.set(i, before.at(i) - 1e-5 * Vec3::Unit(axis));
            gradient[i][axis] = (bend_angle(up, 1) - bend_angle(down, 1)) / 2e-5;
        }
        weight += inverse[i] * gradient[i].squaredNorm();
    }
    const double error = bend_angle(before, 1) - rest;
    for (int i = 0; i < 3; ++i) {
        const Vec3 move = after.at(i) - before.at(i);
        EXPECT_LT((move + small * error * inverse[i] / weight * gradient[i]).norm(), 1e-8 * small + 1e-15);
    }
    EXPECT_LT(turning_moment(before, after, inverse).norm(), kRounding);
}

TEST(AngleConstraint, LeavesAStraightChainAloneAndOpensAFold) {
    AngleConstraint straight(4, 1, 0);
    straight.begin({1, 1, 1, 1});
    Field places = places_of({{0, 0, 0}, {1, 1, 0}, {2, 2, 0}, {3, 3, 0}});
    straight.sweep(places, Order::upwards);
    for (int i = 0; i < 4; ++i)
        EXPECT_LT((places.at(i) - Vec3(i, i, 0)).norm(), kRounding);

    AngleConstraint fold(3, 0.5, 0);
    fold.begin({1, 1, 1});
    Field folded = places_of({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}});
    for (int n = 0; n < 20; ++n)
        fold.sweep(folded, Order::upwards);
    EXPECT_LT(bend_angle(folded, 1), 0.1);
    for (int i = 0; i < 3; ++i)
        EXPECT_TRUE(folded.at(i).allFinite());
}

TEST(LongRangeAttachment, BoundsTheDistanceAndLeavesWhatIsWithinAlone) {
    const LongRangeAttachment attachment({2, 1, 0}, 1);
    Field places = places_of({{0, 0, 9}, {0.6, 0, 0}, {0, 0, 0}});
    attachment.sweep(places, Vec3::Zero(), {1, 1, 0});
    EXPECT_LT((places.at(0) - Vec3(0, 0, 2)).norm(), kRounding);
    EXPECT_EQ(places.at(1), Vec3(0.6, 0, 0));
}

TEST(LongRangeAttachment, LeavesWhatItsStiffnessDoesNotTake) {
    const LongRangeAttachment attachment({2}, 0.25);
    Field places = places_of({{0, 0, 10}});
    Vec3 point(0, 0, 10);
    for (int n = 1; n <= 4; ++n) {
        attachment.sweep(places, Vec3::Zero(), {1});
        attachment.hold(point, Vec3::Zero(), 2);
        EXPECT_NEAR(places.z[0] - 2, 8 * std::pow(0.75, n), kRounding);
        EXPECT_NEAR(point.z() - 2, 8 * std::pow(0.75, n), kRounding);
    }
}

TEST(Pin, LeavesWhatItsStiffnessDoesNotTakeAndKeepsMomentum) {
    Pinned particle{{1, 0, 0}, 0.5}, anchor{{0, 0, 0}, 1e-4};
    const Vec3 before = particle.place / 0.5 + anchor.place / 1e-4;
    for (int n = 1; n <= 4; ++n) {
        pin(particle, anchor, 0.6);
        EXPECT_NEAR((particle.place - anchor.place).norm(), std::pow(0.4, n), kRounding);
        EXPECT_LT((particle.place / 0.5 + anchor.place / 1e-4 - before).norm(), 1e-9);
    }
}

TEST(Pin, DampingTakesItsShareOfTheRelativeSpeedAndKeepsMomentum) {
    Vec3 particle(3, 0, 0), anchor(1, 0, 0);
    damp_pin(particle, 0.5, anchor, 0.125, 0.25);
    EXPECT_NEAR(particle.x() - anchor.x(), 1.5, kRounding);
    EXPECT_NEAR(particle.x() / 0.5 + anchor.x() / 0.125, 3 / 0.5 + 1 / 0.125, kRounding);
}

/// Two loops of chain that lie into one another.
Field tangled(int n, double rest) {
    Field field(n);
    for (int i = 0; i < n; ++i) {
        const double turn = 2 * rest * i;
        field.set(i, {0.5 * std::cos(turn), 0.5 * std::sin(turn), 0.004 * i});
    }
    return field;
}

TEST(SelfCollision, FindsEveryPairThatIsNear) {
    const int n = 300;
    const double rest = 0.1, radius = 0.1;
    const Field places = tangled(n, rest);
    SelfCollision collision(n, radius, rest);
    collision.find(places);
    std::size_t near = 0;
    for (int i = 0; i < n; ++i)
        for (int j = i + 3; j < n; ++j) // 2 radii are 2 links
            near += (places.at(j) - places.at(i)).norm() < 3 * radius;
    EXPECT_GT(near, 300U);
    EXPECT_EQ(collision.pairs(), near);
}

TEST(SelfCollision, PushesTwoParticlesToTwoRadiiAndKeepsMomentum) {
    SelfCollision collision(9, 0.1, 0.2);
    Field places(9);
    for (int i = 0; i < 9; ++i)
        places.set(i, Vec3(0.5 * i, 0, 0));
    places.set(8, Vec3(0.05, 0.02, 0));
    std::vector<double> inverse(9, 1);
    inverse[8] = 0.5;
    const Vec3 before = moment(places, inverse);
    collision.find(places);
    collision.project(places, inverse);
    EXPECT_NEAR((places.at(8) - places.at(0)).norm(), 0.2, kRounding);
    EXPECT_LT((moment(places, inverse) - before).norm(), kRounding);
    EXPECT_EQ(places.at(1), Vec3(0.5, 0, 0));
}

} // namespace
} // namespace windlass::lab
