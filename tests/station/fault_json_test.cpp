// The table of faults as the instructor's page has it.

#include "instructor_console/status_text.hpp"
#include "station/names.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <set>

namespace windlass::console {
namespace {

TEST(FaultJson, HasEveryFaultOnceWithItsWords) {
    const nlohmann::json list = fault_json();
    std::set<std::string> wire_names;
    for (const auto& fault : list) {
        const auto code = fault.at("code").get<std::string>();
        EXPECT_TRUE(station::fault_code(code)) << code;
        EXPECT_TRUE(wire_names.insert(fault.at("wire_name").get<std::string>()).second) << code;
        EXPECT_TRUE(fault.at("wire_name").get<std::string>().starts_with("FAULT_")) << code;
        for (const char* words : {"symptom", "reason", "way_out", "severity"})
            EXPECT_FALSE(fault.at(words).get<std::string>().empty()) << code << ' ' << words;
        EXPECT_TRUE(fault.at("both_sides").is_boolean()) << code;
        EXPECT_TRUE(fault.at("targets").is_string()) << code;
    }
    EXPECT_EQ(wire_names.size(), static_cast<std::size_t>(FAULT_SHIP_BLACKOUT) + 1)
        << "the last of the wire's";
}

} // namespace
} // namespace windlass::console
