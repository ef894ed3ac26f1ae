// A session that is not looked at in every tick.

#include "tests/run/session_rig.hpp"

namespace windlass::run {
namespace {

using namespace test;

/// The cable is to run no faster than 3 m/s.
exercise::ExerciseDef with_lesson() {
    exercise::ExerciseDef def;
    def.lesson = R"({"id": "T", "criteria": [{"id": "pace", "kind": "limit", "of": "cable_speed", "max": 3,)"
                 R"( "zero": 3, "from": {"time": 0.1}}]})";
    return def;
}

/// So many ticks, one in `every` of them looked at, with a let-go on the way.
std::unique_ptr<Session> ticked(const SessionOptions& options, int ticks, int every,
                                const exercise::ExerciseDef& def = {}) {
    auto session = std::make_unique<Session>(def, options);
    for (int k = 0; k < ticks; ++k) {
        if (k == 100) give(*session, levers(0));
        session->tick(k % every == 0);
    }
    give(*session, run_order(RunAction::pause));
    session->tick();
    return session;
}

TEST_F(SessionTest, IsTheSameHoweverSeldomItIsLookedAt) {
    const auto always = ticked(options(), 1501, 1), seldom = ticked(options(), 1501, 7);
    EXPECT_EQ(seldom->snapshot().state_hash, always->snapshot().state_hash);
    EXPECT_EQ(seldom->snapshot().tick, 1501U);
    std::vector<std::string> codes[2];
    for (const auto& event : always->events())
        codes[0].push_back(event.code + std::to_string(event.tick));
    for (const auto& event : seldom->events())
        codes[1].push_back(event.code + std::to_string(event.tick));
    EXPECT_EQ(codes[0], codes[1]);
    EXPECT_GT(codes[0].size(), 3U); // ready, started, let go, on the bottom
}

// A lesson sees every tick, and no hash where nobody else looks.
TEST_F(SessionTest, OfALessonComesToTheSameStateAndMarksHoweverSeldomItIsLookedAt) {
    const auto always = ticked(options(), 1501, 1, with_lesson());
    const auto seldom = ticked(options(), 1501, 7, with_lesson());
    EXPECT_EQ(seldom->snapshot().state_hash, always->snapshot().state_hash);
    EXPECT_NE(seldom->snapshot().state_hash, 0U);
    const assess::Result marks = always->assessor().result();
    EXPECT_LT(marks.criteria.at(0).milli, 1000); // something was lost
    EXPECT_EQ(seldom->assessor().result().criteria[0].milli, marks.criteria[0].milli);
    EXPECT_EQ(seldom->assessor().result().criteria[0].worst, marks.criteria[0].worst);
}

TEST_F(SessionTest, OfALessonHasNoHashOfATickThatNobodyLooksAt) {
    Session session(with_lesson(), options());
    session.tick(true);
    EXPECT_TRUE(session.seen());
    EXPECT_NE(session.snapshot().state_hash, 0U);
    session.tick(false);
    EXPECT_FALSE(session.seen());
    EXPECT_EQ(session.snapshot().tick, session.now_tick());
    EXPECT_EQ(session.snapshot().state_hash, 0U);
}

TEST_F(SessionTest, ShowsWhatWasCalledOutWhetherLookedAtOrNot) {
    Session session({}, options());
    bool shown = false;
    give(session, levers(0));
    for (int k = 0; k < 1500; ++k) {
        session.clear_news();
        session.tick(false);
        if (count(session, "anchor.let_go") == 0) continue;
        shown = session.seen() && session.snapshot().tick == session.now_tick();
        break;
    }
    EXPECT_TRUE(shown);
}

TEST_F(SessionTest, ShowsTheLastTickWhenItStandsStill) {
    Session session({}, options());
    for (int k = 0; k < 5; ++k)
        session.tick(false);
    EXPECT_FALSE(session.seen());
    give(session, run_order(RunAction::pause));
    session.tick(false);
    EXPECT_TRUE(session.seen());
    EXPECT_EQ(session.snapshot().tick, 5U);
}

} // namespace
} // namespace windlass::run
