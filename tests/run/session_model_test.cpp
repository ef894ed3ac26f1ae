// What a session says of the model's own steps.

#include "tests/run/session_rig.hpp"

namespace windlass::run {
namespace {

using namespace test;

TEST_F(SessionTest, TellsInstructorsThatStepsOfTheModelAreInDoubt) {
    // Links of 0.1 m on 100 m of hanging cable: a whole tick is too long a step for them.
    exercise::ExerciseDef def;
    def.model.adaptive = false;
    def.max_substeps = 1;
    def.environment.depth = 200;
    def.tackle[0].cable_out = 100;
    def.tackle[0].chain.node_spacing = 0.1;
    Session session(def, options());
    session.clear_news();
    for (int k = 0; k < 10 * def.tick_rate_hz; ++k)
        ASSERT_TRUE(session.tick());
    ASSERT_EQ(session.alerts().size(), 1U);
    const AlertView& alert = session.alerts().front();
    EXPECT_EQ(alert.code, "model.in_doubt");
    EXPECT_EQ(alert.priority, AlertPriority::caution);
    EXPECT_FALSE(alert.deck_panel || alert.bridge_panel); // about the simulation, for instructors
    EXPECT_NE(alert.explanation.find("too long"), std::string::npos) << alert.explanation;
    EXPECT_EQ(count(session, "model.in_doubt"), 1);
}

} // namespace
} // namespace windlass::run
