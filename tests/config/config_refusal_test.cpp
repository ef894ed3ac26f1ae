// Exercise files that are refused, each with file, pointer, value and what is allowed.

#include "common/json_schema.hpp"
#include "tests/config/config_files.hpp"

#include <nlohmann/json.hpp>

#include <sys/stat.h>

namespace windlass::config {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;
using test::ConfigFiles;

TEST_F(ConfigFiles, FaultsAndStartAtAnchorThatCannotBeAreRefused) {
    const auto says = [&](const char* text, const char* part) {
        EXPECT_NE(refusal(text).find(part), std::string::npos) << refusal(text);
    };
    says(R"({"faults": [{"code": "brake-wet", "side": "starboard"}]})",
         "/faults/0/side: starboard is not allowed: a side that tackle has");
    says(R"({"faults": [{"code": "brake-wet"}, {"code": "brake-wet"}]})", "/faults/1/code: brake-wet");
    says(R"({"faults": [{"code": "brake-wet", "when": {"chance": [9, 3]}}]})", "/faults/0/when/chance/1: 3");
    says(R"({"faults": [{"code": "brake-wet", "when": {"time": 1, "event": "x"}}]})", "/faults/0/when");
    says(R"({"tackle": [{"at_anchor": 1}]})", "/tackle/0/at_anchor: 1 is not allowed: at least 2.3 shackles");
    says(R"({"tackle": [{"at_anchor": 20}]})", "/tackle/0/at_anchor: 20 is not allowed: at most");
    says(R"({"tackle": [{"at_anchor": 7}, {"side": "starboard", "at_anchor": 6}]})",
         "/tackle/0/at_anchor: 7 is not allowed: at most");
    says(R"({"tackle": [{"at_anchor": 6}], "ship_start": {"turned_deg": 180}})",
         "/ship_start/turned_deg: 180 is not allowed: 0");
    says(R"({"tackle": [{"at_anchor": 6, "brake": 0.03}]})", "/tackle/0/brake: 0.03 is not allowed");
    EXPECT_EQ(refusal(R"({"tackle": [{"at_anchor": 6, "brake": 0.03, "stopper_closed": true}]})"), "");
}

// It would begin below the bottom, and be thrown out of it.
TEST_F(ConfigFiles, AnchorThatStartsBelowTheLipHangsClearOfTheBottom) {
    EXPECT_EQ(refusal(R"({"environment": {"depth": 25}, "tackle": [{"cable_out": 27}]})"), "");
    const std::string said = refusal(R"({"environment": {"depth": 25}, "tackle": [{"cable_out": 110}]})");
    EXPECT_NE(said.find("/tackle/0/cable_out: 110 is not allowed: at most 2"), std::string::npos) << said;
    EXPECT_NE(said.find("a ship that lies to her cable has at_anchor"), std::string::npos) << said;
}

struct BadFile {
    const char* name;
    std::string text;
    std::vector<std::string> says; ///< parts of the refusal, in any order
};

class BadExercise : public ConfigFiles, public ::testing::WithParamInterface<BadFile> {};

TEST_P(BadExercise, IsRefusedWithFilePointerValueAndWhatIsAllowed) {
    const std::string text = refusal(GetParam().text);
    EXPECT_EQ(text.rfind((root_ / "exercises/x.json").string() + ": ", 0), 0U) << text;
    for (const std::string& part : GetParam().says)
        EXPECT_NE(text.find(part), std::string::npos) << "expected: " << part << "\nin: " << text;
}

INSTANTIATE_TEST_SUITE_P(
    Files, BadExercise,
    ::testing::Values(
        BadFile{"OutOfRange",
                R"({"environment": {"depth": -3}})",
                {"/environment/depth: -3 is not allowed: a number from 2 to 1000 (m, water depth; where the "
                 "ground slopes, at x = y = 0)"}},
        BadFile{"WrongType",
                R"({"environment": {"depth": "deep"}})",
                {R"(/environment/depth: "deep" is not allowed: a number from 2 to 1000)"}},
        BadFile{"Null",
                R"({"environment": {"depth": null}})",
                {"/environment/depth: null is not allowed: a number"}},
        BadFile{"NumberForFlag",
                R"({"tackle": [{"clutch_in": 1}]})",
                {"/tackle/0/clutch_in: 1 is not allowed: true or false (dog clutch at the start)"}},
        BadFile{"FractionForWholeNumber",
                R"({"tick_rate_hz": 99.5})",
                {"/tick_rate_hz: 99.5 is not allowed: a whole number from 60 to 1200"}},
        BadFile{
            "UnknownChoice",
            R"({"environment": {"soil": "lava"}})",
            {R"(/environment/soil: "lava" is not allowed: one of "mud", "sand", "clay", "gravel", "rock", "coral", "mixed")"}},
        BadFile{"RaggedGrid",
                R"({"environment": {"ground": {"heights": [[0, 0], [0], [0, 0]], "soils": ["SS", "SSS"]}}})",
                {"/environment/ground/heights/1: 1 points is not allowed: 2, as in the first row",
                 "/environment/ground/soils/1: 3 points is not allowed: 2, as in the first row",
                 "/environment/ground/soils: 2 rows is not allowed: 3, as heights has"}},
        BadFile{"CliffInTheGrid",
                R"({"environment": {"ground": {"heights": [[0, 0], [0, 31]]}}})",
                {"/environment/ground/heights/1/1: 31 is not allowed: within 30 m of its neighbour, 0"}},
        BadFile{"UnknownSoilLetter",
                R"({"environment": {"ground": {"soils": ["SZ"]}}})",
                {R"(/environment/ground/soils/0: "SZ" is not allowed: text in quotes of 1 to 128 characters)",
                 "M mud, S sand"}},
        BadFile{"ShipAgroundAtItsStart",
                R"({"environment": {"depth": 20, "ground": {"slope_deg": 10, "slope_towards_deg": 180}}})",
                {"/environment/ground: ", "she would be aground"}},
        BadFile{"MisspeltField",
                R"({"environment": {"dept": 30}})",
                {R"(/environment/dept: no such field here; the nearest known one is "depth")"}},
        BadFile{"FieldWithoutItsUnit",
                R"({"environment": {"wind_from": 3}})",
                {R"(the nearest known one is "wind_from_deg")"}},
        BadFile{"StrangeField",
                R"({"tackle": [{"xyzzy": 1}]})",
                {"/tackle/0/xyzzy: no such field here; known are: anchor, anchor_home, at_anchor, brake"}},
        BadFile{"FieldInsidePart",
                R"({"tackle": [{"chain": {"diametre": 0.07}}]})",
                {R"(/tackle/0/chain/diametre: no such field here; the nearest known one is "diameter")"}},
        BadFile{"SeveralFaultsAtOnce",
                R"({"ship": {"beam": 0}, "tackle": [{"brake": 2}], "max_substeps": 0})",
                {"/ship/beam: 0 is not allowed", "/tackle/0/brake: 2 is not allowed: a number from 0 to 1",
                 "/max_substeps: 0 is not allowed"}},
        BadFile{
            "NoTackle", R"({"tackle": []})", {"/tackle: [] is not allowed: a list [...] of 1 to 2 entries"}},
        BadFile{"ListForObject", "[]", {"/: [] is not allowed: an object {...}"}},
        BadFile{
            "BadName", R"({"name": "a b"})", {R"(/name: "a b" is not allowed: text in quotes of 1 to 64)"}},
        BadFile{"NotJson", "{\n  \"name\": \"x\",\n  oops\n}", {"line 3, column 3: not JSON: "}},
        BadFile{"CutOff", R"({"environment": {)", {"line 1, column 18: not JSON: "}},
        BadFile{"Empty", "", {"line 1, column 1: not JSON: "}},
        BadFile{"NotANumber", R"({"environment": {"depth": NaN}})", {"line 1, column ", "not JSON"}},
        BadFile{"TooLargeForADouble",
                "{\"environment\":\n {\"depth\": 1e999}}",
                {"line 2, column 12: 1e999 is not allowed: larger than any number that can be stored"}},
        BadFile{"FieldGivenTwice",
                R"({"environment": {"depth": 25, "depth": 30}})",
                {R"(field "depth" is given twice)"}},
        BadFile{"UnknownShip",
                R"({"ship": {"from": "bulk"}})",
                {R"(/ship/from: "bulk" is not allowed: there is no )", "there are: bulk_carrier_225m"}},
        BadFile{"RefersToItself", R"({"from": "x"})", {"/from: refers back to itself"}},
        BadFile{"CableLongerThanTheChain",
                R"({"tackle": [{"cable_out": 400}]})",
                {"/tackle/0/cable_out: 400 is not allowed: at most 312 m"}},
        BadFile{"HoveInBeyondTheSeat",
                R"({"tackle": [{"cable_out": -4}]})",
                {"/tackle/0/cable_out: -4 is not allowed: at least -2.8", "there the anchor is home"}},
        BadFile{"LipInsideTheHull",
                R"({"ship": {"from": "bulk_carrier_225m", "hawse_outboard": 1}})",
                {"/ship/hawse_outboard: 1 is not allowed: at least", "104 m forward of midships"}},
        BadFile{"SameSideTwice",
                R"({"tackle": [{}, {}]})",
                {"/tackle/1/side: the same as /tackle/0/side is not allowed"}},
        BadFile{"Aground",
                R"({"environment": {"depth": 10}})",
                {"/environment/depth: 10 is not allowed: above the ship's draught, 12.5 m"}},
        BadFile{"AgroundByTheStern",
                R"({"ship": {"from": "bulk_carrier_225m", "trim": 3}, "environment": {"depth": 13.9}})",
                {"/environment/depth: 13.9 is not allowed: above the ship's draught, 14 m"}},
        BadFile{"TrimmedOutOfTheWater",
                R"({"ship": {"from": "bulk_carrier_225m", "draught": 6, "trim": 6.5}})",
                {"/ship/trim: 6.5 is not allowed: within the draught, 6 m"}},
        BadFile{"DeeperThanTheChain",
                R"({"environment": {"depth": 400}})",
                {"/environment/depth: 400 is not allowed: less than the chain of /tackle/0, 330 m"}},
        BadFile{"ChainDoesNotFitTheGypsy",
                R"({"tackle": [{"chain": {"diameter": 0.052}}]})",
                {"/tackle/0/windlass/gypsy_radius: 0.5 is not allowed: from 0.296 to 0.374 m"}},
        BadFile{"TooManyNodes",
                R"({"tackle": [{"chain": {"length": 1000, "node_spacing": 0.3}}]})",
                {"/tackle/0/chain/node_spacing: 0.3 is not allowed: at least 0.489 m"}},
        BadFile{
            "WindlassOfAnEarlierVersion",
            R"({"tackle": [{"windlass": {"clutch_claws": 6}}]})",
            {"/tackle/0/windlass/clutch_claws: a field of an earlier version; leave it out: it is alike in "
             "every windlass"}},
        BadFile{"ChainOfAnEarlierVersion",
                R"({"tackle": [{"chain": {"drag_axial": 0.3}}]})",
                {"/tackle/0/chain/drag_axial: a field of an earlier version; leave it out: it follows from "
                 "diameter and grade"}},
        BadFile{
            "AnchorOfAnEarlierVersion",
            R"({"tackle": [{"anchor": {"holding_sand": 4}}]})",
            {"/tackle/0/anchor/holding_sand: a field of an earlier version; leave it out: it follows from "
             "type and mass"}},
        BadFile{
            "BedOfAnEarlierVersion",
            R"({"environment": {"bed_friction": 0.5}})",
            {"/environment/bed_friction: a field of an earlier version; leave it out: it follows from the "
             "soil"}}),
    [](const auto& info) { return info.param.name; });

TEST_F(ConfigFiles, FaultInAPartNamesThePartsFile) {
    const fs::path ship = write("ships/wreck.json", R"({"draught": -1})");
    EXPECT_EQ(refusal(R"({"ship": {"from": "wreck"}})"),
              ship.string() + ": /draught: -1 is not allowed: a number from 0.5 to 30 (m)");
}

TEST_F(ConfigFiles, MissingFileIsNamed) {
    try {
        load_exercise(root_ / "exercises/none.json");
        FAIL() << "loaded a file that is not there";
    } catch (const ConfigError& error) {
        EXPECT_EQ(error.what(),
                  (root_ / "exercises/none.json").string() + ": cannot be read: No such file or directory");
    }
}

TEST_F(ConfigFiles, FolderIsNoFile) {
    EXPECT_THROW(load_exercise(root_ / "exercises"), ConfigError);
}

// Nobody writes into this FIFO: whoever waited for it would wait for ever.
TEST_F(ConfigFiles, WhatIsNoRegularFileIsToldAtOnce) {
    const fs::path fifo = write("exercises/x.json", "").replace_filename("fifo.json");
    ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
    try {
        load_exercise(fifo);
        FAIL();
    } catch (const ConfigError& error) {
        EXPECT_EQ(std::string(error.what()), fifo.string() + ": is no regular file");
    }
}

TEST_F(ConfigFiles, FileOfManyMegabytesIsNotRead) {
    const fs::path file = write("exercises/x.json", "{}");
    fs::resize_file(file, 17 << 20);
    try {
        load_exercise(file);
        FAIL();
    } catch (const ConfigError& error) {
        EXPECT_EQ(std::string(error.what()), file.string() + ": is longer than 16777216 bytes");
    }
}

TEST(JsonSchemaText, MissingFieldIsNamedWithWhatItTakes) {
    const JsonSchema schema(R"({"type": "object", "required": ["when"],
                               "properties": {"when": {"type": "number", "minimum": 0, "description": "s"}}})");
    try {
        schema.check(Json::object(), "script.json");
        FAIL() << "accepted";
    } catch (const ConfigError& error) {
        EXPECT_STREQ(error.what(), "script.json: /when: is missing: a number of at least 0 (s)");
    }
}

TEST(JsonSchemaText, NoSchemaIsRefused) {
    EXPECT_THROW(JsonSchema("{"), std::invalid_argument);
}

} // namespace
} // namespace windlass::config
