// RECORDING@TIME, as an instructor types it.

#include "instructor_console/recording_position.hpp"

#include <gtest/gtest.h>

namespace windlass::console {
namespace {

TEST(RecordingPosition, IsSecondsOrMinutesBehindTheLastAt) {
    EXPECT_EQ(moment_in("monday@12.5")->time, 12.5);
    EXPECT_EQ(moment_in("monday@2:13.5")->time, 133.5);
    EXPECT_EQ(moment_in("monday@0:05")->time, 5);
    EXPECT_EQ(moment_in("recordings/crew@sea/monday.mcap@3")->recording, "recordings/crew@sea/monday.mcap");
}

TEST(RecordingPosition, OfAnyOtherFormIsNone) {
    for (const char* text : {"", "12", "monday", "@12", "monday@", "monday@x", "monday@-1", "monday@1:60",
                             "monday@1:2:3", "monday@nan", "monday@inf", "monday@12 ", "monday@0x10"})
        EXPECT_FALSE(moment_in(text)) << text;
}

} // namespace
} // namespace windlass::console
