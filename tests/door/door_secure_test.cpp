// The door under DDS Security: one identity of its own, behind which all seats work.

#include "tests/door/door_rig.hpp"
#include "tests/wire/identities.hpp"

#include <csignal>

namespace windlass::test {
using namespace rigs;

namespace {

using testing::HasSubstr;

class SecureDoor : public DoorRig {
protected:
    SecureDoor() {
        EXPECT_TRUE(identities_.made());
        reopen_door_as("door");
    }
    std::vector<std::string> as(const std::string& name) const {
        return {"--security", identities_.of(name)};
    }
    void reopen_door_as(const std::string& name) {
        door_->signal(SIGTERM);
        EXPECT_EQ(door_->exit_code(), 0) << door_->text();
        door_ = open_door(WINDLASS_CONFIG_DIR "/exercises", as(name));
    }
    std::unique_ptr<ServerProcess> start_server(const std::vector<std::string>& more) const {
        auto options = domain();
        options.insert(options.end(), {"--classroom", "--config-root", WINDLASS_CONFIG_DIR});
        options.insert(options.end(), more.begin(), more.end());
        return std::make_unique<ServerProcess>(std::move(options));
    }

    const Identities identities_;
};

TEST_F(SecureDoor, LeadsAClassFromItsOpeningToItsMarks) {
    const auto server = start_server(as("server"));
    const std::string code = open_class("mon", 1, 2, "L01_let_go_25m");
    const auto exercise = [this] { return class_told("mon")["exercises"][0]; };
    ASSERT_TRUE(eventually([&] { return !exercise()["state"].is_null(); })) << door_->text();
    Browser ben = trainee(code, "ben"), carla = trainee(code, "carla");
    const auto deck = ben.open("page=forecastle"), bridge = carla.open("page=bridge"),
               desk = owner().open("page=instructor&exercise=mon-1");
    EXPECT_TRUE(eventually([&] { return !deck->samples("ForecastleView").empty(); })) << door_->text();
    EXPECT_TRUE(eventually([&] { return !bridge->samples("BridgeView").empty(); }));
    EXPECT_TRUE(eventually([&] { return !desk->samples("AnchorState").empty(); }));
    EXPECT_TRUE(deck->samples("AnchorState").empty() && bridge->samples("AnchorState").empty())
        << "the door may hear it, and a seat may not";
    EXPECT_EQ(owner().post("/door/class", {{"do", "start"}, {"class", "mon"}}).status, 200);
    ASSERT_TRUE(eventually([&] { return exercise()["time"] > 1.0; })) << server->text();
    EXPECT_TRUE(eventually([&] {
        deck->say({{"op", "levers"},
                   {"side", 0},
                   {"brake", 1},
                   {"speed_lever", 0},
                   {"clutch_in", false},
                   {"stopper_closed", false},
                   {"emergency_stop", false}});
        return server->text().find("ben has the port windlass") != std::string::npos;
    })) << server->text();
    ASSERT_TRUE(eventually([&] { return door_->text().find("files attached") != std::string::npos; }))
        << "its recorder goes by the same identity: " << door_->text();
    EXPECT_EQ(owner().post("/door/class", {{"do", "end"}, {"class", "mon"}}).status, 200);
    ASSERT_TRUE(eventually([&] { return exercise()["state"].is_null(); }));
    EXPECT_EQ(exercise()["outcome"], "not_shown");
    const auto recording = exercise()["recording"].get<std::string>();
    EXPECT_THAT(owner().get("/door/debriefing?recording=" + recording).body, HasSubstr("ben"));
}

TEST_F(SecureDoor, AndAServerWithoutAnIdentityDoNotHearEachOther) {
    const auto server = start_server({});
    pace(std::chrono::seconds(5)); // an open door has heard it after one
    EXPECT_EQ(owner().get("/door/classes").json()["servers"], 0);
}

} // namespace
} // namespace windlass::test
