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

/// What the disk refuses, with the file's name and what was tried.
template <class Act>
auto trying_to(const char* what, const std::filesystem::path& path, Act act) {
    try {
        return act();
    } catch (const std::system_error& refused) {
        const int error = refused.code().value();
        throw WriteError(path.string() + ": cannot " + what + ": " + why(error), error);
    }
}

} // namespace

OutFile::OutFile(const std::filesystem::path& path, files::Disk& disk)
    : path_(path),
      file_(trying_to("make this file", path, [&] { return disk.make(path, files::ReadBy::all); })) {}

void OutFile::write(Bytes bytes) {
    while (!bytes.empty()) {
        const std::size_t written = trying_to("write", path_, [&] { return file_->append(bytes); });
        size_ += written;
        bytes = bytes.subspan(written);
    }
}

void OutFile::cut(std::uint64_t size) {
    trying_to("cut off what was half written", path_, [&] { file_->cut(size); });
    size_ = size;
}

void OutFile::sync() {
    trying_to("write to the disk", path_, [&] { file_->sync(); });
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
