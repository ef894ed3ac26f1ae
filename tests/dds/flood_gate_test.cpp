#include "server/dds/flood_gate.hpp"

#include <gtest/gtest.h>

namespace windlass::dds {
namespace {

wire::WriterId writer(int number) {
    wire::WriterId id{};
    id[0] = static_cast<std::uint8_t>(number);
    id[1] = static_cast<std::uint8_t>(number >> 8);
    return id;
}

int passed(FloodGate& gate, const wire::WriterId& who, int samples, double begin, double period) {
    int count = 0;
    for (int i = 0; i < samples; ++i)
        count += gate.pass(who, begin + i * period) ? 1 : 0;
    return count;
}

TEST(FloodGate, LetsABurstPassAndThenTheRate) {
    FloodGate gate({.per_second = 20, .burst = 50});
    EXPECT_EQ(passed(gate, writer(1), 100, 0, 0), 50);
    EXPECT_NEAR(passed(gate, writer(1), 100000, 1e-4, 1e-4), 200, 1); // 10 s at 10 kHz; the first is a part
    EXPECT_EQ(passed(gate, writer(1), 100, 100, 0), 50);
}

TEST(FloodGate, LetsAHeldLeverPassForEver) {
    FloodGate gate({.per_second = 500, .burst = 250});
    EXPECT_EQ(passed(gate, writer(1), 24000, 0, 1.0 / 240), 24000);
}

TEST(FloodGate, OneWriterDoesNotUseUpWhatAnotherMaySay) {
    FloodGate gate({.per_second = 20, .burst = 50});
    EXPECT_EQ(passed(gate, writer(1), 1000, 0, 0), 50);
    EXPECT_EQ(passed(gate, writer(2), 10, 0, 0), 10);
}

TEST(FloodGate, ForgetsTheWriterNotHeardForLongest) {
    FloodGate gate({.per_second = 1, .burst = 1});
    for (int i = 0; i < 1000; ++i)
        EXPECT_TRUE(gate.pass(writer(i), i * 1e-4));
    EXPECT_FALSE(gate.pass(writer(999), 0.1)); // still known
    EXPECT_TRUE(gate.pass(writer(0), 0.1));    // forgotten, and so fresh
}

} // namespace
} // namespace windlass::dds
