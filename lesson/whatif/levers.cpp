#include "lesson/whatif/levers.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::whatif {

namespace {

constexpr double kPause = 0.5; // s, without which it is one movement

/// What an order says of a lever; nothing: it is of others.
std::optional<double> said_of(const Lever& lever, const exercise::Order& order) {
    if (const auto* helm = std::get_if<exercise::HelmOrder>(&order); helm != nullptr && lever.of_helm())
        return lever.kind == LeverKind::engine ? helm->engine : helm->rudder;
    const auto* windlass = std::get_if<exercise::WindlassOrder>(&order);
    if (windlass == nullptr || lever.of_helm() || windlass->side != lever.side) return std::nullopt;
    switch (lever.kind) {
    case LeverKind::brake:
        return windlass->brake;
    case LeverKind::speed:
        return windlass->speed_lever;
    case LeverKind::clutch:
        return windlass->clutch_in ? 1 : 0;
    default:
        return windlass->stopper_closed ? 1 : 0;
    }
}

void put(const Lever& lever, double value, exercise::Order& order) {
    if (auto* helm = std::get_if<exercise::HelmOrder>(&order)) {
        (lever.kind == LeverKind::engine ? helm->engine : helm->rudder) = value;
        return;
    }
    auto& windlass = std::get<exercise::WindlassOrder>(order);
    switch (lever.kind) {
    case LeverKind::brake:
        windlass.brake = value;
        return;
    case LeverKind::speed:
        windlass.speed_lever = value;
        return;
    case LeverKind::clutch:
        windlass.clutch_in = value > 0.5;
        return;
    default:
        windlass.stopper_closed = value > 0.5;
    }
}

exercise::Order order_at_first(const Lever& lever, const LeversAtFirst& first) {
    if (lever.of_helm()) return first.helm;
    return first.windlass.at(static_cast<std::size_t>(lever.side));
}

} // namespace

double value_at(const Track& track, std::uint64_t tick) {
    const auto later = std::ranges::upper_bound(track, tick, {}, &Place::tick);
    return later == track.begin() ? track.front().value : std::prev(later)->value;
}

Track track_of(const Lever& lever, const std::vector<run::OrderView>& orders, const LeversAtFirst& first,
               std::uint64_t first_tick) {
    Track track{{first_tick, *said_of(lever, order_at_first(lever, first))}};
    for (const run::OrderView& order : orders) {
        const auto value = said_of(lever, order.command);
        if (!value) continue;
        if (track.back().tick == order.tick) // the last word of a tick holds
            track.back().value = *value;
        else if (*value != track.back().value)
            track.push_back({order.tick, *value});
    }
    return track;
}

std::vector<Move> moves_of(const Track& track, int tick_rate) {
    const auto pause = static_cast<std::uint64_t>(std::llround(kPause * tick_rate));
    const auto way = [&](std::size_t k) { return track[k].value > track[k - 1].value; };
    std::vector<Move> moves;
    for (std::size_t k = 1; k < track.size(); ++k) {
        const bool goes_on = k > 1 && track[k].tick - track[k - 1].tick < pause && way(k) == way(k - 1);
        if (goes_on)
            moves.back().last = k;
        else
            moves.push_back({k, k});
    }
    return moves;
}

std::vector<run::OrderView> with_track(const std::vector<run::OrderView>& orders, const Lever& lever,
                                       const Track& track, const LeversAtFirst& first) {
    std::vector<run::OrderView> changed;
    changed.reserve(orders.size() + track.size());
    run::OrderView last{
        .run = 0, .tick = 0, .number = 0, .source = {}, .command = order_at_first(lever, first)};
    std::size_t next = 1; // place that no order has told yet
    const auto put_in_before = [&](std::uint64_t tick) {
        for (; next < track.size() && track[next].tick < tick; ++next) {
            last.tick = track[next].tick;
            put(lever, track[next].value, last.command);
            changed.push_back(last);
        }
    };
    for (const run::OrderView& order : orders) {
        put_in_before(order.tick);
        changed.push_back(order);
        if (!said_of(lever, order.command)) continue;
        put(lever, value_at(track, order.tick), changed.back().command);
        while (next < track.size() && track[next].tick <= order.tick)
            ++next;
        last = changed.back();
        last.number = 0; // what is put in has no number
    }
    put_in_before(UINT64_MAX);
    return changed;
}

} // namespace windlass::whatif
