#include "recorder/mcap/writer.hpp"

#include <algorithm>
#include <utility>

namespace windlass::mcap {

Writer::Writer(const std::filesystem::path& path, WriterOptions options, files::Disk& disk)
    : file_(path, disk), options_(std::move(options)) {
    out_.assign(kMagic.begin(), kMagic.end());
    append(out_, Header{.profile = "", .library = options_.library});
    put(out_);
}

void Writer::put(const Buffer& whole_records) {
    const std::uint64_t before = file_.size();
    try {
        file_.write(whole_records);
    } catch (const WriteError&) {
        file_.cut(before);
        throw;
    }
}

std::uint16_t Writer::add_schema(std::string name, std::string encoding, std::string data) {
    const auto id = static_cast<std::uint16_t>(schemas_.size() + 1);
    Schema schema{id, std::move(name), std::move(encoding), std::move(data)};
    out_.clear();
    append(out_, schema);
    put(out_);
    schemas_.push_back(std::move(schema));
    return id;
}

std::uint16_t Writer::add_channel(std::uint16_t schema, std::string topic, std::string message_encoding,
                                  Strings metadata) {
    const auto id = static_cast<std::uint16_t>(channels_.size() + 1);
    Channel channel{id, schema, std::move(topic), std::move(message_encoding), std::move(metadata)};
    out_.clear();
    append(out_, channel);
    put(out_);
    channels_.push_back(std::move(channel));
    return id;
}

void Writer::add_attachment(const Attachment& attachment) {
    out_.clear();
    append(out_, attachment);
    const std::uint64_t offset = file_.size();
    put(out_);
    attachment_index_.push_back({offset, out_.size(), attachment.log_time, attachment.create_time,
                                 attachment.data.size(), attachment.name, attachment.media_type});
}

void Writer::add_metadata(const Metadata& metadata) {
    out_.clear();
    append(out_, metadata);
    const std::uint64_t offset = file_.size();
    put(out_);
    metadata_index_.push_back({offset, out_.size(), metadata.name});
}

void Writer::write(const Message& message) {
    if (open_messages_ == 0) {
        open_ = {};
        open_.start = open_.end = message.log_time;
    }
    auto& index = open_index_[message.channel_id];
    index.channel_id = message.channel_id;
    index.entries.emplace_back(message.log_time, chunk_.size());
    append(chunk_, message);
    open_.start = std::min(open_.start, message.log_time);
    open_.end = std::max(open_.end, message.log_time);
    ++open_messages_;
    if (chunk_.size() >= options_.chunk_size) flush();
}

void Writer::flush() {
    if (open_messages_ == 0) return;
    compress(options_.compression, chunk_, compressed_);
    open_.offset = file_.size();
    open_.compression = compression_name(options_.compression);
    open_.compressed_size = compressed_.size();
    open_.uncompressed_size = chunk_.size();
    out_.clear();
    append(out_, Chunk{open_.start, open_.end, chunk_.size(), crc32(chunk_), open_.compression, compressed_});
    open_.length = out_.size();
    for (const auto& [channel, index] : open_index_) {
        open_.message_index_offsets[channel] = open_.offset + out_.size();
        append(out_, index);
    }
    open_.message_index_length = out_.size() - open_.length;

    const auto messages = std::exchange(open_messages_, 0);
    const auto index = std::exchange(open_index_, {});
    chunk_.clear();
    try {
        put(out_);
    } catch (const WriteError&) {
        lost_ += messages;
        throw;
    }
    auto& counted = statistics_;
    counted.start = chunk_index_.empty() ? open_.start : std::min(counted.start, open_.start);
    counted.end = std::max(counted.end, open_.end);
    counted.messages += messages;
    for (const auto& [channel, entries] : index)
        counted.channel_messages[channel] += entries.entries.size();
    chunk_index_.push_back(std::move(open_));
}

Buffer Writer::summary() const {
    Buffer out;
    append(out, DataEnd{});
    const std::size_t data_end = out.size();
    const std::uint64_t start = file_.size() + data_end;

    Statistics statistics = statistics_;
    statistics.schemas = static_cast<std::uint16_t>(schemas_.size());
    statistics.channels = static_cast<std::uint32_t>(channels_.size());
    statistics.attachments = static_cast<std::uint32_t>(attachment_index_.size());
    statistics.metadata = static_cast<std::uint32_t>(metadata_index_.size());
    statistics.chunks = static_cast<std::uint32_t>(chunk_index_.size());

    std::vector<SummaryOffset> groups;
    const auto group = [&](Opcode opcode, const auto& records) {
        if (records.empty()) return;
        const std::uint64_t at = file_.size() + out.size();
        for (const auto& record : records)
            append(out, record);
        groups.push_back({opcode, at, file_.size() + out.size() - at});
    };
    group(Opcode::schema, schemas_);
    group(Opcode::channel, channels_);
    group(Opcode::statistics, std::vector{statistics});
    group(Opcode::chunk_index, chunk_index_);
    group(Opcode::attachment_index, attachment_index_);
    group(Opcode::metadata_index, metadata_index_);

    const std::uint64_t offsets = file_.size() + out.size();
    for (const auto& one : groups)
        append(out, one);
    // The CRC is that of the summary and of the footer but for the CRC itself, which comes last.
    append(out, Footer{start, offsets, 0});
    constexpr std::size_t kCrc = sizeof(std::uint32_t);
    const std::uint32_t crc = crc32(Bytes(out).subspan(data_end, out.size() - data_end - kCrc));
    std::memcpy(out.data() + out.size() - kCrc, &crc, kCrc);
    Encoder(out).raw(kMagic);
    return out;
}

void Writer::close() {
    flush();
    put(summary());
    file_.sync();
}

} // namespace windlass::mcap
