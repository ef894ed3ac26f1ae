#pragma once
// The wire: participants, writers and readers of the Windlass topics over Fast DDS, with the QoS of
// topics.hpp. No Fast DDS header is needed to use it.

#include "idl/topics.hpp"

#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace windlass::wire {

/// Where the other members are. Neither: on this host.
struct Network {
    bool lan = false;                  ///< in the local network, found by multicast
    std::string discovery_server = {}; ///< HOST:PORT of a fast-discovery-server with id 0; empty: none
};

/// A member of the same partition that speaks another version of the wire: neither hears the other.
struct OtherVersion {
    std::string name; ///< of the participant
    int version = 0;  ///< 1: before versions had numbers

    /// "NAME speaks version 1 of the wire, this program version 2: neither hears the other".
    std::string text() const;
};

/// Which exercise to join, and under which name.
struct JoinOptions {
    int domain = 0;                             ///< DDS domain, 0..232
    std::string partition = "exercise/default"; ///< "exercise/NAME", or "exercise/*" to hear all
    std::string name = "client";                ///< of the participant, for people who look at the network
    std::filesystem::path security = {};        ///< folder with this member's identity; empty: open to all
    Network network = {};
    /// Members of this same process are not looked for: those of a server have nothing to say to each other.
    bool ignore_own_process = false;
    /// Told of each such member once, at once when it is discovered, on a DDS thread; none: a warning is
    /// logged.
    std::function<void(const OtherVersion&)> on_other_version = {};
};

/// Partition of the exercise that an operator calls NAME.
inline std::string exercise_partition(const std::string& name) {
    return "exercise/" + name;
}

/// What an exercise may be called: 1 to 64 letters, digits, dots, dashes and underscores.
bool is_exercise_name(const std::string& name);

/// Partition in which servers tell which exercises they have, and are told to open and remove some.
inline constexpr const char* kClassroomPartition = "classroom";

/// GUID of a writer: tells a client that was started anew from one that goes on.
using WriterId = std::array<std::uint8_t, 16>;

/// One member of one exercise. Stays alive until its last writer and reader are gone.
/// Uses UDP: on the loopback interface, or as JoinOptions::network says; with
/// FASTRTPS_DEFAULT_PROFILES_FILE set, the default participant profile of that file instead.
class Participant {
public:
    /// Throws std::runtime_error, saying what could not be had, when DDS does not start.
    explicit Participant(const JoinOptions& session);

    /// The same member in one more partition: a host of many exercises joins the domain once. Throws
    /// std::runtime_error.
    Participant(const Participant& member, const std::string& partition);

    struct Impl;
    const std::shared_ptr<Impl>& impl() const { return impl_; }

private:
    std::shared_ptr<Impl> impl_;
};

/// Writes samples of one topic. One thread at a time for each writer.
template <class T>
class Writer {
public:
    /// ownership_strength matters on exclusive topics only: the higher one is heard. Throws
    /// std::runtime_error when the writer cannot be made, e.g. when permissions forbid it.
    Writer(Participant& participant, const Topic<T>& topic, int ownership_strength = 0);
    ~Writer();
    Writer(Writer&&) noexcept;
    Writer& operator=(Writer&&) noexcept;

    /// Sends one sample; false when it could not be stored, or a sequence or string exceeds its bound.
    bool write(const T& sample);

    /// Readers connected now: the server's, a recorder's, a station's.
    int matched() const;

    /// A reader of the participant that has that writer is connected, e.g. of the server whose status was
    /// heard. What is written from then on reaches it; before, an order is lost on it, though others hear it.
    bool heard_by(const WriterId& peer) const;

    WriterId id() const;

    /// Waits until every connected reader has everything written so far; false when time is up.
    /// For a client that sends one order and leaves.
    bool wait_acknowledged(std::chrono::milliseconds timeout);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Hears samples of one topic. The callback runs on a DDS thread (or inside write() of a writer in the
/// same process): it must be quick and must not destroy the reader. No callback runs after destruction.
template <class T>
class Reader {
public:
    using OnSample = std::function<void(const T&)>;
    using OnSampleFrom = std::function<void(const T&, const WriterId&)>;
    using OnWrong = std::function<void()>;
    using OnWriter = std::function<void(const WriterId&, bool there)>;

    /// Throws std::runtime_error when the reader cannot be made. on_wrong is told of each sample that is no
    /// CDR of the type, or exceeds a bound of it; nothing of such a sample is seen. on_writer is told of each
    /// writer that is there, before its first sample, and that is there no more: at once when it was disposed
    /// of, else when DDS misses its program. A program that was only held up is there again, with the writer
    /// that it had. It may run beside on_sample.
    Reader(Participant& participant, const Topic<T>& topic, OnSample on_sample);
    Reader(Participant& participant, const Topic<T>& topic, OnSampleFrom on_sample, OnWrong on_wrong = {},
           OnWriter on_writer = {});
    ~Reader();
    Reader(Reader&&) noexcept;
    Reader& operator=(Reader&&) noexcept;

    /// Writers connected now.
    int matched() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace windlass::wire
