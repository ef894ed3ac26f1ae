#include "recorder/recording/recording.hpp"

#include "idl/types.hpp"

#include <algorithm>
#include <charconv>

namespace windlass::recording {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> files_of(const std::vector<fs::path>& paths) {
    std::vector<fs::path> files;
    for (const auto& path : paths) {
        if (!fs::is_directory(path)) {
            files.push_back(path);
            continue;
        }
        const std::size_t before = files.size();
        for (const auto& entry : fs::directory_iterator(path))
            if (entry.path().extension() == ".mcap") files.push_back(entry.path());
        if (files.size() == before)
            throw std::runtime_error(path.string() + ": there is no .mcap file in it");
        std::sort(files.begin() + static_cast<std::ptrdiff_t>(before), files.end());
    }
    if (files.empty()) throw std::runtime_error("no recording is named");
    return files;
}

/// What our recorder says of the recording that a file is a part of; nullptr for files of others.
const mcap::Strings* said_of_recording(const mcap::Reader& file) {
    for (const auto& metadata : file.metadata())
        if (metadata.name == "windlass.recording") return &metadata.entries;
    return nullptr;
}

/// What our recorder calls the recording that a file is a part of; empty for files of others.
std::string recording_id(const mcap::Reader& file) {
    const auto* said = said_of_recording(file);
    return said != nullptr && said->contains("recording") ? said->at("recording") : std::string();
}

/// Of a type's name: "windlass::v12::Event" 12, "windlass::Event" 1 (before versions had numbers); 0: no type
/// of ours.
int version_in(std::string_view type) {
    constexpr std::string_view ours = "windlass::";
    if (!type.starts_with(ours)) return 0;
    type.remove_prefix(ours.size());
    const auto end = type.find("::");
    if (end == type.npos) return 1;
    if (end < 2 || type[0] != 'v') return 0;
    int version = 0;
    const auto [stopped, error] = std::from_chars(type.data() + 1, type.data() + end, version);
    return error == std::errc() && stopped == type.data() + end ? version : 0;
}

/// Versions of the wire that the file is of: by its schemas, and by what our recorder says where it was cut
/// off before the first of them.
std::set<int> versions_of(const mcap::Reader& file) {
    std::set<int> versions;
    for (const auto& [id, schema] : file.schemas())
        versions.insert(version_in(schema.name));
    versions.erase(0);
    if (const auto* said = said_of_recording(file); said != nullptr && versions.empty()) {
        int version = 1;
        if (const auto entry = said->find("wire_version"); entry != said->end())
            std::from_chars(entry->second.data(), entry->second.data() + entry->second.size(), version);
        versions.insert(version);
    }
    return versions;
}

void must_be_of_this_version(const mcap::Reader& file, const fs::path& named) {
    for (const int version : versions_of(file))
        if (version != WIRE_VERSION)
            throw VersionError(named.string() + " is of version " + std::to_string(version) +
                               " of the wire, this program of version " + std::to_string(WIRE_VERSION) +
                               ": use the programs of version " + std::to_string(version) +
                               ", or any MCAP reader, since the file has its types with it");
}

/// A further file of a recording. Nothing: its recorder was lost at the beginning of it, or the disk was
/// full, and nothing is in it, not even of which recording it is.
std::unique_ptr<mcap::Reader> open_further(const fs::path& path) {
    std::error_code unknown;
    if (fs::file_size(path, unknown) < mcap::kMagic.size()) return nullptr;
    auto file = std::make_unique<mcap::Reader>(path);
    if (said_of_recording(*file) == nullptr && file->chunks().empty()) return nullptr;
    return file;
}

} // namespace

KeptMessage::KeptMessage(const Message& message)
    : topic(message.topic()),
      sequence(message.sequence),
      log_time(message.log_time),
      publish_time(message.publish_time),
      payload(message.payload.begin(), message.payload.end()) {}

Recording::Recording(const std::vector<fs::path>& paths) {
    const auto files = files_of(paths);
    const fs::path named = fs::absolute(paths.front()).lexically_normal();
    name_ = named.has_filename() ? named.stem().string() : named.parent_path().filename().string();
    for (const auto& path : files) {
        auto opened = files_.empty() ? std::make_unique<mcap::Reader>(path) : open_further(path);
        if (!opened) {
            tell(path.string() + ": it was begun, and nothing is in it");
            continue;
        }
        files_.push_back(std::move(opened));
        const auto& file = *files_.back();
        must_be_of_this_version(file, paths.size() == 1 ? paths.front() : path);
        if (recording_id(file) != recording_id(*files_.front())) {
            throw std::runtime_error(path.string() + " and " + files.front().string() +
                                     " are of two recordings; name one");
        }
        if (!file.damage().empty()) tell(path.string() + ": " + file.damage());
        for (const auto& chunk : file.chunks())
            chunks_.push_back({files_.size() - 1, chunk});
    }
    std::ranges::stable_sort(chunks_, {}, [](const ChunkOf& chunk) { return chunk.index.start; });
    if (chunks_.empty()) return;
    start_ = chunks_.front().index.start;
    for (const auto& chunk : chunks_)
        end_ = std::max(end_, chunk.index.end);
}

