#pragma once
// The stations behind the door: a gateway for each role, all of one member of the domain.

#include "door/class_book.hpp"
#include "door/people.hpp"
#include "station/gateway/gateway.hpp"
#include "station/gateway/page_session.hpp"

namespace windlass::door {

/// The role of somebody who sits there, and of staff.
station::Seat seat_at(Place place);
station::Seat seat_of(Rank rank);

/// One thread.
class Stations {
public:
    /// instructor: the instructors' gateway's options; the others are made of its member. Joins the domain.
    /// Throws std::runtime_error.
    explicit Stations(gateway::GatewayOptions instructor);

    gateway::Gateway& instructor() { return of(station::Seat::instructor); }
    const gateway::SharedReaders& readers() const { return readers_; }

    /// A session of that role in that exercise, under somebody's name. Throws std::runtime_error.
    std::shared_ptr<gateway::PageSession> open(station::Seat seat, const std::string& exercise,
                                               const std::string& name, gateway::Transport& transport) {
        return of(seat).open_page(exercise, transport, name);
    }

    void tick(gateway::Clock::time_point now) {
        for (auto& [seat, each] : gateways_)
            each.tick(now);
    }

private:
    gateway::Gateway& of(station::Seat seat);

    gateway::SharedReaders readers_;
    gateway::GatewayOptions others_;
    std::map<station::Seat, gateway::Gateway> gateways_; // each once somebody needs it
};

} // namespace windlass::door
