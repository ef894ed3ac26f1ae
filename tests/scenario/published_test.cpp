// What is published: checked field by field from one list, and what the newer fields mean.

#include "server/exercise/picture/published.hpp"
#include "server/physics/windlass/gypsy.hpp"

#include "rigs/drill.hpp"
#include "rigs/leaves.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace windlass::exercise {
using namespace rigs;

namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// Puts NaN into the which-th floating point number of a snapshot; its path, or nothing where there are not
/// so many.
std::string spoil(Snapshot& snapshot, int which) {
    std::string spoilt;
    each_leaf("", snapshot, [&](const std::string& path, auto& value) {
        using Leaf = std::remove_reference_t<decltype(value)>;
        if constexpr (std::is_floating_point_v<Leaf>)
            if (which-- == 0) {
                value = std::numeric_limits<Leaf>::quiet_NaN();
                spoilt = path;
            }
    });
    return spoilt;
}

/// A snapshot with one entry at least in every list.
Snapshot full() {
    Snapshot snapshot;
    snapshot.tackle.resize(2);
    for (TackleView& tackle : snapshot.tackle) {
        tackle.chain.nodes.assign(3, {1, 2, 3});
        tackle.chain.tension.assign(2, 4);
        tackle.chain.marks.resize(2);
    }
    snapshot.environment.now.current_profile.resize(2);
    snapshot.environment.after.current_profile.resize(1);
    snapshot.faults.resize(1);
    snapshot.bridge_orders.resize(1);
    snapshot.events.resize(2);
    return snapshot;
}

TEST(Published, OneBadNumberInAnyFieldIsFound) {
    const Snapshot good = full();
    ASSERT_TRUE(is_finite(good));
    for (int which = 0;; ++which) {
        Snapshot bad = good;
        const std::string where = spoil(bad, which);
        if (where.empty()) {
            EXPECT_GT(which, 200);
            break;
        }
        EXPECT_FALSE(is_finite(bad)) << which << ": " << where;
    }
}

/// How many of each kind a list goes through.
struct Counted {
    std::size_t doubles = 0, flags = 0, words = 0;
};
template <class T>
Counted counted() {
    Counted seen;
    const T object;
    each_leaf("", object, [&](const std::string&, const auto& value) {
        using Leaf = std::decay_t<decltype(value)>;
        ++(std::is_floating_point_v<Leaf> ? seen.doubles
           : std::is_same_v<Leaf, bool>   ? seen.flags
                                          : seen.words);
    });
    return seen;
}

TEST(Published, ListsHoldAllThatIsInTheStructs) {
    // Of the structs that are all doubles and flags the size says how many there must be. That the others are
    // whole is the structured binding's: a field that it does not name does not compile.
    const auto windlass = counted<WindlassView>();
    EXPECT_EQ(windlass.flags, 8U);
    EXPECT_LE(windlass.doubles * 8 + windlass.flags + windlass.words * 4, sizeof(WindlassView));
    EXPECT_GT(windlass.doubles * 8 + windlass.flags + windlass.words * 4 + 8,
              sizeof(WindlassView)); // its padding
    EXPECT_EQ(counted<WatchCircleOrder>().doubles, 3U);
}

TEST(CableForce, OfEachCableAddsUpAndHasItsMomentAboutMidshipsOnTheWaterline) {
    Drill drill(let_go_def());
    ASSERT_TRUE(let_go_and_pay_out(drill, 3));
    drill.run_until([&] { return drill.windlass().gypsy_load > 75e3; }, 300);
    const Snapshot& now = drill.now();
    const TackleView& port = now.tackle[0];
    EXPECT_EQ(now.cable_force, port.force);
    const physics::Vec3 lever = port.hawse - now.ship.position;
    const physics::Vec3 moment = lever.cross(port.force);
    EXPECT_NEAR(lever.z(), drill.exercise().def().ship.hawse_height, 1e-9);
    // The hull bears nothing here, so the lip is where it all acts.
    EXPECT_NEAR((now.cable_moment - moment).norm() / moment.norm(), 0, 1e-9);
    EXPECT_LT(now.cable_moment.x(), -1e6); // she heads north: her bow is pulled down, about the axis to east
    EXPECT_NEAR(now.cable_moment.x(), lever.y() * port.force.z() - lever.z() * port.force.y(),
                1e-9 * moment.norm());
    EXPECT_NEAR((port.hawse - port.chain.nodes.front().cast<double>()).norm(), 0, 0.05);
}

TEST(Gypsy, TurnsInStepWithItsLinksWhereverTheyRun) {
    Drill drill(quiet_def(60, 25));
    drill.run(1);
    const double revolution = physics::gypsy_revolution(drill.exercise().def().tackle[0].chain.diameter);
    drill.brake(0);
    drill.run(3);
    const WindlassView& w = drill.windlass();
    ASSERT_GT(w.cable_speed, 1);
    EXPECT_NEAR(w.gypsy_speed, kTurn * w.cable_speed / revolution, 1e-9);
    EXPECT_NEAR(std::remainder(w.gypsy_turn - kTurn * w.cable_out / revolution, kTurn), 0, 1e-9);
    EXPECT_GE(w.gypsy_turn, 0);
    EXPECT_LT(w.gypsy_turn, kTurn);
}

TEST(Gypsy, StandsWhileLinksJumpOverItAndTurnsIntoTheNextPocketWhenTheySeat) {
    constexpr double kDiameter = 0.078;
    const double revolution = physics::gypsy_revolution(kDiameter), pocket = kTurn / physics::kGypsyPockets;
    physics::GypsyState gypsy;
    double out = 30;
    const auto pass = [&](double speed, double seconds) {
        for (int k = 0; k < 100; ++k) {
            physics::turn_gypsy(kDiameter, seconds / 100, speed * seconds / 100, gypsy);
            out += speed * seconds / 100;
        }
    };
    const double before = physics::gypsy_turn(kDiameter, out, gypsy);
    gypsy.jumping = true;
    pass(1, 3.3); // metres, less than a pocket beyond a whole turn
    EXPECT_NEAR(std::remainder(physics::gypsy_turn(kDiameter, out, gypsy) - before, kTurn), 0, 1e-9);
    EXPECT_EQ(physics::gypsy_speed(kDiameter, 1, gypsy), 0);
    gypsy.jumping = false;
    EXPECT_NE(physics::gypsy_speed(kDiameter, 0, gypsy), 0); // on its way
    pass(0, 1);
    const double off = physics::gypsy_turn(kDiameter, out, gypsy) - kTurn * out / revolution;
    EXPECT_NEAR(std::remainder(off, pocket), 0, 1e-9);
    EXPECT_EQ(physics::gypsy_speed(kDiameter, 0, gypsy), 0);
}

TEST(Clutch, ShowsHowFarItsClawsAreOutOfLine) {
    Drill drill(quiet_def(60, 25));
    drill.run(1);
    drill.brake(0);
    drill.run(3); // it runs
    double min = 1, max = 0;
    for (int k = 0; k < 300; ++k) {
        drill.tick();
        min = std::min(min, drill.windlass().clutch_offset);
        max = std::max(max, drill.windlass().clutch_offset);
    }
    EXPECT_GE(min, 0);
    EXPECT_LT(max, 1);
    EXPECT_GT(max - min, 0.5); // they pass by each other
}

} // namespace
} // namespace windlass::exercise
