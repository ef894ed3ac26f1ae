// What a seat's page may hear and order is what config/security/roles.txt gives that role, but for
// Checkpoint.

#include "station/gateway/roles.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <map>
#include <set>
#include <sstream>

namespace windlass::gateway {
namespace {

using station::Seat;
using Names = std::set<std::string>;

/// Topics by role, partition and "read" or "write".
std::map<std::string, Names> granted() {
    std::ifstream file(WINDLASS_ROLES);
    std::map<std::string, Names> found;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line.starts_with('#')) continue;
        std::istringstream words(line);
        std::string role, partition, what, topic;
        words >> role >> partition >> what;
        while (words >> topic)
            found[role + " " + partition + " " + what].insert(topic);
    }
    return found;
}

Names names(const Topics& topics) {
    Names found;
    for (const wire::TopicInfo* topic : topics)
        found.insert(topic->name);
    EXPECT_EQ(found.size(), topics.size()) << "a topic stands there twice";
    return found;
}

Names without_checkpoint(Names all) {
    all.erase("Checkpoint");
    return all;
}

class RoleOf : public ::testing::TestWithParam<Seat> {};

TEST_P(RoleOf, ASeatIsWhatRolesTxtGivesIt) {
    const auto table = granted();
    const Role live = role_of(GetParam(), "mine"), replay = role_of(GetParam(), "replay-1");
    const auto of = [&](const char* where) {
        const auto found = table.find(live.name + where);
        return found == table.end() ? Names{} : found->second;
    };
    EXPECT_EQ(names(live.hears), without_checkpoint(of(" exercise/* read")));
    EXPECT_EQ(names(live.writes), of(" exercise/* write"));
    EXPECT_EQ(names(live.classroom_hears), of(" classroom read"));
    EXPECT_EQ(names(live.classroom_writes), of(" classroom write"));
    Names in_replay = of(" exercise/* read");
    in_replay.merge(of(" exercise/replay* read"));
    EXPECT_EQ(names(replay.hears), without_checkpoint(in_replay));
    Names given_in_replay = of(" exercise/* write");
    given_in_replay.merge(of(" exercise/replay* write"));
    EXPECT_EQ(names(replay.writes), given_in_replay);
    EXPECT_EQ(may_replay(GetParam()), given_in_replay.contains("ReplayCommand"));
}

TEST_P(RoleOf, NoTraineesSeatHearsATopicOfTheTruthLive) {
    const Names heard = names(role_of(GetParam(), "mine").hears);
    for (const char* truth : {"ExerciseTruth", "EnvironmentState", "ShipState", "AnchorState", "ChainState",
                              "WindlassLoad", "CableForce", "SeabedDescription", "Event", "ServerAlert",
                              "OrderTaken", "Assessment", "Prediction"})
        EXPECT_EQ(heard.contains(truth), has_truth(GetParam())) << truth;
    EXPECT_EQ(heard.contains("FaultCommand"), GetParam() == Seat::instructor);
}

// On a ship the bridge has no panel that tells of a cable that runs away: somebody reports it.
TEST_P(RoleOf, ASeatHearsTheAlertsOfItsOwnPanel) {
    const Names heard = names(role_of(GetParam(), "mine").hears);
    EXPECT_EQ(heard.contains("ForecastleAlert"), GetParam() != Seat::conning);
    EXPECT_EQ(heard.contains("Alert"), GetParam() != Seat::forecastle);
}

// Nor does it see from there a cable that jumps or a brake that smokes.
TEST_P(RoleOf, ASeatHearsTheEventsOfItsOwnPlace) {
    const Names heard = names(role_of(GetParam(), "mine").hears);
    EXPECT_EQ(heard.contains("ForecastleEvent"), GetParam() != Seat::conning);
    EXPECT_EQ(heard.contains("BridgeEvent"), GetParam() != Seat::forecastle);
}

INSTANTIATE_TEST_SUITE_P(Seats, RoleOf,
                         ::testing::Values(Seat::forecastle, Seat::conning, Seat::trainee, Seat::watcher,
                                           Seat::observer, Seat::assessor, Seat::instructor),
                         [](const auto& seat) { return role_of(seat.param, "mine").name; });

TEST(FindTopic, KnowsEveryRowAndNothingElse) {
    for (const auto& row : wire::topics::all)
        EXPECT_EQ(find_topic(row.name), &row);
    EXPECT_EQ(find_topic("ClassroomCommand")->type, std::string("ClassroomCommand"));
    EXPECT_EQ(find_topic("shipstate"), nullptr);
    EXPECT_EQ(find_topic(""), nullptr);
}

} // namespace
} // namespace windlass::gateway
