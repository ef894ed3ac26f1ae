#include "station/gateway/feed.hpp"

#include "idl/idl_text.hpp"
#include "idl/payload.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <map>
#include <mutex>

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

/// What a program hears of one partition, in one way.
struct Feed::Partition : std::enable_shared_from_this<Partition> {
    Partition(const wire::Participant& member, const std::string& name, Kind its_kind)
        : participant{member, name}, kind{its_kind} {}

    /// The line of that channel, made where nobody uses it yet. It hears nothing before Line::begin().
    LineInUse use(const Channel& channel);
    void leave(Line* line);

    /// The exercise's time, s, as ExerciseStatus tells it: what lies after it has not happened.
    void follow(double time);

    wire::Participant participant;
    const Kind kind;
    std::atomic<double> exercise_time = 0;
    std::array<std::atomic<bool>, 2> asked{}; // forecastle, bridge

private:
    std::mutex mutex_; // before that of a line; never held while DDS is called
    std::map<std::uint32_t, std::unique_ptr<Line>> lines_;
};

/// One topic: its reader, and what pages hear of it.
struct Feed::Line {
    Line(Partition& of, const Channel& channel)
        : partition{of},
          is_status{std::string_view(channel.topic->name) == wire::topics::exercise_status.name},
          heard{*channel.topic, channel.number, of.kind == Kind::classroom, of.kind != Kind::newest} {}

    /// Hears from now on, if it does not yet.
    void begin() {
        std::call_once(begun, [this] {
            reader.emplace(partition.participant, heard.topic(),
                           [this](const wire::RawSample& sample) { pass_on(sample); });
        });
    }

    void pass_on(const wire::RawSample& sample) {
        const FramePtr frame = heard.frame_of(sample.payload, sample.written_unix_ns,
                                              partition.exercise_time.load(), Clock::now());
        if (is_status) partition.follow(frame->time);
        for (std::size_t seat = 0; seat < kQuestions.size(); ++seat)
            if (std::string_view(heard.topic().name) == kQuestions.at(seat))
                partition.asked.at(seat) = asks(frame->payload);
        heard.hear(frame, sample.writer);
    }

    Partition& partition;
    const bool is_status;
    int users = 0; // by the partition's mutex
    HeardTopic heard;
    std::once_flag begun;
    std::optional<wire::RawReader> reader; // last: it stops before what its callback uses goes away
};

Feed::LineInUse Feed::Partition::use(const Channel& channel) {
    const std::scoped_lock lock{mutex_};
    auto& line = lines_[channel.number];
    if (!line) line = std::make_unique<Line>(*this, channel);
    ++line->users;
    return {line.get(), Leave{shared_from_this()}};
}

void Feed::Partition::leave(Line* line) {
    std::unique_ptr<Line>
        last; // goes when the mutex is free: its reader waits for a callback, which may follow()
    const std::scoped_lock lock{mutex_};
    if (--line->users > 0) return;
    const auto found = lines_.find(line->heard.number());
    last = std::move(found->second);
    lines_.erase(found);
}

void Feed::Partition::follow(double time) {
    if (time >= exercise_time.exchange(time)) return;
    const std::scoped_lock lock{mutex_};
    for (const auto& [number, line] : lines_)
        line->heard.back_to(time);
}

void Feed::Leave::operator()(Line* line) const {
    partition->leave(line);
}

struct SharedReaders::Impl {
    wire::Participant member;
    std::mutex mutex;
    std::map<std::pair<std::string, Feed::Kind>, std::weak_ptr<Feed::Partition>> partitions;
};

SharedReaders::SharedReaders(wire::Participant member) : impl_{new Impl{std::move(member), {}, {}}} {}

std::shared_ptr<Feed::Partition> SharedReaders::partition(const std::string& name, Feed::Kind kind) const {
    const std::scoped_lock lock{impl_->mutex};
    std::erase_if(impl_->partitions, [](const auto& each) { return each.second.expired(); });
    auto& known = impl_->partitions[{name, kind}];
    auto found = known.lock();
    if (!found) known = found = std::make_shared<Feed::Partition>(impl_->member, name, kind);
    return found;
}

Feed::Feed(const SharedReaders& readers, const std::string& partition, Kind kind, const Topics& topics)
    : partition_{readers.partition(partition, kind)} {
    for (const wire::TopicInfo* topic : topics)
        channels_.push_back({number_of(kind, *topic), name_of(kind, *topic), topic});
    for (const Channel& channel : channels_)
        lines_.push_back(partition_->use(channel));
    // Only now: a status that is heard is told to all lines.
    for (const auto& line : lines_)
        line->begin();
}

Feed::~Feed() = default;

wire::Participant& Feed::participant() {
    return partition_->participant;
}

bool Feed::withheld(const wire::TopicInfo& topic) const {
    const std::string_view name = topic.name;
    const auto& asked = partition_->asked;
    return (asked[0] &&
            (name == wire::topics::forecastle_view.name || name == wire::topics::forecastle_ghost.name)) ||
           (asked[1] && (name == wire::topics::bridge_view.name || name == wire::topics::bridge_ghost.name ||
                         name == wire::topics::forecastle_camera.name));
}

Feed::Line* Feed::line(std::uint32_t channel) const {
    const auto found =
        std::ranges::find_if(lines_, [channel](const auto& l) { return l->heard.number() == channel; });
    return found == lines_.end() ? nullptr : found->get();
}

Feed::Line* Feed::line(const wire::TopicInfo& topic) const {
    const auto found = std::ranges::find_if(
        lines_, [&](const auto& l) { return std::string_view(l->heard.topic().name) == topic.name; });
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
    Line* const known = line(channel);
    if (known == nullptr) return;
    known->heard.listen(ear, begin, withheld(known->heard.topic()), Clock::now());
}

void Feed::leave(std::uint32_t channel, Ear& ear) {
    Line* const known = line(channel);
    if (known == nullptr) return;
    known->heard.leave(ear);
}

void Feed::leave(Ear& ear) {
    for (const Channel& channel : channels_)
        leave(channel.number, ear);
}

std::vector<FramePtr> Feed::kept(const wire::TopicInfo& topic) const {
    const Line* const known = line(topic);
    if (known == nullptr) return {};
    return known->heard.kept(Clock::now());
}

std::optional<wire::WriterId> Feed::writer(const wire::TopicInfo& topic) const {
    const Line* const known = line(topic);
    if (known == nullptr || known->reader->matched() == 0) return std::nullopt;
    return known->heard.writer();
}

std::optional<Spoken> Feed::spoken(const wire::TopicInfo& topic, const std::string& instance) const {
    const Line* const known = line(topic);
    return known == nullptr ? std::nullopt : known->heard.spoken(instance);
}

std::uint32_t number_of(const std::vector<Channel>& channels, const wire::TopicInfo& topic) {
    const auto found = std::ranges::find_if(
        channels, [&](const Channel& each) { return std::string_view(each.topic->name) == topic.name; });
    return found == channels.end() ? 0 : found->number;
}

} // namespace windlass::gateway
