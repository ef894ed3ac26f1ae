#pragma once
// Which page of a station has which levers, and for how long. Pure: time is given, writing is somebody
// else's.

#include "common/hand_silence.hpp"
#include "station/gateway/history.hpp"

#include <nlohmann/json.hpp>

#include <functional>
#include <optional>
#include <set>
#include <string>

namespace windlass::gateway {

/// A windlass or the helm.
enum class Hand { port, starboard, helm };
inline constexpr std::array kHands{Hand::port, Hand::starboard, Hand::helm};

class LeverDesk {
public:
    using Page = const void*; ///< tells pages apart

    /// moved_in_run: ExerciseStatus.run, as it was known when the hand took the levers or moved one last.
    using Write = std::function<void(Hand, const nlohmann::json& sample, std::uint64_t moved_in_run)>;

    /// ExerciseStatus.run, as it was heard last; 0: it was not.
    using RunHeard = std::function<std::uint64_t()>;

    /// Without a word of this station for so long, while an equal is heard on the same levers, the other has
    /// them: a hand that is late is passed over for a moment.
    static constexpr auto kLost = std::chrono::seconds(2);

    /// Told of a hand that has changed; holder nullptr: nobody's. taken_by: which station has the levers
    /// instead, where that is why.
    using Changed = std::function<void(Hand, Page holder, const std::string& taken_by)>;

    /// Told when a page takes levers by a touch, before its first word; not when one that was silent for too
    /// long goes on.
    using TakeOver = std::function<void(Hand)>;

    LeverDesk(Write write, Changed changed, TakeOver take_over = {}, RunHeard run_heard = {})
        : write_{std::move(write)},
          changed_{std::move(changed)},
          take_over_{std::move(take_over)},
          run_heard_{std::move(run_heard)} {}

    /// Set points of that page: written at once when they differ, and again with each tick. False: another
    /// page has these levers. Nothing of a page from which another station has taken them, or another page
    /// while it was silent for too long, counts before it has let go: it may not have heard of that yet, and
    /// its levers are not where the other has left them.
    bool put(Hand hand, Page page, const nlohmann::json& sample, Clock::time_point now);

    /// The word that counts on these levers, by what DDS lets everybody hear, is our own.
    void heard_own(Hand hand, Clock::time_point at);

    /// It is of the station of that name. The same word may be told again. outranks: it was taken over from
    /// us, and counts wherever it is spoken; the levers are its own from this word on, not only after kLost:
    /// else they would come back to us while it is late.
    void heard_other(Hand hand, const std::string& station, Clock::time_point at, bool outranks);

    /// The page has them no more, if it had them.
    void let_go(Hand hand, Page page);
    void leave(Page page); ///< all of them

    /// Writes again what is held while its page has spoken within the last 0.3 s, so that nobody hears a hand
    /// that is silent, and ends what has been silent for kHandSilent. 20 times a second.
    void tick(Clock::time_point now);

    Page holder(Hand hand) const;

private:
    struct Held {
        Page page = nullptr;
        nlohmann::json sample;
        std::uint64_t moved_in_run = 0;
        double heard = 0;        // s of our own time, when its page spoke last
        Clock::time_point own;   // when its word counted last, or it was taken
        Clock::time_point since; // when its page began to speak
    };
    Held& of(Hand hand) { return held_.at(static_cast<std::size_t>(hand)); }
    Held& silent(Hand hand) { return silent_.at(static_cast<std::size_t>(hand)); }
    std::set<Page>& overruled(Hand hand) { return overruled_.at(static_cast<std::size_t>(hand)); }
    void end(Hand hand, const std::string& taken_by = {});
    double listened(Clock::time_point now); ///< s of our own time
    std::uint64_t run_heard() const;

    ListeningTime listening_;
    Write write_;
    Changed changed_;
    TakeOver take_over_;
    RunHeard run_heard_;
    std::array<Held, 3> held_;
    std::array<Held, 3> silent_; // hands that were given up for silence, and have not been let go since
    std::array<std::set<Page>, 3> overruled_; // pages that have yet to let go of what another took
};

} // namespace windlass::gateway
