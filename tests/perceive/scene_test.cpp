// What a scene is made of is what the exercise computes with.

#include "server/config/config.hpp"
#include "server/exercise/checkpoint.hpp"
#include "server/perceive/scene.hpp"
#include "server/physics/sea/ground.hpp"
#include "server/physics/ship/hull_surface.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <numbers>
#include <set>

namespace windlass::perceive {
namespace {

using exercise::ExerciseDef;

const std::vector<ExerciseDef>& shipped() {
    static const std::vector<ExerciseDef> all = [] {
        std::vector<ExerciseDef> list{ExerciseDef{}};
        for (const auto& entry : std::filesystem::directory_iterator(WINDLASS_CONFIG_DIR "/exercises"))
            if (entry.path().extension() == ".json") list.push_back(config::load_exercise(entry.path()));
        return list;
    }();
    return all;
}

SceneDescription scene(const ExerciseDef& def, const SeatAids& aids = {}) {
    SceneDescription to;
    describe_scene(def, aids, to);
    return to;
}

physics::Vec3 corner(const SceneDescription& scene, std::size_t triangle, std::size_t k) {
    const Point3f& point = scene.hull_corners().at(scene.hull_triangles().at(3 * triangle + k));
    return {point.x(), point.y(), point.z()};
}

TEST(Scene, TheHullIsThatOfContact) {
    for (const ExerciseDef& def : shipped()) {
        const physics::ObstacleMesh mesh = physics::hull_mesh(def.ship, exercise::lip_clearance(def));
        const SceneDescription made = scene(def);
        ASSERT_EQ(made.hull_triangles().size(), 3 * static_cast<std::size_t>(mesh.triangles())) << def.name;
        for (int t = 0; t < mesh.triangles(); ++t)
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_EQ(corner(made, static_cast<std::size_t>(t), k),
                          mesh.triangle(t).corner[k].cast<float>().cast<double>());
    }
}

TEST(Scene, TheHullIsClosedAndItsTrianglesLookOutwards) {
    for (const ExerciseDef& def : shipped()) {
        const SceneDescription made = scene(def);
        std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
        double volume = 0; // m3
        const auto& corners = made.hull_triangles();
        for (std::size_t t = 0; t < corners.size() / 3; ++t) {
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_TRUE(sides.emplace(corners[3 * t + k], corners[3 * t + (k + 1) % 3]).second);
            volume += corner(made, t, 0).dot(corner(made, t, 1).cross(corner(made, t, 2))) / 6;
        }
        for (const auto& [from, to] : sides)
            EXPECT_TRUE(sides.contains({to, from})) << def.name << ": " << from << " to " << to;
        EXPECT_GT(volume, 0.5 * def.ship.length_overall * def.ship.beam * def.ship.draught) << def.name;
    }
}

TEST(Scene, KeepsTheBoundsOfTheWire) {
    for (const ExerciseDef& def : shipped()) {
        const SceneDescription made = scene(def);
        EXPECT_LE(made.hull_corners().size(), 4096U);
        EXPECT_LE(made.hull_triangles().size(), 24576U);
        SeabedDescription seabed;
        describe_seabed(def, seabed);
        EXPECT_LE(seabed.heights().size(), 16384U);
        Chart chart;
        draw_chart(def, chart);
        EXPECT_LE(chart.soundings().size(), 1024U);
        EXPECT_GE(chart.soundings().size(), 200U);
    }
}

TEST(Scene, TellsWhatTheTackleIs) {
    for (const ExerciseDef& def : shipped()) {
        const SceneDescription made = scene(def, {.load_cell = false, .underwater = true});
        const physics::ObstacleMesh mesh = physics::hull_mesh(def.ship, exercise::lip_clearance(def));
        EXPECT_EQ(made.definition_hash(), exercise::definition_hash(def));
        EXPECT_EQ(made.draught(), def.ship.draught);
        EXPECT_TRUE(made.underwater_camera());
        ASSERT_EQ(made.tackle().size(), def.tackle.size());
        for (std::size_t i = 0; i < def.tackle.size(); ++i) {
            const exercise::GroundTackleDef& tackle = def.tackle[i];
            const SceneTackle& told = made.tackle()[i];
            const physics::HawsePipe pipe = exercise::hawse_pipe(def, tackle, mesh);
            EXPECT_EQ(told.side(), static_cast<int>(tackle.side));
            EXPECT_EQ(told.lip().y(), pipe.lip.y());
            EXPECT_EQ(told.lip().y() > 0, tackle.side == exercise::Side::port);
            EXPECT_EQ(told.mouth().x(), pipe.mouth.x());
            EXPECT_EQ(told.bore().z(), pipe.bore.z());
            EXPECT_EQ(told.seat(), pipe.seat);
            EXPECT_EQ(told.chain_diameter(), tackle.chain.diameter);
            EXPECT_EQ(told.breaking_load(), physics::breaking_load(tackle.chain));
            EXPECT_EQ(told.brake_rating(), tackle.windlass.brake_rating);
            EXPECT_EQ(told.rated_current(),
                      told.drive() == "hydraulic" ? 0 : tackle.windlass.motor_current_rated)
                << "by the plate of an electric motor";
            EXPECT_EQ(told.pockets(), 5);
            EXPECT_TRUE(told.counter_fitted());
            EXPECT_FALSE(told.load_cell_fitted());
        }
    }
    const SceneTackle told = scene(ExerciseDef{}).tackle().at(0);
    EXPECT_EQ(told.drive(), "electric_vfd");
    EXPECT_EQ(told.stopper(), "bar");
    EXPECT_EQ(told.anchor(), "hall");
    EXPECT_NEAR(told.fluke_limit(), std::numbers::pi / 4, 1e-12);
    ExerciseDef stocked;
    stocked.tackle[0].anchor = physics::typical_anchor(physics::AnchorType::stock);
    EXPECT_EQ(scene(stocked).tackle().at(0).fluke_limit(), 0);
}

TEST(Seabed, TellsOfSlopeAndGrid) {
    ExerciseDef def;
    physics::lay_ground(def.environment, {.slope = 0.02,
                                          .slope_towards = 0, // down to the north
                                          .west = -100,
                                          .south = -50,
                                          .spacing = 20,
                                          .columns = 3,
                                          .rows = 2,
                                          .heights = {0, 1, 2, 3, 4, 5},
                                          .soils = std::vector(6, physics::Soil::clay)});
    SeabedDescription seabed;
    describe_seabed(def, seabed);
    EXPECT_EQ(seabed.depth(), 25);
    EXPECT_EQ(seabed.soil(), SOIL_SAND);
    EXPECT_EQ(seabed.slope(), 0.02);
    EXPECT_NEAR(seabed.slope_towards(), std::numbers::pi, 1e-12); // uphill to the south
    EXPECT_EQ(seabed.origin_x(), -100);
    EXPECT_EQ(seabed.origin_y(), -50);
    EXPECT_EQ(seabed.columns(), 3U);
    EXPECT_EQ(seabed.rows(), 2U);
    EXPECT_EQ(seabed.heights(), (std::vector<float>{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(seabed.soils(), std::vector<std::uint8_t>(6, SOIL_CLAY));
}

TEST(Seabed, ALevelOneHasNoGrid) {
    SeabedDescription seabed;
    seabed.heights({1, 2, 3}); // of the exercise before
    seabed.columns(3);
    describe_seabed(ExerciseDef{}, seabed);
    EXPECT_EQ(seabed.columns(), 0U);
    EXPECT_TRUE(seabed.heights().empty());
    EXPECT_EQ(seabed.slope(), 0);
}

TEST(Seabed, AGridOfSoilsOnlyIsEven) {
    ExerciseDef def;
    physics::lay_ground(def.environment,
                        {.columns = 2, .rows = 2, .soils = std::vector(4, physics::Soil::rock)});
    SeabedDescription seabed;
    describe_seabed(def, seabed);
    EXPECT_EQ(seabed.heights(), std::vector<float>(4, 0));
    EXPECT_EQ(seabed.soils(), std::vector<std::uint8_t>(4, SOIL_ROCK));
}

TEST(Chart, SoundsTheGroundBelowTheDatum) {
    ExerciseDef def;
    physics::lay_ground(def.environment, {.slope = 0.02, .slope_towards = 0});
    def.weather.tide_height = 1.5; // of which a chart knows nothing
    Chart chart;
    draw_chart(def, chart);
    EXPECT_EQ(chart.soundings().size(), 31U * 31U); // 750 m to every side of the start, 50 m apart
    for (const Sounding& sounding : chart.soundings()) {
        const double depth = -physics::bed_height(def.environment, sounding.x(), sounding.y());
        EXPECT_NEAR(sounding.depth(), depth, 0.0501);
        EXPECT_NEAR(std::remainder(sounding.depth(), 0.1), 0, 1e-5);
        EXPECT_EQ(sounding.soil(), SOIL_SAND);
    }
}

TEST(Chart, CoversAWideGridWithSoundingsFartherApart) {
    ExerciseDef def;
    physics::lay_ground(def.environment, {.west = -4000,
                                          .south = -4000,
                                          .spacing = 100,
                                          .columns = 81,
                                          .rows = 81,
                                          .soils = std::vector(81 * 81, physics::Soil::mud)});
    Chart chart;
    draw_chart(def, chart);
    EXPECT_LE(chart.soundings().size(), 1024U);
    EXPECT_GE(chart.soundings().size(), 700U);
    EXPECT_LE(chart.soundings().front().x(), -3700);
    EXPECT_GE(chart.soundings().back().x(), 3700);
    EXPECT_EQ(chart.soundings().front().soil(), SOIL_MUD);
}

TEST(Sea, IsFlatWithoutWaves) {
    exercise::Snapshot s;
    s.sea.ramp_begin = s.sea.ramp_end = 12;
    s.environment.now.tide_height = 2.5;
    SeaState sea;
    sea.components().resize(3);
    describe_sea(s, sea);
    EXPECT_EQ(sea.time(), 12);
    EXPECT_EQ(sea.tide_height(), 2.5);
    EXPECT_TRUE(sea.components().empty());
}

TEST(Sea, IsToAClientWhatItIsToTheServer) {
    // The surface at three points, of the sample alone by the IDL's words, after an hour and in the middle of
    // a ramp.
    physics::SeaSurface surface({.wave_height = 1, .wave_period = 5, .swell_height = 2, .swell_period = 13},
                                30);
    surface.order({.swell_height = 3, .swell_period = 11, .swell_from = 1}, 3590, 60);
    exercise::Snapshot s;
    s.sea.ramp_begin = surface.ramp_begin(), s.sea.ramp_end = surface.ramp_end();
    s.sea.waves.assign(surface.components().begin(), surface.components().end());
    SeaState sea;
    describe_sea(s, sea);
    EXPECT_LE(sea.components().size(), 64U);
    for (const double t : {3590.0, 3600.0, 3644.0, 3700.0})
        for (const auto& [x, y] : {std::pair(0.0, 0.0), {250.0, -80.0}, {-1000.0, 400.0}}) {
            double z = 0;
            for (const WaveComponent& c : sea.components()) {
                const double share =
                    std::clamp((t - sea.ramp_begin()) / (sea.ramp_end() - sea.ramp_begin()), 0.0, 1.0);
                const double a = c.amplitude_before() + share * (c.amplitude_after() - c.amplitude_before());
                z += a * std::cos(c.k_x() * x + c.k_y() * y - c.omega() * t + c.phase());
            }
            EXPECT_NEAR(z, surface.elevation(x, y, t), 1e-9); // a millimetre is asked for
        }
}

} // namespace
} // namespace windlass::perceive
