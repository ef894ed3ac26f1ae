// What the seats are shown: every rule of it.

#include "tests/perceive/ships.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace windlass::perceive {
namespace {

using exercise::AnchorPhase;
using exercise::ExerciseDef;
using exercise::FaultCode;
using exercise::FaultPhase;
using exercise::Snapshot;
using exercise::TackleView;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kKnot = 1852.0 / 3600;

/// The forecastle of a riding ship, some of whose windlass is as the function makes it.
template <class Change>
ForecastleView with(const Change& change, const SeatAids& aids = {}) {
    Snapshot s = riding();
    change(s.tackle[0]);
    return forecastle(s, aids);
}

TEST(Forecastle, EveryFieldIsFilledInWhateverWasThere) {
    ForecastleView used = forecastle(weighing(), {.lining_temperature = true, .underwater = true});
    perceive_forecastle(riding(), riding().tackle[0], some_ship(), {}, used);
    EXPECT_EQ(bytes(used), bytes(forecastle(riding())));
    BridgeView old = bridge(weighing());
    perceive_bridge(riding(), some_ship(), old);
    EXPECT_EQ(bytes(old), bytes(bridge(riding())));
}

TEST(LookingOut, TellsTheHourToTheMinuteAndTheVisibilityInTwoFigures) {
    Snapshot s = riding();
    s.environment.now.time_of_day = 23 * 3600 + 10 * 60 + 59.9;
    s.environment.now.visibility = 1249;
    Daylight seen;
    perceive_daylight(s, seen);
    EXPECT_EQ(seen.time_of_day(), 23 * 3600 + 10 * 60);
    EXPECT_NEAR(seen.visibility(), 1200, 1e-9);
    s.environment.now.visibility = 0;
    perceive_daylight(s, seen);
    EXPECT_EQ(seen.visibility(), 0);
}

TEST(Forecastle, TakesMemoryOnlyOnce) {
    ForecastleView view = forecastle(weighing());
    const auto* nodes = view.nodes().data();
    const auto* marks = view.marks().data();
    Snapshot s = riding();
    for (auto& node : s.tackle[0].chain.nodes)
        node.z() = 3; // all of it in sight
    s.tackle[0].chain.nodes.resize(2000, s.tackle[0].chain.nodes[0]);
    s.tackle[0].chain.marks.resize(80, s.tackle[0].chain.marks[5]);
    perceive_forecastle(s, s.tackle[0], some_ship(), {}, view);
    EXPECT_EQ(view.nodes().size(), 256U); // and is bounded
    EXPECT_EQ(view.marks().size(), 64U);
    EXPECT_EQ(view.nodes().data(), nodes);
    EXPECT_EQ(view.marks().data(), marks);
}

TEST(Forecastle, TheShipIsSeenInSteps) {
    Snapshot s = riding();
    s.ship.position = {10.04, -20.06, -0.04};
    s.ship.heading = 359.97 * kDegree;
    const ForecastleView view = forecastle(s);
    EXPECT_NEAR(view.ship_position().x(), 10.0, 1e-12);
    EXPECT_NEAR(view.ship_position().y(), -20.1, 1e-12);
    EXPECT_EQ(view.ship_position().z(), 0);
    EXPECT_EQ(view.ship_heading(), 0); // and not a whole turn
}

TEST(Forecastle, TiltIsPositiveToStarboardAndBowUp) {
    Snapshot s = riding();
    s.ship.attitude = Eigen::AngleAxisd(std::numbers::pi / 2 - s.ship.heading, Eigen::Vector3d::UnitZ()) *
                      Eigen::AngleAxisd(-0.05, Eigen::Vector3d::UnitY()) *
                      Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX());
    EXPECT_NEAR(forecastle(s).ship_roll(), 0.1, 1e-12);
    EXPECT_NEAR(forecastle(s).ship_pitch(), 0.05, 1e-12);
    EXPECT_NEAR(bridge(s).roll(), 0.1, 1e-12);
    EXPECT_NEAR(bridge(s).pitch(), 0.05, 1e-12);
}

