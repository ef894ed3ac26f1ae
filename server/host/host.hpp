#pragma once
// Many exercises in one process.

#include "server/host/host_threads.hpp"
#include "server/host/hosted_exercise.hpp"

#include <map>
#include <memory>

namespace windlass::host {

/// Owns the exercises, which threads tick that may be shared with other hosts. All methods are for one
/// thread, which is not of these: opening and closing take their time, and no exercise waits for that.
class Host {
public:
    /// As many as the wire's list of a server's exercises holds.
    static constexpr std::size_t kMaxExercises = 64;

    /// member: of the DDS domain, in whatever partition.
    Host(const wire::Participant& member, HostThreads& threads) : member_(member), threads_(threads) {}
    ~Host() { close_all("closed"); }
    Host(const Host&) = delete;
    Host& operator=(const Host&) = delete;

    /// Opens partition exercise/ID and lets the exercise go. Throws std::invalid_argument when the id is in
    /// use here, when there are too many, or when the exercise cannot be set up from its definition;
    /// std::runtime_error when there is no DDS.
    void open(const std::string& id, const exercise::ExerciseDef& def, run::SessionOptions options);
    /// Ends an exercise for that reason and leaves its partition. False: there is none of that id.
    bool close(const std::string& id, const std::string& reason);
    void close_all(const std::string& reason);
    /// Leaves them as a server does that is lost, but with all of them that is to be kept on disk: nobody is
    /// told that they have ended.
    void leave_all();

    std::size_t size() const { return exercises_.size(); }
    bool has(const std::string& id) const { return exercises_.contains(id); }
    std::vector<HostedStatus> status() const; ///< of every exercise, by id
    bool all_ended() const;                   ///< each has run its set duration; false when there is none
    bool any_stopped_by_fault() const;
    /// Threads' time that exercises take, by their last second. One that is hurried counts as in real time:
    /// it gives way.
    double load() const;
    /// Of the beats that threads are at, how long the longest lasts already.
    std::chrono::steady_clock::duration longest_beat() const;

private:
    wire::Participant member_;
    HostThreads& threads_;
    std::map<std::string, std::unique_ptr<HostedExercise>> exercises_;
};

} // namespace windlass::host
