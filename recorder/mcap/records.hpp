#pragma once
// The records of an MCAP file (mcap.dev/spec, "Records"), as values; times are ns since 1970-01-01 UTC.

#include "recorder/mcap/bytes.hpp"

#include <array>

namespace windlass::mcap {

inline constexpr std::array<std::uint8_t, 8> kMagic{0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};
inline constexpr std::size_t kRecordHead = 9;                  ///< opcode, then the length in 8 bytes
inline constexpr std::size_t kFooterRecord = kRecordHead + 20; ///< the only record of a known length

enum class Opcode : std::uint8_t {
    header = 1,
    footer,
    schema,
    channel,
    message,
    chunk,
    message_index,
    chunk_index,
    attachment,
    attachment_index,
    statistics,
    metadata,
    metadata_index,
    summary_offset,
    data_end
};

using Strings = std::map<std::string, std::string>;

struct Header {
    std::string profile, library;
};
struct Schema {
    std::uint16_t id = 0; ///< never 0
    std::string name, encoding, data;
};
struct Channel {
    std::uint16_t id = 0, schema_id = 0;
    std::string topic, message_encoding;
    Strings metadata;
};
struct Message {
    std::uint16_t channel_id = 0;
    std::uint32_t sequence = 0;
    std::int64_t log_time = 0, publish_time = 0;
    Bytes data;
};
struct Chunk {
    std::int64_t start = 0, end = 0; ///< earliest and latest log_time
    std::uint64_t uncompressed_size = 0;
    std::uint32_t uncompressed_crc = 0; ///< 0: not known
    std::string compression;
    Bytes records;
};
struct MessageIndex {
    std::uint16_t channel_id = 0;
    std::vector<std::pair<std::int64_t, std::uint64_t>> entries; ///< log_time, offset in the chunk's records
};
struct ChunkIndex {
    std::int64_t start = 0, end = 0;
    std::uint64_t offset = 0, length = 0;                         ///< of the chunk record
    std::map<std::uint16_t, std::uint64_t> message_index_offsets; ///< by channel
    std::uint64_t message_index_length = 0;
    std::string compression;
    std::uint64_t compressed_size = 0, uncompressed_size = 0;
};
struct Attachment {
    std::int64_t log_time = 0, create_time = 0;
    std::string name, media_type;
    Bytes data;
};
struct AttachmentIndex {
    std::uint64_t offset = 0, length = 0;
    std::int64_t log_time = 0, create_time = 0;
    std::uint64_t data_size = 0;
    std::string name, media_type;
};
struct Metadata {
    std::string name;
    Strings entries;
};
struct MetadataIndex {
    std::uint64_t offset = 0, length = 0;
    std::string name;
};
struct Statistics {
    std::uint64_t messages = 0;
    std::uint16_t schemas = 0;
    std::uint32_t channels = 0, attachments = 0, metadata = 0, chunks = 0;
    std::int64_t start = 0, end = 0;
    std::map<std::uint16_t, std::uint64_t> channel_messages;
};
struct SummaryOffset {
    Opcode group{};
    std::uint64_t start = 0, length = 0;
};
struct Footer {
    std::uint64_t summary_start = 0, summary_offset_start = 0;
    std::uint32_t summary_crc = 0;
};
struct DataEnd {};

/// CRC-32 as zlib's, which MCAP uses; of bytes after those that gave `before`.
std::uint32_t crc32(Bytes bytes, std::uint32_t before = 0);

/// Appends the whole record, opcode and length included.
void append(Buffer& out, const Header& record);
void append(Buffer& out, const Schema& record);
void append(Buffer& out, const Channel& record);
void append(Buffer& out, const Message& record);
void append(Buffer& out, const Chunk& record);
void append(Buffer& out, const MessageIndex& record);
void append(Buffer& out, const ChunkIndex& record);
void append(Buffer& out, const Attachment& record); ///< with its CRC
void append(Buffer& out, const AttachmentIndex& record);
void append(Buffer& out, const Metadata& record);
void append(Buffer& out, const MetadataIndex& record);
void append(Buffer& out, const Statistics& record);
void append(Buffer& out, const SummaryOffset& record);
void append(Buffer& out, const Footer& record);
void append(Buffer& out, const DataEnd& record);

/// Reads a record's content (behind opcode and length). Spans point into it. Throws Damage.
template <class Record>
Record parse(Bytes content);

} // namespace windlass::mcap
