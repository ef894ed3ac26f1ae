#pragma once
// A file being written or read; errors say which file, what was tried, and why it failed.

#include "common/disk.hpp"
#include "recorder/mcap/bytes.hpp"

#include <filesystem>
#include <memory>

namespace windlass::mcap {

/// The system refused to write: a full disk, a limit on file size. error() is errno.
class WriteError : public std::runtime_error {
public:
    WriteError(const std::string& text, int error) : std::runtime_error(text), error_(error) {}
    int error() const { return error_; }

private:
    int error_;
};

/// A new file, written from front to back.
class OutFile {
public:
    /// Throws WriteError, also where the file exists already.
    explicit OutFile(const std::filesystem::path& path, files::Disk& disk = files::system_disk());

    /// Writes all, or throws WriteError having written a part.
    void write(Bytes bytes);
    /// Cuts off what lies behind `size`, and goes on writing there.
    void cut(std::uint64_t size);
    /// Waits until the disk has it.
    void sync();

    std::uint64_t size() const { return size_; }
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
    std::unique_ptr<files::File> file_;
    std::uint64_t size_ = 0;
};

/// An existing file, read anywhere.
class InFile {
public:
    /// Throws std::runtime_error when it cannot be opened.
    explicit InFile(const std::filesystem::path& path);
    ~InFile();
    InFile(const InFile&) = delete;
    InFile& operator=(const InFile&) = delete;

    /// Exactly those bytes, in a buffer that the next call uses again. Throws Damage where the file ends
    /// before.
    Bytes read(std::uint64_t offset, std::uint64_t size);

    std::uint64_t size() const { return size_; }
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
    int descriptor_ = -1;
    std::uint64_t size_ = 0;
    Buffer buffer_;
};

} // namespace windlass::mcap
