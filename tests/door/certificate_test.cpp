// The door's own authority: what it vouches for, and that it stays the same.

#include "door/certificate.hpp"
#include "door/private_file.hpp"
#include "tests/recorder/folder.hpp"

#include <gmock/gmock.h>

#include <cstdio>

namespace windlass::door {
namespace {

using test::Folder;
using testing::ElementsAre;
using testing::HasSubstr;
namespace fs = std::filesystem;

/// What openssl(1) says, and its exit code.
std::pair<int, std::string> openssl(const std::string& arguments) {
    FILE* pipe = popen(("openssl " + arguments + " 2>&1").c_str(), "r");
    std::string text;
    char part[4096];
    for (std::size_t n = 0; (n = fread(part, 1, sizeof part, pipe)) > 0;)
        text.append(part, n);
    return {pclose(pipe), text};
}

const std::vector<std::string> kNames{"localhost", "classroom.local", "127.0.0.1", "192.168.1.5", "::1"};

TEST(OwnCertificate, IsOneThatEveryBrowserOfTheHouseTakesOnceItKnowsTheAuthority) {
    const Folder folder;
    const Certificate made = own_certificate(folder.path(), kNames);
    EXPECT_THAT(made.left_out, testing::IsEmpty());
    for (const char* check : {"-verify_hostname classroom.local", "-verify_hostname localhost",
                              "-verify_ip 192.168.1.5", "-verify_ip ::1"}) {
        const auto [code, text] = openssl("verify -purpose sslserver -x509_strict -CAfile " +
                                          made.authority.string() + " " + check + " " + made.chain.string());
        EXPECT_EQ(code, 0) << check << text;
    }
    EXPECT_NE(openssl("verify -CAfile " + made.authority.string() + " -verify_hostname elsewhere " +
                      made.chain.string())
                  .first,
              0);
    const auto [code, text] = openssl("x509 -in " + made.chain.string() +
                                      " -noout -fingerprint -sha256 -ext keyUsage,extendedKeyUsage");
    EXPECT_THAT(text, HasSubstr(made.fingerprint));
    EXPECT_THAT(text, HasSubstr("TLS Web Server Authentication"));
}

TEST(OwnCertificate, OfTheNextStartIsAnotherByTheSameAuthority) {
    const Folder folder;
    const Certificate first = own_certificate(folder.path(), kNames);
    const Certificate second = own_certificate(folder.path(), {"localhost", "192.168.77.1"});
    EXPECT_EQ(second.authority_fingerprint, first.authority_fingerprint);
    EXPECT_NE(second.fingerprint, first.fingerprint);
    EXPECT_EQ(openssl("verify -CAfile " + second.authority.string() + " -verify_ip 192.168.77.1 " +
                      second.chain.string())
                  .first,
              0)
        << "an address of a private network that came later";
}

TEST(OwnCertificate, VouchesForNothingElse) {
    const Folder folder;
    own_certificate(folder.path(), kNames);
    const Certificate made = own_certificate(folder.path(), {"localhost", "bank.example", "8.8.8.8"});
    EXPECT_THAT(made.left_out, ElementsAre("bank.example", "8.8.8.8"));
    EXPECT_EQ(openssl("verify -CAfile " + made.authority.string() + " -verify_hostname localhost " +
                      made.chain.string())
                  .first,
              0);
    EXPECT_NE(openssl("verify -CAfile " + made.authority.string() + " -verify_hostname bank.example " +
                      made.chain.string())
                  .first,
              0);
}

TEST(OwnCertificate, KeysAreNobodyElsesToRead) {
    const Folder folder;
    own_certificate(folder.path(), kNames);
    for (const char* file : {"authority.key", "door.key"})
        EXPECT_EQ(fs::status(folder / file).permissions() & fs::perms::all,
                  fs::perms::owner_read | fs::perms::owner_write)
            << file;
}

TEST(GivenCertificate, IsTakenWithItsOwnKeyOnly) {
    const Folder one, other;
    const Certificate a = own_certificate(one.path(), kNames), b = own_certificate(other.path(), kNames);
    EXPECT_EQ(given_certificate(a.chain, a.key).fingerprint, a.fingerprint);
    EXPECT_TRUE(given_certificate(a.chain, a.key).authority.empty());
    EXPECT_THROW(given_certificate(a.chain, b.key), std::runtime_error);
    test::put(one / "none.pem", "no certificate");
    try {
        given_certificate(one / "none.pem", a.key);
        ADD_FAILURE();
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), HasSubstr("none.pem"));
    }
    EXPECT_THROW(given_certificate(a.chain, one / "none.pem"), std::runtime_error);
    EXPECT_THROW(given_certificate(one / "missing.pem", a.key), std::runtime_error);
}

TEST(OwnNames, HaveThisComputerAmongThem) {
    EXPECT_THAT(own_names(), testing::IsSupersetOf({"localhost", "127.0.0.1"}));
}

} // namespace
} // namespace windlass::door
