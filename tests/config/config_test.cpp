// Exercise files: defaults that cannot drift from their schemas, shipped files that load, and what files say.

#include "server/config/config_json.hpp"
#include "server/physics/sea/ground.hpp"
#include "tests/config/config_files.hpp"
#include "words/words.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace windlass::config {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;
using test::ConfigFiles;
using test::kConfig;

// ------------------------------------------------------------------ schema and built-in defaults

/// Compares every field that C++ knows with the schema's properties, both ways.
void expect_defaults_match(const Json& values, const Json& schema, const std::string& at) {
    const Json& properties = schema.at("properties");
    for (const auto& [name, value] : values.items()) {
        SCOPED_TRACE(at + "/" + name);
        ASSERT_TRUE(properties.contains(name)) << "the schema does not know this field";
        const Json& property = properties.at(name);
        if (value.is_object())
            expect_defaults_match(value, property, at + "/" + name);
        else if (value.is_array() && (value.empty() || value.at(0).is_string()))
            EXPECT_EQ(property.at("default"), value);
        else if (value.is_array())
            expect_defaults_match(value.at(0), property.at("items"), at + "/" + name + "/0");
        else if (value.is_number())
            EXPECT_NEAR(property.at("default").get<double>(), value.get<double>(),
                        1e-5 * std::abs(value.get<double>())); // degrees are rounded in the schema
        else
            EXPECT_EQ(property.at("default"), value);
    }
    for (const auto& [name, property] : properties.items())
        EXPECT_TRUE(values.contains(name) || name == "$schema" || name == "from" || name == "note" ||
                    name == "lesson" || name == "landmarks") // kept as texts
            << at << "/" << name << ": no member in C++ has this field";
}

TEST(ConfigSchema, GivesTheBuiltInDefaults) {
    exercise::ExerciseDef def;
    EXPECT_TRUE(def.weather.current_profile.empty());
    def.weather.current_profile.emplace_back(); // for the defaults of a layer
    EXPECT_TRUE(def.tackle[0].condition.empty());
    def.tackle[0].condition.emplace_back();
    expect_defaults_match(to_json(def), config_schema(ConfigKind::exercise), "");
}

// These structs hold nothing but doubles (and an enum padded to one), so that a member that was forgotten in
// the list of fields shows in their size.
TEST(ConfigFields, NameEveryMemberOfTheDefinitions) {
    exercise::ExerciseDef def;
    const Json document = to_json(def);
    const Json& tackle = document.at("tackle").at(0);
    EXPECT_EQ(document.at("ship").size(), sizeof(physics::ShipDef) / sizeof(double));
    constexpr std::size_t kList = sizeof(physics::EnvironmentDef::current_profile) / sizeof(double),
                          kGround = sizeof(physics::EnvironmentDef::ground) / sizeof(double);
    constexpr std::size_t kWeatherAlone =
        13; // veering, two of gusts, seven of waves, the tide's table, visibility, time of day
    // What follows of the bed from the soil, of chain from diameter and grade, of anchors from type and mass.
    constexpr std::size_t kBed = 3, kChain = 10, kAnchor = 11;
    EXPECT_EQ(document.at("environment").size() + kBed + kList + kGround - 2 - kWeatherAlone,
              sizeof(physics::EnvironmentDef) / sizeof(double));
    EXPECT_EQ(document.at("ship_start").size(), sizeof(exercise::ShipStartDef) / sizeof(double));
    EXPECT_EQ(tackle.at("windlass").size(), sizeof(physics::WindlassDef) / sizeof(double));
    EXPECT_EQ(tackle.at("chain").size() + kChain, sizeof(physics::ChainDef) / sizeof(double));
    EXPECT_EQ(tackle.at("anchor").size() + kAnchor, sizeof(physics::AnchorDef) / sizeof(double));
    def.tackle[0].condition.emplace_back();
    EXPECT_EQ(to_json(def).at("tackle").at(0).at("condition").at(0).size(),
              sizeof(physics::LinkCondition) / sizeof(double));
}

TEST(ConfigSchema, SaysUnitOrMeaningOfEveryField) {
    for (const ConfigKind kind :
         {ConfigKind::exercise, ConfigKind::ship, ConfigKind::windlass, ConfigKind::chain, ConfigKind::anchor,
          ConfigKind::ground, ConfigKind::landmarks})
        for (const auto& [name, property] : config_schema(kind).at("properties").items())
            EXPECT_FALSE(property.value("description", "").empty()) << name;
}

