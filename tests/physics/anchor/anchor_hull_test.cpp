// The anchor against the ship: plating and stem keep it out, and make neither momentum nor energy.

#include "rigs/tackle_rig.hpp"
#include "server/physics/base/closest.hpp"
#include "tests/physics/chain/winding.hpp"
#include "tests/physics/exercise_step.hpp"
#include "tests/physics/solver/chain_rig.hpp"

#include <gtest/gtest.h>

#include <random>

namespace windlass::physics {
namespace {

/// An anchor in air without a cable, thrown at a ship that stands still with her axes along the world's.
struct ThrownAnchor {
    ShipDef ship;
    ObstacleMesh mesh = hull_mesh(ship, 0.28);
    HullSurface hull{&mesh, {}, {}};
    EnvironmentDef environment = in_air();
    Anchor anchor{{}, 0, environment, {}};
    EnergyLedger ledger;

    explicit ThrownAnchor(const AnchorPose& pose) {
        environment.depth = 1e6;
        anchor.set_pose(pose);
    }
    void step() {
        const ChainTail shackle = anchor.begin(environment, {kStep, kStep}, {}, {}, &hull);
        anchor.finish(environment, {kStep, kStep}, shackle.velocity, &ledger); // as nothing pulls
        ledger.contact += anchor.hull_load().work;
    }
    double energy() const { return anchor.kinetic_energy() + anchor.potential_energy(environment); }

