#include "common/disk.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace windlass::files {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail() {
    throw std::system_error(errno, std::generic_category());
}

/// A file that the system has open.
class Descriptor {
public:
    Descriptor(const fs::path& path, int flags, mode_t mode = 0)
        : number_(open(path.c_str(), flags | O_CLOEXEC, mode)) {}
    ~Descriptor() {
        if (number_ >= 0) close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    bool is_open() const { return number_ >= 0; }
    int operator*() const { return number_; }

private:
    int number_;
};

class SystemFile final : public File {
public:
    SystemFile(const fs::path& path, ReadBy readers, int flags)
        : file_(path, O_WRONLY | O_CREAT | O_APPEND | flags, readers == ReadBy::all ? 0644 : 0600) {
        if (!file_.is_open()) fail();
    }
    std::size_t append(Bytes bytes) override {
        for (;;) {
            const ssize_t written = ::write(*file_, bytes.data(), bytes.size());
            if (written >= 0) return static_cast<std::size_t>(written);
            if (errno != EINTR) fail();
        }
    }
    void cut(std::uint64_t size) override {
        if (ftruncate(*file_, static_cast<off_t>(size)) != 0) fail();
    }
    void sync() override {
        if (fdatasync(*file_) != 0) fail();
    }

private:
    const Descriptor file_;
};

class SystemDisk final : public Disk {
public:
    std::unique_ptr<File> make(const fs::path& file, ReadBy readers) override {
        return std::make_unique<SystemFile>(file, readers, O_EXCL);
    }
    void append(const fs::path& file, Bytes bytes) override {
        SystemFile(file, ReadBy::owner, 0).append(bytes);
    }
    std::vector<std::uint8_t> read(const fs::path& path) override {
        const Descriptor file(path, O_RDONLY);
        struct stat status {};
        if (!file.is_open() || fstat(*file, &status) != 0) fail();
        std::vector<std::uint8_t> bytes(static_cast<std::size_t>(status.st_size));
        std::size_t done = 0;
        while (done < bytes.size()) {
            const ssize_t got = ::read(*file, bytes.data() + done, bytes.size() - done);
            if (got < 0 && errno == EINTR) continue;
            if (got < 0) fail();
            if (got == 0) break;
            done += static_cast<std::size_t>(got);
        }
        bytes.resize(done);
        return bytes;
    }
    bool exists(const fs::path& path) override { return fs::exists(path); }
    std::vector<fs::path> list(const fs::path& folder) override {
        std::vector<fs::path> paths;
        std::error_code none;
        for (const auto& entry : fs::directory_iterator(folder, none))
            paths.push_back(entry.path());
        return paths;
    }
    fs::file_time_type written_at(const fs::path& path) override { return fs::last_write_time(path); }
    void make_folder(const fs::path& folder) override { fs::create_directories(folder); }
    void rename(const fs::path& from, const fs::path& to) override { fs::rename(from, to); }
    void remove(const fs::path& path) override { fs::remove(path); }
    void remove_all(const fs::path& path) override { fs::remove_all(path); }
    void sync_folder(const fs::path& path) override {
        const Descriptor folder(path, O_RDONLY | O_DIRECTORY);
        if (folder.is_open()) fsync(*folder);
    }
};

} // namespace

Disk& system_disk() {
    static SystemDisk disk;
    return disk;
}

} // namespace windlass::files
