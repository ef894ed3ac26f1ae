// Connections that say nothing give way to those that come.

#include "station/gateway/lobby.hpp"

#include <gmock/gmock.h>

#include <vector>

namespace windlass::gateway {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class Lobbied : public ::testing::Test {
protected:
    std::unique_ptr<Lobby::Place> enter(const std::string& address) {
        auto place = lobby_.enter(address, turned_out_);
        const int number = ++entered_;
        place->turned_out_by([this, number] { out_.push_back(number); });
        return place;
    }

    Lobby lobby_{3};
    std::string turned_out_;
    int entered_ = 0;
    std::vector<int> out_; // numbers of those that were turned out
};

TEST_F(Lobbied, NobodyIsTurnedOutWhileThereIsRoom) {
    const auto a = enter("a"), b = enter("a"), c = enter("b");
    EXPECT_THAT(out_, IsEmpty());
    EXPECT_EQ(turned_out_, "");
    EXPECT_EQ(lobby_.size(), 3U);
}

TEST_F(Lobbied, WhoHasMostGivesUpTheOneThatHasBeenSilentForLongest) {
    const auto a = enter("many"), b = enter("many"), c = enter("one");
    a->heard();
    const auto d = enter("new");
    EXPECT_EQ(turned_out_, "many");
    EXPECT_THAT(out_, ElementsAre(2)) << "the first has spoken since";
    EXPECT_EQ(lobby_.size(), 3U);
}

TEST_F(Lobbied, OneWhoFloodsTurnsOutItself) {
    const auto honest = enter("honest");
    std::vector<std::unique_ptr<Lobby::Place>> flood;
    for (int i = 0; i < 100; ++i)
        flood.push_back(enter("flood"));
    EXPECT_EQ(out_.size(), 98U);
    EXPECT_THAT(out_, testing::Not(testing::Contains(1)));
}

TEST_F(Lobbied, APlaceThatIsGivenUpIsTheNextOnes) {
    auto a = enter("a"), b = enter("a"), c = enter("a");
    b.reset();
    const auto d = enter("b");
    EXPECT_THAT(out_, IsEmpty());
    a.reset(), c.reset();
    EXPECT_EQ(lobby_.size(), 1U);
}

TEST_F(Lobbied, OneThatWasTurnedOutLeavesWithoutTakingAnothersPlace) {
    auto a = enter("a"), b = enter("a"), c = enter("a");
    const auto d = enter("a");
    EXPECT_THAT(out_, ElementsAre(1));
    a->heard(); // too late
    a.reset();
    EXPECT_EQ(lobby_.size(), 3U);
}

} // namespace
} // namespace windlass::gateway
