// A participant that means harm, or does not know better: what it sends changes nothing but the log of
// events, and costs no memory.

#include "idl/raw.hpp"
#include "tests/wire/server_process.hpp"

#include <fastcdr/Cdr.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <mutex>
#include <random>

namespace windlass::test {
namespace {

namespace topics = wire::topics;
using Payload = std::vector<std::uint8_t>;

template <class T>
Payload cdr(const T& sample) {
    Payload bytes(T::getCdrSerializedSize(sample) + 8);
    eprosima::fastcdr::FastBuffer buffer(reinterpret_cast<char*>(bytes.data()), bytes.size());
    eprosima::fastcdr::Cdr out(buffer, eprosima::fastcdr::Cdr::DEFAULT_ENDIAN,
                               eprosima::fastcdr::Cdr::DDS_CDR);
    out.serialize_encapsulation();
    sample.serialize(out);
    bytes.resize(out.getSerializedDataLength());
    return bytes;
}

/// Places of that number among the 32-bit words of a payload.
std::vector<std::size_t> places(const Payload& bytes, std::uint32_t number) {
    std::vector<std::size_t> found;
    for (std::size_t at = 4; at + 4 <= bytes.size(); at += 4)
        if (std::memcmp(&bytes[at], &number, 4) == 0) found.push_back(at);
    return found;
}

Payload with(Payload bytes, std::size_t at, std::uint32_t number) {
    std::memcpy(&bytes[at], &number, 4);
    return bytes;
}

/// MB that a process holds now.
double memory(pid_t pid) {
    std::ifstream status("/proc/" + std::to_string(pid) + "/status");
    for (std::string word; status >> word;)
        if (word == "VmRSS:" && status >> word) return std::stod(word) / 1024;
    return 0;
}

wire::Session member(const std::string& name) {
    return {own_domain(), "exercise/hostile", name};
}

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

/// A server that stands ready, so that not one bit of its state may change; and who watches it.
class Hostile : public ::testing::Test {
protected:
    Hostile() {
        EXPECT_TRUE(eventually([&] { return status().time_scale() > 0; })) << server_.text();
        before_ = status();
        memory_before_ = memory(server_.pid());
        heard_at_ = std::chrono::steady_clock::now();
    }
    ExerciseStatus status() const {
        const std::lock_guard lock(mutex_);
        return status_;
    }
    bool has_refused(const std::string& text) const {
        const std::lock_guard lock(mutex_);
        return std::any_of(events_.begin(), events_.end(), [&](const Event& e) {
            return e.code().to_string() == "command.refused" &&
                   e.text().to_string().find(text) != std::string::npos;
        });
    }
    std::size_t events() const {
        const std::lock_guard lock(mutex_);
        return events_.size();
    }
    /// s since the server was first heard: a flood takes as long as the machine needs for it.
    double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - heard_at_).count();
    }
    /// The exercise is as it was, and goes on serving; its memory has not grown.
    void expect_unharmed(bool to_the_bit = true) {
        EXPECT_TRUE(eventually([&, tick = status().tick()] { return status().tick() >= tick; }));
        std::this_thread::sleep_for(std::chrono::milliseconds(500)); // two more status samples
        const auto now = status();
        if (to_the_bit) {
            EXPECT_EQ(now.state_hash(), before_.state_hash());
        }
        EXPECT_EQ(now.state(), before_.state());
        EXPECT_EQ(now.time_scale(), before_.time_scale());
        EXPECT_EQ(now.wind_speed(), before_.wind_speed());
        EXPECT_TRUE(now.faults().empty());
        // MB; queues of fixed size fill up, and every writer that joined is remembered.
        EXPECT_LT(memory(server_.pid()) - memory_before_, 32) << server_.text();
        EXPECT_TRUE(eventually([&] { // a trainee still gets its hands on the levers
            WindlassCommand levers;
            levers.side(SIDE_PORT);
            levers.brake(0.5);
            levers.origin().source("trainee");
            levers.origin().serial(++serial_);
            levers.origin().sent_unix_ns(std::chrono::system_clock::now().time_since_epoch().count());
            levers_.write(levers);
            const std::lock_guard lock(mutex_);
            return std::any_of(events_.begin(), events_.end(),
                               [](const Event& e) { return e.code() == "levers.taken"; });
        })) << server_.text();
    }
    template <class T>
    void matched(const T& writer) {
        ASSERT_TRUE(eventually([&] { return writer.matched() > 0; }));
    }

