#include "server/dds/rate_gate.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::server {

bool RateGate::due(std::uint64_t tick, int tick_rate, double now) {
    const auto period = static_cast<std::uint64_t>(std::floor(static_cast<double>(tick) * rate_ / tick_rate));
    if (!first_) allowance_ = std::min(kBurst, allowance_ + (now - asked_) * rate_);
    asked_ = now;
    const bool moved = period != period_;
    const bool repeats = tick == tick_ && now - sent_ >= 1 / idle_rate_;
    tick_ = tick;
    if (!first_ && !((moved || repeats) && allowance_ >= 1)) return false;
    first_ = false;
    period_ = period;
    sent_ = now;
    allowance_ -= 1;
    return true;
}

} // namespace windlass::server
