#include "station/gateway/heard_topic.hpp"

namespace windlass::gateway {

HeardTopic::HeardTopic(const wire::TopicInfo& topic, std::uint32_t number, bool many_writers, bool with_past)
    : topic_{topic},
      number_{number},
      newest_only_{newest_only(topic)},
      standing_{topic.transient_local && topic.depth == 1 && !(with_past && past_of(topic).frames > 0)},
      history_{topic, many_writers, with_past} {}

FramePtr HeardTopic::frame_of(std::span<const std::uint8_t> payload, std::int64_t written_unix_ns,
                              double exercise_time, Clock::time_point now) const {
    auto frame = std::make_shared<SharedFrame>();
    frame->channel = number_;
    frame->newest_only = newest_only_;
    frame->standing = standing_;
    frame->instance = instance_of(topic_, payload);
    frame->written_unix_ns = written_unix_ns;
    frame->heard = now;
    frame->time = time_of(topic_, payload).value_or(exercise_time);
    frame->payload.assign(payload.begin(), payload.end());
    return frame;
}

void HeardTopic::hear(const FramePtr& frame, const wire::WriterId& writer) {
    const std::scoped_lock lock{mutex_};
    writer_ = writer;
    if (topic_.exclusive) spoken_[frame->instance] = {frame, writer, frame->heard};
    history_.keep(frame, std::string(writer.begin(), writer.end()), frame->heard);
    for (Ear* ear : ears_)
        ear->hear(frame);
}

void HeardTopic::back_to(double time) {
    const std::scoped_lock lock{mutex_};
    history_.back_to(time);
}

void HeardTopic::listen(Ear& ear, const std::function<void(std::vector<FramePtr>)>& begin, bool withheld,
                        Clock::time_point now) {
    const std::scoped_lock lock{mutex_};
    if (!ears_.insert(&ear).second) return;
    begin(withheld ? std::vector<FramePtr>() : history_.kept(now));
}

void HeardTopic::leave(Ear& ear) {
    const std::scoped_lock lock{mutex_};
    ears_.erase(&ear);
}

std::vector<FramePtr> HeardTopic::kept(Clock::time_point now) const {
    const std::scoped_lock lock{mutex_};
    return history_.kept(now);
}

std::optional<wire::WriterId> HeardTopic::writer() const {
    const std::scoped_lock lock{mutex_};
    return writer_;
}

std::optional<Spoken> HeardTopic::spoken(const std::string& instance) const {
    const std::scoped_lock lock{mutex_};
    const auto found = spoken_.find(instance);
    return found == spoken_.end() ? std::nullopt : std::optional(found->second);
}

} // namespace windlass::gateway
