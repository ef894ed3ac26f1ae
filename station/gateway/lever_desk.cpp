#include "station/gateway/lever_desk.hpp"

namespace windlass::gateway {

namespace {
constexpr double kRepeated = 0.3; // s; a page speaks each 0.1 s
}

double LeverDesk::listened(Clock::time_point now) {
    return listening_.at(std::chrono::duration<double>(now.time_since_epoch()).count());
}

bool LeverDesk::put(Hand hand, Page page, const nlohmann::json& sample, Clock::time_point now) {
    Held& held = of(hand);
    if (held.page != nullptr && held.page != page) return false;
    if (overruled(hand).contains(page)) return true;
    const bool taken = held.page == nullptr;
    const bool moved = taken || held.sample != sample;
    const double listened_until = listened(now);
    if (taken) {
        const bool goes_on = silent(hand).page == page, lies = goes_on && silent(hand).sample == sample;
        held = {page,
                sample,
                lies ? silent(hand).moved_in_run : run_heard(),
                listened_until,
                goes_on ? silent(hand).own : now,
                now};
        if (!goes_on && silent(hand).page != nullptr) overruled(hand).insert(silent(hand).page);
        silent(hand) = {};
        if (!goes_on && take_over_) take_over_(hand);
    } else {
        held.heard = listened_until;
        held.sample = sample;
        if (moved) held.moved_in_run = run_heard();
    }
    if (moved) write_(hand, sample, held.moved_in_run);
    if (taken) changed_(hand, page, {});
    return true;
}

void LeverDesk::heard_own(Hand hand, Clock::time_point at) {
    Held& held = of(hand);
    if (held.page != nullptr) held.own = std::max(held.own, at);
}

void LeverDesk::heard_other(Hand hand, const std::string& station, Clock::time_point at, bool outranks) {
    const Held& held = of(hand);
    if (held.page == nullptr || at <= held.since || (!outranks && at - held.own <= kLost)) return;
    overruled(hand).insert(held.page);
    end(hand, station);
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
    const double listened_until = listened(now);
    for (const Hand hand : kHands) {
        if (of(hand).page == nullptr) continue;
        const double silent_for = listened_until - of(hand).heard;
        if (silent_for >= kHandSilent) {
            silent(hand) = of(hand);
            end(hand);
        } else if (silent_for < kRepeated) {
            write_(hand, of(hand).sample, of(hand).moved_in_run);
        }
    }
}

std::uint64_t LeverDesk::run_heard() const {
    return run_heard_ ? run_heard_() : 0;
}

LeverDesk::Page LeverDesk::holder(Hand hand) const {
    return held_.at(static_cast<std::size_t>(hand)).page;
}

void LeverDesk::end(Hand hand, const std::string& taken_by) {
    of(hand) = {};
    changed_(hand, nullptr, taken_by);
}

} // namespace windlass::gateway
