#include "recorder/record/tape.hpp"

#include "idl/idl_text.hpp"
#include "recorder/recording/sha256.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <system_error>

namespace windlass::recorder {

namespace fs = std::filesystem;

namespace {

// A client that starts anew has a new writer and gets a channel of its own, so that gaps in the sequence can
// be told. A hostile one could make thousands: from here on, they share a channel.
constexpr std::size_t kMaxWriters = 1000;
constexpr WriterId kManyWriters{};
// An exercise that stands still fills chunks slowly; the index of a file must stay bounded all the same.
constexpr std::size_t kMaxChunks = 50'000;

std::string hex(const WriterId& writer) {
    std::string text;
    for (const auto byte : writer)
        text += fmt::format("{:02x}", byte);
    return text;
}

std::int64_t now() {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(
               std::chrono::system_clock::now().time_since_epoch())
        .count();
}

} // namespace

Tape::Tape(TapeOptions options, files::Disk& disk) : options_(std::move(options)), disk_(disk) {
    try {
        make_folder();
        for (const auto& path : disk_.list(options_.folder))
            if (path.extension() == ".mcap")
                throw std::runtime_error(options_.folder.string() +
                                         ": there is a recording in it already; name another folder");
        begin_file();
    } catch (...) {
        discard();
        throw;
    }
}

void Tape::make_folder() {
    try {
        for (fs::path path = fs::absolute(options_.folder / "").parent_path(); !disk_.exists(path);
             path = path.parent_path())
            made_.push_back(path);
        disk_.make_folder(options_.folder);
    } catch (const std::system_error& error) {
        throw mcap::WriteError(options_.folder.string() +
                                   ": cannot make this folder: " + error.code().message(),
                               error.code().value());
    }
}

void Tape::discard() {
    file_.reset();
    for (const auto& path : made_) {
        try {
            disk_.remove(path);
        } catch (const std::system_error&) { // it holds something else, or the system does not let it go
            continue;
        }
    }
}

void Tape::begin_file() {
    const auto folder = fs::absolute(options_.folder / "").parent_path();
    const auto name = fmt::format("{}_{:03}.mcap", folder.filename().string(), part_);
    made_.insert(made_.begin(), folder / name);
    file_ = std::make_unique<mcap::Writer>(
        folder / name,
        mcap::WriterOptions{.compression = options_.compression, .library = "windlass recorder"}, disk_);
    mcap::Strings metadata = options_.metadata;
    metadata["part"] = std::to_string(part_++);
    metadata["wire_version"] = std::to_string(WIRE_VERSION);
    metadata["idl_sha256"] = recording::sha256(idl::own_text());
    file_->add_metadata({"windlass.recording", metadata});
    schemas_.clear();
    channels_.clear();
    attachments_written_ = 0;
    write_attachments();
}

/// The disk has the file then; that it is in its folder, and those that were made in theirs, is another
/// thing.
void Tape::end_file() {
    file_->close();
    for (const auto& path : made_)
        disk_.sync_folder(path.parent_path());
    bytes_before_ += file_->size();
    lost_before_ += file_->lost();
    file_.reset();
}

void Tape::write_attachments() {
    for (; attachments_written_ < attachments_.size(); ++attachments_written_) {
        const auto& file = attachments_[attachments_written_];
        file_->add_attachment({.log_time = now(),
                               .create_time = 0,
                               .name = file.name,
                               .media_type = "application/json",
                               .data = mcap::as_bytes(file.content)});
        file_->add_metadata(
            {"windlass.attachment", {{"name", file.name}, {"sha256", recording::sha256(file.content)}}});
    }
}

void Tape::attach(std::vector<ExerciseFile> files) {
    for (auto& file : files) {
        const auto same = [&](const ExerciseFile& other) {
            return other.name == file.name && other.content == file.content;
        };
        if (std::ranges::none_of(attachments_, same)) attachments_.push_back(std::move(file));
    }
    write_attachments();
}

std::uint16_t Tape::schema_of(std::size_t topic) {
    auto& schema = schemas_[topic];
    if (schema == 0)
        schema = file_->add_schema(wire::type_name(wire::topics::all[topic]), "omgidl",
                                   std::string(idl::own_text()));
    return schema;
}

std::uint16_t Tape::channel_of(const Sample& sample) {
    ChannelKey key{sample.topic, sample.writer};
    if (channels_.size() >= kMaxWriters && !channels_.contains(key)) key.second = kManyWriters;
    auto& channel = channels_[key];
    if (channel == 0) {
        const std::string writer = key.second == kManyWriters ? "many" : hex(key.second);
        channel = file_->add_channel(schema_of(sample.topic), wire::topics::all[sample.topic].name, "cdr",
                                     {{"writer", writer}});
    }
    return channel;
}

void Tape::write(const Sample& sample) {
    ++taken_;
    ++unplaced_;
    if (file_->size() >= options_.roll_size || file_->chunks() >= kMaxChunks) {
        end_file();
        begin_file();
    }
    const std::uint16_t channel = channel_of(sample);
    --unplaced_; // from here on it is in the file's open chunk, or counted as lost with it
    file_->write({.channel_id = channel,
                  .sequence = sample.sequence,
                  .log_time = sample.log_time,
                  .publish_time = sample.publish_time,
                  .data = sample.payload});
}

void Tape::flush() {
    file_->flush();
}

void Tape::close(const mcap::Strings& closing) {
    if (!file_) return;
    file_->flush();
    file_->add_metadata({"windlass.closing", closing});
    end_file();
}

std::uint64_t Tape::lost() const {
    return unplaced_ + lost_before_ + (file_ ? file_->lost() : 0);
}

std::uint64_t Tape::bytes() const {
    return bytes_before_ + (file_ ? file_->size() : 0);
}

} // namespace windlass::recorder
