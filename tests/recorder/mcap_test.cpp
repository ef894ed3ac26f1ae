// MCAP files: what is written is read again, whole or cut off anywhere, and damage is told.

#include "recorder/mcap/reader.hpp"
#include "recorder/mcap/writer.hpp"

#include "rigs/file_size_limit.hpp"
#include "tests/recorder/folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace windlass::mcap {
namespace {

using test::content;
using test::Folder;
using test::put;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr int kMessages = 400;

/// A message of some 100 bytes that no other has.
std::string text_of(int i) {
    return "message " + std::to_string(i) + std::string(90, static_cast<char>('a' + i % 26));
}

/// 400 messages on two channels, in chunks of some 4 kB, and an attachment in their middle.
void write_file(Writer& writer) {
    const auto schema = writer.add_schema("windlass::Event", "omgidl", "struct Event {};");
    const auto first = writer.add_channel(schema, "Event", "cdr", {{"writer", "01"}});
    const auto second = writer.add_channel(schema, "Event", "cdr", {{"writer", "02"}});
    writer.add_metadata({"windlass.recording", {{"version", "1"}}});
    for (int i = 0; i < kMessages; ++i) {
        const std::string text = text_of(i);
        writer.write(
            {i % 3 == 0 ? second : first, static_cast<std::uint32_t>(i), 1000 + i, 500 + i, as_bytes(text)});
        if (i == kMessages / 2)
            writer.add_attachment({1200, 0, "exercise.json", "application/json", as_bytes("{}")});
    }
}

WriterOptions options(Compression compression = Compression::zstd) {
    return {.compression = compression, .chunk_size = 4096, .library = "test"};
}

/// How many messages can be read, each of them as it was written and in order; -1 when one differs.
int messages_in(Reader& reader) {
    int count = 0;
    for (const auto& chunk : reader.chunks()) {
        bool same = true;
        for_each_record(reader.records(chunk), [&](Opcode opcode, Bytes bytes) {
            if (opcode != Opcode::message) return;
            const auto message = parse<Message>(bytes);
            same = same && as_text(message.data) == text_of(count) && message.log_time == 1000 + count &&
                   message.publish_time == 500 + count &&
                   message.sequence == static_cast<std::uint32_t>(count) &&
                   message.channel_id == (count % 3 == 0 ? 2 : 1);
            ++count;
        });
        if (!same) return -1;
    }
    return count;
}

class EveryCompression : public testing::TestWithParam<Compression> {};

TEST_P(EveryCompression, WhatIsWrittenIsReadAgain) {
    const Folder folder;
    Writer writer(folder / "a.mcap", options(GetParam()));
    write_file(writer);
    writer.close();

    Reader reader(folder / "a.mcap");
    EXPECT_THAT(reader.damage(), IsEmpty());
    EXPECT_EQ(messages_in(reader), kMessages);
    EXPECT_GT(reader.chunks().size(), 10U);
    EXPECT_EQ(reader.schemas().at(1).data, "struct Event {};");
    EXPECT_EQ(reader.channels().at(2).metadata.at("writer"), "02");
    ASSERT_EQ(reader.attachments().size(), 1U);
    EXPECT_EQ(reader.attachments()[0].name, "exercise.json");
    EXPECT_EQ(reader.content(reader.attachments()[0]), "{}");
    ASSERT_EQ(reader.metadata().size(), 1U);
    EXPECT_EQ(reader.metadata()[0].entries.at("version"), "1");
}

INSTANTIATE_TEST_SUITE_P(Compressions, EveryCompression,
                         testing::Values(Compression::none, Compression::lz4, Compression::zstd),
                         [](const auto& info) {
                             const auto name = compression_name(info.param);
                             return name.empty() ? std::string("none") : std::string(name);
                         });

TEST(McapFile, CutOffAnywhereIsReadUpToItsLastWholeChunk) {
    const Folder folder;
    Writer writer(folder / "whole.mcap", options());
    write_file(writer);
    writer.close();
    const std::string whole = content(folder / "whole.mcap");
    const auto chunks = Reader(folder / "whole.mcap").chunks();

    for (std::size_t size = 8; size < whole.size(); size += 61) {
        put(folder / "cut.mcap", whole.substr(0, size));
        Reader reader(folder / "cut.mcap");
        std::size_t expected = 0;
        while (expected < chunks.size() && chunks[expected].offset + chunks[expected].length <= size)
            ++expected;
        ASSERT_EQ(reader.chunks().size(), expected) << "cut at " << size;
        ASSERT_GE(messages_in(reader), 0) << "cut at " << size;
        ASSERT_THAT(reader.damage(), Not(IsEmpty())) << "cut at " << size;
    }
}

TEST(McapFile, DamagedChunkIsToldAndTheOthersAreRead) {
    const Folder folder;
    Writer writer(folder / "a.mcap", options());
    write_file(writer);
    writer.close();
    std::string bytes = content(folder / "a.mcap");
    const auto chunk = Reader(folder / "a.mcap").chunks().at(3);
    bytes.at(chunk.offset + chunk.length - 20) ^= 0x55;
    put(folder / "b.mcap", bytes);

    Reader reader(folder / "b.mcap");
    EXPECT_NO_THROW(reader.records(reader.chunks().at(2)));
    EXPECT_NO_THROW(reader.records(reader.chunks().at(4)));
    try {
        reader.records(reader.chunks().at(3));
        FAIL() << "no error";
    } catch (const Damage& damage) {
        EXPECT_THAT(damage.what(), HasSubstr("chunk at byte " + std::to_string(chunk.offset)));
    }
}

TEST(McapFile, DamagedSummaryIsDoneWithout) {
    const Folder folder;
    Writer writer(folder / "a.mcap", options());
    write_file(writer);
    writer.close();
    std::string bytes = content(folder / "a.mcap");
    bytes.at(bytes.size() - 200) ^= 0x55;
    put(folder / "b.mcap", bytes);

    Reader reader(folder / "b.mcap");
    EXPECT_THAT(reader.damage(), HasSubstr("summary"));
    EXPECT_EQ(messages_in(reader), kMessages);
    EXPECT_EQ(reader.attachments().size(), 1U);
    EXPECT_EQ(reader.metadata().size(), 1U);
}

TEST(McapFile, EveryDamagedByteIsSurvived) {
    const Folder folder;
    Writer writer(folder / "a.mcap", options(Compression::lz4));
    write_file(writer);
    writer.close();
    const std::string whole = content(folder / "a.mcap");
    for (std::size_t at = 8; at < whole.size(); at += 37) {
        std::string bytes = whole;
        bytes.at(at) ^= 0xff;
        put(folder / "b.mcap", bytes);
        Reader reader(folder / "b.mcap"); // no other exception than Damage leaves it
        for (const auto& chunk : reader.chunks()) {
            try {
                reader.records(chunk);
            } catch (const Damage&) {
                continue;
            }
        }
    }
}

TEST(McapFile, OtherFileIsRefusedByName) {
    const Folder folder;
    put(folder / "notes.txt", "anchors aweigh, and more than eight bytes");
    put(folder / "empty.mcap", "");
    for (const char* name : {"notes.txt", "empty.mcap"}) {
        try {
            Reader reader(folder / name);
            FAIL() << "no error";
        } catch (const Damage& damage) {
            EXPECT_THAT(damage.what(), HasSubstr(name));
            EXPECT_THAT(damage.what(), HasSubstr("no MCAP file"));
        }
    }
    EXPECT_THROW(Reader(folder / "missing.mcap"), std::runtime_error);
    EXPECT_THROW(Reader(folder.path()), std::runtime_error);
}

TEST(McapFile, ExistingFileIsNotOverwritten) {
    const Folder folder;
    put(folder / "a.mcap", "mine");
    EXPECT_THROW(Writer(folder / "a.mcap", options()), WriteError);
    EXPECT_EQ(content(folder / "a.mcap"), "mine");
}

TEST(McapFile, RefusedWriteLeavesWholeRecordsAndCountsWhatIsLost) {
    const Folder folder;
    Writer writer(folder / "a.mcap", options(Compression::none));
    {
        const rigs::FileSizeLimit limit(30'000);
        EXPECT_THROW(write_file(writer), WriteError);
    }
    {
        const rigs::FileSizeLimit no_room_for_the_summary(writer.size() + 50);
        EXPECT_THROW(writer.close(), WriteError);
    }
    EXPECT_GT(writer.lost(), 0U);
    EXPECT_LT(writer.lost(), 40U); // one chunk of 4 kB
    Reader reader(folder / "a.mcap");
    const int read = messages_in(reader);
    EXPECT_GT(read, 150); // 30 kB hold some 200 messages, each of 130 bytes with 16 of index
    EXPECT_THAT(reader.damage(), HasSubstr("not closed"));
    EXPECT_THAT(reader.damage(), HasSubstr(", 0 bytes are left out"));

    writer.close(); // now that there is room
    EXPECT_THAT(Reader(folder / "a.mcap").damage(), IsEmpty());
}

} // namespace
} // namespace windlass::mcap
