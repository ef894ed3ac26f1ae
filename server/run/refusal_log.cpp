#include "server/run/refusal_log.hpp"

#include <algorithm>

namespace windlass::run {

namespace {

constexpr double kEventsPerSecond = 10;
constexpr double kBurst = 20;

} // namespace

bool RefusalLog::may_tell(double now) {
    allowance_ = first_ ? kBurst : std::min(kBurst, allowance_ + (now - asked_) * kEventsPerSecond);
    first_ = false;
    asked_ = now;
    if (allowance_ < 1) return false;
    allowance_ -= 1;
    return true;
}

RefusalLog::Told RefusalLog::with_others(Waiting refusal) {
    if (refusal.others > 0)
        refusal.last.text =
            "(" + std::to_string(refusal.others) + " refusals not listed) " + refusal.last.text;
    return std::move(refusal.last);
}

std::optional<RefusalLog::Told> RefusalLog::tell(Waiting refusal, double now) {
    const auto before = std::ranges::find(waiting_, refusal.reason, &Waiting::reason);
    const bool waits = before != waiting_.end();
    if (waits) refusal.others = before->others + before->samples;
    if (may_tell(now)) {
        if (waits) waiting_.erase(before);
        return with_others(std::move(refusal));
    }
    if (waits)
        *before = std::move(refusal);
    else
        waiting_.push_back(std::move(refusal));
    return std::nullopt;
}

std::optional<RefusalLog::Told> RefusalLog::add(const Refusal& refusal, double now) {
    total_ += refusal.samples;
    return tell({.reason = refusal.topic + '.' + refusal.field,
                 .last = {refusal.text(), refusal.side, refusal.number},
                 .samples = refusal.samples},
                now);
}

std::optional<RefusalLog::Told> RefusalLog::add_overflow(std::uint64_t samples, double now) {
    total_ += samples;
    return tell(
        {.reason = "mailbox",
         .last = {std::to_string(samples) + " samples refused: the mailbox was full; allowed: 1024 in a tick",
                  -1, static_cast<double>(samples)},
         .samples = samples},
        now);
}

std::optional<RefusalLog::Told> RefusalLog::overdue(double now) {
    if (waiting_.empty() || !may_tell(now)) return std::nullopt;
    Waiting first = std::move(waiting_.front());
    waiting_.pop_front();
    return with_others(std::move(first));
}

} // namespace windlass::run
