// The layout for Foxglove and Lichtblick names topics and fields that there are.

#include "idl/idl_text.hpp"
#include "station/gateway/roles.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <regex>

namespace windlass::gateway {
namespace {

using nlohmann::json;

/// "/WindlassLoad{side==0}.cable_out": the topic is there, and its type has the fields.
void expect_known(const std::string& path) {
    static const std::regex form(R"(/(\w+)(?:\{(\w+)==\d+\})?(?:\.(\w+))?)");
    std::smatch parts;
    ASSERT_TRUE(std::regex_match(path, parts, form)) << path;
    const wire::TopicInfo* topic = find_topic(parts[1]);
    ASSERT_NE(topic, nullptr) << path;
    const auto& members = idl::own_schema().find(wire::type_name(*topic))->members;
    for (const std::string& field : {parts[2].str(), parts[3].str()})
        EXPECT_TRUE(field.empty() || std::ranges::find(members, field, &idl::Member::name) != members.end())
            << path;
}

void collect_panels(const json& node, std::vector<std::string>& panels) {
    if (node.is_string()) return panels.push_back(node);
    collect_panels(node.at("first"), panels);
    collect_panels(node.at("second"), panels);
}

TEST(FoxgloveLayout, NamesTopicsAndFieldsOfTheWire) {
    const json layout = json::parse(std::ifstream(WINDLASS_LAYOUT));
    int paths = 0;
    for (const json& panel : layout.at("configById")) {
        EXPECT_EQ(panel.value("topicToRender", "/log"), "/log"); // EventLog's: the only one of that kind
        const json topics_drawn = panel.value("topics", json::object());
        for (const auto& [topic, unused] : topics_drawn.items())
            EXPECT_EQ(topic, "/scene"); // SceneChannel's: the only one that a 3D panel takes
        if (panel.contains("topicPath")) {
            expect_known(panel["topicPath"]);
            ++paths;
        }
        for (const json& line : panel.value("paths", json::array())) {
            expect_known(line.at("value"));
            ++paths;
        }
    }
    EXPECT_GT(paths, 10);
}

TEST(FoxgloveLayout, ShowsEveryPanelThatItDescribesAndNoOther) {
    const json layout = json::parse(std::ifstream(WINDLASS_LAYOUT));
    std::vector<std::string> shown, described;
    collect_panels(layout.at("layout"), shown);
    for (const auto& [name, unused] : layout.at("configById").items())
        described.push_back(name);
    std::ranges::sort(shown);
    EXPECT_EQ(shown, described);
}

} // namespace
} // namespace windlass::gateway
