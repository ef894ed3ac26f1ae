// The anchor hove home: guided by its shank in the hawse pipe, seated on the plating, and out again.

#include "rigs/grip_in_proportion.hpp"
#include "rigs/tackle_rig.hpp"
#include "server/physics/tackle/hawse_pipe_fit.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace windlass::physics {
using namespace rigs;

namespace {

/// The default ship's port side, her axes along the world's.
struct Bow {
    ShipDef ship;
    TackleSetup setup;
    ObstacleMesh mesh = hull_mesh(ship, setup.chain.contact_diameter);

    explicit Bow(double cable_out) {
        setup.pipe = fit_hawse_pipe(ship, setup.windlass, setup.chain, setup.anchor, mesh, -1);
        setup.cable_out = cable_out;
        grip_in_proportion(setup.windlass);
        // Hung with the flukes' axis square to the pipe.
        setup.anchor_turned = std::atan2(setup.pipe->bore.x(), -setup.pipe->bore.y());
    }
    TackleRig rig() const {
        TackleRig rig(setup, quiet_water(50));
        rig.hull.mesh = &mesh;
        rig.hull.pipe = &*rig.setup.pipe;
        rig.lip_on_board = setup.pipe->lip;
        return rig;
    }
    static Bow with_anchor_home() {
        Bow bow(5);
        bow.setup.cable_out = bow.setup.pipe->cable_at_home();
        return bow;
    }
};

/// Clutch in, brake off, motor heaving.
void heave(TackleRig& rig, double lever) {
    rig.levers.clutch_in = true;
    rig.levers.brake = 0;
    rig.levers.speed = lever;
}

/// rad, between shank and bore.
double askew(const TackleRig& rig) {
    const Vec3 shank = (rig.tackle.anchor().shackle() - rig.tackle.anchor().pin()).normalized();
    return std::acos(std::min(1.0, shank.dot(rig.setup.pipe->bore)));
}

// Flukes do not stand upright on their pin. Those that began so fell over after seconds, to the side that
// rounding chose, and the anchor swung for a minute: with up to 1.6 m/s, and against the ship's side.
TEST(HawsePipe, AnchorThatIsOutOfItAtTheStartHangsAtRest) {
    for (const double cable_out : {5.0, 12.0}) {
        const Bow bow(cable_out);
        TackleRig rig = bow.rig();
        EXPECT_NEAR(std::abs(rig.tackle.anchor().fluke_angle()), rig.setup.anchor.fluke_angle, 1e-9);
        double fastest = 0;
        for (int k = 0; k < 300; ++k) {
            rig.run(0.1);
            fastest = std::max(fastest, rig.tackle.anchor().fastest());
        }
        EXPECT_LT(fastest, 0.02) << cable_out; // m/s: a few mm of settling
    }
}

TEST(HawsePipe, IsHoveHomeHoweverItHangsButForFlukesTurnedInboard) {
    // Turned about its shank it slips round in the pipe until its flukes lie outboard, and seats.
    for (const double turned : {0.0, 1.57, 2.2, 3.14}) {
        Bow bow(2.5);
        bow.setup.anchor_turned += turned;
        TackleRig rig = bow.rig();
        heave(rig, 0.5);
        EXPECT_TRUE(rig.run_until([&] { return rig.tackle.home(); }, 60)) << turned;
        rig.run(5);
        EXPECT_LT(askew(rig), radians_from_degrees(2)) << turned;
        EXPECT_NEAR(rig.windlass().cable_out, bow.setup.pipe->cable_at_home(), 0.1) << turned;
        // Crown and flukes on the plating, besides the shank in the pipe.
        EXPECT_GE(rig.tackle.anchor().hull_load().borne, 3) << turned;
    }
}

TEST(HawsePipe, HoveOnIntoTheSeatTheMotorStallsAndTrips) {
    Bow bow(2.5);
    TackleRig rig = bow.rig();
    heave(rig, 0.5);
    ASSERT_TRUE(rig.run_until([&] { return rig.tackle.home(); }, 60));
    rig.run(5);
    EXPECT_LT(std::abs(rig.windlass().cable_speed), 1e-3);
    EXPECT_GT(rig.deck().gypsy_load, 0.95 * bow.setup.windlass.stall_pull);
    EXPECT_TRUE(rig.run_until([&] { return rig.windlass().motor.tripped; }, 120));
}

TEST(HawsePipe, FlukesThatComeUpInboardJamItShortOfItsSeat) {
    Bow bow(2.5);
    bow.setup.flukes_turned = 0.3;
    TackleRig rig = bow.rig();
    heave(rig, 0.5);
    EXPECT_TRUE(rig.run_until([&] { return rig.windlass().motor.tripped; }, 180));
    EXPECT_FALSE(rig.tackle.home());
    EXPECT_TRUE(rig.tackle.flukes_inboard());
    EXPECT_GT(askew(rig), radians_from_degrees(10));
    EXPECT_GT(rig.windlass().cable_out, bow.setup.pipe->cable_at_home() + 0.5);
}

TEST(HawsePipe, WalkedBackIntoTheWaterTheShipsWayTurnsFlukesThatCameUpInboard) {
    int jammed = 0;
    for (const double turned : {-0.3, 0.0, 0.5, 0.8}) {
        Bow bow(2.5);
        bow.setup.flukes_turned = 0.3;
        bow.setup.anchor_turned += turned;
        TackleRig rig = bow.rig();
        heave(rig, 0.5);
        rig.run(30);
        jammed += rig.tackle.flukes_inboard();
        // A knot ahead: the stream trails the flukes aft (half of that turns them in one case of four only).
        // Again if that was not enough: how the anchor hangs when it leaves the water is chance.
        for (int again = 0; again < 4 && !rig.tackle.home(); ++again) {
            heave(rig, -0.5);
            ASSERT_TRUE(rig.run_until([&] { return rig.windlass().cable_out > 10; }, 90));
            heave(rig, 0);
            rig.lip_velocity = {0.5, 0, 0};
            rig.run(30);
            heave(rig, 0.5);
            ASSERT_TRUE(rig.run_until([&] { return rig.windlass().cable_out < 4; }, 90));
            rig.lip_velocity.setZero();
            rig.run_until([&] { return rig.tackle.home(); }, 60);
        }
        EXPECT_TRUE(rig.tackle.home()) << turned;
        EXPECT_FALSE(rig.tackle.flukes_inboard()) << turned;
    }
    EXPECT_GE(jammed, 2);
}

TEST(HawsePipe, ShortOfItsSeatItsLoadIsItsWeightOnTheSlopeOfItsShank) {
    Bow bow(5);
    bow.setup.cable_out = bow.setup.pipe->cable_at_home() + 0.3;
    TackleRig rig = bow.rig();
    rig.hull.material.friction = 0; // nothing slows its rocking on the mouth's edge: means of half a minute
    rig.run(30);
    const double weight = rig.tackle.anchor().weight(rig.environment);
    double pull = 0, slope = 0;
    Vec3 borne = Vec3::Zero();
    constexpr int kTicks = 9000;
    for (int k = 0; k < kTicks; ++k) {
        rig.step();
        pull += rig.deck().hawse_tension / kTicks;
        slope += std::sin(std::asin(bow.setup.pipe->bore.z()) + askew(rig)) / kTicks;
        borne += (rig.tackle.hull_load().impulse - rig.tackle.pull_on_ship()) / kTicks;
    }
    EXPECT_NEAR(pull / (weight * slope), 1, 0.05); // the last link does not lie quite along the shank
    // What pipe, plating and cable bear together is its weight.
    EXPECT_NEAR(borne.z() / weight, 1, 0.02);
    EXPECT_LT(std::hypot(borne.x(), borne.y()), 0.02 * weight);
}

TEST(HawsePipe, StaysHomeInASwellOnTheStopper) {
    Bow bow = Bow::with_anchor_home();
    bow.setup.stopper_closed = true;
    TackleRig rig = bow.rig();
    double low = 1e9, high = 0;
    for (int k = 0; k < 300 * 60; ++k) { // 3 m high, 8 s: the bow rises and falls at up to 1.2 m/s
        const double turn = 2 * std::numbers::pi / 8;
        rig.lip_velocity = {0, 0, 1.5 * turn * std::sin(turn * k * rig.dt)};
        rig.step();
        ASSERT_TRUE(rig.tackle.home()) << k;
        if (k < 2400) continue; // in the first waves it settles
        low = std::min(low, rig.deck().hawse_tension);
        high = std::max(high, rig.deck().hawse_tension);
    }
    EXPECT_LT(askew(rig), radians_from_degrees(2));
    // The bow's acceleration is 0.095 of the earth's: between 0.9 and 1.1 of the weight, and what is locked
    // in between cable and seat comes and goes with it.
    EXPECT_GT(low, 0);
    EXPECT_LT(high, 1.3 * low);
}

TEST(HawsePipe, LeavesByItsWeightWhenTheBrakeIsOpened) {
    const Bow bow = Bow::with_anchor_home();
    TackleRig rig = bow.rig();
    rig.run(2);
    EXPECT_TRUE(rig.tackle.home());
    rig.levers.brake = 0;
    EXPECT_TRUE(rig.run_until([&] { return rig.windlass().cable_out > 5; }, 20));
    EXPECT_EQ(rig.tackle.anchor().hull_load().borne, 0);
}

TEST(HawsePipe, BooksCloseHomeAndOutAgainAndBitsAreTheSame) {
    const auto home_and_out = [] {
        Bow bow(2.5);
        bow.setup.anchor_turned += 1.57;
        TackleRig rig = bow.rig();
        rig.tackle.keep_ledger();
        const double start = rig.tackle.energy(rig.environment);
        heave(rig, 0.5);
        rig.run_until([&] { return rig.tackle.home(); }, 60);
        heave(rig, -0.5);
        rig.run_until([&] { return rig.windlass().cable_out > 4; }, 60);
        EXPECT_GT(rig.windlass().cable_out, 4);
        const double lost = start - rig.tackle.energy(rig.environment);
        double turned_over = 0;
        for (const LedgerEntry& entry : entries(rig.tackle.ledger()))
            turned_over += std::abs(entry.joules);
        EXPECT_NEAR(lost, sum(rig.tackle.ledger()), 0.005 * turned_over);
        const AnchorPose pose = rig.tackle.anchor().pose();
        return std::array{pose.position.x(), pose.position.y(), pose.position.z(), pose.attitude.w(),
                          rig.deck().hawse_tension};
    };
    EXPECT_EQ(home_and_out(), home_and_out());
}

} // namespace
} // namespace windlass::physics
