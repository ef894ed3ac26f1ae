// Lessons that a learning system starts, over the network: door, server and a small learning system.

#include "door/cmi5/http_client.hpp"
#include "recorder/recording/sha256.hpp"
#include "tests/door/door_rig.hpp"
#include "tests/door/learning_system.hpp"

#include <csignal>

namespace windlass::test {
using namespace rigs;

namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// Two lessons of some seconds: one is achieved by a word, and over without it when its time is up.
constexpr const char* kShort = R"({
  "from": "let_go_port_25m", "name": "short", "title": "A word",
  "lesson": {
    "id": "S1", "title": "Say that you stand by", "briefing": "Say that you stand by the port anchor.", "pass": 70,
    "objectives": [{ "id": "words", "text": "Says what is so", "stcw": "A-II/5 orders" }],
    "moments": { "said": { "report": "standing_by" } },
    "criteria": [{ "id": "said", "kind": "final", "that": { "moment": "said" }, "weight": 10, "must": true,
                   "objective": "words", "why": "The bridge waits for it" }],
    "end": { "good": { "moment": "said", "since": 1 }, "time": 8 }
  }
})";

class Launched : public DoorRig {
protected:
    Launched() { door_ = open(); }

    std::unique_ptr<DoorProcess> open() const {
        return open_door(config() + "/exercises", {"--learning-system", there_.origin()});
    }
    std::string config() const {
        const auto folder = folder_ / "config";
        if (!std::filesystem::exists(folder)) {
            std::filesystem::copy(WINDLASS_CONFIG_DIR, folder, std::filesystem::copy_options::recursive);
            put(folder / "exercises/short.json", kShort);
        }
        return folder.string();
    }
    static Answer launch(Browser& by, json parameters, const std::string& lesson = "short") {
        parameters["lesson"] = lesson;
        return by.post("/door/launch", parameters);
    }
    static json session(Browser& of) { return of.get("/door/me").json().value("launch", json()); }
    bool said(const std::vector<std::string>& verbs) const {
        return eventually([&] { return there_.verbs() == verbs; });
    }
    void next_session(const std::string& id) {
        there_.launch_data["contextTemplate"]["extensions"][LearningSystem::kSession] = id;
    }

    LearningSystem there_;
};

class LaunchedWithServer : public Launched {
protected:
    /// The learner enters, and says the word or not, until the lesson is over.
    void play(Browser& learner, bool well) {
        const auto page = learner.open("page=forecastle");
        EXPECT_TRUE(eventually([&] { return !page->samples("ForecastleView").empty(); })) << door_->text();
        if (well) {
            EXPECT_TRUE(eventually([&] {
                const auto heard = page->all<ExerciseStatus>("ExerciseStatus");
                return !heard.empty() && heard.back().state() == RUN_RUNNING;
            })) << "it is started once the learner is there: "
                << door_->text();
            page->say(json{{"op", "order"},
                           {"id", 1},
                           {"topic", "Report"},
                           {"sample", {{"code", "REPORT_STANDING_BY"}}}});
        }
        EXPECT_TRUE(eventually([&] { return !page->samples("SeatAssessment").empty(); })) << door_->text();
        EXPECT_EQ(learner.post("/door/finish", json::object()).status, 200);
        EXPECT_TRUE(eventually([&] { return page->closed() == 4001; }));
        EXPECT_TRUE(eventually([&] { return session(learner)["state"] == "done"; })) << door_->text();
    }
    std::string hash_of(const std::string& recording) const {
        std::vector<std::filesystem::path> files;
        for (const auto& file : std::filesystem::directory_iterator(folder_ / "recordings" / recording))
            if (file.path().extension() == ".mcap") files.push_back(file.path());
        std::ranges::sort(files);
        return recording::sha256(files);
    }

    rigs::ServerProcess server_{[this] {
        auto options = domain();
        options.insert(options.end(), {"--classroom", "--config-root", config()});
        return options;
    }()};
};

