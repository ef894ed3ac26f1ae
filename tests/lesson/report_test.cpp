// Reports against the truth: each swept across it, held against the table of docs/lessons.md.

#include "tests/lesson/course.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace windlass::assess {

namespace {

using exercise::CableWeight;
using exercise::Growing;
using exercise::ReportCode;
using exercise::StayGiven;

std::string reporting(const char* code, const char* rest = "") {
    return lesson(std::string(R"({"id": "r", "kind": "report", "report": ")") + code + "\"" + rest + "}");
}

/// What a report that comes so many seconds after the truth earns (negative: before), thousandths.
int timed(const char* name, ReportCode code, double after, const std::function<void(Course&)>& come_true) {
    constexpr int kSecond = 1; // Hz, a tick each second
    Course course(reporting(name), kSecond);
    course.run(5);
    if (after < 0) course.report(code);
    course.run(after < 0 ? -after : 0);
    come_true(course);
    course.run(std::max(1.0, after));
    if (after >= 0) course.report(code);
    course.run(400);
    course.end();
    return course.mark().milli;
}

/// Marks of one report for a figure that is set before it.
int figured(const char* name, const exercise::ReportMade& report, const std::function<void(Course&)>& is) {
    Course course(reporting(name));
    is(course);
    course.run(1);
    course.report(report);
    course.run(1);
    return course.mark().milli;
}

/// How often the marks of a sweep change.
int borders(const std::vector<int>& marks) {
    int changes = 0;
    for (std::size_t k = 1; k < marks.size(); ++k)
        changes += marks[k] != marks[k - 1];
    return changes;
}

} // namespace

// -300 to 400 s round the truth: nothing, whole, half, nothing, each border once and where the table has it.
TEST(Reports, OfWhatHappensAreWorthWhatTheTableSaysAtEachSecondRoundIt) {
    const auto event = [](const char* code) { return [code](Course& course) { course.event(code); }; };
    const auto hove_at = [](double degrees) {
        return [degrees](Course& course) {
            course.chain().top_angle = degrees * 3.14159265358979323846 / 180;
            course.windlass().cable_speed = -0.1;
        };
    };
    const struct {
        const char* name;
        ReportCode code;
        double early, full, half; // s
        std::function<void(Course&)> come_true;
    } rows[] = {
        {"let_go", ReportCode::let_go, 5, 10, 20, event("anchor.let_go")},
        {"heaving", ReportCode::heaving, 5, 15, 30, hove_at(30)},
        {"on_the_bottom", ReportCode::on_the_bottom, 3, 15, 30, event("anchor.on_bottom")},
        {"brought_up", ReportCode::brought_up, 60, 120, 240, event("anchor.brought_up")},
        {"dragging", ReportCode::dragging, 60, 180, 360, event("anchor.dragging")},
        {"short_stay", ReportCode::short_stay, 20, 20, 60, hove_at(60)},
        {"up_and_down", ReportCode::up_and_down, 20, 20, 60, hove_at(80)},
        {"anchor_aweigh", ReportCode::anchor_aweigh, 20, 30, 60, event("anchor.aweigh")},
        {"anchor_home", ReportCode::anchor_home, 5, 30, 90, event("anchor.housed")},
    };
    constexpr double kTick = 1; // s: a report is taken in the tick behind it, and may lie that much beside
    for (const auto& row : rows) {
        std::vector<int> marks;
        for (double after = -300; after <= 400; ++after) {
            marks.push_back(timed(row.name, row.code, after, row.come_true));
            const double off = after < 0                             ? -row.early
                               : after > 0.5 * (row.full + row.half) ? row.half
                                                                     : row.full;
            if (std::abs(after - off) <= kTick) continue;
            const int worth = after < -row.early ? 0 : after < row.full ? 1000 : after < row.half ? 500 : 0;
            EXPECT_EQ(marks.back(), worth) << row.name << " after " << after << " s";
        }
        EXPECT_EQ(borders(marks), 3) << row.name;
    }
}

