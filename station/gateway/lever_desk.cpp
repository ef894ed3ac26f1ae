#include "station/gateway/lever_desk.hpp"

namespace windlass::gateway {

namespace {
constexpr std::array kHands{Hand::port, Hand::starboard, Hand::helm};
}

bool LeverDesk::put(Hand hand, Page page, const nlohmann::json& sample, Clock::time_point now) {
    Held& held = of(hand);
    if (held.page != nullptr && held.page != page) return false;
    if (overruled(hand).contains(page)) return true;
    const bool taken = held.page == nullptr;
    const bool moved = taken || held.sample != sample;
    if (taken) {
        const bool goes_on = silent(hand).page == page;
        held = {page, sample, now, goes_on ? silent(hand).own : now, now};
        silent(hand) = {};
        if (!goes_on && take_over_) take_over_(hand);
    }
    held.sample = sample;
    held.heard = now;
    if (moved) write_(hand, sample);
    if (taken) changed_(hand, page, {});
    return true;
}

void LeverDesk::heard(Hand hand, bool own, const std::string& station, Clock::time_point at) {
    Held& held = of(hand);
    if (held.page == nullptr) return;
    if (own) {
        held.own = std::max(held.own, at);
    } else if (at > held.since && at - held.own > kLost) {
        overruled(hand).insert(held.page);
        end(hand, station);
    }
}

void LeverDesk::let_go(Hand hand, Page page) {
    overruled(hand).erase(page);
    if (silent(hand).page == page) silent(hand) = {};
    if (of(hand).page == page) end(hand);
}

void LeverDesk::leave(Page page) {
    for (const Hand hand : kHands)
        let_go(hand, page);
}

void LeverDesk::tick(Clock::time_point now) {
    for (const Hand hand : kHands) {
        if (of(hand).page == nullptr) continue;
        if (now - of(hand).heard < kDeadMan)
            write_(hand, of(hand).sample);
        else {
            silent(hand) = of(hand);
            end(hand);
        }
    }
}

LeverDesk::Page LeverDesk::holder(Hand hand) const {
    return held_.at(static_cast<std::size_t>(hand)).page;
}

void LeverDesk::end(Hand hand, const std::string& taken_by) {
    of(hand) = {};
    changed_(hand, nullptr, taken_by);
}

} // namespace windlass::gateway
