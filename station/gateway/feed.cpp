#include "station/gateway/feed.hpp"

#include "idl/idl_text.hpp"
#include "idl/payload.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace windlass::gateway {

namespace {

/// The same number for a topic in every role: its row. The classroom's come behind the exercise's.
std::uint32_t number_of(Feed::Kind kind, const wire::TopicInfo& topic) {
    constexpr std::uint32_t kClassroom = 100;
    const auto row = [&](const auto& rows) {
        const auto found = std::ranges::find_if(
            rows, [&](const wire::TopicInfo& each) { return std::string_view(each.name) == topic.name; });
        return static_cast<std::uint32_t>(found - rows.begin()) + 1;
    };
    return kind == Feed::Kind::classroom ? kClassroom + row(wire::topics::classroom) : row(wire::topics::all);
}

std::string name_of(Feed::Kind kind, const wire::TopicInfo& topic) {
    // The classroom has events of its own, beside the exercise's.
    const bool event = std::string_view(topic.name) == wire::topics::event.name;
    return (kind == Feed::Kind::classroom && event ? "/classroom/" : "/") + std::string(topic.name);
}

/// Whether it puts a question; a payload that is none puts none.
bool asks(idl::Bytes payload) {
    try {
        return wire::decode<Question>(payload).id().size() > 0;
    } catch (const std::runtime_error&) {
        return false;
    }
}

/// By the seat that is asked: forecastle, bridge.
constexpr std::array kQuestions{wire::topics::forecastle_question.name, wire::topics::bridge_question.name};

} // namespace

/// One topic: its reader, what is kept of it, and who listens.
struct Feed::Line {
    Line(Feed& of, const Channel& channel, Kind kind)
        : feed{of},
          number{channel.number},
          topic{*channel.topic},
          only_newest{newest_only(topic)},
          has_past{kind != Kind::newest && past_of(topic).frames > 0},
          is_status{std::string_view(topic.name) == wire::topics::exercise_status.name},
          history{topic, kind == Kind::classroom, kind != Kind::newest} {}

    void pass_on(const wire::RawSample& sample) {
        auto frame = std::make_shared<SharedFrame>();
        frame->channel = number;
        frame->newest_only = only_newest;
        frame->standing = topic.transient_local && topic.depth == 1 && !has_past;
        frame->instance = instance_of(topic, sample.payload);
        frame->written_unix_ns = sample.written_unix_ns;
        frame->heard = Clock::now();
        frame->time = time_of(topic, sample.payload).value_or(feed.exercise_time_.load());
        frame->payload.assign(sample.payload.begin(), sample.payload.end());
        if (is_status) feed.follow(frame->time);
        for (std::size_t seat = 0; seat < kQuestions.size(); ++seat)
            if (std::string_view(topic.name) == kQuestions.at(seat))
                feed.asked_.at(seat) = asks(frame->payload);
        const std::scoped_lock lock{mutex};
        writer = sample.writer;
        if (topic.exclusive) spoken[frame->instance] = {frame, sample.writer, frame->heard};
        history.keep(frame, std::string(sample.writer.begin(), sample.writer.end()), frame->heard);
        for (Ear* ear : ears)
            ear->hear(frame);
    }

    Feed& feed;
    const std::uint32_t number;
    const wire::TopicInfo& topic;
    const bool only_newest, has_past, is_status;
    mutable std::mutex mutex;
    History history;
    std::optional<wire::WriterId> writer; // of the newest sample
    std::map<std::string, Spoken> spoken; // by instance, of an exclusive topic
    std::set<Ear*> ears;
    std::optional<wire::RawReader> reader; // last: it stops before what its callback uses goes away
};

Feed::Feed(wire::Participant participant, Kind kind, const Topics& topics)
    : participant_{std::move(participant)} {
    for (const wire::TopicInfo* topic : topics)
        channels_.push_back({number_of(kind, *topic), name_of(kind, *topic), topic});
    for (const Channel& channel : channels_)
        lines_.push_back(std::make_unique<Line>(*this, channel, kind));
    // Only now: a status that is heard is told to all lines.
    for (const auto& line : lines_)
        line->reader.emplace(participant_, line->topic,
                             [&line = *line](const wire::RawSample& sample) { line.pass_on(sample); });
}

