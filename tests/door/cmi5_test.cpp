// How a learning system's launch is read, what is said to its record store, and what waits for it.

#include "door/cmi5/course.hpp"
#include "door/cmi5/launch.hpp"
#include "door/cmi5/outbox.hpp"
#include "rigs/child_process.hpp"
#include "tests/door/learning_system.hpp"
#include "tests/recorder/folder.hpp"

#include <gmock/gmock.h>

#include <boost/property_tree/xml_parser.hpp>
#include <fmt/format.h>
#include <fstream>

namespace windlass::test {
namespace {

using namespace cmi5;
using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr std::int64_t kNow = 1'800'000'000;

template <class Throws>
std::string refusal(Throws throws) {
    try {
        throws();
    } catch (const std::exception& error) {
        return error.what();
    }
    return "nothing is refused";
}

Stamp next_stamp() {
    static int made = 0;
    return {.id = fmt::format("00000000-0000-4000-8000-{:012}", ++made), .at_unix_ms = 1000 * kNow + made};
}

Marks good_marks() {
    return {.ended_by_itself = true,
            .outcome = "achieved",
            .score = 87.04,
            .duration = 612.5,
            .objectives =
                {{.id = "control", .text = "Lets go", .stcw = "A-II/5", .outcome = "achieved", .score = 90}},
            .recording = "cmi5-1",
            .recording_sha256 = std::string(64, 'a')};
}

TEST(Url, IsReadByItsPartsAndNothingElseIsOne) {
    const auto url = url_of("HTTPS://LMS.example:8443/lrs/?a=b");
    ASSERT_TRUE(url);
    EXPECT_EQ(url->origin(), "https://lms.example:8443");
    EXPECT_EQ(url->target, "/lrs/?a=b");
    EXPECT_EQ(url_of("https://lms.example?k=1")->target, "/?k=1");
    EXPECT_EQ(url_of("http://[::1]:80/")->origin(), "http://[::1]");
    for (const char* none :
         {"", "lms.example", "ftp://lms.example/", "https://", "https://a b/", "https://u:p@lms/",
          "https://lms.example:0/", "https://lms.example:99999/", "https://lms.example:x/",
          "javascript:alert(1)", "https://lms.example/#x", "//lms.example/", "https://lms\r\nX: y/"})
        EXPECT_FALSE(url_of(none)) << none;
}

TEST(Url, WhatHasAMeaningIsEscapedAndComesBack) {
    const std::string text = "{\"a\": \"b&c=d\"} \xc3\xa9";
    EXPECT_THAT(escaped(text), Not(HasSubstr("&")));
    EXPECT_EQ(plain(escaped(text)), text);
    EXPECT_EQ(plain("100%"), "100%");
}

TEST(LearningSystems, AreTheConfiguredOriginsAndNoOther) {
    const LearningSystems systems({"https://lms.example", "http://127.0.0.1:8080"});
    EXPECT_TRUE(systems.allow(*url_of("https://LMS.example:443/xapi")));
    EXPECT_TRUE(systems.allow(*url_of("http://127.0.0.1:8080/")));
    for (const char* other : {"http://lms.example/", "https://lms.example:444/", "https://lms.example.evil/",
                              "http://127.0.0.1/", "http://169.254.169.254/"})
        EXPECT_FALSE(systems.allow(*url_of(other))) << other;
    for (const char* none : {"lms.example", "http://lms.example", "https://lms.example/path", "https://*"})
        EXPECT_THAT(refusal([&] { LearningSystems({none}); }), HasSubstr(none));
}

TEST(Launch, EachParameterThatIsNoneIsRefusedByItsName) {
    LearningSystem there;
    const LearningSystems allowed({there.origin()});
    const json good = there.launch();
    EXPECT_EQ(launch_of(good, allowed).activity, LearningSystem::kActivity);
    const std::vector<std::pair<std::string, std::vector<std::string>>> wrong{
        {"endpoint", {"", "x", "https://evil.example/", there.origin() + "/lrs?a=b", "http://127.0.0.1:1/"}},
        {"fetch", {"", "file:///etc/passwd", "http://169.254.169.254/latest", "https://evil.example/"}},
        {"actor",
         {"", "x", "[]", "{}", R"({"account": 5})", R"({"mbox": "mailto:a@b.c"})",
          R"({"objectType": "Group", "account": {"homePage": "https://a", "name": "b"}})",
          R"({"name": 5, "account": {"homePage": "https://a", "name": "b"}})"}},
        {"registration", {"", "1", "760e3480-ba55-4991-94b0-01820dbd23a2&x=y"}},
        {"activityId", {"", "no iri", "https://a b", std::string("urn:") + std::string(2000, 'x')}}};
    for (const auto& [field, values] : wrong)
        for (const std::string& value : values) {
            json bad = good;
            bad[field] = value;
            const std::string why = refusal([&] { launch_of(bad, allowed); });
            EXPECT_THAT(why, testing::StartsWith(field + ": ")) << value;
            EXPECT_LT(why.size(), 300U);
        }
    EXPECT_THAT(refusal([&] { launch_of({{"endpoint", 5}}, allowed); }), HasSubstr("endpoint: nothing"));
}

TEST(Launch, DataThatIsNoneIsRefusedByField) {
    const json good = LearningSystem().launch_data;
    EXPECT_EQ(*launch_data_of(good).mastery_score, 0.7);
    EXPECT_TRUE(launch_data_of(good).normal);
    for (const auto& [field, value] :
         std::vector<std::pair<std::string, json>>{{"contextTemplate", 5},
                                                   {"contextTemplate", {{"extensions", 5}}},
                                                   {"launchMode", "Play"},
                                                   {"masteryScore", 70},
                                                   {"returnURL", "javascript:alert(1)"}}) {
        json bad = good;
        bad[field] = value;
        EXPECT_THAT(refusal([&] { launch_data_of(bad); }), HasSubstr("LMS.LaunchData." + field));
    }
    EXPECT_THAT(refusal([] { launch_data_of(json()); }), HasSubstr("LMS.LaunchData"));
}

class Store : public ::testing::Test {
protected:
    LearningSystem there_;
    const WebClient client_{{}, std::chrono::seconds(5)};
    const LearningSystems allowed_{{there_.origin()}};
    About about_of(const Launch& launch) const {
        const LaunchData data = launch_data_of(there_.launch_data);
        return {.actor = launch.actor,
                .registration = launch.registration,
                .activity = launch.activity,
                .context_template = data.context_template,
                .normal = data.normal,
                .mastery_score = data.mastery_score};
    }
};

TEST_F(Store, GivesItsTokenOnceAndSaysWhyNotAgain) {
    const json launch = there_.launch();
    EXPECT_THAT(RecordStore::fetch_token(client_, launch["fetch"]), HasSubstr("c2VjcmV0"));
    EXPECT_THAT(refusal([&] { RecordStore::fetch_token(client_, launch["fetch"]); }),
                HasSubstr("The authorization token has already been returned."));
}

TEST_F(Store, HasDataAndPreferencesForWhoHasTheToken) {
    const Launch launch = launch_of(there_.launch(), allowed_);
    const RecordStore store(client_, launch.endpoint, RecordStore::fetch_token(client_, launch.fetch));
    EXPECT_EQ(store.launch_data(launch).return_url, "https://lms.example/back?course=1");
    EXPECT_EQ(store.preferences(launch).languages, "") << "404 is no error";
    there_.preferences = R"({"languagePreference": "de-DE,en", "audioPreference": "off"})";
    EXPECT_EQ(store.preferences(launch).languages, "de-DE,en");
    EXPECT_FALSE(store.has(launch, "passed"));
    const RecordStore other(client_, launch.endpoint, "guessed");
    EXPECT_THAT(refusal([&] { other.launch_data(launch); }), HasSubstr("401"));
}

TEST_F(Store, TakesEveryStatementOfAPassedAndOfAFailedSession) {
    const Launch launch = launch_of(there_.launch(), allowed_);
    const RecordStore store(client_, launch.endpoint, RecordStore::fetch_token(client_, launch.fetch));
    std::string why;
    About about = about_of(launch);
    Marks failed = good_marks();
    failed.outcome = "not_yet";
    failed.score = 40;
    EXPECT_EQ(store.post(initialized(about, next_stamp()), why), 200) << why;
    for (const json& each : last_statements(about, failed, 700, next_stamp))
        EXPECT_EQ(store.post(each, why), 200) << why;
    EXPECT_THAT(there_.verbs(), ElementsAre("initialized", "failed", "completed", "terminated"));
    there_.launch_data["contextTemplate"]["extensions"][LearningSystem::kSession] = "session-2";
    about = about_of(launch);
    about.has_completed = store.has(launch, "completed");
    EXPECT_TRUE(about.has_completed);
    EXPECT_EQ(store.post(initialized(about, next_stamp()), why), 200) << why;
    for (const json& each : last_statements(about, good_marks(), 700, next_stamp))
        EXPECT_EQ(store.post(each, why), 200) << why;
    EXPECT_THAT(there_.broken(), IsEmpty());
    const json result = there_.statement("passed")["result"];
    EXPECT_EQ(result["score"]["scaled"], 0.87);
    EXPECT_EQ(result["extensions"]["urn:windlass:extension:recording_sha256"], std::string(64, 'a'));
    EXPECT_EQ(result["extensions"]["urn:windlass:extension:objectives"][0]["outcome"], "achieved");
    EXPECT_EQ(store.post(there_.statements().front(), why), 200) << "the same once more is no second one";
    EXPECT_EQ(there_.statements().size(), 7U);
}

TEST_F(Store, ThatIsDownOrSlowIsToldByItsOriginInTime) {
    const Launch launch = launch_of(there_.launch(), allowed_);
    there_.slow_ms = 1000;
    const WebClient hasty({}, std::chrono::milliseconds(200));
    EXPECT_THAT(refusal([&] { RecordStore::fetch_token(hasty, launch.fetch); }), HasSubstr(there_.origin()));
    there_.down();
    EXPECT_THAT(refusal([&] { RecordStore::fetch_token(client_, launch.fetch); }),
                HasSubstr(there_.origin() + ": Connection refused"));
}

class Said : public ::testing::Test {
protected:
    About about_{.actor = {},
                 .registration = "r",
                 .activity = "urn:a",
                 .context_template = json::object(),
                 .normal = true,
                 .mastery_score = 0.7};
    std::vector<std::string> verbs(const std::optional<Marks>& marks) const {
        std::vector<std::string> all;
        for (const json& each : last_statements(about_, marks, 1, next_stamp))
            all.push_back(each["verb"]["display"]["en"]);
        return all;
    }
};

TEST_F(Said, PassedIsWhatTheLessonAndTheLearningSystemBothCallSo) {
    Marks marks = good_marks();
    EXPECT_EQ(verdict_of(about_, marks), Verdict::passed);
    about_.mastery_score = 0.9; // asks for more
    EXPECT_EQ(verdict_of(about_, marks), Verdict::failed);
    EXPECT_EQ(judged(about_, marks, Verdict::failed, next_stamp())["result"]["score"]["scaled"], 0.87);
    about_.mastery_score = 0.3; // for less
    marks.outcome = "not_yet";
    marks.score = 45;
    EXPECT_EQ(verdict_of(about_, marks), Verdict::failed) << "no points buy off a must";
    const json made = judged(about_, marks, Verdict::failed, next_stamp());
    EXPECT_FALSE(made["result"].contains("score")) << "0.45 would be a pass";
    EXPECT_EQ(made["result"]["extensions"]["urn:windlass:extension:points"], 45);
    about_.mastery_score = {};
    marks = good_marks();
    EXPECT_EQ(verdict_of(about_, marks), Verdict::passed);
}

TEST_F(Said, WhatProvesNothingIsNeitherPassedNorFailed) {
    EXPECT_THAT(verbs(good_marks()), ElementsAre("passed", "completed", "terminated"));
    EXPECT_THAT(verbs(std::nullopt), ElementsAre("terminated")) << "there is no recording";
    Marks early = good_marks();
    early.ended_by_itself = false;
    EXPECT_THAT(verbs(early), ElementsAre("terminated"));
    Marks practice = good_marks();
    practice.practice = true;
    EXPECT_THAT(verbs(practice), ElementsAre("terminated"));
    about_.has_completed = true;
    EXPECT_THAT(verbs(good_marks()), ElementsAre("passed", "terminated"));
    about_.has_passed = true;
    EXPECT_THAT(verbs(good_marks()), ElementsAre("terminated"));
    about_ = {
        .actor = {}, .registration = {}, .activity = {}, .context_template = json::object(), .normal = false};
    EXPECT_THAT(verbs(good_marks()), ElementsAre("terminated")) << "browse and review";
}

class Kept : public ::testing::Test {
protected:
    Outbox outbox() {
        return Outbox(folder_.path(), [](const std::filesystem::path& file, const std::string& text) {
            std::ofstream(file, std::ios::binary) << text;
        });
    }
    static Session session() {
        Session made;
        made.id = "s1";
        made.token = "secret";
        made.fetch = "f1";
        made.browser = "b1";
        made.about.context_template = json::object();
        return made;
    }
    static json said(const std::string& verb) {
        return {{"id", verb}, {"verb", {{"id", "http://adlnet.gov/expapi/verbs/" + verb}}}};
    }
    Folder folder_;
};

TEST_F(Kept, GoesOutInOrderAndTheTokenIsForgottenBehindTheLast) {
    Outbox box = outbox();
    box.put(session());
    box.add("s1", {said("initialized")}, false);
    box.add("s1", {said("passed"), said("terminated")}, true);
    for (const char* verb : {"initialized", "passed", "terminated"}) {
        ASSERT_THAT(box.due(kNow), ElementsAre("s1"));
        box.begin("s1", kNow);
        EXPECT_THAT(box.due(kNow), IsEmpty()) << "one at a time";
        EXPECT_EQ(box.posted("s1", kNow), verb);
    }
    EXPECT_THAT(box.due(kNow), IsEmpty());
    EXPECT_EQ(box.find("s1")->token, "");
    EXPECT_THAT(content(folder_ / "s1.json"), Not(HasSubstr("secret")));
    box.forget_old(kNow + Outbox::kKept);
    EXPECT_NE(box.of_browser("b1"), nullptr);
    box.forget_old(kNow + Outbox::kKept + 1);
    EXPECT_EQ(box.of_browser("b1"), nullptr);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "s1.json"));
}

TEST_F(Kept, WaitsLongerEachTimeAndIsThereForTheNextProgram) {
    Outbox box = outbox();
    box.put(session());
    box.add("s1", {said("initialized")}, false);
    std::int64_t now = kNow;
    std::vector<std::int64_t> pauses;
    for (int i = 0; i < 11; ++i) {
        box.begin("s1", now);
        EXPECT_TRUE(box.failed("s1", now));
        pauses.push_back(box.find("s1")->next_unix_s - now);
        now = box.find("s1")->next_unix_s;
    }
    EXPECT_THAT(pauses, ElementsAre(2, 4, 8, 16, 32, 64, 128, 256, 512, 900, 900));
    Outbox next = outbox();
    EXPECT_EQ(next.find("s1")->token, "secret");
    EXPECT_EQ(next.of_fetch("f1")->waiting.size(), 1U);
    EXPECT_THAT(next.due(now), ElementsAre("s1"));
    next.begin("s1", now);
    EXPECT_EQ(next.posted("s1", now), "initialized");
    EXPECT_EQ(next.find("s1")->tries, 0);
}

TEST_F(Kept, IsGivenUpAfterTwoWeeksWithAllBehindIt) {
    Outbox box = outbox();
    box.put(session());
    box.add("s1", {said("initialized"), said("terminated")}, true);
    box.begin("s1", kNow);
    EXPECT_TRUE(box.failed("s1", kNow));
    box.begin("s1", kNow + Outbox::kGivenUp);
    EXPECT_FALSE(box.failed("s1", kNow + Outbox::kGivenUp));
    EXPECT_THAT(box.find("s1")->waiting, IsEmpty());
    EXPECT_EQ(box.find("s1")->token, "");
}

TEST_F(Kept, AFileThatIsNoSessionIsToldByName) {
    std::ofstream(folder_ / "x.json") << "{}";
    EXPECT_THAT(refusal([&] { outbox(); }), HasSubstr("x.json"));
}

/// Whether a course has what CourseStructure.xsd (cmi5, section 13) wants of it: which elements in which
/// order, which attributes, of which values. What is wrong; empty: nothing.
class CourseStructure {
public:
    explicit CourseStructure(const std::string& xml) {
        std::istringstream in(xml);
        boost::property_tree::ptree tree;
        read_xml(in, tree, boost::property_tree::xml_parser::trim_whitespace);
        const Tree& whole = tree.get_child("courseStructure");
        attribute(whole, "xmlns", "https://w3id.org/xapi/profiles/cmi5/v1/CourseStructure\\.xsd");
        expect(order(whole) == "course au", "order of the course");
        const Tree& course = whole.get_child("course");
        attribute(course, "id", kIri);
        expect(order(course) == "title description", "elements of the course");
        words(course);
        std::set<std::string> ids;
        for (const auto& [name, each] : whole) {
            if (name != "au") continue;
            ++units;
            attribute(each, "id", kIri);
            expect(ids.insert(value(each, "id")).second, "a unit twice");
            attribute(each, "launchMethod", "OwnWindow|AnyWindow");
            attribute(each, "masteryScore", "0(\\.[0-9]{1,4})?|1(\\.0{1,4})?");
            attribute(each, "moveOn", "NotApplicable|Passed|Completed|CompletedAndPassed|CompletedOrPassed");
            attribute(each, "activityType", kIri);
            expect(order(each) == "title description url", "elements of a unit");
            words(each);
            expect(url_of(each.get<std::string>("url", "")).has_value(), "a unit's url");
        }
        expect(units > 0, "no unit");
    }
    std::vector<std::string> wrong;
    int units = 0;

private:
    using Tree = boost::property_tree::ptree;
    static constexpr const char* kIri = "[a-z]+:[^ <>\"{}|^`]+";

