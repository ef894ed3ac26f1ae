// What an instructor's station has beside its pages: a recorder, the way from a recording into a live
// exercise, and Foxglove, which looks on.

#include "recorder/recording/recording.hpp"
#include "tests/wire/gateway_rig.hpp"
#include "tests/wire/run_program.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <csignal>
#include <fstream>
#include <sstream>

namespace windlass::test {
using namespace rigs;

namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;
namespace fs = std::filesystem;

class InstructorStation : public GatewayRig {
protected:
    InstructorStation()
        : folder_(fs::temp_directory_path() / ("windlass_gateway_recordings_" + std::to_string(getpid()))) {}
    ~InstructorStation() override { fs::remove_all(folder_); }

    fs::path folder_;
};

TEST_F(InstructorStation, RecordsAnExerciseAndGoesOnLiveFromIt) {
    const auto desk = instructor(
        {"--recordings", folder_.string(), "--exercises", std::string(WINDLASS_CONFIG_DIR) + "/exercises"});
    PageClient teacher(desk->address);
    EXPECT_EQ(teacher.wait_for("hello")["recording"], nullptr);
    for (const char* name : {"../elsewhere", ".hidden", "a/b", "a b"}) {
        teacher.say({{"op", "record"}, {"id", name}, {"on", true}, {"name", name}});
        EXPECT_EQ(teacher.wait_for("refused", {{"id", name}})["field"], "name");
    }
    teacher.say({{"op", "record"}, {"id", 1}, {"on", true}, {"name", "monday"}});
    EXPECT_FALSE(teacher.wait_for("sent", {{"id", 1}}).is_null()) << desk->text();
    EXPECT_FALSE(teacher.wait_for("hello", {{"recording", "monday"}}).is_null());
    teacher.say({{"op", "record"}, {"id", 2}, {"on", true}, {"name", "tuesday"}});
    EXPECT_THAT(teacher.wait_for("refused", {{"id", 2}}).value("allowed", ""), HasSubstr("already"));

    // From the beginning: what a recorder has from no checkpoint on cannot be gone through again.
    ASSERT_TRUE(eventually([&] { return desk->text().find("recording partition") != std::string::npos; }));
    give(teacher, "ExerciseCommand", {{"action", "EXERCISE_RESET"}});
    give(teacher, "ExerciseCommand", {{"action", "EXERCISE_START"}});
    ASSERT_TRUE(eventually([&] { return status().state() == RUN_RUNNING && status().time() > 4; }));
    teacher.say({{"op", "record"}, {"id", 3}, {"on", false}});
    EXPECT_TRUE(eventually([&] { return teacher.told("hello").back()["recording"].is_null(); }))
        << desk->text();

    for (const char* name : {"../monday", "sunday", "."}) {
        teacher.say({{"op", "continue_live"},
                     {"id", name},
                     {"recording", name},
                     {"position", 1},
                     {"exercise", "second"}});
        EXPECT_EQ(teacher.wait_for("refused", {{"id", name}})["field"], "recording");
    }
    const recording::Recording recorded({folder_ / "monday"});
    EXPECT_FALSE(recorded.files().front()->attachments().empty()) << "the exercise's files go along";
    teacher.say({{"op", "continue_live"},
                 {"id", 4},
                 {"recording", "monday"},
                 {"position", recorded.seconds() - 1},
                 {"exercise", "second"}});
    EXPECT_TRUE(eventually([&] {
        return !teacher.told("sent").empty() && teacher.told("sent").back()["id"] == 4;
    })) << desk->text();
    PageClient::Options second;
    second.exercise = "second";
    const PageClient there(desk->address, second);
    EXPECT_TRUE(eventually([&] {
        const auto states = there.all<ExerciseStatus>("ExerciseStatus");
        return !states.empty() && states.back().state() == RUN_PAUSED && states.back().time() > 2;
    })) << desk->text();
    EXPECT_TRUE(eventually([&] {
        return std::ranges::any_of(there.all<Event>("Event"),
                                   [](const Event& event) { return event.code() == "exercise.restored"; });
    }));
    EXPECT_EQ(status().state(), RUN_RUNNING) << "the recorded exercise itself goes on";
}

/// Processes that it has started and that are there.
std::vector<pid_t> children_of(pid_t parent) {
    std::vector<pid_t> children;
    for (const auto& each : fs::directory_iterator("/proc")) {
        if (!std::isdigit(static_cast<unsigned char>(each.path().filename().native().front()))) continue;
        std::ifstream file(each.path() / "stat");
        const std::string stat{std::istreambuf_iterator<char>(file), {}};
        const auto name_ends = stat.rfind(')');
        if (name_ends == std::string::npos) continue; // gone
        std::istringstream fields(stat.substr(name_ends + 1));
        char state = 0;
        pid_t its_parent = 0;
        if (fields >> state >> its_parent && its_parent == parent && state != 'Z')
            children.push_back(std::stoi(each.path().filename()));
    }
    return children;
}

TEST_F(InstructorStation, RecordsSeveralExercisesWithOneRecorderAndGoesOnWhereThatIsLost) {
    const auto desk = instructor({"--recordings", folder_.string()});
    PageClient teacher(desk->address);
    PageClient::Options options;
    options.exercise = "second";
    PageClient second(desk->address, options);
    const auto times = [&](const std::string& what) {
        const std::string text = desk->text();
        std::size_t count = 0;
        for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
            ++count;
        return count;
    };
    teacher.say({{"op", "record"}, {"id", 1}, {"on", true}, {"name", "monday"}});
    second.say({{"op", "record"}, {"id", 1}, {"on", true}, {"name", "tuesday"}});
    ASSERT_TRUE(eventually([&] { return times("recording partition") == 2; })) << desk->text();
    const auto has_begun = [&](const char* name) {
        try {
            return recording::Recording({folder_ / name}).seconds() > 0;
        } catch (const std::exception&) {
            return false; // nothing is on the disk yet
        }
    };
    ASSERT_TRUE(eventually([&] { return has_begun("monday") && has_begun("tuesday"); })) << desk->text();

    const auto recorders = children_of(desk->pid());
    ASSERT_EQ(recorders.size(), 1U);
    kill(recorders.front(), SIGKILL);
    EXPECT_FALSE(teacher.wait_for("hello", {{"recording", "monday-2"}}).is_null()) << desk->text();
    EXPECT_FALSE(second.wait_for("hello", {{"recording", "tuesday-2"}}).is_null()) << desk->text();
    ASSERT_TRUE(eventually([&] { return has_begun("monday-2") && has_begun("tuesday-2"); })) << desk->text();

    teacher.say({{"op", "record"}, {"id", 2}, {"on", false}});
    EXPECT_FALSE(teacher.wait_for("hello", {{"recorded", "monday-2"}, {"recording", nullptr}}).is_null());
    EXPECT_TRUE(children_of(desk->pid()).size() == 1U) << "tuesday goes on";
    second.say({{"op", "record"}, {"id", 2}, {"on", false}});
    EXPECT_TRUE(eventually([&] { return children_of(desk->pid()).empty(); })) << desk->text();
    for (const char* name : {"monday", "tuesday", "monday-2", "tuesday-2"})
        EXPECT_NO_THROW(recording::Recording({folder_ / name})) << name;
}

/// What the client library of Foxglove met.
json look_on(const PageAddress& address, const char* subprotocol, const std::string& topics) {
    const auto ending =
        run("node " WINDLASS_PAGES "/tools/ts.mjs " WINDLASS_PAGES "/tests/foxglove.ts 'ws://127.0.0.1:" +
            std::to_string(address.port) + "/foxglove?token=" + address.token + "' " + subprotocol + " 60 " +
            topics);
    const json met = json::parse(ending.text, nullptr, false);
    EXPECT_TRUE(met.is_object()) << ending.text;
    return met.is_object() ? met : json::object();
}

TEST_F(InstructorStation, FoxglovesOwnClientConnectsAndDecodesEveryChannelThatSpeaks) {
    const auto desk = instructor({"--foxglove"});
    PageClient teacher(desk->address);
    // So that the topics that speak when something happens do.
    give(teacher, "Report", {{"code", "REPORT_LET_GO"}, {"side", 0}});
    give(teacher, "BridgeOrderCommand", {{"code", "BRIDGE_ORDER_HOLD_ON"}, {"side", 0}, {"value", 6}});
    teacher.say(brake(1));
    const std::string topics =
        "/ExerciseStatus /ExerciseTruth /EnvironmentState /ShipState /AnchorState /ChainState "
        "/WindlassLoad /CableForce /ForecastleView /ForecastleCamera /BridgeView /Daylight /LightsAndShapes "
        "/SeaState /SceneDescription /Landmarks "
        "/SeabedDescription /Event /ForecastleEvent /BridgeEvent /BridgeOrder /OrderTaken /log /scene";
    for (const char* subprotocol : {"foxglove.websocket.v1", "foxglove.sdk.v1"}) {
        const json met = look_on(desk->address, subprotocol, topics);
        EXPECT_EQ(met.value("protocol", ""), subprotocol);
        EXPECT_EQ(met["server"]["name"], "Windlass gateway");
        EXPECT_EQ(met["server"]["capabilities"], json({"time"}));
        EXPECT_GT(met.value("times", 0), 1);
        // All of the table but Checkpoint, and log and scene.
        EXPECT_EQ(met.value("channels", 0U), wire::topics::all.size() - 1 + 2);
        EXPECT_EQ(met["topics"]["/log"], met["topics"]["/Event"]);
        std::istringstream names(topics);
        for (std::string name; names >> name;)
            EXPECT_TRUE(met["topics"].contains(name)) << name << " in " << met.dump();
        // Its order was answered, and nothing else was wrong.
        EXPECT_EQ(met["errors"], json({"this op is not known here"}));
    }
    EXPECT_NE(status().state(), RUN_FINISHED) << "a client that looks on gives no orders";
    const json refused = look_on(desk->address, "windlass.v1", "/Event");
    EXPECT_TRUE(refused["topics"].empty());
}

TEST_F(InstructorStation, SeesAMinuteAheadWhereItAsksAndWhatItSawIsRecorded) {
    const auto desk = instructor({"--recordings", folder_.string()});
    const auto deck = seat("forecastle");
    PageClient teacher(desk->address), trainee(deck->address);
    teacher.say({{"op", "record"}, {"id", 1}, {"on", true}, {"name", "ahead"}});
    ASSERT_FALSE(teacher.wait_for("hello", {{"recording", "ahead"}}).is_null()) << desk->text();
    // Only then does the recorder hear the server; it has begun long before, where cores are few.
    ASSERT_TRUE(eventually([&] { return desk->text().find(" attached") != std::string::npos; }));
    ASSERT_TRUE(eventually([&] { return !trainee.samples("ForecastleView").empty(); }));
    EXPECT_THAT(teacher.samples("Prediction"), IsEmpty()) << "off unless it is asked for";
    give(teacher, "ExerciseCommand", {{"action", "EXERCISE_PAUSE"}}); // it may wait long for a core
    give(teacher, "ExerciseCommand", {{"action", "EXERCISE_PREDICT"}, {"predict", true}});
    const auto newest = [&] {
        const auto told = teacher.all<Prediction>("Prediction");
        return told.empty() ? Prediction{} : told.back();
    };
    ASSERT_TRUE(eventually([&] { return newest().state() == PREDICTION_WHOLE; }, std::chrono::seconds(150)))
        << newest().state();
    EXPECT_EQ(newest().moments().size(), 61U);
    EXPECT_EQ(newest().run(), status().run());
    EXPECT_EQ(newest().moments()[60].time() - newest().time(), 60);
    EXPECT_TRUE(has_event("exercise.prediction", "predictions on by teacher"));
    give(teacher, "ExerciseCommand", {{"action", "EXERCISE_PREDICT"}, {"predict", false}});
    ASSERT_TRUE(eventually([&] { return newest().state() == PREDICTION_OFF; }));
    EXPECT_THAT(newest().moments(), IsEmpty());
    EXPECT_THAT(trainee.heard(), testing::Not(testing::Contains("Prediction")));
    {
        PageClient leaves(desk->address);
        give(leaves, "ExerciseCommand", {{"action", "EXERCISE_PREDICT"}, {"predict", true}});
        ASSERT_TRUE(eventually([&] { return newest().state() != PREDICTION_OFF; }));
    }
    EXPECT_TRUE(eventually([&] { return newest().state() == PREDICTION_OFF; })) << "he has left the desk";

    teacher.say({{"op", "record"}, {"id", 2}, {"on", false}});
    ASSERT_TRUE(eventually([&] { return teacher.told("hello").back()["recording"].is_null(); }));
    recording::Recording recording({folder_ / "ahead"});
    std::vector<PredictionState> recorded;
    auto cursor = recording.messages({.topics = {"Prediction"}});
    while (const auto message = cursor.next())
        recorded.push_back(recording::decode<Prediction>(message->payload).state());
    EXPECT_THAT(recorded, testing::Contains(PREDICTION_WHOLE));
    EXPECT_THAT(recorded, testing::Contains(PREDICTION_OFF));
}

std::vector<std::string> ids(const json& scene) {
    std::vector<std::string> all;
    for (const json& entity : scene.at("entities"))
        all.push_back(entity.at("id"));
    return all;
}

TEST_F(InstructorStation, FoxglovesClockAndSceneFollowTheExerciseAndGoBackWithARestore) {
    const auto desk = instructor({"--foxglove"});
    PageClient teacher(desk->address);
    PageClient client(desk->address, {.origin = "",
                                      .subprotocol = "foxglove.websocket.v1",
                                      .target = "/foxglove?token=" + desk->address.token});
    EXPECT_THAT(client.wait_for("serverInfo")["capabilities"], testing::ElementsAre("time"));
    EXPECT_EQ(teacher.wait_for("serverInfo")["capabilities"], json::array()) << "a page of ours";
    const auto scenes = [&] {
        std::vector<json> all;
        for (const auto& payload : client.samples("scene"))
            all.push_back(json::parse(payload));
        return all;
    };
    give(teacher, "ExerciseCommand", {{"action", "EXERCISE_START"}});
    ASSERT_TRUE(eventually([&] { return status().time() > 2; }));
    give(teacher, "ExerciseCommand", {{"action", "EXERCISE_SNAPSHOT"}});
    const double snapshot_by = status().time() + 1;
    ASSERT_TRUE(eventually([&] { return status().time() > snapshot_by + 2 && scenes().size() > 20; }));
    const auto forward = client.times();
    EXPECT_TRUE(std::ranges::is_sorted(forward));
    EXPECT_GT(forward.size(), 20U);
    EXPECT_NEAR(static_cast<double>(forward.back()) * 1e-9, status().time(), 1);
    for (const json& scene : scenes())
        EXPECT_THAT(scene["deletions"], IsEmpty());
    const auto drawn = testing::ElementsAre("water", "seabed", "ship", "port_cable", "port_anchor");
    EXPECT_THAT(ids(scenes().back()), drawn);

    give(teacher, "ExerciseCommand", {{"action", "EXERCISE_RESTORE"}, {"restore_time", snapshot_by}});
    ASSERT_TRUE(eventually([&] { return status().state() == RUN_PAUSED && status().time() < snapshot_by; }));
    json anew;
    std::uint64_t stamp = 0;
    ASSERT_TRUE(eventually([&] {
        const auto all = scenes();
        const auto found =
            std::ranges::find_if(all, [](const json& each) { return !each["deletions"].empty(); });
        if (found == all.end()) return false;
        anew = *found;
        stamp = client.stamps("scene").at(static_cast<std::size_t>(found - all.begin()));
        return true;
    }));
    const auto restored = static_cast<std::uint64_t>(std::llround(status().time() * 1e9));
    EXPECT_EQ(stamp, restored);
    EXPECT_THAT(ids(anew), drawn);
    EXPECT_EQ(anew["entities"][0]["timestamp"]["sec"], restored / 1'000'000'000);
    EXPECT_GE(anew["deletions"][0]["timestamp"]["sec"], forward.back() / 1'000'000'000);
    const auto times = client.times();
    const auto back = std::ranges::adjacent_find(times, std::greater<>());
    ASSERT_NE(back, times.end());
    EXPECT_EQ(*std::next(back), restored);
    EXPECT_TRUE(std::is_sorted(std::next(back), times.end())) << "it went back once";
    EXPECT_EQ(times.back(), restored) << "and stands with the pause";
}

} // namespace
} // namespace windlass::test
