#pragma once
// The other servers of the domain.

#include "idl/wire.hpp"

#include <map>
#include <mutex>
#include <optional>
#include <string>

namespace windlass::host {

/// Hears what other servers say of themselves. Who has been silent for 3 s is gone, and his exercises with
/// him.
class Neighbours {
public:
    /// own: the writer whose samples are this server's. Throws std::runtime_error.
    Neighbours(wire::Participant& member, const wire::WriterId& own);

    std::size_t count() const;

    /// Returns when every other server that is connected has told of itself. Whoever is not connected within
    /// some tenths of a second, or says nothing for a second, is not waited for.
    void meet() const;

    /// A server of that name is there.
    bool has_namesake(const std::string& name) const;
    /// One is there that has had an exercise for longer than the server whose status this is; of two that
    /// have had none, it is one of the two.
    bool has_elder_namesake(const ClassroomStatus& own) const;

    /// The server that has an exercise of that name; empty: none is known.
    std::string server_of(const std::string& id) const;

    /// The server that has opened an exercise of that name before us; empty: none is known. Two servers never
    /// both have to give way: of two that were opened in the same instant, the one of the server whose name
    /// comes first in the alphabet stays.
    std::string earlier(const std::string& id, std::int64_t since_unix_ns, const std::string& server) const;

private:
    struct Heard {
        ClassroomStatus status;
        std::chrono::steady_clock::time_point at;
    };
    template <class Condition>
    bool any(Condition condition) const;
    template <class Condition>
    std::string find(const std::string& id, Condition condition) const;
    void hear(const ClassroomStatus& status, const wire::WriterId& writer);

    const wire::WriterId own_;
    mutable std::mutex mutex_;
    std::map<wire::WriterId, Heard> heard_; // guarded by mutex_
    wire::Reader<ClassroomStatus> reader_;  // last: its callback uses the above
};

} // namespace windlass::host
