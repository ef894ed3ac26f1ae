#pragma once
// A replay's place in DDS: writes the server's topics into a partition where no server is, and hears what
// the replay is asked to do.

#include "idl/raw.hpp"

#include <chrono>
#include <map>
#include <mutex>
#include <set>
#include <vector>

namespace windlass::recorder {

class ReplayWriter {
public:
    /// Joins and listens; writes nothing yet. Throws std::runtime_error when DDS does not start.
    explicit ReplayWriter(const wire::JoinOptions& session);

    /// Somebody else writes ExerciseStatus in this domain and partition: a live server, or another replay.
    bool taken_by_another() const;

    /// Gets ready to write the topics. Throws std::logic_error for one that a server does not write: a
    /// command.
    void open(const std::set<std::string>& topics);

    /// Payload as it is. False when the topic is not open or the payload is not of its type.
    bool write(const std::string& topic, wire::Bytes payload);
    void write(const ReplayStatus& status);

    /// Waits until all who listen have what must not be lost (events and the like), or the timeout is over.
    void flush(std::chrono::milliseconds timeout);

    /// What has been asked since the last call, and by whom.
    std::vector<std::pair<ReplayCommand, wire::WriterId>> take_commands();

private:
    wire::Participant participant_;
    wire::RawReader statuses_;
    std::map<std::string, wire::RawWriter> writers_;
    wire::Writer<ReplayStatus> replay_status_;
    std::mutex mutex_;
    std::vector<std::pair<ReplayCommand, wire::WriterId>> commands_;
    wire::Reader<ReplayCommand> reader_; // last: its callback uses what is above
};

} // namespace windlass::recorder
