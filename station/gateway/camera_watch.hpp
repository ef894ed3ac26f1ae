#pragma once
// What the cameras on the forecastles of a classroom see, of which a page draws a small picture now and then.

#include "station/gateway/feed.hpp"

#include <nlohmann/json.hpp>

namespace windlass::gateway {

/// What such a picture is made of, all of which a bridge has.
const Topics& camera_topics();

/// Of samples that are kept, oldest first: each instance's newest, if it was heard later than since; lists of
/// topic and payload in base64.
nlohmann::json samples_since(const std::vector<FramePtr>& kept, const wire::TopicInfo& topic,
                             Clock::time_point since);

class CameraWatch {
public:
    /// Samples of camera_topics() of an exercise that were heard later than since. An exercise is heard from
    /// the first look on, so that this one has nothing yet, and no longer than half a minute after the last.
    /// Throws std::runtime_error when it cannot be joined.
    nlohmann::json look(const SharedReaders& readers, const std::string& exercise, Clock::time_point since,
                        Clock::time_point now);

    /// Leaves what nobody looks at any more.
    void tick(Clock::time_point now);

private:
    struct Looked {
        std::unique_ptr<Feed> feed;
        Clock::time_point at;
    };
    std::map<std::string, Looked> looked_; // by exercise
};

} // namespace windlass::gateway
