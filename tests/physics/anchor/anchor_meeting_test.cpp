// Anchor against anchor: they stay out of each other, and make neither momentum nor energy.

#include "server/physics/anchor/anchor_meeting.hpp"
#include "tests/physics/base/bits.hpp"
#include "tests/physics/solver/chain_rig.hpp"
#include "tests/physics/solver/two_cables.hpp"

#include <gtest/gtest.h>

#include <random>

namespace windlass::physics {
namespace {

/// Numbers of -1 to 1.
struct Dice {
    std::mt19937 random;
    explicit Dice(int seed) : random(seed) {}
    double one() { return std::uniform_real_distribution<double>(-1, 1)(random); }
    Vec3 vector() {
        const double x = one(), y = one();
        return {x, y, one()};
    }
    Eigen::Quaterniond attitude() {
        const Vec3 v = vector();
        return Eigen::Quaterniond(one(), v.x(), v.y(), v.z()).normalized();
    }
    Box box() {
        const Vec3 half = vector().cwiseAbs() + Vec3::Constant(0.1), centre = 0.8 * vector();
        return {centre, half, attitude().toRotationMatrix()};
    }
};

constexpr double kFar = 1e9; ///< m, room within which boxes are looked at

TEST(BoxSeparation, IsTheShortestWayThatPartsThem) {
    Dice dice(1);
    int overlapping = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        Box a = dice.box();
        const Box b = dice.box();
        const BoxSeparation met = separation(a, b, kFar);
        if (met.distance > 0) continue;
        ++overlapping;
        const Vec3 at = a.centre, other = dice.vector().normalized();
        a.centre = at - met.distance * met.normal;
        ASSERT_NEAR(separation(a, b, kFar).distance, 0, 2e-6) << trial; // edges give way to faces by 1e-6 m
        a.centre = at - 0.99 * met.distance * other;
        ASSERT_LT(separation(a, b, kFar).distance, 0) << trial;
    }
    EXPECT_GT(overlapping, 500);
}

TEST(BoxSeparation, IsNotMoreThanTheirDistance) {
    Dice dice(2);
    int apart = 0;
    for (int trial = 0; trial < 500; ++trial) {
        const Box a = dice.box(), b = dice.box();
        const BoxSeparation met = separation(a, b, kFar);
        apart += met.distance > 0 ? 1 : 0;
        for (int k = 0; k < 100; ++k) {
            const Vec3 in_a = a.centre + a.axes * a.half.cwiseProduct(dice.vector());
            const Vec3 on_b = b.axes.transpose() * (in_a - b.centre);
            const double from_b = (on_b.cwiseAbs() - b.half).cwiseMax(0).norm();
            ASSERT_LE(met.distance, from_b) << trial; // 0: the point is in both
        }
    }
    EXPECT_GT(apart, 50);
}

TEST(BoxSeparation, ChangesAsItsPointMovesAlongItsNormal) {
    constexpr double kShort = 1e-6; // what is left is of its square
    Dice dice(3);
    for (int trial = 0; trial < 2000; ++trial) {
        Box a = dice.box();
        const Box b = dice.box();
        const BoxSeparation met = separation(a, b, kFar);
        if (met.distance > -1e-3) continue;
        const Vec3 shift = dice.vector(), turn = dice.vector();
        const Vec3 way = shift + turn.cross(met.point - a.centre);
        a.centre += kShort * shift;
        a.axes = Eigen::AngleAxisd(kShort * turn.norm(), turn.normalized()).toRotationMatrix() * a.axes;
        const double change = separation(a, b, kFar).distance - met.distance;
        ASSERT_NEAR(change / kShort, met.normal.dot(way), 1e-4) << trial;
    }
}

/// Deepest that two anchors are in each other, m.
double deepest(const Anchor& a, const Anchor& b) {
    double deepest = 0;
    for (int i = 0; i < a.boxes(); ++i)
        for (int j = 0; j < b.boxes(); ++j)
            deepest = std::max(deepest, -separation(a.box(i), b.box(j), 0).distance);
    return deepest;
}

std::size_t anchors_met(const PairContacts& ties) {
    std::size_t met = 0;
    for (const PairContact& pair : ties.all())
        met += pair.body_a == Body::anchor ? 1 : 0;
    return met;
}

/// Two anchors in air without cables, tumbling at each other from 5 m.
struct ThrownAnchors {
    EnvironmentDef environment = in_air();
    Anchor a, b;
    ChainState no_cable = straight_chain(ChainDef(), Vec3::Zero(), Vec3::UnitZ(), 1, 4);
    SymmetricField yielding{4};
    Field predicted{4};
    PairContacts ties{1024};
    EnergyLedger ledger; ///< of both
    double dt;

