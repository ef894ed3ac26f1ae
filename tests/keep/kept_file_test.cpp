// The file in which an exercise is kept: what was being written is told from what is damaged.

#include "server/keep/kept_file.hpp"

#include "rigs/file_size_limit.hpp"
#include "tests/recorder/folder.hpp"

#include <gmock/gmock.h>

#include <cstring>

namespace windlass::keep {
namespace {

using test::content;
using test::Folder;
using test::put;
using testing::HasSubstr;
using testing::Property;

constexpr std::size_t kHead = 9; // of a record, before its payload

std::vector<std::uint8_t> bytes_of(const std::string& text) {
    return {text.begin(), text.end()};
}

std::string text_of(const KeptContents::Entry& entry) {
    return {entry.payload.begin(), entry.payload.end()};
}

void add_synced(KeptWriter& writer, std::uint64_t size) {
    std::array<std::uint8_t, sizeof size> payload{};
    std::memcpy(payload.data(), &size, sizeof size);
    writer.add(Record::synced, payload);
}

/// A file of three orders, of which the disk is known to have the first two.
class KeptFile : public testing::Test {
protected:
    KeptFile() {
        KeptWriter writer(path_);
        writer.add(Record::order, bytes_of("hold on"));
        writer.add(Record::order, bytes_of(""));
        writer.write();
        writer.sync();
        synced_ = writer.size();
        add_synced(writer, synced_);
        writer.add(Record::order, bytes_of("veer to four"));
        writer.write();
        whole_ = content(path_);
    }

    /// How many of the orders are read, and that they are the first ones.
    std::size_t orders() const {
        const KeptContents contents(path_);
        std::vector<std::string> found;
        for (const auto& entry : contents.entries())
            if (entry.kind == Record::order) found.push_back(text_of(entry));
        const std::vector<std::string> all{"hold on", "", "veer to four"};
        EXPECT_TRUE(std::equal(found.begin(), found.end(), all.begin()));
        return found.size();
    }

    const Folder folder_;
    const std::filesystem::path path_ = folder_ / "000001.kept";
    std::uint64_t synced_ = 0;
    std::string whole_;
};

TEST_F(KeptFile, GivesBackWhatWasWritten) {
    EXPECT_EQ(orders(), 3U);
    EXPECT_EQ(KeptContents(path_).cut_off(), 0U);
}

TEST_F(KeptFile, TornAtAnyByteGivesTheRecordsBeforeThatAreWhole) {
    const std::size_t first = 8 + kHead + 7, second = first + kHead, third = whole_.size();
    for (std::size_t size = 0; size < whole_.size(); ++size) {
        put(path_, whole_.substr(0, size));
        EXPECT_EQ(orders(),
                  (size >= first ? 1U : 0U) + (size >= second ? 1U : 0U) + (size >= third ? 1U : 0U))
            << "of " << size << " bytes";
    }
}

// After a power cut a file may be as long as it was and have nothing at its end.
TEST_F(KeptFile, EndThatIsAllZeroIsCutOff) {
    put(path_, whole_.substr(0, synced_) + std::string(5000, '\0'));
    EXPECT_EQ(orders(), 2U);
    EXPECT_EQ(KeptContents(path_).cut_off(), 5000U);
}

// And nothing at its beginning, where the power went within a second of its first word.
TEST_F(KeptFile, BeginningThatIsAllZeroHoldsNothingUnlessTheDiskHadIt) {
    put(path_, std::string(5000, '\0'));
    EXPECT_EQ(orders(), 0U);
    EXPECT_EQ(KeptContents(path_).cut_off(), 5000U);
    put(path_, std::string(synced_, '\0') + whole_.substr(synced_));
    EXPECT_THAT(
        [&] { const KeptContents contents(path_); },
        testing::Throws<KeptError>(Property(&KeptError::what, HasSubstr("damaged: the record at byte 0"))));
}

TEST_F(KeptFile, WrongByteThatTheDiskHadIsDamageAndNamesTheFile) {
    for (std::size_t at = 0; at < synced_; ++at) {
        std::string wrong = whole_;
        wrong[at] = static_cast<char>(wrong[at] ^ 1);
        put(path_, wrong);
        EXPECT_THAT([&] { const KeptContents contents(path_); },
                    testing::Throws<KeptError>(Property(&KeptError::what, HasSubstr(path_.string()))))
            << "byte " << at;
    }
}

TEST_F(KeptFile, WrongByteBehindWhatTheDiskHadCutsTheRestOff) {
    for (std::size_t at = synced_; at < whole_.size(); ++at) {
        std::string wrong = whole_;
        wrong[at] = static_cast<char>(wrong[at] ^ 1);
        put(path_, wrong);
        EXPECT_EQ(orders(), 2U) << "byte " << at;
    }
}

TEST_F(KeptFile, OfAnotherFormatIsRefusedInASentence) {
    std::string other = whole_;
    other[6] = 9;
    put(path_, other);
    EXPECT_THAT([&] { const KeptContents contents(path_); },
                testing::Throws<KeptError>(Property(
                    &KeptError::what, path_.string() +
                                          ": format 9 is not allowed: this version of the server keeps in "
                                          "format 2")));
    put(path_, "a shopping list");
    EXPECT_THAT(
        [&] { const KeptContents contents(path_); },
        testing::Throws<KeptError>(Property(&KeptError::what, HasSubstr("not a file of kept exercises"))));
}

TEST_F(KeptFile, FullDiskCutsOffWhatWasHalfWritten) {
    std::filesystem::remove(path_);
    KeptWriter writer(path_);
    writer.add(Record::order, bytes_of("hold on"));
    writer.write();
    const std::string before = content(path_);
    {
        const rigs::FileSizeLimit limit(before.size() + 100);
        writer.add(Record::order, bytes_of(std::string(5000, 'x')));
        EXPECT_THAT([&] { writer.write(); },
                    testing::Throws<KeptError>(
                        Property(&KeptError::what, path_.string() + ": cannot write: File too large")));
    }
    EXPECT_EQ(content(path_), before);
    writer.add(Record::order, bytes_of(""));
    writer.write();
    EXPECT_EQ(orders(), 2U);
}

TEST_F(KeptFile, IsNotWrittenOver) {
    EXPECT_THROW(KeptWriter{path_}, KeptError);
    EXPECT_EQ(content(path_), whole_);
}

} // namespace
} // namespace windlass::keep
