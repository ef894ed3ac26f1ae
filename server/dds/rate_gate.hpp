#pragma once
// When a topic is due.

#include <cstdint>

namespace windlass::dds {

/// Thins ticks out to a rate. The rate counts in exercise time; a cap of the same rate in wall time keeps a
/// hurried exercise from flooding its listeners; an exercise that stands still is repeated now and then, so
/// that those who join see it.
class RateGate {
public:
    /// rate and idle_rate in Hz, idle_rate for an exercise that stands still.
    RateGate(double rate, double idle_rate) : rate_(rate), idle_rate_(idle_rate), allowance_(kBurst) {}

    /// Whether to send tick `tick` of an exercise with tick_rate steps per second at wall time now (s, from
    /// any start, never going back).
    bool due(std::uint64_t tick, int tick_rate, double now);
    /// What due() would say; nothing is sent, and nothing remembered.
    bool will_be_due(std::uint64_t tick, int tick_rate, double now) const;

private:
    static constexpr double kBurst = 4; // samples that may come early, for a tick that wakes late
    std::uint64_t period_of(std::uint64_t tick, int tick_rate) const;
    double allowance(double now) const;

    double rate_, idle_rate_;
    double allowance_;            // samples that the cap allows now
    double asked_ = 0, sent_ = 0; // wall time
    std::uint64_t tick_ = 0;
    std::uint64_t period_ = 0; // of the rate, in which tick_ lies
    bool first_ = true;
};

} // namespace windlass::dds
