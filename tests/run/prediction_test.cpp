// A prediction is what comes, where nobody does anything; and making one changes nothing.

#include "server/run/prediction.hpp"

#include "tests/run/session_rig.hpp"

namespace windlass::run {
namespace {

using test::give;
using test::levers;
using test::run_order;

class PredictionTest : public test::SessionTest {
protected:
    static PredictionView predict(const Session& session) {
        Branch branch(session.state(), session.status().run);
        while (branch.step()) {
        }
        return branch.found();
    }
    static void run(Session& session, double seconds) {
        for (int k = 0; k < std::lround(seconds * session.def().tick_rate_hz); ++k)
            session.tick();
    }
};

/// Goes on with the session and holds all that was predicted against it, every bit.
void expect_comes_true(Session& session, const PredictionView& found) {
    ASSERT_FALSE(found.moments.empty());
    EXPECT_EQ(found.tick, session.now_tick());
    EXPECT_EQ(found.run, session.status().run);
    std::vector<exercise::ExerciseEvent> called;
    std::size_t at = 0;
    const auto look = [&] {
        if (at == found.moments.size() || session.now_time() != found.moments[at].time) return;
        const PredictedMoment now = moment_of(session.snapshot()), &was = found.moments[at++];
        EXPECT_EQ(was.x, now.x) << now.time;
        EXPECT_EQ(was.y, now.y) << now.time;
        EXPECT_EQ(was.heading, now.heading) << now.time;
        ASSERT_EQ(was.cables.size(), now.cables.size());
        for (std::size_t k = 0; k < now.cables.size(); ++k)
            for_each_field<PredictedCable>([&](auto field) {
                EXPECT_EQ(field.of(was.cables[k]), field.of(now.cables[k])) << now.time << " s, cable " << k;
            });
    };
    look();
    const std::uint64_t end = session.now_tick() + Branch::kSeconds * 300ULL;
    while (session.now_tick() < end && session.tick()) {
        called.insert(called.end(), session.snapshot().events.begin(), session.snapshot().events.end());
        look();
    }
    EXPECT_EQ(at, found.moments.size());
    called.resize(std::min(called.size(), Branch::kMostEvents));
    ASSERT_EQ(found.events.size(), called.size());
    for (std::size_t k = 0; k < called.size(); ++k) {
        EXPECT_EQ(found.events[k].tick, called[k].tick);
        EXPECT_EQ(found.events[k].text, called[k].text);
    }
}

TEST_F(PredictionTest, ComesTrueToTheBitOfACableThatRuns) {
    Session session({}, options());
    give(session, levers(0));
    run(session, 3);
    const PredictionView found = predict(session);
    EXPECT_EQ(found.state, PredictionState::whole);
    EXPECT_EQ(found.moments.size(), 61U);
    EXPECT_EQ(found.time, 3);
    EXPECT_GT(found.moments.back().cables.at(0).cable_out, found.moments.front().cables.at(0).cable_out + 20);
    EXPECT_FALSE(found.events.empty()) << "she touches the bottom, at least";
    expect_comes_true(session, found);
}

TEST_F(PredictionTest, HasWhatComesByItself) {
    exercise::ExerciseDef def;
    def.faults = {{.code = exercise::FaultCode::brake_lining_faded,
                   .severity = 1,
                   .trigger = exercise::FaultTrigger::at_time,
                   .trigger_value = 10}};
    def.lesson = R"({"id": "T", "faults": [{"code": "load-cell-dead", "when": {"time": 20, "cable_speed":)"
                 R"( {"below": 99}}}], "criteria": [{"id": "v", "kind": "limit", "of": "cable_speed",)"
                 R"( "max": 99}]})";
    Session session(def, options());
    run(session, 2);
    const PredictionView found = predict(session);
    EXPECT_EQ(found.state, PredictionState::whole);
    EXPECT_EQ(std::ranges::count(found.events, "fault.active", &exercise::ExerciseEvent::code), 2)
        << "one armed by the file, one by the lesson";
    EXPECT_GT(found.moments.back().cables.at(0).cable_out, found.moments.front().cables.at(0).cable_out + 1)
        << "the brake has let go";
    expect_comes_true(session, found);
}

TEST_F(PredictionTest, EndsWhereTheLessonAsksASeat) {
    exercise::ExerciseDef def;
    def.lesson =
        R"({"id": "T", "criteria": [{"id": "out", "kind": "question", "ask": "How much is out?",)"
        R"( "of": "cable_out", "tolerance": 2, "when": {"time": 4.5, "cable_speed": {"below": 99}}}]})";
    Session session(def, options());
    run(session, 1);
    const PredictionView found = predict(session);
    EXPECT_EQ(found.state, PredictionState::asked);
    EXPECT_EQ(found.moments.back().time, 4.5);
    expect_comes_true(session, found);
    ASSERT_TRUE(session.held());
    const PredictionView held = predict(session);
    EXPECT_EQ(held.state, PredictionState::asked) << "nothing moves until somebody has answered";
    EXPECT_EQ(held.moments.size(), 1U);
}

TEST_F(PredictionTest, IsNotMadeOfAShipThatAnotherSimulatorSails) {
    Session session({}, options());
    run(session, 0.1);
    exercise::OwnShipSample sample;
    sample.position = session.snapshot().ship.position;
    sample.attitude = session.snapshot().ship.attitude;
    sample.time = 1;
    give(session, exercise::Order{sample});
    run(session, 0.1);
    const PredictionView found = predict(session);
    EXPECT_EQ(found.state, PredictionState::foreign);
    EXPECT_TRUE(found.moments.empty());
}

TEST_F(PredictionTest, IsOffUntilAnInstructorAsksForItAndNothingInTheExerciseComesOfThat) {
    Session session({}, options());
    EXPECT_FALSE(session.predicts());
    run(session, 0.1);
    const std::uint64_t orders = session.orders_taken(), hash = session.snapshot().state_hash;
    session.clear_news();
    RunOrder order = run_order(RunAction::predict);
    order.predict = true;
    give(session, order);
    give(session, order);
    EXPECT_TRUE(session.predicts());
    EXPECT_EQ(test::count(session, "exercise.prediction"), 1) << "said once";
    EXPECT_EQ(test::text_of(session, "exercise.prediction"), "predictions on by instructor");
    give(session, run_order(RunAction::reset));
    EXPECT_TRUE(session.predicts()) << "it stays on, whatever is run";
    order.predict = false;
    give(session, order);
    EXPECT_FALSE(session.predicts());
    EXPECT_GT(orders + 1, session.orders_taken()) << "it is no order that a recording goes through again";
    run(session, 0);
    give(session, run_order(RunAction::start));
    run(session, 0.1);
    EXPECT_EQ(session.snapshot().state_hash, hash);
}

} // namespace
} // namespace windlass::run
