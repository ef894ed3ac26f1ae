// Quantities of a condition that are worked out of several places.

#include "server/assess/hawse.hpp"
#include "server/assess/quantities.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace windlass::assess {

namespace {

double quantity(const char* name, const exercise::Snapshot& seen) {
    return quantity_at(quantity_of(name)).read(seen, seen.tackle.front());
}

/// A ship that heads by so many degrees, her pipes 8 m apart and 110 m from midships, between two anchors 300
/// m apart in line east and west: port's to the west, as a standing moor lays them for a ship that heads
/// north.
exercise::Snapshot moored(double heading_deg) {
    exercise::Snapshot seen;
    seen.tackle.resize(2);
    const double heading = heading_deg * std::numbers::pi / 180;
    const physics::Vec3 ahead(std::sin(heading), std::cos(heading), 0), right(ahead.y(), -ahead.x(), 0);
    for (int side : {0, 1}) {
        exercise::TackleView& tackle = seen.tackle[static_cast<std::size_t>(side)];
        const double out = side == 0 ? -1 : 1;
        tackle.side = static_cast<exercise::Side>(side);
        tackle.hawse = 4 * out * right;
        tackle.anchor.position = physics::Vec3(150 * out, 0, -20);
    }
    return seen;
}

using Cable = std::vector<Eigen::Vector3f>;

/// A ship that heads north and lies back on both cables, which lead ahead from her pipes 8 m apart and spread
/// to their anchors, port's to the west; on the way they cross so often as she has made half turns. Turned to
/// starboard (positive), port's pipe has passed over starboard's cable: port is on top where they cross last,
/// next to the anchors, under the other where they cross before that, and so on; to port the other way about.
std::pair<Cable, Cable> turned(int half_turns) {
    const int crosses = std::abs(half_turns);
    float side = crosses % 2 == 0 ? -1 : 1; // of port: -1 west
    float y = 0;
    Cable port{{4 * side, y, 6}}, starboard{{-4 * side, y, 6}};
    const auto go_on = [&](float out, float north, float z, float higher) {
        y += north;
        port.push_back({out * side, y, z + higher});
        starboard.push_back({-out * side, y, z - higher});
    };
    for (int k = 0; k < crosses; ++k) {
        const float higher = ((crosses - k) % 2 == 1) == (half_turns > 0) ? 0.1F : -0.1F;
        go_on(0.5F, 6, 5 - 2.0F * static_cast<float>(k), higher);
        side = -side;
        go_on(0.5F, 1, 4 - 2.0F * static_cast<float>(k), higher);
    }
    go_on(4, 10, -10, 0);
    go_on(40, 40, -20, 0);
    go_on(150, 60, -20, 0);
    return {port, starboard};
}

double turns_in_hawse_of(Cable port, Cable starboard) {
    exercise::Snapshot seen = moored(0);
    seen.tackle[0].chain.nodes = std::move(port);
    seen.tackle[1].chain.nodes = std::move(starboard);
    return quantity("turns_in_hawse", seen);
}

} // namespace

// She lies by her bow in the middle: open while port's pipe is on port anchor's side, crossed while it is on
// the other.
TEST(Quantities, LeadsAreCrossedWhileSheHeadsAwayFromTheSideThatKeepsHerHawseOpen) {
    for (const double heading : {0.0, 45.0, 80.0, -45.0, -80.0})
        EXPECT_EQ(quantity("leads_crossed", moored(heading)), 0) << heading;
    exercise::Snapshot off = moored(180);
    // Turned round, and a little off the line of the anchors, as streams leave her.
    for (exercise::TackleView& tackle : off.tackle)
        tackle.hawse.y() += 10;
    EXPECT_EQ(quantity("leads_crossed", off), 1);
    off.tackle.pop_back();
    EXPECT_EQ(quantity("leads_crossed", off), 0) << "one cable crosses nothing";
}

TEST(Quantities, TurnsInTheHawseAreNoneACrossAnElbowARoundTurnAndTellWhichWaySheHasTurned) {
    for (const int made : {0, 1, 2, 3, 4, -1, -2, -3, -4}) {
        const auto [port, starboard] = turned(made);
        EXPECT_EQ(turns_in_hawse_of(port, starboard), made);
    }
    exercise::Snapshot one = moored(0);
    one.tackle[0].chain.nodes = turned(2).first;
    one.tackle.pop_back();
    EXPECT_EQ(quantity("turns_in_hawse", one), 0) << "one cable has no turn about another";
}

