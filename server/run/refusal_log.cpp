#include "server/run/refusal_log.hpp"

#include <algorithm>

namespace windlass::server {

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

std::string RefusalLog::with_untold(std::string text) {
    if (untold_ > 0) text = "(" + std::to_string(untold_) + " refusals not listed) " + text;
    untold_ = 0;
    return text;
}

std::optional<std::string> RefusalLog::add(const Refusal& refusal, double now) {
    total_ += refusal.samples;
    if (may_tell(now)) return with_untold(refusal.text());
    untold_ += refusal.samples;
    return std::nullopt;
}

std::optional<std::string> RefusalLog::add_overflow(std::uint64_t samples, double now) {
    total_ += samples;
    if (may_tell(now)) {
        return with_untold(std::to_string(samples) +
                           " samples refused: the mailbox was full; allowed: 1024 in a tick");
    }
    untold_ += samples;
    return std::nullopt;
}

} // namespace windlass::server
