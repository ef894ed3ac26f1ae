#pragma once
// What the network asks of whoever has the pages.

#include "station/gateway/history.hpp"
#include "station/gateway/request.hpp"

namespace windlass::gateway {

/// Everything but log() on the network's thread.
class Host {
public:
    using Reply = std::function<void(Verdict)>;

    virtual ~Host() = default;

    /// Replies once, at once or later, on the network's thread.
    virtual void judge(const Request& request, Reply reply) = 0;

    /// 20 times a second.
    virtual void tick(Clock::time_point now) = 0;

    /// A line for whoever runs the program. From any thread.
    virtual void log(const std::string& line) = 0;
};

/// How much of the network is taken at a time.
struct Limits {
    std::size_t sessions = 16;         ///< pages and foreign clients
    std::size_t connections = 256;     ///< asking for files, or not yet for anything
    std::size_t message = 16UL * 1024; ///< bytes of a page's message
    std::size_t body = 0;              ///< bytes of a request's body; 0: none is read
};

} // namespace windlass::gateway
