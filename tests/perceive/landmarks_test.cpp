// What stands round the anchorage: from the file to the wire, and what a file may not say.

#include "common/json_file.hpp"
#include "server/config/config.hpp"
#include "server/exercise/checkpoint.hpp"
#include "server/perceive/landmarks.hpp"

#include <gmock/gmock.h>
#include <spdlog/fmt/fmt.h>

#include <numbers>

namespace windlass::perceive {
namespace {

using testing::HasSubstr;

exercise::ExerciseDef with(const std::string& landmarks) {
    return config::parse_exercise(R"({"landmarks": )" + landmarks + "}", "x.json", WINDLASS_CONFIG_DIR);
}

Landmarks described(const exercise::ExerciseDef& def) {
    Landmarks to;
    describe_landmarks(def, to);
    return to;
}

std::string refusal(const std::string& landmarks) {
    try {
        with(landmarks);
    } catch (const ConfigError& error) {
        return error.what();
    }
    return "";
}

TEST(LandmarksOfAnExercise, StandWhereItsFileSays) {
    const exercise::ExerciseDef def = with(R"({
        "position": {"latitude_deg": -33.5, "longitude_deg": 151.25}, "iala_region": "B",
        "coasts": [{"colour": "#4c5f4e", "shore": [[1, 2], [3, 4]], "ridge": [[5, 6, 7], [8, 9, 10]]}],
        "lamps": [[1, 2, 30]],
        "marks": [
            {"name": "Front", "kind": "beacon", "x": 10, "y": 500, "height": 12, "light": "white",
             "sectors": [{"light": "red", "from_deg": 270, "to_deg": 90}]},
            {"name": "Bank", "kind": "buoy_west", "x": -20, "y": 40, "height": 6, "light": "white", "period": 15,
             "flashes": [[0, 0.5], [2, 0.5]]},
            {"name": "Rear", "kind": "tower", "x": 10, "y": 900, "height": 40}],
        "transits": [{"name": "In", "front": "Front", "rear": "Rear"}],
        "ships": [{"x": 7, "y": 8, "heading_deg": 90, "length": 120, "beam": 20}]})");
    const Landmarks told = described(def);
    EXPECT_EQ(told.definition_hash(), exercise::definition_hash(def));
    EXPECT_TRUE(told.has_position());
    EXPECT_EQ(told.latitude_deg(), -33.5);
    EXPECT_EQ(told.longitude_deg(), 151.25);
    EXPECT_TRUE(told.region_b());
    ASSERT_EQ(told.coasts().size(), 1U);
    EXPECT_EQ(told.coasts()[0].colour(), 0x4c5f4eU);
    EXPECT_EQ(told.coasts()[0].shore().at(1).y(), 4);
    EXPECT_EQ(told.coasts()[0].ridge().at(1).z(), 10);
    EXPECT_EQ(told.lamps().at(0).z(), 30);
    ASSERT_EQ(told.marks().size(), 3U);
    EXPECT_STREQ(told.marks()[0].name().c_str(), "Front");
    EXPECT_EQ(told.marks()[0].kind(), LandmarkKind::LANDMARK_BEACON);
    EXPECT_TRUE(told.marks()[0].flashes().empty()) << "a fixed light";
    EXPECT_EQ(told.marks()[0].sectors().at(0).light(), LightColour::LIGHT_RED);
    EXPECT_FLOAT_EQ(told.marks()[0].sectors()[0].from(), static_cast<float>(1.5 * std::numbers::pi));
    EXPECT_FLOAT_EQ(told.marks()[0].sectors()[0].to(), static_cast<float>(0.5 * std::numbers::pi));
    EXPECT_EQ(told.marks()[1].kind(), LandmarkKind::LANDMARK_BUOY_WEST);
    EXPECT_EQ(told.marks()[1].light(), LightColour::LIGHT_WHITE);
    EXPECT_EQ(told.marks()[1].period(), 15);
    EXPECT_EQ(told.marks()[1].flashes().at(1).begin(), 2);
    EXPECT_EQ(told.marks()[2].light(), LightColour::LIGHT_NONE);
    EXPECT_EQ(told.transits().at(0).front(), 0U);
    EXPECT_EQ(told.transits().at(0).rear(), 2U);
    EXPECT_FLOAT_EQ(told.ships().at(0).heading(), static_cast<float>(std::numbers::pi / 2));
}

TEST(LandmarksOfAnExercise, AreNoneInAnOpenSea) {
    for (const char* none : {"{}", R"({"from": "open_sea"})"}) {
        const Landmarks told = described(with(none));
        EXPECT_FALSE(told.has_position());
        EXPECT_TRUE(told.coasts().empty() && told.marks().empty() && told.ships().empty());
    }
    EXPECT_TRUE(described(exercise::ExerciseDef{}).marks().empty());
}

TEST(LandmarksOfAnExercise, ComeBackWithACheckpointAndAreOfItsDefinition) {
    const exercise::ExerciseDef def = with(R"({"from": "north_point"})");
    EXPECT_FALSE(described(def).marks().empty());
    EXPECT_NE(exercise::definition_hash(def), exercise::definition_hash(with("{}")));
    const auto kept = exercise::read_checkpoint(exercise::write_checkpoint(exercise::Exercise(def)),
                                                config::check_definition);
    EXPECT_EQ(described(kept.def()), described(def));
}

TEST(LandmarksOfAnExercise, OfBytesThatSayAnythingMakeNoExercise) {
    for (const std::string& text :
         {std::string("{"), std::string("[1]"), std::string(R"({"marks": 1})"),
          std::string(R"({"marks": [{}]})"),
          std::string(R"({"coasts": [{"colour": "#zz", "shore": [[0, 0], [1, 1]], "ridge": [[0, 0, 1]]}]})"),
          std::string(R"({"position": {"latitude_deg": 1e999, "longitude_deg": 0}})"),
          std::string(30000, '['), std::string(10, '\xff')}) {
        exercise::ExerciseDef def;
        def.landmarks = text;
        const auto bytes = exercise::write_checkpoint(exercise::Exercise(def));
        EXPECT_THROW(exercise::read_checkpoint(bytes, config::check_definition), exercise::CheckpointError)
            << text.substr(0, 60);
    }
}

TEST(LandmarksOfAnExercise, AreNoLongerThanWireAndCheckpointKeep) {
    std::string umlauts;
    for (int k = 0; k < 17; ++k)
        umlauts += "\u00fc"; // 34 bytes, 17 characters
    EXPECT_THAT(refusal(R"({"marks": [{"name": ")" + umlauts +
                        R"(", "kind": "tower", "x": 1, "y": 2, "height": 3}]})"),
                HasSubstr("at most 32 bytes of UTF-8"));
    std::string coasts; // each of which the schema allows
    for (int k = 0; k < 16; ++k) {
        std::string shore, ridge;
        for (int point = 0; point < 256; ++point) {
            shore += fmt::format("{}[{}.125, 10000.125]", point ? ", " : "", 1000 + point);
            ridge += fmt::format("{}[{}.125, 10000.125, 100]", point ? ", " : "", 1000 + point);
        }
        coasts += fmt::format(R"({}{{"colour": "#4c5f4e", "shore": [{}], "ridge": [{}]}})", k ? ", " : "",
                              shore, ridge);
    }
    EXPECT_THAT(refusal(R"({"coasts": [)" + coasts + "]}"),
                ::testing::ContainsRegex("/landmarks: [0-9]+ is not allowed: at most 65536 bytes"));
}