    ThrownAnchors(int seed, AnchorType type, double speed, double step)
        : a(typical_anchor(type), 0, environment, {}), b(typical_anchor(type), 0, environment, {}), dt(step) {
        Dice dice(seed);
        throw_from(a, {-2.5, 0, 100}, 0.5 * speed, dice);
        throw_from(b, {2.5, 0, 100}, -0.5 * speed, dice);
    }
    static void throw_from(Anchor& anchor, const Vec3& at, double speed, Dice& dice) {
        const Eigen::Quaterniond attitude = dice.attitude();
        const Vec3 aside = 0.5 * dice.vector();
        anchor.set_pose({at + aside, attitude, {speed, 0, 0}, dice.vector()});
        anchor.turn_flukes(0.6 * dice.one());
    }

    void step() {
        const StepTime time{dt, dt};
        ties.clear();
        find_anchor_meetings(environment, a, b, dt, ties);
        const Vec3 shackle_a = a.begin(environment, time, {}, {}).velocity,
                   shackle_b = b.begin(environment, time, {}, {}).velocity;
        const AnchorEnd end_a = a.end(), end_b = b.end();
        const std::array<CableInStep, 2> in{
            {{&no_cable, &yielding, &predicted, &end_a}, {&no_cable, &yielding, &predicted, &end_b}}};
        ties.enter(in, time);
        ties.press();
        const Vector7 after_a = finish(a, end_a, shackle_a, ties.pushed(0)),
                      after_b = finish(b, end_b, shackle_b, ties.pushed(1));
        const std::array<CableAfter, 2> after{{{&no_cable, after_a}, {&no_cable, after_b}}};
        ledger.contact += ties.work(after);
    }
    Vector7 finish(Anchor& anchor, const AnchorEnd& end, const Vec3& shackle, const Vector7& pushed) {
        anchor.push(pushed);
        const Vec3 as_nothing_pulls = shackle + point_velocity({.arm = end.shackle}, pushed);
        return anchor.finish(environment, {dt, dt}, as_nothing_pulls, &ledger);
    }
    double energy() const {
        return a.kinetic_energy() + b.kinetic_energy() + a.potential_energy(environment) +
               b.potential_energy(environment);
    }
    double mass() const { return a.mass() + b.mass(); }
    Vec3 momentum() const { return a.mass() * a.motion().head<3>() + b.mass() * b.motion().head<3>(); }
};

TEST(AnchorMeeting, ThrownAnchorsStayApartAndMakeNeitherMomentumNorEnergy) {
    constexpr std::array kTypes{AnchorType::hall, AnchorType::ac14, AnchorType::shhp, AnchorType::stock};
    for (const double speed : {2.0, 10.0}) { // a hit at 10 m/s: twice what an anchor falls with in water
        int hits = 0;
        for (int seed = 1; seed <= 24; ++seed) {
            ThrownAnchors two(seed, kTypes[seed % kTypes.size()], speed, kTick);
            const double start = two.energy(), moving = two.a.kinetic_energy() + two.b.kinetic_energy();
            double worst = 0, deep = 0, min = 0, made = 0, fell = 0;
            std::size_t met = 0;
            for (int k = 0; k < 600; ++k) {
                const Vec3 before = two.momentum();
                two.step();
                const Vec3 given(0, 0, -kTick * two.mass() * kGravity);
                worst = std::max(worst, (two.momentum() - before - given).norm() / (two.mass() * speed));
                deep = std::max(deep, deepest(two.a, two.b));
                min = std::min(min, two.ledger.contact);
                // What falls with the speed of a step's end loses so much in a step.
                fell += 0.5 * two.mass() * std::pow(kTick * kGravity, 2);
                made = std::max(made, two.energy() + fell + sum(two.ledger) - start);
                met += two.ties.all().size();
            }
            hits += met > 0 ? 1 : 0;
            EXPECT_LT(worst, 1e-9) << speed << " " << seed;               // as wanted, in each step
            EXPECT_LT(deep, 0.05) << speed << " " << seed;                // a step and a half of the way
            EXPECT_GE(min, -1e-9 * moving) << speed << " " << seed;       // at no time has contact given any
            EXPECT_LT(made, 0.02 * moving + 500) << speed << " " << seed; // they tumble at first order
        }
        EXPECT_GT(hits, 18) << speed; // of 24, tumbling past each other
    }
}

/// Hanging beside each other, 4 m apart; the first one's lip is moved until they would hang in each other.
TwoCables side_by_side(const EnvironmentDef& sea) {
    TwoCables rig{sea, held(6), {0, 0, 0}, held(6), {4, 0.2, 0}};
    rig.finer = 4; // the anchors turn at first order
    return rig;
}
Vec3 swung_together(double time) {
    return time < 4 ? Vec3(0.95, 0, 0) : Vec3(Vec3::Zero());
}

TEST(AnchorMeeting, AnchorsSwungTogetherLeanOnEachOtherAndTheBooksClose) {
    for (const bool water : {false, true}) {
        TwoCables rig = side_by_side(water ? still_water(50) : in_air());
        const double start = rig.energy();
        double stirred = 0, max = -1e300, deep = 0; // J, J, m
        std::size_t met = 0;
        for (int k = 0; k < 300 * 10; ++k) {
            const double before = rig.a.ledger().hull + rig.b.ledger().hull;
            rig.step(swung_together(k * kTick));
            met += anchors_met(rig.crossing.ties());
            deep = std::max(deep, deepest(rig.a.anchor(), rig.b.anchor()));
            stirred += std::abs(rig.a.ledger().hull + rig.b.ledger().hull - before);
            max = std::max(max, rig.energy() - start + rig.booked());
            ASSERT_TRUE(rig.a.finite() && rig.b.finite()) << k;
        }
        EXPECT_GT(met, 300u) << water;
        EXPECT_LT(deep, 0.01) << water; // a hundred kilonewtons press them by 3 mm
        // Lips 0.3 m apart, and anchors that are 0.4 m thick where they are thinnest.
        EXPECT_GT((rig.b.anchor().pose().position - rig.a.anchor().pose().position).norm(), 0.4) << water;
        EXPECT_GT(rig.a.ledger().contact, 0.05 * stirred) << water;
        EXPECT_LT(max / stirred, 0.005) << water; // as of cables swung together
        EXPECT_NEAR((rig.energy() - start + rig.booked()) / stirred, 0, 0.005) << water;
    }
}

TEST(AnchorMeeting, GivesTheSameBitsTwice) {
    const auto run = [] {
        TwoCables rig = side_by_side(still_water(50));
        for (int k = 0; k < 1500; ++k)
            rig.step(swung_together(k * kTick));
        EXPECT_GT(rig.a.ledger().contact, 0);
        return rig.b.anchor().motion();
    };
    const Vector6 one = run(), other = run();
    EXPECT_EQ(bits({one.data(), 6}), bits({other.data(), 6}));
}

TEST(AnchorMeeting, IsSeenComing) {
    const auto near = [](double apart) { // none of either is within 1.5 m of the other's cable
        TwoCables rig{still_water(60), held(20), {0, 0, 6}, held(20), {apart, 0, 6}};
        return rig.crossing.near(rig.a, rig.b, 1.5);
    };
    EXPECT_TRUE(near(4.5));
    EXPECT_FALSE(near(7));
}

/// The first anchor is walked out on its motor, clutch in; the second hangs on its brake and is let go.
struct FoulAnchors : TwoCables {
    double deep = 0, load = 0; ///< m; N, the most at either lip
    double fastest = 0;        ///< m/s, of the second anchor
    std::size_t met = 0;

