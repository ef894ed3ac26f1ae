#pragma once
// Connections that are no sessions: asking for files, or not yet for anything. Pure.

#include <cstddef>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <string>

namespace windlass::gateway {

/// At most so many at a time. When one more comes, the address that has most of them gives one up: that which
/// has been silent for longest. So one who opens many connections and says nothing shuts nobody out. One
/// thread.
class Lobby {
public:
    /// A connection's place, as long as it lives; the lobby outlives it.
    class Place {
    public:
        ~Place();
        Place(const Place&) = delete;
        Place& operator=(const Place&) = delete;

        /// It has said something: others have been silent for longer.
        void heard();

        /// Who ends the connection from now on.
        void turned_out_by(std::function<void()> turn_out) { turn_out_ = std::move(turn_out); }

    private:
        friend class Lobby;
        Place(Lobby& lobby, std::string address) : lobby_{lobby}, address_{std::move(address)} {}

        Lobby& lobby_;
        const std::string address_;
        std::function<void()> turn_out_;
        std::list<Place*>::iterator at_;
        bool in_ = true;
    };

    explicit Lobby(std::size_t most) : most_{most} {}

    /// A place for a connection from there, whose turned_out_by() is to be said before others enter.
    /// turned_out: the address that had to give one up; empty: none.
    std::unique_ptr<Place> enter(const std::string& address, std::string& turned_out);

    std::size_t size() const { return silent_.size(); }

private:
    void leave(Place& place);
    Place& busiest();

    const std::size_t most_;
    std::list<Place*> silent_;                 // who has been silent for longest comes first
    std::map<std::string, std::size_t> count_; // by address
};

} // namespace windlass::gateway
