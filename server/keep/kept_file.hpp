#pragma once
// The file in which an exercise is kept: records, one behind the other, of which what was being written when
// the power went is told from what is damaged.
//
// Layout, little-endian: "WLKEPT", u16 kKeptFormat, then records: u32 length of the payload, u32 CRC-32 of
// kind and payload, u8 kind, payload. Payloads are the wire's (CDR) and are opened by who keeps and takes up;
// here only `synced` is looked into: u64, up to which byte the file is known to be on the disk.

#include "common/disk.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace windlass::keep {

inline constexpr std::uint16_t kKeptFormat = 2;

/// Begins with the file, and says what is wrong with it.
struct KeptError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

enum class Record : std::uint8_t {
    beginning = 1, ///< Beginning (beginning.hpp)
    checkpoint,    ///< Checkpoint
    order,         ///< OrderTaken
    reached,       ///< Checkpoint without data: how far the exercise has come
    status,        ///< ExerciseStatus, at first and when state or time scale has changed
    synced         ///< everything up to that byte is on the disk
};

/// Writes such a file. One thread at a time; sync() may run beside the rest on another.
class KeptWriter {
public:
    /// Makes the file, which must not be there. Throws KeptError.
    explicit KeptWriter(std::filesystem::path path, files::Disk& disk = files::system_disk());

    /// Puts a record behind those that wait.
    void add(Record kind, files::Bytes payload);
    /// Hands what waits to the system, whole or not at all: what was written in part is cut off. Throws
    /// KeptError.
    void write();
    /// Waits until what was written is on the disk. Throws KeptError.
    void sync() const;

    const std::filesystem::path& path() const { return path_; }
    std::uint64_t size() const { return size_; } ///< bytes that were written

private:
    std::filesystem::path path_;
    std::unique_ptr<files::File> file_;
    std::uint64_t size_ = 0;
    std::vector<std::uint8_t> waiting_;
};

/// What such a file holds.
class KeptContents {
public:
    struct Entry {
        Record kind;
        std::uint64_t at = 0; ///< byte at which the record begins
        files::Bytes payload;
    };

    /// Reads the file up to the last record that is whole. What is behind it was being written when the
    /// program or the power went, and is left out, unless the disk was known to have it: then the file is
    /// damaged. Throws KeptError.
    explicit KeptContents(const std::filesystem::path& path, files::Disk& disk = files::system_disk());
    KeptContents(const KeptContents&) = delete;
    KeptContents& operator=(const KeptContents&) = delete;

    const std::vector<Entry>& entries() const { return entries_; }
    std::uint64_t cut_off() const { return cut_off_; } ///< bytes at its end that were left out

private:
    std::vector<std::uint8_t> bytes_;
    std::vector<Entry> entries_;
    std::uint64_t cut_off_ = 0;
};

} // namespace windlass::keep