// ------------------------------------------------------------------ files that load

TEST(ShippedExercises, AllLoad) {
    int loaded = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(kConfig / "exercises")) {
        EXPECT_NO_THROW(load_exercise(entry.path())) << entry.path();
        ++loaded;
    }
    EXPECT_GT(loaded, 0);
}

TEST(ShippedParts, AllFitTheirSchema) {
    for (const ConfigKind kind : {ConfigKind::ship, ConfigKind::windlass, ConfigKind::chain,
                                  ConfigKind::anchor, ConfigKind::ground, ConfigKind::landmarks}) {
        int loaded = 0;
        for (const fs::directory_entry& entry : fs::directory_iterator(kConfig / config_folder(kind))) {
            EXPECT_NO_THROW(load_document(kind, entry.path(), kConfig)) << entry.path();
            ++loaded;
        }
        EXPECT_GT(loaded, 0) << config_folder(kind);
    }
}

TEST(ShippedParts, FitTogetherInEachSize) {
    const struct {
        const char *windlass, *chain, *anchor;
    } sizes[] = {{"electric_52mm", "stud_link_52mm_k3", "stockless_4650"},
                 {"electric_78mm", "stud_link_78mm_k3", "stockless_9900"},
                 {"electric_117mm", "stud_link_117mm_k3", "stockless_23000"}};
    const fs::path file = fs::temp_directory_path() / ("windlass-size-" + std::to_string(getpid()) + ".json");
    for (const auto& size : sizes) {
        const Json tackle{{"windlass", {{"from", size.windlass}}},
                          {"chain", {{"from", size.chain}}},
                          {"anchor", {{"from", size.anchor}}}};
        std::ofstream(file) << Json{{"tackle", {tackle}}};
        const exercise::GroundTackleDef def = load_exercise(file, kConfig).tackle.at(0);
        const double breaking_load = physics::breaking_load(def.chain);
        EXPECT_NEAR(def.windlass.stopper_rating, 0.8 * breaking_load, 0.001 * breaking_load) << size.chain;
        EXPECT_GE(def.windlass.brake_rating, 0.45 * breaking_load) << "UR A3 3.1.1, " << size.windlass;
    }
    fs::remove(file);
}

TEST(ShippedExercises, LetGoStartsAsItsTitleSays) {
    const exercise::ExerciseDef def = load_exercise(kConfig / "exercises/let_go_port_25m.json");
    EXPECT_EQ(def.name, "let-go-port-25m");
    EXPECT_EQ(def.environment.depth, 25);
    EXPECT_EQ(def.ship_start.surge, -0.5);
    ASSERT_EQ(def.tackle.size(), 1U);
    EXPECT_EQ(def.tackle[0].side, exercise::Side::port);
    EXPECT_FALSE(def.tackle[0].clutch_in);
    EXPECT_EQ(def.tackle[0].brake, 1);
}

TEST_F(ConfigFiles, EmptyExerciseIsTheBuiltInOne) {
    EXPECT_EQ(to_json(load_exercise(write("exercises/x.json", "{}"))), to_json(exercise::ExerciseDef{}));
}

TEST_F(ConfigFiles, WrittenExerciseReadsBackTheSame) {
    exercise::ExerciseDef def;
    def.name = "other";
    def.environment.soil = physics::Soil::mud;
    def.environment.depth = 40;
    def.weather.current_profile = {{0, 1, 0}, {15, 0.4, 0.5 * std::numbers::pi}};
    def.tackle[0].chain = physics::stud_link_chain(0.062, physics::Grade::k2, 302.5);
    def.tackle[0].windlass.gypsy_radius = 0.395;
    def.tackle.push_back(def.tackle[0]);
    def.tackle[1].side = exercise::Side::starboard;
    def.tackle[1].stopper_closed = true;
    def.tackle[1].condition = {{.begins = 0, .ends = 27.5, .wear = 0.08},
                               {.begins = 55, .ends = 55, .defect = 0.4}};
    const exercise::ExerciseDef back = load_exercise(write("exercises/x.json", to_json(def).dump()));
    EXPECT_EQ(to_json(back), to_json(def));
    EXPECT_EQ(back.tackle[1].side, exercise::Side::starboard);
    EXPECT_EQ(back.tackle[1].chain.grade, physics::Grade::k2);
}

