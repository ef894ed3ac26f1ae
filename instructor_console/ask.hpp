#pragma once
// Gives one order and waits for the server's answer.

#include "instructor_console/orders.hpp"
#include "station/client.hpp"

namespace windlass::console {

struct Answer {
    enum class Kind { carried_out, refused, none, no_server } kind = Kind::none;
    std::string text; ///< for people
    station::Picture picture;
};

/// Sends the order and waits at most timeout seconds until it shows in the picture or is refused.
template <class Sample>
Answer ask(station::Client& client, const wire::Topic<Sample>& topic, const ServerOrder<Sample>& order,
           double timeout);

} // namespace windlass::console
