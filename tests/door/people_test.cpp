// Who logs in, their passwords, sessions and what is written of it.

#include "door/audit.hpp"
#include "door/people.hpp"
#include "door/private_file.hpp"
#include "door/secrets.hpp"
#include "door/staff_sessions.hpp"
#include "tests/recorder/folder.hpp"

#include <gmock/gmock.h>

namespace windlass::door {
namespace {

using namespace std::chrono_literals;
using test::Folder;
using testing::HasSubstr;
using testing::Not;

namespace fs = std::filesystem;

fs::perms mode(const fs::path& file) {
    return fs::status(file).permissions() & fs::perms::all;
}

TEST(Password, IsKnownByItsHashAloneAndEachHashIsAnother) {
    begin_secrets();
    const std::string hash = password_hash("correct horse");
    EXPECT_THAT(hash, testing::StartsWith("$argon2id$"));
    EXPECT_THAT(hash, Not(HasSubstr("correct")));
    EXPECT_TRUE(is_password(hash, "correct horse"));
    EXPECT_FALSE(is_password(hash, "correct hors"));
    EXPECT_FALSE(is_password("", "correct horse"));
    EXPECT_FALSE(is_password("no hash", "no hash"));
    EXPECT_NE(password_hash("correct horse"), hash);
}

TEST(Secret, IsFoundByItsDigestAlone) {
    begin_secrets();
    const std::string secret = make_secret();
    EXPECT_EQ(secret.size(), 64U);
    EXPECT_NE(make_secret(), secret);
    EXPECT_EQ(digest(secret), digest(secret));
    EXPECT_NE(digest(secret), secret);
    EXPECT_NE(digest(secret), digest(secret + "0"));
}

TEST(People, AreKeptWithoutPasswordsInAFileOfTheirOwn) {
    const Folder folder;
    People people(folder / "people.json");
    EXPECT_TRUE(people.empty());
    people.put({.name = "anna", .rank = Rank::owner, .hash = "h1"});
    people.put({.name = "ben", .rank = Rank::assessor, .hash = "h2"});
    EXPECT_EQ(mode(folder / "people.json"), fs::perms::owner_read | fs::perms::owner_write);
    const People again(folder / "people.json");
    ASSERT_NE(again.find("ben"), nullptr);
    EXPECT_EQ(again.find("ben")->rank, Rank::assessor);
    EXPECT_EQ(again.find("ben")->hash, "h2");
    EXPECT_EQ(again.find("Ben"), nullptr);
    EXPECT_FALSE(fs::exists(folder / "people.json.new"));
}

TEST(People, OneOwnerRemains) {
    const Folder folder;
    People people(folder / "people.json");
    EXPECT_THROW(people.put({.name = "ben", .rank = Rank::instructor, .hash = "h"}), std::runtime_error);
    people.put({.name = "anna", .rank = Rank::owner, .hash = "h"});
    EXPECT_THROW(people.remove("anna"), std::runtime_error);
    EXPECT_THROW(people.put({.name = "anna", .rank = Rank::observer, .hash = "h"}), std::runtime_error);
    EXPECT_EQ(people.find("anna")->rank, Rank::owner);
    people.put({.name = "ben", .rank = Rank::owner, .hash = "h"});
    people.remove("anna");
    EXPECT_EQ(people.find("anna"), nullptr);
}

TEST(People, AFileThatIsNoneIsToldByName) {
    const Folder folder;
    for (const char* text : {"", "[]", "{\"people\": [{}]}",
                             "{\"people\": [{\"name\": \"a\", \"hash\": \"h\", \"rank\": \"king\"}]}"}) {
        test::put(folder / "people.json", text);
        try {
            const People people(folder / "people.json");
            ADD_FAILURE() << text;
        } catch (const std::runtime_error& error) {
            EXPECT_THAT(error.what(), HasSubstr("people.json"));
        }
    }
}

TEST(PlainName, IsOneLineOfTextWithoutBlanksAtItsEnds) {
    EXPECT_EQ(plain_name("  Anna Maria "), "Anna Maria");
    EXPECT_EQ(plain_name("\xC3\x85sa"), "\xC3\x85sa");
    for (const char* none : {"", "   ", "a\nb", "a\x7F", "\xFF", "012345678901234567890123456789012"})
        EXPECT_EQ(plain_name(none), "") << none;
}

TEST(StaffSessions, AStolenCookieIsOfNoUseElsewhere) {
    StaffSessions sessions;
    Clock::time_point now{100h};
    sessions.begin("key", "anna", "192.168.1.7", now);
    EXPECT_EQ(sessions.find("key", "192.168.1.7", now), "anna");
    EXPECT_EQ(sessions.find("key", "192.168.1.8", now), "");
    EXPECT_EQ(sessions.find("other", "192.168.1.7", now), "");
    now += StaffSessions::kUnused;
    EXPECT_EQ(sessions.find("key", "192.168.1.7", now), "anna");
    now += StaffSessions::kUnused + 1s;
    EXPECT_EQ(sessions.find("key", "192.168.1.7", now), "") << "not used for half a day";
}

TEST(StaffSessions, EndByTheirKeyAndByTheirName) {
    StaffSessions sessions;
    const Clock::time_point now{100h};
    for (const char* key : {"1", "2", "3"})
        sessions.begin(key, "anna", "a", now);
    sessions.begin("4", "ben", "a", now);
    sessions.end("1");
    EXPECT_EQ(sessions.find("1", "a", now), "");
    EXPECT_EQ(sessions.find("2", "a", now), "anna");
    EXPECT_THAT(sessions.end_of("anna"), testing::ElementsAre("2", "3"));
    EXPECT_EQ(sessions.find("2", "a", now), "");
    EXPECT_EQ(sessions.find("4", "a", now), "ben");
}

TEST(StaffSessions, AreBoundedAndTheOneNotUsedForLongestGoes) {
    StaffSessions sessions;
    Clock::time_point now{100h};
    for (std::size_t i = 0; i < StaffSessions::kMost; ++i)
        sessions.begin(std::to_string(i), "anna", "a", now += 1s);
    EXPECT_EQ(sessions.find("0", "a", now += 1s), "anna");
    sessions.begin("one more", "anna", "a", now += 1s);
    EXPECT_EQ(sessions.find("0", "a", now), "anna") << "it was used";
    EXPECT_EQ(sessions.find("1", "a", now), "");
}

TEST(Audit, IsOnlyEverAddedTo) {
    const Folder folder;
    std::string failed;
    const Audit audit(folder / "audit.jsonl", [&](const std::string& why) { failed = why; });
    audit.write("login", {{"name", "anna\nmallory"}, {"address", "1.2.3.4"}});
    audit.write("logout", {{"name", "\xFF"}});
    const std::string text = test::content(folder / "audit.jsonl");
    EXPECT_EQ(std::ranges::count(text, '\n'), 2) << "what somebody types makes no line of its own";
    const auto line = nlohmann::json::parse(text.substr(0, text.find('\n')));
    EXPECT_EQ(line["what"], "login");
    EXPECT_EQ(line["name"], "anna\nmallory");
    EXPECT_EQ(line["at"].get<std::string>().size(), 20U);
    EXPECT_EQ(mode(folder / "audit.jsonl"), fs::perms::owner_read | fs::perms::owner_write);
    EXPECT_EQ(failed, "");
    const Audit nowhere(folder / "no/such/folder", [&](const std::string& why) { failed = why; });
    nowhere.write("login", {});
    EXPECT_THAT(failed, HasSubstr("no/such/folder"));
}

TEST(PrivateFolder, IsRefusedWhereOthersMayReadIt) {
    const Folder folder;
    private_folder(folder / "a/door");
    EXPECT_EQ(mode(folder / "a/door"), fs::perms::owner_all);
    private_folder(folder / "a/door");
    fs::permissions(folder / "a/door", fs::perms::group_read, fs::perm_options::add);
    EXPECT_THROW(private_folder(folder / "a/door"), std::runtime_error);
}

} // namespace
} // namespace windlass::door
