#include "station/gateway/scene_channel.hpp"

#include "station/gateway/exercise_clock.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace windlass::gateway {

using nlohmann::json;
using namespace std::chrono_literals;

namespace {

constexpr auto kApart = 100ms;
constexpr double kMoment = 1e-6; // s; a deletion takes what is older than itself

} // namespace

SceneChannel::SceneChannel(Source& feed, const std::vector<Channel>& channels) : feed_{feed} {
    for (const wire::TopicInfo* topic : scene_topics())
        topics_.emplace(number_of(channels, *topic), topic);
    if (topics_.contains(0)) topics_.clear();
}

SceneChannel::~SceneChannel() {
    feed_.leave(*this);
}

json SceneChannel::advertisements(bool with_schema) const {
    json list = json::array();
    if (!topics_.empty())
        list.push_back({{"id", kChannel},
                        {"topic", "/scene"},
                        {"encoding", "json"},
                        {"schemaName", "foxglove.SceneUpdate"},
                        {"schemaEncoding", "jsonschema"},
                        {"schema", with_schema ? scene_schema() : ""}});
    return list;
}

void SceneChannel::listen(std::uint32_t channel, Ear& ear,
                          const std::function<void(std::vector<FramePtr>)>& begin) {
    if (!has(channel)) return;
    // Not under the lock: the feed holds its own when it calls hear().
    for (const auto& [number, topic] : topics_)
        feed_.listen(number, *this, [this](const std::vector<FramePtr>& kept) {
            for (const FramePtr& frame : kept)
                hear(frame);
        });
    const std::scoped_lock lock{mutex_};
    ear_ = &ear;
    begin({draw(false, Clock::now())});
}

void SceneChannel::leave(std::uint32_t channel, Ear& ear) {
    {
        const std::scoped_lock lock{mutex_};
        if (!has(channel) || ear_ != &ear) return;
        ear_ = nullptr;
    }
    feed_.leave(*this);
}

void SceneChannel::hear(const FramePtr& frame) {
    const std::scoped_lock lock{mutex_};
    heard_.hear(*topics_.at(frame->channel), frame->payload);
}

void SceneChannel::tell(double time, bool again, Clock::time_point now) {
    const std::scoped_lock lock{mutex_};
    time_ = time;
    if (again) ++run_;
    if (ear_ == nullptr || (!again && now - sent_at_ < kApart)) return;
    const std::string before = sent_;
    const FramePtr frame = draw(again, now);
    if (again || sent_ != before) ear_->hear(frame);
}

/// Everything, every time: a client that comes late, or has lost some, sees as much as any other.
FramePtr SceneChannel::draw(bool anew, Clock::time_point now) {
    const std::optional<double> until =
        anew ? std::optional(std::max(newest_, time_) + kMoment) : std::nullopt;
    sent_ = scene_update(heard_, time_, until);
    sent_at_ = now;
    newest_ = anew ? time_ : std::max(newest_, time_);
    auto frame = std::make_shared<SharedFrame>();
    frame->channel = kChannel;
    frame->newest_only = !anew;             // a deletion is not to be missed
    frame->instance = std::to_string(run_); // nor is what was drawn after it to take a place before it
    frame->heard = now;
    frame->time = time_;
    frame->payload.assign(sent_.begin(), sent_.end());
    return frame;
}

} // namespace windlass::gateway