// "Brought up", and once more to the bridge's question before she is: one report, and no false call beside
// it. One that comes when the first can no longer come true is another.
TEST(Reports, SaidAgainBeforeItCouldComeTrueIsOneReport) {
    for (const double again : {30.0, 90.0}) { // s after the first; early: 60
        Course course(reporting("brought_up"), 1);
        course.run(5);
        course.report(ReportCode::brought_up);
        course.run(again);
        course.report(ReportCode::brought_up);
        course.run(25);
        course.event("anchor.brought_up");
        course.run(2);
        course.end();
        EXPECT_EQ(course.mark().milli, again < 60 ? 1000 : 0) << again;
    }
}

// Two units to either side of the truth: nothing, half, whole, half, nothing.
TEST(Reports, OfFiguresAreWorthWhatTheyAreOff) {
    constexpr double kShackle = 27.5, kOut = 5 * kShackle; // m
    const struct {
        const char* name;
        ReportCode code;
        double truth; // shackles or turns
    } rows[] = {
        {"shackles_on_deck", ReportCode::shackles_on_deck, (kOut + 4) / kShackle},
        {"shackles_in_pipe", ReportCode::shackles_in_pipe, (kOut + 1.5) / kShackle},
        {"shackles_in_water", ReportCode::shackles_in_water, (kOut - 6) / kShackle},
        {"turns", ReportCode::turns, 3},
    };
    const auto is = [&](Course& course) {
        course.chain().cable_out = kOut;
        course.seen().tackle[0].hawse.z() = 6;
        course.chain().turns = -3; // left-handed ones are as many
    };
    for (const auto& row : rows) {
        std::vector<int> marks;
        for (int k = -200; k <= 200; ++k) {
            const double off = 0.01 * k;
            marks.push_back(figured(row.name, {.code = row.code, .side = 0, .value = row.truth + off}, is));
            const double far = std::abs(off);
            if (std::min(std::abs(far - 0.5), std::abs(far - 1)) < 0.005) continue; // of a border itself
            EXPECT_EQ(marks.back(), far < 0.5 ? 1000 : far < 1 ? 500 : 0) << row.name << " off by " << off;
        }
        EXPECT_EQ(borders(marks), 4) << row.name;
    }
}

TEST(Reports, OfTheLeadAreRightWithinAnHourRoundTheClock) {
    for (int truth = 0; truth < 24; ++truth) {
        std::vector<int> marks;
        for (int said = 1; said <= 12; ++said) {
            marks.push_back(figured("lead", {.code = ReportCode::lead, .side = 0, .lead = said},
                                    [&](Course& course) { course.chain().lead_clock = 0.5 * truth; }));
            const double apart = std::abs(std::remainder(said - 0.5 * truth, 12.0));
            EXPECT_EQ(marks.back(), apart <= 1   ? 1000
                                    : apart <= 2 ? 500
                                                 : 0)
                << said << " for " << 0.5 * truth;
        }
        marks.push_back(marks.front());
        EXPECT_EQ(borders(marks), 4) << 0.5 * truth;
    }
}

// Classes at 25, 50, 75 deg; within 5 deg of a border both are right, beyond it the next is worth half.
TEST(Reports, OfTheStayAreRightInTheirClassAndNearItsBorders) {
    const struct {
        StayGiven said;
        double least, most; // deg of the class
    } rows[] = {{StayGiven::up_and_down, 75, 90},
                {StayGiven::short_stay, 50, 75},
                {StayGiven::medium_stay, 25, 50},
                {StayGiven::long_stay, 0, 25}};
    for (const auto& row : rows)
        for (double angle = 1.25; angle < 90; angle += 2.5) {
            const int milli = figured(
                "lead", {.code = ReportCode::lead, .side = 0, .lead = 12, .stay = row.said},
                [&](Course& course) { course.chain().top_angle = angle * 3.14159265358979323846 / 180; });
            const double off = std::max({0.0, row.least - angle, angle - row.most});
            EXPECT_EQ(milli, off < 5    ? 1000
                             : off < 30 ? 500
                                        : 0)
                << angle << " deg as " << static_cast<int>(row.said);
        }
}