    const ServerProcess server_{
        {"--domain", std::to_string(own_domain()), "--name", "hostile", "--partition", "hostile", "--wait"}};
    wire::Participant enemy_{member("enemy")};

private:
    mutable std::mutex mutex_;
    ExerciseStatus status_, before_;
    double memory_before_ = 0;
    std::chrono::steady_clock::time_point heard_at_;
    std::vector<Event> events_;
    std::uint64_t serial_ = 0;
    wire::Participant watcher_{member("watcher")};
    wire::Writer<WindlassCommand> levers_{watcher_, topics::windlass_command, 10};
    wire::Reader<ExerciseStatus> statuses_{watcher_, topics::exercise_status,
                                           [this](const ExerciseStatus& s) {
                                               const std::lock_guard lock(mutex_);
                                               status_ = s;
                                           }};
    wire::Reader<Event> log_{watcher_, topics::event, [this](const Event& e) {
                                 const std::lock_guard lock(mutex_);
                                 events_.push_back(e);
                             }};
};

template <class T>
T signed_by(const std::string& source, std::uint64_t serial) {
    T sample;
    sample.origin().source(source);
    sample.origin().serial(serial);
    sample.origin().sent_unix_ns(std::chrono::system_clock::now().time_since_epoch().count());
    return sample;
}

TEST_F(Hostile, PayloadsThatAreNoneAreRefusedUnopened) {
    std::mt19937 random(3);
    for (const auto& row : topics::all) {
        if (row.from_server || std::string(row.name).starts_with("Replay") || row.rate == 60) continue;
        wire::RawWriter writer(enemy_, row);
        matched(writer);
        for (int i = 0; i < 300; ++i) {
            Payload garbage(4 + random() % 300, 0xFF);
            if (i % 3 != 0) // a third is all ones: booleans of 255, texts of 4 GB
                std::generate(garbage.begin(), garbage.end(),
                              [&] { return static_cast<std::uint8_t>(random()); });
            if (i % 2 != 0) std::copy_n("\0\1\0\0", 4, garbage.begin()); // a true header
            writer.write(garbage);
        }
        EXPECT_TRUE(eventually([&] {
            return has_refused(std::string(row.name) + " from (unnamed): payload");
        })) << row.name;
    }
    expect_unharmed();
}

TEST_F(Hostile, NumbersThatAreNoneAndCodesThatAreNoneAreRefused) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    wire::Writer<WindlassCommand> levers(enemy_, topics::windlass_command, 99);
    wire::Writer<HelmCommand> helm(enemy_, topics::helm_command, 99);
    wire::Writer<ExerciseCommand> orders(enemy_, topics::exercise_command);
    wire::Writer<FaultCommand> faults(enemy_, topics::fault_command);
    matched(levers), matched(helm), matched(orders), matched(faults);
    std::uint64_t serial = 0;
    for (const double bad : {nan, -nan, 1e308, -1e308, std::numeric_limits<double>::infinity()}) {
        auto lever = signed_by<WindlassCommand>("enemy", ++serial);
        lever.brake(bad);
        lever.speed_lever(bad);
        levers.write(lever);
        auto wheel = signed_by<HelmCommand>("enemy", serial);
        wheel.rudder(bad);
        helm.write(wheel);
        auto order = signed_by<ExerciseCommand>("enemy", serial);
        order.action(EXERCISE_ENVIRONMENT);
        order.wind_speed(bad);
        orders.write(order);
        auto fault = signed_by<FaultCommand>("enemy", serial);
        fault.severity(bad);
        faults.write(fault);
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    for (const char* field : {"brake = nan", "rudder = nan", "wind_speed = nan", "severity = nan"})
        EXPECT_TRUE(eventually([&] { return has_refused(field); })) << field;
    std::this_thread::sleep_for(std::chrono::milliseconds(400)); // its strength is forgotten, by the deadline
    expect_unharmed();
}

