#pragma once
// When a hand on the levers that is not heard any more is taken to be gone. One rule for the server and for a
// station's hold on its pages; docs/command_authority.md tells it.

#include <algorithm>

namespace windlass {

/// s without a word after which a hand is taken to be gone. Its words come 10 or 20 times a second; those of
/// a page came up to 3.1 s late on two cores with four pages and two other processes that each took a core.
inline constexpr double kHandSilent = 5;

/// The time that counts as silence of others, s: the listener's own, without what it slept through itself.
class ListeningTime {
public:
    /// At wall time now (s, never going back). To be asked at least 10 times a second: more than 0.1 s since
    /// it was asked last counts as 0.1 s.
    double at(double now) {
        constexpr double kBeat = 0.1;
        listened_ += std::clamp(now - now_, 0.0, kBeat);
        now_ = now;
        return listened_;
    }

private:
    double now_ = 0, listened_ = 0;
};

} // namespace windlass
