// The recorder as a child process.

#include "station/gateway/recorder_process.hpp"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

namespace windlass::gateway {
namespace {

TEST(RecorderProcess, HasNothingOpenThatItsParentHas) {
    int ends[2];
    ASSERT_EQ(pipe2(ends, 0), 0); // as a socket that was accepted: it goes to child processes
    RecorderProcess child("/usr/bin/sleep", {"1000"});
    close(ends[1]);
    pollfd reader{ends[0], POLLIN, 0};
    EXPECT_EQ(poll(&reader, 1, 2000), 1) << "the child has the other end, which is so not closed";
    EXPECT_FALSE(child.ended());
    close(ends[0]);
}

} // namespace
} // namespace windlass::gateway
