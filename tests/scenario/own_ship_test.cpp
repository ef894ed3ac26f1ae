// The ship of an exercise without its cables: what of the helm she hears, and who sails her.

#include "server/exercise/tick/own_ship.hpp"

#include "server/exercise/definition/exercise_def.hpp"

#include <gtest/gtest.h>

namespace windlass::exercise {
namespace {

constexpr double kTick = 1.0 / 60; // s
constexpr physics::Helm kOrdered{.engine = 0.5, .rudder = 0.3, .bow_thruster = 1, .stern_thruster = -1};

/// She lies stopped in still air and water, and her helm is moved once.
class OwnShipTest : public testing::Test {
protected:
    void run(double seconds) {
        for (const double end = time_ + seconds; time_ < end - kTick / 2;) {
            time_ += kTick;
            const double rise = surroundings_.advance(kTick, time_);
            ASSERT_TRUE(ship_.step(surroundings_, rise, faults_, kTick, time_, log_));
        }
    }
    void fails(FaultCode code) {
        faults_.order({.code = code}, time_, log_);
        faults_.advance(time_, log_);
    }
    void order(const physics::Helm& helm) { ship_.steer(helm, surroundings_.sea(), time_); }

    EventLog log_{[this](const words::Event& event, int, double, const std::string&) {
        events_.emplace_back(event.name);
    }};
    std::vector<std::string> events_;
    ExerciseDef def_;
    Surroundings surroundings_{def_.environment, Weather{.wind_speed = 0, .current_speed = 0}, {}, 25};
    FaultBook faults_;
    OwnShip ship_{def_.ship, {}, surroundings_.sea(), 25};
    double time_ = 0;
};

TEST_F(OwnShipTest, HearsHerHelm) {
    order(kOrdered);
    run(1);
    EXPECT_EQ(ship_.answers(), kOrdered);
}

TEST_F(OwnShipTest, FailedTelegraphLeavesTheEngineAsItWasAndTheRestHeard) {
    order({.engine = -0.2});
    run(1);
    fails(FaultCode::telegraph_failed);
    order(kOrdered);
    run(1);
    EXPECT_EQ(ship_.answers().engine, -0.2);
    EXPECT_EQ(ship_.answers().rudder, kOrdered.rudder);
}

TEST_F(OwnShipTest, BlackoutStopsThrustersAtOnceAndSteeringUntilTheEmergencySupplyIsUp) {
    order(kOrdered);
    fails(FaultCode::ship_blackout);
    run(44);
    EXPECT_EQ(ship_.answers().bow_thruster, 0);
    EXPECT_EQ(ship_.state().rudder, 0);
    run(20); // 45 s, SOLAS II-1/42; and the rudder takes 28 s from side to side
    EXPECT_EQ(ship_.answers().stern_thruster, 0);
    EXPECT_NEAR(ship_.state().rudder, kOrdered.rudder, 0.01);
    EXPECT_NEAR(ship_.state().surge, 0, 1e-3); // and no engine drives her
}

TEST_F(OwnShipTest, PullOfACableMovesHerInTheNextStepAlone) {
    ship_.pulled_by({.force = {0, 1e6, 0}});
    run(kTick);
    const double surge = ship_.state().surge;
    EXPECT_GT(surge, 0); // north, as she heads
    EXPECT_EQ(ship_.pull().force.norm(), 0);
    run(kTick);
    EXPECT_LE(ship_.state().surge, surge);
}

TEST_F(OwnShipTest, WhoMovesTheHelmOfAShipThatNobodySailsAnyMoreHasHer) {
    ship_.follow({.attitude = physics::attitude(ship_.state()), .time = 1}, time_, log_);
    run(1);
    EXPECT_TRUE(ship_.foreign());
    run(physics::ForeignShip::kStill + 1);
    order(kOrdered);
    run(1);
    EXPECT_FALSE(ship_.foreign());
    EXPECT_EQ(events_.back(), "own_ship.handed_back");
}

} // namespace
} // namespace windlass::exercise
