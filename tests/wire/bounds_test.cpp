// Bounds over the wire: what is too long is not sent, and what claims to be is not opened. Every type and
// every sequence: tests/idl/bounds_test.cpp.

#include "tests/wire/hostile_rig.hpp"

#include <atomic>
#include <random>

namespace windlass::test {
namespace {

TEST(Writer, SendsNothingBeyondABoundHoweverDeepItLies) {
    wire::Participant server(member("server"));
    wire::Writer<EnvironmentState> writer(server, topics::environment_state);
    EnvironmentState state;
    state.after().current_profile().resize(64);
    EXPECT_TRUE(writer.write(state));
    state.after().current_profile().resize(65);
    EXPECT_FALSE(writer.write(state));
    wire::Writer<ChainState> stream(server, topics::chain_state);
    ChainState chain;
    chain.marks().resize(65);
    EXPECT_FALSE(stream.write(chain));
    chain.marks().resize(64);
    EXPECT_TRUE(stream.write(chain));
}

TEST(Station, IsNotHarmedByHugeSequencesNorByGarbage) {
    wire::Participant server(member("fake-server")), station(member("station"));
    std::atomic<int> good = 0, wrong = 0;
    const wire::Reader<ChainState> reader(
        station, topics::chain_state, [&](const ChainState&, const wire::WriterId&) { ++good; },
        [&] { ++wrong; });
    wire::RawWriter writer(server, topics::chain_state);
    ASSERT_TRUE(rigs::eventually([&] { return writer.matched() == 1; }));

    ChainState chain;
    chain.nodes().resize(5);
    const auto bytes = cdr(chain);
    const auto lengths = places(bytes, 5);
    ASSERT_EQ(lengths.size(), 1U);
    const double before = memory(getpid());
    std::mt19937 random(7);
    for (std::uint32_t i = 0; i < 10000 && wrong < 200; ++i) { // best effort: some are overwritten
        writer.write(with(bytes, lengths[0], 0xFFFFFFFFU - i));
        Payload garbage(64 + random() % 200);
        std::generate(garbage.begin(), garbage.end(), [&] { return static_cast<std::uint8_t>(random()); });
        writer.write(garbage);
        rigs::pace(std::chrono::milliseconds(1));
    }
    EXPECT_GE(wrong, 200);
    EXPECT_EQ(good, 0);
    EXPECT_TRUE(rigs::eventually([&] {
        writer.write(bytes);
        return good > 0;
    }));
    EXPECT_LT(memory(getpid()) - before, 16); // MB; one such claim would have been 48 GB
}

} // namespace
} // namespace windlass::test
