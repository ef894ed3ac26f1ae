#pragma once
// A recording: one or more MCAP files of one exercise, read as one. Messages come by time and topic.

#include "recorder/mcap/reader.hpp"

#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>

namespace windlass::recording {

using mcap::Bytes;
using Nanoseconds = std::int64_t; ///< since 1970-01-01 UTC, or between two such times

/// One message. Views are good until the next call of the cursor that gave it.
struct Message {
    const mcap::Channel* channel = nullptr;
    std::uint32_t sequence = 0;                 ///< of its writer; see Channel "writer"
    Nanoseconds log_time = 0, publish_time = 0; ///< on the recorder's clock
    Bytes payload;                              ///< CDR header and CDR, as it travelled

    const std::string& topic() const { return channel->topic; }
};

/// A message that is kept.
struct KeptMessage {
    std::string topic;
    std::uint32_t sequence = 0;
    Nanoseconds log_time = 0, publish_time = 0;
    mcap::Buffer payload;

    explicit KeptMessage(const Message& message);
    KeptMessage() = default;
};

/// Which messages: those of the topics (none named: of all) with from <= log_time < until.
struct Query {
    std::set<std::string> topics{};
    Nanoseconds from = std::numeric_limits<Nanoseconds>::min();
    Nanoseconds until = std::numeric_limits<Nanoseconds>::max();
};

class Recording;

/// Walks through the messages of a query in the order of log_time.
class Cursor {
public:
    /// The next message, or nothing at the end. A damaged chunk is told in Recording::damage and left out.
    std::optional<Message> next();

private:
    friend class Recording;
    Cursor(Recording& recording, Query query);
    bool open_next_chunk();

    struct Entry {
        Nanoseconds log_time;
        mcap::Bytes content;
    };
    Recording* recording_;
    Query query_;
    std::size_t next_chunk_ = 0;
    mcap::Buffer records_;
    std::vector<Entry> entries_;
    std::size_t next_entry_ = 0;
    std::size_t file_ = 0;
};

/// The recording is of another version of the wire: its payloads are not what our types say, though their
/// names may be alike. what() is a sentence that names both versions.
struct VersionError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

class Recording {
public:
    /// Each path is an MCAP file, or a folder whose *.mcap are all taken; in the order of their times. Throws
    /// std::runtime_error (a file that cannot be read or is no MCAP file, none at all, of two recordings) and
    /// VersionError.
    explicit Recording(const std::vector<std::filesystem::path>& paths);

    /// By default every message.
    Cursor messages(Query query = {});

    /// The last message of the topic with log_time <= time: the checkpoint to go back to, say.
    std::optional<KeptMessage> last_before(const std::string& topic, Nanoseconds time);

    const std::string& name() const { return name_; } ///< of the folder or the first file
    Nanoseconds start() const { return start_; }      ///< log_time of the first message; 0: there is none
    Nanoseconds end() const { return end_; }          ///< log_time of the last message
    double seconds() const { return static_cast<double>(end_ - start_) * 1e-9; }

    const std::vector<std::unique_ptr<mcap::Reader>>& files() const { return files_; }
    std::size_t chunks() const { return chunks_.size(); }

    /// What is wrong: one line a file or chunk. Chunks are found out when they are read.
    const std::vector<std::string>& damage() const { return damage_; }

    /// The IDL that the topic was recorded with, and the name of its type in it; empty when not known.
    struct TypeText {
        std::string type, idl;
    };
    TypeText type_of(const mcap::Channel& channel) const;

private:
    friend class Cursor;
    struct ChunkOf {
        std::size_t file;
        mcap::ChunkIndex index;
    };
    bool concerns(const ChunkOf& chunk, const Query& query) const;
    void tell(std::string damage);

    std::string name_;
    std::vector<std::unique_ptr<mcap::Reader>> files_;
    std::vector<ChunkOf> chunks_; // by time
    std::vector<std::string> damage_;
    Nanoseconds start_ = 0, end_ = 0;
};

} // namespace windlass::recording
