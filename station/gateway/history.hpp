#pragma once
// What a page that joins late is given of one topic: what a late joiner of DDS would get, the newest sample
// of a stream, the last word on levers, and of what a page draws over time the past. Pure.

#include "idl/topics.hpp"

#include <chrono>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace windlass::gateway {

using Clock = std::chrono::steady_clock;

/// One sample as it came over DDS, shared by all pages that hear it.
struct SharedFrame {
    std::uint32_t channel = 0;         ///< number of its topic, see Feed
    bool newest_only = false;          ///< a state: of each instance the newest one is enough
    bool standing = false;             ///< holds until the next one: a late page is told it before what was
    std::string instance;              ///< bytes of its key
    std::int64_t written_unix_ns = 0;  ///< at its writer
    Clock::time_point heard{};         ///< here: what came before what, of other topics too
    double time = 0;                   ///< s of exercise time: its own, else the exercise's when it was heard
    std::vector<std::uint8_t> payload; ///< CDR header and CDR
};
using FramePtr = std::shared_ptr<const SharedFrame>;

/// The bytes of the key that a payload of that topic begins with; empty where the topic has no key, or where
/// the payload ends within it.
std::string instance_of(const wire::TopicInfo& topic, std::span<const std::uint8_t> payload);

/// s of exercise time that a payload of that topic tells; nothing where its type has none near its beginning,
/// or the payload ends before it.
std::optional<double> time_of(const wire::TopicInfo& topic, std::span<const std::uint8_t> payload);

/// States, of which a slow page is given the newest only: what comes at a rate.
bool newest_only(const wire::TopicInfo& topic);

/// How much of a topic's past is kept, of each instance.
struct PastBounds {
    double apart = 0;       ///< s of exercise time from one to the next, at least
    std::size_t frames = 0; ///< 0: none is kept
    std::size_t bytes = 0;  ///< of payload
};

/// Of what pages draw over time (plots, tracks, traces) two hours, a sample a second; of what was reported
/// the last 200. Of other topics none.
PastBounds past_of(const wire::TopicInfo& topic);

/// What was, in the order of exercise time.
class Past {
public:
    explicit Past(PastBounds bounds) : bounds_{bounds} {}

    /// Keeps the frame if it is far enough from the last. One that is before the last: time went back to it.
    void keep(const FramePtr& frame);

    /// Time went back to that moment (a restore, a reset): what lies after it has not happened.
    void back_to(double time);

    const std::deque<FramePtr>& frames() const { return frames_; } ///< oldest first

private:
    void drop_last();

    PastBounds bounds_;
    std::size_t bytes_ = 0;
    std::deque<FramePtr> frames_;
};

class History {
public:
    /// many_writers: each with instances of its own (servers in the classroom), so that one that speaks does
    /// not end what others said; such samples grow old. with_past: as past_of() the topic has it.
    explicit History(const wire::TopicInfo& topic, bool many_writers = false, bool with_past = true);

    /// writer: tells one server from the next. States that another wrote are forgotten. What it told of what
    /// has happened, and the past, stay up to the moment of this frame, with which the next one begins: an
    /// exercise that is taken up after its server was lost goes on from there, any other begins at 0 and
    /// has nothing before it. What clients say is theirs together.
    void keep(const FramePtr& frame, const std::string& writer, Clock::time_point now);

    /// As Past's; of levers the word that came later is forgotten, too.
    void back_to(double time);

    /// Of each instance the past, then the newest; oldest first.
    std::vector<FramePtr> kept(Clock::time_point now) const;

private:
    struct Kept {
        std::uint64_t number;
        FramePtr frame;
        Clock::time_point at;
    };
    struct Instance {
        explicit Instance(PastBounds bounds) : past{bounds} {}
        std::deque<Kept> newest;
        Past past;
        std::uint64_t number = 0; ///< of its last sample
    };
    void begin_server_at(double time);

    const std::size_t depth_; ///< of each instance's newest; 0: none is kept
    const PastBounds past_;
    const std::size_t instances_; ///< at most
    const bool many_writers_;     ///< that do not end what others said
    const bool of_clients_;       ///< its samples are no server's
    const bool ages_;             ///< what is old is told to nobody
    const bool is_log_;           ///< tells what has happened, each thing once
    std::string writer_;
    std::uint64_t taken_ = 0;
    std::map<std::string, Instance> instances_kept_;
};

} // namespace windlass::gateway