    FoulAnchors(const Vec3& first, const Vec3& second)
        : TwoCables(still_water(20), on_the_motor(), first, held(3), second) {
        of_a.levers.clutch_in = true;
    }
    static TackleSetup on_the_motor() {
        TackleSetup setup = held(3);
        setup.clutch_in = true, setup.brake = 0;
        return setup;
    }
    void run(double seconds, const Vec3& speed_a = Vec3::Zero()) {
        for (int k = 0; k < seconds / kTick; ++k) {
            step(speed_a);
            deep = std::max(deep, deepest(a.anchor(), b.anchor()));
            load = std::max({load, a.last_step().top_pull, b.last_step().top_pull});
            met += anchors_met(crossing.ties());
            fastest = std::max(fastest, b.anchor().motion().head<3>().norm());
            ASSERT_TRUE(a.finite() && b.finite()) << k;
        }
    }
    void walk_out(double cable_out) {
        of_a.levers.speed = -1;
        while (a.windlass().state().cable_out < cable_out)
            step();
        of_a.levers.speed = 0;
    }
};

/// The second one's anchor falls until so much of its cable is out.
void let_go(FoulAnchors& rig, double cable_out) {
    rig.of_b.levers.brake = 0;
    for (int k = 0; k < 300 * 12 && rig.b.windlass().state().cable_out < cable_out; ++k)
        rig.run(kTick);
    rig.of_b.levers.brake = 1;
    rig.run(5);
}

TEST(AnchorMeeting, OneLetGoOnAnotherThatHangsStrikesItAndFallsOn) {
    for (const double aside : {0.0, 0.4, 0.8}) {
        FoulAnchors rig({0, 0, 6}, {4, 0.3, 6});
        const double start = rig.energy();
        rig.walk_out(12);
        rig.run(4 - aside, Vec3::UnitX());
        rig.run(4);
        let_go(rig, 26);
        EXPECT_GT(rig.met, 10u) << aside;
        EXPECT_LT(rig.deep, 0.1) << aside; // half of what flukes are thick: 1 to 5 cm
        // Both together, on the stiff cable: v/2 sqrt(2 m EA / l).
        const ChainDef& chain = rig.a.setup().chain;
        const double m = rig.a.anchor().mass(), length = 12 + rig.a.setup().windlass.hawse_pipe_length;
        EXPECT_LT(rig.load, 0.5 * rig.fastest * std::sqrt(2 * m * chain.stiffness / length)) << aside;
        EXPECT_LT(rig.b.anchor().pose().position.z(), -19) << aside;
        EXPECT_NEAR(rig.a.anchor().pose().position.z(), -8.1, 0.2) << aside;
        // What is not booked comes of the blow, whose contacts a step of 1/300 s begins and ends: of its
        // energy 2.6 to 3.4 %.
        const double blow = 0.5 * m * rig.fastest * rig.fastest;
        EXPECT_NEAR((rig.energy() - start + rig.booked()) / blow, 0, 0.04) << aside << ' ' << rig.fastest;
    }
}

TEST(AnchorMeeting, OneHoveUpFromUnderAnotherLiftsIt) {
    int lifted = 0;
    for (const double ahead :
         {-0.6, -0.2, 0.0, 0.2, 0.6}) { // m, of the middle of the one that lies, along its shank
        FoulAnchors rig({0, 0, 6}, {0, 6, 6});
        rig.walk_out(27);
        rig.run(4, Vec3::UnitX());
        const AnchorPose below = rig.a.anchor().pose();
        const Vec3 over = below.position + below.attitude * Vec3(ahead, 0, 0) - rig.of_b.lip;
        for (int k = 0; k < 300 * 12; ++k)
            rig.step(Vec3::Zero(), Vec3(over.x(), over.y(), 0) / 12);
        rig.run(8);
        let_go(rig, 26);
        EXPECT_GT(rig.met, 300u) << ahead;
        const double lying = rig.b.anchor().pose().position.z();
        rig.load = 0;
        rig.of_a.levers.speed = 1;
        double highest = lying;
        for (int k = 0; k < 300 * 60; ++k) {
            rig.run(kTick);
            highest = std::max(highest, rig.b.anchor().pose().position.z());
        }
        lifted += highest > lying + 0.3 ? 1 : 0;
        EXPECT_LT(rig.deep, 0.1) << ahead;   // as above
        EXPECT_LT(rig.load, 900e3) << ahead; // as it is, hooked, too: the motor stalls with 880 kN
        EXPECT_GT(rig.a.anchor().pose().position.z(), -10) << ahead;
    }
    EXPECT_GE(lifted, 2); // 3; the others were let go of at once
}

} // namespace
} // namespace windlass::physics
