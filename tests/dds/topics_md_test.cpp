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

/// Of a line of a table, without the spaces around them.
Row cells_of(const std::string& line) {
    Row row;
    std::istringstream cells(line.substr(1));
    for (std::string cell; std::getline(cells, cell, '|');) {
        const auto first = cell.find_first_not_of(' ');
        row.push_back(
            first == std::string::npos ? "" : cell.substr(first, cell.find_last_not_of(' ') - first + 1));
    }
    return row;
}

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
        const Row row = cells_of(line);
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
    EXPECT_EQ(row[1], type_name(info));
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

/// "topic role" -> "R", "W" or "RW" in live exercises: what topics.md says, and what identities are made of.
std::map<std::string, std::string> documented_rights() {
    std::ifstream file(WINDLASS_TOPICS_MD);
    std::map<std::string, std::string> rights;
    Row roles;
    for (std::string line; std::getline(file, line);) {
        if (line.rfind("| topic | forecastle |", 0) == 0) roles = cells_of(line);
        if (line.empty() || line[0] != '|') roles.clear();
        if (roles.empty()) continue;
        const Row row = cells_of(line);
        for (std::size_t i = 1; i < row.size() && row[0] != "topic" && row[0].rfind("---", 0) != 0; ++i)
            if (row[i] != "-") rights[row[0] + " " + roles.at(i)] = row[i];
    }
    return rights;
}

std::map<std::string, std::string> given_rights() {
    std::ifstream file(WINDLASS_ROLES);
    std::map<std::string, std::string> rights;
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string role, partition, what, topic;
        if (line.empty() || line[0] == '#' || !(words >> role >> partition >> what)) continue;
        if (partition != "exercise/*" || role == "server") continue;
        while (words >> topic) {
            auto& right = rights[topic + " " + role];
            right = what == "read" ? "R" + right : right + "W";
        }
    }
    return rights;
}

TEST(RightsTable, SaysWhatIdentitiesAreGiven) {
    EXPECT_EQ(documented_rights(), given_rights());
}

} // namespace
} // namespace windlass::wire
