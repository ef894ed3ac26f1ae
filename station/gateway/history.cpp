#include "station/gateway/history.hpp"

#include "idl/idl_text.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <iterator>
#include <string_view>

namespace windlass::gateway {

namespace {

/// A server in the classroom speaks each second; one that is silent for so long has no exercises any more.
constexpr auto kSilent = std::chrono::seconds(3);

/// Two hours, as far back as the plots of a page go. A sample a second is what a line of two hours can show,
/// and less than the pause that a plot draws as a gap.
constexpr PastBounds kDrawn{.apart = 1, .frames = 7200, .bytes = 4 << 20};
constexpr PastBounds kSaid{.apart = 0, .frames = 200, .bytes = 1 << 18};

std::size_t depth_kept(const wire::TopicInfo& topic) {
    // A word on levers stands when the hand has left them, and no server tells it again. An order is given
    // once.
    if (!topic.from_server) return topic.exclusive ? 1 : 0;
    return topic.transient_local ? static_cast<std::size_t>(topic.depth) : 1;
}

/// Goes along the first members of a type, as long as they are texts and numbers.
class Head {
public:
    explicit Head(std::span<const std::uint8_t> payload)
        : swapped_{payload.size() > 1 && (payload[1] != 0) != (std::endian::native == std::endian::little)},
          body_{payload.size() < kHeader ? payload.subspan(payload.size()) : payload.subspan(kHeader)} {}

    /// Past that member; false where it is none of those kinds, or the payload ends within it.
    bool skip(const idl::Member& member) {
        if (member.sequence) return false;
        switch (member.type->kind) {
        case idl::Kind::text: {
            const auto length = number<std::uint32_t>();
            if (!length || *length > body_.size() - at_) return false;
            at_ += *length;
            return true;
        }
        case idl::Kind::int32:
        case idl::Kind::uint32:
        case idl::Kind::enumeration:
            return number<std::uint32_t>().has_value();
        case idl::Kind::int64:
        case idl::Kind::uint64:
        case idl::Kind::float64:
            return number<std::uint64_t>().has_value();
        default:
            return false;
        }
    }

    template <class T>
    std::optional<T> number() {
        at_ = (at_ + sizeof(T) - 1) / sizeof(T) * sizeof(T); // CDR: of N bytes at a multiple of N
        if (at_ + sizeof(T) > body_.size()) return std::nullopt;
        std::array<std::uint8_t, sizeof(T)> bytes{};
        std::memcpy(bytes.data(), &body_[at_], sizeof(T));
        if (swapped_) std::ranges::reverse(bytes);
        at_ += sizeof(T);
        return std::bit_cast<T>(bytes);
    }

