// The debriefing: what the page and the records say is what the recording has.

#include "common/figure_text.hpp"
#include "recorder/debrief/attempt_reader.hpp"
#include "recorder/debrief/compare.hpp"
#include "recorder/debrief/curves.hpp"
#include "recorder/debrief/html.hpp"
#include "recorder/debrief/judgement.hpp"
#include "recorder/debrief/lesson_text.hpp"
#include "recorder/debrief/moments.hpp"
#include "recorder/debrief/page.hpp"
#include "recorder/debrief/page_parts.hpp"
#include "recorder/debrief/plot.hpp"
#include "recorder/debrief/read_attempt.hpp"
#include "recorder/debrief/records.hpp"
#include "recorder/debrief/said.hpp"
#include "recorder/debrief/scale.hpp"
#include "recorder/debrief/scenes.hpp"
#include "recorder/debrief/seat_units.hpp"
#include "recorder/recording/sha256.hpp"
#include "words/words.hpp"

#include "tests/recorder/debriefed.hpp"
#include "tests/recorder/folder.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <regex>

namespace windlass::debrief {
namespace {

using test::DebriefedRun;
using test::Folder;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

Attempt read(const std::filesystem::path& path, std::size_t run = 0) {
    recording::Recording recording({path});
    Attempt attempt = read_attempt(recording, run);
    read_scenes(recording, attempt);
    return attempt;
}

Attempt attempt_of(const Folder& folder, const DebriefedRun& of = {}, const char* name = "monday") {
    recorder::Tape tape({.folder = folder / name});
    test::write_run(tape, of);
    tape.close({});
    return read(folder / name);
}

int count(const std::string& text, const std::string& part) {
    int found = 0;
    for (auto at = text.find(part); at != text.npos; at = text.find(part, at + 1))
        ++found;
    return found;
}

TEST(DebriefTest, LargestTensionOnThePageIsTheLargestOfTheRecording) {
    const Folder folder;
    const Attempt attempt = attempt_of(folder);
    double largest = 0, at = 0; // looked for in every sample
    recording::Recording recording({folder / "monday"});
    auto cursor = recording.messages({.topics = {"WindlassLoad"}});
    while (const auto message = cursor.next()) {
        const auto load = recording::decode<WindlassLoad>(message->payload);
        if (load.hawse_tension() > largest) at = load.time();
        largest = std::max(largest, load.hawse_tension());
    }
    ASSERT_EQ(largest, test::kPeakTension);
    const auto figures = figures_of(attempt);
    const auto found = std::ranges::find(figures, "largest_tension_port", &Figure::id);
    ASSERT_NE(found, figures.end());
    EXPECT_DOUBLE_EQ(found->value, largest);
    EXPECT_DOUBLE_EQ(attempt.sides[0].curves[kTension].largest()->time, at);
    EXPECT_THAT(page_of(attempt, {}), HasSubstr("75 t at 0:31"));
    // And the line that is drawn goes up to it, though it is of one sample in hundreds.
    const auto drawn = attempt.sides[0].curves[kTension].samples();
    EXPECT_LT(drawn.size(), 1500U);
    EXPECT_DOUBLE_EQ(std::ranges::max(drawn, {}, &Sample::value).value * words::units::tonne, largest);
}

TEST(DebriefTest, FiguresEndWithTheLessonAndWhatCameAfterItStandsUnderItsEnd) {
    const Folder folder;
    Attempt attempt = attempt_of(folder);
    EXPECT_FALSE(attempt.lesson_over()) << "the exercise ended with it";
    EXPECT_THAT(page_of(attempt, {}), Not(HasSubstr("What counts")));
    EXPECT_THAT(page_of(attempt, {}), Not(HasSubstr("After the lesson")));
    EXPECT_TRUE(json_of(attempt)["lesson_over"].is_null());
    attempt.assessment->time(30); // and the exercise went on for half a minute: the peak came then
    const auto figures = figures_of(attempt);
    const auto value = [&](const char* id) {
        const auto found = std::ranges::find(figures, id, &Figure::id);
        return found == figures.end() ? -1 : found->value;
    };
    EXPECT_NEAR(value("duration"), 30, 1e-9);
    EXPECT_NEAR(value("largest_tension_port"), 43'000, 1);
    EXPECT_NEAR(value("cable_out_port"), 45, 0.3);
    for (const Moment& moment : moments_of(attempt))
        if (moment.what.find("largest tension") != std::string::npos) {
            EXPECT_LE(moment.time, 30);
        }
    EXPECT_EQ(json_of(attempt)["lesson_over"], 30);
    const std::string page = page_of(attempt, {});
    EXPECT_THAT(page, HasSubstr("<dt>What counts</dt><dd>0:00 to 0:30, when the lesson was over"));
    const std::string after = "<h3>After the lesson&#39;s end, at 0:30</h3>";
    EXPECT_EQ(count(page, after), 2) << "key moments and reports";
    EXPECT_GT(page.find("wrong report: "), page.find(after));
    EXPECT_LT(page.find("anchor on the bottom"), page.find(after));
}

TEST(DebriefTest, CurvesEndHalfAMinuteAfterTheLesson) {
    const Folder folder;
    Attempt attempt = attempt_of(folder);
    attempt.assessment->time(1);  // and the exercise went on for a minute: the peak at 0:31.37 came then
    const auto last_drawn = [&] { // px: the rightmost point of the lines of the first plot
        const std::string page = page_of(attempt, {});
        const auto from = page.find("<g class=\"lines\" clip-path=\"url(#port0-clip)\">");
        const std::string lines = page.substr(from, page.find("</g>", from) - from);
        static const std::regex point(R"([ML]([0-9.]+) )");
        double last = 0;
        for (std::sregex_iterator each(lines.begin(), lines.end(), point), none; each != none; ++each)
            last = std::max(last, std::stod((*each)[1]));
        return last;
    };
    const std::string page = page_of(attempt, {});
    EXPECT_THAT(page, HasSubstr("The curves end at 0:31, 30 s after the lesson"));
    EXPECT_THAT(page, HasSubstr("tension at the hawse pipe lip: largest 4.09 t at 0:01, least"));
    const double cut = last_drawn();
    attempt.assessment->time(20); // the plot stays a minute wide
    EXPECT_THAT(page_of(attempt, {}), HasSubstr("largest 4.28 t at 0:20"));
    EXPECT_NEAR(last_drawn() - cut, width_of(19, 0, 60), width_of(0.5, 0, 60));
    attempt.assessment->time(40);
    EXPECT_THAT(page_of(attempt, {}), Not(HasSubstr("The curves end")));
    EXPECT_THAT(page_of(attempt, {}), HasSubstr("largest 75 t at 0:31"));
}

TEST(DebriefTest, PageNeedsNothingBesideItself) {
    const Folder folder;
    const Attempt attempt = attempt_of(folder);
    const std::string page = page_of(attempt, {});
    for (const char* outside : {"<script", "<link", "<img", "src=", "@import", "http:", "https:", "url(http"})
        EXPECT_THAT(page, Not(HasSubstr(outside)));
    EXPECT_THAT(page, HasSubstr("<html lang=\"en\">"));
    EXPECT_THAT(page, Not(HasSubstr("let-go <port>"))) << "a name from a file is text, not markup";
    EXPECT_THAT(page, HasSubstr("let-go &lt;port&gt; &amp; &quot;25m&quot;"));
    EXPECT_THAT(page, HasSubstr("never &lt;told&gt;"));
}

TEST(DebriefTest, WhatAReasonSaysWasLostStandsInTheColumnBesideIt) {
    const Folder folder;
    Attempt attempt = attempt_of(folder);
    for (const char* cost : {"80 % of its points lost", "all of its points lost", "12.0 of 15 points lost"}) {
        attempt.assessment->criteria()[1].reason(std::string("0:41 too fast: ") + cost + "; a must");
        EXPECT_THAT(page_of(attempt, {}), HasSubstr("0:41 too fast; a must")) << cost;
    }
}

TEST(DebriefTest, EveryElementIsClosedAndEveryIdStandsOnce) {
    const Folder folder;
    const Attempt attempt = attempt_of(folder), other = attempt_of(folder, {.let_go = 15}, "tuesday");
    const std::string page = page_of(
        attempt, {.links = {.kind = Links::Kind::beside, .station = {}, .token = {}}, .over = {&other}});
    static const std::regex tag(R"(<(/?)([a-zA-Z0-9]+)[^>]*?(/?)>)");
    std::vector<std::string> open;
    for (std::sregex_iterator at(page.begin(), page.end(), tag), end; at != end; ++at) {
        const std::string name = (*at)[2];
        if (name == "meta" || (*at)[3] == "/") continue;
        if ((*at)[1] != "/") {
            open.push_back(name);
            continue;
        }
        ASSERT_FALSE(open.empty()) << name;
        ASSERT_EQ(open.back(), name);
        open.pop_back();
    }
    EXPECT_THAT(open, IsEmpty());
    std::set<std::string> ids;
    static const std::regex id("id=\"([^\"]*)\"");
    for (std::sregex_iterator at(page.begin(), page.end(), id), end; at != end; ++at)
        EXPECT_TRUE(ids.insert((*at)[1]).second) << (*at)[1] << " stands twice";
    EXPECT_EQ(count(page, "<svg "), count(page, "<title id=")) << "each picture has a title";
    EXPECT_EQ(count(page, "<svg "), count(page, "<desc id="));
    EXPECT_EQ(count(page, "<svg "), count(page, "<details>") + 1)
        << "and its table, but for the key of tensions";
    EXPECT_EQ(count(page, "<h1>"), 1);
}

TEST(DebriefTest, PointsLostAreTheShareOfTheCriteriaInPlay) {
    const Folder folder;
    const Attempt attempt = attempt_of(folder);
    const Judgement judgement = judgement_of(attempt);
    const auto lost = judgement.deductions();
    ASSERT_THAT(lost, SizeIs(2));
    EXPECT_EQ(lost[0].criterion->code(), "fall");
    EXPECT_NEAR(lost[0].points, 30, 1e-9); // 15 of 50
    EXPECT_NEAR(lost[0].lost, 24, 1e-9);   // eight tenths of it
    EXPECT_NEAR(lost[0].time, 33, 1e-9) << "where it first went wrong, not where it was decided";
    EXPECT_NEAR(lost[1].lost, 10, 1e-9);
    EXPECT_NEAR(100 - lost[0].lost - lost[1].lost, attempt.assessment->score(), 1e-9);
    const std::string page = page_of(attempt, {});
    EXPECT_THAT(page, HasSubstr("66.0 of 100 points, not yet"));
    EXPECT_THAT(page, HasSubstr("24.0 of 30.0"));
    EXPECT_THAT(page, HasSubstr("6.0 of 30.0")) << "among all criteria what it earned, in the same points";
    EXPECT_THAT(page, HasSubstr("0:41 port cable 414 m/min, 5.5 allowed"));
    ASSERT_THAT(judgement.strongest(3), SizeIs(1));
    EXPECT_EQ(judgement.strongest(3)[0].criterion->code(), "clutch");
}

// Marks and scores of two strangers' attempts at L01, as the server had given them.
TEST(DebriefTest, DeductionsComeToTheScoreWithWhatOnlyGuardsAndWhatIsHalved) {
    const auto reckoned = [](double score,
                             const std::vector<std::tuple<bool, unsigned, unsigned>>& criteria) {
        Attempt attempt;
        Assessment& marks = attempt.assessment.emplace();
        marks.finished(true);
        marks.score(score);
        for (const auto& [deed, weight, milli] : criteria) {
            auto& one = marks.criteria().emplace_back(
                test::criterion("one", CRITERION_STATE_AT, CRITERION_MET, weight, milli, "", 1, ""));
            one.deed(deed);
        }
        const auto of = reckoning_of(attempt, judgement_of(attempt));
        return of ? (100 - of->lost - of->unearned) / (of->halved ? 2 : 1) : -1;
    };
    constexpr double kRounded = 0.1; // the marks are told in whole per cent, the score in tenths
    EXPECT_NEAR(reckoned(85.2, {{false, 5, 1000},
                                {false, 10, 580},
                                {false, 15, 1000},
                                {false, 10, 1000},
                                {false, 5, 1000},
                                {true, 15, 1000},
                                {true, 15, 1000},
                                {true, 10, 1000},
                                {true, 15, 753},
                                {true, 6, 500},
                                {false, 5, 1000},
                                {true, 8, 1000},
                                {true, 4, 0},
                                {true, 10, 1000},
                                {true, 5, 1000}}),
                85.2, kRounded);
    EXPECT_NEAR(reckoned(22.4, {{false, 5, 1000},
                                {false, 10, 1000},
                                {false, 15, 1000},
                                {false, 10, 1000},
                                {false, 5, 1000},
                                {true, 15, 0},
                                {true, 15, 0},
                                {true, 15, 945},
                                {true, 6, 1000},
                                {false, 5, 1000},
                                {true, 8, 1000},
                                {true, 4, 0}}),
                22.4, kRounded);
    EXPECT_EQ(reckoned(70, {{true, 1, 1000}, {true, 1, 0}}), -1) << "50 or 25 would be so";
}

TEST(DebriefTest, MustThatItNeverCameToCostsItsPointsAndWentWrongAtNoMoment) {
    const Folder folder;
    Attempt attempt = attempt_of(folder);
    Criterion& never = attempt.assessment->criteria()[3];
    never.must(true);
    never.counts(true);
    never.deed(true);
    never.tick(attempt.assessment->tick());
    attempt.assessment->score(15.5); // (30 + 3 * 30 / 85) / 2
    const Judgement judgement = judgement_of(attempt);
    ASSERT_THAT(judgement.deductions(), SizeIs(3));
    EXPECT_EQ(judgement.deductions()[2].criterion->code(), "later");
    EXPECT_NEAR(judgement.deductions()[2].lost, 50, 1e-9);
    const auto reckoning = reckoning_of(attempt, judgement);
    ASSERT_TRUE(reckoning);
    EXPECT_TRUE(reckoning->halved);
    const auto wrong = went_wrong(attempt, judgement);
    ASSERT_TRUE(wrong);
    EXPECT_EQ(wrong->criterion->code(), "fall") << "no must, and the first that went wrong";
    for (const Moment& moment : moments_of(attempt))
        EXPECT_THAT(moment.what, Not(AllOf(HasSubstr("not met"), HasSubstr("later"))));
}

TEST(DebriefTest, WhatHalvedThePointsIsTold) {
    const Folder folder;
    Attempt attempt = attempt_of(folder);
    Assessment& marks = *attempt.assessment;
    marks.objectives({test::objective("ready", "achieved", 100), test::objective("late", "not_shown", 0)});
    marks.score(32.6); // half of 60 and 6 * 60 / 70
    EXPECT_THAT(why_halved(attempt), IsEmpty());
    marks.ending(LESSON_TIME_UP);
    marks.abort("time is up");
    EXPECT_THAT(why_halved(attempt), IsEmpty());
    marks.abort("the bridge was told what is not so when it asked \"how much port cable is out?\"");
    EXPECT_THAT(page_of(attempt, {}),
                HasSubstr("Halved, since the bridge was told what is not so when it asked "
                          "&quot;how much port cable is out?&quot;: 32.6."));
    marks.criteria()[1].must(true);
    marks.criteria()[3].must(true); // it never came to that
    marks.objectives({test::objective("ready", "achieved", 100), test::objective("run", "not_yet", 49.9)});
    marks.abort("the bridge heard nothing");
    EXPECT_THAT(page_of(attempt, {}),
                HasSubstr("Halved, since a criterion marked (must) was missed, a criterion marked (must) was "
                          "not come to, an objective has less than half of its points and the bridge heard "
                          "nothing: 32.6."));
}

TEST(DebriefTest, PointsThatHaveNotPassedDoNotReadAsIfTheyHad) {
    EXPECT_EQ(points_text(69.96), "69.9");
    EXPECT_EQ(points_text(0.1 * 696), "69.6");
    EXPECT_EQ(points_text(70), "70.0");
    EXPECT_EQ(share_text(6.25), "6.3") << "of a criterion, as pages have it";
    EXPECT_EQ(share_text(10.86), "10.9");
    for (int tenths = 0; tenths <= 1000; ++tenths)
        ASSERT_EQ(points_in_tenths(0.1 * tenths), tenths);
    const Folder folder;
    Attempt attempt = attempt_of(folder);
    attempt.assessment->criteria()[1].must(true);
    attempt.assessment->criteria()[1].counted(499); // a must is met from 500 on
    EXPECT_THAT(page_of(attempt, {}), HasSubstr(">49 %<"));
    EXPECT_EQ((LaterWord{.by = "bo", .points = 69.96, .outcome = "not_yet", .note = {}}.stands()),
              "69.9 points, not yet");
}

TEST(DebriefTest, WhatOnlyGuardsIsNotPraised) {
    const Folder folder;
    Attempt attempt = attempt_of(folder);
    EXPECT_THAT(page_of(attempt, {}), HasSubstr("What went well"));
    attempt.assessment->criteria()[0].deed(false); // the clutch was out from the beginning
    EXPECT_THAT(page_of(attempt, {}), Not(HasSubstr("What went well")));
}

TEST(DebriefTest, PracticeSaysSoWithItsHintsAndPassesAndFailsNobody) {
    const Folder folder;
    Attempt attempt = attempt_of(folder);
    EXPECT_EQ(practice_words(attempt), "");
    EXPECT_THAT(page_of(attempt, {}), Not(HasSubstr("practice")));
    attempt.assessment->practice(true);
    EXPECT_EQ(practice_words(attempt), "for practice, 0 hints");
    HintGiven hint;
    hint.tick(attempt.assessment->criteria()[1].tick());
    hint.id("too-fast");
    hint.criterion("fall");
    hint.forecastle(true);
    hint.text("She runs too fast.");
    attempt.assessment->hints({hint});
    const std::string page = page_of(attempt, {});
    EXPECT_THAT(page, HasSubstr("for practice, 1 hint: it is no test of competence"));
    EXPECT_THAT(page, HasSubstr("She runs too fast."));
    EXPECT_THAT(page, HasSubstr("(hinted)"));
    EXPECT_TRUE(was_hinted(attempt, attempt.assessment->criteria()[1]));
    EXPECT_FALSE(was_hinted(attempt, attempt.assessment->criteria()[0]));
    std::vector<std::string> verbs;
    for (const auto& each : xapi_of(attempt, {"https://school.example/accounts", "trainee-17"})) {
        const std::string verb = each["verb"]["id"];
        verbs.push_back(verb.substr(verb.rfind('/') + 1));
        if (verbs.back() != "experienced") continue;
        EXPECT_EQ(each["result"]["response"], "for practice, 1 hint");
        EXPECT_FALSE(each["result"].contains("success"));
        EXPECT_EQ(each["result"]["extensions"]["urn:windlass:extension:hints"], 1);
    }
    EXPECT_THAT(verbs, ElementsAre("initialized", "completed", "experienced", "terminated"));
}

TEST(DebriefTest, WhatWouldHaveKeptALostPointStandsBesideItWithTheMomentBefore) {
    const Folder folder;
    const Attempt attempt = attempt_of(folder);
    EXPECT_THAT(page_of(attempt, {}), Not(HasSubstr("what would have kept it"))) << "where nobody searched";
    const std::string page =
        page_of(attempt, {.links = {.kind = Links::Kind::beside, .station = {}, .token = {}},
                          .remedies = std::vector<Remedy>{{"fall", 31.4, "0:31.4 the wheel <hard> on"}}});
    EXPECT_THAT(page, HasSubstr("<th scope=\"col\">what would have kept it</th>"));
    EXPECT_THAT(page, HasSubstr("0:31.4 the wheel &lt;hard&gt; on Do it again from <a href=\"/replay?"));
    EXPECT_THAT(page, HasSubstr(">0:21</a>."));
}

TEST(DebriefTest, BothScenesOfAnAnswerStandSideBySideWhereTheyAreNotTheSame) {
    const Folder folder;
    const Attempt attempt = attempt_of(folder);
    const auto scene = [](double cable_out) {
        SceneAt made{.time = 61, .ship = ShipState(), .chains = {}, .anchors = {}};
        made.ship->attitude().w(1);
        ChainState& chain = made.chains[0].emplace();
        chain.cable_out(cable_out);
        for (const float z : {6.0F, -25.0F})
            chain.nodes().emplace_back().z(z);
        chain.tension() = std::vector<float>(1, 50e3F);
        return made;
    };
    const auto page = [&](double was, double would) {
        Remedy remedy{"fall", 31.4, "0:31.4 the wheel hard on"};
        remedy.was = scene(was);
        remedy.would = scene(would);
        return page_of(attempt, {.links = {}, .remedies = std::vector<Remedy>{remedy}});
    };
    EXPECT_THAT(page(88, 55),
                testing::ContainsRegex("<div class=\"pair\">\n<figure><p>As it was</p>.*: 88 m .*"
                                       "<figure><p>As it would have been</p>.*: 55 m "));
    EXPECT_THAT(page(88, 88), HasSubstr("Ship, cable and anchor stand the same in both at 1:01"));
    EXPECT_THAT(page(88, 88), Not(HasSubstr("class=\"pair\"")));
}

TEST(DebriefTest, SceneWithTheAnchorHomeTellsNoCableOutAndNoLead) {
    SceneAt scene{.time = 61, .ship = ShipState(), .chains = {}, .anchors = {}};
    scene.chains[0].emplace().cable_out(-3);
    scene.chains[0]->lead_clock(10);
    scene.chains[0]->stay(STAY_MEDIUM);
    scene.anchors[0].emplace().phase(ANCHOR_HOUSED);
    EXPECT_THAT(scene_words(scene, SIDE_PORT), testing::StartsWith("Port: anchor home. Ship "));
    scene.chains[0]->cable_out(80);
    scene.anchors[0]->phase(ANCHOR_HOLDING);
    EXPECT_THAT(scene_words(scene, SIDE_PORT), HasSubstr("leads 10 o'clock, medium stay"));
}

TEST(DebriefTest, BothCoursesOfAnAnswerStandUnderTheDeductionsWithTheirMomentsAndLimits) {
    const Folder folder;
    const Attempt attempt = attempt_of(folder);
    const Remedy moved{.criterion = "fall",
                       .time = 31.4,
                       .words = "0:31.4 the wheel hard on",
                       .changed = 31.4,
                       .lost = 33,
                       .courses = {{.title = "cable's speed",
                                    .unit = "m/s",
                                    .was = {{20, 2}, {33, 6.9}, {50, 0}},
                                    .would = {{20, 2}, {33, 3.1}, {50, 0}},
                                    .least = {},
                                    .most = 5.5}}};
    const Remedy said{
        .criterion = "report", .time = 40, .words = "reported", .changed = 40, .lost = 50, .only_said = true};
    const std::string page = page_of(attempt, {.links = {}, .remedies = std::vector<Remedy>{moved, said}});
    EXPECT_THAT(page, HasSubstr("<h4>fall: cable&#39;s speed</h4>"));
    for (const char* part : {">as it was</text>", ">as it would have been</text>", ">at most 5.5 m/s</text>",
                             ">changed</text>", ">lost</text>", "As it was: largest 6.9 m/s at 0:33",
                             "As it would have been: largest 3.1 m/s at 0:33", "the change is one of words"})
        EXPECT_THAT(page, HasSubstr(part));
    EXPECT_EQ(count(page, "<svg "), count(page, "<details>") + 1) << "each with its table";
}

TEST(DebriefTest, OneGoesBackToTheFirstMustThatWasMissedButNotToTheEndOfTheTime) {
    Attempt attempt;
    attempt.dt = 1.0 / test::kTickRate;
    attempt.ended = 100;
    Assessment& marks = attempt.assessment.emplace();
    const auto lost = [&](const char* code, bool must, double time) {
        auto& mark = marks.criteria().emplace_back(
            test::criterion(code, CRITERION_STATE_AT, CRITERION_NOT_MET, 10, 0, "", time, ""));
        mark.must(must);
    };
    const auto back_to = [&] {
        const auto mark = went_wrong(attempt, judgement_of(attempt));
        return mark ? name_of(*mark->criterion) : "";
    };
    marks.ending(LESSON_TIME_UP);
    EXPECT_EQ(back_to(), "");
    lost("secured", true, 100);
    EXPECT_EQ(back_to(), "") << "ten seconds before the time was up there is nothing to be done";
    lost("report", false, 20);
    EXPECT_EQ(back_to(), "report");
    lost("brake", true, 50);
    EXPECT_EQ(back_to(), "brake");
    marks.criteria().pop_back();
    marks.ending(LESSON_BROKEN_OFF);
    EXPECT_EQ(back_to(), "secured") << "broken off by what went wrong then";
}

// A wheel that is spun open is sent twenty times a second, and the station repeats where its levers stand.
TEST(DebriefTest, LeversThatGoOnTheSameWayAreMovedOnce) {
    Attempt attempt;
    AttemptReader reader(attempt, 1);
    attempt.dt = 0.01;
    std::uint64_t tick = 0;
    const auto brake = [&](const char* by, double at, std::uint64_t ticks_later) {
        OrderTaken order;
        order.tick(tick += ticks_later);
        order.source() = by;
        order.kind(ORDER_TAKEN_WINDLASS);
        order.windlass().brake(at);
        reader.add(order);
    };
    const auto moves = [&](const char* by) { return attempt.hands[by].windlass; };
    brake("ben", 1, 0);
    for (int i = 1; i <= 20; ++i) {
        brake("ben", 1 - i / 20.0, 5);
        brake("ben", 1 - i / 20.0, 1);
    }
    EXPECT_EQ(moves("ben"), 2) << "taken in hand, and opened";
    for (int i = 1; i <= 10; ++i)
        brake("ben", i / 20.0, 5);
    EXPECT_EQ(moves("ben"), 3) << "and screwed on at once";
    brake("ben", 0.6, 100);
    EXPECT_EQ(moves("ben"), 4) << "and after a rest";
    brake("anna", 0.7, 5);
    EXPECT_EQ(moves("ben"), 4);
    EXPECT_EQ(moves("anna"), 1);
    EXPECT_EQ(attempt.lever_moves.size(), 33U) << "the strip under the plots has each";
}

TEST(DebriefTest, WhatTheInstructorWasShownAheadIsTold) {
    Attempt attempt;
    AttemptReader reader(attempt, 1);
    attempt.dt = 0.01;
    attempt.ended = 100;
    const auto predict = [&](double time, double of_event) {
        Prediction prediction;
        prediction.time(time);
        prediction.state(PREDICTION_WHOLE);
        prediction.moments().emplace_back();
        if (of_event > 0) {
            Event& event = prediction.events().emplace_back();
            event.code("brake.lining_burns");
            event.text("lining burns");
            event.time(of_event);
        }
        reader.add(prediction);
    };
    EXPECT_EQ(page_of(attempt, {}).find("A minute ahead"), std::string::npos) << "nobody asked";
    predict(20, 0);
    predict(22, 61);
    predict(24, 62);
    const auto off = [&](double time) {
        Prediction prediction;
        prediction.time(time);
        prediction.state(PREDICTION_OFF);
        reader.add(prediction);
    };
    predict(48, 0); // on a machine that is busy they come rarely
    off(50);
    predict(50.2, 0);
    off(50.4);
    predict(70, 95); // asked for again later
    off(72);
    const std::string page = page_of(attempt, {});
    EXPECT_THAT(page, HasSubstr("Predictions were shown from 0:20 to 0:50, from 1:10 to 1:12"));
    ASSERT_EQ(attempt.foreseen.size(), 2U);
    EXPECT_EQ(attempt.foreseen[0].told, 22);
    EXPECT_EQ(attempt.foreseen[0].last_told, 24);
    EXPECT_EQ(attempt.foreseen[0].event.time(), 61) << "as it was told first";
    EXPECT_THAT(page, HasSubstr("0:24</td>"));
    EXPECT_THAT(page, HasSubstr("lining burns"));
}

// One judge: whatever the marks are, the outcome of an objective is the server's.
TEST(DebriefTest, ObjectivesAreAsTheServerHasJudgedThem) {
    const Folder folder;
    Attempt attempt = attempt_of(folder);
    const auto all = achievements_of(attempt);
    ASSERT_THAT(all, SizeIs(3));
    EXPECT_EQ(all[0].text, "objective ready");
    EXPECT_EQ(all[0].outcome, "achieved");
    EXPECT_EQ(all[1].id, "run");
    EXPECT_EQ(all[1].outcome, "not_yet");
    EXPECT_NEAR(all[1].score, 15, 1e-9);
    EXPECT_EQ(all[2].outcome, "not_shown");
    Assessment& marks = *attempt.assessment;
    marks.outcome("achieved");
    marks.objectives({test::objective("run", "achieved", 75)});
    marks.criteria()[1].must(true);
    marks.criteria()[1].milli(500);
    marks.criteria()[1].counted(500);
    marks.criteria()[1].met(true); // a must is met from half on
    marks.criteria()[1].state(CRITERION_MET);
    marks.criteria({marks.criteria()[0], marks.criteria()[1]});
    const std::string page = page_of(attempt, {});
    EXPECT_THAT(page, HasSubstr("points, achieved"));
    EXPECT_THAT(page, HasSubstr("An objective is achieved when its criteria marked (must) are met"))
        << "by which rule";
    EXPECT_THAT(page, Not(HasSubstr("not yet"))) << "not above, not below";
    for (const auto& statement : xapi_of(attempt, {"urn:here", "t1"}))
        EXPECT_FALSE(statement["verb"]["display"]["en"] == "failed") << statement;
}

TEST(DebriefTest, UnfinishedAssessmentPassesAndFailsNobody) {
    const Folder folder;
    Attempt attempt = attempt_of(folder);
    attempt.assessment->finished(false);
    attempt.assessment->outcome("");
    for (ObjectiveMark& each : attempt.assessment->objectives())
        each.outcome("");
    EXPECT_THAT(page_of(attempt, {}), HasSubstr("66.0 of 100 points, not finished"));
    for (const Achievement& each : achievements_of(attempt))
        EXPECT_EQ(each.outcome, "") << each.id;
    for (const auto& statement : xapi_of(attempt, {"urn:here", "t1"}))
        EXPECT_FALSE(statement["verb"]["display"]["en"] == "failed");
}

TEST(DebriefTest, CriterionWithoutAReasonToMatterIsCalledByItsCode) {
    Criterion criterion;
    criterion.code("reports-brought-up");
    EXPECT_EQ(title_of(criterion), "reports brought up");
    criterion.text("So the master knows");
    EXPECT_EQ(title_of(criterion), "reports brought up: So the master knows");
}

TEST(DebriefTest, AnAssessorsWordStandsBesideTheComputedMark) {
    const Folder folder;
    Attempt attempt = attempt_of(folder);
    AssessorWord word{.time = 70, .by = "instructor-1", .command = {}};
    word.command.criterion("fall");
    word.command.verdict(VERDICT_MET);
    word.command.note("the counter had failed");
    attempt.words = {word};
    Criterion& fall = attempt.assessment->criteria()[1]; // as the server has it after that word
    fall.state(CRITERION_OVERRIDDEN);
    fall.counted(1000);
    fall.met(true);
    const auto lost = judgement_of(attempt).deductions();
    ASSERT_THAT(lost, SizeIs(1));
    EXPECT_EQ(lost[0].criterion->code(), "report");
    EXPECT_EQ(json_of(attempt)["assessment"]["criteria"][1]["milli_computed"], 200);
    EXPECT_EQ(json_of(attempt)["assessment"]["criteria"][1]["milli"], 1000);
    EXPECT_EQ(json_of(attempt)["assessment"]["criteria"][1]["assessor"]["by"], "instructor-1");
}

TEST(DebriefTest, ExerciseThatWasEndedEarlyIsConfirmedByNobody) {
    const Folder folder;
    Attempt attempt = attempt_of(folder);
    AssessorWord word{.time = 60, .by = "server", .command = {}};
    word.command.verdict(VERDICT_ENDED);
    word.command.note("exercise ended: set duration");
    attempt.words = {word};
    attempt.assessment->ending(LESSON_ENDED_EARLY);
    attempt.assessment->abort("ended before its lesson was done");
    EXPECT_EQ(ended_by(attempt), "instructor");
    EXPECT_TRUE(json_of(attempt)["assessment"]["confirmed_by"].is_null());
    const std::string page = page_of(attempt, {});
    EXPECT_THAT(page, Not(HasSubstr("Confirmed")));
    EXPECT_THAT(page, HasSubstr("<dd>ended before its lesson was done</dd>"));
    word.by = "Ann";
    word.command.verdict(VERDICT_CONFIRMED);
    attempt.words.push_back(word);
    EXPECT_THAT(page_of(attempt, {}), HasSubstr("Confirmed by Ann"));
}

TEST(DebriefTest, WithoutMarksThePageSaysSo) {
    const Folder folder;
    const Attempt attempt = attempt_of(folder, {.assessed = false});
    EXPECT_FALSE(attempt.assessment);
    EXPECT_THAT(page_of(attempt, {}), HasSubstr("Nothing was assessed"));
    EXPECT_TRUE(json_of(attempt)["assessment"].is_null());
    std::vector<std::string> verbs;
    for (const auto& statement : xapi_of(attempt, {"urn:here", "t1"}))
        verbs.push_back(statement["verb"]["display"]["en"]);
    EXPECT_THAT(verbs, ElementsAre("initialized", "completed", "terminated")) << "neither passed nor failed";
}

TEST(DebriefTest, ReportsHaveTheTruthThatTheServerHasJudgedThemBy) {
    const Folder folder;
    const auto reports = reports_said(attempt_of(folder));
    ASSERT_THAT(reports, SizeIs(2)); // a repeat-back is none
    EXPECT_NEAR(*reports[0].delay, 7, 1e-9);
    EXPECT_EQ(reports[0].truth, "7.0 s after it was so, at 0:20");
    EXPECT_EQ(reports[0].milli, 1000U);
    EXPECT_EQ(reports[1].value, 2);
    EXPECT_EQ(*reports[1].true_value, 1.96);
    EXPECT_EQ(reports[1].truth, "1.96 were so");
    EXPECT_EQ(reports[1].milli, 0U);
}

TEST(DebriefTest, ReportThatNobodyJudgesHasTheCableBesideItAndNoVerdict) {
    const Folder folder;
    const auto reports = reports_said(attempt_of(folder, {.assessed = false}));
    ASSERT_THAT(reports, SizeIs(2));
    EXPECT_EQ(reports[0].truth, "anchor on the bottom");
    EXPECT_EQ(reports[1].truth, "2.17 shackles from the lip were so"); // 5 m and 27.4 s of 2 m/s
    EXPECT_FALSE(reports[1].true_value || reports[1].milli || reports[1].delay);
}

TEST(DebriefTest, FalseReportThatNoCriterionAsksForHasTheCableBesideItAndNoVerdict) {
    const Folder folder;
    Attempt attempt = attempt_of(folder);
    for (JudgedReport& one : attempt.assessment->reports())
        one.criterion("");
    const auto reports = reports_said(attempt);
    ASSERT_THAT(reports, SizeIs(2));
    EXPECT_EQ(reports[0].truth, "anchor on the bottom");
    EXPECT_FALSE(reports[1].true_value || reports[1].milli || reports[1].delay);
}

TEST(DebriefTest, OrderSaysWhenItWasCarriedOut) {
    const Folder folder;
    Attempt attempt = attempt_of(folder);
    EXPECT_EQ(orders_said(attempt)[0].done, 14.0);
    EXPECT_THAT(page_of(attempt, {}), HasSubstr(">carried out</th>"));
    EXPECT_THAT(csv_of(attempt), HasSubstr("carried out at 0:14"));
    attempt.assessment->orders()[0].tick(0);
    EXPECT_FALSE(orders_said(attempt)[0].done);
    EXPECT_THAT(page_of(attempt, {}), HasSubstr(">not</td>"));
    attempt.assessment->orders().clear(); // given by hand, of no lesson
    EXPECT_FALSE(orders_said(attempt)[0].judged);
    EXPECT_THAT(page_of(attempt, {}), Not(HasSubstr(">not</td>")));
}

TEST(DebriefTest, MomentsAreWhatWasJudgedWrongAndWhatTheServerWarnedOf) {
    const Folder folder;
    Attempt attempt = attempt_of(folder);
    attempt.assessment->orders()[0].tick(0);
    Event foul;
    foul.time(40);
    foul.code("anchor.fouled");
    foul.text("the anchor is foul");
    foul.severity(EVENT_WARNING);
    foul.side(SIDE_PORT);
    attempt.events.push_back(foul);
    std::string all;
    for (const Moment& moment : moments_of(attempt))
        all += fmt::format("{:.0f} {}\n", moment.time, moment.what);
    EXPECT_THAT(all, HasSubstr("33 not met: fall"));
    EXPECT_THAT(all, HasSubstr("8 order not carried out: "));
    EXPECT_THAT(all, HasSubstr("38 wrong report: ")); // 37.5
    EXPECT_THAT(all, HasSubstr("the anchor is foul"));
    EXPECT_THAT(all, HasSubstr("anchor on the bottom"));
    EXPECT_THAT(all, Not(HasSubstr("not met: later"))) << "it was not shown";
}

TEST(DebriefTest, WhatWentWellIsSaidByWhatWasSo) {
    const Folder folder;
    const std::string page = page_of(attempt_of(folder), {});
    EXPECT_THAT(page, HasSubstr("<li>clutch: 0:09 clutch out</li>")) << "not the warning: criterion clutch";
    EXPECT_THAT(page, HasSubstr("5.5 m/s</td>"));
}

TEST(DebriefTest, ModelsOwnEventsAreForEngineers) {
    const Folder folder;
    EXPECT_THAT(page_of(attempt_of(folder), {}), Not(HasSubstr("model.steps")));
}

TEST(DebriefTest, OrdersHaveTheDelayOfTheirRepeatBack) {
    const Folder folder;
    const auto orders = orders_said(attempt_of(folder));
    ASSERT_THAT(orders, SizeIs(1));
    EXPECT_NEAR(*orders[0].repeated - orders[0].given, 3.5, 1e-9);
    EXPECT_EQ(orders[0].state, "repeated");
    EXPECT_EQ(orders[0].by, "bridge-1");
    EXPECT_FALSE(orders[0].answered);
}

TEST(DebriefTest, OrderThatWasSaidAgainUntilItWasRepeatedWasRepeatedOnce) {
    const Folder folder;
    Attempt attempt = attempt_of(folder);
    for (const int number : {2, 3}) { // what answers the last answers all of them
        GivenOrder again = attempt.orders[0];
        again.order.number(number);
        again.order.time(9 + number);
        again.order.text("I say again");
        attempt.orders.push_back(again);
    }
    for (SaidReport& said : attempt.reports)
        if (said.report.code() == REPORT_ORDER_REPEATED) {
            said.time = 14;
            said.report.order_number(3);
            said.report.order_code(BRIDGE_ORDER_LET_GO);
        }
    auto orders = orders_said(attempt);
    ASSERT_THAT(orders, SizeIs(3));
    for (const std::size_t early : {0U, 1U}) {
        EXPECT_EQ(orders[early].state, "not repeated, said again");
        EXPECT_FALSE(orders[early].repeated);
    }
    EXPECT_EQ(orders[2].state, "repeated");
    EXPECT_EQ(orders[2].repeated, 14.0);
    EXPECT_THAT(page_of(attempt, {}), HasSubstr(">not repeated, said again</td>"));

    for (SaidReport& said : attempt.reports)
        if (said.report.code() == REPORT_ORDER_REPEATED) said.report.order_number(2);
    orders = orders_said(attempt);
    EXPECT_EQ(orders[0].state, "not repeated, said again");
    EXPECT_EQ(orders[1].repeated, 14.0);
    EXPECT_EQ(orders[2].state, "repeated");
    EXPECT_EQ(orders[2].repeated, 14.0) << "who repeated it named the one before";
}

TEST(DebriefTest, OrderOfWhatWasSoAlreadyTookNoTime) {
    const Folder folder;
    Attempt attempt = attempt_of(folder);
    EXPECT_THAT(page_of(attempt, {}), Not(HasSubstr("so already")));
    attempt.orders[0].order.time(20); // carried out at 14 s
    EXPECT_THAT(page_of(attempt, {}), HasSubstr(">so already</td>"));
}

TEST(DebriefTest, OrderThatWasSaidAgainWasCarriedOutOnceAndNotBeforeItWasGiven) {
    const Folder folder;
    Attempt attempt = attempt_of(folder); // given at 8 s, carried out at 14 s
    for (const int number : {2, 3}) {
        GivenOrder again = attempt.orders[0];
        again.order.number(number);
        again.order.time(number == 2 ? 11 : 17);
        again.order.text("I say again");
        attempt.orders.push_back(again);
    }
    attempt.assessment->orders()[0].number(3); // as the server calls it
    const auto orders = orders_said(attempt);
    ASSERT_THAT(orders, SizeIs(3));
    EXPECT_FALSE(orders[0].judged || orders[0].done) << "that time had passed";
    EXPECT_EQ(orders[1].done, 14.0);
    EXPECT_FALSE(orders[2].judged || orders[2].done);
    EXPECT_EQ(orders[2].done_before, 14.0);
    EXPECT_THAT(page_of(attempt, {}), HasSubstr(", before it was said again</td>"));
    EXPECT_THAT(csv_of(attempt), HasSubstr("carried out at 0:14, before it was said again"));
    attempt.assessment->orders()[0].tick(test::tick_at(1)); // so already
    EXPECT_EQ(orders_said(attempt)[0].done, 1.0) << "the first time that it was given";
    EXPECT_EQ(orders_said(attempt)[1].done_before, 1.0);
}

// The cable stands at 5 m when it is ordered, and at 57 m from 40 s on. A lesson that leaves the length to
// the bridge takes the first for done, and knows of no second order.
TEST(DebriefTest, OrderToPayOutIsCarriedOutWhenThatLengthStandsOut) {
    const Folder folder;
    Attempt attempt = attempt_of(folder);
    auto& truths = attempt.sides[SIDE_PORT].truths;
    std::erase_if(truths, [](const Truth& truth) { return truth.time > 40; });
    for (double time = 40.1; time < 60; time += 0.1)
        truths.push_back({.time = time, .cable_out = 57});
    const auto give = [&](std::size_t place, double time, double shackles) {
        BridgeOrder& order = attempt.orders[place].order;
        order.number(static_cast<int>(place) + 1);
        order.time(time);
        order.code(BRIDGE_ORDER_PAY_OUT);
        order.side(SIDE_PORT);
        order.value(shackles);
    };
    attempt.orders.resize(2, attempt.orders[0]);
    give(0, 8, 2);
    give(1, 50, 6);
    attempt.assessment->orders()[0].tick(test::tick_at(8.01));
    const auto orders = orders_said(attempt);
    ASSERT_TRUE(orders[0].done);
    EXPECT_NEAR(*orders[0].done, 40.1, 0.11);
    EXPECT_TRUE(orders[1].judged);
    EXPECT_FALSE(orders[1].done);
    for (Truth& truth : truths)
        if (truth.time > 43 && truth.time < 45) truth.cable_speed = 0.3;
    EXPECT_NEAR(orders_said(attempt)[0].done.value_or(0), 45, 0.11) << "eased once more";
    give(0, 8, 6); // and never came to that
    give(1, 50, 2);
    EXPECT_TRUE(orders_said(attempt)[0].judged);
    EXPECT_FALSE(orders_said(attempt)[0].done);
    EXPECT_NEAR(orders_said(attempt)[1].done.value_or(0), 50, 0.11);
}

TEST(DebriefTest, QuestionIsAnsweredAndNobodyRepeatsIt) {
    const Folder folder;
    Attempt attempt = attempt_of(folder); // shackles are reported at 37.5 s
    attempt.orders.reserve(2);
    BridgeOrder& order = attempt.orders[0].order;
    order.code(BRIDGE_ORDER_HOW_MUCH);
    order.side(SIDE_PORT);
    order.state(ORDER_GIVEN);
    EXPECT_EQ(orders_said(attempt)[0].state, "answered");
    EXPECT_NEAR(orders_said(attempt)[0].answered.value_or(0), 37.5, 1e-9);
    attempt.orders.push_back(attempt.orders[0]);
    attempt.orders[1].order.number(2);
    attempt.orders[1].order.time(20);
    EXPECT_EQ(orders_said(attempt)[0].state, "not answered, asked again");
    EXPECT_EQ(orders_said(attempt)[1].state, "answered");
    EXPECT_THAT(page_of(attempt, {}), Not(HasSubstr("not yet repeated")));
    attempt.orders.resize(1);
    order.code(BRIDGE_ORDER_HOW_GROWING);
    attempt.assessment->orders()[0].tick(0);
    EXPECT_EQ(orders_said(attempt)[0].state, "not answered");
    EXPECT_THAT(page_of(attempt, {}), HasSubstr("not answered: how is the port cable growing?"));
}

// A class that begins again from a moment is told the orders of before, and not what was said to them.
TEST(DebriefTest, QuestionOfBeforeTheMomentThatAnAttemptGoesOnFromIsToldByWhatTheLessonKnows) {
    const Folder folder;
    Attempt attempt = attempt_of(folder);         // shackles are reported at 37.5 s
    BridgeOrder& order = attempt.orders[0].order; // given at 8 s, which the lesson knows as done at 14 s
    order.code(BRIDGE_ORDER_HOW_MUCH);
    order.side(SIDE_PORT);
    order.state(ORDER_GIVEN);
    Event restored;
    restored.time(20);
    restored.code("exercise.restored");
    restored.text("exercise restored to 0:20, paused, from monday at 0:20 by instructor");
    attempt.events.insert(attempt.events.begin(), restored);
    auto row = orders_said(attempt)[0];
    EXPECT_EQ(row.state, "answered");
    EXPECT_EQ(row.answered, 14.0) << "what was reported since is no answer to it";
    attempt.assessment->orders()[0].tick(0);
    EXPECT_EQ(orders_said(attempt)[0].state, "not answered");
    attempt.assessment->orders().clear(); // somebody asked, whom the lesson does not know
    row = orders_said(attempt)[0];
    EXPECT_EQ(row.state,
              "asked before 0:20, from where this goes on; whether it was answered is not told here");
    EXPECT_FALSE(row.answered);
    attempt.assessment->practice(true);
    EXPECT_THAT(page_of(attempt, {}),
                HasSubstr("Orders, questions and points that stand here with an earlier "
                          "time are of before"));
    order.time(25); // asked here
    EXPECT_EQ(orders_said(attempt)[0].state, "answered");
    EXPECT_NEAR(orders_said(attempt)[0].answered.value_or(0), 37.5, 1e-9);
}

// As the seats had them: a briefing of 330 m/min is not talked over in m/s.
TEST(DebriefTest, SentencesOfTheJudgeAreReadInTheUnitsOfTheSeats) {
    EXPECT_EQ(
        in_seat_units(
            "0:16 cable's speed 5.23 m/s, at most 5.5 m/s; cable's speed above 7.5 m/s leaves nothing"),
        "0:16 cable's speed 314 m/min, at most 330 m/min; cable's speed above 450 m/min leaves nothing");
    EXPECT_EQ(in_seat_units("wind north 8 m/s, stream 0.3 m/s; cable between 2 and 4 m/s"),
              "wind north 16 kn, stream 0.6 kn; cable between 120 and 240 m/min");
    EXPECT_EQ(in_seat_units("2.5 m/s ahead. At 3 m/s it is fast."), "4.9 kn ahead. At 3 m/s it is fast.");
    EXPECT_EQ(in_seat_units("cable's speed -0.122 m/s, at least -0.12 m/s"),
              "cable's speed -7.3 m/min, at least -7.2 m/min");
    EXPECT_EQ(in_seat_units("from 20 to 80 kN, not 240 kN/m"), "from 2.0 to 8.2 t, not 240 kN/m");
    EXPECT_EQ(limited_text(5.5, "m/s", "cable_speed"), "330 m/min");
    EXPECT_EQ(limited_text(1.2, "m/s", "ship_speed"), "2.3 kn");
    EXPECT_EQ(limited_text(1.2, "m/s", ""), "1.2 m/s") << "nobody knows whose";
    EXPECT_EQ(limited_text(289e3, "N", "tension"), "29 t");
}

TEST(DebriefTest, FiguresAreThoseOfTheTrade) {
    EXPECT_EQ(figure_text(-0.1028, "shackles"), "-0.1 shackles");
    EXPECT_EQ(figure_text(-0.001, "shackles"), "0 shackles");
    EXPECT_EQ(figure_text(6.974, "shackles"), "6.97 shackles");
    EXPECT_EQ(figure_text(11.7, "h"), "11.5 o'clock");
    EXPECT_EQ(figure_text(0.1, "h"), "12 o'clock");
    EXPECT_EQ(figure_text(308.15, "K"), "35 \u00b0C");
    EXPECT_EQ(figure_text(-400, "N"), "0 kN");
    EXPECT_EQ(figure_text(-1e-5, "m/s"), "0 m/s");
}

TEST(DebriefTest, LimitThatNeverCameIntoPlayHasNoWorst) {
    const Folder folder;
    Attempt attempt = attempt_of(folder);
    Criterion& limit = attempt.assessment->criteria()[1];
    limit.unit("K");
    limit.limit(423);
    EXPECT_THAT(page_of(attempt, {}), HasSubstr(">-266 \u00b0C<")) << "6.9 K";
    limit.milli(0);
    limit.worst(0);
    limit.time_outside(0);
    for (const CriterionState state : {CRITERION_NOT_IN_PLAY, CRITERION_OVERRIDDEN}) {
        limit.state(state);
        EXPECT_THAT(page_of(attempt, {}), Not(HasSubstr(">-273 \u00b0C<")));
        EXPECT_TRUE(json_of(attempt)["assessment"]["criteria"][1]["worst"].is_null());
    }
}

TEST(DebriefTest, PictureOfSeveralMomentsIsOfTheFirstAndSaysWhatCameAfterIt) {
    const Folder folder;
    Attempt attempt = attempt_of(folder);
    for (const auto& [time, side] : {std::pair(45.0, SIDE_PORT), std::pair(47.0, SIDE_STARBOARD)}) {
        Event mark;
        mark.time(time);
        mark.code("exercise.bookmark");
        mark.text("look");
        mark.side(side);
        attempt.events.push_back(mark);
    }
    recording::Recording recording({folder / "monday"});
    read_scenes(recording, attempt);
    EXPECT_THAT(page_of(attempt, {}),
                testing::ContainsRegex("</b> 0:45 [^<]*; not pictured, soon after: <b>[0-9]+</b> 0:47 "));
}

TEST(DebriefTest, MomentsLeadToThePlaceInTheRecording) {
    const Folder folder;
    const Attempt attempt = attempt_of(folder, {.waits = 4});
    const auto moments = moments_of(attempt);
    EXPECT_TRUE(std::ranges::is_sorted(moments, {}, &Moment::time));
    const auto fault = std::ranges::find(moments, 30.0, &Moment::time);
    ASSERT_NE(fault, moments.end());
    EXPECT_THAT(fault->what, HasSubstr("first lever moved 2.5 s later"));
    EXPECT_NEAR(attempt.position_of(30), 34, 0.01) << "it stood ready for 4 s";
    const std::string served =
        page_of(attempt, {.links = {.kind = Links::Kind::beside, .station = {}, .token = {}}, .over = {}});
    EXPECT_THAT(served, HasSubstr("href=\"/replay?recording=monday&amp;t=34.0\""));
    EXPECT_THAT(served, HasSubstr("A time opens the replay there."));
    EXPECT_THAT(served, Not(HasSubstr("recorder control")))
        << "who reads it in a browser goes there by its links, and has no terminal";
    const std::string alone = page_of(attempt, {});
    EXPECT_THAT(alone, Not(HasSubstr("href="))) << "nobody serves it: no link that leads nowhere";
    EXPECT_THAT(alone, HasSubstr("<code>recorder control seek "));
    EXPECT_THAT(alone, HasSubstr("<code>instructor_console restore recordings/monday@"));
}

TEST(DebriefTest, LinksTakeTheAddressThatAStationPrints) {
    const Links links = links_to("http://127.0.0.1:8766/instructor#token=0123abcd");
    EXPECT_EQ(links.to("a b", 3.14159), "http://127.0.0.1:8766/replay?recording=a%20b&t=3.1#token=0123abcd");
    EXPECT_EQ(links_to("http://localhost:8765").to("m", 0), "http://localhost:8765/replay?recording=m&t=0.0");
    for (const char* wrong :
         {"javascript:alert(1)", "127.0.0.1:8765", "http://a/\" onclick=\"x", "file:///etc"})
        EXPECT_THROW(links_to(wrong), std::runtime_error) << wrong;
}

TEST(DebriefTest, OneRunIsNotMixedWithAnother) {
    const Folder folder;
    recorder::Tape tape({.folder = folder / "two"});
    test::write_run(tape, {.run = 7, .peak = 900'000, .waits = 0});
    test::write_run(tape, {.run = 8, .peak = 500'000, .waits = 0}, 61);
    tape.close({});
    const Attempt last = read(folder / "two"), first = read(folder / "two", 1);
    EXPECT_EQ(last.origin.run, 8U);
    EXPECT_NEAR(last.sides[0].curves[kTension].largest()->value * words::units::tonne, 500e3, 1e-6);
    EXPECT_NEAR(first.sides[0].curves[kTension].largest()->value * words::units::tonne, 900e3, 1e-6);
    EXPECT_NE(attempt_id(last), attempt_id(first));
    EXPECT_NEAR(last.position_of(30), 91, 0.01);
    EXPECT_THROW(read(folder / "two", 3), std::runtime_error);
}

TEST(DebriefTest, AnotherAttemptIsAlignedAtLettingGo) {
    const Folder folder;
    const Attempt attempt = attempt_of(folder), other = attempt_of(folder, {.let_go = 16}, "tuesday");
    const Alignment alignment = align(attempt, other);
    EXPECT_NEAR(alignment.shift, -6, 1e-9);
    const std::string page = page_of(attempt, {.links = {}, .over = {&other}});
    EXPECT_THAT(page, HasSubstr("tuesday (aligned at letting go)"));
    EXPECT_THAT(page, HasSubstr("Beside other attempts"));
}

TEST(DebriefTest, CutOffRecordingIsToldAndWhatIsLeftIsUsed) {
    const Folder folder;
    attempt_of(folder);
    const auto file = folder / "monday" / "monday_000.mcap";
    std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
    const Attempt attempt = read(folder / "monday");
    EXPECT_FALSE(attempt.origin.complete);
    EXPECT_GT(attempt.duration(), 5);
    EXPECT_THAT(page_of(attempt, {}), HasSubstr("could not be read"));
}

TEST(DebriefTest, HashIsThatOfTheFile) {
    const Folder folder;
    const Attempt attempt = attempt_of(folder);
    EXPECT_EQ(attempt.origin.sha256, recording::sha256(test::content(folder / "monday" / "monday_000.mcap")));
    EXPECT_EQ(attempt_id(attempt), attempt_id(read(folder / "monday")))
        << "made again, it is the same attempt";
    // The SHA-256 of "abc" is in FIPS 180-2, appendix B.1.
    EXPECT_EQ(recording::sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(DebriefTest, LessonsTitleAndQuestionsComeFromItsFile) {
    const auto lesson = lesson_text("lessons/l01.json", R"({"name": "l01", "lesson": {"title": "Let go",
        "questions": ["What did you smell?", {}]}})");
    EXPECT_TRUE(lesson.taught);
    EXPECT_THAT(lesson.questions, ElementsAre("What did you smell?"));
    EXPECT_FALSE(lesson_text("exercises/a.json", R"({"name": "a"})").taught);
    EXPECT_FALSE(lesson_text("exercises/a.json", "no json").taught);
}

/// xAPI 1.0.3, part two, 4: what a statement must have, and the forms of its parts.
TEST(DebriefTest, StatementsHaveWhatALearningRecordStoreAsksFor) {
    const Folder folder;
    const Attempt attempt = attempt_of(folder);
    const auto statements = xapi_of(attempt, {"https://school.example/accounts", "trainee-17"});
    std::vector<std::string> verbs;
    std::set<std::string> ids;
    static const std::regex uuid("[0-9a-f]{8}-[0-9a-f]{4}-[1-8][0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}");
    static const std::regex duration(R"(PT[0-9]+M[0-9]+\.[0-9]{2}S)"),
        instant(R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ)");
    for (const auto& each : statements) {
        EXPECT_TRUE(std::regex_match(each["id"].get<std::string>(), uuid)) << each["id"];
        EXPECT_TRUE(ids.insert(each["id"]).second) << "no two have one id";
        EXPECT_FALSE(each["actor"].contains("mbox"));
        EXPECT_EQ(each["actor"]["account"]["name"], "trainee-17");
        EXPECT_TRUE(std::regex_match(each["timestamp"].get<std::string>(), instant));
        EXPECT_TRUE(std::regex_match(each["context"]["registration"].get<std::string>(), uuid));
        if (each.contains("result") && each["result"].contains("duration")) {
            EXPECT_TRUE(std::regex_match(each["result"]["duration"].get<std::string>(), duration));
        }
        const std::string verb = each["verb"]["id"];
        verbs.push_back(verb.substr(verb.rfind('/') + 1));
    }
    EXPECT_THAT(verbs, ElementsAre("initialized", "completed", "failed", "passed", "failed", "terminated"));
    EXPECT_NEAR(statements[2]["result"]["score"]["scaled"].get<double>(), 0.66, 1e-9);
    EXPECT_EQ(statements[3]["context"]["contextActivities"]["parent"][0]["id"],
              statements[0]["object"]["id"]);
    EXPECT_EQ(statements, xapi_of(attempt, {"https://school.example/accounts", "trainee-17"}))
        << "sent twice, it is one";
}

TEST(DebriefTest, TableHasOneRowAFactAndSurvivesCommasAndQuotes) {
    const Folder folder;
    Attempt attempt = attempt_of(folder);
    attempt.events[0].text("a \"pin\", bent");
    const std::string csv = csv_of(attempt);
    EXPECT_THAT(csv, testing::StartsWith("section,time (s),recorded (s),side,name,value,unit,text\r\n"));
    EXPECT_THAT(csv, HasSubstr("figure,,,,largest_tension_port,734567,N,"));
    EXPECT_THAT(csv, HasSubstr("\"a \"\"pin\"\", bent\"\r\n"));
    EXPECT_THAT(csv, HasSubstr("criterion,33.000,37.000,,fall,20,%,"));
}

TEST(SeriesTest, KeepsTheExtremesOfEveryInterval) {
    Series series(10);
    for (int i = 0; i < 1000; ++i)
        series.add(i * 0.1, i == 333 ? 50 : i == 666 ? -50 : 1);
    const auto samples = series.samples();
    EXPECT_LE(samples.size(), 40U);
    EXPECT_TRUE(std::ranges::is_sorted(samples, {}, &Sample::time));
    EXPECT_DOUBLE_EQ(std::ranges::max(samples, {}, &Sample::value).time, 33.3);
    EXPECT_DOUBLE_EQ(std::ranges::min(samples, {}, &Sample::value).time, 66.6);
    EXPECT_EQ(series.at(-1), std::nullopt);
    EXPECT_EQ(series.at(40), 1);
    series.add(101, std::nan(""));
    EXPECT_EQ(series.samples().size(), samples.size());
}

TEST(ScaleTest, StepsAreRoundAndALineKeepsItsCorners) {
    EXPECT_DOUBLE_EQ(round_step(734, 5), 200);
    EXPECT_DOUBLE_EQ(round_step(0.9, 5), 0.2);
    EXPECT_DOUBLE_EQ(round_time_step(457, 9), 60);
    EXPECT_DOUBLE_EQ(round_time_step(7200, 9), 900);
    EXPECT_EQ(time_figure(125, 5), "2:05");
    EXPECT_THAT(simplified({{0, 0}, {1, 0.01}, {2, 0}, {2, 9}, {2, 10}}, 0.25), SizeIs(3));
}

} // namespace
} // namespace windlass::debrief