TEST_F(ConfigFiles, CurrentProfileGoesDown) {
    const auto file = write("exercises/x.json", R"({"environment": {"current_profile": [
        {"depth": 10}, {"depth": 5, "share": 0.5}]}})");
    try {
        load_exercise(file);
        FAIL() << "taken";
    } catch (const std::exception& error) {
        EXPECT_NE(std::string(error.what()).find("/environment/current_profile/1/depth"), std::string::npos)
            << error.what();
    }
}

TEST_F(ConfigFiles, ConditionLiesOnTheCableAndLeavesHalfOfTheDiameter) {
    struct Case {
        const char* condition;
        const char* says;
    };
    for (const Case& c :
         {Case{R"({"begins": 30, "ends": 20})", "/tackle/0/condition/1/ends: 20 is not allowed"},
          Case{R"({"begins": 300, "ends": 331})", "at most the chain's length, 330 m"},
          Case{R"({"begins": 0, "ends": 9, "wear": 0.6})",
               "wear: 0.6 is not allowed: a number from 0 to 0.5"},
          Case{R"({"begins": 0, "ends": 9, "corrosion": 0.1})", "leave it out: count it in wear"},
          Case{R"({"begins": 0})", "ends"}}) {
        const std::string list =
            R"([{"begins": 0, "ends": 330, "wear": 0.1}, )" + std::string(c.condition) + "]";
        const auto file = write("exercises/x.json", R"({"tackle": [{"condition": )" + list + "}]}");
        try {
            load_exercise(file);
            FAIL() << c.condition << " is taken";
        } catch (const std::exception& error) {
            EXPECT_NE(std::string(error.what()).find(c.says), std::string::npos) << error.what();
        }
    }
    const auto file = write("exercises/x.json",
                            R"({"tackle": [{"condition": [{"begins": 0, "ends": 330, "wear": 0.5}]}]})");
    EXPECT_EQ(load_exercise(file).tackle.at(0).condition.at(0).wear, 0.5);
}

TEST_F(ConfigFiles, SeatsAreFittedAndAidedAsListed) {
    const exercise::Seats usual = load_exercise(write("exercises/x.json", "{}")).seats;
    EXPECT_TRUE(usual.counter && usual.load_cell);
    EXPECT_FALSE(usual.underwater || usual.lining_temperature || usual.latched_lever);
    const exercise::Seats bare = load_exercise(write("exercises/x.json", R"({"seats": {"forecastle": {
        "fitted": ["counter"], "aids": ["underwater", "latched_lever"]}}})"))
                                     .seats;
    EXPECT_TRUE(bare.counter && bare.underwater && bare.latched_lever);
    EXPECT_FALSE(bare.load_cell || bare.lead_readout || bare.alerts_without_sensor);
    const std::string why = refusal(R"({"seats": {"forecastle": {"aids": ["crystal_ball"]}}})");
    EXPECT_NE(why.find("/seats/forecastle/aids/0"), std::string::npos) << why;
}

TEST_F(ConfigFiles, TraineesReadTheTitleWhereTheyHaveNoneOfTheirOwn) {
    exercise::ExerciseDef def =
        load_exercise(write("exercises/x.json", R"({"title": "Brake fades at 4 shackles"})"));
    EXPECT_EQ(exercise::title_for_trainees(def), "Brake fades at 4 shackles");
    def = load_exercise(
        write("exercises/x.json", R"({"title": "Brake fades", "title_trainee": "Let go in 25 m"})"));
    EXPECT_EQ(exercise::title_for_trainees(def), "Let go in 25 m");
    EXPECT_EQ(def.title, "Brake fades");
}

TEST_F(ConfigFiles, WeatherAtTheStartIsTheEnvironments) {
    const exercise::ExerciseDef def = load_exercise(write("exercises/x.json", R"({"environment": {
        "wind_speed": 11, "wind_from_deg": 90, "veering_deg": 0.1, "current_speed": 0.7,
        "visibility": 600, "time_of_day_h": 2.5}})"));
    EXPECT_EQ(def.weather.wind_speed, 11);
    EXPECT_DOUBLE_EQ(def.weather.wind_from, std::numbers::pi / 2);
    EXPECT_DOUBLE_EQ(def.weather.veering, std::numbers::pi / 1800);
    EXPECT_EQ(def.weather.visibility, 600);
    EXPECT_EQ(def.weather.time_of_day, 9000);
    EXPECT_DOUBLE_EQ(def.weather.current_towards, std::numbers::pi);
    EXPECT_EQ(def.environment.wind_speed, 11); // what the model is given
    EXPECT_EQ(def.environment.current_speed, 0.7);
}

