#include "sim/recording_checks.hpp"

#include "recorder/mcap/reader.hpp"

#include <spdlog/fmt/fmt.h>

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <string_view>
#include <system_error>

namespace windlass::sim {

namespace {

[[noreturn]] void fail_recording(const Recorded& recorded, std::string expected, const std::string& found) {
    throw Failure{"recording", std::move(expected), recorded.folder.string() + ": " + found};
}

/// The bytes as a file that the reader can open.
class MemoryFile {
public:
    explicit MemoryFile(files::Bytes bytes) : number_(memfd_create("recording", MFD_CLOEXEC)) {
        while (number_ >= 0 && !bytes.empty()) {
            const ssize_t written = ::write(number_, bytes.data(), bytes.size());
            if (written < 0) break;
            bytes = bytes.subspan(static_cast<std::size_t>(written));
        }
        if (number_ < 0 || !bytes.empty()) {
            const int error = errno;
            if (number_ >= 0) close(number_);
            throw std::system_error(error, std::generic_category());
        }
    }
    ~MemoryFile() { close(number_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    std::filesystem::path path() const { return "/proc/self/fd/" + std::to_string(number_); }

private:
    const int number_;
};

/// What can be read of a recording, in the order of its files.
struct ReadBack {
    std::vector<HeardSample> messages{};
    std::optional<mcap::Strings> closing{};
    std::string damage{}; // of a file, that told last; empty: each was closed
    std::string broken{}; // what is in the midst of one and cannot be read, that was found last
    bool torn = false;    // a file ends in the midst of a record
    std::optional<std::size_t> unread_from{}; // so many messages were read before anything was missing

    void miss() {
        if (!unread_from) unread_from = messages.size();
    }
};

std::optional<std::size_t> topic_row(std::string_view topic) {
    const auto& all = wire::topics::all;
    const auto found =
        std::ranges::find_if(all, [&](const wire::TopicInfo& one) { return topic == one.name; });
    if (found == all.end()) return std::nullopt;
    return static_cast<std::size_t>(found - all.begin());
}

std::optional<recorder::WriterId> writer_in(const mcap::Channel& channel) {
    recorder::WriterId writer{};
    const auto said = channel.metadata.find("writer");
    if (said == channel.metadata.end() || said->second.size() != 2 * writer.size()) return std::nullopt;
    const char* at = said->second.data();
    for (std::uint8_t& byte : writer) {
        const auto [stopped, error] = std::from_chars(at, at + 2, byte, 16);
        if (error != std::errc() || stopped != at + 2) return std::nullopt;
        at += 2;
    }
    return writer;
}

void read_chunk(mcap::Reader& reader, const mcap::ChunkIndex& chunk, ReadBack& read) {
    std::size_t messages = 0;
    mcap::for_each_record(reader.records(chunk), [&](mcap::Opcode opcode, mcap::Bytes content) {
        if (opcode != mcap::Opcode::message) return;
        const auto message = mcap::parse<mcap::Message>(content);
        const auto channel = reader.channels().find(message.channel_id);
        const bool known = channel != reader.channels().end();
        const auto topic = known ? topic_row(channel->second.topic) : std::nullopt;
        const auto writer = known ? writer_in(channel->second) : std::nullopt;
        if (!topic || !writer) throw mcap::Damage("a message of a channel that is not known");
        read.messages.push_back({.topic = *topic,
                                 .writer = *writer,
                                 .sequence = message.sequence,
                                 .log_time = message.log_time,
                                 .publish_time = message.publish_time,
                                 .payload = hash_of(message.data)});
        ++messages;
    });
    // A page of zeros over the head of a chunk makes one of it that has nothing in it.
    if (messages == 0) throw mcap::Damage("a chunk with nothing in it");
}

void read_file(files::Bytes bytes, ReadBack& read) {
    const MemoryFile file(bytes);
    std::optional<mcap::Reader> reader;
    try {
        reader.emplace(file.path());
    } catch (const mcap::Damage& damage) {
        read.damage = damage.what();
        read.torn = read.torn || !bytes.empty();
        read.miss();
        return;
    }
    for (const auto& metadata : reader->metadata())
        if (metadata.name == "windlass.closing") read.closing = metadata.entries;
    for (const auto& chunk : reader->chunks()) {
        try {
            read_chunk(*reader, chunk, read);
        } catch (const mcap::Damage& damage) {
            read.broken = damage.what();
            read.miss();
        }
    }
    if (reader->damage().empty()) return;
    read.damage = reader->damage();
    read.torn = read.torn || (!read.damage.ends_with(", 0 bytes are left out") &&
                              !read.damage.ends_with("everything before it was found"));
    read.miss();
}

ReadBack read_back(SimDisk& disk, const std::filesystem::path& folder) {
    ReadBack read;
    auto paths = disk.list(folder);
    std::ranges::sort(paths);
    for (const auto& path : paths)
        read_file(disk.content(path).value(), read);
    return read;
}

/// What was heard, in its order, nothing twice and nothing made up; with nothing missing but at the end, or,
/// where there may be holes, behind what is damaged.
void hold_messages(const Recorded& recorded, const ReadBack& read, bool holes) {
    const auto& heard = recorded.heard;
    std::size_t next = 0;
    for (std::size_t k = 0; k < read.messages.size(); ++k) {
        const auto found =
            std::find(heard.begin() + static_cast<std::ptrdiff_t>(next), heard.end(), read.messages[k]);
        const auto place = static_cast<std::size_t>(found - heard.begin());
        const bool hole = holes && read.unread_from && *read.unread_from <= k;
        if (found == heard.end() || (place != next && !hole))
            fail_recording(recorded, fmt::format("message {} of {} that were heard", next + 1, heard.size()),
                           found == heard.end() ? fmt::format("one of topic {} that was not heard, or before",
                                                              wire::topics::all[read.messages[k].topic].name)
                                                : fmt::format("message {}", place + 1));
        next = place + 1;
    }
}

/// What the recording says of itself adds up to what was heard.
void hold_closing(const Recorded& recorded, const ReadBack& read) {
    const auto said = [&](const char* what) {
        const auto entry = read.closing->find(what);
        return entry == read.closing->end() ? std::string("nothing") : entry->second;
    };
    const std::size_t messages = read.messages.size();
    const std::size_t lost = recorded.heard.size() - messages;
    for (const auto& [what, count] : {std::pair<const char*, std::uint64_t>{"messages", messages},
                                      {"lost_at_end", lost},
                                      {"dropped", recorded.dropped}})
        if (said(what) != std::to_string(count))
            fail_recording(recorded, fmt::format("{} {} in windlass.closing", what, count), said(what));
}

} // namespace

std::uint64_t hash_of(files::Bytes payload) {
    return std::hash<std::string_view>{}(
        std::string_view(reinterpret_cast<const char*>(payload.data()), payload.size()));
}

void hold_recording(SimDisk& disk, const Recorded& recorded) {
    const ReadBack read = read_back(disk, recorded.folder);
    // Where the disk refuses the next file, there is none to be closed.
    const bool whole = recorded.closed && (!recorded.refused || read.closing);
    const bool cut = recorded.power_cut && !whole;
    hold_messages(recorded, read, cut);
    if (cut) return; // of what the disk was not waited for anything may be missing
    if (!read.broken.empty()) fail_recording(recorded, "no chunk that cannot be read", read.broken);
    if (read.messages.size() < recorded.flushed)
        fail_recording(recorded, fmt::format("the {} messages that were flushed", recorded.flushed),
                       std::to_string(read.messages.size()));
    if (recorded.refused && recorded.ended && read.torn)
        fail_recording(recorded, "nothing half written where the disk refused", read.damage);
    if (whole && !read.damage.empty()) fail_recording(recorded, "files that were closed", read.damage);
    if (whole && !read.closing) fail_recording(recorded, "how the recording was closed", "nothing");
    if (whole && !recorded.refused && read.messages.size() != recorded.heard.size())
        fail_recording(recorded, fmt::format("all {} messages", recorded.heard.size()),
                       std::to_string(read.messages.size()));
    if (read.closing) hold_closing(recorded, read);
}

} // namespace windlass::sim
