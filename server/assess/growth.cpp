#include "server/assess/growth.hpp"

#include <algorithm>
#include <numeric>

namespace windlass::assess {

using exercise::Growing;

namespace {

constexpr double kSlack = 1.2, kTight = 2; // of the plumb cable's weight
constexpr double kRises = 1.1;             // of the mean of the ten seconds before

constexpr unsigned bit(Growing growing) {
    return 1U << static_cast<unsigned>(growing);
}

} // namespace

void Growth::observe(double tension, double plumb_weight, int tick_rate) {
    sum_ += tension;
    if (++ticks_ < tick_rate) return;
    std::shift_right(tension_.begin(), tension_.end(), 1);
    std::shift_right(was_.begin(), was_.end(), 1);
    tension_[0] = sum_ / ticks_;
    sum_ = ticks_ = 0;
    seconds_ = std::min(seconds_ + 1, static_cast<int>(tension_.size()));
    const bool slack = tension_[0]<kSlack * plumb_weight, tight = tension_[0]> kTight * plumb_weight;
    was_[0] = slack ? bit(Growing::slack) : tight ? bit(Growing::tight) : bit(Growing::growing);
    if (rises()) was_[0] |= bit(Growing::growing);
}

bool Growth::rises() const {
    if (seconds_ < static_cast<int>(tension_.size())) return false;
    const auto middle = tension_.begin() + kMean;
    return std::accumulate(tension_.begin(), middle, 0.0) >
           kRises * std::accumulate(middle, tension_.end(), 0.0);
}

bool Growth::lately(Growing said) const {
    return std::any_of(was_.begin(), was_.end(), [&](unsigned was) { return (was & bit(said)) != 0; });
}

bool Growth::nearly(Growing said) const {
    const bool is_next_to_all = said == Growing::growing || said == Growing::not_given;
    return is_next_to_all || lately(said) || lately(Growing::growing);
}

template <class Visitor, physics::StateOf<Growth> Self>
void visit_state(Visitor& v, Self& self) {
    WINDLASS_STATE(v, self.ticks_, self.sum_, self.seconds_);
    v.within({"seconds"}, self.seconds_, 0, static_cast<int>(self.tension_.size()));
    v.numbers({"tension"}, self.tension_.data(), self.tension_.size());
    for (auto& was : self.was_)
        v.whole({"was"}, was);
}
WINDLASS_STATE_LISTED(Growth);

} // namespace windlass::assess
