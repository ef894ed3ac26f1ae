// How long a hand at a page has the levers.

#include "station/gateway/lever_desk.hpp"

#include <gmock/gmock.h>

namespace windlass::gateway {
namespace {

using namespace std::chrono_literals;
using nlohmann::json;
using testing::ElementsAre;
using testing::IsEmpty;

const Clock::time_point kBegin{1h};

/// A desk that tells what it wrote, and whom it told of.
struct Desk {
    std::vector<std::string> log;
    LeverDesk levers{[this](Hand hand, const json& sample, std::uint64_t moved_in_run) {
                         log.push_back(
                             name(hand) + " " + sample.dump() +
                             (moved_in_run == 0 ? "" : ", moved in " + std::to_string(moved_in_run)));
                     },
                     [this](Hand hand, LeverDesk::Page holder, const std::string& taken_by) {
                         log.push_back(name(hand) + (holder == nullptr ? " free" : " taken") +
                                       (taken_by.empty() ? "" : " by " + taken_by));
                     },
                     [this](Hand) { ++taken_over; }, [this] { return run; }};
    int taken_over = 0;
    std::uint64_t run = 0; ///< as heard
    static std::string name(Hand hand) {
        return hand == Hand::helm ? "helm" : hand == Hand::port ? "port" : "starboard";
    }
    std::vector<std::string> told() { return std::exchange(log, {}); }
};

TEST(LeverDesk, WritesAtOnceAndAgainWithEachTickWhileThePageSpeaks) {
    Desk desk;
    const int page = 0;
    EXPECT_TRUE(desk.levers.put(Hand::port, &page, 1, kBegin));
    EXPECT_THAT(desk.told(), ElementsAre("port 1", "port taken"));
    EXPECT_TRUE(desk.levers.put(Hand::port, &page, 1, kBegin + 100ms));
    EXPECT_THAT(desk.told(), IsEmpty()) << "nothing has moved; the tick repeats it";
    EXPECT_TRUE(desk.levers.put(Hand::port, &page, 2, kBegin + 120ms));
    EXPECT_THAT(desk.told(), ElementsAre("port 2"));
    desk.levers.tick(kBegin + 150ms);
    desk.levers.tick(kBegin + 200ms);
    EXPECT_THAT(desk.told(), ElementsAre("port 2", "port 2"));
}

constexpr auto kSilent =
    std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(kHandSilent));

TEST(LeverDesk, SaysInWhichRunItsHandMovedALeverLast) {
    Desk desk;
    const int page = 0;
    desk.run = 7;
    desk.levers.put(Hand::port, &page, 1, kBegin);
    desk.run = 8;
    desk.levers.put(Hand::port, &page, 1, kBegin + 100ms);
    desk.levers.tick(kBegin + 150ms);
    EXPECT_THAT(desk.told(), ElementsAre("port 1, moved in 7", "port taken", "port 1, moved in 7"));
    desk.levers.put(Hand::port, &page, 2, kBegin + 200ms);
    EXPECT_THAT(desk.told(), ElementsAre("port 2, moved in 8"));
    desk.run = 9;
    const auto given_up = kBegin + 500ms + kSilent;
    for (auto now = kBegin + 200ms; now < given_up; now += 50ms)
        desk.levers.tick(now);
    desk.told();
    desk.levers.put(Hand::port, &page, 2, given_up);
    EXPECT_THAT(desk.told(), ElementsAre("port 2, moved in 8", "port taken"))
        << "a hand that was only silent";
    desk.levers.let_go(Hand::port, &page);
    desk.levers.put(Hand::port, &page, 2, given_up + 1s);
    EXPECT_THAT(desk.told(), ElementsAre("port free", "port 2, moved in 9", "port taken"));
}

/// Ticks until then, each 0.05 s.
Clock::time_point tick(Desk& desk, Clock::time_point from, Clock::time_point until) {
    while (from < until)
        desk.levers.tick(from += 50ms);
    return until;
}

TEST(LeverDesk, APageThatIsSilentIsHeardByNobodyAndKeepsTheLeversAsABusyBrowserMust) {
    Desk desk;
    const int page = 0;
    auto now = kBegin;
    desk.levers.put(Hand::port, &page, 1, now);
    desk.told();
    now = tick(desk, now, now + kSilent - 50ms);
    EXPECT_EQ(desk.told(), std::vector<std::string>(5, "port 1")) << "its last word is not repeated for long";
    EXPECT_EQ(desk.levers.holder(Hand::port), &page);
    EXPECT_TRUE(desk.levers.put(Hand::port, &page, 1, now)) << "a busy browser";
    now = tick(desk, now, now + kSilent - 50ms);
    EXPECT_EQ(desk.levers.holder(Hand::port), &page);
    desk.told();
    tick(desk, now, now + 100ms);
    EXPECT_THAT(desk.told(), ElementsAre("port free"));
    EXPECT_EQ(desk.levers.holder(Hand::port), nullptr);
}

TEST(LeverDesk, TimeInWhichTheStationItselfDidNotRunIsNoPagesSilence) {
    Desk desk;
    const int page = 0;
    desk.levers.put(Hand::port, &page, 1, kBegin);
    desk.levers.tick(kBegin + 10s);
    EXPECT_EQ(desk.levers.holder(Hand::port), &page);
}

TEST(LeverDesk, OnePageHasTheLeversOfASideUntilItLetsGoOrIsGone) {
    Desk desk;
    const int one = 0, other = 0;
    EXPECT_TRUE(desk.levers.put(Hand::port, &one, 1, kBegin));
    EXPECT_FALSE(desk.levers.put(Hand::port, &other, 5, kBegin));
    EXPECT_TRUE(desk.levers.put(Hand::starboard, &other, 6, kBegin));
    desk.told();
    desk.levers.let_go(Hand::port, &other);
    EXPECT_THAT(desk.told(), IsEmpty()) << "they are not his";
    desk.levers.let_go(Hand::port, &one);
    EXPECT_TRUE(desk.levers.put(Hand::port, &other, 5, kBegin));
    EXPECT_THAT(desk.told(), ElementsAre("port free", "port 5", "port taken"));
    desk.levers.leave(&other);
    EXPECT_THAT(desk.told(), ElementsAre("port free", "starboard free"));
    desk.levers.tick(kBegin);
    EXPECT_THAT(desk.told(), IsEmpty());
}

TEST(LeverDesk, LeversThatAnotherStationWasHeardOnForTwoSecondsAreItsOwnAndThePageIsToldByWhom) {
    Desk desk;
    const int page = 0;
    EXPECT_TRUE(desk.levers.put(Hand::port, &page, 1, kBegin));
    desk.levers.heard_own(Hand::port, kBegin + 1s);
    desk.levers.heard_other(Hand::port, "desk-2", kBegin + 3s, false);
    desk.levers.heard_own(Hand::port, kBegin + 3100ms); // ours counts again: it was late, no more
    desk.levers.heard_other(Hand::port, "desk-2", kBegin + 5100ms, false);
    EXPECT_EQ(desk.levers.holder(Hand::port), &page);
    desk.told();
    desk.levers.heard_other(Hand::port, "desk-2", kBegin + 5101ms, false);
    EXPECT_THAT(desk.told(), ElementsAre("port free by desk-2"));
    EXPECT_TRUE(
        desk.levers.put(Hand::port, &page, 2, kBegin + 5200ms)); // on its way before the page was told
    EXPECT_THAT(desk.told(), IsEmpty());
    EXPECT_EQ(desk.levers.holder(Hand::port), nullptr);
    desk.levers.let_go(Hand::port, &page);
    EXPECT_TRUE(desk.levers.put(Hand::port, &page, 3, kBegin + 6s));
    EXPECT_THAT(desk.told(), ElementsAre("port 3", "port taken"));
}

TEST(LeverDesk, LeversThatWereTakenOverAreTheOthersFromItsFirstWordAndDoNotComeBackWhileItIsLate) {
    Desk desk;
    const int page = 0;
    EXPECT_TRUE(desk.levers.put(Hand::port, &page, 1, kBegin));
    desk.levers.heard_own(Hand::port, kBegin + 1s);
    desk.told();
    desk.levers.heard_other(Hand::port, "desk-2", kBegin, true);
    EXPECT_THAT(desk.told(), IsEmpty()) << "that word was spoken before ours";
    desk.levers.heard_other(Hand::port, "desk-2", kBegin + 1050ms, true);
    EXPECT_THAT(desk.told(), ElementsAre("port free by desk-2"));
    EXPECT_TRUE(desk.levers.put(Hand::port, &page, 1, kBegin + 1100ms)); // the page was not told yet
    tick(desk, kBegin + 1100ms, kBegin + 3s);                            // and desk-2 is late
    EXPECT_THAT(desk.told(), IsEmpty()) << "nothing of this page is heard where desk-2 has the levers";
}

TEST(LeverDesk, AHandThatWasSilentGoesOnAndTakesNothingOver) {
    Desk desk;
    const int page = 0;
    EXPECT_TRUE(desk.levers.put(Hand::port, &page, 1, kBegin));
    desk.levers.heard_own(Hand::port, kBegin + 100ms);
    tick(desk, kBegin, kBegin + 5s);
    EXPECT_EQ(desk.levers.holder(Hand::port), nullptr);
    EXPECT_TRUE(desk.levers.put(Hand::port, &page, 1, kBegin + 6s));
    EXPECT_EQ(desk.taken_over, 1);
    desk.levers.heard_other(Hand::port, "desk-2", kBegin + 5900ms, false); // who may have let go since
    EXPECT_EQ(desk.levers.holder(Hand::port), &page);
    desk.told();
    desk.levers.heard_other(Hand::port, "desk-2", kBegin + 6001ms, false);
    EXPECT_THAT(desk.told(), ElementsAre("port free by desk-2")) << "he took them over meanwhile";
    desk.levers.let_go(Hand::port, &page);
    EXPECT_TRUE(desk.levers.put(Hand::port, &page, 1, kBegin + 7s));
    EXPECT_EQ(desk.taken_over, 2);
}

// Else its levers, as they lay when it fell silent, would undo what the other has done.
TEST(LeverDesk, AHandThatWasSilentDoesNotGoOnWhereAnotherPageHasHadTheLevers) {
    Desk desk;
    const int one = 0, other = 0;
    EXPECT_TRUE(desk.levers.put(Hand::helm, &one, 1, kBegin));
    auto now = tick(desk, kBegin, kBegin + kSilent + 100ms);
    EXPECT_TRUE(desk.levers.put(Hand::helm, &other, 5, now));
    desk.levers.let_go(Hand::helm, &other);
    desk.told();
    EXPECT_TRUE(desk.levers.put(Hand::helm, &one, 1, now + 1s)); // it was told, and has not heard of it yet
    EXPECT_THAT(desk.told(), IsEmpty());
    EXPECT_EQ(desk.levers.holder(Hand::helm), nullptr);
    desk.levers.let_go(Hand::helm, &one);
    EXPECT_TRUE(desk.levers.put(Hand::helm, &one, 6, now + 2s)) << "it takes them as they are";
    EXPECT_THAT(desk.told(), ElementsAre("helm 6", "helm taken"));
}

TEST(LeverDesk, AHandThatIsNeverHeardBesideAnotherDoesNotKeepTheLevers) {
    Desk desk;
    const int page = 0;
    EXPECT_TRUE(desk.levers.put(Hand::helm, &page, 1, kBegin));
    desk.levers.heard_other(Hand::helm, "bridge-1", kBegin + 2s, false);
    EXPECT_EQ(desk.levers.holder(Hand::helm), &page);
    desk.levers.heard_other(Hand::helm, "bridge-1", kBegin + 2001ms, false);
    EXPECT_EQ(desk.levers.holder(Hand::helm), nullptr);
}

} // namespace
} // namespace windlass::gateway
