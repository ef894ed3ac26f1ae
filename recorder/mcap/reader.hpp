#pragma once
// Reads one MCAP file: by its summary when it was closed in order, otherwise by going through its records
// up to where they stop making sense.

#include "recorder/mcap/file.hpp"
#include "recorder/mcap/records.hpp"

namespace windlass::mcap {

class Reader {
public:
    /// Throws std::runtime_error when the file cannot be opened, Damage when it is no MCAP file.
    explicit Reader(const std::filesystem::path& path);

    /// Empty when the file was closed in order; otherwise what is wrong with it, and what is left out.
    const std::string& damage() const { return damage_; }

    const std::map<std::uint16_t, Schema>& schemas() const { return schemas_; }
    const std::map<std::uint16_t, Channel>& channels() const { return channels_; }
    const std::vector<ChunkIndex>& chunks() const { return chunks_; } ///< in the order of the file
    const std::vector<AttachmentIndex>& attachments() const { return attachments_; }
    const std::vector<Metadata>& metadata() const { return metadata_; }
    const std::filesystem::path& path() const { return file_.path(); }
    std::uint64_t size() const { return file_.size(); }

    /// The records of a chunk, in a buffer that the next call uses again. Throws Damage.
    Bytes records(const ChunkIndex& chunk);

    /// Content of an attachment. Throws Damage.
    std::string content(const AttachmentIndex& attachment);

private:
    bool read_summary();
    void scan();
    bool scan_record(Opcode opcode, std::uint64_t offset, std::uint64_t length);
    void scan_chunk(std::uint64_t offset, std::uint64_t length);
    void file_definition(Opcode opcode, Bytes content);
    Bytes content_of(std::uint64_t offset, std::uint64_t length, Opcode expected);

    InFile file_;
    std::string damage_;
    std::map<std::uint16_t, Schema> schemas_;
    std::map<std::uint16_t, Channel> channels_;
    std::vector<ChunkIndex> chunks_;
    std::vector<AttachmentIndex> attachments_;
    std::vector<Metadata> metadata_;
    Buffer records_;
};

/// Calls take(opcode, content) for each record. Throws Damage where one ends too early.
template <class Take>
void for_each_record(Bytes records, Take take) {
    for (Decoder in(records); !in.empty();) {
        const auto opcode = static_cast<Opcode>(in.get<std::uint8_t>());
        take(opcode, in.bytes<std::uint64_t>());
    }
}

} // namespace windlass::mcap
