// An anchor foul of its own cable or of an old one, and one that is bent: brought about by handling, and
// avoided by right handling with everything else the same.

#include "rigs/drill.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace windlass::exercise {

using namespace rigs;

namespace {

constexpr double kTurn = 2 * std::numbers::pi;

constexpr double kStream = 0.75; // m/s

/// So much cable (m) let go in 25 m: in a heap under a ship that is all but dead in the water, or laid out as
/// she falls back before a stream that sets in some direction (rad clockwise from north).
Drill paid_out(bool heap, double cable, double towards) {
    ExerciseDef def = quiet_def(25, 5);
    def.weather.current_speed = heap ? 0.1 : kStream;
    def.weather.current_towards = heap ? 0 : towards;
    if (!heap) def.ship_start.heading = towards + 0.5 * kTurn, def.ship_start.surge = -kStream;
    Drill drill(def);
    drill.brake(0);
    EXPECT_TRUE(drill.run_until_event("anchor.on_bottom", 30));
    const physics::Vec3 anchor = drill.anchor().shackle;
    const auto out = [&] {
        // As much as lies on the ground and hangs; in a heap all that there is.
        const physics::Vec3 lip = drill.chain().nodes.front().cast<double>();
        const double laid = 35 + std::hypot(lip.x() - anchor.x(), lip.y() - anchor.y());
        drill.grip(!heap && drill.chain().cable_out > laid ? 0.1 : 0);
        return drill.chain().cable_out > cable;
    };
    EXPECT_TRUE(drill.run_until(out, 400));
    drill.brake(1);
    drill.run(5);
    return drill;
}

/// The stream sets her off until the cable has come taut and the anchor holds or has been dragged 20 m.
void set_off(Drill& drill, double towards) {
    drill.current(kStream, towards);
    const double dragged = drill.anchor().dragged;
    drill.run_until([&] { return drill.anchor().dragged > dragged + 20 || drill.anchor().embedment > 0.9; },
                    1200);
}

/// Paid out like that, and drawn the way it was laid.
Drill drawn_out(bool heap, double cable, double towards) {
    Drill drill = paid_out(heap, cable, towards);
    set_off(drill, towards);
    return drill;
}

/// Engine and thrusters keep her bow going round the anchor, near it, on one heading.
class RoundTheAnchor {
public:
    explicit RoundTheAnchor(Drill& drill) : drill_(drill), heading_(drill.now().ship.heading) {}

    /// Half a second of it.
    void go_on() {
        const physics::Vec3 out = from_anchor();
        const double off = out.norm(), bearing = std::atan2(out.x(), out.y());
        if (off > kClear) turned_ += std::remainder(bearing - bearing_, kTurn);
        bearing_ = bearing;
        const physics::Vec3 away = physics::compass(bearing),
                            round = physics::compass(bearing - 0.25 * kTurn);
        steer((off < kClear ? kSpeed * away : kSpeed * round) +
              std::clamp(0.05 * (kRadius - off), -0.1, 0.1) * away);
        drill_.run(0.5);
    }
    /// Anticlockwise since she was first clear of it.
    double turns() const { return -turned_ / kTurn; }
    double bearing() const { return bearing_; } ///< rad, of the hawse from the anchor

private:
    static constexpr double kRadius = 12, kClear = 6; // m
    static constexpr double kSpeed = 0.15;            // m/s; more of it the thrusters do not turn in 12 m

    physics::Vec3 from_anchor() const {
        const physics::Vec3 way = drill_.chain().nodes.front().cast<double>() - drill_.anchor().shackle;
        return {way.x(), way.y(), 0};
    }
    /// bow: m/s over ground that her bow should have.
    void steer(const physics::Vec3& bow) {
        const auto& ship = drill_.now().ship;
        const physics::Vec3 ahead = physics::compass(ship.heading),
                            abeam = physics::compass(ship.heading + 0.25 * kTurn);
        const double surge = bow.dot(ahead) - ship.surge;
        const double sway =
            bow.dot(abeam) - ship.sway - drill_.exercise().def().ship.hawse_forward * ship.yaw_rate;
        const double yaw = 0.02 * std::remainder(heading_ - ship.heading, kTurn) - ship.yaw_rate;
        const auto order = [](double want) { return std::clamp(want, -1.0, 1.0); };
        drill_.helm(order(8 * surge), order(8 * sway + 2000 * yaw), order(8 * sway - 2000 * yaw));
    }