// The page offers both as answers to "how is the cable leading?", and they are the same words.
TEST(Reports, ThatSheIsUpAndDownOrAtShortStaySayHowSheLeads) {
    const struct {
        ReportCode code;
        StayGiven stay;
    } rows[] = {{ReportCode::up_and_down, StayGiven::up_and_down},
                {ReportCode::short_stay, StayGiven::short_stay}};
    for (const auto& row : rows)
        for (const double angle : {10.0, 40.0, 60.0, 85.0}) {
            const auto leads = [&](Course& course) {
                course.chain().top_angle = angle * 3.14159265358979323846 / 180;
            };
            EXPECT_EQ(figured("lead", {.code = row.code, .side = 0}, leads),
                      figured("lead", {.code = ReportCode::lead, .side = 0, .stay = row.stay}, leads))
                << angle << " deg";
        }
    EXPECT_EQ(figured("lead", {.code = ReportCode::up_and_down, .side = 0},
                      [](Course& course) { course.chain().top_angle = 0.1; }),
              0);
}

// Of Zcont, here 300 kN: none below 0.3, moderate to 1, much to 1.5, too much above.
TEST(Reports, OfTheWeightAreRightInTheirClassAndWorthHalfInTheNext) {
    constexpr double kBorders[] = {90e3, 300e3, 450e3};
    for (int said = 1; said <= 4; ++said) {
        std::vector<int> marks;
        for (double load = 5e3; load < 700e3; load += 10e3) {
            marks.push_back(figured(
                "weight", {.code = ReportCode::weight, .side = 0, .weight = static_cast<CableWeight>(said)},
                [&](Course& course) { course.windlass().gypsy_load = load; }));
            int is = 1;
            for (const double border : kBorders)
                is += load > border;
            EXPECT_EQ(marks.back(), is == said                 ? 1000
                                    : std::abs(is - said) == 1 ? 500
                                                               : 0)
                << load << " N as " << said;
        }
        EXPECT_EQ(borders(marks), said == 1 || said == 4 ? 2 : 3) << said;
    }
    EXPECT_EQ(figured("weight", {.code = ReportCode::weight, .side = 0},
                      [](Course& course) { course.windlass().gypsy_load = 1e5; }),
              0); // the number of nothing said
}

namespace {

constexpr double kPlumb = 31e3; // N: 6 m of hawse pipe and 25 m of water, at 1 kN a metre

/// Marks of a report of how a cable grows that has had one tension for half a minute.
int grown(Growing said, double tension) {
    Course course(reporting("growing"));
    course.seen().tackle[0].hawse.z() = 6;
    course.seen().environment.depth = 25;
    course.windlass().hawse_tension = tension;
    course.run(30);
    course.report({.code = ReportCode::growing, .side = 0, .growing = said});
    course.run(11);
    return course.mark().milli;
}

} // namespace

// Slack below 1.2 times the plumb cable's weight, tight above twice that, growing between.
TEST(Reports, OfHowTheCableGrowsAreRightInTheirClass) {
    for (const Growing said : {Growing::slack, Growing::growing, Growing::tight}) {
        std::vector<int> marks;
        for (double share = 0.05; share < 4; share += 0.1) {
            const Growing is = share < 1.2 ? Growing::slack : share > 2 ? Growing::tight : Growing::growing;
            marks.push_back(grown(said, share * kPlumb));
            const int apart =
                std::abs(static_cast<int>(said) - static_cast<int>(is)); // one word beside it: half
            EXPECT_EQ(marks.back(), apart == 0   ? 1000
                                    : apart == 1 ? 500
                                                 : 0)
                << share << " as " << static_cast<int>(said);
        }
        EXPECT_EQ(borders(marks), 2);
    }
}

TEST(Reports, OfACableThatIsTightAndStillRisesMayBeGrowing) {
    for (const double rise : {0.0, 0.3, 3.0}) { // % a second
        Course course(reporting("growing"));
        course.seen().environment.depth = 25;
        double tension = 5 * kPlumb;
        for (int k = 0; k < 40; ++k) {
            course.windlass().hawse_tension = tension;
            course.run(1);
            tension *= 1 + 0.01 * rise;
        }
        course.report({.code = ReportCode::growing, .side = 0, .growing = Growing::growing});
        course.run(5);
        course.windlass().hawse_tension = 5 * kPlumb;
        course.run(6);
        EXPECT_EQ(course.mark().milli, rise > 1 ? 1000 : 500) << rise; // a tenth in ten seconds
    }
}