TEST(Definition, OfATideBeyondItsRangeIsRefused) {
    exercise::ExerciseDef def;
    EXPECT_NO_THROW(check_definition(def));
    def.weather.tide_height = 3;
    EXPECT_NO_THROW(check_definition(def));
    def.weather.tide_height = 21;
    EXPECT_THROW(check_definition(def), ConfigError);
}

TEST_F(ConfigFiles, TideSaysHeightAndStreamOfTheStart) {
    const std::string file = write("exercises/x.json", R"({"environment": {"current_speed": 3, "tide": [
        {"time_h": -1, "height": 2, "current_speed": 1, "current_towards_deg": 90},
        {"time_h": 1, "height": 4, "current_speed": 0},
        {"time_h": 2.5, "height": 3, "current_speed": 0.5, "current_towards_deg": 270}]}})");
    const exercise::ExerciseDef def = load_exercise(file);
    ASSERT_EQ(def.tide.size(), 3U);
    EXPECT_EQ(def.tide[0].time, -3600);
    EXPECT_EQ(def.tide[2].time, 9000);
    EXPECT_DOUBLE_EQ(def.tide[2].current_towards, 1.5 * std::numbers::pi);
    EXPECT_DOUBLE_EQ(def.weather.tide_height, 3); // half-way between two rows
    EXPECT_DOUBLE_EQ(def.weather.current_speed, 0.5);
    EXPECT_DOUBLE_EQ(def.weather.current_towards, std::numbers::pi / 2);
    EXPECT_DOUBLE_EQ(def.environment.level, 3);
    EXPECT_EQ(exercise_from_json(to_json(def)).tide, def.tide);
}

TEST_F(ConfigFiles, TideWhoseRowsDoNotGoOnIsRefused) {
    const std::string rows = refusal(R"({"environment": {"tide": [
        {"time_h": 1, "height": 2, "current_speed": 0}, {"time_h": 1, "height": 3, "current_speed": 0}]}})");
    EXPECT_NE(rows.find("/environment/tide/1/time_h: 1 is not allowed: after the row before it, 1 h"),
              std::string::npos)
        << rows;
    const std::string low = refusal(R"({"environment": {"depth": 13, "tide_height": -1}})");
    EXPECT_NE(low.find("/environment/depth: 12 is not allowed"), std::string::npos) << low;
}

TEST_F(ConfigFiles, WavesAndGustsAreTheEnvironments) {
    const exercise::ExerciseDef def = load_exercise(write("exercises/x.json", R"({"environment": {
        "gust_factor": 1.3, "gust_period": 80, "wave_height": 1.2, "wave_period": 5, "wave_from_deg": 90,
        "swell_height": 2, "swell_period": 11, "swell_from_deg": -90, "wave_seed": 7}})"));
    EXPECT_EQ(def.weather.gust_factor, 1.3);
    EXPECT_EQ(def.weather.gust_period, 80);
    EXPECT_EQ(def.weather.wave_height, 1.2);
    EXPECT_DOUBLE_EQ(def.weather.wave_from, std::numbers::pi / 2);
    EXPECT_EQ(def.weather.swell_period, 11);
    EXPECT_DOUBLE_EQ(def.weather.swell_from, -std::numbers::pi / 2);
    EXPECT_EQ(def.weather.wave_seed, 7U);
}

TEST_F(ConfigFiles, WavesThatWouldBreakAreRefused) {
    EXPECT_THROW(
        load_exercise(write("exercises/x.json", R"({"environment": {"wave_height": 3, "wave_period": 5}})")),
        ConfigError); // steeper than 1 in 14
    EXPECT_THROW(
        load_exercise(write("exercises/x.json",
                            R"({"environment": {"depth": 14, "swell_height": 8, "swell_period": 16}})")),
        ConfigError); // higher than half the depth
}

TEST_F(ConfigFiles, FileChangesThePartItTakesFrom) {
    const exercise::ExerciseDef def =
        load_exercise(write("exercises/x.json", R"({"ship": {"from": "bulk_carrier_225m", "draught": 13.5},
                                      "tackle": [{"anchor": {"from": "anchors/stockless_9900.json", "mass": 9000}}]})"));
    EXPECT_EQ(def.ship.draught, 13.5);
    EXPECT_EQ(def.ship.length_overall, 225);
    EXPECT_EQ(def.tackle.at(0).anchor.mass, 9000);
}

