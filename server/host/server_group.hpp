#pragma once
// One process as one server of the classroom, or as several.

#include "server/host/classroom.hpp"

#include <memory>
#include <vector>

namespace windlass::host {

/// A server's list of exercises has 64 places on the wire. A process that is to have more is several servers,
/// NAME, NAME.2 and so on, on the same threads: the next one appears when the last one is full. To clients
/// they are servers like any others. Each is a participant of its own, since Fast DDS compares every writer
/// of a participant with every reader of it, and copies its announcement each time. All methods are for one
/// thread, which is not of the pool.
class ServerGroup {
public:
    static constexpr std::size_t kMaxServers = 7;
    /// What a process takes; 400 were opened and heard of. What a core carries: bench/README.md.
    static constexpr std::size_t kMaxExercises = kMaxServers * Host::kMaxExercises;

    /// Joins the DDS domain, in partition "classroom", as a member that does not look for others of this
    /// process.
    using Join = std::function<wire::Participant()>;

    /// threads: that tick, at least one. keeper: has the exercises on disk; none: they are not kept. Throws
    /// std::runtime_error.
    ServerGroup(Join join, std::string name, unsigned threads, ExerciseSource source,
                keep::Keeper* keeper = nullptr);
    ~ServerGroup();
    ServerGroup(const ServerGroup&) = delete;
    ServerGroup& operator=(const ServerGroup&) = delete;

    /// Opens an exercise on the first server that has room. Throws as Host::open, and std::invalid_argument
    /// when there is room on none.
    void open(const std::string& id, const exercise::ExerciseDef& def, run::SessionOptions options);
    /// The server outside this process that has an exercise of that name already; empty: none is known.
    std::string server_of(const std::string& id) const;

    /// Carries out what was ordered and tells how things stand, as Classroom::serve(); adds a server when all
    /// are full.
    void serve();
    /// Of our names, the one that another server has or had first; empty: none.
    std::string name_taken() const;
    /// An exercise was closed because another server had one of its name, and none is left.
    bool gave_all_way() const;

    bool all_ended() const; ///< each exercise has run its set duration; false when there is none
    bool any_stopped_by_fault() const;
    /// As Host::longest_beat(): of one that never ends, a thread hangs.
    std::chrono::steady_clock::duration longest_beat() const;
    void close_all(const std::string& reason);
    /// As Host::leave_all().
    void leave_all();

    /// How late ticks began since this was last asked.
    Timekeeping::Figures timekeeping() { return threads_.timekeeping.collect(); }

private:
    struct Server;
    bool full() const;
    double load() const;
    void add_server();

    const Join join_;
    wire::Participant classroom_; // of all; and of the first server's exercises
    const std::string name_;
    const unsigned ticking_;
    const ExerciseSource source_;
    HostThreads threads_;
    std::vector<std::unique_ptr<Server>> servers_; // go first
};

} // namespace windlass::host
