#pragma once
// A server, who watches it, and the means of one who means harm, or does not know better.

#include "idl/raw.hpp"
#include "rigs/server_process.hpp"

#include <fastcdr/Cdr.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cstring>
#include <fstream>
#include <functional>
#include <mutex>

namespace windlass::test {

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
inline std::vector<std::size_t> places(const Payload& bytes, std::uint32_t number) {
    std::vector<std::size_t> found;
    for (std::size_t at = 4; at + 4 <= bytes.size(); at += 4)
        if (std::memcmp(&bytes[at], &number, 4) == 0) found.push_back(at);
    return found;
}

inline Payload with(Payload bytes, std::size_t at, std::uint32_t number) {
    std::memcpy(&bytes[at], &number, 4);
    return bytes;
}

/// MB that a process holds now.
inline double memory(pid_t pid) {
    std::ifstream status("/proc/" + std::to_string(pid) + "/status");
    for (std::string word; status >> word;)
        if (word == "VmRSS:" && status >> word) return std::stod(word) / 1024;
    return 0;
}

inline wire::JoinOptions member(const std::string& name) {
    return {rigs::own_domain(), "exercise/hostile", name};
}

/// A server that stands ready, so that not one bit of its state may change; and who watches it.
class Hostile : public ::testing::Test {
protected:
    Hostile() {
        EXPECT_TRUE(rigs::eventually([&] { return status().time_scale() > 0 && truth().state_hash() != 0; }))
            << server_.text();
        before_ = status();
        truth_before_ = truth();
        memory_before_ = memory(server_.pid());
        heard_at_ = std::chrono::steady_clock::now();
    }
    ExerciseStatus status() const {
        const std::lock_guard lock(mutex_);
        return status_;
    }
    ExerciseTruth truth() const {
        const std::lock_guard lock(mutex_);
        return truth_;
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
        EXPECT_TRUE(rigs::eventually(
            [&, from = heard_.load()] { return heard_ >= from + 3; })) // one may be under way
            << server_.text();
        const auto now = status();
        if (to_the_bit) {
            EXPECT_EQ(truth().state_hash(), truth_before_.state_hash());
        }
        EXPECT_EQ(now.state(), before_.state());
        EXPECT_EQ(now.time_scale(), before_.time_scale());
        EXPECT_TRUE(truth().faults().empty());
        // MB; queues of fixed size fill up, and every writer that joined is remembered.
        EXPECT_LT(memory(server_.pid()) - memory_before_, 32) << server_.text();
        EXPECT_TRUE(rigs::eventually([&] { // a trainee still gets its hands on the levers
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
        ASSERT_TRUE(rigs::eventually([&] { return writer.matched() > 0; }));
    }

    const rigs::ServerProcess server_{{"--domain", std::to_string(rigs::own_domain()), "--name", "hostile",
                                       "--partition", "hostile", "--wait"}};
    wire::Participant enemy_{member("enemy")};

private:
    mutable std::mutex mutex_;
    ExerciseStatus status_, before_;
    ExerciseTruth truth_, truth_before_;
    double memory_before_ = 0;
    std::chrono::steady_clock::time_point heard_at_;
    std::vector<Event> events_;
    std::atomic<std::uint64_t> heard_ = 0; // truths, of which one comes with each status
    std::uint64_t serial_ = 0;
    wire::Participant watcher_{member("watcher")};
    wire::Writer<WindlassCommand> levers_{watcher_, topics::windlass_command, 10};
    wire::Reader<ExerciseStatus> statuses_{watcher_, topics::exercise_status,
                                           [this](const ExerciseStatus& s) {
                                               const std::lock_guard lock(mutex_);
                                               status_ = s;
                                           }};
    wire::Reader<ExerciseTruth> truths_{watcher_, topics::exercise_truth, [this](const ExerciseTruth& t) {
                                            const std::lock_guard lock(mutex_);
                                            truth_ = t;
                                            ++heard_;
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

/// Calls at 10 kHz for three seconds, with a number that counts up from 1.
inline void flood(const std::function<void(std::uint64_t)>& call) {
    const auto begin = std::chrono::steady_clock::now();
    std::uint64_t sent = 0;
    for (auto due = begin; due < begin + std::chrono::seconds(3); due += std::chrono::microseconds(100)) {
        std::this_thread::sleep_until(due);
        call(++sent);
    }
}

} // namespace windlass::test
