#pragma once
// A disk that is full, slow, refuses, or loses its power, when the world says so.

#include "common/disk.hpp"
#include "sim/world.hpp"

#include <limits>
#include <map>
#include <optional>

namespace windlass::sim {

class SimDisk final : public files::Disk {
public:
    explicit SimDisk(World& world) : SimDisk(world, world.chance()) {}
    /// chance: draws what a loss leaves.
    SimDisk(World& world, Chance& chance) : world_(world), chance_(chance) {}

    // How it is.
    std::uint64_t room = std::numeric_limits<std::uint64_t>::max(); ///< bytes, of all files together
    bool refuses = false;                                           ///< to write, sync or make anything: EIO
    double write_takes = 0;                                         ///< s, each
    double sync_takes = 0;                                          ///< s, each
    bool served = false; ///< by a server that runs: a slow disk lets the world go on
    /// s, that calls took since it was set: whoever sets it sits them out himself when all are made, and the
    /// world does not go on in the midst of them.
    std::optional<double> took{};
    /// The server is lost in so many operations from now, in the midst of one that writes; 0: it is not.
    void lose_in(std::uint64_t operations, Loss how) {
        lost_at_ = operations == 0 ? 0 : operations_ + operations, lost_how_ = how;
    }

    /// The server is gone, and what it did not hand over with it; after a power cut, what the disk did not
    /// have, any part of it: files end anywhere, with pages of zeros, and folders are as they were before.
    void lose(Loss how);

    /// Something was refused since a file was made last that is written.
    bool failed() const { return failed_; }
    std::uint64_t errors() const { return errors_; } ///< so often it refused
    std::uint64_t bytes() const;                     ///< of all files
    std::uint64_t bytes_below(const std::filesystem::path& folder) const;
    /// Changes a byte that the disk has, of the newest file whose name ends so; false: there is none.
    bool rot(const std::string& ending);
    /// What is in it, as somebody else sees it; nothing: there is none.
    std::optional<files::Bytes> content(const std::filesystem::path& file) const;
    /// Somebody else removes it, with all that is in it.
    void clear_away(const std::filesystem::path& path);
    /// Cuts so many bytes off the newest such file.
    void lose_the_end(const std::string& ending, std::size_t bytes);

    std::unique_ptr<files::File> make(const std::filesystem::path& file, files::ReadBy readers) override;
    void append(const std::filesystem::path& file, files::Bytes bytes) override;
    std::vector<std::uint8_t> read(const std::filesystem::path& file) override;
    bool exists(const std::filesystem::path& path) override;
    std::vector<std::filesystem::path> list(const std::filesystem::path& folder) override;
    std::filesystem::file_time_type written_at(const std::filesystem::path& path) override;
    void make_folder(const std::filesystem::path& folder) override;
    void rename(const std::filesystem::path& from, const std::filesystem::path& to) override;
    void remove(const std::filesystem::path& path) override;
    void remove_all(const std::filesystem::path& path) override;
    void sync_folder(const std::filesystem::path& folder) override;

private:
    struct Node {
        bool folder = false;
        std::vector<std::uint8_t> bytes{};
        std::size_t synced = 0; // of them the disk has
        std::uint64_t written = 0;
    };
    using Entries = std::map<std::filesystem::path, std::shared_ptr<Node>>;
    class File;

    void operation(bool writes);
    bool lost_now();
    void write(Node& node, files::Bytes bytes, std::size_t& taken);
    [[noreturn]] void refuse(int error);
    void wait(double seconds);
    template <class Change>
    void change(Change change);

    World& world_;
    Chance& chance_;
    Entries entries_;
    Entries on_disk_;                                    // as a power cut would leave them at worst
    std::vector<std::function<void(Entries&)>> changes_; // of folders, that the disk may not have yet
    std::uint64_t operations_ = 0, lost_at_ = 0, writes_ = 0, errors_ = 0;
    Loss lost_how_ = Loss::killed;
    bool lost_ = false, failed_ = false;
};

} // namespace windlass::sim
