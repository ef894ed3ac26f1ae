// topics.md, which foreign clients are built from, says what the code does.

#include "idl/topics.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace windlass::wire {
namespace {

using Row = std::vector<std::string>;

/// Rows of the tables of topics in topics.md, by topic.
std::map<std::string, Row> documented() {
    std::ifstream file(WINDLASS_TOPICS_MD);
    std::map<std::string, Row> rows;
    std::string line;
    bool in_table = false;
    while (std::getline(file, line)) {
        if (line.rfind("| topic | type |", 0) == 0) in_table = true;
        if (line.empty()) in_table = false;
        if (!in_table) continue;
        Row row;
        std::istringstream cells(line.substr(1));
        for (std::string cell; std::getline(cells, cell, '|');) {
            const auto first = cell.find_first_not_of(' ');
            row.push_back(
                first == std::string::npos ? "" : cell.substr(first, cell.find_last_not_of(' ') - first + 1));
        }
        if (row.at(0) != "topic" && row.at(0).rfind("---", 0) != 0) rows[row.at(0)] = row;
    }
    return rows;
}

std::string number(double value) {
    std::ostringstream out;
    out << value;
    return out.str();
}

class TopicsDocument : public testing::TestWithParam<TopicInfo> {};

TEST_P(TopicsDocument, SaysWhatTheCodeDoes) {
    const TopicInfo& info = GetParam();
    const auto rows = documented();
    ASSERT_TRUE(rows.contains(info.name));
    const Row& row = rows.at(info.name);
    ASSERT_EQ(row.size(), 11U);
    EXPECT_EQ(row[1], std::string("windlass::") + info.name);
    EXPECT_EQ(row[2] != "-", info.keyed);
    EXPECT_EQ(row[3], number(info.instances));
    EXPECT_EQ(row[4], info.from_server ? "server -> all" : "clients -> server");
    EXPECT_EQ(row[5], info.rate > 0 ? number(info.rate) : "at once");
    EXPECT_EQ(row[6], info.reliable ? "reliable" : "best-effort");
    EXPECT_EQ(row[7], info.transient_local ? "transient-local" : "volatile");
    EXPECT_EQ(row[8], number(info.depth));
    EXPECT_EQ(row[9], info.exclusive ? "exclusive" : "shared");
    EXPECT_EQ(row[10], info.deadline > 0 ? number(info.deadline) : "-");
}

INSTANTIATE_TEST_SUITE_P(EveryTopic, TopicsDocument, testing::ValuesIn(topics::all),
                         [](const auto& info) { return std::string(info.param.name); });
INSTANTIATE_TEST_SUITE_P(EveryTopicOfTheClassroom, TopicsDocument, testing::ValuesIn(topics::classroom),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(TopicsTable, NamesNoTopicThatTheCodeDoesNotHave) {
    EXPECT_EQ(documented().size(), topics::all.size() + topics::classroom.size());
}

} // namespace
} // namespace windlass::wire
