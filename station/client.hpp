#pragma once
// A station's link to one exercise: hears what its seat may know, and gives orders under one name.

#include "idl/wire.hpp"
#include "station/picture.hpp"

#include <functional>
#include <memory>

namespace windlass::station {

/// Who sits at the station. It decides which topics are heard, as the roles of config/security/roles.txt do.
enum class Seat {
    forecastle, ///< ForecastleView, ForecastleEvent, BridgeOrder, ForecastleAlert
    conning,    ///< BridgeView, BridgeEvent, BridgeOrder, Report, Alert
    trainee,    ///< one person on both
    watcher,    ///< hears what a trainee does, and gives no orders
    coach,      ///< a trainee's, and the truth: for scripts that look at it
    observer,   ///< the truth, and no orders
    assessor,   ///< the same, and has a word on the marks
    instructor  ///< the truth
};

inline bool on_forecastle(Seat seat) {
    return seat == Seat::forecastle || seat == Seat::trainee || seat == Seat::watcher || seat == Seat::coach;
}
inline bool on_bridge(Seat seat) {
    return seat == Seat::conning || seat == Seat::trainee || seat == Seat::watcher || seat == Seat::coach;
}
inline bool has_truth(Seat seat) {
    return seat == Seat::coach || seat == Seat::observer || seat == Seat::assessor ||
           seat == Seat::instructor;
}

/// Keeps the picture up to date from DDS threads; every function may be called from any thread.
class Client {
public:
    /// Joins the exercise. Throws std::runtime_error when DDS cannot start, or permissions forbid a topic of
    /// the seat.
    Client(const wire::JoinOptions& session, Seat seat);
    ~Client();
    Client(const Client&) = delete;
    Client& operator=(const Client&) = delete;

    Picture picture() const; ///< copy of the picture as it is now

    /// Waits until the condition holds, looking each time something comes in. False after timeout.
    bool wait(std::chrono::duration<double> timeout,
              const std::function<bool(const Picture&)>& condition) const;

    /// Waits for the next sample of any topic, at most timeout.
    void wait_for_news(std::chrono::duration<double> timeout) const;

    /// Waits until the exercise's status is heard; with the truth, and where the seat has it, for that too.
    /// Ends early where only members of another version of the wire are: none of them will ever be heard.
    /// False when no status came.
    bool meet_server(std::chrono::duration<double> timeout) const;

    bool server_present() const; ///< a server publishes in this domain and partition

    /// The server whose status was heard last also hears this writer (wire::Writer or RawWriter). An order
    /// written before is lost, whoever else hears it.
    template <class Writer>
    bool server_hears(const Writer& writer) const {
        const auto server = status_writer();
        return server && writer.heard_by(*server);
    }

    /// What was said of a member of another version of the wire, as a line for people; nothing: none was met.
    std::optional<std::string> other_version() const;

    /// Origin of the next command: this client's name, a serial above all before, the time of sending.
    Origin next_origin();

    const std::string& name() const; ///< under which it gives orders
    Seat seat() const;
    wire::Participant& participant();

private:
    std::optional<wire::WriterId> status_writer() const;

    struct Link;
    std::unique_ptr<Link> link_;
};

} // namespace windlass::station
