#pragma once
// When a hand on the levers that is not heard any more is taken to be gone. One rule for the server and for a
// station's hold on its pages; docs/command_authority.md tells it. What a station shows of others' hands goes
// by kHandSilent alone.

#include <algorithm>

namespace windlass {

/// s without a word after which a hand is taken to be gone whose words have come regularly; they come 20
/// times a second.
inline constexpr double kHandSilent = 1;

/// s after which any hand is, however late its words have come before.
inline constexpr double kHandSilentAtMost = 3;

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

/// Tells a hand that is gone from one at a slow computer: a silence counts that is long against the gaps
/// there have been between its words. Times are s of ListeningTime.
class HandSilence {
public:
    HandSilence() = default;
    /// Its first word comes now.
    explicit HandSilence(double now) : heard_(now) {}

    /// It speaks again, also after it was given up.
    void heard(double now) {
        constexpr double kForgotten =
            0.05; // s of the longest gap, each s: after 20 s at most it is forgotten
        const double gap = now - heard_;
        longest_gap_ = std::max(gap, std::min(longest_gap_, kHandSilentAtMost / kGaps) - kForgotten * gap);
        heard_ = now;
    }

    /// s since its last word.
    double silent(double now) const { return now - heard_; }

    /// When it will be taken to be gone, if no word comes until then.
    double given_up_at() const {
        return heard_ + std::clamp(kGaps * longest_gap_, kHandSilent, kHandSilentAtMost);
    }

private:
    static constexpr double kGaps = 3; // a silence as long as so many of the longest gap

    double heard_ = 0;
    double longest_gap_ = 0;
};

} // namespace windlass
