#include "station/gateway/lobby.hpp"

#include <algorithm>
#include <utility>

namespace windlass::gateway {

Lobby::Place::~Place() {
    lobby_.leave(*this);
}

void Lobby::Place::heard() {
    if (in_) lobby_.silent_.splice(lobby_.silent_.end(), lobby_.silent_, at_);
}

std::unique_ptr<Lobby::Place> Lobby::enter(const std::string& address, std::string& turned_out) {
    turned_out.clear();
    std::unique_ptr<Place> place(new Place(*this, address));
    place->at_ = silent_.insert(silent_.end(), place.get());
    ++count_[address];
    if (silent_.size() <= most_) return place;
    Place& out = busiest();
    turned_out = out.address_;
    leave(out);
    if (const auto turn_out = std::exchange(out.turn_out_, {})) turn_out(); // which may end its life
    return place;
}

/// Of the address that has most; of several, that which has been silent for longest.
Lobby::Place& Lobby::busiest() {
    std::size_t most = 0;
    for (const auto& [address, count] : count_)
        most = std::max(most, count);
    return **std::ranges::find_if(silent_,
                                  [&](const Place* place) { return count_.at(place->address_) == most; });
}

void Lobby::leave(Place& place) {
    if (!std::exchange(place.in_, false)) return;
    silent_.erase(place.at_);
    const auto of_address = count_.find(place.address_);
    if (--of_address->second == 0) count_.erase(of_address);
}

} // namespace windlass::gateway
