// The lookout beside an exercise that ticks: what it shows is right, what it costs is bounded, and the
// exercise goes on as if it were not there.

#include "server/host/lookout.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace windlass::host {
namespace {

using namespace std::chrono_literals;
using run::PredictionState;
using run::PredictionView;
using run::Session;

constexpr auto kLong = 20s; // for what comes at once on a machine that has nothing else to do

class LookoutTest : public testing::Test {
protected:
    static run::SessionOptions options() {
        run::SessionOptions options;
        options.fault_folder = testing::TempDir();
        options.seed = 1;
        return options;
    }
    static void give(Session& session, run::OrderContent order) {
        run::Inbox inbox;
        inbox.orders.push_back({"instructor", std::move(order)});
        session.carry_out(inbox, 0);
    }
    static void ask(Session& session, bool on) {
        run::RunOrder order;
        order.action = run::RunAction::predict;
        order.predict = on;
        give(session, order);
    }
    static void let_go(Session& session) {
        give(session, exercise::Order{exercise::WindlassOrder{.brake = 0}});
    }
    /// As a beat of its thread does.
    void look(const Session& session, Outlook::Time now = Outlook::Clock::now()) {
        const auto tell = [this](const PredictionView& prediction) { told_.push_back(prediction); };
        if (outlook_->look(session, now, tell)) lookout_.call();
    }
    /// Up to the next that is told; nothing: none came in that time.
    std::optional<PredictionView> next(const Session& session, std::chrono::milliseconds time = kLong) {
        told_.clear();
        for (const auto end = Outlook::Clock::now() + time; told_.empty() && Outlook::Clock::now() < end;) {
            look(session);
            std::this_thread::sleep_for(1ms);
        }
        return told_.empty() ? std::nullopt : std::optional(told_.front());
    }

    Lookout lookout_;
    std::shared_ptr<Outlook> outlook_ = lookout_.add();
    std::vector<PredictionView> told_;
};

TEST_F(LookoutTest, SaysNothingUnlessItIsAskedAndSaysWhenItIsNoMore) {
    Session session({}, options());
    EXPECT_EQ(next(session, 100ms), std::nullopt);
    ask(session, true);
    EXPECT_EQ(next(session)->state, PredictionState::awaited);
    const auto made = next(session);
    ASSERT_TRUE(made);
    EXPECT_EQ(made->state, PredictionState::whole);
    EXPECT_EQ(made->run, session.status().run);
    EXPECT_EQ(made->moments.size(), 61U);
    EXPECT_GT(made->processor_time, 0);
    ask(session, false);
    EXPECT_EQ(next(session)->state, PredictionState::off);
    EXPECT_EQ(next(session, 100ms), std::nullopt);
    ask(session, true);
    EXPECT_EQ(next(session)->state, PredictionState::awaited);
    EXPECT_EQ(next(session)->state, PredictionState::whole) << "though it is the same as before";
}

TEST_F(LookoutTest, LooksOnceAtAnExerciseThatStandsAndAgainWhenALeverIsMoved) {
    Session session({}, options());
    run::RunOrder pause;
    pause.action = run::RunAction::pause;
    give(session, pause);
    ask(session, true);
    next(session);
    const auto first = next(session);
    ASSERT_TRUE(first);
    const auto rest = std::chrono::duration_cast<std::chrono::milliseconds>(
        std::chrono::duration<double>(first->processor_time / Outlook::kShare));
    EXPECT_EQ(next(session, rest + 500ms), std::nullopt) << "it would be the same";
    let_go(session);
    const auto second = next(session);
    ASSERT_TRUE(second);
    EXPECT_EQ(second->tick, first->tick);
    EXPECT_NE(second->moments.back().cables.at(0).cable_out, first->moments.back().cables.at(0).cable_out);
}

TEST_F(LookoutTest, TellsAnewWhichRunItIsOf) {
    Session session({}, options());
    ask(session, true);
    next(session);
    ASSERT_TRUE(next(session));
    run::RunOrder reset;
    reset.action = run::RunAction::reset;
    give(session, reset);
    const auto told = next(session);
    ASSERT_TRUE(told);
    EXPECT_EQ(told->state, PredictionState::awaited);
    EXPECT_EQ(told->run, session.status().run);
}

/// The tenth of a core, over the time in which an exercise runs; and its bits.
TEST_F(LookoutTest, TakesATenthOfACoreAtMostAndChangesNoBitOfTheExercise) {
    Session with({}, options()), without({}, options());
    ask(with, true);
    let_go(with), let_go(without);
    const auto began = Outlook::Clock::now();
    double spent = 0, last = 0;
    std::size_t made = 0;
    while (made < 2 && Outlook::Clock::now() - began < 90s) {
        for (int tick = 0; tick < 30; ++tick)
            with.tick(), without.tick();
        ASSERT_EQ(with.snapshot().state_hash, without.snapshot().state_hash) << with.now_time();
        EXPECT_EQ(with.orders_taken(), without.orders_taken());
        told_.clear();
        look(with);
        for (const PredictionView& prediction : told_) {
            if (prediction.moments.empty()) continue;
            ++made;
            spent += last = prediction.processor_time;
            EXPECT_LT(last, Outlook::kMostTime + 0.2);
        }
        std::this_thread::sleep_for(20ms);
    }
    const std::chrono::duration<double> lasted = Outlook::Clock::now() - began;
    EXPECT_EQ(made, 2U);
    // What the last one took is worked off after it.
    EXPECT_LE(spent - last, Outlook::kShare * lasted.count());
}

TEST_F(LookoutTest, OfAnExerciseThatStandsGoesToItsEndHoweverLongItWaitedForACore) {
    run::SessionOptions waits = options();
    waits.wait = true;
    Session session({}, waits);
    ask(session, true);
    look(session, Outlook::Clock::now() - Outlook::kPatience - 1s);
    const auto made = next(session);
    ASSERT_TRUE(made);
    EXPECT_EQ(made->state, PredictionState::whole);
    EXPECT_EQ(made->moments.size(), 61U);
}

TEST_F(LookoutTest, ThatIsGivenUpComesAsFarAsItWas) {
    Session session({}, options());
    ask(session, true);
    look(session, Outlook::Clock::now() - Outlook::kPatience - 1s); // as if it had waited for a core so long
    const auto made = next(session);
    ASSERT_TRUE(made);
    EXPECT_EQ(made->state, PredictionState::dear);
    EXPECT_GE(made->moments.size(), 1U);
    EXPECT_LT(made->moments.size(), 61U);
}

} // namespace
} // namespace windlass::host
