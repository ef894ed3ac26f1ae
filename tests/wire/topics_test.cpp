// What the topic table promises, between two participants on this host.

#include "idl/wire.hpp"

#include "rigs/own_domain.hpp"
#include "rigs/wait.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <optional>
#include <thread>

namespace windlass::wire {
namespace {

using rigs::eventually;
using rigs::own_domain;
using namespace std::chrono_literals;

WindlassCommand command(double brake, const char* source) {
    WindlassCommand c;
    c.side(SIDE_PORT);
    c.brake(brake);
    c.origin().source(source);
    return c;
}

TEST(Topics, ChainStateOfAFullCableArrivesUnchanged) {
    Participant server({own_domain(), "exercise/a", "server"});
    Participant client({own_domain(), "exercise/a", "client"});
    std::mutex mutex;
    ChainState heard;
    Reader<ChainState> reader(client, topics::chain_state, [&](const ChainState& sample) {
        const std::lock_guard lock(mutex);
        heard = sample;
    });
    Writer<ChainState> writer(server, topics::chain_state);
    ASSERT_TRUE(eventually([&] { return writer.matched() == 1 && reader.matched() == 1; }));

    ChainState sent;
    sent.side(SIDE_STARBOARD);
    sent.nodes().resize(2048);
    sent.tension().resize(2047);
    for (int i = 0; i < 2048; ++i)
        sent.nodes()[i].z(static_cast<float>(-i));
    ASSERT_TRUE(eventually([&] {
        EXPECT_TRUE(writer.write(sent));
        const std::lock_guard lock(mutex);
        return heard.nodes().size() == 2048;
    }));
    const std::lock_guard lock(mutex);
    EXPECT_EQ(heard.side(), SIDE_STARBOARD);
    EXPECT_EQ(heard.nodes()[2047].z(), -2047.0F);
    EXPECT_EQ(heard.tension().size(), 2047U);
}

TEST(Topics, SequenceBeyondItsBoundIsNotWritten) {
    Participant server({own_domain(), "exercise/a", "server"});
    Writer<ChainState> writer(server, topics::chain_state);
    ChainState sample;
    sample.nodes().resize(2049);
    EXPECT_FALSE(writer.write(sample));
}

TEST(Topics, LateJoinerGetsEveryEventInOrder) {
    Participant server({own_domain(), "exercise/a", "server"});
    Writer<Event> writer(server, topics::event);
    for (int i = 1; i <= 500; ++i) {
        Event e;
        e.number(i);
        ASSERT_TRUE(writer.write(e));
    }
    Participant client({own_domain(), "exercise/a", "client"});
    std::mutex mutex;
    std::vector<std::uint64_t> numbers;
    Reader<Event> reader(client, topics::event, [&](const Event& e) {
        const std::lock_guard lock(mutex);
        numbers.push_back(e.number());
    });
    EXPECT_TRUE(eventually([&] {
        const std::lock_guard lock(mutex);
        return numbers.size() == 500;
    }));
    const std::lock_guard lock(mutex);
    for (std::size_t i = 0; i < numbers.size(); ++i)
        ASSERT_EQ(numbers[i], i + 1);
}

TEST(Topics, StrongerWriterTakesOverAndTheWeakerIsHeardAgainWhenItFallsSilent) {
    Participant server({own_domain(), "exercise/a", "server"});
    Participant trainee({own_domain(), "exercise/a", "trainee"});
    Participant instructor({own_domain(), "exercise/a", "instructor"});
    std::atomic<double> brake{-1};
    Reader<WindlassCommand> reader(server, topics::windlass_command,
                                   [&](const WindlassCommand& c) { brake = c.brake(); });
    Writer<WindlassCommand> weak(trainee, topics::windlass_command, 10);
    Writer<WindlassCommand> strong(instructor, topics::windlass_command, 20);
    ASSERT_TRUE(eventually([&] { return weak.matched() == 1 && strong.matched() == 1; }));

    const auto weak_writes = [&] { return weak.write(command(0.25, "trainee")); };
    ASSERT_TRUE(eventually([&] { return weak_writes() && brake == 0.25; }));
    // Of the two, written one after the other, the stronger one stands.
    ASSERT_TRUE(eventually([&] {
        strong.write(command(0.75, "instructor"));
        weak_writes();
        return brake == 0.75;
    }));
    EXPECT_TRUE(eventually([&] { return weak_writes() && brake == 0.25; }));
}

TEST(Topics, ReaderIsToldOfWritersThatAreThereAndAtOnceOfOneThatIsDisposedOf) {
    Participant server({own_domain(), "exercise/a", "server"});
    Participant client({own_domain(), "exercise/a", "client"});
    std::mutex mutex;
    std::vector<std::pair<WriterId, bool>> met;
    const auto told = [&] {
        const std::lock_guard lock(mutex);
        return met;
    };
    Reader<WindlassCommand> reader(
        server, topics::windlass_command, [](const WindlassCommand&, const WriterId&) {}, {},
        [&](const WriterId& writer, bool there) {
            const std::lock_guard lock(mutex);
            met.emplace_back(writer, there);
        });
    Writer<WindlassCommand> stays(client, topics::windlass_command);
    std::optional<Writer<WindlassCommand>> leaves(std::in_place, client, topics::windlass_command);
    const std::pair one{stays.id(), true}, other{leaves->id(), true}, gone{leaves->id(), false};
    ASSERT_TRUE(eventually([&] { return told().size() == 2; }));
    EXPECT_THAT(told(), testing::UnorderedElementsAre(one, other));
    leaves.reset();
    EXPECT_TRUE(eventually([&] { return told().size() == 3; }));
    EXPECT_EQ(told().back(), gone);
}

TEST(Topics, PartitionsDoNotMix) {
    Participant one({own_domain(), "exercise/one", "server"});
    Participant two({own_domain(), "exercise/two", "server"});
    Participant member({own_domain(), "exercise/two", "client"});
    Participant every({own_domain(), "exercise/*", "recorder"});
    std::atomic<int> heard_member{0};
    std::atomic<int> heard_every{0};
    Reader<Event> reader(member, topics::event, [&](const Event&) { ++heard_member; });
    Reader<Event> recorder(every, topics::event, [&](const Event&) { ++heard_every; });
    Writer<Event> first(one, topics::event);
    Writer<Event> second(two, topics::event);
    ASSERT_TRUE(first.write(Event{}));
    ASSERT_TRUE(eventually([&] { return heard_every == 1; }));
    ASSERT_TRUE(second.write(Event{}));
    ASSERT_TRUE(eventually([&] { return heard_every == 2 && heard_member == 1; }));
    EXPECT_EQ(first.matched(), 1);  // the recorder
    EXPECT_EQ(second.matched(), 2); // and the member
}

TEST(Topics, OneMemberInTwoPartitionsWritesToEachOnAThreadOfItsOwn) {
    const Participant member({own_domain(), "exercise/none", "host"});
    Participant client({own_domain(), "exercise/*", "client"});
    std::atomic<int> wrong{0};
    std::array<std::atomic<int>, 2> heard{};
    const auto write = [&](int side) {
        const std::string partition = "exercise/" + std::to_string(side);
        Participant own(member, partition);
        Participant listener(client, partition);
        const Reader<AnchorState> reader(listener, topics::anchor_state,
                                         [&heard, &wrong, side](const auto& s) {
                                             if (s.side() != side || s.height_above_bottom() != side) ++wrong;
                                             ++heard.at(side);
                                         });
        Writer<AnchorState> writer(own, topics::anchor_state);
        AnchorState sample; // keyed: keys of both are made at the same time
        sample.side(side);
        sample.height_above_bottom(side);
        EXPECT_TRUE(eventually([&] { return writer.matched() == 1 && reader.matched() == 1; }));
        EXPECT_TRUE(eventually([&] {
            for (int i = 0; i < 100; ++i)
                writer.write(sample);
            return heard.at(side) >= 1000;
        }));
    };
    std::thread port(write, SIDE_PORT), starboard(write, SIDE_STARBOARD);
    port.join();
    starboard.join();
    EXPECT_EQ(wrong, 0);
}

TEST(Topics, HighestDomainWorks) {
    Participant server({232, "exercise/a", "server"});
    Participant client({232, "exercise/a", "client"});
    std::atomic<int> heard{0};
    Reader<Event> reader(client, topics::event, [&](const Event&) { ++heard; });
    Writer<Event> writer(server, topics::event);
    ASSERT_TRUE(writer.write(Event{}));
    EXPECT_TRUE(eventually([&] { return heard > 0; }));
}

TEST(Topics, DomainOutOfRangeIsRefusedWithTheRange) {
    try {
        Participant p({233, "exercise/a", "x"});
        FAIL() << "no error";
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("0..232"), std::string::npos) << error.what();
    }
}

} // namespace
} // namespace windlass::wire
