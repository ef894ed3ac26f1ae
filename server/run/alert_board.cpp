#include "server/run/alert_board.hpp"

#include <algorithm>

namespace windlass::run {

AlertView* AlertBoard::find(std::string_view code, int side) {
    const auto found = std::find_if(alerts_.begin(), alerts_.end(),
                                    [&](const AlertView& a) { return a.code == code && a.side == side; });
    return found == alerts_.end() ? nullptr : &*found;
}

void AlertBoard::change(AlertView& alert, AlertCondition condition, std::uint64_t tick, double time) {
    alert.condition = condition;
    alert.tick = tick;
    alert.time = time;
    changes_.push_back(alert);
}

void AlertBoard::raise(AlertView alert) {
    alert.raised_time = alert.time;
    AlertView* known = find(alert.code, alert.side);
    if (known == nullptr) known = &alerts_.emplace_back();
    *known = std::move(alert);
    change(*known, AlertCondition::active_unacknowledged, known->tick, known->time);
}

void AlertBoard::rectify(std::string_view code, int side, std::uint64_t tick, double time) {
    AlertView* alert = find(code, side);
    if (alert == nullptr) return;
    switch (alert->condition) {
    case AlertCondition::active_acknowledged:
        change(*alert, AlertCondition::normal, tick, time);
        break;
    case AlertCondition::active_unacknowledged:
    case AlertCondition::active_silenced:
        change(*alert, AlertCondition::rectified_unacknowledged, tick, time);
        break;
    case AlertCondition::rectified_unacknowledged:
    case AlertCondition::normal:
        break;
    }
}

bool AlertBoard::stands(std::string_view code, int side, double time) const {
    return std::any_of(alerts_.begin(), alerts_.end(), [&](const AlertView& a) {
        return a.code == code && a.side == side && a.raised_time <= time &&
               a.condition != AlertCondition::rectified_unacknowledged &&
               a.condition != AlertCondition::normal;
    });
}

void AlertBoard::sound_again(std::uint64_t tick, double time, double now) {
    for (AlertView& alert : alerts_) {
        if (alert.condition != AlertCondition::active_silenced || now < alert.silenced_until) continue;
        alert.silenced_until = alert.silenced_left = 0;
        change(alert, AlertCondition::active_unacknowledged, tick, time);
    }
}

bool AlertBoard::acknowledge(const AlertOrder& order, std::uint64_t tick, double time, double now) {
    AlertView* alert = find(order.code, order.side);
    if (alert == nullptr) return false;
    const bool active = alert->condition == AlertCondition::active_unacknowledged ||
                        alert->condition == AlertCondition::active_silenced;
    if (order.acknowledge && active) {
        change(*alert, AlertCondition::active_acknowledged, tick, time);
    } else if (order.acknowledge && alert->condition == AlertCondition::rectified_unacknowledged) {
        change(*alert, AlertCondition::normal, tick, time);
    } else if (!order.acknowledge && alert->condition == AlertCondition::active_unacknowledged) {
        alert->silenced_until = now + kSilence;
        alert->silenced_left = kSilence;
        change(*alert, AlertCondition::active_silenced, tick, time);
    } else {
        return false;
    }
    return true;
}

} // namespace windlass::run
