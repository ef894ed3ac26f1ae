#pragma once
// Which page of a station has which levers, and for how long. Pure: time is given, writing is somebody
// else's.

#include "common/hand_silence.hpp"
#include "station/gateway/history.hpp"

#include <nlohmann/json.hpp>

#include <functional>
#include <optional>
#include <string>

namespace windlass::gateway {

/// A windlass or the helm.
enum class Hand { port, starboard, helm };
inline constexpr std::array kHands{Hand::port, Hand::starboard, Hand::helm};

class LeverDesk {
public:
    using Page = const void*; ///< tells pages apart

    using Write = std::function<void(Hand, const nlohmann::json& sample)>;
    /// Told of a hand that has changed; holder nullptr: nobody's.
    using Changed = std::function<void(Hand, Page holder)>;

    LeverDesk(Write write, Changed changed) : write_{std::move(write)}, changed_{std::move(changed)} {}

    /// Set points of that page: written at once when they differ, and again with each tick. False: another
    /// page has these levers.
    bool put(Hand hand, Page page, const nlohmann::json& sample, Clock::time_point now);

    /// The page has them no more, if it had them.
    void let_go(Hand hand, Page page);
    void leave(Page page); ///< all of them

    /// Writes again what is held while its page has spoken within the last 0.3 s, so that nobody hears a hand
    /// that is silent, and ends what has been silent for too long (HandSilence). 20 times a second.
    void tick(Clock::time_point now);

    Page holder(Hand hand) const;

private:
    struct Held {
        Page page = nullptr;
        nlohmann::json sample;
        HandSilence silence;
    };
    Held& of(Hand hand) { return held_.at(static_cast<std::size_t>(hand)); }
    void end(Hand hand);
    double listened(Clock::time_point now); ///< s of our own time

    ListeningTime listening_;
    Write write_;
    Changed changed_;
    std::array<Held, 3> held_;
};

} // namespace windlass::gateway
