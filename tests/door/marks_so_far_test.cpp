// What the page of a class is told of a lesson that runs: the figures of its desk (kit/points_said.test.ts).

#include "door/marks_so_far.hpp"

#include <gtest/gtest.h>

namespace windlass::door {
namespace {

Criterion criterion(unsigned weight, CriterionState state, unsigned counted, std::uint64_t decided) {
    Criterion made;
    made.kind(CRITERION_ORDER);
    made.state(state);
    made.weight(weight);
    made.counted(counted);
    made.counts(state != CRITERION_NOT_IN_PLAY);
    made.tick(decided);
    return made;
}

TEST(MarksSoFar, AreOfWhatIsDecidedInPointsOfTheWholeLesson) {
    Assessment marks;
    EXPECT_FALSE(marks_so_far(marks));
    Criterion stance = criterion(30, CRITERION_OPEN, 0, 0);
    stance.kind(CRITERION_RUBRIC);
    marks.criteria({criterion(10, CRITERION_MET, 600, 50), criterion(20, CRITERION_OPEN, 1000, 0),
                    criterion(20, CRITERION_NOT_IN_PLAY, 0, 0), stance});
    const auto found = marks_so_far(marks);
    ASSERT_TRUE(found);
    EXPECT_DOUBLE_EQ(found->points, 12);
    EXPECT_DOUBLE_EQ(found->lost, 8);
}

// A limit that was broken is not made good again; a report that was not made yet may still be.
TEST(MarksSoFar, WhatIsLostForGoodIsToldBeforeItIsDecided) {
    Assessment marks;
    Criterion pay_out = criterion(15, CRITERION_OPEN, 0, 0), piled = criterion(10, CRITERION_OPEN, 700, 0);
    pay_out.kind(CRITERION_LIMIT);
    piled.kind(CRITERION_STATE_AT);
    marks.criteria({pay_out, piled, criterion(75, CRITERION_OPEN, 0, 0)});
    const auto found = marks_so_far(marks);
    ASSERT_TRUE(found);
    EXPECT_DOUBLE_EQ(found->points, 0);
    EXPECT_DOUBLE_EQ(found->lost, 18);
}

TEST(MarksSoFar, AnAssessorsWordCountsAsSoonAsItIsSaid) {
    Assessment marks;
    Criterion excused = criterion(80, CRITERION_OVERRIDDEN, 0, 0);
    excused.counts(false);
    marks.criteria(
        {criterion(10, CRITERION_OVERRIDDEN, 1000, 0), criterion(10, CRITERION_NOT_MET, 0, 50), excused});
    const auto found = marks_so_far(marks);
    ASSERT_TRUE(found);
    EXPECT_DOUBLE_EQ(found->points, 50);
    EXPECT_DOUBLE_EQ(found->lost, 50);
}

} // namespace
} // namespace windlass::door
