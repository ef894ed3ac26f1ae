// Devices that stand at one seat, over the network.

#include "tests/door/door_rig.hpp"

namespace windlass::test {
using namespace rigs;

namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

class KioskAtTheDoor : public DoorWithServer {
protected:
    /// The key of an address that the owner makes.
    std::string made(const std::string& name, int exercise, const std::string& place) {
        const Answer put = owner().post(
            "/door/kiosks", {{"do", "put"}, {"name", name}, {"exercise", exercise}, {"place", place}});
        EXPECT_EQ(put.status, 200) << put.body;
        return put.json().value("key", "");
    }
    /// A device that has opened it.
    Browser device(const std::string& key, const std::string& from = "127.0.0.1") const {
        Browser one = browser(from);
        EXPECT_EQ(one.post("/door/device", {{"key", key}}).status, 200);
        return one;
    }
    std::string command(const std::string& what, const std::vector<std::string>& more, int code = 0) const {
        std::vector<std::string> words{WINDLASS_DOOR, "--state", (folder_ / "door").string(), "kiosk", what};
        words.insert(words.end(), more.begin(), more.end());
        rigs::ChildProcess program(words);
        EXPECT_EQ(program.exit_code(), code) << program.text();
        return program.text();
    }
};

TEST_F(KioskAtTheDoor, WaitsForAClassAndHasItsSeatOfEachAndOfTheNextOne) {
    const std::string key = made("forecastle 2", 2, "forecastle");
    EXPECT_EQ(key.size(), 32);
    Browser one = device(key);
    EXPECT_EQ(one.get("/").header("Location"), "/kiosk");
    EXPECT_EQ(one.get("/kiosk").status, 200);
    EXPECT_EQ(one.post("/door/sit", json::object()).json()["who"], "kiosk") << "no class";
    open_class("mon", 2, 2);
    expect_made("mon");
    const json seat = one.post("/door/sit", json::object()).json();
    EXPECT_EQ(seat["who"], "trainee");
    EXPECT_EQ(seat["exercise"], "mon-2");
    EXPECT_EQ(seat["place"], "forecastle");
    EXPECT_EQ(one.get("/").header("Location"), "/forecastle");
    const auto page = one.open("page=forecastle");
    EXPECT_TRUE(eventually([&] { return !page->samples("ForecastleView").empty(); })) << door_->text();
    EXPECT_EQ(class_told("mon")["exercises"][1]["seats"][0]["name"], "forecastle 2");
    EXPECT_EQ(one.post("/door/sit", json::object()).json()["exercise"], "mon-2") << "it sits there already";
    EXPECT_EQ(owner().post("/door/class", {{"do", "end"}, {"class", "mon"}}).status, 200);
    EXPECT_TRUE(eventually([&] { return page->closed() == 4001; }));
    EXPECT_EQ(one.get("/").header("Location"), "/kiosk");
    open_class("tue", 3, 3);
    EXPECT_EQ(one.post("/door/sit", json::object()).json()["exercise"], "tue-2");
    for (const char* what : {"kiosk.put", "kiosk.open", "kiosk.sit"})
        EXPECT_THAT(audit(), HasSubstr(what));
}

TEST_F(KioskAtTheDoor, IsKnownAfterTheDoorIsStartedAnewAndItsKeyIsKeptNowhere) {
    const std::string key = made("third", 1, "ship");
    Browser one = device(key);
    EXPECT_THAT(one.cookie, testing::StartsWith("windlass-kiosk="));
    const std::string kept = content(folder_ / "door/kiosks.json") + audit();
    EXPECT_THAT(kept, Not(HasSubstr(key)));
    EXPECT_THAT(kept, Not(HasSubstr(one.cookie.substr(one.cookie.find('=') + 1))));
    door_->signal(SIGKILL);
    EXPECT_EQ(door_->exit_code(), -1);
    door_ = open_door();
    Browser again = browser();
    again.cookie = one.cookie;
    EXPECT_EQ(again.get("/").header("Location"), "/kiosk");
    EXPECT_EQ(again.get("/door/me").json()["number"], 1);
}

TEST_F(KioskAtTheDoor, ItsAddressIsGoodOnceAndGuessersAreToldToWait) {
    const std::string key = made("third", 1, "ship");
    device(key);
    EXPECT_EQ(browser().post("/door/device", {{"key", key}}).status, 403) << "opened before";
    int waits = 0;
    Browser guesser = browser("127.0.0.2");
    for (int i = 0; i < 40; ++i)
        waits += guesser.post("/door/device", {{"key", std::to_string(i)}}).status == 429 ? 1 : 0;
    EXPECT_GT(waits, 10);
    EXPECT_THAT(audit(), HasSubstr("kiosk.failed"));
    for (const json& bad : {json(5), json(), json::array()})
        EXPECT_EQ(browser().post("/door/device", {{"key", bad}}).status, 400);
}

TEST_F(KioskAtTheDoor, IsGoodForItsSeatAndForNothingElse) {
    Browser one = device(made("third", 1, "ship"));
    for (const char* page : {"/instructor", "/classroom", "/class", "/people", "/forecastle", "/bridge"})
        EXPECT_EQ(one.get(page).header("Location"), "/") << page;
    for (const char* question : {"/door/classes", "/door/people", "/door/lessons", "/door/kiosks"})
        EXPECT_EQ(one.get(question).status, 401) << question;
    for (const char* act : {"/door/class", "/door/people", "/door/kiosks"})
        EXPECT_EQ(one.post(act, {{"do", "put"}, {"name", "x"}}).status, 401) << act;
    EXPECT_EQ(one.upgrade("page=forecastle"), 401) << "no class";
    Browser other = browser();
    EXPECT_EQ(other.post("/door/sit", json::object()).status, 401) << "no kiosk";
    other.cookie = "windlass=" + one.cookie.substr(one.cookie.find('=') + 1);
    EXPECT_EQ(other.get("/door/me").json()["who"], "nobody") << "its cookie is no session's";
    EXPECT_EQ(owner()
                  .post("/door/kiosks", {{"do", "put"}, {"name", "x"}, {"exercise", 1}, {"place", "roof"}})
                  .status,
              400);
    EXPECT_EQ(owner()
                  .post("/door/kiosks", {{"do", "put"}, {"name", "x"}, {"exercise", 0}, {"place", "ship"}})
                  .status,
              400);
}

TEST_F(KioskAtTheDoor, ASeatThatIsTakenIsToldAndHadOnceItIsFree) {
    const std::string code = open_class("mon", 1, 1);
    Browser ben = trainee(code, "ben");
    Browser one = device(made("first", 1, "ship"));
    const json waits = one.post("/door/sit", json::object()).json();
    EXPECT_EQ(waits["who"], "kiosk");
    EXPECT_EQ(waits["why"], "ben sits here");
    EXPECT_EQ(owner().post("/door/class", {{"do", "remove"}, {"class", "mon"}, {"name", "ben"}}).status, 200);
    EXPECT_EQ(one.post("/door/sit", json::object()).json()["exercise"], "mon-1");
}

// As a class that goes on from a moment is opened: of who sat in one exercise, which is its first now.
TEST_F(KioskAtTheDoor, OfAClassWhoseListHasItsNameItHasTheSeatThatTheListGivesIt) {
    Browser one = device(made("deck 3", 3, "forecastle")), other = device(made("deck 1", 1, "forecastle"));
    const Answer opened = owner().post("/door/class", {{"do", "open"},
                                                       {"class", "again"},
                                                       {"lesson", "let_go_port_25m"},
                                                       {"exercises", 1},
                                                       {"crew", 2},
                                                       {"names", json::array({"deck 3"})},
                                                       {"places", json::object({{"deck 3", "bridge"}})}});
    ASSERT_EQ(opened.status, 200) << opened.body;
    EXPECT_THAT(other.post("/door/sit", json::object()).json()["why"].get<std::string>(),
                HasSubstr("a list of names"));
    const json seat = one.post("/door/sit", json::object()).json();
    EXPECT_EQ(seat["exercise"], "again-1");
    EXPECT_EQ(seat["place"], "bridge");
    EXPECT_EQ(one.get("/").header("Location"), "/bridge");
}

TEST_F(KioskAtTheDoor, TakenBackItsDeviceIsOutAndItsSeatFree) {
    Browser one = device(made("first", 1, "ship"));
    open_class("mon", 1, 1);
    expect_made("mon");
    one.post("/door/sit", json::object());
    const auto page = one.open("page=forecastle");
    EXPECT_TRUE(eventually([&] { return !page->told("hello").empty(); }));
    EXPECT_EQ(owner().post("/door/kiosks", {{"do", "remove"}, {"name", "first"}}).status, 200);
    EXPECT_TRUE(eventually([&] { return page->closed() == 4001; }));
    EXPECT_TRUE(class_told("mon")["exercises"][0]["seats"][0]["name"].is_null());
    EXPECT_EQ(one.post("/door/sit", json::object()).status, 401);
    EXPECT_EQ(one.upgrade("page=forecastle"), 401);
    EXPECT_EQ(owner().post("/door/kiosks", {{"do", "remove"}, {"name", "first"}}).status, 404);
    EXPECT_THAT(audit(), HasSubstr("kiosk.remove"));
}

TEST_F(KioskAtTheDoor, TheCommandLineMakesListsAndTakesBackWhatTheRunningDoorHeeds) {
    open_class("mon", 2, 2);
    expect_made("mon");
    const std::string told = command("add", {"bridge 2", "--seat", "2", "--place", "bridge"});
    EXPECT_THAT(told, HasSubstr("https://localhost:8443/kiosk#key="));
    const auto at = told.find("#key=");
    Browser one = device(told.substr(at + 5, 32));
    EXPECT_EQ(one.post("/door/sit", json::object()).json()["exercise"], "mon-2");
    const auto page = one.open("page=bridge");
    EXPECT_TRUE(eventually([&] { return !page->told("hello").empty(); }));
    EXPECT_THAT(command("list", {}), HasSubstr("bridge 2: bridge of exercise 2, opened"));
    command("remove", {"bridge 2"});
    EXPECT_TRUE(eventually([&] { return page->closed() == 4001; })) << door_->text();
    EXPECT_EQ(one.get("/").status, 200) << "the page to join: it is nobody's";
    EXPECT_THAT(command("remove", {"bridge 2"}, 1), HasSubstr("there is no kiosk of that name"));
    command("add", {"x", "--seat", "65", "--place", "bridge"}, 2);
    EXPECT_THAT(audit(), HasSubstr("command line"));
}

} // namespace
} // namespace windlass::test
