#pragma once
// One topic of a partition as pages hear it: a frame of each sample, what is kept for a page that comes late,
// and who listens. Knows no network, and the time is given.

#include "idl/wire.hpp"
#include "station/gateway/source.hpp"

#include <map>
#include <mutex>
#include <set>
#include <span>

namespace windlass::gateway {

/// Whose word was heard last of one instance of a topic.
struct Spoken {
    FramePtr frame;
    wire::WriterId writer{};
    Clock::time_point at;
};

/// From any thread, but for what says otherwise.
class HeardTopic {
public:
    /// number: of its channel. many_writers, with_past: as History's.
    HeardTopic(const wire::TopicInfo& topic, std::uint32_t number, bool many_writers, bool with_past);

    const wire::TopicInfo& topic() const { return topic_; }
    std::uint32_t number() const { return number_; }

    /// What pages are given of a sample that comes now. exercise_time: s, for a type that tells none.
    FramePtr frame_of(std::span<const std::uint8_t> payload, std::int64_t written_unix_ns,
                      double exercise_time, Clock::time_point now) const;
    /// Keeps it, and hands it to all who listen. One call at a time.
    void hear(const FramePtr& frame, const wire::WriterId& writer);
    /// As Past's.
    void back_to(double time);

    /// From now on that ear hears; first begin is given what is kept, or nothing where that is withheld.
    void listen(Ear& ear, const std::function<void(std::vector<FramePtr>)>& begin, bool withheld,
                Clock::time_point now);
    void leave(Ear& ear);

    std::vector<FramePtr> kept(Clock::time_point now) const;
    std::optional<wire::WriterId> writer() const;                    ///< of the newest sample
    std::optional<Spoken> spoken(const std::string& instance) const; ///< of an exclusive topic

private:
    const wire::TopicInfo& topic_;
    const std::uint32_t number_;
    const bool newest_only_, standing_;
    mutable std::mutex mutex_;
    History history_;
    std::optional<wire::WriterId> writer_;
    std::map<std::string, Spoken> spoken_; // by instance, of an exclusive topic
    std::set<Ear*> ears_;
};

} // namespace windlass::gateway