    Drill& drill_;
    double heading_ = 0, bearing_ = 0, turned_ = 0; // rad
};

/// The stream sets her off until the anchor is called foul: it comes home crown first, its flukes not in the
/// ground, and holds less than half of what it does sound, 340 kN; most only slide, 29 kN.
void until_foul(Drill& drill, double towards) {
    drill.current(kStream, towards);
    const AnchorView& anchor = drill.anchor();
    ASSERT_TRUE(drill.run_until([&] { return anchor.phase == AnchorPhase::fouled; }, 1200));
    EXPECT_LT(anchor.embedment, 0.5);
    EXPECT_LT(anchor.holding_capacity, 1.7e5);
}

/// Anchor let go in 25 m, and the ship taken round it. The cable goes out meanwhile, in turns; or she is kept
/// to what reaches the bottom until she has been stopped, and it goes out as she falls back. Then a stream
/// sets her off: until the rings foul the anchor, or the cable has come taut and it holds or was dragged 20
/// m.
Drill taken_round(double heading, bool veered_meanwhile) {
    constexpr double kUpAndDown = 36, kCable = 200; // m
    constexpr double kTurns = 3;
    ExerciseDef def = quiet_def(25, 5);
    def.ship_start.heading = heading;
    def.ship.bow_thruster = def.ship.stern_thruster = 150e3;
    Drill drill(def);
    drill.brake(0);
    EXPECT_TRUE(drill.run_until_event("anchor.on_bottom", 60));
    const auto veer_to = [&](double cable) { drill.grip(drill.chain().cable_out > cable ? 0.3 : 0); };
    RoundTheAnchor round(drill);
    while (round.turns() < kTurns && drill.now().time < 2000) {
        const double gone = std::clamp(round.turns() / kTurns, 0.0, 1.0);
        veer_to(veered_meanwhile ? kUpAndDown + gone * (kCable - kUpAndDown) : kUpAndDown);
        round.go_on();
    }
    EXPECT_GE(round.turns(), kTurns);
    drill.helm(0, 0, 0);
    drill.current(kStream, round.bearing());
    const physics::Vec3 anchor = drill.anchor().shackle;
    drill.run_until(
        [&] {
            const physics::Vec3 way = drill.chain().nodes.front().cast<double>() - anchor;
            veer_to(std::min(kUpAndDown + std::hypot(way.x(), way.y()), kCable));
            return drill.chain().cable_out > kCable - 1;
        },
        1000);
    drill.brake(1);
    if (veered_meanwhile)
        until_foul(drill, round.bearing());
    else
        set_off(drill, round.bearing());
    return drill;
}

/// Dug in at last, and not foul.
void expect_holding(Drill& drill) {
    // A turn may slip off at the very end: the phase is called when it has settled.
    EXPECT_TRUE(drill.run_until(
        [&] { return (drill.anchor().phase == AnchorPhase::fouled) == (drill.anchor().fouled > 0); }, 30));
    EXPECT_NE(drill.anchor().phase, AnchorPhase::fouled);
    EXPECT_GE(drill.anchor().embedment, 0.5);
}

/// Never called foul, and holds.
void expect_clear(Drill drill) {
    EXPECT_EQ(drill.count("anchor.fouled"), 0);
    expect_holding(drill);
}

} // namespace

