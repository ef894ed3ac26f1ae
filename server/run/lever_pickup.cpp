#include "server/run/lever_pickup.hpp"

#include <algorithm>
#include <utility>

namespace windlass::run {

using exercise::HelmOrder;
using exercise::WindlassOrder;

namespace {

constexpr std::size_t kMaxFormer = 8; // more programs of one hand than ever speak late together

/// Puts the levers (members) that the hand has not moved since `then` back to where they were found. The k-th
/// bit of moved says that the k-th of them was moved.
template <class Order, class... Members>
void put_back(Order& now, const Order& then, const Order& found, unsigned& moved, Members... members) {
    unsigned bit = 1;
    const auto put_back_one = [&](auto member) {
        if (now.*member != then.*member) moved |= bit;
        if ((moved & bit) == 0) now.*member = found.*member;
        bit <<= 1;
    };
    (put_back_one(members), ...);
}

/// The order, as the levers stand that were moved since `then`.
exercise::Order pick_up(const exercise::Order& order, const exercise::Order& then, unsigned& moved,
                        const exercise::Exercise& exercise) {
    if (const auto* sent = std::get_if<WindlassOrder>(&order)) {
        WindlassOrder now = *sent;
        put_back(now, std::get<WindlassOrder>(then), exercise.levers(sent->side), moved,
                 &WindlassOrder::brake, &WindlassOrder::clutch_in, &WindlassOrder::stopper_closed,
                 &WindlassOrder::emergency_stop, &WindlassOrder::speed_lever);
        if (now.speed_lever != sent->speed_lever) now.speed_lever = 0;
        return now;
    }
    auto now = std::get<HelmOrder>(order);
    put_back(now, std::get<HelmOrder>(then), exercise.helm(), moved, &HelmOrder::engine, &HelmOrder::rudder,
             &HelmOrder::bow_thruster, &HelmOrder::stern_thruster);
    return now;
}

} // namespace

void LeverPickup::hold() {
    begins_ = true;
    for (auto& station : senders_) {
        if (!station) continue;
        station->then = station->last;
        station->moved = 0;
    }
}

exercise::Order LeverPickup::taken_up(const exercise::Order& order, const ReceivedOrder& from,
                                      std::uint64_t run, const exercise::Exercise& exercise) {
    const auto levers = LeverOwnership::levers_of(order);
    if (!levers) return order;
    auto& station = senders_[static_cast<std::size_t>(*levers)];
    const bool lies_there = from.moved_in_run != 0 && from.moved_in_run != run;
    if (!station || station->source != from.source) {
        station = Sender{.source = from.source, .writer = from.writer, .last = order};
        if (lies_there) station->then = order;
    } else if (station->writer != from.writer) {
        unsigned none = 0;
        auto& former = station->former;
        if (lies_there && std::ranges::count(former, from.writer) > 0)
            return pick_up(order, order, none, exercise);
        if (former.size() == kMaxFormer) former.erase(former.begin());
        former.push_back(std::exchange(station->writer, from.writer));
        if (lies_there) station->then = order, station->moved = 0;
    }
    station->last = order;
    if (begins_ && station->then) station->then = order;
    return station->then ? pick_up(order, *station->then, station->moved, exercise) : order;
}

} // namespace windlass::run
