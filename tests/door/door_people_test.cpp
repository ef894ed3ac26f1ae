// Who is let in at the door, over the network.

#include "tests/door/door_rig.hpp"

namespace windlass::test {
using namespace rigs;

namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

using Door = DoorRig;

TEST_F(Door, TheFirstOwnerIsSetUpOnceByTheLinkThatIsPrinted) {
    Browser mallory = browser();
    EXPECT_EQ(
        mallory.post("/door/setup", {{"token", "guess"}, {"name", "m"}, {"password", kPassword}}).status,
        403);
    const json good{{"token", door_->setup}, {"name", "anna"}, {"password", kPassword}};
    json weak = good;
    weak["password"] = "short";
    EXPECT_EQ(mallory.post("/door/setup", weak).status, 400);
    EXPECT_EQ(owner().get("/door/me").json()["rank"], "owner");
    EXPECT_EQ(mallory.post("/door/setup", good).status, 403) << "it is good once";
    EXPECT_EQ(mallory.get("/door/me").json()["who"], "nobody");
    EXPECT_THAT(content(folder_ / "door/people.json"), HasSubstr("$argon2id$"));
    EXPECT_THAT(content(folder_ / "door/people.json") + audit() + door_->text(), Not(HasSubstr(kPassword)));
}

TEST_F(Door, APasswordThatIsGuessedIsToldToWaitAndItsOwnerIsNotKeptOut) {
    owner();
    Browser mallory = browser("127.0.0.2");
    int waits = 0;
    for (int i = 0; i < 40; ++i)
        waits += mallory.post("/door/login", {{"name", "anna"}, {"password", "guess " + std::to_string(i)}})
                             .status == 429
                     ? 1
                     : 0;
    EXPECT_GT(waits, 10);
    EXPECT_EQ(mallory.post("/door/login", {{"name", "anna"}, {"password", kPassword}}).status, 429)
        << "who guesses does not come to know which one was right";
    Browser anna = browser("127.0.0.3");
    EXPECT_EQ(anna.post("/door/login", {{"name", "anna"}, {"password", kPassword}}).status, 200);
    EXPECT_THAT(audit(), HasSubstr("login.failed"));
}

TEST_F(Door, ACookieIsHiddenFromPagesAndOfOneSite) {
    Browser anna = browser();
    const Answer set =
        anna.post("/door/setup", {{"token", door_->setup}, {"name", "anna"}, {"password", kPassword}});
    for (const char* word : {"HttpOnly", "SameSite=Strict", "Path=/"})
        EXPECT_THAT(set.header("Set-Cookie"), HasSubstr(word));
    EXPECT_THAT(audit() + content(folder_ / "door/people.json"), Not(HasSubstr(anna.cookie.substr(9))));
    EXPECT_EQ(anna.post("/door/logout", json::object()).status, 200);
    EXPECT_EQ(anna.get("/door/me").json()["who"], "nobody");
}

TEST_F(Door, TheIconIsAnybodysAlsoByTheNameThatBrowsersAskForByThemselves) {
    const Answer icon = browser().get("/favicon.ico");
    EXPECT_EQ(icon.status, 200);
    EXPECT_EQ(icon.header("Content-Type"), "image/svg+xml");
    EXPECT_THAT(icon.header("Content-Security-Policy"), HasSubstr("default-src 'self'"));
    EXPECT_EQ(icon.body, browser().get("/favicon.svg").body);
}

TEST_F(Door, AStolenCookieOfStaffIsOfNoUseElsewhere) {
    Browser thief = browser("127.0.0.2");
    thief.cookie = owner().cookie;
    EXPECT_EQ(thief.get("/door/me").json()["who"], "nobody");
    EXPECT_EQ(thief.get("/door/classes").status, 401);
    EXPECT_EQ(thief.upgrade("exercise=none"), 401);
    EXPECT_EQ(owner().get("/door/me").json()["who"], "staff");
}

TEST_F(Door, AnotherSitesPageMayAskNothingInSomebodysName) {
    const std::string foreign = "Origin: http://evil.example\r\n";
    EXPECT_EQ(owner().upgrade("exercise=none", foreign), 403);
    EXPECT_EQ(owner().ask("GET", "/door/classes", "", foreign + "Connection: close\r\n").status, 403);
    const Plain post(door_->loopback);
    const std::string body = R"({"do":"open","class":"x","lesson":"L01","exercises":1,"crew":1})";
    post.say("POST /door/class HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(door_->loopback) +
             "\r\nConnection: close\r\nCookie: " + owner().cookie +
             "\r\nContent-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body);
    EXPECT_EQ(answer_of(post.answer()).status, 403) << "no Origin at all";
    EXPECT_THAT(owner().get("/door/classes").json()["classes"], testing::IsEmpty());
}

TEST_F(Door, ACodeTriedTenThousandTimesIsToldToWaitAndKeepsNobodyElseOut) {
    const std::string code = open_class("mon", 2, 1);
    Browser mallory = browser("127.0.0.2");
    int judged = 0;
    for (int i = 0; i < 10'000; ++i) {
        const int status =
            mallory.post("/door/join", {{"code", "AAAAA" + std::to_string(i)}, {"name", "m"}}).status;
        ASSERT_TRUE(status == 403 || status == 429) << status;
        judged += status == 403 ? 1 : 0;
    }
    // 20 at once and one each 3 s: 24^6 codes are not gone through in a day by whoever is slowed to that.
    EXPECT_LT(judged, 1000);
    EXPECT_EQ(trainee(code, "ben", "127.0.0.3").get("/door/me").json()["who"], "trainee");
}

TEST_F(Door, ASeatIsOneBrowsersAndComesBackToItAfterAReload) {
    const std::string code = open_class("mon", 1, 2);
    Browser ben = trainee(code, "ben");
    EXPECT_EQ(ben.get("/door/me").json()["place"], "forecastle");
    EXPECT_EQ(ben.get("/").header("Location"), "/forecastle");
    Browser other = browser();
    const Answer refused = other.post("/door/join", {{"code", code}, {"name", "ben"}});
    EXPECT_EQ(refused.status, 409);
    EXPECT_THAT(refused.body, HasSubstr("another browser"));
    EXPECT_EQ(ben.post("/door/join", {{"code", code}, {"name", "ben"}}).json()["place"], "forecastle");
    EXPECT_EQ(class_told("mon")["exercises"][0]["seats"][0]["name"], "ben");
    EXPECT_EQ(owner().post("/door/class", {{"do", "remove"}, {"class", "mon"}, {"name", "ben"}}).status, 200);
    EXPECT_EQ(ben.get("/door/me").json()["who"], "nobody");
    EXPECT_EQ(other.post("/door/join", {{"code", code}, {"name", "ben"}}).status, 200) << "freed";
    EXPECT_THAT(audit(), HasSubstr("class.remove"));
}

TEST_F(Door, AClassWithAListOffersItsNamesToWhoHasItsCodeAndLetsNobodyElseIn) {
    const auto open = [&](const json& names) {
        return owner().post("/door/class", {{"do", "open"},
                                            {"class", "mon"},
                                            {"lesson", "let_go_port_25m"},
                                            {"exercises", 2},
                                            {"crew", 1},
                                            {"names", names}});
    };
    for (const json& wrong :
         {json("ben"), json{1, 2}, json{"ben", ""}, json{"ben", "ben"}, json{"a", "b", "c"}})
        EXPECT_EQ(open(wrong).status, 400) << wrong;
    EXPECT_EQ(open({"anna", "ben"}).status, 409) << "the owner is called so";
    EXPECT_EQ(open({"ben", "carla"}).status, 200);
    const std::string code = class_told("mon")["code"];
    Browser one = browser(), other = browser();
    const auto offered = [&] { return other.post("/door/names", {{"code", code}}).json()["names"]; };
    EXPECT_EQ(offered(), json({"ben", "carla"}));
    EXPECT_EQ(one.post("/door/join", {{"code", code}, {"name", "dora"}}).status, 403);
    EXPECT_EQ(one.post("/door/join", {{"code", code}, {"name", "ben"}}).status, 200);
    EXPECT_EQ(offered(), json({"carla"}));
    EXPECT_EQ(other.post("/door/names", {{"code", "ABCDEF"}}).status, 403);
    const std::string anybodys = open_class("tue", 1, 1);
    EXPECT_TRUE(other.post("/door/names", {{"code", anybodys}}).json()["names"].is_null());
}

TEST_F(Door, NobodyTakesANameThatIsAnInstructors) {
    const std::string code = open_class("mon", 1, 1);
    for (const char* name : {"anna", "server", "door", "", "a\nb"})
        EXPECT_NE(browser().post("/door/join", {{"code", code}, {"name", name}}).status, 200) << name;
}

TEST_F(Door, SeatsOutliveTheDoor) {
    const std::string code = open_class("mon", 1, 1);
    Browser ben = trainee(code, "ben");
    door_->signal(SIGKILL);
    EXPECT_EQ(door_->exit_code(), -1);
    door_ = open_door();
    EXPECT_EQ(door_->setup, "") << "there is an owner";
    Browser again = browser();
    again.cookie = ben.cookie;
    EXPECT_EQ(again.get("/door/me").json()["name"], "ben");
    again.cookie = owner_->cookie;
    EXPECT_EQ(again.get("/door/me").json()["who"], "nobody") << "staff log in again";
}

TEST_F(Door, RanksDoWhatIsTheirs) {
    const auto put = [&](const char* name, const char* rank) {
        return owner()
            .post("/door/people", {{"do", "put"}, {"name", name}, {"rank", rank}, {"password", kPassword}})
            .status;
    };
    const json open{{"do", "open"}, {"class", "x"}, {"lesson", "L01"}, {"exercises", 1}, {"crew", 1}};
    const json more{{"do", "put"}, {"name", "z"}, {"rank", "owner"}, {"password", kPassword}};
    for (const char* rank : {"observer", "assessor", "instructor"}) {
        EXPECT_EQ(put(rank, rank), 200);
        Browser one = browser();
        EXPECT_EQ(one.post("/door/login", {{"name", rank}, {"password", kPassword}}).status, 200);
        EXPECT_EQ(one.post("/door/class", open).status, rank == std::string("instructor") ? 200 : 403)
            << rank;
        EXPECT_EQ(one.post("/door/people", more).status, 403) << rank;
        EXPECT_EQ(one.get("/door/people").status, 404) << rank;
        EXPECT_EQ(one.get("/door/classes").status, 200) << rank;
    }
    EXPECT_EQ(put("king", "king"), 400);
    EXPECT_EQ(owner().post("/door/people", {{"do", "remove"}, {"name", "anna"}}).status, 409)
        << "one owner remains";
}

} // namespace
} // namespace windlass::test
