// What a sample claims to hold is looked at before it is opened.

#include "tests/wire/hostile_rig.hpp"

#include <atomic>
#include <random>

namespace windlass::test {
namespace {

/// A sequence as long as its bound is opened; a longer claim is not.
template <class T>
void expect_claims_checked(const T& full, std::uint32_t bound, std::size_t sequences) {
    const auto bytes = cdr(full);
    EXPECT_TRUE(wire::claims_within_bounds<T>(bytes));
    const auto lengths = places(bytes, bound);
    ASSERT_EQ(lengths.size(), sequences);
    for (const auto at : lengths) {
        EXPECT_FALSE(wire::claims_within_bounds<T>(with(bytes, at, bound + 1)));
        EXPECT_FALSE(wire::claims_within_bounds<T>(with(bytes, at, 0xFFFFFFFFU)));
        Payload cut(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(at));
        EXPECT_FALSE(wire::claims_within_bounds<T>(cut));
    }
}

TEST(Bounds, AreLookedAtBeforeASampleIsOpened) {
    ExerciseStatus status;
    status.exercise("a"); // lengths of texts that leave what follows at odd places
    status.title("some title");
    status.faults().resize(32);
    expect_claims_checked(status, 32, 1);
    ChainState chain;
    chain.nodes().resize(2048);
    chain.tension().resize(2048);
    expect_claims_checked(chain, 2048, 2);
    ChainState marked;
    marked.marks().resize(64);
    expect_claims_checked(marked, 64, 1);
    Assessment assessment;
    assessment.criteria().resize(64);
    expect_claims_checked(assessment, 64, 1);
    Checkpoint checkpoint;
    checkpoint.data().resize(1048576);
    expect_claims_checked(checkpoint, 1048576, 1);
    RestoreCommand restore;
    restore.origin().source("abc");
    restore.from("monday");
    restore.checkpoint().resize(1048576);
    expect_claims_checked(restore, 1048576, 1);
    ClassroomStatus servers;
    servers.server("a");
    servers.exercises().resize(64);
    expect_claims_checked(servers, 64, 1);
    ClassroomCommand order;
    order.id("ab");
    order.exercise("file");
    order.definition().resize(262144);
    expect_claims_checked(order, 262144, 1);
}

TEST(Bounds, KnowEverySequenceOfTheIdl) {
    std::ifstream idl(WINDLASS_IDL);
    std::size_t sequences = 0;
    for (std::string line; std::getline(idl, line);)
        if (line.find("  sequence<") == 0) ++sequences;
    EXPECT_EQ(sequences, 9U) << "a new sequence needs its bound in idl/bounds.cpp, and a line above";
}

TEST(Station, IsNotHarmedByHugeSequencesNorByGarbage) {
    wire::Participant server(member("fake-server")), station(member("station"));
    std::atomic<int> good = 0, wrong = 0;
    const wire::Reader<ChainState> reader(
        station, topics::chain_state, [&](const ChainState&, const wire::WriterId&) { ++good; },
        [&] { ++wrong; });
    wire::RawWriter writer(server, topics::chain_state);
    ASSERT_TRUE(eventually([&] { return writer.matched() == 1; }));

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
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_GE(wrong, 200);
    EXPECT_EQ(good, 0);
    EXPECT_TRUE(eventually([&] {
        writer.write(bytes);
        return good > 0;
    }));
    EXPECT_LT(memory(getpid()) - before, 16); // MB; one such claim would have been 48 GB
}

} // namespace
} // namespace windlass::test
