// Those who mean harm at the door, or do not know better: each is refused, and everybody else goes on.

#include "tests/door/door_rig.hpp"
#include "tests/door/tls_client.hpp"

#include "idl/wire.hpp"
#include "station/gateway/roles.hpp"

#include <fstream>
#include <mutex>

namespace windlass::test {
using namespace rigs;

namespace {

using nlohmann::json;
using testing::HasSubstr;

class HostileDoor : public DoorRig {
protected:
    Answer by_tls(const std::string& target) const {
        return TlsClient(door_->tls, (folder_ / "door/authority.crt").string(), "localhost").get(target);
    }
    double memory() const { // MB
        std::ifstream status("/proc/" + std::to_string(door_->pid()) + "/status");
        for (std::string word; status >> word;)
            if (word == "VmRSS:" && status >> word) return std::stod(word) / 1024;
        return 0;
    }
};

TEST_F(HostileDoor, WhoKnowsTheAuthorityIsServedByTlsAndNobodyElseIsDeceived) {
    const Answer page = by_tls("/");
    EXPECT_EQ(page.status, 200);
    EXPECT_THAT(page.body, HasSubstr("join.js"));
    EXPECT_EQ(by_tls("/authority.crt").body, content(folder_ / "door/authority.crt"));
    EXPECT_THAT(door_->text(),
                HasSubstr(by_tls("/door/me").json()["authority_fingerprint"].get<std::string>()));
    EXPECT_THROW(TlsClient(door_->tls, (folder_ / "door/authority.crt").string(), "elsewhere.example"),
                 std::runtime_error);
}

TEST_F(HostileDoor, APortThatIsTakenIsToldAndTheDoorEnds) {
    std::vector<std::string> command{WINDLASS_DOOR,
                                     "--port",
                                     std::to_string(door_->tls),
                                     "--state",
                                     (folder_ / "second").string(),
                                     "--exercises",
                                     WINDLASS_CONFIG_DIR "/exercises"};
    const auto more = domain();
    command.insert(command.end(), more.begin(), more.end());
    rigs::ChildProcess second(std::move(command));
    EXPECT_EQ(second.exit_code(), 1);
    EXPECT_THAT(second.text(), HasSubstr("cannot serve pages at 0.0.0.0:" + std::to_string(door_->tls)));
}

TEST_F(HostileDoor, PlainHttpOnlyLeadsToTls) {
    const Plain connection(door_->redirect);
    connection.say("GET /?code=ABCDEF HTTP/1.1\r\nHost: classroom.local:80\r\nConnection: close\r\n\r\n");
    const Answer led = answer_of(connection.answer());
    EXPECT_EQ(led.status, 308);
    EXPECT_EQ(led.header("Location"),
              "https://classroom.local:" + std::to_string(door_->tls) + "/?code=ABCDEF");
    const Plain split(door_->redirect);
    split.say("GET / HTTP/1.1\r\nHost: a b\"<script>\r\nConnection: close\r\n\r\n");
    EXPECT_EQ(answer_of(split.answer()).status, 400);
    const Plain upgrade(door_->redirect);
    upgrade.say("GET /ws HTTP/1.1\r\nHost: localhost\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
                "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n");
    char first[13] = {};
    EXPECT_EQ(recv(upgrade.descriptor(), first, 12, MSG_WAITALL), 12);
    EXPECT_STREQ(first, "HTTP/1.1 308");
}

TEST_F(HostileDoor, PlainHttpOnLoopbackAnswersToLoopbacksNamesAlone) {
    Browser rebound = browser();
    const Plain connection(door_->loopback);
    connection.say("GET / HTTP/1.1\r\nHost: evil.example:" + std::to_string(door_->loopback) +
                   "\r\nConnection: close\r\n\r\n");
    EXPECT_EQ(answer_of(connection.answer()).status, 421) << "a name that was bound to 127.0.0.1 elsewhere";
    EXPECT_EQ(rebound.get("/").status, 200);
}

TEST_F(HostileDoor, AThousandHandshakesThatAreNeverEndedShutNobodyOut) {
    const double before = memory();
    std::vector<std::unique_ptr<Plain>> many;
    for (int i = 0; i < 1000; ++i) {
        many.push_back(std::make_unique<Plain>(door_->tls, i % 2 == 0 ? "127.0.0.2" : "127.0.0.3"));
        ASSERT_TRUE(many.back()->connected) << i;
        if (i % 3 == 0) many.back()->say("\x16\x03\x01"); // the beginning of a greeting
    }
    EXPECT_TRUE(eventually([&] { return door_->text().find("too many connections") != std::string::npos; }));
    for (int i = 0; i < 20; ++i)
        EXPECT_EQ(by_tls("/").status, 200) << i;
    EXPECT_LT(memory() - before, 64); // MB
}

TEST_F(HostileDoor, GarbageEndsItsOwnConnectionAndNoOther) {
    const std::string garbage[] = {std::string(1000, '\0'), "GET / HTTP/1.1\r\nHost: localhost\r\n\r\n",
                                   std::string("\x16\x03\x03\xFF\xFF", 5) + std::string(70'000, 'x'),
                                   std::string("\x80\x2E\x01\x00\x02", 5)};
    for (const std::string& bytes : garbage) {
        const Plain connection(door_->tls);
        connection.say(bytes);
        shutdown(connection.descriptor(), SHUT_WR);
        connection.answer(); // comes to its end
        EXPECT_EQ(by_tls("/").status, 200);
    }
    for (const unsigned short port : {door_->redirect, door_->loopback}) {
        const Plain connection(port);
        connection.say("\x16\x03\x01\x02 no HTTP at all\r\n\r\n");
        EXPECT_EQ(answer_of(connection.answer()).status, 0);
    }
    EXPECT_EQ(by_tls("/").status, 200);
}

TEST_F(HostileDoor, ABodyThatIsTooLongIsRefusedAndOneThatNeverEndsHoldsNobodyUp) {
    EXPECT_EQ(browser().ask("POST", "/door/join", std::string(9000, 'x')).status, 413);
    const Plain endless(door_->loopback);
    endless.say("POST /door/join HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(door_->loopback) +
                "\r\nOrigin: http://127.0.0.1:" + std::to_string(door_->loopback) +
                "\r\nContent-Length: 100\r\n\r\n{");
    EXPECT_EQ(browser().get("/").status, 200);
    for (const char* body : {"", "null", "[]", "{", "\"x\"", "{\"code\":5,\"name\":{}}", "{\"code\":null}"})
        EXPECT_EQ(browser().ask("POST", "/door/join", body).status, 400) << body;
    const std::string deep = std::string(2000, '[') + std::string(2000, ']');
    EXPECT_EQ(browser().ask("POST", "/door/join", deep).status, 400);
    for (const char* method : {"PUT", "DELETE", "OPTIONS", "TRACE"})
        EXPECT_EQ(browser().ask(method, "/door/join", "").status, 405) << method;
    EXPECT_EQ(browser().post("/door/nonsense", json::object()).status, 401) << "a stranger learns nothing";
    EXPECT_EQ(owner().post("/door/nonsense", json::object()).status, 404);
}

TEST_F(HostileDoor, AStrangerGetsThePagesOfTheDoorAndNothingElse) {
    Browser stranger = browser();
    for (const char* page : {"/join", "/kiosk", "/login", "/setup", "/trust", "/licences.txt"})
        EXPECT_EQ(stranger.get(page).status, 200) << page;
    for (const char* page : {"/instructor", "/classroom", "/lessons", "/forecastle", "/bridge", "/watch",
                             "/class", "/people", "/replay"})
        EXPECT_EQ(stranger.get(page).header("Location"), "/") << page;
    for (const char* none : {"/door/../../etc/passwd", "/people.json", "/authority.key", "/door.key",
                             "/audit.jsonl", "/%2e%2e/door.key", "/debrief-00000000000000000000000000000000"})
        EXPECT_EQ(stranger.get(none).status, std::string(none).starts_with("/door/") ? 401 : 404) << none;
    for (const char* question : {"/door/classes", "/door/people", "/door/lessons"})
        EXPECT_EQ(stranger.get(question).status, 401) << question;
    for (const char* act : {"/door/class", "/door/people"})
        EXPECT_EQ(stranger.post(act, {{"do", "open"}}).status, 401) << act;
    EXPECT_EQ(stranger.upgrade("exercise=none"), 401);
    EXPECT_EQ(stranger.upgrade("exercise=none&page=forecastle"), 401);
    stranger.cookie = "windlass=" + std::string(64, '0');
    EXPECT_EQ(stranger.upgrade("exercise=none"), 401);
}

class TraineeAtTheDoor : public DoorWithServer {
protected:
    void SetUp() override {
        code_ = open_class("mon", 2, 3);
        expect_made("mon");
    }
    std::string code_;
};

/// Names of topics, without the classroom's.
std::set<std::string> names(const gateway::Topics& topics) {
    std::set<std::string> found;
    for (const auto* topic : topics)
        found.insert(topic->name);
    return found;
}

TEST_F(TraineeAtTheDoor, HearsAndOrdersWhatItsSeatMayAndNothingOfAnyOther) {
    using station::Seat;
    const std::pair<const char*, Seat> seats[] = {
        {"forecastle", Seat::forecastle}, {"bridge", Seat::conning}, {"watch", Seat::watcher}};
    for (const auto& [place, seat] : seats) {
        Browser one = trainee(code_, place);
        ASSERT_EQ(one.get("/door/me").json()["place"], place);
        const gateway::Role role = gateway::role_of(seat, "mon-1");
        const auto page = one.open("page=" + role.pages.front());
        ASSERT_TRUE(eventually([&] { return !page->channels().empty(); }));
        std::set<std::string> heard;
        for (const auto& [number, name] : page->channels())
            heard.insert(name);
        auto may = names(role.hears);
        may.merge(names(role.classroom_hears));
        EXPECT_EQ(heard, may) << place;
        const auto writes = names(role.writes);
        int id = 0;
        for (const wire::TopicInfo& topic : wire::topics::all) {
            if (writes.contains(topic.name)) continue;
            page->say({{"op", "order"}, {"id", ++id}, {"topic", topic.name}, {"sample", json::object()}});
            EXPECT_FALSE(page->wait_for("refused", {{"id", id}}).is_null())
                << place << " ordered " << topic.name;
        }
        page->say({{"op", "order"}, {"id", ++id}, {"topic", "ClassroomCommand"}, {"sample", json::object()}});
        EXPECT_FALSE(page->wait_for("refused", {{"id", id}}).is_null());
        for (const char* op : {"record", "continue_live", "read_recording", "debrief", "replay",
                               "watch_classroom", "camera"}) {
            page->say({{"op", op},
                       {"id", ++id},
                       {"on", true},
                       {"recording", "x"},
                       {"position", 0},
                       {"since", 0},
                       {"exercise", "mon-1"}});
            EXPECT_FALSE(page->wait_for("refused", {{"id", id}}).is_null()) << place << " did " << op;
        }
        for (const char* elsewhere : {"mon-2", "none", "replay-mon", "second"})
            EXPECT_EQ(one.upgrade("page=" + role.pages.front() + "&exercise=" + elsewhere), 403) << elsewhere;
        for (const char* others : {"instructor", "classroom", "lessons", "class", "people"}) {
            EXPECT_EQ(one.upgrade(std::string("page=") + others), 409) << others;
            EXPECT_EQ(one.get(std::string("/") + others).header("Location"), "/") << others;
        }
        EXPECT_EQ(one.get("/door/classes").status, 403);
        EXPECT_EQ(one.post("/door/class", {{"do", "end"}, {"class", "mon"}}).status, 403);
        EXPECT_EQ(one.post("/door/people", {{"do", "remove"}, {"name", "anna"}}).status, 403);
    }
}

TEST_F(TraineeAtTheDoor, OneSeatIsNotOpenInTwoPlaces) {
    Browser ben = trainee(code_, "ben", "127.0.0.2");
    const std::string cookie = ben.cookie;
    Browser first = browser(), thief = browser("127.0.0.3");
    first.cookie = thief.cookie = cookie;
    auto page = first.open("page=forecastle");
    ASSERT_TRUE(eventually([&] { return !page->told("hello").empty(); }));
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(thief.upgrade("page=forecastle"), 423)
            << "a stolen cookie, elsewhere, while its owner is at work";
    EXPECT_EQ(audit().find("seat.refused"), audit().rfind("seat.refused")) << "it tries again and again";
    EXPECT_THAT(audit(), HasSubstr("seat.refused"));
    EXPECT_FALSE(page->closed());
    std::vector<std::unique_ptr<PageClient>> more;
    int refused = 0;
    for (int i = 0; i < 10; ++i) {
        try {
            more.push_back(first.open("page=forecastle"));
            EXPECT_TRUE(eventually([&] { return !more.back()->told("hello").empty(); }));
        } catch (const std::runtime_error&) {
            ++refused;
        }
    }
    EXPECT_EQ(refused, 5) << "six pages at a time";
    EXPECT_EQ(owner().post("/door/class", {{"do", "remove"}, {"class", "mon"}, {"name", "ben"}}).status, 200);
    EXPECT_TRUE(eventually([&] { return page->closed() == 4001; }));
    EXPECT_EQ(first.upgrade("page=forecastle"), 401) << "the cookie of a seat that was freed";
}

TEST_F(TraineeAtTheDoor, WhoIsMovedIsSentToTheOtherSeat) {
    Browser ben = trainee(code_, "ben");
    auto page = ben.open("page=forecastle");
    ASSERT_TRUE(eventually([&] { return !page->told("hello").empty(); }));
    EXPECT_EQ(page->told("hello").front()["exercise"], "mon-1");
    EXPECT_EQ(page->told("hello").front()["name"], "ben");
    EXPECT_EQ(owner()
                  .post("/door/class", {{"do", "move"},
                                        {"class", "mon"},
                                        {"name", "ben"},
                                        {"exercise", "mon-2"},
                                        {"place", "bridge"}})
                  .status,
              200);
    EXPECT_TRUE(eventually([&] { return page->closed() == 4001; }));
    EXPECT_EQ(ben.upgrade("page=forecastle"), 409);
    EXPECT_EQ(ben.get("/").header("Location"), "/bridge");
    page = ben.open("page=bridge");
    ASSERT_TRUE(eventually([&] { return !page->told("hello").empty(); }));
    EXPECT_EQ(page->told("hello").front()["exercise"], "mon-2");
    EXPECT_EQ(page->told("hello").front()["seat"], "conning");
}

TEST_F(TraineeAtTheDoor, AFloodEndsItsOwnSessionAndNoOther) {
    Browser ben = trainee(code_, "ben"), carl = trainee(code_, "carl");
    auto flood = ben.open("page=forecastle");
    auto other = carl.open("page=bridge");
    ASSERT_TRUE(eventually([&] { return !flood->told("hello").empty() && !other->told("hello").empty(); }));
    for (int i = 0; i < 2000; ++i)
        flood->say({{"op", "let_go_levers"}, {"side", 0}});
    EXPECT_TRUE(eventually([&] { return flood->closed() == 1008; }));
    auto binary = ben.open("page=forecastle");
    binary->say(std::string("\x01\x02", 2), false);
    EXPECT_TRUE(eventually([&] { return binary->closed() == 1003; }));
    auto large = ben.open("page=forecastle");
    large->say("\"" + std::string(16 * 1024, 'x') + "\"", true);
    EXPECT_TRUE(eventually([&] { return large->closed() == 1009; }));
    EXPECT_FALSE(other->closed());
}

TEST_F(TraineeAtTheDoor, WhoseNetworkIsGoneInALetGoLeavesTheLeversAsAHandDoesAndComesBackToThem) {
    Browser ben = trainee(code_, "ben");
    EXPECT_EQ(owner().post("/door/class", {{"do", "start"}, {"class", "mon"}}).status, 200);
    wire::Participant watcher{{own_domain(), wire::exercise_partition("mon-1"), "watcher"}};
    std::mutex mutex;
    WindlassLoad load;
    const wire::Reader<WindlassLoad> reader{watcher, wire::topics::windlass_load,
                                            [&](const WindlassLoad& heard) {
                                                const std::lock_guard lock(mutex);
                                                load = heard;
                                            }};
    const auto now = [&] {
        const std::lock_guard lock(mutex);
        return load;
    };
    const auto set = [](PageClient& page, double brake, double speed_lever) {
        page.say({{"op", "levers"},
                  {"side", 0},
                  {"brake", brake},
                  {"speed_lever", speed_lever},
                  {"clutch_in", false},
                  {"stopper_closed", false},
                  {"emergency_stop", false}});
    };
    auto page = ben.open("page=forecastle");
    EXPECT_TRUE(eventually([&] { // says it again and again, as a page does
        set(*page, 0.5, 0.25);
        pace(std::chrono::milliseconds(50));
        return now().cable_speed() > 0.5 && now().speed_lever() == 0.25;
    })) << door_->text();
    page->vanish();
    EXPECT_TRUE(eventually([&] { return now().speed_lever() == 0; })) << "the lever springs back";
    EXPECT_EQ(now().brake_position(), 0.5) << "nothing moves a hand-wheel but a hand";
    EXPECT_GT(now().cable_speed(), 0.1) << "and so the cable runs on";
    // A tablet may come back with another address, before the door knows that it was gone (20 s).
    Browser moved = browser("127.0.0.5");
    moved.cookie = ben.cookie;
    const auto answered = [&] { return moved.get("/ws?page=forecastle").status; };
    EXPECT_EQ(answered(), 423) << "not yet: it tries again";
    auto again = ben.open("page=forecastle");
    EXPECT_TRUE(eventually([&] {
        set(*again, 1, 0);
        pace(std::chrono::milliseconds(50));
        return now().brake_position() == 1 && now().cable_speed() < 0.01;
    })) << "the hand is back, and stops the cable";
    again->vanish();
    EXPECT_TRUE(eventually([&] { return answered() == 400; })) << "only that this is no WebSocket";
}

TEST_F(TraineeAtTheDoor, AClassIsStartedTogetherAndGoesOnWithoutTheDoor) {
    Browser ben = trainee(code_, "ben"), carl = trainee(code_, "carl");
    EXPECT_EQ(owner()
                  .post("/door/class", {{"do", "move"},
                                        {"class", "mon"},
                                        {"name", "carl"},
                                        {"exercise", "mon-2"},
                                        {"place", "forecastle"}})
                  .status,
              200);
    EXPECT_EQ(owner().post("/door/class", {{"do", "start"}, {"class", "mon"}}).status, 200);
    const auto all = [&](int state) {
        const auto told = class_told("mon");
        return std::ranges::all_of(told["exercises"], [&](const auto& e) { return e["state"] == state; });
    };
    EXPECT_TRUE(eventually([&] { return all(RUN_RUNNING); })) << class_told("mon");
    // The exercises are the server's: killed, the door takes none along.
    wire::Participant watcher{{own_domain(), wire::exercise_partition("mon-1"), "watcher"}};
    std::atomic<double> time = 0;
    const wire::Reader<ExerciseStatus> reader{watcher, wire::topics::exercise_status,
                                              [&](const ExerciseStatus& status) { time = status.time(); }};
    EXPECT_TRUE(eventually([&] { return time > 0; }));
    door_->signal(SIGKILL);
    EXPECT_EQ(door_->exit_code(), -1);
    const double then = time;
    EXPECT_TRUE(eventually([&] { return time > then + 1; }));
    door_ = open_door();
    Browser again = browser();
    again.cookie = ben.cookie;
    auto page = again.open("page=forecastle");
    EXPECT_TRUE(eventually([&] { return !page->samples("ForecastleView").empty(); })) << door_->text();
    owner_.emplace(door_->loopback);
    EXPECT_EQ(owner_->post("/door/login", {{"name", "anna"}, {"password", kPassword}}).status, 200);
    EXPECT_EQ(owner_->post("/door/class", {{"do", "pause"}, {"class", "mon"}}).status, 200);
    EXPECT_TRUE(eventually([&] { return all(RUN_PAUSED); }));
    EXPECT_EQ(owner_->post("/door/class", {{"do", "end"}, {"class", "mon"}}).status, 200);
    EXPECT_TRUE(eventually([&] { return page->closed() == 4002; }));
    EXPECT_TRUE(eventually([&] { // and the exercises are gone
        const double last = time;
        pace(std::chrono::milliseconds(200));
        return last == time;
    }));
}

TEST_F(TraineeAtTheDoor, AFaultAndWordsGoToAllExercisesOfAClassAndNothingElseDoes) {
    std::vector<std::unique_ptr<PageClient>> desks;
    for (const char* exercise : {"mon-1", "mon-2"})
        desks.push_back(owner().open(std::string("page=instructor&exercise=") + exercise));
    const auto give = [&](const json& topic, const json& sample) {
        return owner()
            .post("/door/class", {{"do", "give"}, {"class", "mon"}, {"topic", topic}, {"sample", sample}})
            .status;
    };
    const json fault{{"code", "FAULT_LOAD_CELL_DEAD"}, {"severity", 1.0}, {"trigger", "TRIGGER_NOW"}};
    EXPECT_EQ(give("FaultCommand", fault), 200);
    EXPECT_EQ(
        give("BridgeOrderCommand", {{"code", "BRIDGE_ORDER_TEXT"}, {"side", -1}, {"text", "mind the lead"}}),
        200);
    for (const auto& desk : desks) {
        EXPECT_TRUE(eventually([&] {
            const auto said = desk->all<BridgeOrder>("BridgeOrder");
            return std::ranges::any_of(
                said, [](const BridgeOrder& order) { return order.text().to_string() == "mind the lead"; });
        })) << door_->text();
        EXPECT_TRUE(eventually([&] {
            const auto truths = desk->all<ExerciseTruth>("ExerciseTruth");
            return !truths.empty() && !truths.back().faults().empty() &&
                   truths.back().faults()[0].code() == FAULT_LOAD_CELL_DEAD;
        }));
    }
    EXPECT_EQ(give("FaultCommand", {{"code", "FAULT_NO_SUCH"}}), 400);
    EXPECT_EQ(give("FaultCommand", {{"code", "FAULT_LOAD_CELL_DEAD"}, {"severity", "much"}}), 400);
    EXPECT_EQ(give("FaultCommand", "all of them"), 400);
    for (const char* topic : {"ExerciseCommand", "WindlassCommand", "AssessmentCommand", "Nothing"})
        EXPECT_EQ(give(topic, {{"action", "EXERCISE_STOP"}}), 400) << topic;
    EXPECT_THAT(audit(), HasSubstr("mind the lead"));
}

TEST_F(TraineeAtTheDoor, WhoDoesNothingIsSilentUntilTheHandDoesSomething) {
    Browser ben = trainee(code_, "ben");
    const auto silent = [&] {
        const auto told = class_told("mon");
        return told["exercises"][0]["seats"][0]["silent"];
    };
    EXPECT_TRUE(silent().is_null()) << "nobody is there";
    EXPECT_EQ(owner().post("/door/class", {{"do", "start"}, {"class", "mon"}}).status, 200);
    const auto page = ben.open("page=forecastle");
    const auto hold = [&](double brake) {
        page->say({{"op", "levers"},
                   {"side", 0},
                   {"brake", brake},
                   {"speed_lever", 0},
                   {"clutch_in", false},
                   {"stopper_closed", true},
                   {"emergency_stop", false}});
    };
    hold(0.8);
    EXPECT_TRUE(eventually([&] {
        hold(0.8); // a hand that only holds says so again and again
        const json now = silent();
        return now.is_number() && now >= 2;
    })) << silent();
    hold(0.7);
    EXPECT_TRUE(eventually([&] { return silent() < 2; })) << silent();
    EXPECT_TRUE(eventually([&] { return silent() >= 2; })) << silent();
    page->say(
        {{"op", "order"}, {"id", 1}, {"topic", "Report"}, {"sample", {{"code", "REPORT_STANDING_BY"}}}});
    EXPECT_FALSE(page->wait_for("sent", {{"id", 1}}).is_null());
    EXPECT_TRUE(eventually([&] { return silent() < 2; })) << silent();
}

TEST_F(TraineeAtTheDoor, AnObserverSeesTheTruthAndGivesNoOrders) {
    EXPECT_EQ(owner()
                  .post("/door/people",
                        {{"do", "put"}, {"name", "otto"}, {"rank", "observer"}, {"password", kPassword}})
                  .status,
              200);
    Browser otto = browser();
    EXPECT_EQ(otto.post("/door/login", {{"name", "otto"}, {"password", kPassword}}).status, 200);
    const auto page = otto.open("page=instructor&exercise=mon-1");
    EXPECT_TRUE(eventually([&] { return !page->samples("ExerciseTruth").empty(); }));
    int id = 0;
    for (const wire::TopicInfo& topic : wire::topics::all) {
        page->say({{"op", "order"}, {"id", ++id}, {"topic", topic.name}, {"sample", json::object()}});
        EXPECT_FALSE(page->wait_for("refused", {{"id", id}}).is_null()) << topic.name;
    }
    EXPECT_EQ(otto.post("/door/class", {{"do", "start"}, {"class", "mon"}}).status, 403);
    EXPECT_EQ(owner().post("/door/people", {{"do", "remove"}, {"name", "otto"}}).status, 200);
    EXPECT_TRUE(eventually([&] { return page->closed() == 4001; })) << "and hears no more";
    EXPECT_EQ(otto.upgrade("page=instructor&exercise=mon-1"), 401);
}

} // namespace
} // namespace windlass::test