TEST_F(ConfigFiles, ExerciseTakesFromAnother) {
    write("ships/barge.json", R"({"length_overall": 60, "length_pp": 57, "beam": 12, "draught": 3,
                                  "displacement": 1.6e6, "hawse_forward": 29, "hawse_outboard": 2})");
    const exercise::ExerciseDef def = load_exercise(write(
        "exercises/x.json",
        R"({"from": "let_go_port_25m", "title": "In mud", "environment": {"soil": "mud"}, "ship": {"from": "barge"}})"));
    EXPECT_EQ(def.title, "In mud");
    EXPECT_EQ(def.name, "let-go-port-25m");
    EXPECT_EQ(def.environment.soil, physics::Soil::mud);
    EXPECT_EQ(def.environment.current_speed, 0.3);
    EXPECT_EQ(def.ship.length_overall, 60);
    EXPECT_EQ(def.ship.bow_thruster, physics::ShipDef{}.bow_thruster)
        << "not the bulk carrier's, the default";
    EXPECT_EQ(def.ship_start.surge, -0.5);
}

TEST_F(ConfigFiles, DiameterAndGradeSetTheWholeChain) {
    const exercise::ExerciseDef def = load_exercise(write("exercises/x.json", R"({"tackle": [{
        "windlass": {"from": "electric_52mm"},
        "chain": {"diameter": 0.052, "grade": "k2"}}]})"));
    const physics::ChainDef& chain = def.tackle.at(0).chain;
    const physics::ChainDef expected = physics::stud_link_chain(0.052, physics::Grade::k2, 330);
    EXPECT_EQ(chain.stiffness, expected.stiffness);
    EXPECT_EQ(chain.displacement, expected.displacement);
    EXPECT_EQ(physics::breaking_load(chain), physics::breaking_load(expected));
    EXPECT_EQ(chain.mass_per_metre, expected.mass_per_metre);
}

TEST_F(ConfigFiles, SoilSetsTheBedUnderTheChain) {
    const exercise::ExerciseDef def =
        load_exercise(write("exercises/x.json", R"({"environment": {"soil": "mud"}})"));
    EXPECT_EQ(def.environment.bed_stiffness, physics::chain_bed(physics::Soil::mud).stiffness);
    EXPECT_EQ(def.environment.bed_suction, physics::chain_bed(physics::Soil::mud).suction);
    EXPECT_EQ(def.environment.bed_friction, physics::chain_bed(physics::Soil::mud).friction);
}

TEST_F(ConfigFiles, GroundIsReadAsAChartShowsIt) {
    const exercise::ExerciseDef def = load_exercise(write("exercises/x.json", R"({"environment": {"ground": {
        "slope_deg": 2, "slope_towards_deg": 90, "west": -20, "south": 100, "spacing": 20,
        "heights": [[1, 2, 3], [4, 5, 6]], "soils": ["SSR", "MSO"]}}})"));
    ASSERT_TRUE(def.environment.ground);
    const physics::GroundDef& ground = def.environment.ground->def();
    EXPECT_EQ(ground.heights, (std::vector<double>{4, 5, 6, 1, 2, 3})) << "the last row is the southern one";
    EXPECT_EQ(def.environment.ground->soil(-20, 100), physics::Soil::mud);
    EXPECT_EQ(def.environment.ground->soil(20, 120), physics::Soil::rock);
    EXPECT_EQ(def.environment.ground->soil(20, 100), physics::Soil::coral);
    EXPECT_DOUBLE_EQ(ground.slope_towards, std::numbers::pi / 2);
    EXPECT_EQ(to_json(load_exercise(write("exercises/y.json", to_json(def).dump()))), to_json(def));
}

TEST_F(ConfigFiles, GroundTakesFromAFileAndNotFromTheBaseAsWell) {
    write("grounds/hole.json", R"({"heights": [[0, -4]]})");
    write("exercises/base.json", R"({"environment": {"ground": {"slope_deg": 3, "soils": ["MM"]}}})");
    const exercise::ExerciseDef def = load_exercise(
        write("exercises/x.json",
              R"({"from": "base", "environment": {"ground": {"from": "hole", "spacing": 8}}})"));
    ASSERT_TRUE(def.environment.ground);
    EXPECT_EQ(def.environment.ground->def().slope, 0);
    EXPECT_EQ(def.environment.ground->def().spacing, 8);
    EXPECT_TRUE(def.environment.ground->def().soils.empty());
    EXPECT_EQ(def.environment.ground->def().heights.size(), 2U);
}

