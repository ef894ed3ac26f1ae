#pragma once
// A station's link to one exercise: hears every topic of the server and gives orders under one name.

#include "idl/wire.hpp"
#include "station/picture.hpp"

#include <functional>
#include <memory>

namespace windlass::station {

/// Keeps the picture up to date from DDS threads; every function may be called from any thread.
class Client {
public:
    /// Joins the exercise. Throws std::runtime_error when DDS cannot start.
    explicit Client(const wire::JoinOptions& session);
    ~Client();
    Client(const Client&) = delete;
    Client& operator=(const Client&) = delete;

    Picture picture() const; ///< copy of the picture as it is now

    /// Waits until the condition holds, looking each time something comes in. False after timeout.
    bool wait(std::chrono::duration<double> timeout,
              const std::function<bool(const Picture&)>& condition) const;

    /// Waits for the next sample of any topic, at most timeout.
    void wait_for_news(std::chrono::duration<double> timeout) const;

    bool server_present() const; ///< a server publishes in this domain and partition

    /// Origin of the next command: this client's name, a serial above all before, the time of sending.
    Origin next_origin();

    const std::string& name() const; ///< under which it gives orders
    wire::Participant& participant();

private:
    struct Link;
    std::unique_ptr<Link> link_;
};

} // namespace windlass::station
