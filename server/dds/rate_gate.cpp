#include "server/dds/rate_gate.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::dds {

std::uint64_t RateGate::period_of(std::uint64_t tick, int tick_rate) const {
    return static_cast<std::uint64_t>(std::floor(static_cast<double>(tick) * rate_ / tick_rate));
}

double RateGate::allowance(double now) const {
    return first_ ? allowance_ : std::min(kBurst, allowance_ + (now - asked_) * rate_);
}

bool RateGate::will_be_due(std::uint64_t tick, int tick_rate, double now) const {
    const bool moved = period_of(tick, tick_rate) != period_;
    const bool repeats = tick == tick_ && now - sent_ >= 1 / idle_rate_;
    return first_ || ((moved || repeats) && allowance(now) >= 1);
}

bool RateGate::due(std::uint64_t tick, int tick_rate, double now) {
    const bool due = will_be_due(tick, tick_rate, now);
    allowance_ = allowance(now);
    asked_ = now;
    tick_ = tick;
    if (!due) return false;
    first_ = false;
    period_ = period_of(tick, tick_rate);
    sent_ = now;
    allowance_ -= 1;
    return true;
}

} // namespace windlass::dds