Cursor Recording::messages(Query query) {
    return {*this, std::move(query)};
}

std::optional<KeptMessage> Recording::last_before(const std::string& topic, Nanoseconds time) {
    const Query query{.topics = {topic}, .until = time + 1};
    for (std::size_t i = chunks_.size(); i-- > 0;) {
        if (!concerns(chunks_[i], query)) continue;
        std::optional<KeptMessage> found;
        Cursor cursor(*this, query);
        cursor.query_.from = chunks_[i].index.start;
        cursor.next_chunk_ = i;
        while (const auto message = cursor.next())
            found.emplace(*message);
        if (found) return found;
    }
    return std::nullopt;
}

Recording::TypeText Recording::type_of(const mcap::Channel& channel) const {
    for (const auto& file : files_) {
        const auto found = file->channels().find(channel.id);
        if (found == file->channels().end() || &found->second != &channel) continue;
        const auto schema = file->schemas().find(channel.schema_id);
        if (schema != file->schemas().end() && schema->second.encoding == "omgidl")
            return {schema->second.name, schema->second.data};
    }
    return {};
}

/// Whether there can be such messages in the chunk, as far as the indexes tell.
bool Recording::concerns(const ChunkOf& chunk, const Query& query) const {
    if (chunk.index.end < query.from || chunk.index.start >= query.until) return false;
    if (query.topics.empty() || chunk.index.message_index_offsets.empty()) return true;
    const auto& channels = files_[chunk.file]->channels();
    return std::ranges::any_of(chunk.index.message_index_offsets, [&](const auto& entry) {
        const auto channel = channels.find(entry.first);
        return channel == channels.end() || query.topics.contains(channel->second.topic);
    });
}

void Recording::tell(std::string damage) {
    if (std::ranges::find(damage_, damage) == damage_.end()) damage_.push_back(std::move(damage));
}

Cursor::Cursor(Recording& recording, Query query) : recording_(&recording), query_(std::move(query)) {}

bool Cursor::open_next_chunk() {
    entries_.clear();
    next_entry_ = 0;
    const auto& chunks = recording_->chunks_;
    while (next_chunk_ < chunks.size() && !recording_->concerns(chunks[next_chunk_], query_))
        ++next_chunk_;
    if (next_chunk_ == chunks.size()) return false;
    const auto& chunk = chunks[next_chunk_++];
    file_ = chunk.file;
    auto& file = *recording_->files_[file_];
    try {
        const Bytes records = file.records(chunk.index);
        records_.assign(records.begin(), records.end()); // other cursors read through the same file
        mcap::for_each_record(records_, [this](mcap::Opcode opcode, Bytes content) {
            if (opcode == mcap::Opcode::message)
                entries_.push_back({mcap::parse<mcap::Message>(content).log_time, content});
        });
    } catch (const mcap::Damage& damage) {
        entries_.clear();
        recording_->tell(file.path().string() + ": " + damage.what() + "; what is in it is left out");
    }
    // Our recorder writes in this order; other writers need not.
    std::ranges::stable_sort(entries_, {}, &Entry::log_time);
    return true;
}

std::optional<Message> Cursor::next() {
    for (;;) {
        if (next_entry_ == entries_.size()) {
            if (!open_next_chunk()) return std::nullopt;
            continue;
        }
        const auto message = mcap::parse<mcap::Message>(entries_[next_entry_++].content);
        if (message.log_time < query_.from || message.log_time >= query_.until) continue;
        const auto& channels = recording_->files_[file_]->channels();
        const auto channel = channels.find(message.channel_id);
        if (channel == channels.end()) continue; // defined nowhere: it cannot be told what it is
        if (!query_.topics.empty() && !query_.topics.contains(channel->second.topic)) continue;
        return Message{.channel = &channel->second,
                       .sequence = message.sequence,
                       .log_time = message.log_time,
                       .publish_time = message.publish_time,
                       .payload = message.data};
    }
}

} // namespace windlass::recording
