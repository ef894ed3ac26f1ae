#include "door/stations.hpp"

namespace windlass::door {

using station::Seat;

Seat seat_at(Place place) {
    switch (place) {
    case Place::ship:
        return Seat::trainee;
    case Place::forecastle:
        return Seat::forecastle;
    case Place::bridge:
        return Seat::conning;
    case Place::watch:
        break;
    }
    return Seat::watcher;
}

Seat seat_of(Rank rank) {
    if (leads(rank)) return Seat::instructor;
    return rank == Rank::assessor ? Seat::assessor : Seat::observer;
}

Stations::Stations(gateway::GatewayOptions instructor) : readers_{wire::Participant(instructor.member)} {
    instructor.readers = readers_;
    others_.member = instructor.member;
    others_.readers = readers_;
    others_.exercise.clear();
    others_.log = instructor.log;
    others_.given = instructor.given;
    others_.recordings = instructor.recordings;
    others_.events_of = instructor.events_of;
    others_.past_of = instructor.past_of;
    const auto made = gateways_.try_emplace(Seat::instructor, std::move(instructor)).first;
    others_.replays = made->second.options().replays; // one for all
}

gateway::Gateway& Stations::of(Seat seat) {
    if (const auto found = gateways_.find(seat); found != gateways_.end()) return found->second;
    gateway::GatewayOptions options = others_;
    options.seat = seat;
    return gateways_.try_emplace(seat, std::move(options)).first->second;
}

} // namespace windlass::door