    /// Deepest that any corner is inside the hull, or the stem inside a box, m.
    double deepest() const {
        double deepest = 0;
        std::vector<int> all(4096);
        all.resize(mesh.near(mesh.low(), mesh.high(), all));
        for (int k = 0; k < anchor.boxes(); ++k) {
            const AnchorBox box = anchor.box(k);
            for (int corner = 0; corner < 8; ++corner) {
                const Vec3 sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
                const Vec3 p = box.centre + box.axes * box.half.cwiseProduct(sign);
                if (winding(mesh, p) < 0.5) continue;
                double nearest = 1e9;
                for (const int t : all) {
                    const MeshTriangle& triangle = mesh.triangle(t);
                    const OnTriangle on = closest_on_triangle(triangle.corner, triangle.normal, p);
                    nearest = std::min(nearest, (p - on.point).norm());
                }
                deepest = std::max(deepest, nearest);
            }
            const Vec3 foot = box.axes.transpose() * (stem_foot() - box.centre);
            const Vec3 stem = box.axes.transpose() * (stem_head() - stem_foot());
            deepest = std::max(deepest, -closest_on_box(foot, stem, box.half).distance);
        }
        return deepest;
    }
    // Above water, raked by half its height (hull_surface.cpp).
    Vec3 stem_head() const { return {0.5 * ship.length_overall, 0, ship.hawse_height + 2.5}; }
    Vec3 stem_foot() const { return stem_head() - stem_head().z() * Vec3(0.5, 0, 1); }
};

/// Tumbling at the bow from ahead and from the side, at 4 m/s.
AnchorPose thrown_at_the_bow(int seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> pick(-1, 1);
    AnchorPose pose;
    pose.attitude = Eigen::Quaterniond(pick(random), pick(random), pick(random), pick(random)).normalized();
    pose.spin = Vec3(pick(random), pick(random), pick(random));
    const bool at_stem = seed % 2 == 0;
    pose.position = at_stem ? Vec3(114.5, 0.3 * pick(random), 5) : Vec3(100 + 3 * pick(random), 13, 7);
    pose.velocity = at_stem ? Vec3(-4, 0, 4) : Vec3(0, -4, 4);
    return pose;
}

TEST(AnchorOnHull, StaysOutsideKeepsMomentumAndMakesNoEnergy) {
    for (int seed = 1; seed <= 12; ++seed) {
        ThrownAnchor thrown(thrown_at_the_bow(seed));
        const double start = thrown.energy();
        double worst = 0, deepest = 0, made = 0;
        int touched = 0;
        for (int k = 0; k < 450; ++k) {
            const Vec3 before = thrown.anchor.mass() * thrown.anchor.motion().head<3>();
            thrown.step();
            const ContactLoad& load = thrown.anchor.hull_load();
            const Vec3 given = load.impulse - Vec3(0, 0, kStep * thrown.anchor.mass() * kGravity);
            const Vec3 momentum = thrown.anchor.mass() * thrown.anchor.motion().head<3>();
            worst = std::max(worst, (momentum - before - given).norm() / before.norm());
            touched += load.borne;
            if (load.borne > 0) deepest = std::max(deepest, thrown.deepest());
            made = std::max(made, thrown.energy() + sum(thrown.ledger) - start);
        }
        EXPECT_GT(touched, 0) << seed;
        EXPECT_LT(worst, 1e-9) << seed;
        EXPECT_LT(deepest, 0.1) << seed; // 4 m/s of 10 t on 3e7 N/m are stopped in 4 m/s sqrt(m / k) = 7 cm
        EXPECT_LT(made, 1e-6 * start) << seed;
    }
}

TEST(AnchorOnHull, LiesOnDeckWithItsWeight) {
    AnchorPose pose;
    pose.position = {60, 2, ShipDef().hawse_height + 2.5 + 0.5};
    ThrownAnchor laid(pose);
    for (int k = 0; k < 3000; ++k)
        laid.step();
    EXPECT_LT(laid.anchor.motion().norm(), 1e-3);
    const Vec3 push = laid.anchor.hull_load().impulse / kStep;
    const double weight = laid.anchor.weight(laid.environment);
    EXPECT_NEAR(push.z(), weight, 1e-3 * weight);
    EXPECT_LT(std::hypot(push.x(), push.y()), 1e-3 * weight);
}

/// Hung from the port lip; the ship goes off to port, 3 m in two seconds, and stops.
struct Swung {
    double max_made = 0, booked = 0; ///< J
    int touched = 0;
    std::vector<double> trace;
};

Swung swing_at_the_bow(bool solid) {
    TackleSetup setup;
    setup.cable_out = 2.5;
    rigs::TackleRig rig(setup, rigs::quiet_water(100));
    const ShipDef ship;
    const ObstacleMesh mesh = hull_mesh(ship, setup.chain.contact_diameter);
    if (solid) rig.hull.mesh = &mesh;
    rig.lip_on_board = {ship.hawse_forward, ship.hawse_outboard, ship.hawse_height};
    rig.tackle.keep_ledger();
    Swung swung;
    const double start = rig.tackle.energy(rig.environment);
    for (int k = 0; k < 1800; ++k) {
        const double t = std::min(2.0, k * rig.dt);
        rig.lip_velocity = {0, 1.5 * (1 - std::cos(std::numbers::pi * t)), 0};
        rig.step();
        swung.touched += rig.tackle.anchor().hull_load().borne;
        const double lost = start - rig.tackle.energy(rig.environment);
        swung.booked = sum(rig.tackle.ledger());
        swung.max_made = std::max(swung.max_made, swung.booked - lost);
        const AnchorPose pose = rig.tackle.anchor().pose();
        for (const double value : {pose.position.x(), pose.position.y(), pose.position.z(), pose.attitude.w(),
                                   rig.deck().hawse_tension})
            swung.trace.push_back(value);
    }
    return swung;
}

TEST(AnchorOnHull, SwungAtTheBowOnItsCableMakesNoEnergy) {
    const Swung through = swing_at_the_bow(false), swung = swing_at_the_bow(true);
    EXPECT_EQ(through.touched, 0);
    EXPECT_GT(swung.touched, 0);
    // 0.8 % of the work that the lip does is out of balance when nothing is touched, too.
    EXPECT_LT(through.max_made, 0.01 * std::abs(through.booked));
    EXPECT_LT(swung.max_made, through.max_made);
    EXPECT_EQ(swing_at_the_bow(true).trace, swung.trace);
}

} // namespace
} // namespace windlass::physics
