#pragma once
// How a cable grows, as it truly is: what a report of it is held against.

#include "server/exercise/definition/orders.hpp"
#include "server/physics/base/state_visitor.hpp"

#include <array>

namespace windlass::assess {

/// By the tension at the lip, in means of a second. Slack: below 1.2 times the weight of the cable that would
/// hang plumb to the bottom; tight: above twice that; growing: between the two, or the mean of ten seconds a
/// tenth above that of the ten before. Which of them was so is kept for ten seconds. Training practice.
class Growth {
public:
    /// A tick. tension: N; plumb_weight: N in water, from the lip straight down to the bottom; tick_rate: Hz.
    void observe(double tension, double plumb_weight, int tick_rate);

    /// Whether the cable has been so within the last ten seconds.
    bool lately(exercise::Growing said) const;

    /// Whether that word for it is worth anything: it has been so lately, or the word next to it has.
    bool nearly(exercise::Growing said) const;

    /// N/s, from the second before to the last one that is over.
    double rise() const { return seconds_ < 2 ? 0 : tension_[0] - tension_[1]; }

    template <class Visitor, physics::StateOf<Growth> Self>
    friend void visit_state(Visitor& v, Self& self);

private:
    static constexpr std::size_t kMean = 10; // s

    bool rises() const;

    int ticks_ = 0;                           ///< of the second that is not over
    double sum_ = 0;                          ///< N, over them
    int seconds_ = 0;                         ///< that are known, of those below
    std::array<double, 2 * kMean> tension_{}; ///< N, means of seconds, newest first
    std::array<unsigned, kMean> was_{};       ///< a bit for each Growing, the same seconds
};

/// s, by which a report of how the cable grows may lie beside the truth.
inline constexpr double kGrowthAround = 10;

} // namespace windlass::assess