    void expect(bool right, const std::string& what) {
        if (!right) wrong.push_back(what);
    }
    static std::string value(const Tree& of, const std::string& name) {
        return of.get<std::string>("<xmlattr>." + name, "");
    }
    void attribute(const Tree& of, const std::string& name, const std::string& form) {
        expect(std::regex_match(value(of, name), std::regex(form)), name + "=" + value(of, name));
    }
    /// Names of the elements, one for a row of the same.
    static std::string order(const Tree& of) {
        std::string all, last;
        for (const auto& [name, each] : of)
            if (name != "<xmlattr>" && name != last) all += (all.empty() ? "" : " ") + (last = name);
        return all;
    }
    void words(const Tree& of) {
        for (const char* each : {"title", "description"}) {
            const auto said = of.get_child_optional(std::string(each) + ".langstring");
            expect(said && !said->data().empty(), std::string("no ") + each);
            if (said) attribute(*said, "lang", "[a-z]{2}");
        }
    }
};

TEST(Course, HasAUnitForEachLessonByTheStructureOfTheSpecification) {
    const std::vector<CourseLesson> lessons{
        {.id = "L01", .title = "Let go & <bring up>", .description = "\"Let go\"\x01 in 25 m", .pass = 70},
        {.id = "L02", .title = "Lower", .description = "Lower her", .pass = 85}};
    const std::string xml = course_xml("https://door.example:8443", lessons);
    const CourseStructure read(xml);
    EXPECT_THAT(read.wrong, IsEmpty());
    EXPECT_EQ(read.units, 2);
    EXPECT_THAT(xml, HasSubstr("Let go &amp; &lt;bring up&gt;"));
    EXPECT_THAT(xml, HasSubstr("masteryScore=\"0.85\" moveOn=\"Passed\""));
    EXPECT_THAT(xml, HasSubstr("<url>https://door.example:8443/cmi5/L02</url>"));
    EXPECT_EQ(xml, course_xml("https://door.example:8443", lessons)) << "its ids are the same again";
}

TEST(Course, OfTheShippedLessonsIsOneToo) {
    rigs::ChildProcess program({WINDLASS_DOOR, "course", "--url", "https://door.example", "--exercises",
                                WINDLASS_CONFIG_DIR "/exercises"});
    ASSERT_EQ(program.exit_code(), 0) << program.text();
    const CourseStructure read(program.text());
    EXPECT_THAT(read.wrong, IsEmpty());
    EXPECT_GE(read.units, 41);
    EXPECT_THAT(program.text(), HasSubstr("<url>https://door.example/cmi5/L13</url>"));
    EXPECT_THAT(program.text(), Not(HasSubstr("unaway"))) << "what is to come in L13 is not told beforehand";
    rigs::ChildProcess wrong({WINDLASS_DOOR, "course", "--url", "door.example"});
    EXPECT_EQ(wrong.exit_code(), 1);
    EXPECT_THAT(wrong.text(), HasSubstr("--url: door.example: https://HOST"));
}

} // namespace
} // namespace windlass::test