TEST_F(ConfigFiles, LevelGroundIsNone) {
    EXPECT_FALSE(
        load_exercise(write("exercises/x.json", R"({"environment": {"ground": {}}})")).environment.ground);
}

TEST_F(ConfigFiles, DegreesBecomeRadians) {
    const exercise::ExerciseDef def = load_exercise(write(
        "exercises/x.json", R"({"environment": {"wind_from_deg": 90}, "ship_start": {"heading_deg": -45}})"));
    EXPECT_DOUBLE_EQ(def.environment.wind_from, std::numbers::pi / 2);
    EXPECT_DOUBLE_EQ(def.ship_start.heading, -std::numbers::pi / 4);
}

TEST_F(ConfigFiles, FaultsComeByEveryTrigger) {
    const std::string text = R"({"chance_seed": 7, "faults": [
        {"code": "brake-wet"},
        {"code": "blackout", "when": {"time": 300}, "lasts": 120, "ramp": 5, "severity": 0.5},
        {"code": "load-cell-dead", "when": {"cable_out": {"above": 80}}},
        {"code": "relief-valve-low", "when": {"cable_out": {"below": 60}}},
        {"code": "drive-trip", "when": {"gypsy_load": {"above": 260000}}},
        {"code": "pump", "when": {"gypsy_load": {"below": 100000}}},
        {"code": "soil-poor", "when": {"event": "anchor.aweigh"}},
        {"code": "joining-shackle-open", "target": 3, "when": {"order": "let_go"}},
        {"code": "clutch-jumps-out", "when": {"chance": [600, 900]}}]})";
    std::string fitting = text;
    fitting.replace(fitting.find("\"pump\""), 6, "\"hydraulic-pump-lost\"");
    const exercise::ExerciseDef def = load_exercise(write("exercises/x.json", fitting));
    ASSERT_EQ(def.faults.size(), 9U);
    EXPECT_EQ(def.faults[0].trigger, exercise::FaultTrigger::now);
    EXPECT_EQ(def.faults[1].lasts, 120);
    EXPECT_EQ(def.faults[2].trigger, exercise::FaultTrigger::at_cable_out);
    EXPECT_EQ(def.faults[3].trigger, exercise::FaultTrigger::at_cable_out_at_most);
    EXPECT_EQ(def.faults[4].trigger_value, 260000);
    EXPECT_EQ(def.faults[5].trigger, exercise::FaultTrigger::at_load_at_most);
    EXPECT_EQ(def.faults[6].trigger_event, "anchor.aweigh");
    EXPECT_EQ(def.faults[7].trigger_order, exercise::BridgeOrderCode::let_go);
    EXPECT_EQ(def.faults[8].trigger_until, 900);
    EXPECT_EQ(def.chance_seed, 7);
    EXPECT_EQ(to_json(load_exercise(write("exercises/y.json", to_json(def).dump()))), to_json(def));
    EXPECT_NE(refusal(text).find(R"(/faults/5/code: "pump" is not allowed)"), std::string::npos)
        << refusal(text);
}

TEST_F(ConfigFiles, AFaultWaitsForNoEventThatNeverComes) {
    for (const char* event : {"levers.taken", "anchor.letgo", ""}) {
        const std::string text = refusal(
            std::string(R"({"faults": [{"code": "brake-wet", "when": {"event": ")") + event + R"("}}]})");
        EXPECT_NE(text.find(std::string("/faults/0/when/event: \"") + event + "\" is not allowed"),
                  std::string::npos)
            << text;
        EXPECT_NE(text.find("anchor.let_go"), std::string::npos) << text;
    }
}

TEST_F(ConfigFiles, AFieldThatHasAnotherNameNowIsToldByIt) {
    const std::string text =
        refusal(R"({"faults": [{"code": "brake-wet", "when": {"load": {"above": 1}}}]})");
    EXPECT_NE(text.find("/faults/0/when/load: no such field here; it is called \"gypsy_load\" now"),
              std::string::npos)
        << text;
}

TEST(ConfigSchema, ReferencesToWordsAreTheirNames) {
    const Json names = config_schema(ConfigKind::exercise)
                           .at("/properties/faults/items/properties/when/properties/event/enum"_json_pointer);
    EXPECT_EQ(names, Json(words::kEventNames));
}

} // namespace
} // namespace windlass::config
