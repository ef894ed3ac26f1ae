#pragma once
// What is left behind when an exercise had to be stopped: the last good state and the last commands, so
// that the cause can be found.

#include "server/exercise/picture/snapshot.hpp"
#include "server/run/received_order.hpp"

#include <cstdint>
#include <deque>
#include <filesystem>
#include <string>

namespace windlass::run {

/// The last commands that went into the exercise, each with its tick.
class CommandHistory {
public:
    void add(std::uint64_t tick, const exercise::Order& command);
    void clear() { entries_.clear(); }

    struct Entry {
        std::uint64_t tick;
        exercise::Order command;
    };
    const std::deque<Entry>& entries() const { return entries_; }

private:
    std::deque<Entry> entries_; // bounded
};

/// Writes `windlass-fault-EXERCISE-TICK.json` into the folder and returns its path. Throws
/// std::runtime_error naming the file when it cannot be written.
std::filesystem::path write_fault_dump(const std::filesystem::path& folder, const std::string& exercise,
                                       const exercise::Snapshot& last_good, const CommandHistory& history);

} // namespace windlass::run
