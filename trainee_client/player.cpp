#include "trainee_client/player.hpp"

#include "station/format.hpp"
#include "station/names.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace windlass::trainee {

using station::Picture;

Player::Player(Script script, int side) : script_{std::move(script)}, side_{side} {
    if (script_.mate) mate_.emplace(side);
}

bool Player::finished() const {
    return !mate_ && next_ == script_.steps.size();
}

double Player::since_step(const Picture& picture) const {
    return picture.time(side_) - step_time_.value_or(0);
}

std::vector<const Step*> Player::advance(const Picture& picture) {
    std::vector<const Step*> taken;
    const bool heard = picture.status && (script_.conns || station::levers_known(picture, side_));
    if (heard) repeat_orders(picture, taken);
    if (!heard || finished() || failure_) return taken;
    if (mate_) {
        mates_ = mate_->advance(picture);
        for (const Step& step : mates_)
            taken.push_back(&step);
        return taken;
    }

    const double now = picture.time(side_);
    if (!step_time_) {
        step_time_ = last_time_ = now;
        reports_before_ = picture.reports.received;
    }
    if (script_.follows_orders) skip_what_is_not_ordered(picture);
    while (!finished() &&
           script_.steps[next_].when.holds(picture, side_, now - *step_time_, reports_before_)) {
        taken.push_back(&script_.steps[next_++]);
        step_time_ = now;
        reports_before_ = picture.reports.received;
    }
    if (finished()) return taken;

    constexpr double kBackwards = 1; // s; topics of one tick may come in any order
    if (now < last_time_ - kBackwards)
        fail(picture, fmt::format("the exercise went back from {} to {}", station::clock(last_time_),
                                  station::clock(now)));
    else if (picture.status->state() == RUN_STOPPED_BY_FAULT || picture.status->state() == RUN_FINISHED)
        fail(picture, fmt::format("the exercise is {}", station::name(picture.status->state())));
    else if (now - *step_time_ > script_.steps[next_].timeout)
        fail(picture, fmt::format("timed out after {:g} s", script_.steps[next_].timeout));
    last_time_ = now;
    return taken;
}

/// Goes on to the step of an order that has come, when the one that is waited for has not: the bridge does
/// not order what it hears to be done.
void Player::skip_what_is_not_ordered(const Picture& picture) {
    const auto asks_for = [](const Condition& when, const Condition& other) {
        return when.ordered == other.ordered && when.ordered_value == other.ordered_value;
    };
    const auto given = [&](const Condition& when) {
        Condition order;
        order.ordered = when.ordered;
        order.ordered_value = when.ordered_value;
        return order.holds(picture, side_, 0);
    };
    const Condition& waits = script_.steps[next_].when;
    if (!waits.ordered || given(waits)) return;
    for (std::size_t k = next_ + 1; k < script_.steps.size(); ++k) {
        const Condition& later = script_.steps[k].when;
        if (!later.ordered || !given(later)) continue;
        const auto begin = script_.steps.begin();
        const bool done = std::any_of(begin, begin + static_cast<std::ptrdiff_t>(next_),
                                      [&](const Step& step) { return asks_for(step.when, later); });
        if (done) continue;
        next_ = k;
        return;
    }
}

/// Repeats back, with what was heard of it, each order that waits for that since long enough.
void Player::repeat_orders(const Picture& picture, std::vector<const Step*>& taken) {
    if (!script_.repeats_orders || !picture.status) return;
    for (const BridgeOrder& order : picture.orders) {
        const bool ours = order.side() < 0 || order.side() == side_;
        if (mate_ && mate_->cannot(order, picture)) continue;
        const bool waits = order.run() == picture.status->run() && order.repeat_by() > 0 &&
                           (order.state() == ORDER_GIVEN || order.state() == ORDER_NOT_REPEATED);
        const bool again = std::ranges::any_of(
            repeats_, [&](const Step& step) { return step.report->order_number == order.number(); });
        if (!ours || !waits || again || picture.time(side_) < order.time() + *script_.repeats_orders)
            continue;
        Step& step = repeats_.emplace_back();
        step.report = ReportOrder{.code = REPORT_ORDER_REPEATED,
                                  .value = order.value(),
                                  .side = order.side(),
                                  .order = order.code(),
                                  .order_number = order.number(),
                                  .text = {}};
        if (order.code() == BRIDGE_ORDER_TEXT) step.report->text = order.text().to_string();
        if (script_.repeats_wrongly) {
            if (order.value() > 0)
                step.report->value += 1;
            else
                step.report->side = order.side() == SIDE_PORT ? SIDE_STARBOARD : SIDE_PORT;
        }
        taken.push_back(&step);
    }
}

void Player::fail(const Picture& picture, const std::string& reason) {
    failure_ = fmt::format("{}: {}", reason, waiting_for(picture));
}

std::string Player::waiting_for(const Picture& picture) const {
    if (finished() || mate_) return "";
    const Step& step = script_.steps[next_];
    const std::string say = step.say.empty() ? "" : fmt::format(" (\"{}\")", step.say);
    const double since = picture.status ? since_step(picture) : 0;
    return fmt::format("step {} of {}{} waits for {}", next_ + 1, script_.steps.size(), say,
                       step.when.unmet(picture, side_, since, reports_before_));
}

} // namespace windlass::trainee
