#pragma once
// What the network makes of what is sent: late, in bursts, from several writers in any order; a bad one also
// loses, doubles and reorders what one writer sends. Of those who work the same levers DDS lets the strongest
// be heard that still speaks.

#include "server/dds/mailbox.hpp"
#include "sim/world.hpp"

#include <set>

namespace windlass::sim {

/// A sample on its way, and what its hand knows of itself.
struct Sent {
    dds::Mailbox::Sample sample;
    wire::WriterId writer{};
    bool instructor = false;
    std::uint64_t moved_in_run = 0;
    int strength = 10;
    double at = 0;                    ///< s, when it was sent
    std::array<double, 5> moved_at{}; ///< s, when the hand last moved each of its levers
};

class Network {
public:
    explicit Network(World& world);

    void send(Sent sent);
    /// A strength above all that has been spoken with on the instructors' topic of these levers, for one who
    /// takes them over.
    int outrank(int levers);
    /// That writer is there no more, which is told behind what it sent.
    void leave(const wire::WriterId& writer);
    /// The program of that writer is held up until then (s): missed after DDS's lease, and there again.
    void hold_up(const wire::WriterId& writer, double until);

    using Heard = std::function<void(const Sent&)>;
    using Met = std::function<void(const wire::WriterId&, bool there)>;
    /// A server listens from now on. What was sent before is lost, as DDS keeps no orders for those who come.
    void serve(Heard heard, Met met);
    /// There is none.
    void serve_nobody() { heard_ = nullptr, met_ = nullptr; }
    /// Each word that counts on levers is told as it comes, as every station hears them.
    void overhear(Heard overheard) { overheard_ = std::move(overheard); }

private:
    double arrival(const wire::WriterId& writer);
    void arrive(const Sent& sent);
    void miss(const wire::WriterId& writer);

    struct Owner {
        wire::WriterId writer{};
        int strength = 0;
        double heard = -10; // s
    };

    World& world_;
    const bool bad_;
    Heard heard_, overheard_;
    Met met_;
    double served_since_ = 0, congested_until_ = 0; // s
    std::map<wire::WriterId, double> last_;         // arrival of each writer's last sample
    std::map<std::pair<int, bool>, Owner> owners_;
    std::map<int, int> strongest_; // instructor, by levers
};

} // namespace windlass::sim
