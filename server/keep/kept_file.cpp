#include "server/keep/kept_file.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <optional>
#include <system_error>
#include <utility>

namespace windlass::keep {

namespace {

static_assert(std::endian::native == std::endian::little, "the layout is that of the memory");

constexpr std::array<char, 6> kMark{'W', 'L', 'K', 'E', 'P', 'T'};
constexpr std::size_t kBegin = kMark.size() + sizeof kKeptFormat;
constexpr std::size_t kHead = 9;             // length, CRC, kind
constexpr std::size_t kMaxPayload = 2 << 20; // a checkpoint on the wire is of 1 MiB at most

template <class Number>
void put(std::vector<std::uint8_t>& bytes, Number number) {
    const auto raw = std::bit_cast<std::array<std::uint8_t, sizeof number>>(number);
    bytes.insert(bytes.end(), raw.begin(), raw.end());
}

template <class Number>
Number number_at(files::Bytes bytes, std::size_t at) {
    Number number{};
    std::memcpy(&number, bytes.data() + at, sizeof number);
    return number;
}

std::uint32_t checksum(files::Bytes kind_and_payload) {
    return static_cast<std::uint32_t>(crc32_z(0, kind_and_payload.data(), kind_and_payload.size()));
}

[[noreturn]] void fail(const std::filesystem::path& path, const char* what, const std::system_error& error) {
    throw KeptError(path.string() + ": cannot " + what + ": " + error.code().message());
}

std::unique_ptr<files::File> make_file(files::Disk& disk, const std::filesystem::path& path) {
    try {
        return disk.make(path, files::ReadBy::owner);
    } catch (const std::system_error& error) {
        fail(path, "make this file", error);
    }
}

std::vector<std::uint8_t> read_file(files::Disk& disk, const std::filesystem::path& path) {
    try {
        return disk.read(path);
    } catch (const std::system_error& error) {
        fail(path, "be read", error);
    }
}

/// The record at that byte; nothing: no whole one begins there.
std::optional<KeptContents::Entry> record_at(files::Bytes bytes, std::size_t at) {
    if (bytes.size() - at < kHead) return std::nullopt;
    const auto length = number_at<std::uint32_t>(bytes, at);
    const auto kind = bytes[at + kHead - 1];
    if (length > kMaxPayload || length > bytes.size() - at - kHead || kind == 0 ||
        kind > static_cast<std::uint8_t>(Record::synced))
        return std::nullopt;
    if (checksum(bytes.subspan(at + kHead - 1, length + 1)) != number_at<std::uint32_t>(bytes, at + 4))
        return std::nullopt;
    return KeptContents::Entry{
        .kind = static_cast<Record>(kind), .at = at, .payload = bytes.subspan(at + kHead, length)};
}

/// Up to which byte the disk is known to have the file, by what stands at or behind that place.
std::uint64_t synced_behind(files::Bytes bytes, std::size_t from) {
    std::uint64_t synced = 0;
    for (std::size_t at = from; at + kHead + sizeof synced <= bytes.size(); ++at) {
        if (bytes[at + kHead - 1] != static_cast<std::uint8_t>(Record::synced) ||
            number_at<std::uint32_t>(bytes, at) != sizeof synced)
            continue;
        if (const auto record = record_at(bytes, at))
            synced = std::max(synced, number_at<std::uint64_t>(record->payload, 0));
    }
    return synced;
}

} // namespace

KeptWriter::KeptWriter(std::filesystem::path path, files::Disk& disk)
    : path_(std::move(path)), file_(make_file(disk, path_)) {
    waiting_.reserve(kBegin);
    waiting_.assign(kMark.begin(), kMark.end());
    put(waiting_, kKeptFormat);
}

void KeptWriter::add(Record kind, files::Bytes payload) {
    put(waiting_, static_cast<std::uint32_t>(payload.size()));
    const std::size_t check = waiting_.size();
    put(waiting_, std::uint32_t{0});
    waiting_.push_back(static_cast<std::uint8_t>(kind));
    waiting_.insert(waiting_.end(), payload.begin(), payload.end());
    const std::uint32_t sum = checksum(files::Bytes(waiting_).subspan(check + sizeof sum));
    std::memcpy(waiting_.data() + check, &sum, sizeof sum);
}

void KeptWriter::write() {
    const std::uint64_t whole = size_;
    std::size_t done = 0;
    try {
        while (done < waiting_.size())
            done += file_->append(files::Bytes(waiting_).subspan(done));
    } catch (const std::system_error& error) {
        waiting_.clear();
        try {
            file_->cut(whole);
        } catch (const std::system_error& uncut) {
            fail(path_, "cut off what was half written", uncut);
        }
        fail(path_, "write", error);
    }
    size_ = whole + done;
    waiting_.clear();
}

void KeptWriter::sync() const {
    try {
        file_->sync();
    } catch (const std::system_error& error) {
        fail(path_, "write to the disk", error);
    }
}

KeptContents::KeptContents(const std::filesystem::path& path, files::Disk& disk)
    : bytes_(read_file(disk, path)) {
    const files::Bytes bytes(bytes_);
    if (bytes.size() < kBegin) { // killed before its first word was whole
        cut_off_ = bytes.size();
        return;
    }
    const bool blank = std::ranges::all_of(bytes.first(kBegin), [](auto byte) { return byte == 0; });
    if (!blank && !std::equal(kMark.begin(), kMark.end(), bytes.begin()))
        throw KeptError(path.string() +
                        ": not a file of kept exercises: it begins with other bytes than WLKEPT");
    if (const auto format = number_at<std::uint16_t>(bytes, kMark.size()); !blank && format != kKeptFormat)
        throw KeptError(path.string() + ": format " + std::to_string(format) +
                        " is not allowed: this version of the server keeps in format " +
                        std::to_string(kKeptFormat));
    std::size_t at = blank ? 0 : kBegin; // blank: the power went before its first words came to the disk
    while (!blank && at < bytes.size()) {
        const auto record = record_at(bytes, at);
        if (!record) break;
        entries_.push_back(*record);
        at += kHead + record->payload.size();
    }
    if (synced_behind(bytes, at) > at)
        throw KeptError(path.string() + ": damaged: the record at byte " + std::to_string(at) + " of " +
                        std::to_string(bytes.size()) +
                        " was on the disk, and its checksum is not that of its bytes");
    cut_off_ = bytes.size() - at;
}

} // namespace windlass::keep
