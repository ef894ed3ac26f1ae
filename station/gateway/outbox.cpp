#include "station/gateway/outbox.hpp"

namespace windlass::gateway {

namespace {

std::string slot_of(std::uint32_t subscription, const SharedFrame& frame) {
    return frame.newest_only ? std::to_string(subscription) + '/' + frame.instance : std::string();
}

} // namespace

bool Outbox::put(std::uint32_t subscription, const FramePtr& frame) {
    const std::string slot = slot_of(subscription, *frame);
    if (!slot.empty()) {
        if (const auto waiting = slots_.find(slot); waiting != slots_.end()) {
            waiting->second->item.frame = frame;
            return true;
        }
        items_.push_back({{"", frame, subscription}, false, slot});
        slots_.emplace(slot, std::prev(items_.end()));
        return true;
    }
    if (counted_ == kMost) return false;
    items_.push_back({{"", frame, subscription}, true, ""});
    ++counted_;
    return true;
}

bool Outbox::put(std::string text) {
    if (counted_ == kMost) return false;
    items_.push_back({{std::move(text), nullptr, 0}, true, ""});
    ++counted_;
    return true;
}

void Outbox::put_kept(std::uint32_t subscription, const FramePtr& frame, bool with_past) {
    if (frame->newest_only && !with_past)
        put(subscription, frame);
    else
        items_.push_back({{"", frame, subscription}, false, ""});
}

std::optional<Outbox::Item> Outbox::pop() {
    if (items_.empty()) return std::nullopt;
    Waiting first = std::move(items_.front());
    items_.pop_front();
    if (!first.slot.empty()) slots_.erase(first.slot);
    if (first.counted) --counted_;
    return std::move(first.item);
}

} // namespace windlass::gateway
