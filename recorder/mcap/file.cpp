#include "recorder/mcap/file.hpp"

#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace windlass::mcap {

namespace {

std::string why(int error) {
    return std::generic_category().message(error);
}

[[noreturn]] void fail(const std::filesystem::path& path, const char* what) {
    const int error = errno;
    throw WriteError(path.string() + ": cannot " + what + ": " + why(error), error);
}

} // namespace

OutFile::OutFile(const std::filesystem::path& path) : path_(path) {
    descriptor_ = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
    if (descriptor_ < 0) fail(path_, "make this file");
}

OutFile::~OutFile() {
    close(descriptor_);
}

void OutFile::write(Bytes bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail(path_, "write");
        size_ += static_cast<std::uint64_t>(written);
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
}

void OutFile::cut(std::uint64_t size) {
    if (ftruncate(descriptor_, static_cast<off_t>(size)) != 0 ||
        lseek(descriptor_, static_cast<off_t>(size), SEEK_SET) < 0)
        fail(path_, "cut off what was half written");
    size_ = size;
}

void OutFile::sync() {
    if (fdatasync(descriptor_) != 0) fail(path_, "write to the disk");
}

InFile::InFile(const std::filesystem::path& path) : path_(path) {
    descriptor_ = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    struct stat status {};
    if (descriptor_ < 0 || fstat(descriptor_, &status) != 0 || !S_ISREG(status.st_mode)) {
        const int error = errno;
        if (descriptor_ >= 0) close(descriptor_);
        throw std::runtime_error(path.string() +
                                 ": cannot be read: " + (descriptor_ < 0 ? why(error) : "it is no file"));
    }
    size_ = static_cast<std::uint64_t>(status.st_size);
}

InFile::~InFile() {
    close(descriptor_);
}

Bytes InFile::read(std::uint64_t offset, std::uint64_t size) {
    if (offset > size_ || size > size_ - offset)
        throw Damage("the file ends at byte " + std::to_string(size_));
    buffer_.resize(size);
    std::size_t done = 0;
    while (done < size) {
        const ssize_t got =
            pread(descriptor_, buffer_.data() + done, size - done, static_cast<off_t>(offset + done));
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) throw Damage("byte " + std::to_string(offset + done) + " cannot be read: " + why(errno));
        if (got == 0) throw Damage("the file ends at byte " + std::to_string(offset + done));
        done += static_cast<std::size_t>(got);
    }
    return buffer_;
}

} // namespace windlass::mcap
