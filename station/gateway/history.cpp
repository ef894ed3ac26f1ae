#include "station/gateway/history.hpp"

#include "idl/idl_text.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

namespace windlass::gateway {

namespace {

/// A server in the classroom speaks each second; one that is silent for so long has no exercises any more.
constexpr auto kSilent = std::chrono::seconds(3);

std::size_t depth_kept(const wire::TopicInfo& topic) {
    // Levers count only as long as they are sent, and an order is given once.
    if (!topic.from_server) return 0;
    return topic.transient_local ? static_cast<std::size_t>(topic.depth) : 1;
}

} // namespace

std::string instance_of(const wire::TopicInfo& topic, std::span<const std::uint8_t> payload) {
    constexpr std::size_t kHeader = 4;
    if (!topic.keyed || payload.size() < kHeader) return {};
    const auto* type = idl::own_schema().find(wire::type_name(topic));
    if (type == nullptr) return {};
    const bool swapped = (payload[1] != 0) != (std::endian::native == std::endian::little);
    const auto body = payload.subspan(kHeader);
    std::size_t at = 0;
    // Keys stand first in our types, and are texts and 32-bit numbers.
    for (const auto& member : type->members) {
        if (!member.key) break;
        at = (at + 3) / 4 * 4;
        if (at + 4 > body.size()) return {};
        std::uint32_t length = 0;
        if (member.type->kind == idl::Kind::text) {
            std::memcpy(&length, &body[at], 4);
            if (swapped) length = __builtin_bswap32(length);
            if (length > body.size() - at - 4) return {};
        }
        at += 4 + length;
    }
    return {body.begin(), body.begin() + static_cast<std::ptrdiff_t>(at)};
}

bool newest_only(const wire::TopicInfo& topic) {
    return topic.rate > 0;
}

History::History(const wire::TopicInfo& topic, bool many_writers)
    : depth_(depth_kept(topic)),
      instances_(static_cast<std::size_t>(topic.instances)),
      many_writers_(many_writers) {}

void History::take(const FramePtr& frame, const std::string& writer, Clock::time_point now) {
    if (depth_ == 0) return;
    if (!many_writers_ && writer != writer_) {
        instances_kept_.clear();
        writer_ = writer;
    }
    if (!instances_kept_.contains(frame->instance) && instances_kept_.size() == instances_) {
        const auto oldest = std::ranges::min_element(
            instances_kept_, {}, [](const auto& instance) { return instance.second.back().number; });
        instances_kept_.erase(oldest);
    }
    auto& kept = instances_kept_[frame->instance];
    kept.push_back({taken_++, frame, now});
    if (kept.size() > depth_) kept.pop_front();
}

std::vector<FramePtr> History::kept(Clock::time_point now) const {
    std::vector<const Kept*> all;
    for (const auto& [instance, kept] : instances_kept_)
        for (const Kept& one : kept)
            if (!many_writers_ || now - one.at < kSilent) all.push_back(&one);
    std::ranges::sort(all, {}, [](const Kept* one) { return one->number; });
    std::vector<FramePtr> frames;
    frames.reserve(all.size());
    for (const Kept* one : all)
        frames.push_back(one->frame);
    return frames;
}

} // namespace windlass::gateway