TEST(Forecastle, WindIsFeltAsItMeetsTheShip) {
    Snapshot s = riding();
    s.ship.heading = 0;
    s.ship.velocity = {0, 5, 0};       // 5 m/s north
    s.environment.now.wind_speed = 10; // from ahead: 15 m/s, a near gale
    s.environment.now.wind_from = 0;
    EXPECT_EQ(forecastle(s).wind_felt(), 7);
    EXPECT_EQ(forecastle(s).wind_from_bow(), 0);
    EXPECT_NEAR(bridge(s).wind_speed_apparent(), 15, 1e-12);
    s.ship.velocity = physics::Vec3::Zero();
    s.environment.now.wind_from = 100 * kDegree; // the flag tells 4 1/2 points of 22.5 degrees from 4
    EXPECT_EQ(forecastle(s).wind_felt(), 5);
    EXPECT_NEAR(forecastle(s).wind_from_bow(), 90 * kDegree, 1e-12);
    EXPECT_NEAR(bridge(s).wind_from_apparent(), 100 * kDegree, 1e-12);
    s.ship.heading = 190 * kDegree; // now it comes over the port bow's side
    EXPECT_NEAR(forecastle(s).wind_from_bow(), 270 * kDegree, 1e-9);
    s.environment.now.wind_speed = 8; // 15.6 kn, told as 16 kn
    EXPECT_EQ(forecastle(s).wind_felt(), 4);
    s.environment.now.wind_speed = 8.6; // 16.7 kn, told as 17 kn
    EXPECT_EQ(forecastle(s).wind_felt(), 5);
    s.environment.now.wind_speed = 0.1;
    EXPECT_EQ(forecastle(s).wind_felt(), 0);
    EXPECT_EQ(forecastle(s).wind_from_bow(), 0); // the flag hangs
    s.environment.now.wind_speed = 40;
    EXPECT_EQ(forecastle(s).wind_felt(), 12);
}

