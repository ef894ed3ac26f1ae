#include "recorder/mcap/reader.hpp"

#include "recorder/mcap/compression.hpp"

#include <algorithm>

namespace windlass::mcap {

namespace {

// No chunk of ours is a tenth as large. A length that a damaged file makes up must not take all memory.
constexpr std::uint64_t kLargestChunk = 256 << 20;

std::string at_byte(std::uint64_t offset) {
    return "at byte " + std::to_string(offset) + ": ";
}

} // namespace

Reader::Reader(const std::filesystem::path& path) : file_(path) {
    if (file_.size() < kMagic.size() || !std::ranges::equal(file_.read(0, kMagic.size()), kMagic))
        throw Damage(path.string() + ": is no MCAP file (it does not begin like one)");
    if (read_summary()) return;
    if (damage_.empty()) damage_ = "its summary is missing; ";
    scan();
}

void Reader::file_definition(Opcode opcode, Bytes content) {
    if (opcode == Opcode::schema) {
        auto schema = parse<Schema>(content);
        schemas_.emplace(schema.id, std::move(schema));
    } else if (opcode == Opcode::channel) {
        auto channel = parse<Channel>(content);
        channels_.emplace(channel.id, std::move(channel));
    }
}

/// False, with nothing filed, when there is no summary that can be trusted.
bool Reader::read_summary() {
    constexpr std::size_t kTail = kFooterRecord + kMagic.size();
    if (file_.size() < kMagic.size() + kTail) return false;
    const Bytes tail = file_.read(file_.size() - kTail, kTail);
    if (!std::ranges::equal(tail.subspan(kFooterRecord), kMagic) ||
        static_cast<Opcode>(tail[0]) != Opcode::footer)
        return false;
    const auto footer = parse<Footer>(tail.subspan(kRecordHead));
    const std::uint64_t end = file_.size() - kTail;
    if (footer.summary_start < kMagic.size() || footer.summary_start > end) return false;
    const Bytes summary = file_.read(footer.summary_start, file_.size() - footer.summary_start);
    constexpr std::size_t kCrcAndMagic = sizeof footer.summary_crc + kMagic.size();
    if (footer.summary_crc != 0 &&
        footer.summary_crc != crc32(summary.first(summary.size() - kCrcAndMagic))) {
        damage_ = "its summary is damaged; ";
        return false;
    }
    std::vector<MetadataIndex> metadata;
    try {
        for_each_record(summary.first(summary.size() - kTail), [&](Opcode opcode, Bytes content) {
            file_definition(opcode, content);
            if (opcode == Opcode::chunk_index) chunks_.push_back(parse<ChunkIndex>(content));
            if (opcode == Opcode::attachment_index) attachments_.push_back(parse<AttachmentIndex>(content));
            if (opcode == Opcode::metadata_index) metadata.push_back(parse<MetadataIndex>(content));
        });
        for (const auto& one : metadata)
            metadata_.push_back(parse<Metadata>(content_of(one.offset, one.length, Opcode::metadata)));
    } catch (const Damage&) { // a summary without checksum, or metadata that is not where it should be
        schemas_.clear();
        channels_.clear();
        chunks_.clear();
        attachments_.clear();
        metadata_.clear();
        damage_ = "its summary is damaged; ";
        return false;
    }
    return true;
}

void Reader::scan() {
    std::uint64_t offset = kMagic.size();
    std::string stopped;
    bool at_end = false;
    while (!at_end && stopped.empty()) {
        try {
            if (file_.size() - offset < kRecordHead) break;
            Decoder head(file_.read(offset, kRecordHead));
            const auto opcode = static_cast<Opcode>(head.get<std::uint8_t>());
            const auto length = head.get<std::uint64_t>();
            if (opcode < Opcode::header || opcode > Opcode::data_end) {
                stopped = at_byte(offset) + "there is no record";
            } else if (length > file_.size() - offset - kRecordHead) {
                stopped = at_byte(offset) + "the file ends in the middle of a record";
            } else {
                at_end = !scan_record(opcode, offset, length);
                offset += kRecordHead + length;
            }
        } catch (const Damage& damage) {
            stopped = at_byte(offset) + damage.what();
        }
    }
    if (stopped.empty() && !at_end) stopped = at_byte(offset) + "the file ends";
    if (!at_end) {
        damage_ = "it was not closed: " + stopped + ", " + std::to_string(file_.size() - offset) +
                  " bytes are left out";
    } else {
        damage_ += "everything before it was found";
    }
}

/// False: the data section is over.
bool Reader::scan_record(Opcode opcode, std::uint64_t offset, std::uint64_t length) {
    const std::uint64_t content = offset + kRecordHead;
    switch (opcode) {
    case Opcode::schema:
    case Opcode::channel:
        file_definition(opcode, file_.read(content, length));
        break;
    case Opcode::metadata:
        metadata_.push_back(parse<Metadata>(file_.read(content, length)));
        break;
    case Opcode::attachment: {
        const auto found = parse<Attachment>(file_.read(content, length));
        attachments_.push_back({offset, kRecordHead + length, found.log_time, found.create_time,
                                found.data.size(), found.name, found.media_type});
        break;
    }
    case Opcode::chunk:
        scan_chunk(offset, length);
        break;
    case Opcode::message_index:
        if (!chunks_.empty()) {
            const auto id = Decoder(file_.read(content, length)).get<std::uint16_t>();
            chunks_.back().message_index_offsets[id] = offset;
            chunks_.back().message_index_length += kRecordHead + length;
        }
        break;
    case Opcode::data_end:
    case Opcode::footer:
        return false;
    default:
        break;
    }
    return true;
}

/// Files a chunk by its first fields, unopened.
void Reader::scan_chunk(std::uint64_t offset, std::uint64_t length) {
    constexpr std::uint64_t kFields = 64; // times, sizes, CRC and the name of a compression
    Decoder in(file_.read(offset + kRecordHead, std::min(length, kFields)));
    ChunkIndex chunk;
    chunk.start = in.get<std::int64_t>();
    chunk.end = in.get<std::int64_t>();
    chunk.uncompressed_size = in.get<std::uint64_t>();
    in.get<std::uint32_t>();
    chunk.compression = in.text();
    chunk.compressed_size = in.get<std::uint64_t>();
    chunk.offset = offset;
    chunk.length = kRecordHead + length;
    chunks_.push_back(std::move(chunk));
}

Bytes Reader::content_of(std::uint64_t offset, std::uint64_t length, Opcode expected) {
    const Bytes record = file_.read(offset, length);
    Decoder in(record);
    if (static_cast<Opcode>(in.get<std::uint8_t>()) != expected)
        throw Damage(at_byte(offset) + "there is another record than the index says");
    return in.bytes<std::uint64_t>();
}

Bytes Reader::records(const ChunkIndex& index) {
    try {
        const auto chunk = parse<Chunk>(content_of(index.offset, index.length, Opcode::chunk));
        if (chunk.uncompressed_size > kLargestChunk) throw Damage("it says that it is larger than any is");
        decompress(chunk.compression, chunk.records, chunk.uncompressed_size, records_);
        if (chunk.uncompressed_crc != 0 && chunk.uncompressed_crc != crc32(records_))
            throw Damage("its checksum does not fit");
        // Other writers define their channels inside chunks.
        for_each_record(records_, [this](Opcode opcode, Bytes content) { file_definition(opcode, content); });
        return records_;
    } catch (const Damage& damage) {
        throw Damage("chunk " + at_byte(index.offset) + damage.what());
    }
}

std::string Reader::content(const AttachmentIndex& index) {
    return std::string(
        as_text(parse<Attachment>(content_of(index.offset, index.length, Opcode::attachment)).data));
}

} // namespace windlass::mcap
