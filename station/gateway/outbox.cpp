#include "station/gateway/outbox.hpp"

namespace windlass::gateway {

namespace {

std::string slot_of(std::uint32_t subscription, const SharedFrame& frame) {
    return frame.newest_only ? std::to_string(subscription) + '/' + frame.instance : std::string();
}

} // namespace

void Outbox::put_newest(const std::string& slot, Item item) {
    if (const auto waiting = slots_.find(slot); waiting != slots_.end()) {
        waiting->second->item = std::move(item);
        return;
    }
    items_.push_back({std::move(item), false, slot});
    slots_.emplace(slot, std::prev(items_.end()));
}

bool Outbox::put(std::uint32_t subscription, const FramePtr& frame) {
    Item item{.frame = frame, .subscription = subscription};
    if (const std::string slot = slot_of(subscription, *frame); !slot.empty()) {
        put_newest(slot, std::move(item));
        return true;
    }
    if (counted_ == kMost) return false;
    items_.push_back({std::move(item), true, ""});
    ++counted_;
    return true;
}

bool Outbox::put(std::string text) {
    if (counted_ == kMost) return false;
    items_.push_back({{.text = std::move(text)}, true, ""});
    ++counted_;
    return true;
}

void Outbox::put_time(std::uint64_t ns) {
    put_newest("time", {.ns = ns, .is_time = true}); // no subscription's: those begin with a digit
}

void Outbox::put_kept(std::uint32_t subscription, const FramePtr& frame, bool with_past) {
    if (frame->newest_only && !with_past)
        put(subscription, frame);
    else
        items_.push_back({{.frame = frame, .subscription = subscription}, false, ""});
}

void Outbox::forget(std::uint32_t subscription) {
    for (auto at = items_.begin(); at != items_.end();) {
        if (!at->item.frame || at->item.subscription != subscription) {
            ++at;
            continue;
        }
        if (!at->slot.empty()) slots_.erase(at->slot);
        if (at->counted) --counted_;
        at = items_.erase(at);
    }
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
