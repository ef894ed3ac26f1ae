#pragma once
// Writes one MCAP file: chunks with their message indexes, and at the end a summary.
//
// It is our own, and not foxglove/mcap's C++ writer, for what a recording of an exercise is worth. A full
// disk is an everyday thing: that writer's FileWriter only asserts that a write was whole, and it aborts
// where zstd fails; here a refused write is cut off again and told, and the file stays readable. The reader
// beside it takes a damaged file up to its last whole chunk. Nor has Debian a package of that library.

#include "recorder/mcap/compression.hpp"
#include "recorder/mcap/file.hpp"
#include "recorder/mcap/records.hpp"

namespace windlass::mcap {

struct WriterOptions {
    Compression compression = Compression::zstd;
    std::size_t chunk_size = 1 << 20; ///< bytes before compression, at which a chunk is written
    std::string library;              ///< who wrote the file
};

/// After every call the file on disk ends behind a whole record (but for a kill in the middle of a write):
/// when the system refuses a write, the part that was written is cut off again, WriteError is thrown, and
/// the writer can still be closed. Messages of a chunk that could not be written are lost; lost() counts.
class Writer {
public:
    Writer(const std::filesystem::path& path, WriterOptions options,
           files::Disk& disk = files::system_disk());

    /// Ids count up from 1 and are good in this file only.
    std::uint16_t add_schema(std::string name, std::string encoding, std::string data);
    std::uint16_t add_channel(std::uint16_t schema, std::string topic, std::string message_encoding,
                              Strings metadata);
    void add_attachment(const Attachment& attachment);
    void add_metadata(const Metadata& metadata);

    /// Into the open chunk; channel_id must be of add_channel. Written when the chunk is full.
    void write(const Message& message);
    /// Writes the open chunk, if there is anything in it.
    void flush();
    /// Writes what is open, the summary and the footer; nothing may be written after it.
    void close();

    std::uint64_t size() const {
        return file_.size() + chunk_.size();
    } ///< bytes, the open chunk uncompressed
    std::uint64_t lost() const { return lost_; }
    std::size_t chunks() const { return chunk_index_.size(); }
    const std::filesystem::path& path() const { return file_.path(); }

private:
    void put(const Buffer& whole_records);
    Buffer summary() const;

    OutFile file_;
    WriterOptions options_;
    Buffer chunk_, compressed_, out_; // reused
    ChunkIndex open_;
    std::map<std::uint16_t, MessageIndex> open_index_;
    std::uint64_t open_messages_ = 0;
    std::uint64_t lost_ = 0;

    std::vector<Schema> schemas_;
    std::vector<Channel> channels_;
    std::vector<ChunkIndex> chunk_index_;
    std::vector<AttachmentIndex> attachment_index_;
    std::vector<MetadataIndex> metadata_index_;
    Statistics statistics_;
};

} // namespace windlass::mcap