// "Never pile the cable on the anchor." A ship that is taken round it while her cable goes out lays it there
// in rings, and drawn tight they catch it. The same ship on the same way with her brake on, stopped, and her
// cable veered as she falls back on it, is brought up.
TEST(FoulAnchor, CableThatGoesOutWhileSheIsTakenRoundFoulsTheAnchorAndVeeredWithSternwayDoesNot) {
    const Drill ringed = taken_round(kTurn / 4, true);
    EXPECT_LT(ringed.now().model_error.load, 0) << "when it turns round is luck, and no error is estimated";
    Drill veered = taken_round(kTurn / 4, false);
    EXPECT_GE(veered.now().model_error.load, 0);
    expect_clear(std::move(veered));
}

// Of 18 that were so taken round it, on four headings and in some millimetres more of water, all fouled it;
// when the rings slip off is chance: two still had them after 20 m. Of 16 with their cable veered all were
// brought up, one of them called foul on the way.
TEST(FoulAnchor, RingsFoulItOnEveryHeadingAndWhoseCableIsVeeredWithSternwayIsBroughtUp) {
    int called = 0;
    for (int quarter = 0; quarter < 4; ++quarter) {
        const double heading = quarter * kTurn / 4;
        taken_round(heading, true);
        Drill veered = taken_round(heading, false);
        called += std::min(veered.count("anchor.fouled"), 1);
        expect_holding(veered);
    }
    EXPECT_LE(called, 1);
}

// From its top. For a while the cable leads over the anchor, and may draw its shackle back over the crown. Of
// 18 heaps of 106 to 114 m 11 caught it: which do is chance, that some do and some do not is not.
TEST(FoulAnchor, HeapThatIsDrawnOutStraightCatchesTheAnchorOrComesClearAndIsNotCalledFoul) {
    int foul = 0, heaps = 0;
    for (const double cable : {106, 109, 112})
        for (int eighth = 1; eighth < 4; ++eighth, ++heaps) {
            Drill drill = drawn_out(true, cable, eighth * kTurn / 8);
            if (drill.anchor().phase == AnchorPhase::fouled)
                ++foul;
            else
                expect_clear(std::move(drill));
        }
    EXPECT_GE(foul, 2);
    EXPECT_LE(foul, heaps - 2);
}

TEST(FoulAnchor, CableLaidOutWithSternwayStaysClear) {
    for (int eighth = 0; eighth < 8; ++eighth)
        expect_clear(drawn_out(false, 165, eighth * kTurn / 8));
}

namespace {

/// The anchor dug in in 100 m and an old cable hooked on its flukes; hove in at full lever.
Drill heaving_foul() {
    ExerciseDef def = quiet_def(100, 100);
    def.weather.current_speed = 1; // sets her back on her cable
    def.weather.current_towards = 0.5 * kTurn;
    def.ship_start.surge = -0.5;
    Drill drill(def);
    drill.fault(FaultCode::anchor_fouled);
    drill.brake(0);
    EXPECT_TRUE(drill.run_until([&] { return drill.chain().cable_out > 115; }, 60));
    for (double grip = 0.1; drill.chain().cable_out < 270 && drill.now().time < 900; drill.run(0.1)) {
        grip = std::clamp(grip + 0.002 * (drill.windlass().cable_speed - 0.7), 0.0, 1.0); // at her own speed
        drill.grip(grip);
    }
    drill.brake(1);
    // Hooked: more than any soil gives.
    EXPECT_TRUE(drill.run_until([&] { return drill.anchor().holding_capacity > 1e6; }, 600));
    drill.current(0, 0); // fetched up, she comes ahead on her cable
    EXPECT_TRUE(drill.run_until([&] { return drill.now().ship.surge > 0.1; }, 600));
    drill.clutch(true);
    EXPECT_TRUE(drill.run_until([&] { return drill.windlass().clutch == ClutchState::in; }, 60));
    drill.brake(0);
    drill.speed_lever(1);
    return drill;
}

} // namespace