    std::span<const std::uint8_t> passed() const { return body_.first(at_); }

private:
    static constexpr std::size_t kHeader = 4;
    bool swapped_;
    std::span<const std::uint8_t> body_;
    std::size_t at_ = 0;
};

} // namespace

std::string instance_of(const wire::TopicInfo& topic, std::span<const std::uint8_t> payload) {
    const auto* type = idl::own_schema().find(wire::type_name(topic));
    if (!topic.keyed || type == nullptr) return {};
    Head head(payload);
    for (const auto& member : type->members) { // keys stand first in our types
        if (!member.key) break;
        if (!head.skip(member)) return {};
    }
    return {head.passed().begin(), head.passed().end()};
}

std::optional<double> time_of(const wire::TopicInfo& topic, std::span<const std::uint8_t> payload) {
    const auto* type = idl::own_schema().find(wire::type_name(topic));
    if (type == nullptr) return std::nullopt;
    Head head(payload);
    for (const auto& member : type->members) {
        if (member.name == "time" && member.type->kind == idl::Kind::float64) return head.number<double>();
        if (!head.skip(member)) break;
    }
    return std::nullopt;
}

bool newest_only(const wire::TopicInfo& topic) {
    return topic.rate > 0;
}

PastBounds past_of(const wire::TopicInfo& topic) {
    namespace topics = wire::topics;
    const std::string_view name = topic.name;
    for (const char* drawn : {topics::ship_state.name, topics::anchor_state.name, topics::windlass_load.name,
                              topics::environment_state.name, topics::bridge_view.name})
        if (name == drawn) return kDrawn;
    return name == topics::report.name ? kSaid : PastBounds{};
}

void Past::keep(const FramePtr& frame) {
    if (bounds_.frames == 0 || !std::isfinite(frame->time)) return;
    if (!frames_.empty() && frame->time < frames_.back()->time) {
        back_to(frame->time);
        if (bounds_.apart > 0 && !frames_.empty() && frames_.back()->time == frame->time) drop_last();
    }
    if (!frames_.empty() && frame->time < frames_.back()->time + bounds_.apart) return;
    frames_.push_back(frame);
    bytes_ += frame->payload.size();
    while (frames_.size() > bounds_.frames || bytes_ > bounds_.bytes) {
        bytes_ -= frames_.front()->payload.size();
        frames_.pop_front();
    }
}

void Past::back_to(double time) {
    while (!frames_.empty() && frames_.back()->time > time)
        drop_last();
}

void Past::drop_last() {
    bytes_ -= frames_.back()->payload.size();
    frames_.pop_back();
}

History::History(const wire::TopicInfo& topic, bool many_writers, bool with_past)
    : depth_(depth_kept(topic)),
      past_(with_past ? past_of(topic) : PastBounds{}),
      instances_(static_cast<std::size_t>(topic.instances)),
      many_writers_(many_writers || !topic.from_server),
      of_clients_(!topic.from_server),
      ages_(many_writers),
      is_log_(topic.transient_local && topic.depth > 1 && !topic.keyed) {}

void History::begin_server_at(double time) {
    if (!(time > 0)) return instances_kept_.clear();
    for (auto& [key, instance] : instances_kept_) {
        instance.past.back_to(time);
        std::erase_if(instance.newest, [&](const Kept& one) { return !is_log_ || one.frame->time > time; });
    }
}

void History::keep(const FramePtr& frame, const std::string& writer, Clock::time_point now) {
    if (depth_ == 0 && past_.frames == 0) return;
    if (!many_writers_ && writer != writer_) {
        begin_server_at(frame->time);
        writer_ = writer;
    }
    if (!instances_kept_.contains(frame->instance) && instances_kept_.size() == instances_) {
        const auto oldest = std::ranges::min_element(
            instances_kept_, {}, [](const auto& instance) { return instance.second.number; });
        instances_kept_.erase(oldest);
    }
    Instance& instance = instances_kept_.try_emplace(frame->instance, past_).first->second;
    instance.number = taken_++;
    instance.past.keep(frame);
    instance.newest.push_back({instance.number, frame, now});
    if (instance.newest.size() > depth_) instance.newest.pop_front();
}

void History::back_to(double time) {
    for (auto& [key, instance] : instances_kept_) {
        instance.past.back_to(time);
        if (of_clients_)
            std::erase_if(instance.newest, [time](const Kept& one) { return one.frame->time > time; });
    }
}

std::vector<FramePtr> History::kept(Clock::time_point now) const {
    std::vector<FramePtr> frames;
    std::vector<const Kept*> newest;
    for (const auto& [key, instance] : instances_kept_) {
        std::ranges::copy(instance.past.frames(), std::back_inserter(frames));
        for (const Kept& one : instance.newest)
            if ((!ages_ || now - one.at < kSilent) &&
                (instance.past.frames().empty() || instance.past.frames().back() != one.frame))
                newest.push_back(&one);
    }
    std::ranges::sort(newest, {}, [](const Kept* one) { return one->number; });
    for (const Kept* one : newest)
        frames.push_back(one->frame);
    return frames;
}

} // namespace windlass::gateway