// It was so, or comes to be so, within ten seconds of the word: the same to either side.
TEST(Reports, OfHowTheCableGrowsMayLieTenSecondsBesideIt) {
    std::vector<int> marks;
    for (int after = -20; after <= 20; ++after) { // s, from when it was tight for two seconds to the word
        Course course(reporting("growing"));
        course.seen().environment.depth = 25;
        for (int second = 0; second < 60; ++second) {
            course.windlass().hawse_tension = second == 30 || second == 31 ? 3 * kPlumb : 0;
            if (second == 31 + after)
                course.report({.code = ReportCode::growing, .side = 0, .growing = Growing::tight});
            course.run(1);
        }
        marks.push_back(course.mark().milli);
        if (std::abs(after) < 9) {
            EXPECT_EQ(marks.back(), 1000) << after;
        }
        if (std::abs(after) > 13) { // two seconds of it, one of a mean
            EXPECT_EQ(marks.back(), 0) << after;
        }
    }
    EXPECT_EQ(borders(marks), 2);
}

TEST(Reports, OfSeveralThatAreAskedForEachCounts) {
    Course course(reporting("growing", R"(, "count": 2)"));
    course.seen().environment.depth = 25;
    course.run(30);
    course.report({.code = ReportCode::growing, .side = 0, .growing = Growing::tight}); // it is slack
    course.run(5);
    course.report({.code = ReportCode::growing, .side = 0, .growing = Growing::slack});
    course.run(1);
    EXPECT_EQ(course.mark().milli, 500);
    EXPECT_EQ(course.mark().reason, "0:30 \"port cable is tight\" reported, and it was not so. 0:35 \"port "
                                    "cable is slack\" reported, and it was so. "
                                    "2 of 2 reports made: 50 % of its points lost");
}

// What is shown and kept of a report is what was judged: said at 12.0 s of what was so at 5.0 s.
TEST(Reports, EachIsToldAsItWasJudged) {
    Course course(reporting("on_the_bottom"));
    course.report(ReportCode::on_the_bottom); // too early: wrong
    course.run(5);
    course.event("anchor.on_bottom");
    course.run(7);
    course.report(ReportCode::on_the_bottom);
    course.run(1);
    const auto reports = course.now().reports;
    ASSERT_EQ(reports.size(), 2U);
    EXPECT_EQ(reports[0].milli, 0);
    EXPECT_NEAR(reports[0].delay.value(), -5.1, 1e-9);
    EXPECT_EQ(reports[1].tick, 120U) << "of the order, not of the tick that heard it";
    EXPECT_EQ(reports[1].milli, 1000);
    EXPECT_NEAR(reports[1].delay.value(), 6.9, 1e-9);
    EXPECT_EQ(reports[1].text, "6.9 s after it was so, at 0:05");
    EXPECT_FALSE(reports[1].truth);
}

TEST(Reports, OfAFigureTellTheFigureThatWasSo) {
    Course course(reporting("shackles_in_water"));
    course.chain().cable_out = 4 * 27.5 + 12;
    course.seen().tackle[0].hawse.z() = 12;
    course.run(1);
    course.report(ReportCode::shackles_in_water, 5.2);
    course.run(1);
    ASSERT_EQ(course.now().reports.size(), 1U);
    EXPECT_NEAR(course.now().reports[0].truth.value(), 4, 1e-9)
        << "from where it was marked, not from the lip";
    EXPECT_EQ(course.mark().reason,
              "0:01 \"5.2 shackles in the water\" reported, 4 in the water were so: all of its points lost")
        << "by the counter it is more";
}

TEST(Reports, OfShacklesWithTheAnchorHomeTellNoFigureBelowNone) {
    Course course(reporting("shackles_in_pipe"));
    course.chain().cable_out = -4;
    course.run(1);
    course.report(ReportCode::shackles_in_pipe, 1);
    course.run(1);
    EXPECT_EQ(course.mark().reason,
              "0:01 \"1 shackle in the pipe\" reported, the anchor was home: all of its points lost");
}

