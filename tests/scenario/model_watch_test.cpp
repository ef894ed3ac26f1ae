// What the instructor and the recording are told of steps that were not what they should be.

#include "rigs/drill.hpp"
#include "server/exercise/watch/model_watch.hpp"

#include <gtest/gtest.h>

namespace windlass::exercise {
using namespace rigs;

namespace {

/// Cable of 100 m hanging in links of 0.1 m: a tick of 1/300 s in one step is too long for them.
ExerciseDef too_coarse() {
    ExerciseDef def = quiet_def(200, 100);
    def.model.adaptive = false;
    def.max_substeps = 1;
    def.tackle[0].chain.node_spacing = 0.1;
    return def;
}

TEST(ModelWatch, SaysOnceThatStepsAreInDoubtAndTellsThemEveryMinute) {
    Drill drill(too_coarse());
    drill.run(70);
    EXPECT_EQ(drill.count("model.in_doubt"), 1);
    EXPECT_EQ(drill.count("model.steps"), 1);
    EXPECT_EQ(drill.first("model.in_doubt")->severity, Severity::caution);
    EXPECT_NE(drill.first("model.steps")->text.find("too long"), std::string::npos)
        << drill.first("model.steps")->text;
    EXPECT_TRUE(drill.now().model_in_doubt);
    EXPECT_EQ(drill.now().model_steps.steps, 3000U);
}

TEST(ModelWatch, SaysNothingOfAnAnchorThatHangs) {
    ExerciseDef def = quiet_def(60, 25);
    Drill drill(def);
    drill.run(70);
    EXPECT_EQ(drill.count("model.in_doubt") + drill.count("model.steps"), 0);
    EXPECT_FALSE(drill.now().model_in_doubt);
}

TEST(ModelWatch, IsNotInDoubtOfALetGo) {
    Drill drill(let_go_def());
    ASSERT_TRUE(let_go_and_pay_out(drill, 4));
    const auto doubt = drill.first("model.in_doubt");
    EXPECT_FALSE(doubt) << (doubt ? doubt->text : "");
}

} // namespace
} // namespace windlass::exercise
