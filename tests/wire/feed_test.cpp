// Feeds of several seats of one exercise: what several hear is heard once.

#include "station/gateway/feed.hpp"

#include "idl/payload.hpp"
#include "idl/topics.hpp"

#include "rigs/own_domain.hpp"
#include "rigs/wait.hpp"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <memory>
#include <thread>

namespace windlass::gateway {
namespace {

using rigs::eventually;
using Kind = Feed::Kind;

const std::string kExercise = "exercise/one";
const Topics kTopics{&wire::topics::alert, &wire::topics::exercise_status};

/// Counts what it hears.
class Counter final : public Ear {
public:
    void hear(const FramePtr&) override { ++heard; }
    std::atomic<int> heard{0};
};

class SharedFeeds : public testing::Test {
protected:
    std::unique_ptr<Feed> feed(Kind kind = Kind::exercise) const {
        return std::make_unique<Feed>(readers_, kExercise, kind, kTopics);
    }
    void say(const char* code) {
        Alert alert;
        alert.code(code);
        says_.write(wire::encode(alert));
    }
    bool is_matched_by(int readers) const {
        return eventually([&] { return says_.matched() == readers; });
    }

    SharedReaders readers_{wire::Participant({rigs::own_domain(), "classroom", "station", {}, {}})};
    wire::Participant server_{{rigs::own_domain(), kExercise, "server", {}, {}}};
    wire::RawWriter says_{server_, wire::topics::alert};
};

TEST_F(SharedFeeds, HearOnceAndALaterOneHasWhatWasKept) {
    const auto first = feed();
    ASSERT_TRUE(is_matched_by(1));
    say("brake.hot");
    ASSERT_TRUE(eventually([&] { return first->kept(wire::topics::alert).size() == 1; }));

    const auto second = feed();
    EXPECT_EQ(second->kept(wire::topics::alert).size(), 1U) << "at once";
    EXPECT_TRUE(second->writer(wire::topics::alert));
    Counter one, two;
    const std::uint32_t channel = number_of(first->channels(), wire::topics::alert);
    first->listen(channel, one, [](const auto&) {});
    second->listen(channel, two, [](const auto&) {});
    say("chain.end");
    EXPECT_TRUE(eventually([&] { return one.heard == 1 && two.heard == 1; })) << one.heard << two.heard;
    EXPECT_EQ(says_.matched(), 1);
    first->leave(one);
    second->leave(two);
}

TEST_F(SharedFeeds, HearAsLongAsOneOfThemIsThere) {
    auto first = feed(), second = feed();
    ASSERT_TRUE(is_matched_by(1));
    say("brake.hot");
    ASSERT_TRUE(eventually([&] { return second->kept(wire::topics::alert).size() == 1; }));
    first.reset();
    EXPECT_EQ(second->kept(wire::topics::alert).size(), 1U);
    say("chain.end");
    EXPECT_TRUE(eventually([&] { return second->kept(wire::topics::alert).size() == 2; }));
    second.reset();
    EXPECT_TRUE(is_matched_by(0)) << "a reader that nobody uses goes";
    const auto third = feed();
    EXPECT_TRUE(is_matched_by(1)) << "and comes again";
}

TEST_F(SharedFeeds, OfOtherKindsHaveReadersOfTheirOwn) {
    const auto page = feed(), watch = feed(Kind::newest);
    EXPECT_TRUE(is_matched_by(2)) << "what they keep is not the same";
}

/// Seats come and go while samples arrive, each on a thread of the door.
TEST_F(SharedFeeds, MayComeAndGoAtOnce) {
    const auto stays = feed();
    ASSERT_TRUE(is_matched_by(1));
    std::atomic<bool> over{false};
    std::array<std::jthread, 4> doors;
    for (std::jthread& door : doors)
        door = std::jthread([&] {
            while (!over) {
                const auto seat = feed();
                EXPECT_LE(seat->kept(wire::topics::alert).size(), 1U);
            }
        });
    ExerciseStatus status;
    wire::RawWriter tells(server_, wire::topics::exercise_status);
    for (int k = 0; k < 300; ++k) {
        say("brake.hot");
        status.time(300 - k); // back, so that all lines are told
        tells.write(wire::encode(status));
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    over = true;
    for (std::jthread& door : doors)
        door.join();
    EXPECT_EQ(says_.matched(), 1);
}

} // namespace
} // namespace windlass::gateway