// Fouled and heavy: stopper, brake, declutch at once before anything else; a shaft that had had its knocks
// gave way, three shackles ran, shaft and claw coupling were replaced (MARS 201410). Hung off, and the old
// cable slipped, the same shaft brings the anchor home.
TEST(FoulAnchor, HeavingOnShearsTheShaftAndHangingOffClearsTheAnchor) {
    for (const bool hung_off : {false, true}) {
        Drill drill = heaving_foul();
        // Aweigh, and the load grows with every metre.
        ASSERT_TRUE(drill.run_until([&] { return drill.anchor().height_above_bottom > 5; }, 2500));
        EXPECT_EQ(drill.anchor().phase, AnchorPhase::fouled);
        EXPECT_GT(drill.count("anchor.fouled"), 0);
        drill.fault(FaultCode::clutch_shaft_damaged, 0.8); // 400 kN are left
        if (hung_off) {
            drill.speed_lever(0);
            drill.brake(1);
            drill.run(5);
            drill.clutch(false);
            drill.run(2);
            drill.stopper(true);
            drill.run(10);
            drill.clear(FaultCode::anchor_fouled); // slipped
            drill.run(5);
            EXPECT_EQ(drill.anchor().phase, AnchorPhase::aweigh);
            EXPECT_EQ(drill.anchor().carried, 0);
            drill.clutch(true);
            ASSERT_TRUE(drill.run_until([&] { return drill.windlass().clutch == ClutchState::in; }, 60));
            drill.stopper(false);
            drill.brake(0);
            drill.run(5); // not against a brake that is still on
            drill.speed_lever(1);
        }
        const double out = drill.chain().cable_out;
        drill.run_until([&] { return drill.chain().cable_out < 8 || drill.count("clutch.sheared") > 0; },
                        900);
        drill.run(15);
        EXPECT_EQ(drill.count("clutch.sheared") > 0, !hung_off);
        EXPECT_EQ(drill.chain().cable_out < 8, hung_off);
        EXPECT_EQ(drill.chain().cable_out > out + 27.5, !hung_off) << drill.chain().cable_out; // it ran
    }
}

namespace {

/// rad, between the anchor's shank and the bearing of the hawse pipe from it.
double off_the_shank(const Drill& drill) {
    const physics::Vec3 shank = drill.anchor().attitude * physics::Vec3::UnitX();
    const physics::Vec3 lead = drill.chain().nodes.front().cast<double>() - drill.anchor().shackle;
    return std::abs(std::atan2(shank.cross(lead).z(), shank.dot(lead)));
}

/// Six shackles laid out, the anchor dug in and then caught on something that holds more than any soil; and a
/// stream athwart, on which she drifts past until her cable leads off across the shank.
Drill athwart_of_caught_anchor() {
    Drill drill = drawn_out(false, 165, 0);
    drill.run(600);
    drill.fault(FaultCode::anchor_fouled);
    drill.run(300);
    drill.current(0.6, 0.25 * kTurn);
    EXPECT_TRUE(drill.run_until([&] { return off_the_shank(drill) > 0.2 * kTurn; }, 1500));
    EXPECT_GT(drill.anchor().holding_capacity, 1e6);
    EXPECT_EQ(drill.anchor().bent, 0);
    return drill;
}

} // namespace

// An anchor fast in rock or under a cable is not torn out by the engine: she gathers way on her slack cable,
// fetches up across the shank and bends it. Left to come into her cable on the tide, the anchor turns to the
// pull and stays whole.
TEST(BentAnchor, BendsWhenTornAtAthwartAndNotWhenSheComesIntoHerCableSlowly) {
    for (const bool torn : {true, false}) {
        Drill drill = athwart_of_caught_anchor();
        drill.engine(torn ? -1 : 0);
        drill.run(torn ? 300 : 1600);
        EXPECT_LT(off_the_shank(drill), 0.2 * kTurn);
        EXPECT_EQ(drill.anchor().bent > 0, torn) << drill.anchor().bent;
    }
}

} // namespace windlass::exercise