/// Calls at 10 kHz for three seconds, with a number that counts up from 1.
void flood(const std::function<void(std::uint64_t)>& call) {
    const auto begin = std::chrono::steady_clock::now();
    std::uint64_t sent = 0;
    for (auto due = begin; due < begin + std::chrono::seconds(3); due += std::chrono::microseconds(100)) {
        std::this_thread::sleep_until(due);
        call(++sent);
    }
}

TEST_F(Hostile, TenThousandCommandsASecondChangeNotABit) {
    wire::Writer<WindlassCommand> levers(enemy_, topics::windlass_command, 0);
    matched(levers);
    flood([&](std::uint64_t serial) {
        auto lever = signed_by<WindlassCommand>("enemy", serial);
        lever.brake(2);
        levers.write(lever);
    });
    EXPECT_TRUE(eventually([&] { return has_refused("rate = "); }));
    EXPECT_LT(static_cast<double>(events()),
              20 + 10 * (seconds() + 1) + 20); // 10 refusals a second, a burst of 20, and what was there
    EXPECT_GT(status().commands_refused(), 1000U);
    expect_unharmed();
}

TEST_F(Hostile, TenThousandReportsASecondDoNotWashTheLogAway) {
    wire::Writer<Report> reports(enemy_, topics::report);
    matched(reports);
    flood([&](std::uint64_t serial) {
        auto report = signed_by<Report>("enemy", serial);
        report.text("again");
        reports.write(report);
    });
    EXPECT_TRUE(eventually([&] { return has_refused("rate = "); }));
    EXPECT_LT(static_cast<double>(events()),
              50 + 30 * (seconds() + 1) + 20 + 20); // 20 reports a second and a burst of 50 as well
    expect_unharmed(false); // the state counts the events of the exercise, and reports are events
}