TEST(Reports, ThatNeverCameTrueAndThoseThatWereNeverMadeAreSaid) {
    Course cried(reporting("dragging"));
    cried.run(3);
    cried.report(ReportCode::dragging);
    cried.run(1);
    cried.end();
    EXPECT_EQ(cried.mark().reason,
              "0:03 \"port anchor is dragging\" reported, and it never was so: all of its points lost");
    EXPECT_EQ(cried.mark().lost_tick, 30U);
    ASSERT_EQ(cried.now().reports.size(), 1U);
    EXPECT_FALSE(cried.now().reports[0].delay);
    Course silent(reporting("secured"));
    silent.run(1);
    silent.end();
    EXPECT_EQ(silent.mark().reason, "\"secured\" wanted, not reported: all of its points lost");
    EXPECT_EQ(silent.mark().lost_tick, 10U) << "the end: there is no other moment";
    Course overlooked(
        R"({"id": "T", "criteria": [{"id": "r", "kind": "report", "report": "foul_anchor", "weight": 10}]})");
    overlooked.run(5);
    overlooked.seen().tackle[0].anchor.fouled = 1;
    overlooked.seen().tackle[0].anchor.position.z() = 2;
    overlooked.run(5);
    overlooked.end();
    EXPECT_EQ(overlooked.mark().reason,
              "0:05 it was so: \"foul anchor\" wanted, not reported: all of its points lost");
    EXPECT_EQ(overlooked.mark().lost_tick, 51U) << "when it hung there to be seen";
    Course missed(reporting("on_the_bottom"));
    missed.run(5);
    missed.event("anchor.on_bottom");
    missed.run(40);
    EXPECT_EQ(missed.mark().reason,
              "0:05 anchor on bottom (port): \"on the bottom\" wanted within 15 s, not reported: "
              "all of its points lost");
    EXPECT_EQ(missed.mark().lost_tick, 51U);
    missed.report(ReportCode::on_the_bottom);
    missed.run(1);
    EXPECT_EQ(missed.mark().milli, 0) << "too late for a mark";
    ASSERT_EQ(missed.now().reports.size(), 1U) << "and still told";
    EXPECT_NEAR(missed.now().reports[0].delay.value(), 39.9, 1e-9);
}

// What was so beside a report that was not: as the debriefing has it of one that nobody judges.
TEST(Reports, ThatWereNotSoSayHowAnchorOrCableWas) {
    Course called(reporting("brought_up"));
    called.seen().tackle[0].anchor.phase = exercise::AnchorPhase::dragging;
    called.run(3);
    called.report(ReportCode::brought_up);
    called.run(1);
    called.seen().tackle[0].anchor.phase = exercise::AnchorPhase::holding; // later is later
    called.end();
    ASSERT_EQ(called.now().reports.size(), 1U);
    EXPECT_EQ(called.now().reports[0].text, "and it was not so then: anchor dragging");
    Course short_stay(reporting("short_stay"));
    short_stay.chain().lead_clock = 12;
    short_stay.chain().top_angle = 0.1;
    short_stay.run(3);
    short_stay.report(ReportCode::short_stay);
    short_stay.run(1);
    short_stay.end();
    ASSERT_EQ(short_stay.now().reports.size(), 1U);
    EXPECT_EQ(short_stay.now().reports[0].text, "and it was not so then: it led 12 o'clock, long stay");
}

TEST(Reports, ThatNobodyAskedForAreToldWhereTheyWereFalseAndCostNothing) {
    Course course(reporting("secured"));
    course.seen().tackle[0].anchor.phase = exercise::AnchorPhase::hanging;
    course.chain().cable_out = 4 * 27.5 - 1.5; // the fourth mark in the pipe
    course.run(1);
    const CriterionResult before = course.mark();
    course.report(ReportCode::on_the_bottom);
    course.report(ReportCode::shackles_in_pipe, 6);
    course.run(2);
    ASSERT_EQ(course.now().reports.size(), 1U) << "it may be on the bottom within three seconds";
    course.run(2);
    const auto reports = course.now().reports;
    ASSERT_EQ(reports.size(), 2U);
    for (const ReportResult& one : reports) {
        EXPECT_EQ(one.criterion, "");
        EXPECT_EQ(one.milli, 0);
        const bool figure = one.code == ReportCode::shackles_in_pipe;
        EXPECT_EQ(one.text, figure ? "4 in the pipe were so" : "and it was not so then: anchor hanging");
    }
    EXPECT_EQ(course.mark().milli, before.milli);
    EXPECT_EQ(course.mark().state, before.state);
}

