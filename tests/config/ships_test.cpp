// The ships of config/ships: particulars, and that each has the ground tackle that the rules ask of her.

#include "server/config/config.hpp"
#include "tests/config/config_files.hpp"
#include "tests/config/equipment_number.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace windlass::config {
namespace {

namespace fs = std::filesystem;
using test::kConfig;

/// A ship file with what the equipment number asks for and no model needs, estimated from drawings of common
/// ships: displacement at her summer draught (t), height from there to the top of the uppermost house broader
/// than a quarter of the beam (m), side area above it without containers and hatch coamings (m2).
struct Ship {
    const char* file;
    double summer_tonnes, height, area;
    const char *anchor, *chain, *windlass;
};

constexpr Ship kShips[]{
    {"general_cargo_118m", 13400, 14.0, 640, "stockless_3540", "stud_link_46mm_k3", "electric_46mm"},
    {"bulk_carrier_225m", 77000, 20.1, 1936, "stockless_9900", "stud_link_78mm_k3", "electric_78mm"},
    {"panamax_laden", 77000, 20.1, 1936, "stockless_9900", "stud_link_78mm_k3", "electric_78mm"},
    {"panamax_ballast", 77000, 20.1, 1936, "stockless_9900", "stud_link_78mm_k3", "electric_78mm"},
    {"capesize_laden", 203000, 21.0, 2400, "stockless_16900", "stud_link_100mm_k3", "electric_100mm"},
    {"capesize_ballast", 203000, 21.0, 2400, "stockless_16900", "stud_link_100mm_k3", "electric_100mm"},
    {"vlcc_laden", 320000, 23.3, 3500, "stockless_23000", "stud_link_117mm_k3", "electric_117mm"},
    {"vlcc_ballast", 320000, 23.3, 3500, "stockless_23000", "stud_link_117mm_k3", "electric_117mm"},
    {"car_carrier_200m", 33500, 29.3, 4845, "stockless_10500", "stud_link_78mm_k3", "electric_78mm"},
    {"container_ship_300m", 92000, 31.1, 3850, "stockless_14700", "stud_link_95mm_k3", "electric_95mm"}};

exercise::ExerciseDef exercise_with(const Ship& ship) {
    const std::string text = std::string(R"({"environment": {"depth": 40}, "ship": {"from": ")") + ship.file +
                             R"("}, "tackle": [{"windlass": {"from": ")" + ship.windlass +
                             R"("}, "chain": {"from": ")" + ship.chain + R"("}, "anchor": {"from": ")" +
                             ship.anchor + R"("}}]})";
    return parse_exercise(text, ship.file, kConfig);
}

/// IACS UR A1, without the funnel that later revisions count.
double equipment_number(const Ship& ship, double beam) {
    return std::cbrt(ship.summer_tonnes * ship.summer_tonnes) + 2 * ship.height * beam + ship.area / 10;
}

} // namespace

TEST(Ships, EveryFileIsTested) {
    for (const auto& entry : fs::directory_iterator(kConfig / "ships")) {
        const std::string name = entry.path().stem().string();
        EXPECT_TRUE(std::any_of(std::begin(kShips), std::end(kShips), [&](const Ship& ship) {
            return name == ship.file;
        })) << name;
    }
}

TEST(Ships, HaveTheGroundTackleOfTheirEquipmentNumber) {
    for (const Ship& ship : kShips) {
        const exercise::ExerciseDef def = exercise_with(ship);
        const exercise::GroundTackleDef& tackle = def.tackle.front();
        const double number = equipment_number(ship, def.ship.beam);
        const auto row = std::find_if(kEquipment.begin(), kEquipment.end(), [&](const EquipmentRow& each) {
            return number > each.above && number <= each.to;
        });
        ASSERT_NE(row, kEquipment.end()) << ship.file << ' ' << number;
        EXPECT_EQ(tackle.anchor.mass, row->anchor) << ship.file << ' ' << number;
        EXPECT_NEAR(1000 * tackle.chain.diameter, row->diameter_k3_mm, 1e-9) << ship.file << ' ' << number;
        EXPECT_EQ(tackle.chain.grade, physics::Grade::k3);
        // In whole lengths: an odd number of them gives one side a length more.
        EXPECT_GE(tackle.chain.length, 0.5 * row->chain) << ship.file;
        EXPECT_LE(tackle.chain.length, 0.5 * row->chain + physics::kShackleLength) << ship.file;
        // The windlass is for that chain: pockets, and UR A3's pull and holding.
        const double pull = 47.5 * 1e6 * tackle.chain.diameter * tackle.chain.diameter; // N
        EXPECT_NEAR(tackle.windlass.gypsy_radius / tackle.chain.diameter, 6.37, 0.1) << ship.file;
        EXPECT_GE(tackle.windlass.rated_pull, 1.49 * pull) << ship.file;
        EXPECT_GE(tackle.windlass.brake_rating, 0.45 * breaking_load(tackle.chain)) << ship.file;
        EXPECT_GE(tackle.windlass.stopper_rating, 0.8 * breaking_load(tackle.chain) - 1e3) << ship.file;
    }
}

// Block coefficients of such ships: bulk and tankers 0.8 to 0.87 laden, 0.77 in ballast at the least; car
// carriers and container ships 0.55 to 0.65.
TEST(Ships, AreShips) {
    for (const Ship& ship : kShips) {
        const physics::ShipDef def = exercise_with(ship).ship;
        const double block =
            def.displacement / (physics::kSeaWaterDensity * def.length_pp * def.beam * def.draught);
        EXPECT_GT(block, 0.55) << ship.file;
        EXPECT_LT(block, 0.88) << ship.file;
        EXPECT_LT(def.length_pp, def.length_overall) << ship.file;
        EXPECT_GT(def.length_pp, 0.9 * def.length_overall) << ship.file;
        const double height = def.lateral_windage / def.length_overall; // m, in the mean
        EXPECT_GT(height, 5) << ship.file;
        EXPECT_LT(height, 30) << ship.file;
        // An engine that gives 1 to 4 % of her weight in thrust at rest would not be a merchant ship's.
        EXPECT_LT(def.thrust_ahead / (def.displacement * physics::kGravity), 0.01) << ship.file;
        EXPECT_LT(def.thrust_astern, def.thrust_ahead) << ship.file;
        EXPECT_LT(def.hawse_forward, 0.5 * def.length_overall) << ship.file;
    }
}

} // namespace windlass::config
