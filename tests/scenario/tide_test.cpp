// The tide: what rises is the water, with the ship, her hawse pipes and all that floats; the bed and what
// lies on it stay.

#include "rigs/drill.hpp"
#include "server/exercise/checkpoint.hpp"
#include "server/exercise/prelude.hpp"
#include "server/physics/chain/chain_def.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace windlass::exercise {
using namespace rigs;

namespace {

using physics::Vec3;

EnvironmentOrder tide_ordered(const Drill& drill, double height, double ramp) {
    EnvironmentOrder order{.weather = drill.now().environment.now, .ramp = ramp};
    order.weather.tide_height = height;
    return order;
}

/// The anchor on the bottom of 25 m, 40 m of cable out and the brake on.
Drill let_go() {
    Drill drill(quiet_def(25, 5));
    drill.brake(0);
    EXPECT_TRUE(drill.run_until([&] { return drill.chain().cable_out > 40; }, 60));
    drill.brake(1);
    drill.run(30);
    EXPECT_EQ(drill.anchor().phase, AnchorPhase::on_bottom);
    return drill;
}

// Three rows, 100 s apart: half-way between two of them height and stream are their mean, the stream as a
// vector: from 1 m/s to the north to 1 m/s to the east by 0.71 to the north-east.
TEST(Tide, GoesBetweenTheRowsOfItsTableInStraightLines) {
    ExerciseDef def = quiet_def(25, 5);
    def.weather.tide_height = 1, def.weather.current_speed = 1, def.weather.current_towards = 0;
    def.tide = {{.time = 0, .height = 1, .current_speed = 1, .current_towards = 0},
                {.time = 100, .height = 1.8, .current_speed = 1, .current_towards = std::numbers::pi / 2},
                {.time = 200, .height = 1.2, .current_speed = 0.5, .current_towards = std::numbers::pi / 2}};
    Drill drill(def);
    EXPECT_EQ(drill.now().environment.depth, 26);
    drill.run(50);
    const Weather* now = &drill.now().environment.now;
    EXPECT_NEAR(now->tide_height, 1.4, 1e-9);
    EXPECT_NEAR(now->current_speed, std::sqrt(0.5), 1e-9);
    EXPECT_NEAR(now->current_towards, std::numbers::pi / 4, 1e-9);
    drill.run(100);
    EXPECT_NEAR(now->tide_height, 1.5, 1e-9);
    EXPECT_NEAR(now->current_speed, 0.75, 1e-9);
    drill.run(100);
    EXPECT_NEAR(now->tide_height, 1.2, 1e-9); // behind the last row it stands
    EXPECT_NEAR(now->current_speed, 0.5, 1e-9);
    EXPECT_NEAR(drill.now().environment.depth, 26.2, 1e-9);
}

// An order is what holds at its moment, and the tide runs on from there.
TEST(Tide, RunsOnFromWhatIsOrdered) {
    ExerciseDef def = quiet_def(25, 5);
    def.tide = {{.time = 0, .height = 0}, {.time = 200, .height = 1, .current_speed = 1}};
    Drill drill(def);
    drill.run(100);
    EXPECT_NEAR(drill.now().environment.now.current_speed, 0.5, 1e-9);
    EnvironmentOrder order = tide_ordered(drill, 2, 0);
    order.weather.current_speed = 2, order.weather.current_towards = 0;
    drill.give(order);
    drill.run(200);
    EXPECT_NEAR(drill.now().environment.now.tide_height, 2.5, 1e-9);
    EXPECT_NEAR(drill.now().environment.now.current_speed, 2.5, 1e-9);
}

// What is seen from outside is counted from the surface: the ship stays at 0, the anchor on the bottom sinks.
TEST(Tide, LiftsTheShipOffTheBedAndThePictureIsCountedFromTheSurface) {
    Drill drill = let_go();
    const Snapshot before = drill.now();
    drill.give(tide_ordered(drill, 1.5, 200));
    drill.run(230);
    const Snapshot& now = drill.now();
    EXPECT_NEAR(now.environment.depth, 26.5, 1e-9);
    EXPECT_EQ(now.ship.position.z(), 0);
    EXPECT_EQ(now.tackle[0].hawse.z(), before.tackle[0].hawse.z());
    EXPECT_NEAR(now.tackle[0].anchor.position.z(), before.tackle[0].anchor.position.z() - 1.5, 0.01);
    EXPECT_NEAR(now.tackle[0].chain.nodes.back().z(), before.tackle[0].chain.nodes.back().z() - 1.5, 0.01);
    EXPECT_NEAR(now.tackle[0].chain.nodes.front().z(), now.tackle[0].hawse.z(), 1e-5);
    EXPECT_NEAR(now.tackle[0].anchor.height_above_bottom, before.tackle[0].anchor.height_above_bottom, 0.01);
}

// 22 m and a tide of 3 m are 25 m of water: an anchor falls through it, pays its cable out and is snubbed
// alike. Not to the bit, as heights are counted from elsewhere; a tenth of a second after it has come to the
// bottom the heap is another by what rounding makes of it.
TEST(Tide, ThatStandsIsWaterLikeAnyOther) {
    ExerciseDef shoal = quiet_def(22, 5);
    shoal.weather.tide_height = 3;
    Drill deep(quiet_def(25, 5)), tidal(shoal);
    for (Drill* drill : {&deep, &tidal})
        drill->brake(0);
    int compared = 0;
    while (deep.anchor().height_above_bottom > 0.5) {
        ASSERT_TRUE(deep.tick() && tidal.tick());
        EXPECT_NEAR(tidal.windlass().hawse_tension, deep.windlass().hawse_tension,
                    1e-6 * deep.windlass().breaking_load);
        EXPECT_NEAR(tidal.anchor().position.z(), deep.anchor().position.z(), 1e-6);
        ++compared;
    }
    EXPECT_GT(compared, 300); // a second of falling
    deep.run(0.1), tidal.run(0.1);
    EXPECT_NEAR(tidal.windlass().cable_out, deep.windlass().cable_out, 0.01);
}

/// What a catenary of chain says of a cable with that level pull (N), its lip h (m) over the water in that
/// depth (m): inextensible, lighter in water (chain's mass and buoyancy from its definition). Irvine (1981).
struct Hanging {
    double tension, length; ///< N at the lip, m off the bottom
};
Hanging hanging(const physics::ChainDef& chain, double pull, double depth, double lip) {
    const double water = weight_in_water(chain, physics::kSeaWaterDensity), air = weight_in_air(chain);
    const double surface = pull + water * depth, top = surface + air * lip;
    const auto upright = [=](double tension) { return std::sqrt(tension * tension - pull * pull); };
    return {top, upright(surface) / water + (upright(top) - upright(surface)) / air};
}

// Lying quietly on five shackles the water rises by 3 m: her pull is what wind and stream ask of her, and the
// cable hangs from the bed to the lip as a catenary in the new depth. 1 % of load: she is not wholly still.
// Of the length, what is near the touchdown counts as lying: to a height of w x^2 / 2H of a chain's width;
// and a link and a half, as it is counted by links.
TEST(Tide, LeavesACatenaryOfTheNewDepth) {
    Drill drill(steady_breeze_def());
    ASSERT_TRUE(lie_quietly(drill));
    const physics::ShipDef& ship = drill.exercise().def().ship;
    const auto& chain = drill.exercise().def().tackle[0].chain;
    const auto hangs = [&] {
        const double pull = drill.now().cable_force.head<2>().norm();
        const Hanging is = hanging(chain, pull, drill.now().environment.depth, ship.hawse_height);
        const double flat = std::sqrt(2 * chain.contact_diameter * pull / weight_in_water(chain, 1025));
        EXPECT_NEAR(drill.windlass().hawse_tension, is.tension, 0.01 * is.tension);
        EXPECT_NEAR(drill.chain().cable_out - drill.chain().on_bottom, is.length - flat, 1.9);
    };
    hangs();
    const int dragged = drill.count("anchor.dragging");
    const double before = drill.anchor().dragged;
    drill.give(tide_ordered(drill, 3, 600));
    drill.run(700);
    EXPECT_NEAR(drill.now().environment.depth, 28, 1e-9);
    hangs();
    EXPECT_EQ(drill.count("anchor.dragging"), dragged);
    EXPECT_LT(drill.anchor().dragged, before + 0.5);
}

// 10 mm/s, whatever is ordered: the cable of a ship that rises by a metre in a tick would part.
TEST(Tide, OrderedAtOnceComesAtAPaceThatThrowsNoShip) {
    Drill drill = let_go();
    const double before = drill.windlass().hawse_tension;
    drill.give(tide_ordered(drill, 2, 0));
    double largest = 0;
    const auto look = [&](double seconds) {
        for (int k = 0; k < seconds * 300; ++k) {
            drill.tick();
            largest = std::max(largest, drill.windlass().hawse_tension);
        }
    };
    look(100);
    EXPECT_NEAR(drill.now().environment.now.tide_height, 1, 1e-6);
    look(110);
    EXPECT_NEAR(drill.now().environment.now.tide_height, 2, 1e-9);
    // Plumb, two metres of chain more hang in the water: 1.2 kN each; and she is drawn over her anchor a
    // little.
    EXPECT_LT(largest, before + 10e3);
}

TEST(Tide, SetsHerOnTheGroundAndFloatsHerAgain) {
    ExerciseDef def = quiet_def(13, 5); // draught 12.5
    Drill drill(def);
    drill.give(tide_ordered(drill, -0.7, 0));
    ASSERT_TRUE(drill.run_until_event("ship.aground", 60));
    EXPECT_LT(drill.now().environment.depth, 12.5);
    drill.give(tide_ordered(drill, 0, 0));
    EXPECT_TRUE(drill.run_until_event("ship.afloat", 60));
    EXPECT_GT(drill.now().environment.depth, 12.5);
}

TEST(Tide, IsKeptInACheckpoint) {
    ExerciseDef def = quiet_def(25, 5);
    def.tide = {{.time = 0, .height = 0},
                {.time = 20, .height = 0.15, .current_speed = 0.4, .current_towards = 1},
                {.time = 60, .height = 0, .current_speed = 0.1, .current_towards = 4}};
    Drill drill(def);
    drill.run(12);
    drill.give(tide_ordered(drill, 0.4, 30));
    drill.run(5);
    Exercise& live = drill.exercise();
    Exercise read = read_checkpoint(write_checkpoint(live));
    for (int k = 0; k < 300 * 20; ++k) {
        live.step(1.0 / live.def().tick_rate_hz);
        read.step(1.0 / read.def().tick_rate_hz);
    }
    const auto found = differences(live, read);
    EXPECT_TRUE(found.empty()) << found[0].field << ' ' << found[0].first << ' ' << found[0].second;
}

// The prelude is over before the tide runs: at tick 0 it is as the table begins, and a restored state goes
// on.
TEST(Tide, RunsFromTheStartOfAnExerciseAtAnchorAndOfOneReadFromItsBytes) {
    ExerciseDef def = steady_breeze_def();
    def.weather.wind_speed = 8;
    def.tackle[0].at_anchor = 5;
    def.weather.tide_height = 1;
    def.tide = {{.time = 0, .height = 1}, {.time = 100, .height = 1.5}};
    Drill drill(with_prelude_played(def));
    EXPECT_EQ(drill.now().environment.now.tide_height, 1);
    drill.run(50);
    EXPECT_NEAR(drill.now().environment.now.tide_height, 1.25, 1e-9);
    EXPECT_NEAR(drill.now().environment.depth, 26.25, 1e-9);
}

// A foreign ship says her height over the water, and rises with it while she lies still.
TEST(Tide, LiftsAForeignShipToo) {
    Drill drill = let_go();
    const double bottom = drill.now().tackle[0].anchor.shackle.z();
    const Vec3 at = drill.now().ship.position;
    const Eigen::Quaterniond attitude = drill.now().ship.attitude;
    drill.give(tide_ordered(drill, 0.5, 50));
    for (int k = 0; k < 60 * 20; ++k) {
        drill.give(OwnShipSample{at, attitude, Vec3::Zero(), Vec3::Zero(), k * 0.05});
        drill.run(0.05);
    }
    EXPECT_EQ(drill.count("own_ship.jumped"), 0);
    EXPECT_NEAR(drill.now().ship.position.z(), 0, 1e-9);
    EXPECT_NEAR(drill.now().tackle[0].anchor.shackle.z(), bottom - 0.5, 0.02);
}

} // namespace
} // namespace windlass::exercise
