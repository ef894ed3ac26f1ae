#include "server/exercise/watch/riding.hpp"

#include "server/physics/base/state_limits.hpp"

#include <algorithm>

namespace windlass::exercise {

namespace {

constexpr double kMark = 3; ///< s between two marks of the way

constexpr double kDrags = 2;     ///< m within a minute beyond what digs it in: it drags
constexpr double kDragsOn = 0.5; ///< m within a minute: it still does
constexpr double kStill = 0.1;   ///< m within half a minute: it stays where it is
constexpr double kStillOn = 1;   ///< m within half a minute: what it may creep as she yaws, and still hold

constexpr double kStrain = 60e3; ///< N, level: the cable has come to strain
constexpr double kAbove = 1.5;   ///< ... and to so many times what is asked of it
constexpr double kEased = 0.25;  ///< of the excess, that may be left of it

} // namespace

void AnchorWay::forget(const Riding& now) {
    way_ = since_mark_ = 0;
    dragged_ = now.dragged;
    ways_.fill(0);
    embedments_.fill(now.embedment);
    dragging_ = still_ = false;
}

void AnchorWay::mark(double embedment) {
    std::shift_right(ways_.begin(), ways_.end(), 1);
    std::shift_right(embedments_.begin(), embedments_.end(), 1);
    ways_[0] = way_;
    embedments_[0] = embedment;
}

void AnchorWay::observe(const Riding& now) {
    if (!now.landed) {
        forget(now);
        return;
    }
    if (now.taut) way_ += std::max(0.0, now.dragged - dragged_);
    dragged_ = now.dragged;
    for (since_mark_ += now.dt; since_mark_ >= kMark; since_mark_ -= kMark)
        mark(now.embedment);

    const double moved = moved_in_minute();
    const double dug = std::max(0.0, now.embedment - embedments_[kMarks - 1]) * now.setting;
    dragging_ = moved - dug >= kDrags || (dragging_ && moved > kDragsOn);
    still_ = !dragging_ && moved_in_half_minute() < (still_ ? kStillOn : kStill);
}

void BroughtUp::Mean::follow(double value, double lag, double dt) {
    const double share = lag > dt ? dt / lag : 1;
    first += share * (value - first);
    second += share * (first - second);
}

bool BroughtUp::observe(const Riding& now, const AnchorWay& way) {
    if (!now.landed || !now.held || way.dragging()) {
        *this = {};
        return false;
    }
    pull_.follow(now.pull, waiting_ ? now.wave_period : 0, now.dt);
    asked_.follow(now.asked, waiting_ ? now.wave_period : 0, now.dt);
    waiting_ = true;
    const double pull = pull_.second, asked = asked_.second;
    peak_ = std::max(peak_, pull);
    const bool strained = peak_ > kAbove * asked && peak_ > kStrain;
    const bool eased = pull - asked < kEased * (peak_ - asked);
    const bool was = is_;
    is_ = is_ || (strained && eased && way.moved_in_half_minute() < kStill && now.embedment > kGrip);
    return is_ && !was;
}

template <class Visitor, physics::StateOf<AnchorWay> Self>
void visit_state(Visitor& v, Self& self) {
    WINDLASS_STATE(v, self.way_, self.dragged_, self.since_mark_, self.dragging_, self.still_);
    v.within({"since_mark"}, self.since_mark_, 0, kMark);
    v.numbers({"ways"}, self.ways_.data(), self.ways_.size());
    v.numbers({"embedments"}, self.embedments_.data(), self.embedments_.size());
    WINDLASS_WITHIN(v, -physics::kFarthest, physics::kFarthest, self.way_, self.dragged_);
}
WINDLASS_STATE_LISTED(AnchorWay);

template <class Visitor, physics::StateOf<BroughtUp> Self>
void visit_state(Visitor& v, Self& self) {
    auto& [first_pull, pull] = self.pull_;
    auto& [first_asked, asked] = self.asked_;
    WINDLASS_STATE(v, self.waiting_, first_pull, pull, first_asked, asked, self.peak_, self.is_);
    WINDLASS_WITHIN(v, -physics::kStrongest, physics::kStrongest, first_pull, pull, first_asked, asked,
                    self.peak_);
}
WINDLASS_STATE_LISTED(BroughtUp);

} // namespace windlass::exercise
