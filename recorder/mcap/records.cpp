#include "recorder/mcap/records.hpp"

#include <zlib.h>

namespace windlass::mcap {

namespace {

/// Appends opcode, length and what `fill` puts in.
template <class Fill>
void record(Buffer& out, Opcode opcode, Fill fill) {
    Encoder encoder(out);
    encoder.put<std::uint8_t>(static_cast<std::uint8_t>(opcode)).put<std::uint64_t>(0);
    const std::size_t start = out.size();
    fill(encoder);
    const std::uint64_t length = out.size() - start;
    std::memcpy(out.data() + start - sizeof length, &length, sizeof length);
}

void put_strings(Encoder& out, const Strings& strings) {
    const auto begin = out.begin();
    for (const auto& [key, value] : strings)
        out.text(key).text(value);
    out.end(begin);
}

Strings get_strings(Decoder& in) {
    Strings strings;
    for (Decoder map(in.bytes()); !map.empty();) {
        const std::string key = map.text();
        strings[key] = map.text();
    }
    return strings;
}

void put_counts(Encoder& out, const std::map<std::uint16_t, std::uint64_t>& counts) {
    const auto begin = out.begin();
    for (const auto& [key, value] : counts)
        out.put<std::uint16_t>(key).put<std::uint64_t>(value);
    out.end(begin);
}

std::map<std::uint16_t, std::uint64_t> get_counts(Decoder& in) {
    std::map<std::uint16_t, std::uint64_t> counts;
    for (Decoder map(in.bytes()); !map.empty();) {
        const auto key = map.get<std::uint16_t>();
        counts[key] = map.get<std::uint64_t>();
    }
    return counts;
}

} // namespace

std::uint32_t crc32(Bytes bytes, std::uint32_t before) {
    return static_cast<std::uint32_t>(crc32_z(before, bytes.data(), bytes.size()));
}

void append(Buffer& out, const Header& r) {
    record(out, Opcode::header, [&](Encoder& e) { e.text(r.profile).text(r.library); });
}
void append(Buffer& out, const Schema& r) {
    record(out, Opcode::schema,
           [&](Encoder& e) { e.put<std::uint16_t>(r.id).text(r.name).text(r.encoding).text(r.data); });
}
void append(Buffer& out, const Channel& r) {
    record(out, Opcode::channel, [&](Encoder& e) {
        e.put<std::uint16_t>(r.id).put<std::uint16_t>(r.schema_id).text(r.topic).text(r.message_encoding);
        put_strings(e, r.metadata);
    });
}
void append(Buffer& out, const Message& r) {
    record(out, Opcode::message, [&](Encoder& e) {
        e.put<std::uint16_t>(r.channel_id).put<std::uint32_t>(r.sequence);
        e.put<std::int64_t>(r.log_time).put<std::int64_t>(r.publish_time).raw(r.data);
    });
}
void append(Buffer& out, const Chunk& r) {
    record(out, Opcode::chunk, [&](Encoder& e) {
        e.put<std::int64_t>(r.start).put<std::int64_t>(r.end).put<std::uint64_t>(r.uncompressed_size);
        e.put<std::uint32_t>(r.uncompressed_crc).text(r.compression).bytes<std::uint64_t>(r.records);
    });
}
void append(Buffer& out, const MessageIndex& r) {
    record(out, Opcode::message_index, [&](Encoder& e) {
        e.put<std::uint16_t>(r.channel_id);
        const auto begin = e.begin();
        for (const auto& [time, offset] : r.entries)
            e.put<std::int64_t>(time).put<std::uint64_t>(offset);
        e.end(begin);
    });
}
void append(Buffer& out, const ChunkIndex& r) {
    record(out, Opcode::chunk_index, [&](Encoder& e) {
        e.put<std::int64_t>(r.start).put<std::int64_t>(r.end);
        e.put<std::uint64_t>(r.offset).put<std::uint64_t>(r.length);
        put_counts(e, r.message_index_offsets);
        e.put<std::uint64_t>(r.message_index_length).text(r.compression);
        e.put<std::uint64_t>(r.compressed_size).put<std::uint64_t>(r.uncompressed_size);
    });
}
void append(Buffer& out, const Attachment& r) {
    record(out, Opcode::attachment, [&](Encoder& e) {
        const std::size_t start = out.size();
        e.put<std::int64_t>(r.log_time).put<std::int64_t>(r.create_time).text(r.name).text(r.media_type);
        e.bytes<std::uint64_t>(r.data);
        e.put<std::uint32_t>(crc32(Bytes(out).subspan(start)));
    });
}
void append(Buffer& out, const AttachmentIndex& r) {
    record(out, Opcode::attachment_index, [&](Encoder& e) {
        e.put<std::uint64_t>(r.offset).put<std::uint64_t>(r.length);
        e.put<std::int64_t>(r.log_time).put<std::int64_t>(r.create_time).put<std::uint64_t>(r.data_size);
        e.text(r.name).text(r.media_type);
    });
}
void append(Buffer& out, const Metadata& r) {
    record(out, Opcode::metadata, [&](Encoder& e) {
        e.text(r.name);
        put_strings(e, r.entries);
    });
}
void append(Buffer& out, const MetadataIndex& r) {
    record(out, Opcode::metadata_index,
           [&](Encoder& e) { e.put<std::uint64_t>(r.offset).put<std::uint64_t>(r.length).text(r.name); });
}
void append(Buffer& out, const Statistics& r) {
    record(out, Opcode::statistics, [&](Encoder& e) {
        e.put<std::uint64_t>(r.messages).put<std::uint16_t>(r.schemas).put<std::uint32_t>(r.channels);
        e.put<std::uint32_t>(r.attachments).put<std::uint32_t>(r.metadata).put<std::uint32_t>(r.chunks);
        e.put<std::int64_t>(r.start).put<std::int64_t>(r.end);
        put_counts(e, r.channel_messages);
    });
}
void append(Buffer& out, const SummaryOffset& r) {
    record(out, Opcode::summary_offset, [&](Encoder& e) {
        e.put<std::uint8_t>(static_cast<std::uint8_t>(r.group));
        e.put<std::uint64_t>(r.start).put<std::uint64_t>(r.length);
    });
}
void append(Buffer& out, const Footer& r) {
    record(out, Opcode::footer, [&](Encoder& e) {
        e.put<std::uint64_t>(r.summary_start).put<std::uint64_t>(r.summary_offset_start);
        e.put<std::uint32_t>(r.summary_crc);
    });
}
void append(Buffer& out, const DataEnd&) {
    // 0: no CRC of the whole data section; each chunk and attachment has its own.
    record(out, Opcode::data_end, [](Encoder& e) { e.put<std::uint32_t>(0); });
}

template <>
Header parse(Bytes content) {
    Decoder in(content);
    Header r;
    r.profile = in.text();
    r.library = in.text();
    return r;
}
template <>
Schema parse(Bytes content) {
    Decoder in(content);
    Schema r;
    r.id = in.get<std::uint16_t>();
    r.name = in.text();
    r.encoding = in.text();
    r.data = in.text();
    return r;
}
template <>
Channel parse(Bytes content) {
    Decoder in(content);
    Channel r;
    r.id = in.get<std::uint16_t>();
    r.schema_id = in.get<std::uint16_t>();
    r.topic = in.text();
    r.message_encoding = in.text();
    r.metadata = get_strings(in);
    return r;
}
template <>
Message parse(Bytes content) {
    Decoder in(content);
    Message r;
    r.channel_id = in.get<std::uint16_t>();
    r.sequence = in.get<std::uint32_t>();
    r.log_time = in.get<std::int64_t>();
    r.publish_time = in.get<std::int64_t>();
    r.data = in.rest();
    return r;
}
template <>
Chunk parse(Bytes content) {
    Decoder in(content);
    Chunk r;
    r.start = in.get<std::int64_t>();
    r.end = in.get<std::int64_t>();
    r.uncompressed_size = in.get<std::uint64_t>();
    r.uncompressed_crc = in.get<std::uint32_t>();
    r.compression = in.text();
    r.records = in.bytes<std::uint64_t>();
    return r;
}
template <>
MessageIndex parse(Bytes content) {
    Decoder in(content);
    MessageIndex r;
    r.channel_id = in.get<std::uint16_t>();
    for (Decoder entries(in.bytes()); !entries.empty();) {
        const auto time = entries.get<std::int64_t>();
        r.entries.emplace_back(time, entries.get<std::uint64_t>());
    }
    return r;
}
template <>
ChunkIndex parse(Bytes content) {
    Decoder in(content);
    ChunkIndex r;
    r.start = in.get<std::int64_t>();
    r.end = in.get<std::int64_t>();
    r.offset = in.get<std::uint64_t>();
    r.length = in.get<std::uint64_t>();
    r.message_index_offsets = get_counts(in);
    r.message_index_length = in.get<std::uint64_t>();
    r.compression = in.text();
    r.compressed_size = in.get<std::uint64_t>();
    r.uncompressed_size = in.get<std::uint64_t>();
    return r;
}
template <>
Attachment parse(Bytes content) {
    Decoder in(content);
    Attachment r;
    r.log_time = in.get<std::int64_t>();
    r.create_time = in.get<std::int64_t>();
    r.name = in.text();
    r.media_type = in.text();
    r.data = in.bytes<std::uint64_t>();
    const Bytes before_crc = content.first(content.size() - in.rest().size());
    if (const auto crc = in.get<std::uint32_t>(); crc != 0 && crc != crc32(before_crc))
        throw Damage("attachment " + r.name + ": its checksum does not fit");
    return r;
}
template <>
AttachmentIndex parse(Bytes content) {
    Decoder in(content);
    AttachmentIndex r;
    r.offset = in.get<std::uint64_t>();
    r.length = in.get<std::uint64_t>();
    r.log_time = in.get<std::int64_t>();
    r.create_time = in.get<std::int64_t>();
    r.data_size = in.get<std::uint64_t>();
    r.name = in.text();
    r.media_type = in.text();
    return r;
}
template <>
Metadata parse(Bytes content) {
    Decoder in(content);
    Metadata r;
    r.name = in.text();
    r.entries = get_strings(in);
    return r;
}
template <>
MetadataIndex parse(Bytes content) {
    Decoder in(content);
    MetadataIndex r;
    r.offset = in.get<std::uint64_t>();
    r.length = in.get<std::uint64_t>();
    r.name = in.text();
    return r;
}
template <>
Statistics parse(Bytes content) {
    Decoder in(content);
    Statistics r;
    r.messages = in.get<std::uint64_t>();
    r.schemas = in.get<std::uint16_t>();
    r.channels = in.get<std::uint32_t>();
    r.attachments = in.get<std::uint32_t>();
    r.metadata = in.get<std::uint32_t>();
    r.chunks = in.get<std::uint32_t>();
    r.start = in.get<std::int64_t>();
    r.end = in.get<std::int64_t>();
    r.channel_messages = get_counts(in);
    return r;
}
template <>
Footer parse(Bytes content) {
    Decoder in(content);
    Footer r;
    r.summary_start = in.get<std::uint64_t>();
    r.summary_offset_start = in.get<std::uint64_t>();
    r.summary_crc = in.get<std::uint32_t>();
    return r;
}

} // namespace windlass::mcap
