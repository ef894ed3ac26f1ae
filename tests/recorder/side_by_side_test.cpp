// A class side by side: what the page says of each exercise is what its recording has.

#include "recorder/debrief/read_attempt.hpp"
#include "recorder/debrief/side_by_side.hpp"

#include "tests/recorder/debriefed.hpp"
#include "tests/recorder/folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

namespace windlass::debrief {
namespace {

using test::DebriefedRun;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class SideBySide : public testing::Test {
protected:
    Attempt attempt_of(const DebriefedRun& of = {}) {
        const auto path = folder_ / ("recording-" + std::to_string(++made_));
        recorder::Tape tape({.folder = path});
        test::write_run(tape, of);
        tape.close({});
        recording::Recording recording({path});
        return read_attempt(recording);
    }
    /// The criterion of that number earned so much.
    static void give(Attempt& attempt, std::size_t criterion, unsigned milli) {
        Criterion& given = attempt.assessment->criteria().at(criterion);
        given.counted(milli);
        given.milli(milli);
        given.met(milli >= 500);
    }
    static std::string page_of(const std::vector<const Attempt*>& attempts) {
        std::vector<Beside> all;
        for (const Attempt* attempt : attempts)
            all.push_back({.who = "Anna & " + std::to_string(all.size() + 1),
                           .link = "debriefing?recording=" + attempt->origin.recording,
                           .attempt = attempt});
        return side_by_side_page("Class", all);
    }
    /// The cells of the row that begins with that text.
    static std::vector<std::string> row(const std::string& page, const std::string& first) {
        const auto at = page.find("<th scope=\"row\">" + first);
        if (at == page.npos) return {};
        const std::string html = page.substr(at, page.find("</tr>", at) - at);
        static const std::regex cell("<td[^>]*>(.*?)</td>");
        std::vector<std::string> cells;
        for (std::sregex_iterator found(html.begin(), html.end(), cell), end; found != end; ++found)
            cells.push_back((*found)[1]);
        return cells;
    }

    const test::Folder folder_;
    int made_ = 0;
};

TEST_F(SideBySide, EachCriterionHasItsPointsAndHowTheyAreSpread) {
    const Attempt first = attempt_of();
    Attempt second = attempt_of(), third = attempt_of();
    give(second, 1, 1000);
    give(third, 1, 0);
    const std::string page = page_of({&first, &second, &third});
    // 15 of the 50 that were in play: 30 of 100 points.
    EXPECT_THAT(row(page, "fall: criterion fall"),
                ElementsAre("6.0 at 0:33", "30.0", "0.0 at 0:33", "18.0",
                            "<span class=\"squares\" aria-hidden=\"true\">\u25e7\u25a0\u25a1</span> "
                            "1 whole, 1 in part, 1 none"));
    EXPECT_THAT(row(page, "later: criterion later"), ElementsAre("-", "-", "-", "", "not in play"));
    EXPECT_THAT(page, Not(HasSubstr("the rest is worth more")));
}

TEST_F(SideBySide, SaysWhyTheSameDeedHasOtherPointsWhereLessCameIntoPlay) {
    const Attempt whole = attempt_of();
    Attempt less = attempt_of();
    less.assessment->criteria().at(0).counts(false);
    EXPECT_THAT(
        page_of({&whole, &less}),
        HasSubstr("where something did not, the rest is worth more, and the same deed has other points"));
}

TEST_F(SideBySide, WhatLostMostPointsStandsFirst) {
    const Attempt first = attempt_of(), second = attempt_of();
    const std::string page = page_of({&first, &second});
    const auto place = [&](const char* criterion) { return page.find(std::string(">") + criterion + ": "); };
    EXPECT_LT(place("fall"), place("report")); // 24 and 10 points of each
    EXPECT_LT(place("report"), place("clutch"));
}

TEST_F(SideBySide, DeedsAreToldFromLettingGo) {
    const Attempt early = attempt_of(), late = attempt_of({.let_go = 16});
    const std::string page = page_of({&early, &late});
    EXPECT_THAT(row(page, "reported: on the bottom"), ElementsAre("+0:17", "+0:11"));
    EXPECT_THAT(row(page, "carried out: let go"), ElementsAre("+0:04", "-0:02"));
    EXPECT_THAT(page, HasSubstr("from letting go on, m:ss"));
}

TEST_F(SideBySide, WhatOneNeverDidIsEmpty) {
    const Attempt does = attempt_of();
    Attempt never = attempt_of();
    never.reports.clear();
    EXPECT_THAT(row(page_of({&does, &never}), "reported: on the bottom"), ElementsAre("+0:17", ""));
}

TEST_F(SideBySide, WhoNeverLetGoIsToldFromWhenTheOthersDid) {
    const Attempt early = attempt_of(), late = attempt_of({.let_go = 16});
    Attempt never = attempt_of();
    std::erase_if(never.events, [](const Event& event) { return event.code() == "anchor.let_go"; });
    const Zero zero = zero_of({{.attempt = &early}, {.attempt = &never}, {.attempt = &late}});
    EXPECT_THAT(zero.words, HasSubstr("letting go (who never did: "));
    EXPECT_THAT(zero.times, ElementsAre(10, 16, 16));
}

TEST_F(SideBySide, WhereNobodyLetGoTheFirstFaultIsTheBeginning) {
    Attempt attempt = attempt_of();
    std::erase_if(attempt.events, [](const Event& event) { return event.code() == "anchor.let_go"; });
    EXPECT_EQ(zero_of({{.attempt = &attempt}}).words, "the first fault");
    attempt.events.clear();
    EXPECT_THAT(zero_of({{.attempt = &attempt}}).times, ElementsAre(0));
}

TEST_F(SideBySide, AnOrderThatIsGivenAgainIsNoOther) {
    Attempt attempt = attempt_of();
    attempt.orders.push_back(attempt.orders.at(0));
    attempt.orders.back().order.number(2);
    attempt.orders.back().order.text("I say again");
    attempt.orders.back().order.time(20);
    EXPECT_THAT(row(page_of({&attempt}), "the bridge orders: let go port anchor"), ElementsAre("-0:02"));
    EXPECT_THAT(page_of({&attempt}), Not(HasSubstr("say again")));
}

TEST_F(SideBySide, CablesOfMoreThanFourAreTheirSpread) {
    const Attempt early = attempt_of(), late = attempt_of({.let_go = 20});
    const std::string few = page_of({&early, &late}), many = page_of({&early, &early, &late, &late, &late});
    EXPECT_THAT(few, HasSubstr("no. 1: 105.4 m at the end. no. 2: 85.4 m at the end."));
    EXPECT_THAT(few, Not(HasSubstr("median")));
    EXPECT_THAT(many, HasSubstr("median"));
    EXPECT_THAT(many, HasSubstr(">no. 5</text>")); // each has its row of the brake all the same
}

TEST_F(SideBySide, AttemptsAtAnotherLessonAreLeftOut) {
    const Attempt first = attempt_of();
    Attempt other = attempt_of();
    other.assessment->lesson_hash(0xdef);
    const std::string page = page_of({&first, &other});
    EXPECT_THAT(page, HasSubstr("Anna &amp; 2 is left out: it is of another version of"));
    EXPECT_THAT(row(page, "reported: on the bottom"), ElementsAre("+0:17"));
}

TEST_F(SideBySide, WhoWasNotRecordedIsSaid) {
    const Attempt first = attempt_of();
    const std::string page = side_by_side_page(
        "Class", {{.who = "Ben", .missing = "was not recorded"}, {.who = "Anna", .attempt = &first}});
    EXPECT_THAT(page, HasSubstr("Ben is left out: it was not recorded."));
    EXPECT_THAT(row(page, "reported: on the bottom"), ElementsAre("+0:17"));
}

TEST_F(SideBySide, WhoNeverMovedALeverHasNoFiguresAndItIsSaidWhy) {
    const Attempt first = attempt_of();
    Attempt idle = attempt_of();
    for (Side& side : idle.sides)
        side.worked = false;
    const std::string page = page_of({&first, &idle});
    const std::string why = "; no lever was moved, and no cable";
    const auto at = page.find(why);
    ASSERT_NE(at, page.npos);
    EXPECT_GT(at, page.find("Anna &amp; 2</a>")) << "in his own row";
    EXPECT_EQ(page.find(why, at + 1), page.npos) << "and in no other";
    EXPECT_THAT(page, HasSubstr("no. 2: no lever was moved, and no cable."));
}

TEST_F(SideBySide, EachLeadsToItsDebriefing) {
    const Attempt first = attempt_of();
    EXPECT_THAT(page_of({&first}),
                HasSubstr("<a href=\"debriefing?recording=recording-1\">Anna &amp; 1</a>"));
}

TEST_F(SideBySide, WhatCameAfterTheLessonsEndIsLeftOutAndItSaysSo) {
    Attempt over = attempt_of();
    const Attempt whole = attempt_of();
    EXPECT_THAT(page_of({&whole}), Not(HasSubstr("ends with the lesson")));
    over.assessment->time(30);
    const std::string page = page_of({&over, &whole});
    EXPECT_THAT(page, HasSubstr("All that is told here ends with the lesson: no. 1 at 0:30."));
    EXPECT_THAT(row(page, "reported: on the bottom"), ElementsAre("+0:17", "+0:17"));
    EXPECT_THAT(row(page, "reported: shackles in water"), ElementsAre("", HasSubstr("+0:2")));
    EXPECT_THAT(page, HasSubstr("no. 1: 45.0 m at the end. no. 2: 105.4 m at the end."));
}

TEST_F(SideBySide, WithoutMarksDeedsAreThere) {
    const Attempt first = attempt_of({.assessed = false});
    const std::string page = page_of({&first});
    EXPECT_THAT(page, HasSubstr("Nothing was assessed."));
    EXPECT_THAT(row(page, "anchor let go"), ElementsAre("+0:00"));
}

TEST_F(SideBySide, OfNobodyItSaysSo) {
    EXPECT_THAT(page_of({}), HasSubstr("There is no recording."));
}

} // namespace
} // namespace windlass::debrief
