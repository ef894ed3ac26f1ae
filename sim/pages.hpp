#pragma once
// Pages of an exercise, in a share of the seeds: a watcher's and an observer's, and now and then one whose
// hand works the port levers through its station's program. They read, or are slow, or do not; they flood,
// send what is no message, are loaded anew; and their programs are killed and started again.

#include "server/run/session.hpp"
#include "sim/centre.hpp"
#include "sim/network.hpp"

#include <memory>

namespace windlass::sim {

class Pages {
public:
    /// Draws from a chance of its own: who works in a seed without a page's hand is not disturbed by pages.
    Pages(World& world, Network& network, std::uint64_t seed, Sabotage sabotage);
    ~Pages();
    Pages(const Pages&) = delete;
    Pages& operator=(const Pages&) = delete;

    /// What the server of that number tells of a tick, before its news are cleared.
    void tell(const run::Session& session, std::uint64_t server);
    /// All who still read are to have what their programs heard.
    void end();

    std::uint64_t opened() const;    ///< connections
    std::uint64_t sent_away() const; ///< of them, by the gateway
    std::uint64_t killed() const;    ///< programs
    std::uint64_t taken() const;     ///< that a page was told that another station has its levers
    std::uint64_t digest() const;    ///< of all that pages were sent; 0: there were none

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace windlass::sim