TEST_F(Hostile, ThousandsOfInstancesLeaveTheTrueOnesAlone) {
    wire::Writer<WindlassCommand> levers(enemy_, topics::windlass_command, 99);
    matched(levers);
    std::uint64_t serial = 0;
    for (int side = 2; side < 5002; ++side) {
        auto lever = signed_by<WindlassCommand>("enemy", ++serial);
        lever.side(side % 2 == 0 ? side : -side);
        levers.write(lever);
        if (side % 10 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_TRUE(eventually([&] { return has_refused("side = "); }));
    expect_unharmed(); // while the enemy's writer and its instances are still there
}

TEST_F(Hostile, AnotherTypeUnderATopicsNameIsNotHeard) {
    const wire::Topic<ShipState> false_topic{
        {.name = "FaultCommand", .from_server = false, .rate = 0, .reliable = true, .depth = 64}};
    wire::Writer<ShipState> writer(enemy_, false_topic);
    for (int i = 0; i < 100; ++i) {
        EXPECT_TRUE(writer.write(ShipState()));
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    EXPECT_EQ(writer.matched(), 0);
    expect_unharmed();
}

/// One who means harm in the classroom, and hears what server "hostile" says to it.
class ClassroomEnemy {
public:
    bool matched() const { return orders_.matched() > 0; }
    std::size_t events() const {
        const std::lock_guard lock(mutex_);
        return events_.size();
    }
    bool has_refused(const std::string& field) const {
        const std::lock_guard lock(mutex_);
        return std::any_of(events_.begin(), events_.end(), [&](const Event& e) {
            return e.text().to_string().find(field) != std::string::npos;
        });
    }
    /// The next of: garbage, a definition longer than there may be, one that is there and of no use.
    void order(std::uint64_t serial) {
        if (serial % 3 == 0) {
            Payload garbage(4 + random_() % 300);
            std::generate(garbage.begin(), garbage.end(),
                          [&] { return static_cast<std::uint8_t>(random_()); });
            orders_.write(garbage);
            return;
        }
        auto create = signed_by<ClassroomCommand>("enemy", serial);
        create.server("hostile");
        create.id("x");
        create.definition().assign(serial % 300 == 1 ? 262144 : 8, '[');
        auto bytes = cdr(create);
        if (serial % 3 == 2) bytes = with(bytes, places(bytes, 8).back(), 262145);
        orders_.write(bytes);
    }

private:
    std::mt19937 random_{5};
    mutable std::mutex mutex_;
    std::vector<Event> events_;
    wire::Participant participant_{{own_domain(), wire::kClassroomPartition, "enemy"}};
    wire::RawWriter orders_{participant_, topics::classroom_command};
    wire::Reader<Event> log_{participant_, topics::event, [this](const Event& e) {
                                 const std::lock_guard lock(mutex_);
                                 events_.push_back(e);
                             }};
};

TEST_F(Hostile, FloodOfClassroomOrdersChangesNotABitAndIsToldAsRefused) {
    ClassroomEnemy enemy;
    ASSERT_TRUE(eventually([&] { return enemy.matched(); }));
    flood([&](std::uint64_t serial) { enemy.order(serial); });
    for (const char* field : {"rate = ", "payload = ", "definition = 8 bytes"})
        EXPECT_TRUE(eventually([&] { return enemy.has_refused(field); })) << field;
    // 10 refusals a second and a burst of 20, whatever came.
    EXPECT_LT(static_cast<double>(enemy.events()), 20 + 10 * (seconds() + 1));
    expect_unharmed();
}

/// How 3 s of exercise ended that an instructor started: tick and bits.
std::pair<std::uint64_t, std::uint64_t> run_with(ClassroomEnemy* enemy) {
    ServerProcess server({"--domain", std::to_string(own_domain()), "--name", "hostile", "--partition",
                          "hostile", "--wait", "--duration", "3"});
    std::atomic<std::uint64_t> tick = 0, hash = 0;
    wire::Participant instructor(member("instructor"));
    const wire::Reader<ExerciseStatus> statuses(instructor, topics::exercise_status,
                                                [&](const ExerciseStatus& s) {
                                                    hash = s.state_hash();
                                                    tick = s.tick();
                                                });
    wire::Writer<ExerciseCommand> orders(instructor, topics::exercise_command);
    EXPECT_TRUE(eventually([&] { return orders.matched() > 0 && hash != 0; })) << server.text();
    EXPECT_TRUE(!enemy || eventually([&] { return enemy->matched(); }));
    auto start = signed_by<ExerciseCommand>("instructor", 1);
    start.action(EXERCISE_START);
    std::uint64_t serial = 0;
    if (enemy) enemy->order(++serial);
    orders.write(start);
    EXPECT_TRUE(eventually([&] {
        for (int i = 0; enemy && i < 30; ++i) // thousands a second
            enemy->order(++serial);
        return server.ended();
    })) << server.text();
    EXPECT_EQ(server.exit_code(), 0) << server.text();
    return {tick, hash};
}

TEST(Exercise, RunsTheSameBitsUnderAFloodOfClassroomOrders) {
    const auto alone = run_with(nullptr);
    ClassroomEnemy enemy;
    const auto flooded = run_with(&enemy);
    EXPECT_TRUE(enemy.has_refused("rate = "));
    EXPECT_EQ(alone.first, 900U); // 3 s of 300 Hz
    EXPECT_EQ(flooded, alone);
}

} // namespace
} // namespace windlass::test
