#include "station/gateway/camera_watch.hpp"

#include "common/base64.hpp"

namespace windlass::gateway {

using nlohmann::json;
using namespace std::chrono_literals;

namespace {

constexpr auto kUnwatched = 30s; // several rounds of a page with many pictures

} // namespace

const Topics& camera_topics() {
    namespace topics = wire::topics;
    static const Topics all{&topics::scene_description, &topics::landmarks,   &topics::sea_state,
                            &topics::lights_and_shapes, &topics::bridge_view, &topics::forecastle_camera};
    return all;
}

json samples_since(const std::vector<FramePtr>& kept, const wire::TopicInfo& topic, Clock::time_point since) {
    std::map<std::string, FramePtr> newest; // by instance
    for (const FramePtr& frame : kept)
        newest[frame->instance] = frame;
    json samples = json::array();
    for (const auto& [instance, frame] : newest)
        if (frame->heard > since) samples.push_back({topic.name, base64(frame->payload)});
    return samples;
}

json CameraWatch::look(const SharedReaders& readers, const std::string& exercise, Clock::time_point since,
                       Clock::time_point now) {
    Looked& looked = looked_[exercise];
    looked.at = now;
    if (!looked.feed) {
        try {
            looked.feed = std::make_unique<Feed>(readers, wire::exercise_partition(exercise),
                                                 Feed::Kind::newest, camera_topics());
        } catch (...) {
            looked_.erase(exercise);
            throw;
        }
    }
    json samples = json::array();
    for (const wire::TopicInfo* topic : camera_topics())
        for (json& sample : samples_since(looked.feed->kept(*topic), *topic, since))
            samples.push_back(std::move(sample));
    return samples;
}

void CameraWatch::tick(Clock::time_point now) {
    std::erase_if(looked_, [&](const auto& each) { return now - each.second.at > kUnwatched; });
}

} // namespace windlass::gateway
