#pragma once
// What those who write files that must last ask of a disk: a narrow door, so that they can also be tried on
// one that is full, slow, or loses its power at any moment (sim/).

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

namespace windlass::files {

using Bytes = std::span<const std::uint8_t>;

/// Who may read a file that is made; whoever made it writes it.
enum class ReadBy { owner, all };

/// A file that is being written; closed when it goes. What goes wrong is thrown as std::system_error with the
/// system's code.
class File {
public:
    virtual ~File() = default;
    File(const File&) = delete;
    File& operator=(const File&) = delete;

    /// Hands what it takes of the bytes to the system, behind what is there; returns how many.
    virtual std::size_t append(Bytes bytes) = 0;
    /// Leaves so many bytes of it.
    virtual void cut(std::uint64_t size) = 0;
    /// Waits until the disk has what was handed over. Beside the rest, on a thread of its own.
    virtual void sync() = 0;

protected:
    File() = default;
};

/// Files and folders. What goes wrong is thrown as std::system_error with the system's code.
class Disk {
public:
    virtual ~Disk() = default;
    Disk(const Disk&) = delete;
    Disk& operator=(const Disk&) = delete;

    /// A new file, which must not be there.
    virtual std::unique_ptr<File> make(const std::filesystem::path& file, ReadBy readers) = 0;
    /// Adds to a file, which is made where it is not there, for its owner.
    virtual void append(const std::filesystem::path& file, Bytes bytes) = 0;
    virtual std::vector<std::uint8_t> read(const std::filesystem::path& file) = 0;

    virtual bool exists(const std::filesystem::path& path) = 0;
    /// What is in a folder, in any order; nothing where there is none.
    virtual std::vector<std::filesystem::path> list(const std::filesystem::path& folder) = 0;
    virtual std::filesystem::file_time_type written_at(const std::filesystem::path& path) = 0;

    /// Makes a folder and those above it, where they are not there.
    virtual void make_folder(const std::filesystem::path& folder) = 0;
    virtual void rename(const std::filesystem::path& from, const std::filesystem::path& to) = 0;
    /// A file or an empty folder; where there is none, nothing happens.
    virtual void remove(const std::filesystem::path& path) = 0;
    /// With all that is in it.
    virtual void remove_all(const std::filesystem::path& path) = 0;
    /// What was made, renamed or removed in the folder is on the disk then, as far as the system can tell.
    virtual void sync_folder(const std::filesystem::path& folder) = 0;

protected:
    Disk() = default;
};

/// The disk of the machine.
Disk& system_disk();

} // namespace windlass::files
