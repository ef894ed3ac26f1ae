// Pages in a simulated centre, and that the checks of what they are sent can fail.

#include "sim/centre.hpp"
#include "sim/checks.hpp"
#include "sim/page_checks.hpp"

#include "tests/sim/first_failure.hpp"

#include <gmock/gmock.h>

#include <functional>

namespace windlass::sim {
namespace {

TEST(Centre, HasPagesInAShareOfItsSeeds) {
    std::uint64_t without = 0, opened = 0, sent_away = 0, taken = 0, stations = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const Outcome found = run({.seed = seed});
        without += found.pages == 0 ? 1 : 0;
        opened += found.pages, sent_away += found.sent_away, stations += found.stations;
        taken += found.taken;
    }
    EXPECT_GT(without, 0U);
    EXPECT_GT(opened, 10U);
    EXPECT_GT(sent_away, 0U);
    EXPECT_GT(taken, 0U);
    EXPECT_GT(stations, 0U);
}

TEST(Centre, WithPagesOfTheSameSeedIsTheSame) {
    std::uint64_t pages = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const Plan plan{.seed = seed, .minutes = 0.3};
        const Outcome once = run(plan);
        pages += once.pages;
        if (once.pages == 0) continue;
        EXPECT_EQ(once.digest, run(plan).digest) << seed;
    }
    EXPECT_GT(pages, 0U);
}

TEST(PageChecks, FindAnEventThatAPageIsNotTold) {
    EXPECT_EQ(first_failure(Sabotage::page_event_lost, 10), "page events");
}

TEST(PageChecks, FindAStateThatIsNotTheNewest) {
    EXPECT_EQ(first_failure(Sabotage::page_state_lost, 10), "page states");
}

TEST(PageChecks, FindAPageThatIsToldWhatItsSeatMayNotHear) {
    EXPECT_EQ(first_failure(Sabotage::page_sees_truth, 10), "page roles");
}

TEST(PageChecks, FindALeverThatIsNotWhereAPagesHandMovedIt) {
    EXPECT_EQ(first_failure(Sabotage::page_lever_altered, 10), "page levers");
}

TEST(PageChecks, FindAPageThatIsNotToldThatAnotherStationHasItsLevers) {
    EXPECT_EQ(first_failure(Sabotage::page_taking_untold, 10), "page takings");
}

TEST(PageChecks, FindAHandThatStaysOnLeversThatAnotherStationHas) {
    EXPECT_EQ(first_failure(Sabotage::page_hand_stays, 10), "page levers");
}

TEST(PageChecks, FindALeverOfAPageThatIsGone) {
    EXPECT_EQ(first_failure(Sabotage::page_works_on, 10), "page levers");
}

ToldPtr told(const wire::TopicInfo& topic, std::uint8_t mark, std::uint64_t server, double time,
             std::string key = "") {
    return std::make_shared<const ToldSample>(ToldSample{.topic = &topic,
                                                         .payload = {mark},
                                                         .key = std::move(key),
                                                         .time = time,
                                                         .server = server,
                                                         .number = mark});
}

/// What of a topic a program that has heard all that gives a page.
std::vector<int> stands_after(const std::vector<ToldPtr>& heard) {
    HeardBook book;
    for (const ToldPtr& sample : heard)
        book.hear(sample);
    std::vector<int> marks;
    for (const ToldPtr& sample : book.stands(heard.front()->topic->name))
        marks.push_back(sample->payload.front());
    return marks;
}

TEST(PageChecks, KnowWhatOfAnotherServersEventsAndAlertsStands) {
    const auto& event = wire::topics::event;
    const auto& alert = wire::topics::alert;
    using testing::ElementsAre;
    EXPECT_THAT(stands_after({told(event, 1, 1, 1), told(event, 2, 1, 5), told(event, 3, 2, 3)}),
                ElementsAre(1, 3))
        << "taken up where it stood at 3 s at the latest";
    EXPECT_THAT(stands_after({told(event, 1, 1, 1), told(event, 2, 2, 0)}), ElementsAre(2)) << "begun anew";
    EXPECT_THAT(
        stands_after({told(alert, 1, 1, 1, "a"), told(alert, 2, 1, 2, "b"), told(alert, 3, 1, 3, "a")}),
        ElementsAre(2, 3));
    EXPECT_THAT(stands_after({told(alert, 1, 1, 1, "a"), told(alert, 2, 2, 2, "b")}), ElementsAre(2));
}

/// The check that fails first, of a page that is subscribed to events and is told one, 1.
std::string failure_of(const std::function<void(PageChecks&, HeardBook&)>& what) {
    HeardBook book;
    PageChecks checks({"Event"});
    try {
        checks.subscribes(1, wire::topics::event, book, 0);
        const ToldPtr sample = told(wire::topics::event, 1, 1, 1);
        book.hear(sample);
        checks.is_told(sample);
        what(checks, book);
    } catch (const Failure& failure) {
        return failure.check;
    }
    return "";
}

TEST(PageChecks, HoldWhatAPageIsSentAgainstWhatWasTold) {
    const auto gets = [](std::vector<std::uint8_t> marks) {
        return [marks](PageChecks& checks, HeardBook& book) {
            for (const std::uint8_t mark : marks)
                checks.gets(1, "Event", {mark});
            checks.has_all(book, marks.size(), 10);
        };
    };
    EXPECT_EQ(failure_of(gets({1})), "");
    EXPECT_EQ(failure_of(gets({})), "page events") << "not told";
    EXPECT_EQ(failure_of(gets({2})), "page events") << "another one";
    EXPECT_EQ(failure_of(gets({1, 1})), "page events") << "told twice";
    EXPECT_EQ(failure_of([](PageChecks& checks, HeardBook&) { checks.gets(1, "ShipState", {1}); }),
              "page roles");
    EXPECT_EQ(failure_of([](PageChecks& checks, HeardBook&) { checks.gets(2, "Event", {1}); }),
              "page subscriptions");
    EXPECT_EQ(failure_of([](PageChecks& checks, HeardBook& book) {
                  checks.gets(1, "Event", {1});
                  checks.has_all(book, 13, 10);
              }),
              "memory");
}

} // namespace
} // namespace windlass::sim