// A criterion takes a lead once it is asked for, and one. What is said before and after is of something else,
// and not for that so.
TEST(Reports, OfAFigureThatAreFalseAtATimeWhenNobodyAsksAreTold) {
    Course course(reporting("lead", R"(, "from": {"shackles": 3})"));
    course.chain().lead_clock = 12;
    const auto says = [&](int lead) {
        course.report({.code = ReportCode::lead, .side = 0, .lead = lead});
        course.run(1);
    };
    course.run(1);
    says(6);
    ASSERT_EQ(course.now().reports.size(), 1U);
    EXPECT_EQ(course.now().reports[0].criterion, "") << "before it is asked for";
    says(12);
    EXPECT_EQ(course.now().reports.size(), 1U) << "it was so";
    course.chain().cable_out = 4 * 27.5;
    course.run(1);
    says(12);
    ASSERT_EQ(course.now().reports.size(), 2U);
    EXPECT_EQ(course.now().reports[1].criterion, "r");
    says(6);
    ASSERT_EQ(course.now().reports.size(), 3U);
    EXPECT_EQ(course.now().reports[2].criterion, "") << "after it has its mark";
    EXPECT_EQ(course.mark().milli, 1000);
}

// To an order he answers, also where he has said it before; that he did is told.
TEST(Reports, OfAStateThatWereMadeBeforeTheyWereAskedForAreToldAndDoNotCount) {
    Course course(reporting("secured", R"(, "from": {"shackles": 3})"));
    course.windlass().brake_position = 1;
    course.windlass().stopper_closed = true;
    course.windlass().clutch = exercise::ClutchState::out;
    course.run(5);
    course.report(ReportCode::secured);
    course.run(10);
    course.chain().cable_out = 4 * 27.5;
    course.run(5);
    course.end();
    EXPECT_EQ(course.mark().milli, 0);
    EXPECT_EQ(course.mark().reason, "0:15 it was so: \"secured\" wanted, not reported then; said at 0:05, "
                                    "before it was asked for: all of its points lost");
}

// Who hears "secured" relies on it, asked for or not.
TEST(Reports, ThatSheIsSecuredAreFalseCallsBeforeTheyAreAskedForAndAfterThem) {
    constexpr auto kAsked = R"(, "from": {"shackles": 3})";
    const auto secure = [](Course& course, bool so) {
        course.windlass().brake_position = so ? 1 : 0.5;
        course.windlass().stopper_closed = so;
        course.windlass().clutch = exercise::ClutchState::out;
    };
    const auto ask = [](Course& course) {
        course.chain().cable_out = 4 * 27.5;
        course.run(5);
    };
    /// Says it before it is asked for, does something, and says it when it is asked for and so.
    const auto early = [&](bool so, double until, const std::function<void(Course&)>& put_right) {
        Course course(reporting("secured", kAsked));
        secure(course, so);
        course.run(5);
        course.report(ReportCode::secured);
        course.run(until);
        put_right(course);
        course.run(20);
        ask(course);
        secure(course, true);
        course.run(5);
        course.report(ReportCode::secured);
        course.run(5);
        return course.mark();
    };
    const auto nothing = [](Course&) {};
    const auto by_deed = [&](Course& course) { secure(course, true); };
    const auto by_word = [](Course& course) { course.report(ReportCode::anchor_ready); };
    EXPECT_EQ(early(true, 1, nothing).milli, 1000) << "it was so";
    EXPECT_EQ(early(false, 1, nothing).milli, 0);
    EXPECT_EQ(early(false, 1, nothing).lost_tick, 50U) << "when it was said";
    EXPECT_EQ(early(false, 14, by_deed).milli, 1000);
    EXPECT_EQ(early(false, 16, by_deed).milli, 0) << "which is not at once";
    EXPECT_EQ(early(false, 14, by_word).milli, 1000);
    EXPECT_EQ(early(false, 16, by_word).milli, 0);

    Course later(reporting("secured", kAsked));
    secure(later, true);
    ask(later);
    later.report(ReportCode::secured);
    later.run(5);
    EXPECT_EQ(later.mark().state, CriterionState::met);
    secure(later, false);
    later.run(30);
    EXPECT_EQ(later.mark().milli, 1000) << "to open it again is no lie";
    later.report(ReportCode::secured);
    later.run(20);
    EXPECT_EQ(later.mark().state, CriterionState::not_met);
    ASSERT_EQ(later.now().reports.size(), 2U);
    EXPECT_EQ(later.now().reports[1].text.find("but "), 0U) << later.now().reports[1].text;

    Course never_asked(reporting("secured", kAsked));
    secure(never_asked, false);
    never_asked.run(5);
    never_asked.report(ReportCode::secured);
    never_asked.run(20);
    never_asked.end();
    EXPECT_EQ(never_asked.mark().state, CriterionState::not_met) << "as every false call of what never came";

    Course stood_by(reporting("anchor_ready", kAsked));
    stood_by.windlass().brake_position = 0.5;
    stood_by.run(5);
    stood_by.report(ReportCode::anchor_ready);
    stood_by.run(20);
    stood_by.windlass().brake_position = 1;
    ask(stood_by);
    stood_by.report(ReportCode::anchor_ready);
    stood_by.run(5);
    EXPECT_EQ(stood_by.mark().milli, 1000) << "what standing by is hangs on the order";
}

