#pragma once
// The instructor's orders to the servers of a domain: which exercises there shall be.

#include "instructor_console/ask.hpp"

#include <vector>

namespace windlass::console {

/// What is to be opened, and where.
struct NewExercise {
    std::string id;
    std::string file;       ///< in the server's exercise folder; empty: definition
    std::string definition; ///< JSON text
    std::string server;     ///< name; empty: the only one there is
    bool wait = false;      ///< begin ready
    bool practice = false;  ///< its lesson is played for practice, with hints
};

/// Servers and their exercises, by name. session: domain, name and identity; its partition does not matter.
/// Waits at most timeout s for the first server. Throws std::runtime_error when DDS cannot start.
std::vector<ClassroomStatus> hear_servers(const wire::JoinOptions& session, double timeout);

/// Gives the order and waits at most timeout s until it shows or is refused. Throws as above. The answer's
/// picture stays empty.
Answer create_exercise(const wire::JoinOptions& session, const NewExercise& wanted, double timeout);

/// The same; server may be empty: the one that has it.
Answer remove_exercise(const wire::JoinOptions& session, const std::string& id, const std::string& server,
                       double timeout);

/// Servers and exercises in some lines for people.
std::string classroom_text(const std::vector<ClassroomStatus>& servers);

} // namespace windlass::console
