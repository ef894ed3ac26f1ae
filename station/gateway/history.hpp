#pragma once
// What a page that joins late is given of one topic: what a late joiner of DDS would get, and the newest
// sample of a stream. Pure.

#include "idl/topics.hpp"

#include <chrono>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace windlass::gateway {

using Clock = std::chrono::steady_clock;

/// One sample as it came over DDS, shared by all pages that hear it.
struct Frame {
    std::uint32_t channel = 0;         ///< number of its topic, see Feed
    bool newest_only = false;          ///< a state: of each instance the newest one is enough
    std::string instance;              ///< bytes of its key
    std::int64_t written_unix_ns = 0;  ///< at its writer
    std::vector<std::uint8_t> payload; ///< CDR header and CDR
};
using FramePtr = std::shared_ptr<const Frame>;

/// The bytes of the key that a payload of that topic begins with; empty where the topic has no key, or where
/// the payload ends within it.
std::string instance_of(const wire::TopicInfo& topic, std::span<const std::uint8_t> payload);

/// States, of which a slow page is given the newest only: what comes at a rate.
bool newest_only(const wire::TopicInfo& topic);

class History {
public:
    /// many_writers: each with instances of its own (servers in the classroom), so that one that speaks does
    /// not end what others said; such samples grow old.
    explicit History(const wire::TopicInfo& topic, bool many_writers = false);

    /// writer: tells one server from the next. What another wrote is forgotten.
    void take(const FramePtr& frame, const std::string& writer, Clock::time_point now);

    /// Oldest first.
    std::vector<FramePtr> kept(Clock::time_point now) const;

private:
    struct Kept {
        std::uint64_t number;
        FramePtr frame;
        Clock::time_point at;
    };
    const std::size_t depth_;     ///< of each instance; 0: nothing is kept
    const std::size_t instances_; ///< at most
    const bool many_writers_;
    std::string writer_;
    std::uint64_t taken_ = 0;
    std::map<std::string, std::deque<Kept>> instances_kept_;
};

} // namespace windlass::gateway