TEST(Forecastle, GaugesReadInSteps) {
    const ForecastleView view = with([](TackleView& t) {
        t.windlass.gypsy_load_indicated = 250'499;
        t.windlass.motor_current = 178;
        t.windlass.motor_pressure = 1.27e7;
        t.windlass.cable_speed_indicated = 0.148; // 8.9 m/min
    });
    EXPECT_EQ(view.gypsy_load_indicated(), 250'000);
    EXPECT_EQ(view.motor_current(), 180);
    EXPECT_NEAR(view.motor_pressure(), 1.28e7, 1e-6);
    EXPECT_NEAR(view.cable_speed_indicated(), 9.0 / 60, 1e-12);
    EXPECT_EQ(view.cable_out_indicated(), 164.5);
}

TEST(Forecastle, MenSayWhatTheyDoAndHowLongInTensOfSeconds) {
    const ForecastleView view = with([](TackleView& tackle) {
        tackle.deck_work = {exercise::DeckWork::break_cable, 411.2, words::DeckHindrance::stopper_off};
    });
    EXPECT_EQ(view.deck_work(), DECK_WORK_BREAK_CABLE);
    EXPECT_EQ(view.deck_work_left(), 420);
    EXPECT_EQ(view.deck_work_waits(), DECK_HINDRANCE_STOPPER_OFF);
}

TEST(Forecastle, EyesSeeInSteps) {
    ForecastleView view = with([](TackleView& t) {
        t.windlass.cable_speed = 5.86;
        t.chain.lead_clock = 11.6;
        t.chain.top_angle = 34 * kDegree;
    });
    EXPECT_EQ(view.cable_speed_seen(), 5.75);
    EXPECT_EQ(view.lead_clock(), 11.5);
    EXPECT_NEAR(view.top_angle(), 30 * kDegree, 1e-12);
    view = with([](TackleView& t) { t.chain.lead_clock = 0.2; });
    EXPECT_EQ(view.lead_clock(), 12); // as it is called
}

TEST(Forecastle, AnAnchorAtTheHawseHasNoCableThatLeads) {
    for (const AnchorPhase phase : {AnchorPhase::housed, AnchorPhase::acockbill}) {
        Snapshot s = weighing();
        s.tackle[0].anchor.phase = phase;
        EXPECT_FALSE(forecastle(s).leads());
        EXPECT_EQ(forecastle(s).lead_clock(), 0);
        EXPECT_EQ(forecastle(s).top_angle(), 0);
    }
    EXPECT_TRUE(forecastle(riding()).leads());
}

TEST(Forecastle, CableIsSeenToALittleUnderTheSurface) {
    const ForecastleView view = forecastle(riding());
    ASSERT_EQ(view.nodes().size(), 14U); // 6 m of height, 0.6 m a node
    EXPECT_EQ(view.nodes().front().z(), 6);
    EXPECT_EQ(view.nodes().back().z(), -1.5F);
    EXPECT_NEAR(view.nodes().back().y(), 82 + 0.8 * 12.5, 1e-4); // on the same straight line
}

TEST(Forecastle, CableThatIsAllAboveWaterIsAllSeen) {
    EXPECT_EQ(forecastle(weighing()).nodes().size(), 3U);
    Snapshot none = riding();
    none.tackle[0].chain.nodes.clear(); // the whole cable has run out
    EXPECT_TRUE(forecastle(none).nodes().empty());
}

TEST(Forecastle, MarksAreSeenOnDeckAndDownToALittleUnderTheSurface) {
    const auto seen = [](double outboard, float z) {
        return with([&](TackleView& t) { t.chain.marks = {{3, outboard, 3, false, {30, 82, z}}}; }).marks();
    };
    EXPECT_TRUE(seen(-8.1, 6).empty());
    EXPECT_TRUE(seen(9, -1.6F).empty());
    EXPECT_EQ(seen(9, -1.4F).size(), 1U);
    ASSERT_EQ(seen(-7.9, 6).size(), 1U);
    EXPECT_EQ(seen(-7.9, 6)[0].outboard(), -8);
    EXPECT_EQ(seen(4.1, 3)[0].outboard(), 4); // to a link
    EXPECT_EQ(seen(4.1, 3)[0].shackle(), 3);
    EXPECT_EQ(seen(4.1, 3)[0].white_links(), 3);
}

TEST(Forecastle, TheAnchorIsSeenWhileItIsAboveTheWater) {
    ForecastleView view = forecastle(weighing());
    EXPECT_EQ(view.anchor(), ANCHOR_SEEN_CLEAR);
    EXPECT_EQ(view.anchor_position().z(), 2);
    EXPECT_EQ(view.fluke_angle(), 0.5);
    EXPECT_NEAR(view.mud(), 0.4, 1e-12);

    Snapshot foul = weighing();
    foul.tackle[0].anchor.fouled = 0.2;
    view = forecastle(foul);
    EXPECT_EQ(view.anchor(), ANCHOR_SEEN_FOUL);
    EXPECT_EQ(view.mud(), 0); // under the old cable

    view = forecastle(riding());
    EXPECT_EQ(view.anchor(), ANCHOR_SEEN_UNDER_WATER);
    EXPECT_EQ(view.anchor_position(), Point3f());
    EXPECT_EQ(view.anchor_attitude(), Quaternion());
    EXPECT_EQ(view.mud(), 0);

    Snapshot s = weighing();
    s.tackle[0].anchor.phase = AnchorPhase::lost;
    EXPECT_EQ(forecastle(s).anchor(), ANCHOR_SEEN_UNDER_WATER);
    s.tackle[0].anchor.phase = AnchorPhase::housed;
    EXPECT_EQ(forecastle(s).anchor(), ANCHOR_SEEN_HOME);
    s.tackle[0].anchor.phase = AnchorPhase::acockbill;
    EXPECT_EQ(forecastle(s).anchor(), ANCHOR_SEEN_ACOCKBILL);
}

// Two lengths of its shank below a low bow it is at the hawse, and may be under water.
TEST(Forecastle, AnAnchorIsAcockbillWhereItIsDrawn) {
    Snapshot s = weighing();
    exercise::AnchorView& anchor = s.tackle[0].anchor;
    anchor.phase = AnchorPhase::acockbill;
    anchor.position.z() = -1;
    anchor.shackle.z() = 1; // at the waterline
    EXPECT_EQ(forecastle(s).anchor(), ANCHOR_SEEN_ACOCKBILL);
    EXPECT_EQ(forecastle(s).anchor_position().z(), -1);
    EXPECT_FALSE(forecastle(s).leads());

    anchor.position.z() = -2.1;
    anchor.shackle.z() = -0.1;
    EXPECT_EQ(forecastle(s).anchor(), ANCHOR_SEEN_UNDER_WATER);
    EXPECT_EQ(forecastle(s).anchor_position(), Point3f());
    EXPECT_TRUE(forecastle(s).leads());
    EXPECT_EQ(forecastle(s).lead_clock(), 11.5);

    anchor.phase = AnchorPhase::aweigh; // farther down: whether it is clear is seen once it is out
    anchor.shackle.z() = 1;
    anchor.position.z() = -1;
    EXPECT_EQ(forecastle(s).anchor(), ANCHOR_SEEN_UNDER_WATER);
    EXPECT_EQ(forecastle(s).anchor_position(), Point3f());
}

TEST(Forecastle, TheLiningIsSmeltInFiveSteps) {
    const auto smelt = [](double kelvin) {
        return with([&](TackleView& t) { t.windlass.lining_temperature = kelvin; });
    };
    EXPECT_EQ(smelt(300).lining(), LINING_COOL);
    EXPECT_EQ(smelt(340).lining(), LINING_WARM);
    EXPECT_EQ(smelt(430).lining(), LINING_SMELLS);
    EXPECT_EQ(smelt(530).lining(), LINING_SMOKES);
    EXPECT_EQ(smelt(680).lining(), LINING_BURNS);
    EXPECT_EQ(bytes(smelt(530)), bytes(smelt(672))); // and no finer
}

TEST(Forecastle, AThermometerIsAnAid) {
    const auto hot = [](TackleView& t) { t.windlass.lining_temperature = 530; };
    EXPECT_FALSE(with(hot).lining_temperature_shown());
    EXPECT_EQ(with(hot).lining_temperature(), 0);
    EXPECT_EQ(with(hot, {.lining_temperature = true}).lining_temperature(), 530);
}

TEST(Forecastle, UnderWaterIsLookedOnlyWithAnAid) {
    const SeatAids camera{.underwater = true};
    ForecastleView view = forecastle(riding(), camera);
    EXPECT_EQ(view.nodes().size(), 41U);
    EXPECT_EQ(view.marks().size(), 6U); // those outboard, and one on deck
    EXPECT_EQ(view.anchor(), ANCHOR_SEEN_UNDER_WATER);
    EXPECT_EQ(view.anchor_position().y(), 220);
    view = with(
        [](TackleView& t) {
            const Eigen::Vector3f anchor(40, 220, -24);
            t.chain.nodes.resize(2048, anchor - Eigen::Vector3f::UnitX());
            t.chain.nodes.back() = anchor;
        },
        camera);
    EXPECT_LE(view.nodes().size(), 256U);
    EXPECT_GT(view.nodes().size(), 200U);
    EXPECT_EQ(view.nodes().back().x(), 40); // down to the anchor
}

TEST(Forecastle, TheBrakeIsHeardByWhatGoesIntoIt) {
    const auto heard = [](double watts) {
        return with([&](TackleView& t) { t.windlass.brake_power = watts; }).brake_noise();
    };
    EXPECT_EQ(heard(0), 0);
    EXPECT_EQ(heard(2e3), 1);
    EXPECT_EQ(heard(2e5), 2);
    EXPECT_EQ(heard(2e6), 3);
}

TEST(Forecastle, TheMotorIsHeardInTenthsOfItsSpeed) {
    const auto heard = [](double speed) {
        return with([&](TackleView& t) { t.windlass.motor_speed = speed; }).motor_speed_heard();
    };
    EXPECT_NEAR(heard(43), 0.5, 1e-12);
    EXPECT_NEAR(heard(-80), -1, 1e-12);
    EXPECT_EQ(std::signbit(heard(-1)), false); // stands, to the ear
}

TEST(Forecastle, TheDeckShakesByWhatRunsOverIt) {
    const auto felt = [](auto change) { return with(change).vibration(); };
    EXPECT_EQ(felt([](TackleView&) {}), 0);
    EXPECT_EQ(felt([](TackleView& t) { t.windlass.cable_speed = 1; }), 1);
    EXPECT_EQ(felt([](TackleView& t) { t.windlass.cable_speed = -4; }), 2);
    EXPECT_EQ(felt([](TackleView& t) { t.windlass.cable_speed = 8; }), 3);
    EXPECT_EQ(felt([](TackleView& t) { t.windlass.gypsy_jumping = true; }), 3);
    EXPECT_EQ(felt([](TackleView& t) { t.windlass.brake_power = 2e6; }), 2);
    EXPECT_EQ(felt([](TackleView& t) { t.anchor.phase = AnchorPhase::dragging; }), 1);
}

TEST(Bridge, GpsIsCoarse) {
    Snapshot s = riding();
    s.ship.velocity = {0, -1.04 * kKnot, 0};
    const BridgeView view = bridge(s);
    EXPECT_EQ(view.position().x(), 10);
    EXPECT_EQ(view.position().y(), -20);
    EXPECT_NEAR(view.speed_over_ground(), kKnot, 1e-9);
    EXPECT_NEAR(view.course_over_ground(), 180 * kDegree, 1e-9);
    s.ship.velocity = {0.001, 0, 0};
    EXPECT_EQ(bridge(s).speed_over_ground(), 0);
    EXPECT_EQ(bridge(s).course_over_ground(), 0); // none at rest
}

TEST(Bridge, TelegraphWheelAndLeversStandWhereTheyWerePutWhateverComesOfIt) {
    Snapshot s = riding();
    s.ship.engine = 0.1, s.ship.engine_ordered = 0.7;
    s.ship.rudder_ordered = -0.2;
    s.ship.bow_thruster_ordered = 0.5, s.ship.stern_thruster_ordered = -0.5;
    const BridgeView view = bridge(s);
    EXPECT_EQ(view.engine(), 0.1);
    EXPECT_EQ(view.engine_ordered(), 0.7);
    EXPECT_EQ(view.rudder_ordered(), -0.2);
    EXPECT_EQ(view.bow_thruster_ordered(), 0.5);
    EXPECT_EQ(view.stern_thruster_ordered(), -0.5);
}

TEST(Bridge, TheLogGoesThroughTheWaterAtTheKeel) {
    Snapshot s = riding();
    s.ship.heading = 0;
    s.ship.surge = 2 * kKnot;
    s.environment.now.current_speed = kKnot;
    s.environment.now.current_towards = 0;
    EXPECT_NEAR(bridge(s).speed_through_water(), kKnot, 1e-9);
    s.environment.now.current_towards =
        std::numbers::pi / 2; // across: an electromagnetic log sees none of it
    EXPECT_NEAR(bridge(s).speed_through_water(), 2 * kKnot, 1e-9);
    s.environment.now.current_towards = 0;
    s.environment.now.current_profile = {{.depth = 0, .share = 1, .turn = 0},
                                         {.depth = 25, .share = 0, .turn = 0}}; // half at 12.5 m of draught
    EXPECT_NEAR(bridge(s).speed_through_water(), 1.5 * kKnot, 1e-9);
}

TEST(Bridge, TheEchoSounderLooksDownFromTheKeel) {
    Snapshot s = riding(); // 25.04 m of water, 12.5 m of draught
    EXPECT_NEAR(bridge(s).depth_below_keel(), 12.5, 1e-12);
    s.environment.depth = 11;
    EXPECT_EQ(bridge(s).depth_below_keel(), 0);
}

TEST(Bridge, FaultsOfTheShipTakeItsInstruments) {
    const auto with_fault = [](FaultCode code, FaultPhase phase = FaultPhase::active, double severity = 1) {
        Snapshot s = riding();
        exercise::FaultView& fault = s.faults.emplace_back();
        fault.order.code = code;
        fault.phase = phase;
        fault.severity_now = severity;
        return bridge(s);
    };
    BridgeView view = bridge(riding());
    EXPECT_TRUE(view.gps_works() && view.gyro_works() && view.log_works() && view.anemometer_works() &&
                view.echo_sounder_works() && view.vhf_works() && view.cctv_works());
    EXPECT_FALSE(with_fault(FaultCode::vhf_lost).vhf_works());
    EXPECT_FALSE(with_fault(FaultCode::cctv_lost).cctv_works());
    EXPECT_TRUE(with_fault(FaultCode::cctv_lost, FaultPhase::armed).cctv_works());
    EXPECT_TRUE(with_fault(FaultCode::cctv_lost, FaultPhase::cleared).cctv_works());
    EXPECT_TRUE(with_fault(FaultCode::cctv_lost, FaultPhase::active, 0.2).cctv_works());
    view = with_fault(FaultCode::ship_blackout);
    EXPECT_FALSE(view.log_works() || view.anemometer_works() || view.echo_sounder_works() ||
                 view.cctv_works());
    EXPECT_EQ(view.speed_through_water(), 0);
    EXPECT_EQ(view.wind_speed_apparent(), 0);
    EXPECT_EQ(view.depth_below_keel(), 0);
    EXPECT_TRUE(view.gps_works() && view.gyro_works() && view.vhf_works()); // emergency supply
    EXPECT_NE(view.heading(), 0);
    // A camera that has failed, or has no supply, shows nothing.
    ForecastleView picture;
    Snapshot dark = riding();
    EXPECT_TRUE(perceive_camera(dark, dark.tackle[0], picture));
    dark.faults.emplace_back().phase = FaultPhase::active;
    dark.faults[0].severity_now = 1;
    for (const FaultCode code : {FaultCode::cctv_lost, FaultCode::ship_blackout}) {
        dark.faults[0].order.code = code;
        EXPECT_FALSE(perceive_camera(dark, dark.tackle[0], picture));
    }
    // Those of the windlass are none of the bridge's.
    EXPECT_EQ(bytes(with_fault(FaultCode::brake_lining_faded)), bytes(bridge(riding())));
}

TEST(SeatShip, IsOfTheExercise) {
    const ExerciseDef def; // port only
    const SeatShip ship = seat_ship(def);
    EXPECT_EQ(ship.draught, def.ship.draught);
    EXPECT_NEAR(ship.motor_full_speed[0], 0.40 / 0.50 * 100, 1e-9);
    EXPECT_EQ(ship.motor_full_speed[1], 0);
}

// It is under the bow, which is the less deep where she is by the stern.
TEST(SeatShip, SoundsWhereTheSounderIs) {
    ExerciseDef def;
    def.ship.trim = 2.17;
    EXPECT_NEAR(seat_ship(def).draught_at_sounder, 12.5 - 0.01 * def.ship.hawse_forward, 1e-9);
}

} // namespace
} // namespace windlass::perceive