TEST_F(LaunchedWithServer, PassesAndTheLearningSystemHasScoreObjectivesAndTheRecordingsHash) {
    Browser learner = browser();
    const std::string address =
        "/cmi5/S1?endpoint=" + cmi5::escaped(there_.origin() + "/lrs/") + "&fetch=x&actor=y";
    EXPECT_THAT(learner.get(address).body, HasSubstr("cmi5.js")) << "looking at it asks nobody";
    EXPECT_EQ(there_.fetched(), 0);
    there_.preferences = R"({"languagePreference": "de-DE,en"})";
    const json parameters = there_.launch();
    const Answer come = launch(learner, parameters, "S1");
    ASSERT_EQ(come.status, 200) << come.body;
    EXPECT_EQ(come.json()["who"], "trainee");
    EXPECT_EQ(come.json()["launch"]["languages"], "de-DE,en");
    EXPECT_TRUE(there_.asked_preferences);
    EXPECT_THAT(come.body, Not(HasSubstr("c2VjcmV0"))) << "the token stays here";
    EXPECT_TRUE(said({"initialized"}));
    EXPECT_EQ(launch(learner, parameters, "S1").status, 200) << "the page was loaded again";
    Browser other = browser();
    EXPECT_EQ(launch(other, parameters, "S1").status, 403) << "somebody else has copied its address";
    EXPECT_EQ(there_.fetched(), 1);
    EXPECT_EQ(learner.get("/").header("Location"), "/forecastle");
    play(learner, true);
    EXPECT_TRUE(said({"initialized", "passed", "completed", "terminated"})) << door_->text();
    EXPECT_THAT(there_.broken(), IsEmpty());
    const json result = there_.statement("passed")["result"];
    EXPECT_EQ(result["score"]["scaled"], 1.0);
    const json& told = result["extensions"];
    EXPECT_EQ(told["urn:windlass:extension:objectives"][0]["id"], "words");
    EXPECT_EQ(told["urn:windlass:extension:objectives"][0]["outcome"], "achieved");
    const std::string recording = told["urn:windlass:extension:recording"];
    EXPECT_EQ(told["urn:windlass:extension:recording_sha256"], hash_of(recording)) << recording;
    EXPECT_EQ(session(learner)["verdict"], "passed");
    EXPECT_EQ(session(learner)["back"], "https://lms.example/back?course=1");
    EXPECT_EQ(learner.get("/").header("Location"), "/cmi5") << "the page that leads back";
    EXPECT_TRUE(eventually([&] { return !session(learner)["waits"].get<bool>(); }));
    const std::string kept = audit();
    for (const char* line : {"\"launch\"", "launch.result", "launch.posted", "\"passed\""})
        EXPECT_THAT(kept, HasSubstr(line));
    EXPECT_THAT(kept + door_->text(), Not(HasSubstr("c2VjcmV0")));
    // It is in the history, too, and no class of it is left.
    EXPECT_TRUE(eventually([&] { return owner().get("/door/classes").json()["classes"].empty(); }));
}

TEST_F(LaunchedWithServer, FailsWithoutTheWordAndPassesAtTheSecondLaunch) {
    Browser learner = browser();
    ASSERT_EQ(launch(learner, there_.launch()).status, 200);
    play(learner, false);
    EXPECT_TRUE(said({"initialized", "failed", "completed", "terminated"})) << door_->text();
    EXPECT_EQ(there_.statement("failed")["result"]["score"]["scaled"], 0.0);
    next_session("session-2");
    ASSERT_EQ(launch(learner, there_.launch()).status, 200);
    play(learner, true);
    EXPECT_TRUE(
        said({"initialized", "failed", "completed", "terminated", "initialized", "passed", "terminated"}))
        << "completed once in a registration";
    EXPECT_THAT(there_.broken(), IsEmpty());
}

TEST_F(LaunchedWithServer, OfARecordStoreThatIsDownEverythingWaitsForItOnDiskAndTheDoorsDeathChangesNothing) {
    Browser learner = browser();
    ASSERT_EQ(launch(learner, there_.launch()).status, 200);
    EXPECT_TRUE(said({"initialized"}));
    there_.down();
    play(learner, true);
    EXPECT_TRUE(session(learner)["waits"]);
    EXPECT_TRUE(
        eventually([&] { return door_->text().find("has not taken a statement") != std::string::npos; }));
    door_->signal(SIGKILL);
    EXPECT_EQ(door_->exit_code(), -1);
    there_.refuses = 2;
    there_.up();
    door_ = open();
    EXPECT_TRUE(said({"initialized", "passed", "completed", "terminated"})) << door_->text();
    EXPECT_THAT(there_.broken(), IsEmpty());
    Browser again = browser();
    again.cookie = learner.cookie;
    EXPECT_TRUE(eventually([&] { return session(again)["waits"] == false; }));
    for (const auto& file : std::filesystem::directory_iterator(folder_ / "door/launches"))
        EXPECT_THAT(content(file.path()), Not(HasSubstr("c2VjcmV0"))) << "of no use any more";
}

TEST_F(LaunchedWithServer, LeftBeforeItIsOverOrOnlyLookedAtCountsAsNothing) {
    Browser learner = browser();
    ASSERT_EQ(launch(learner, there_.launch()).status, 200);
    EXPECT_EQ(learner.post("/door/logout", json::object()).status, 200);
    EXPECT_TRUE(said({"initialized", "terminated"})) << door_->text();
    EXPECT_EQ(session(learner)["verdict"], "");
    next_session("session-2");
    there_.launch_data["launchMode"] = "Browse";
    ASSERT_EQ(launch(learner, there_.launch()).status, 200);
    EXPECT_EQ(session(learner)["counts"], false);
    play(learner, true);
    EXPECT_TRUE(said({"initialized", "terminated", "initialized", "terminated"})) << door_->text();
    EXPECT_THAT(there_.broken(), IsEmpty());
}