// By hand, in a few links: in line with a stream she heads north, port ahead, starboard aft along her side.
TEST(Quantities, AShipThatSwingsThroughTheWrongSideOfTheLineOfHerAnchorsHasACross) {
    const Eigen::Vector3f north(0, 150, -20), south(0, -150, -20);
    const Cable ahead{{-4, 0, 6}, {-2, 20, -20}, north}, aft{{4, 0, 6}, {6, -20, -20}, south};
    EXPECT_EQ(turns_in_hawse_of(ahead, aft), 0);
    EXPECT_NEAR(half_turns_between(ahead, aft), -0.5, 1e-6);
    // South, through east: port to the north along her port side, starboard ahead.
    const Cable to_port{{4, 0, 6}, {6, 20, -20}, north}, to_starboard{{-4, 0, 6}, {-2, -20, -20}, south};
    EXPECT_EQ(turns_in_hawse_of(to_port, to_starboard), 0);
    EXPECT_NEAR(half_turns_between(to_port, to_starboard), 0.5, 1e-6);
    // South, through west, to port: port's cable comes round the stem, over starboard's, to her other side.
    const Cable round{{4, 0, 6}, {0, -6, 5.5}, {-6, -6, 5}, {-8, 20, -20}, north};
    EXPECT_EQ(turns_in_hawse_of(round, to_starboard), -1);
    EXPECT_NEAR(half_turns_between(round, to_starboard), -1.5, 1e-6);
    // The same way under it, as slack cable may lie: that is drawn back under the bow, and is no turn.
    const Cable under{{4, 0, 6}, {0, -6, -2}, {-6, -6, -8}, {-8, 20, -20}, north};
    EXPECT_EQ(turns_in_hawse_of(under, to_starboard), 0);
}

TEST(Quantities, AShipThatSheersHasNoMoreTurnsInHerHawse) {
    for (const double sheer : {-40.0, -10.0, 10.0, 40.0}) {
        exercise::Snapshot seen = moored(sheer); // anchors on either side
        for (exercise::TackleView& tackle : seen.tackle)
            tackle.chain.nodes = {tackle.hawse.cast<float>(), tackle.anchor.position.cast<float>()};
        EXPECT_EQ(quantity("turns_in_hawse", seen), 0) << sheer;
        EXPECT_NEAR(half_turns_between(seen.tackle[0].chain.nodes, seen.tackle[1].chain.nodes), sheer / 180,
                    1e-6);
    }
}

TEST(Quantities, ABightThatLiesOverTheOtherCableIsNoTurnInTheHawse) {
    auto [port, starboard] = turned(0);
    // Port's cable over starboard's and back over it, as a slack one is washed to and fro.
    port = {{-4, 0, 6}, {-4, 10, 0}, {30, 20, 0}, {-4, 30, 0}, port.back()};
    EXPECT_EQ(turns_in_hawse_of(port, starboard), 0);
    // Over and back under: it has been passed round it, a whole turn.
    port = {{-4, 0, 6}, {-4, 10, 0}, {30, 20, 0}, {30, 20, -30}, {-4, 30, -30}, port.back()};
    EXPECT_EQ(turns_in_hawse_of(port, starboard), -2);
}

TEST(Quantities, TurnsInTheHawseAreTheSameHoweverFineTheLinksAndWhereverTheStreamTakesThem) {
    for (const int made : {1, 2, -3}) {
        auto [port, starboard] = turned(made);
        const auto finer = [](const Cable& cable) {
            Cable fine;
            for (std::size_t i = 0; i + 1 < cable.size(); ++i)
                for (int k = 0; k < 20; ++k)
                    fine.push_back(cable[i] + static_cast<float>(k) / 20 * (cable[i + 1] - cable[i]));
            fine.push_back(cable.back());
            return fine;
        };
        EXPECT_EQ(turns_in_hawse_of(finer(port), starboard), made);
        EXPECT_EQ(turns_in_hawse_of(finer(port), finer(starboard)), made);
        for (Cable* cable : {&port, &starboard}) // a stream washes both aside
            for (Eigen::Vector3f& node : *cable)
                if (node.y() > 0 && node.y() < 50) node += Eigen::Vector3f(12, -3, -2);
        EXPECT_EQ(turns_in_hawse_of(finer(port), finer(starboard)), made);
    }
}

} // namespace windlass::assess