TEST(LandmarksOfAnExercise, AreRefusedWhereTheyDoNotFitTogether) {
    EXPECT_THAT(refusal(R"({"coasts": [{"colour": "#4c5f4e", "shore": [[1, 2], [3, 4]],
                                        "ridge": [[5, 6, 7], [8, 9, 10], [1, 1, 1]]}]})"),
                HasSubstr("x.json: /landmarks/coasts/0/ridge: 3 points is not allowed: 2, as shore has"));
    const auto marks = [](const std::string& light, const std::string& more = "") {
        return R"({"marks": [{"name": "A", "kind": "tower", "x": 1, "y": 2, "height": 3)" + light + "}]" +
               more + "}";
    };
    EXPECT_EQ(refusal(marks("")), "");
    EXPECT_THAT(refusal(marks(R"(, "period": 4, "flashes": [[0, 1]])")),
                HasSubstr("/landmarks/marks/0/light: none"));
    EXPECT_THAT(refusal(marks(R"(, "light": "red", "period": 4)")),
                HasSubstr("/landmarks/marks/0/flashes: []"));
    EXPECT_THAT(refusal(marks(R"(, "light": "red", "period": 4, "flashes": [[3, 2]])")),
                HasSubstr("/landmarks/marks/0/flashes/0: [3,2] is not allowed"));
    EXPECT_THAT(refusal(marks(R"(, "light": "red", "period": 9, "flashes": [[0, 2], [1, 1]])")),
                HasSubstr("/landmarks/marks/0/flashes/1: [1,1] is not allowed"));
    const auto sectors = [&](const std::string& all) {
        return refusal(marks(R"(, "light": "white", "sectors": [)" + all + "]"));
    };
    const std::string red = R"({"light": "red", "from_deg": 350, "to_deg": 20})";
    EXPECT_EQ(sectors(red + R"(, {"light": "none", "from_deg": 20, "to_deg": 90})"), "");
    EXPECT_THAT(sectors(red + R"(, {"light": "green", "from_deg": 19, "to_deg": 90})"),
                HasSubstr("/landmarks/marks/0/sectors/1: 19 to 90 is not allowed"));
    EXPECT_THAT(sectors(red + R"(, {"light": "green", "from_deg": 300, "to_deg": 351})"),
                HasSubstr("/landmarks/marks/0/sectors/1: 300 to 351 is not allowed"));
    EXPECT_THAT(sectors(R"({"light": "white", "from_deg": 3, "to_deg": 9})"),
                HasSubstr("/landmarks/marks/0/sectors/0/light: \"white\" is not allowed"));
    EXPECT_THAT(sectors(R"({"light": "red", "from_deg": 3, "to_deg": 3})"),
                HasSubstr("/landmarks/marks/0/sectors/0/to_deg: 3 is not allowed"));
    EXPECT_THAT(refusal(marks(R"(, "sectors": [)" + red + "]")), HasSubstr("the mark has no light"));
    EXPECT_THAT(refusal(marks("", R"(, "transits": [{"name": "In", "front": "A", "rear": "B"}])")),
                HasSubstr(R"(/landmarks/transits/0/rear: "B" is not allowed: the name of a mark)"));
    EXPECT_THAT(refusal(marks("", R"(, "transits": [{"name": "In", "front": "A", "rear": "A"}])")),
                HasSubstr("another mark than front"));
    EXPECT_THAT(refusal(R"({"marks": [{"name": "A", "kind": "lightship", "x": 1, "y": 2, "height": 3}]})"),
                HasSubstr("/landmarks/marks/0/kind"));
    EXPECT_THAT(refusal(R"({"from": "nowhere"})"), HasSubstr("north_point"));
}

} // namespace
} // namespace windlass::perceive