TEST_F(Launched, GarbageInEachParameterIsToldByFieldAndNobodyIsAsked) {
    Browser learner = browser();
    for (const char* field : {"endpoint", "fetch", "actor", "registration", "activityId"})
        for (const json& bad :
             {json(""), json("x y"), json(5), json(), json("http://169.254.169.254/latest/")}) {
            json parameters = there_.launch();
            parameters[field] = bad;
            if (std::string(field) == "activityId" && bad.is_string() && bad != "" && bad != "x y") continue;
            const Answer answer = launch(learner, parameters);
            EXPECT_EQ(answer.status, 400) << field << ' ' << bad;
            EXPECT_THAT(answer.body, testing::StartsWith(std::string(field) + ": ")) << bad;
        }
    EXPECT_EQ(launch(learner, there_.launch(), "../people").status, 400);
    EXPECT_EQ(there_.fetched(), 0);
    EXPECT_EQ(launch(learner, there_.launch(), "let_go_port_25m").status, 404) << "no lesson: no marks";
    EXPECT_EQ(launch(learner, there_.launch(), "L27").status, 409) << "its bridge orders, and none is there";
    EXPECT_EQ(there_.fetched(), 0);
    EXPECT_EQ(learner.ask("POST", "/door/launch", "no json").status, 400);
    EXPECT_EQ(learner.get("/door/me").json()["who"], "nobody");
}

TEST_F(Launched, WhatTheLearningSystemRefusesIsToldAndItsTokenIsAskedForOnce) {
    Browser learner = browser();
    json parameters = there_.launch();
    there_.launch_data["launchMode"] = "Play";
    const Answer wrong = launch(learner, parameters);
    EXPECT_EQ(wrong.status, 502);
    EXPECT_THAT(wrong.body, HasSubstr("LMS.LaunchData.launchMode"));
    const Answer again = launch(learner, parameters);
    EXPECT_EQ(again.status, 502);
    EXPECT_THAT(again.body, HasSubstr("The authorization token has already been returned."));
    there_.down();
    const Answer nobody = launch(learner, there_.launch());
    EXPECT_EQ(nobody.status, 502);
    EXPECT_THAT(nobody.body, HasSubstr("Connection refused"));
    EXPECT_THAT(audit(), HasSubstr("launch.failed"));
    EXPECT_EQ(learner.get("/door/me").json()["who"], "nobody");
}

TEST_F(Launched, ALearningSystemThatIsSlowHoldsUpNobodyElse) {
    there_.slow_ms = 1500;
    std::thread waits([&] {
        Browser learner = browser();
        launch(learner, there_.launch());
    });
    pace(std::chrono::milliseconds(200));
    const auto before = std::chrono::steady_clock::now();
    EXPECT_EQ(owner().get("/door/classes").status, 200) << "set up, which takes a thread";
    EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::milliseconds(1200));
    waits.join();
}

TEST_F(Launched, GuessersOfLaunchesAreToldToWait) {
    int waits = 0;
    Browser guesser = browser("127.0.0.2");
    for (int i = 0; i < 40; ++i) {
        json parameters = there_.launch();
        parameters["fetch"] = there_.origin() + "/none";
        waits += launch(guesser, parameters).status == 429 ? 1 : 0;
    }
    EXPECT_GT(waits, 10);
}

TEST_F(DoorRig, NoLearningSystemStartsAnythingUnlessItIsConfigured) {
    LearningSystem there;
    Browser learner = browser();
    EXPECT_EQ(learner.get("/cmi5/L01?endpoint=x").status, 404);
    json parameters = there.launch();
    parameters["lesson"] = "L01_let_go_25m";
    EXPECT_EQ(learner.post("/door/launch", parameters).status, 404);
    EXPECT_EQ(there.fetched(), 0);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "door/launches"));
}

TEST_F(DoorRig, ByTlsAServerIsAskedOnlyWhereItsCertificateIsGood) {
    const auto me = [&](const std::string& host) {
        return cmi5::WebRequest{
            .url = cmi5::url_of("https://" + host + ":" + std::to_string(door_->tls) + "/door/me").value()};
    };
    const cmi5::WebClient trusts(folder_ / "door/authority.crt");
    EXPECT_EQ(trusts.ask(me("localhost")).status, 200);
    EXPECT_EQ(trusts.ask(me("127.0.0.1")).status, 200);
    EXPECT_THROW(trusts.ask(me("127.0.0.2")), std::runtime_error) << "not in its certificate";
    EXPECT_THROW(cmi5::WebClient().ask(me("localhost")), std::runtime_error) << "an authority nobody knows";
}

} // namespace
} // namespace windlass::test
