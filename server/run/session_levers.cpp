// Session: who has the levers, and what becomes of levers that nobody has.

#include "server/run/session.hpp"

#include "server/exercise/watch/event_detector.hpp"
#include "server/run/limits.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace windlass::run {

namespace {

constexpr const char* kUnattended = "levers.unattended";

/// The side that events and alerts of these levers name.
int side_of(LeverGroup levers) {
    return levers == LeverGroup::helm ? -1 : static_cast<int>(levers);
}

/// Whether brake and stopper hold the cable of that windlass: it wants no hand.
bool is_secured(const exercise::Snapshot& snapshot, LeverGroup levers) {
    return std::ranges::any_of(snapshot.tackle, [levers](const exercise::TackleView& tackle) {
        const auto& windlass = tackle.windlass;
        return static_cast<LeverGroup>(tackle.side) == levers &&
               windlass.brake_position > exercise::kHardOn && windlass.stopper_closed &&
               !windlass.stopper_sprung;
    });
}

} // namespace

void Session::forget_hands() {
    for (const LeverGroup levers : kAllLeverGroups)
        alerts_.rectify(kUnattended, side_of(levers), tick_, time_);
    lever_ownership_.clear();
    left_ = {};
}

/// Whether an order to these levers is heard. Who gives it has them then, and who takes them from another is
/// named.
bool Session::take_levers(LeverGroup levers, const ReceivedOrder& from) {
    const auto before = lever_ownership_.take(levers, from);
    if (!before) return false;
    if (before->source == from.source) return true;
    const char* how = before->let_go ? ", handed back by " : ", taken from ";
    const bool was_nobodys = before->source.empty() || before->source == kServerName;
    log("levers.taken",
        fmt::format("{} has the {}{}", from.source, name(levers), was_nobodys ? "" : how + before->source),
        side_of(levers));
    left_.at(static_cast<std::size_t>(levers)).reset();
    alerts_.rectify(kUnattended, side_of(levers), tick_, time_);
    return true;
}

void Session::look_for_hands() {
    for (const LeverGroup levers : kAllLeverGroups) {
        const auto hand = lever_ownership_.gone(levers);
        if (hand && !over()) leave_alone(levers, *hand);
    }
    if (!over()) tell_of_levers_left();
}

/// By their alert; of one who has both seats and went over to the levers of the other there is none, until he
/// leaves those, too.
void Session::tell_of_levers_left() {
    for (const LeverGroup levers : kAllLeverGroups) {
        auto& left = left_.at(static_cast<std::size_t>(levers));
        if (!left) continue;
        const bool unattended = !(left->goes_over && lever_ownership_.is_elsewhere(levers, left->source));
        if (std::exchange(left->told, unattended) == unattended) continue;
        left->alert.tick = tick_, left->alert.time = time_;
        if (unattended)
            alerts_.raise(left->alert);
        else
            alerts_.rectify(kUnattended, side_of(levers), tick_, time_);
    }
}

/// No more than 3 s of exercise go by on the word of a hand that is not heard, however the exercise is
/// hurried. From then on the clock is a real one, by which the hand is given up or heard again.
bool Session::hand_is_late() const {
    constexpr double kUnheard = 3;  // s of exercise
    constexpr double kFastest = 20; // as an exercise counts here that runs as fast as possible
    const double scale = status_.time_scale > 0 ? status_.time_scale : kFastest;
    return scale > 1 && running() && lever_ownership_.longest_silence() * scale > kUnheard;
}

/// An exercise that goes on may have been left, or restored, with a speed lever that is not at zero. Unless a
/// hand takes it, it is one that was let go: until then it is kept in the server's own name, which no hand
/// has.
void Session::watch_for_a_hand() {
    for (const auto& tackle : def().tackle) {
        const auto levers = static_cast<LeverGroup>(tackle.side);
        if (lever_ownership_.free(levers) && exercise_.levers(tackle.side).speed_lever != 0)
            lever_ownership_.take(levers, {.source = kServerName, .what = {}, .writer = {}});
    }
}

/// The state in which the real thing is left when its operator lets go: the windlass's speed lever springs to
/// zero; hand-wheel, clutch, stopper and a pressed emergency stop stay as they are, and so do telegraph,
/// wheel and thruster levers.
void Session::leave_alone(LeverGroup levers, const LeverOwnership::Hand& hand) {
    const char* left = "the helm's levers stay as they are";
    if (levers != LeverGroup::helm) {
        exercise::WindlassOrder order = exercise_.levers(static_cast<exercise::Side>(levers));
        order.speed_lever = 0;
        apply(order, kServerName);
        left = "speed lever at zero; brake, clutch and stopper as they were";
    }
    // Whoever has secured an anchor goes away from it; whoever is not heard may lie beside it. A helm that
    // nobody had is left by an instructor as he found it.
    const bool as_found = levers == LeverGroup::helm && hand.let_go && hand.instructor && hand.found_free;
    const bool wants_no_hand =
        as_found || ((hand.let_go || hand.source == kServerName) && is_secured(snapshot_, levers));
    const bool goes_over = hand.let_go && !hand.instructor;
    const bool is_there = goes_over && lever_ownership_.is_elsewhere(levers, hand.source);
    const auto told = [&](std::string text) {
        constexpr words::EventCode kLost = "levers.lost";
        log(kLost, wants_no_hand || is_there ? words::Severity::info : kLost.row().severity, std::move(text),
            side_of(levers));
    };
    if (hand.source == kServerName) { // somebody may sit there who has not touched them: no alarm
        told(fmt::format("nobody has moved the levers of the {} yet: {}", name(levers), left));
        return;
    }
    told(hand.let_go
             ? fmt::format("{} is not at the levers: nobody has the {}; {}", hand.source, name(levers), left)
             : fmt::format("{} is no longer heard and nobody has the {}: {}", hand.source, name(levers),
                           left));
    if (wants_no_hand) return;
    AlertView unattended = alert(
        kUnattended, side_of(levers), 0,
        {name(levers), hand.source, hand.let_go ? "is not at the levers" : "is not heard any more", left});
    (levers == LeverGroup::helm ? unattended.deck_panel : unattended.bridge_panel) = false;
    left_.at(static_cast<std::size_t>(levers)) =
        LeversLeft{.source = hand.source, .goes_over = goes_over, .alert = std::move(unattended)};
}

} // namespace windlass::run
