// What make_identities makes, and what is told of it before DDS looks. wire_security_test has what DDS does
// with it.

#include "tests/wire/identities.hpp"

#include "idl/identity.hpp"

#include <gmock/gmock.h>

#include <chrono>
#include <set>
#include <sstream>

namespace windlass::test {

namespace {

using std::chrono::days;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;
namespace fs = std::filesystem;

const auto kToday = std::chrono::system_clock::now();

/// What `openssl` says.
std::string openssl(const std::string& arguments) {
    const auto ending = run("openssl " + arguments);
    EXPECT_EQ(ending.code, 0) << arguments << ending.text;
    return ending.output;
}
std::string certificate(const fs::path& file) {
    return openssl("x509 -noout -text -in " + file.string());
}

/// Of look_at_identity, the error that it throws.
std::string error_of(const fs::path& folder, std::chrono::system_clock::time_point now) {
    try {
        wire::look_at_identity(folder, now);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

TEST(Identities, FolderIsPrivateAndWhatIsThereStays) {
    const Identities all;
    const auto key = [&] { return run("cat " + all.of("trainee/key.pem")).text; };
    const auto before = key();
    EXPECT_EQ(fs::status(all.folder()).permissions(), fs::perms::owner_all);
    EXPECT_EQ(fs::status(all.authorities() / "permissions.key").permissions(),
              fs::perms::owner_read | fs::perms::owner_write);
    EXPECT_EQ(all.make("").code, 0);
    EXPECT_EQ(key(), before);
    EXPECT_EQ(all.make("trainee trainee-2").code, 0);
    EXPECT_TRUE(fs::exists(all.of("trainee-2/permissions.smime")));
    EXPECT_EQ(all.make("trainee trainee-2").code, 1);
    // Permissions from before roles.txt was changed are signed anew, for the same key.
    for (const std::string name : {"trainee", "trainee-2"}) {
        const fs::path papers = all.of(name + "/permissions.smime");
        put(papers, "of last year");
        fs::last_write_time(papers, fs::file_time_type::clock::now() - std::chrono::hours(24 * 365));
        EXPECT_EQ(all.make("").code, 0);
        EXPECT_THAT(content(papers), HasSubstr("<subject_name>CN=" + name + ",serialNumber="));
        EXPECT_THAT(content(papers), HasSubstr("<topic>WindlassCommand</topic>"));
    }
    EXPECT_EQ(key(), before);
    EXPECT_EQ(all.make("captain x").code, 2);
    EXPECT_EQ(all.make("trainee ../x").code, 2);
}

TEST(Identities, AuthoritiesKeysAreInNoFolderThatIsHandedOut) {
    const Identities all;
    ASSERT_EQ(all.make("trainee seat-3 --exercise bay-3").code, 0);
    ASSERT_EQ(all.make("seat-3 server", "renew").code, 0);
    std::set<std::string> authorities;
    for (const char* key : {"identity.key", "permissions.key"})
        authorities.insert(openssl("pkey -pubout -in " + (all.authorities() / key).string()));
    int keys = 0;
    for (const auto& file : fs::recursive_directory_iterator(all.folder())) {
        if (!file.is_regular_file()) continue;
        EXPECT_EQ(file.status().permissions(), fs::perms::owner_read | fs::perms::owner_write) << file;
        if (content(file).find("PRIVATE KEY") == std::string::npos) continue;
        ++keys;
        EXPECT_EQ(file.path().filename(), "key.pem");
        EXPECT_FALSE(authorities.contains(openssl("pkey -pubout -in " + file.path().string()))) << file;
    }
    EXPECT_EQ(keys, 15) << "one for each role, and seat-3";
    EXPECT_EQ(authorities.size(), 2U);
    for (const auto& file : fs::recursive_directory_iterator(all.authorities()))
        EXPECT_EQ(file.status().permissions() & (fs::perms::group_all | fs::perms::others_all),
                  fs::perms::none)
            << file;
    EXPECT_EQ(fs::status(all.authorities()).permissions(), fs::perms::owner_all);
    const auto inside = all.make("--ca " + all.of("ca"));
    EXPECT_EQ(inside.code, 2);
    EXPECT_THAT(inside.text, HasSubstr("is handed out, and the authorities' keys are not"));
}

TEST(Identities, MachineWithAFolderThatItWasGivenMakesNoAuthorities) {
    const Identities all;
    fs::rename(all.authorities(), all.folder().string() + ".elsewhere");
    fs::remove_all(all.of("server"));
    const auto nothing = all.make("");
    EXPECT_EQ(nothing.code, 0);
    EXPECT_THAT(nothing.text, HasSubstr("has what another machine gave it"));
    EXPECT_FALSE(fs::exists(all.authorities()));
    EXPECT_FALSE(fs::exists(all.of("server")));
    for (const auto& [more, command] :
         {std::pair("trainee x", ""), std::pair("trainee", "renew"), std::pair("trainee", "revoke")}) {
        const auto refused = all.make(more, command);
        EXPECT_EQ(refused.code, 1);
        EXPECT_THAT(refused.text, HasSubstr("where are they (--ca CA)?"));
    }
    EXPECT_EQ(all.make("--ca " + all.folder().string() + ".elsewhere").code, 0);
    EXPECT_TRUE(fs::exists(all.of("server/identity.pem")));
}

TEST(Identities, CertificatesAreOfVersionThreeAndSayWhatTheyAreFor) {
    const Identities all;
    for (const char* name : {"server", "trainee"}) {
        const auto text = certificate(all.of(name) + "/identity.pem");
        EXPECT_THAT(text, AllOf(HasSubstr("Version: 3 "),
                                HasSubstr("Basic Constraints: critical\n                CA:FALSE"),
                                HasSubstr("Key Usage: critical\n                Digital Signature\n"),
                                HasSubstr("TLS Web Client Authentication, TLS Web Server Authentication"),
                                HasSubstr("Subject Key Identifier"), HasSubstr("Authority Key Identifier"),
                                HasSubstr(std::string("CN = ") + name)));
    }
    EXPECT_THAT(certificate(all.of("trainee") + "/identity_ca.pem"),
                AllOf(HasSubstr("Version: 3 "),
                      HasSubstr("Basic Constraints: critical\n                CA:TRUE, pathlen:0"),
                      HasSubstr("Key Usage: critical\n                Certificate Sign, CRL Sign\n"),
                      HasSubstr("Subject Key Identifier"), HasSubstr("Authority Key Identifier")));
    EXPECT_THAT(certificate(all.of("trainee") + "/permissions_ca.pem"),
                AllOf(HasSubstr("CA:TRUE, pathlen:0"), HasSubstr("Digital Signature, Certificate Sign\n")));
    // 128 random bits, and the subject has them too.
    std::set<std::string> serials;
    for (const auto& identity : fs::directory_iterator(all.folder())) {
        auto serial =
            openssl("x509 -noout -serial -in " + (identity.path() / "identity.pem").string()).substr(7);
        serials.insert(serial);
        EXPECT_GE(serial.size(), 29U) << serial;
    }
    EXPECT_EQ(serials.size(), 14U);
    const auto in = [&](const std::string& file, int seconds) {
        return run("openssl x509 -noout -checkend " + std::to_string(seconds) + " -in " + all.of(file))
                   .code == 0;
    };
    constexpr int kDay = 86400;
    EXPECT_TRUE(in("trainee/identity.pem", 729 * kDay));
    EXPECT_FALSE(in("trainee/identity.pem", 731 * kDay));
    EXPECT_TRUE(in("trainee/identity_ca.pem", 3649 * kDay));
    EXPECT_FALSE(in("trainee/identity_ca.pem", 3651 * kDay));
}

TEST(Identities, IdentityOfOneExerciseNamesItsPartitionsOnly) {
    const Identities all;
    ASSERT_EQ(all.make("trainee seat-3 --exercise bay-3").code, 0);
    const auto partitions = [&](const std::string& name) {
        std::set<std::string> found;
        std::istringstream text(content(all.of(name) + "/permissions.smime"));
        for (std::string line; std::getline(text, line);)
            if (const auto at = line.find("<partition>"); at != std::string::npos)
                found.insert(line.substr(at + 11, line.find("</") - at - 11));
        return found;
    };
    const std::set<std::string> own{"exercise/bay-3", "exercise/replay-bay-3", "exercise/replay-bay-3-*",
                                    "classroom"};
    EXPECT_EQ(partitions("seat-3"), own);
    ASSERT_EQ(all.make("seat-3", "renew").code, 0);
    EXPECT_EQ(partitions("seat-3"), own) << "renewed, it is of that exercise still";
    EXPECT_THAT(all.make("", "list").output, HasSubstr("trainee      bay-3 "));
    EXPECT_EQ(partitions("trainee"), (std::set<std::string>{"exercise/*", "exercise/replay*", "classroom"}));
    for (const char* bad : {"trainee x --exercise replay-1", "trainee x --exercise 'a b'", "--exercise bay-3",
                            "trainee x --exercise 'bay*'", "trainee x --exercise ''", "trainee x --exercise"})
        EXPECT_EQ(all.make(bad).code, 2) << bad;
}

TEST(Identities, EndIsToldOfThirtyDaysBefore) {
    const Identities all;
    const fs::path trainee = all.of("trainee");
    EXPECT_THAT(wire::look_at_identity(trainee, kToday + days(699)), IsEmpty());
    const auto told = wire::look_at_identity(trainee, kToday + days(701));
    ASSERT_THAT(told, SizeIs(1)) << "papers end a day later";
    EXPECT_THAT(told.front(), AllOf(HasSubstr("trainee/identity.pem ends on 20"), HasSubstr(", in 29 days;"),
                                    HasSubstr("config/security/make_identities renew FOLDER trainee")));
    EXPECT_THAT(wire::look_at_identity(trainee, kToday + days(702)),
                ElementsAre(HasSubstr("identity.pem"), HasSubstr("permissions.smime ends on")));
    EXPECT_THAT(error_of(trainee, kToday + days(731)),
                AllOf(HasSubstr("trainee/identity.pem ended on 20"),
                      HasSubstr("make_identities renew FOLDER trainee")));
    EXPECT_THAT(error_of(trainee, kToday - days(2)),
                AllOf(HasSubstr("begins on"), HasSubstr("this computer's clock says")));
    // What the authorities and their list end is told likewise: all identities are renewed then.
    ASSERT_EQ(all.make("trainee --days 3650", "renew").code, 0);
    for (const char* paper : {"identity.pem", "identity_ca.pem", "permissions_ca.pem", "crl.pem"})
        EXPECT_THAT(wire::look_at_identity(trainee, kToday + days(3630)),
                    testing::Contains(HasSubstr(paper)));
    fs::remove(trainee / "crl.pem");
    EXPECT_THAT(wire::look_at_identity(trainee, kToday), IsEmpty()) << "those of before have none";
    put(trainee / "identity.pem", "of last year");
    EXPECT_THAT(error_of(trainee, kToday), HasSubstr("identity.pem is no certificate (PEM)"));
}

TEST(Identities, RenewalIsOneCommandAndGivesANewKey) {
    const Identities all;
    const auto key = [&](const std::string& name) { return content(all.of(name) + "/key.pem"); };
    const auto trainee = key("trainee"), server = key("server");
    ASSERT_EQ(all.make("trainee --days 20").code, 2) << "a role, and no name";
    ASSERT_EQ(all.make("trainee --days 20", "renew").code, 0);
    EXPECT_NE(key("trainee"), trainee);
    EXPECT_EQ(key("server"), server);
    EXPECT_THAT(wire::look_at_identity(all.of("trainee"), kToday), SizeIs(2));
    ASSERT_EQ(all.make("", "renew").code, 0);
    EXPECT_THAT(wire::look_at_identity(all.of("trainee"), kToday), IsEmpty());
    EXPECT_NE(key("server"), server);
    const auto unknown = all.make("server nobody", "renew");
    EXPECT_EQ(unknown.code, 1);
    EXPECT_THAT(unknown.text, HasSubstr("there is no identity nobody"));
    for (const char* bad : {"--days 0", "--days 3651", "--days x", "--days", "--months 3"})
        EXPECT_EQ(all.make(bad, "renew").code, 2) << bad;
    // Authorities that would end before what they vouch for are renewed with all the rest.
    const auto authority = content(all.of("door") + "/identity_ca.pem");
    ASSERT_EQ(all.make("--days 3650", "renew").code, 0);
    EXPECT_NE(content(all.of("door") + "/identity_ca.pem"), authority);
    EXPECT_EQ(run("openssl verify -CAfile " + all.of("door/identity_ca.pem") + " -crl_check -CRLfile " +
                  all.of("door/crl.pem") + " " + all.of("door/identity.pem"))
                  .code,
              0);
}

TEST(Identities, RevocationIsOneCommandAndReachesEveryFolder) {
    const Identities all;
    const Folder elsewhere;
    const auto copy = elsewhere / "copy";
    ASSERT_EQ(all.make("trainee seat-3").code, 0);
    fs::copy(all.of("seat-3"), copy);
    ASSERT_EQ(all.make("seat-3", "renew").code, 0);
    const auto revoked = all.make("seat-3", "revoke");
    ASSERT_EQ(revoked.code, 0) << revoked.text;
    EXPECT_THAT(revoked.text, HasSubstr("start the server anew"));
    EXPECT_FALSE(fs::exists(all.of("seat-3")));
    const auto list = content(all.authorities() / "crl.pem");
    for (const auto& identity : fs::directory_iterator(all.folder()))
        EXPECT_EQ(content(identity.path() / "crl.pem"), list) << identity;
    const auto revocations = openssl("crl -noout -text -in " + all.of("server/crl.pem"));
    EXPECT_THAT(
        revocations,
        HasSubstr(openssl("x509 -noout -serial -in " + (copy / "identity.pem").string()).substr(7, 32)));
    EXPECT_EQ(error_of(copy, kToday), "") << "its own list is of before";
    put(copy / "crl.pem", list);
    EXPECT_THAT(error_of(copy, kToday), HasSubstr("copy/identity.pem was revoked on 20"));
    EXPECT_THAT(all.make("seat-3", "revoke").text, HasSubstr("there is no identity seat-3"));
    EXPECT_THAT(all.make("s.rver", "revoke").text, HasSubstr("there is no identity s.rver"));
    for (const char* bad : {"", "../copy", "ca", "'a b'"})
        EXPECT_EQ(all.make(bad, "revoke").code, 2) << bad;
    // Another of that name has its own certificate.
    ASSERT_EQ(all.make("trainee seat-3").code, 0);
    EXPECT_THAT(wire::look_at_identity(all.of("seat-3"), kToday), IsEmpty());
}

TEST(Identities, AuthoritiesKeysAreEncryptedWhenAsked) {
    const Identities all;
    const Folder elsewhere;
    const auto file = [&](const char* name, const char* words) {
        put(elsewhere / name, words);
        return " --passphrase-file " + (elsewhere / name).string();
    };
    const auto good = file("good", "anchor watch at night\n"), bad = file("bad", "anchor watch by day\n"),
               brief = file("brief", "chain\n");
    EXPECT_THAT(all.make("--encrypt" + brief).text, HasSubstr("10 characters at least"));
    EXPECT_THAT(content(all.authorities() / "identity.key"), Not(HasSubstr("ENCRYPTED")));
    ASSERT_EQ(all.make("--encrypt" + good).code, 0);
    for (const char* key : {"identity.key", "permissions.key"}) {
        EXPECT_THAT(content(all.authorities() / key), HasSubstr("BEGIN ENCRYPTED PRIVATE KEY"));
        EXPECT_EQ(fs::status(all.authorities() / key).permissions(),
                  fs::perms::owner_read | fs::perms::owner_write);
    }
    EXPECT_EQ(all.make("--encrypt" + good).code, 1) << "they are already";
    EXPECT_EQ(all.make("", "", "setsid -w").code, 0) << "with nothing to sign none is asked for";
    for (const auto& [more, command] :
         {std::pair("trainee seat-1", ""), std::pair("server", "renew"), std::pair("server", "revoke")}) {
        const auto none = all.make(more, command, "setsid -w"); // without a terminal
        EXPECT_EQ(none.code, 1);
        EXPECT_THAT(none.text, HasSubstr("there is no terminal to ask at: --passphrase-file FILE"));
        const auto wrong = all.make(more + bad, command);
        EXPECT_EQ(wrong.code, 1);
        EXPECT_THAT(wrong.text, HasSubstr("this passphrase does not open"));
        EXPECT_EQ(all.make(more + good, command).code, 0) << command << " " << more;
    }
    EXPECT_EQ(all.make("trainee seat-2", "", "WINDLASS_CA_PASSPHRASE='anchor watch at night'").code, 0);
    EXPECT_THAT(all.make("trainee seat-4 --passphrase-file /nowhere").text,
                HasSubstr("/nowhere: no line in it"));
}

TEST(Identities, FolderOfBeforeIsTakenOverWithItsKeys) {
    // As it was: the authorities within, certificates of version 1 and no record of them.
    const Folder place;
    const auto folder = (place / "old").string();
    const auto made =
        run("set -e; umask 077; mkdir -p " + folder + "/ca; cd " + folder +
            "/ca; for of in identity permissions; do "
            "openssl ecparam -name prime256v1 -genkey -noout -out $of.key; "
            "openssl req -x509 -new -sha256 -key $of.key -days 3650 -subj \"/O=Windlass/CN=$of authority\" "
            "-out ${of}_ca.pem; done; for name in server trainee; do mkdir ../$name; cd ../$name; "
            "cp ../ca/*_ca.pem .; openssl ecparam -name prime256v1 -genkey -noout -out key.pem; "
            "openssl req -new -key key.pem -subj /O=Windlass/CN=$name | "
            "openssl x509 -req -CA identity_ca.pem -CAkey ../ca/identity.key "
            "-set_serial 0x$(openssl rand -hex 8) -days 3650 -out identity.pem; done");
    ASSERT_EQ(made.code, 0) << made.text;
    const auto make = [&](const std::string& command, const std::string& more) {
        return run(WINDLASS_SECURITY_DIR "/make_identities " + command + " " + folder + " " + more);
    };
    const auto key = content(folder + "/trainee/key.pem"), authority = content(folder + "/ca/identity.key");
    ASSERT_THAT(certificate(folder + "/trainee/identity.pem"), HasSubstr("Version: 1 "));
    const auto taken = make("", "");
    ASSERT_EQ(taken.code, 0) << taken.text;
    EXPECT_THAT(taken.text, HasSubstr("no longer in what is handed out"));
    EXPECT_FALSE(fs::exists(folder + "/ca"));
    EXPECT_EQ(content(folder + ".ca/identity.key"), authority);
    EXPECT_EQ(content(folder + "/trainee/key.pem"), key);
    EXPECT_TRUE(fs::exists(folder + "/trainee/crl.pem"));
    EXPECT_THAT(content(folder + "/trainee/permissions.smime"),
                HasSubstr("<subject_name>CN=trainee,O=Windlass<"));
    EXPECT_TRUE(fs::exists(folder + "/observer/identity.pem")) << "the other roles are made";
    const auto serial = openssl("x509 -noout -serial -in " + folder + "/trainee/identity.pem").substr(7, 14);
    ASSERT_EQ(make("renew", "trainee").code, 0);
    EXPECT_THAT(certificate(folder + "/trainee/identity.pem"), HasSubstr("Version: 3 "));
    ASSERT_EQ(make("revoke", "trainee").code, 0);
    EXPECT_THAT(openssl("crl -noout -text -in " + folder + "/server/crl.pem"), HasSubstr(serial))
        << "that of before too";
}

} // namespace
} // namespace windlass::test
