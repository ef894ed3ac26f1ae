// A class over the network, from its opening to what came of it.

#include "tests/door/door_rig.hpp"

#include <csignal>

namespace windlass::test {
using namespace rigs;

namespace {

using testing::HasSubstr;

class Class : public DoorWithServer {
protected:
    /// A recording that has its closing: it was ended, not broken off.
    bool closed(const std::string& name) const {
        const auto recording = folder_ / "recordings" / name;
        if (!std::filesystem::exists(recording)) return false;
        for (const auto& file : std::filesystem::directory_iterator(recording))
            if (content(file.path()).find("windlass.closing") != std::string::npos) return true;
        return false;
    }
};

TEST_F(Class, RecordsItselfFromWhenSomebodySitsThereAndIsTalkedOverWhenItIsOver) {
    const std::string code = open_class("mon", 2, 1, "L01_let_go_25m");
    expect_made("mon");
    Browser ben = trainee(code, "ben");
    const auto exercise = [this](int i) { return class_told("mon")["exercises"][i]; };
    std::string recording;
    ASSERT_TRUE(eventually([&] { return !(recording = exercise(0)["recording"]).empty(); })) << door_->text();
    ASSERT_TRUE(eventually([&] { return door_->text().find("recording partition") != std::string::npos; }));
    EXPECT_EQ(exercise(1)["recording"], "") << "nobody sits there";
    EXPECT_EQ(owner().post("/door/class", {{"do", "start"}, {"class", "mon"}}).status, 200);
    ASSERT_TRUE(eventually([&] { return exercise(0)["time"] > 1.0; }));
    EXPECT_TRUE(exercise(1)["state"] == RUN_READY) << "it waits for who comes late";
    ASSERT_TRUE(eventually([&] { return exercise(0)["points"].is_number(); }));
    EXPECT_EQ(exercise(0)["points"], 0)
        << "nobody has done anything: limits that are kept so far earn nothing";
    EXPECT_EQ(ben.get("/door/debriefing?recording=" + recording).status, 403)
        << "his is the instructor's to show";
    EXPECT_EQ(ben.get("/door/side_by_side?class=mon").status, 403);
    EXPECT_EQ(owner().get("/door/side_by_side?class=mon").status, 404) << "not before it is over";
    EXPECT_EQ(owner().post("/door/class", {{"do", "end"}, {"class", "mon"}}).status, 200);
    ASSERT_TRUE(eventually([&] { return exercise(0)["state"].is_null() && exercise(1)["state"].is_null(); }))
        << "removed";
    EXPECT_EQ(exercise(0)["outcome"], "not_shown") << "ended, and marked for it, before it was removed";
    EXPECT_TRUE(exercise(0)["points"].is_number());
    EXPECT_EQ(exercise(0)["recording"], recording);
    EXPECT_EQ(exercise(0)["seats"][0]["name"], "ben");
    EXPECT_THAT(owner().get("/door/marks.csv?class=mon").body,
                HasSubstr("\"mon-1\",ship,\"ben\",0.0,not_shown,\"" + recording + '"'));
    const Answer debriefing = owner().get("/door/debriefing?recording=" + recording);
    EXPECT_EQ(debriefing.status, 200) << debriefing.body;
    EXPECT_THAT(debriefing.body, HasSubstr(recording));
    const Answer what_if = owner().get("/door/what_if?recording=" + recording);
    EXPECT_EQ(what_if.status, 200) << what_if.body;
    EXPECT_THAT(what_if.body, HasSubstr("<h1>What would have kept lost points: " + recording + "</h1>"));
    EXPECT_EQ(ben.get("/door/what_if?recording=" + recording).status, 401) << "his class is over";
    const Answer side_by_side = owner().get("/door/side_by_side?class=mon");
    EXPECT_EQ(side_by_side.status, 200) << side_by_side.body;
    EXPECT_THAT(side_by_side.body, HasSubstr("<a href=\"debriefing?recording=" + recording + "\">ben</a>"));
    EXPECT_THAT(side_by_side.body, HasSubstr(">Who did what when</h2>"));
    EXPECT_EQ(ben.get("/door/side_by_side?class=mon").status, 401) << "his class is over";
    EXPECT_EQ(owner().get("/door/side_by_side?class=tue").status, 404);
    // Into the history by itself, with who sat there.
    EXPECT_TRUE(eventually([&] {
        return content(folder_ / "door/classes.json").find("\"in_history\": true") != std::string::npos;
    })) << door_->text();
    rigs::ChildProcess history{
        {INSTRUCTOR_CONSOLE, "history", "--file", (folder_ / "recordings/history.sqlite").string(), "list"}};
    EXPECT_EQ(history.exit_code(), 0);
    EXPECT_THAT(history.text(), HasSubstr("ben (ship)"));
    // And what he is to practise next, by that.
    const auto next = owner().get("/door/next?class=mon").json();
    EXPECT_EQ(next["waits"], false);
    ASSERT_EQ(next["next"].size(), 1U) << next;
    EXPECT_EQ(next["next"][0]["name"], "ben");
    EXPECT_EQ(next["next"][0]["file"], "L01_let_go_25m");
    EXPECT_EQ(next["next"][0]["practice"], true) << "he has not achieved it";
    EXPECT_THAT(next["next"][0]["why"].get<std::string>(), HasSubstr("not shown: "));
    EXPECT_NE(next["next"][0]["from"].is_null(), next["next"][0]["no_from"] == "")
        << "again from a moment, or why not";
    EXPECT_EQ(owner().get("/door/next?class=tue").status, 404);
    EXPECT_NE(ben.get("/door/next?class=mon").status, 200) << "his is the instructor's to tell";
    for (const std::string other : {"", "../door", "none", "/etc"})
        EXPECT_EQ(owner().get("/door/debriefing?recording=" + other).status, 404) << other;
    EXPECT_EQ(owner().get("/door/marks.csv?class=tue").status, 404);
    EXPECT_EQ(browser().get("/door/marks.csv?class=mon").status, 401);
    // A second class of the day takes nothing from the first.
    const Answer again = owner().post(
        "/door/class",
        {{"do", "open"}, {"class", "mon"}, {"lesson", "L01_let_go_25m"}, {"exercises", 1}, {"crew", 1}});
    EXPECT_EQ(again.status, 409);
    EXPECT_THAT(again.body, HasSubstr("mon-b is free"));
    EXPECT_EQ(owner().get("/door/debriefing?recording=" + recording).status, 200);
    open_class("mon-b", 1, 1, "L01_let_go_25m");
    EXPECT_EQ(exercise(0)["seats"][0]["name"], "ben");
}

TEST_F(Class, ExerciseWhoseSeatChangesHandsIsTheWorkOfBoth) {
    const std::string code = open_class("mon", 1, 1, "L01_let_go_25m");
    expect_made("mon");
    const auto told = [this] { return class_told("mon")["exercises"][0]; };
    const auto lead = [this](nlohmann::json what) {
        what["class"] = "mon";
        return owner().post("/door/class", what).status;
    };
    Browser ben = trainee(code, "ben");
    EXPECT_EQ(lead({{"do", "start"}}), 200);
    ASSERT_TRUE(eventually([&] { return told()["time"] > 3.0; })) << door_->text();
    EXPECT_EQ(lead({{"do", "remove"}, {"name", "ben"}}), 200);
    EXPECT_EQ(told()["parts"].size(), 1U) << told();
    Browser carl = trainee(code, "carl");
    ASSERT_TRUE(eventually([&] { return told()["time"] > 6.0; })) << door_->text();
    EXPECT_EQ(told()["parts"][0]["name"], "ben");
    EXPECT_GE(told()["parts"][0]["until"], 3.0);
    EXPECT_EQ(told()["parts"][1]["name"], "carl");
    EXPECT_EQ(lead({{"do", "end"}}), 200);
    ASSERT_TRUE(eventually([&] {
        return content(folder_ / "door/classes.json").find("\"in_history\": true") != std::string::npos;
    })) << door_->text();
    rigs::ChildProcess history{
        {INSTRUCTOR_CONSOLE, "history", "--file", (folder_ / "recordings/history.sqlite").string(), "list"}};
    EXPECT_EQ(history.exit_code(), 0);
    EXPECT_THAT(history.text(), AllOf(HasSubstr("ben (ship to 0:0"), HasSubstr("carl (ship from 0:0")));
    EXPECT_THAT(owner().get("/door/side_by_side?class=mon").body, HasSubstr("carl from 0:0"));
    EXPECT_THAT(owner().get("/door/marks.csv?class=mon").body, HasSubstr(",to 0:0"));
}

TEST_F(Class, OnAnAttemptAnAssessorHasAWordOnceTheHistoryHasIt) {
    const std::string code = open_class("mon", 1, 1, "L01_let_go_25m");
    expect_made("mon");
    Browser ben = trainee(code, "ben");
    const auto of_rank = [this](const char* rank) {
        owner().post("/door/people",
                     {{"do", "put"}, {"name", rank}, {"rank", rank}, {"password", kPassword}});
        Browser one = browser();
        EXPECT_EQ(one.post("/door/login", {{"name", rank}, {"password", kPassword}}).status, 200);
        return one;
    };
    Browser assessor = of_rank("assessor"), observer = of_rank("observer");
    std::string recording;
    ASSERT_TRUE(eventually([&] {
        return !(recording = class_told("mon")["exercises"][0]["recording"]).empty();
    })) << door_->text();
    nlohmann::json word{
        {"recording", recording}, {"outcome", "achieved"}, {"points", 81.5}, {"note", "short"}};
    EXPECT_EQ(assessor.post("/door/word", word).status, 404) << "it goes on";
    EXPECT_EQ(owner().post("/door/class", {{"do", "start"}, {"class", "mon"}}).status, 200);
    ASSERT_TRUE(eventually([&] { return class_told("mon")["exercises"][0]["time"] > 3.0; })) << door_->text();
    EXPECT_EQ(owner().post("/door/class", {{"do", "end"}, {"class", "mon"}}).status, 200);
    const auto next = [&] { return assessor.get("/door/next?class=mon").json(); };
    ASSERT_TRUE(eventually([&] { return next()["waits"] == false; })) << door_->text();
    EXPECT_THAT(next()["words"], testing::IsEmpty());
    const Answer refused = assessor.post("/door/word", word);
    EXPECT_EQ(refused.status, 409);
    EXPECT_THAT(refused.body, HasSubstr("10 characters at least"));
    word["note"] = "the load cell had failed";
    const nlohmann::json wrong_fields{{"points", 101}, {"outcome", "good"}, {"note", 5}};
    for (const auto& [field, value] : wrong_fields.items()) {
        nlohmann::json wrong = word;
        wrong[field] = value;
        EXPECT_EQ(assessor.post("/door/word", wrong).status, 400) << field;
    }
    EXPECT_EQ(observer.post("/door/word", word).status, 403) << "who only looks on";
    EXPECT_EQ(ben.post("/door/word", word).status, 401) << "his class is over";
    EXPECT_EQ(class_told("mon")["words"], 0);
    EXPECT_EQ(class_told("mon")["exercises"][0]["pass"], 70)
        << "by which a page asks about 40 points, achieved";
    EXPECT_EQ(assessor.post("/door/word", word).status, 200);
    EXPECT_EQ(class_told("mon")["words"], 1) << "by which other pages look again";
    const nlohmann::json told = next()["words"];
    ASSERT_EQ(told.size(), 1U) << told;
    EXPECT_EQ(told[0]["by"], "assessor");
    EXPECT_EQ(told[0]["points"], 81.5);
    EXPECT_EQ(told[0]["outcome"], "achieved");
    EXPECT_EQ(class_told("mon")["exercises"][0]["outcome"], "not_shown") << "what was computed stays";
    const std::string debriefing = assessor.get("/door/debriefing?recording=" + recording).body;
    EXPECT_THAT(debriefing,
                HasSubstr("Set by assessor since: <strong>81.5 points, achieved</strong>. the load cell "
                          "had failed"));
    EXPECT_THAT(debriefing, HasSubstr("<dt>Trainees</dt><dd>ben</dd>"));
    EXPECT_THAT(debriefing, HasSubstr("<dd>nobody moved a lever, ordered or reported</dd>"));
    EXPECT_THAT(assessor.get("/door/side_by_side?class=mon").body,
                HasSubstr("; set by assessor since: 81.5 points, achieved: the load cell had failed"));
    EXPECT_THAT(assessor.get("/door/marks.csv?class=mon").body,
                HasSubstr(",\"assessor\",81.5,achieved,\"the load cell had failed\""));
    EXPECT_THAT(audit(), HasSubstr("attempt.judged"));
}

TEST_F(Class, SaysWhenTheSilenceOfASeatEndsItsLesson) {
    const std::string code = open_class("mon", 1, 1, "L01_let_go_25m");
    expect_made("mon");
    Browser ben = trainee(code, "ben");
    const auto told = [this] { return class_told("mon")["exercises"][0]; };
    EXPECT_EQ(owner().post("/door/class", {{"do", "start"}, {"class", "mon"}}).status, 200);
    ASSERT_TRUE(eventually([&] { return told()["time"] > 5.0; })) << door_->text();
    EXPECT_TRUE(told()["asking"].is_null()) << "the first order is 2 s old";
    ASSERT_TRUE(eventually([&] { return told()["asking"].is_object(); })) << told();
    EXPECT_NEAR(told()["asking"]["gives_up"].get<double>(), 123, 1)
        << "said once and three times again, 30 s apart, to who has said nothing yet";
    ASSERT_TRUE(eventually([&] { return told()["time"] > 64.0; })) << told();
    EXPECT_NEAR(told()["asking"]["since"].get<double>(), 33, 1) << "and not since the second time";
    EXPECT_FALSE(told()["asking"]["misled"].get<bool>()) << "he has said nothing";
}

// A start passes a question over, and at the desk it is meant to.
TEST_F(Class, IsNotStartedOverAQuestionThatASeatIsBeingAsked) {
    const std::string code = open_class("mon", 1, 2, "L27_the_conn");
    expect_made("mon");
    Browser ben = trainee(code, "ben"), carl = trainee(code, "carl");
    const auto told = [this] { return class_told("mon")["exercises"][0]; };
    const auto start = [this] { return owner().post("/door/class", {{"do", "start"}, {"class", "mon"}}); };
    EXPECT_EQ(start().status, 200);
    ASSERT_TRUE(eventually([&] { return told()["time"] > 1.0; })) << door_->text();
    EXPECT_EQ(told()["asked"], false);
    const nlohmann::json let_go{{"code", "BRIDGE_ORDER_LET_GO"}, {"side", 0}};
    EXPECT_EQ(
        owner()
            .post("/door/class",
                  {{"do", "give"}, {"class", "mon"}, {"topic", "BridgeOrderCommand"}, {"sample", let_go}})
            .status,
        200);
    ASSERT_TRUE(eventually([&] { return told()["asked"] == true && told()["state"] == RUN_PAUSED; }))
        << told();
    const Answer refused = start();
    EXPECT_EQ(refused.status, 409);
    EXPECT_THAT(refused.body, HasSubstr("holds for a question"));
    EXPECT_EQ(told()["asked"], true);

    // Paused besides, as it stands where a server has taken it up: a start has it hold again, and passes
    // nothing.
    EXPECT_EQ(owner().post("/door/class", {{"do", "pause"}, {"class", "mon"}}).status, 200);
    ASSERT_TRUE(eventually([&] { return told()["asked"] == false; })) << told();
    EXPECT_EQ(start().status, 200);
    EXPECT_TRUE(eventually([&] { return told()["asked"] == true; })) << told();
    EXPECT_EQ(start().status, 409);
}

TEST_F(Class, IsStartedWhereSomebodySitsAndElsewhereOnceSomebodyDoes) {
    const std::string code = open_class("mon", 2, 1);
    expect_made("mon");
    const auto start = [this] { return owner().post("/door/class", {{"do", "start"}, {"class", "mon"}}); };
    const auto stands = [this](int i, RunState state) {
        return class_told("mon")["exercises"][i]["state"] == state;
    };
    const Answer refused = start();
    EXPECT_EQ(refused.status, 409);
    EXPECT_THAT(refused.body, HasSubstr("nobody sits in this class yet"));
    Browser ben = trainee(code, "ben"); // and his page is not open
    EXPECT_EQ(start().status, 200);
    EXPECT_TRUE(eventually([&] { return stands(0, RUN_RUNNING); })) << class_told("mon");
    EXPECT_TRUE(stands(1, RUN_READY)) << "else its lesson would be over before somebody comes";
    Browser carl = trainee(code, "carl");
    EXPECT_EQ(start().status, 200);
    EXPECT_TRUE(eventually([&] { return stands(1, RUN_RUNNING); })) << class_told("mon");
    EXPECT_TRUE(stands(0, RUN_RUNNING)) << "which goes on";
}

TEST_F(Class, WhoseLessonWasStillGoingHearsTheMarksBeforeTheSeatEnds) {
    const std::string code = open_class("mon", 1, 1, "L01_let_go_25m");
    expect_made("mon");
    Browser ben = trainee(code, "ben");
    const auto page = ben.open("page=forecastle");
    ASSERT_TRUE(eventually([&] { return !page->samples("ForecastleView").empty(); })) << door_->text();
    EXPECT_EQ(owner().post("/door/class", {{"do", "start"}, {"class", "mon"}}).status, 200);
    ASSERT_TRUE(eventually([&] { return class_told("mon")["exercises"][0]["time"] > 1.0; }));
    EXPECT_EQ(owner().post("/door/class", {{"do", "end"}, {"class", "mon"}}).status, 200);
    EXPECT_EQ(ben.upgrade("page=forecastle"), 401) << "the seat is nobody's at once";
    ASSERT_TRUE(eventually([&] { return page->closed().has_value(); }));
    EXPECT_EQ(page->closed(), 4002) << "he may read on";
    const auto told = page->all<Assessment>("SeatAssessment");
    ASSERT_FALSE(told.empty());
    EXPECT_EQ(told.back().outcome().to_string(), "not_shown");
}

TEST_F(Class, GoesOnFromAMomentOfAnAttemptAndIsPracticeThen) {
    const std::string code = open_class("mon", 1, 1, "L01_let_go_25m");
    expect_made("mon");
    Browser ben = trainee(code, "ben");
    const auto exercise = [this](const char* id) { return class_told(id)["exercises"][0]; };
    std::string recording;
    ASSERT_TRUE(eventually([&] { return !(recording = exercise("mon")["recording"]).empty(); }))
        << door_->text();
    ASSERT_TRUE(eventually([&] { return door_->text().find("recording partition") != std::string::npos; }));
    EXPECT_EQ(owner().post("/door/class", {{"do", "start"}, {"class", "mon"}}).status, 200);
    ASSERT_TRUE(eventually([&] { return exercise("mon")["time"] > 4.0; }));
    EXPECT_EQ(owner().post("/door/class", {{"do", "end"}, {"class", "mon"}}).status, 200);
    ASSERT_TRUE(eventually([&] { return exercise("mon")["state"].is_null() && closed(recording); }));

    nlohmann::json asked{
        {"do", "open"},   {"class", "tue"}, {"lesson", "L01_let_go_25m"},
        {"exercises", 1}, {"crew", 1},      {"from", {{"recording", "none"}, {"position", 3}}}};
    EXPECT_EQ(owner().post("/door/class", asked).status, 404) << "no class has made that";
    asked["from"] = {{"recording", recording}, {"position", -1}};
    EXPECT_EQ(owner().post("/door/class", asked).status, 400);
    asked["from"]["position"] = 3;
    const Answer opened = owner().post("/door/class", asked);
    ASSERT_EQ(opened.status, 200) << opened.body;
    EXPECT_EQ(owner().post("/door/class", {{"do", "start"}, {"class", "tue"}}).status, 409)
        << "nobody sits there";
    ASSERT_TRUE(eventually([&] { return exercise("tue")["state"] == RUN_PAUSED; })) << door_->text();
    const double there = exercise("tue")["time"];
    EXPECT_GT(there, 0.5);
    EXPECT_LT(there, 4.0) << "and it had run on for longer";
    Browser carl = trainee(class_told("tue")["code"], "carl");
    ASSERT_TRUE(eventually([&] { return !exercise("tue")["recording"].get<std::string>().empty(); }));
    EXPECT_EQ(owner().post("/door/class", {{"do", "start"}, {"class", "tue"}}).status, 200);
    ASSERT_TRUE(eventually([&] { return exercise("tue")["time"] > there + 1; }));
    EXPECT_EQ(owner().post("/door/class", {{"do", "end"}, {"class", "tue"}}).status, 200);
    ASSERT_TRUE(eventually([&] { return exercise("tue")["state"].is_null(); }));
    EXPECT_EQ(exercise("tue")["outcome"], "practice");

    const auto next = [&] { return owner().get("/door/next?class=tue").json(); };
    ASSERT_TRUE(eventually([&] { return next()["waits"] == false; })) << door_->text();
    std::filesystem::remove_all(folder_ / "recordings" / exercise("tue")["recording"].get<std::string>());
    const nlohmann::json told = next()["next"];
    ASSERT_EQ(told.size(), 1U) << told;
    EXPECT_TRUE(told[0]["from"].is_null());
    EXPECT_EQ(told[0]["no_from"], "its recording is here no more");
}

TEST_F(Class, SaysWhyItDoesNotStandAtItsMoment) {
    const std::string code = open_class("mon", 1, 1, "L01_let_go_25m");
    expect_made("mon");
    Browser ben = trainee(code, "ben");
    const auto exercise = [this](const char* id) { return class_told(id)["exercises"][0]; };
    std::string recording;
    ASSERT_TRUE(eventually([&] { return !(recording = exercise("mon")["recording"]).empty(); }));
    ASSERT_TRUE(eventually([&] { return door_->text().find("files attached") != std::string::npos; }));
    EXPECT_EQ(exercise("mon")["trouble"], "");
    EXPECT_EQ(owner().post("/door/class", {{"do", "end"}, {"class", "mon"}}).status, 200);
    ASSERT_TRUE(eventually([&] { return exercise("mon")["state"].is_null() && closed(recording); }));
    for (const auto& file : std::filesystem::directory_iterator(folder_ / "recordings" / recording))
        std::filesystem::resize_file(file.path(), 8); // its disk has lost it
    const nlohmann::json asked{
        {"do", "open"},   {"class", "tue"}, {"lesson", "L01_let_go_25m"},
        {"exercises", 1}, {"crew", 1},      {"from", {{"recording", recording}, {"position", 0}}}};
    const Answer opened = owner().post("/door/class", asked);
    ASSERT_EQ(opened.status, 200) << opened.body;
    EXPECT_TRUE(eventually([&] {
        return exercise("tue")["trouble"].get<std::string>().find("this moment of it") != std::string::npos;
    })) << exercise("tue")
        << door_->text();
    Browser carl = trainee(class_told("tue")["code"], "carl");
    const Answer refused = owner().post("/door/class", {{"do", "start"}, {"class", "tue"}});
    EXPECT_EQ(refused.status, 409);
    EXPECT_THAT(refused.body, HasSubstr("at their moment"));
}

TEST_F(Class, SaysThatAServerHasNotMadeIt) {
    const nlohmann::json asked{{"do", "open"},   {"class", "mon"}, {"lesson", "let_go_port_25m"},
                               {"exercises", 1}, {"crew", 1},      {"practice", true}}; // it is no lesson
    ASSERT_EQ(owner().post("/door/class", asked).status, 200);
    EXPECT_TRUE(eventually([&] {
        return class_told("mon")["exercises"][0]["trouble"].get<std::string>().find("has not made it") !=
               std::string::npos;
    })) << class_told("mon");
}

TEST_F(Class, RecordingsEndWholeWithTheDoorAndBeginAnewWithTheNext) {
    const std::string code = open_class("mon", 1, 1);
    expect_made("mon");
    Browser ben = trainee(code, "ben");
    const auto recording = [this] {
        return class_told("mon")["exercises"][0]["recording"].get<std::string>();
    };
    std::string first;
    ASSERT_TRUE(eventually([&] { return !(first = recording()).empty(); })) << door_->text();
    // It has heard something: a recording of nothing is none, and is not left behind.
    ASSERT_TRUE(eventually([&] { return door_->text().find("files attached") != std::string::npos; }))
        << door_->text();
    door_->signal(SIGKILL);
    EXPECT_EQ(door_->exit_code(), -1);
    EXPECT_TRUE(eventually([&] { return closed(first); })) << "the recorder of a door that was killed";
    pace(std::chrono::seconds(1)); // by which recordings are named
    door_ = open_door();
    owner_.emplace(door_->loopback);
    EXPECT_EQ(owner_->post("/door/login", {{"name", "anna"}, {"password", kPassword}}).status, 200);
    EXPECT_TRUE(eventually([&] { return recording() != first; })) << "the next door records, too";
}

/// The same with a server that keeps its exercises on disk.
class KeptClass : public DoorRig, public testing::WithParamInterface<const char*> {
protected:
    std::unique_ptr<ServerProcess> start_server() const {
        auto options = domain();
        options.insert(options.end(), {"--classroom", "--config-root", WINDLASS_CONFIG_DIR, "--keep",
                                       (folder_ / "kept").string(), "--workers", GetParam()});
        return std::make_unique<ServerProcess>(std::move(options));
    }
};

TEST_P(KeptClass, StandsWhereItStoodWhenItsServerWasKilledAndIsStartedTogetherAgain) {
    auto server = start_server();
    const std::string code = open_class("mon", 2, 1);
    const auto all = [this](auto is) {
        const auto told = class_told("mon");
        return std::ranges::all_of(told["exercises"], [&](const auto& each) { return is(each); });
    };
    ASSERT_TRUE(eventually([&] { return all([](const auto& each) { return !each["state"].is_null(); }); }))
        << door_->text();
    Browser ben = trainee(code, "ben"), carl = trainee(code, "carl");
    const auto give = [this](const char* order) {
        EXPECT_EQ(owner().post("/door/class", {{"do", order}, {"class", "mon"}}).status, 200);
    };
    give("start");
    ASSERT_TRUE(eventually([&] { return all([](const auto& each) { return each["time"] > 3.0; }); }));
    const double then = class_told("mon")["exercises"][0]["time"];
    server->signal(SIGKILL);
    EXPECT_EQ(server->exit_code(), -1);
    // One that has room and knows nothing of them is there before their own.
    auto other = domain();
    other.insert(other.end(), {"--classroom", "--config-root", WINDLASS_CONFIG_DIR, "--name", "other"});
    const ServerProcess beside(std::move(other));
    pace(std::chrono::seconds(8)); // by which the lost one is no longer counted
    server = start_server();
    // Never made anew by the door: their time would be 0.
    EXPECT_TRUE(eventually([&] {
        return all([&](const auto& each) { return each["state"] == RUN_PAUSED && each["time"] > then - 1; });
    })) << class_told("mon")
        << server->text();
    EXPECT_EQ(server->text().find("already"), std::string::npos)
        << "nor by one worker before another had taken it up: " << server->text();
    auto page = ben.open("page=forecastle");
    EXPECT_TRUE(eventually([&] { return !page->samples("ForecastleView").empty(); }));
    give("start");
    EXPECT_TRUE(eventually([&] { return all([&](const auto& each) { return each["time"] > then + 1; }); }));
}

INSTANTIATE_TEST_SUITE_P(Of, KeptClass, testing::Values("0", "2"),
                         [](const auto& workers) { return std::string(workers.param) + "Workers"; });

} // namespace
} // namespace windlass::test