bool Feed::withheld(const wire::TopicInfo& topic) const {
    const std::string_view name = topic.name;
    return (asked_[0] &&
            (name == wire::topics::forecastle_view.name || name == wire::topics::forecastle_ghost.name)) ||
           (asked_[1] && (name == wire::topics::bridge_view.name || name == wire::topics::bridge_ghost.name ||
                          name == wire::topics::forecastle_camera.name));
}

void Feed::follow(double time) {
    if (time < exercise_time_.exchange(time))
        for (const auto& line : lines_) {
            const std::scoped_lock lock{line->mutex};
            line->history.back_to(time);
        }
}

Feed::~Feed() {
    for (const auto& line : lines_) // all, before the first line goes away
        line->reader.reset();
}

Feed::Line* Feed::line(std::uint32_t channel) const {
    const auto found =
        std::ranges::find_if(lines_, [channel](const auto& l) { return l->number == channel; });
    return found == lines_.end() ? nullptr : found->get();
}

Feed::Line* Feed::line(const wire::TopicInfo& topic) const {
    const auto found = std::ranges::find_if(
        lines_, [&](const auto& l) { return std::string_view(l->topic.name) == topic.name; });
    return found == lines_.end() ? nullptr : found->get();
}

bool Feed::has(std::uint32_t channel) const {
    return line(channel) != nullptr;
}

nlohmann::json Feed::advertisements(bool with_schema) const {
    nlohmann::json list = nlohmann::json::array();
    for (const Channel& channel : channels_)
        list.push_back({{"id", channel.number},
                        {"topic", channel.name},
                        {"encoding", "cdr"},
                        {"schemaName", wire::type_name(*channel.topic)},
                        {"schemaEncoding", "omgidl"},
                        {"schema", with_schema ? std::string(idl::own_text()) : std::string()}});
    return list;
}

void Feed::listen(std::uint32_t channel, Ear& ear, const std::function<void(std::vector<FramePtr>)>& begin) {
    Line* const heard = line(channel);
    if (heard == nullptr) return;
    const std::scoped_lock lock{heard->mutex};
    if (!heard->ears.insert(&ear).second) return;
    begin(withheld(heard->topic) ? std::vector<FramePtr>() : heard->history.kept(Clock::now()));
}

void Feed::leave(std::uint32_t channel, Ear& ear) {
    Line* const heard = line(channel);
    if (heard == nullptr) return;
    const std::scoped_lock lock{heard->mutex};
    heard->ears.erase(&ear);
}

void Feed::leave(Ear& ear) {
    for (const Channel& channel : channels_)
        leave(channel.number, ear);
}

std::vector<FramePtr> Feed::kept(const wire::TopicInfo& topic) const {
    const Line* const heard = line(topic);
    if (heard == nullptr) return {};
    const std::scoped_lock lock{heard->mutex};
    return heard->history.kept(Clock::now());
}

std::optional<wire::WriterId> Feed::writer(const wire::TopicInfo& topic) const {
    const Line* const heard = line(topic);
    if (heard == nullptr || heard->reader->matched() == 0) return std::nullopt;
    const std::scoped_lock lock{heard->mutex};
    return heard->writer;
}

std::optional<Spoken> Feed::spoken(const wire::TopicInfo& topic, const std::string& instance) const {
    const Line* const heard = line(topic);
    if (heard == nullptr) return std::nullopt;
    const std::scoped_lock lock{heard->mutex};
    const auto found = heard->spoken.find(instance);
    return found == heard->spoken.end() ? std::nullopt : std::optional(found->second);
}

std::uint32_t number_of(const std::vector<Channel>& channels, const wire::TopicInfo& topic) {
    const auto found = std::ranges::find_if(
        channels, [&](const Channel& each) { return std::string_view(each.topic->name) == topic.name; });
    return found == channels.end() ? 0 : found->number;
}

} // namespace windlass::gateway