TEST(Reports, ThatNobodyAskedForAreNotToldWhereTheyWereSo) {
    Course rode(reporting("secured")); // at anchor before it began
    rode.seen().tackle[0].anchor.phase = exercise::AnchorPhase::holding;
    rode.chain().cable_out = 4 * 27.5 - 1.5;
    rode.run(1);
    rode.report(ReportCode::brought_up);
    rode.report(ReportCode::on_the_bottom);
    rode.report(ReportCode::shackles_in_pipe, 4);
    rode.run(100);
    EXPECT_TRUE(rode.now().reports.empty());
    Course fell(reporting("secured"));
    fell.seen().tackle[0].anchor.phase = exercise::AnchorPhase::hanging;
    fell.run(1);
    fell.report(ReportCode::on_the_bottom); // and two seconds later it is
    fell.run(2);
    fell.event("anchor.on_bottom");
    fell.run(10);
    EXPECT_TRUE(fell.now().reports.empty());
    fell.seen().tackle[0].anchor.phase = exercise::AnchorPhase::on_bottom;
    fell.report(ReportCode::brought_up);
    fell.run(100);
    ASSERT_EQ(fell.now().reports.size(), 1U) << "she lies on it, and is not brought up";
}

// Two false calls before the truth, the first of which the second took the place of: it is not said to have
// never come true.
TEST(Reports, MadeBeforeItWasSoAreToldWhenItCameToBeSo) {
    Course course(reporting("on_the_bottom"));
    course.run(5);
    course.report(ReportCode::on_the_bottom);
    course.run(20);
    course.report(ReportCode::on_the_bottom);
    course.run(20);
    EXPECT_EQ(course.mark().reason.find("never"), std::string::npos) << course.mark().reason;
    course.event("anchor.on_bottom");
    course.run(1);
    EXPECT_NE(course.mark().reason.find(
                  "0:05 \"port anchor is on the bottom\" reported, and it was not so until 0:45"),
              std::string::npos)
        << course.mark().reason;
    EXPECT_EQ(course.now().reports.at(0).text.find("never"), std::string::npos)
        << course.now().reports.at(0).text;
}

// The sixth mark stopped in the pipe, as it was ordered: the length is met, and what is said of it is so.
TEST(Reports, OfTheMarkInThePipeAreSoWhereTheOrderedLengthIsMet) {
    Course course(lesson(
        R"({"id": "scope", "kind": "final", "that": {"shackles": {"above": 5.75, "below": 6.25}}, "must": true},)"
        R"({"id": "r", "kind": "report", "report": "shackles_in_pipe"})"));
    course.chain().cable_out = 6 * 27.5 - 1.5;
    course.run(1);
    course.report(ReportCode::shackles_in_pipe, 6);
    course.run(1);
    course.end();
    EXPECT_EQ(course.mark(0).milli, 1000);
    EXPECT_EQ(course.mark(1).milli, 1000);
}

} // namespace windlass::assess
