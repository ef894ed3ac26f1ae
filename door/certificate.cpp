#include "door/certificate.hpp"

#include "common/freed_by.hpp"

#include "door/private_file.hpp"

#include <openssl/bio.h>
#include <openssl/err.h>
#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/rand.h>
#include <openssl/x509v3.h>

#include <algorithm>
#include <arpa/inet.h>
#include <array>
#include <cstring>
#include <ifaddrs.h>
#include <memory>
#include <net/if.h>
#include <stdexcept>
#include <unistd.h>

namespace windlass::door {

namespace fs = std::filesystem;

namespace {

using Bio = std::unique_ptr<BIO, FreedBy<BIO_free_all>>;
using Key = std::unique_ptr<EVP_PKEY, FreedBy<EVP_PKEY_free>>;
using Paper = std::unique_ptr<X509, FreedBy<X509_free>>;

constexpr long kDay = 24 * 3600; // s
constexpr long kAuthorityDays = 3650, kCertificateDays = 397;

[[noreturn]] void fail(const std::string& what) {
    std::array<char, 256> why{};
    ERR_error_string_n(ERR_get_error(), why.data(), why.size());
    ERR_clear_error();
    throw std::runtime_error(what + ": " + why.data());
}

bool is_address(const std::string& name) {
    std::array<unsigned char, 16> octets{};
    return inet_pton(AF_INET, name.c_str(), octets.data()) == 1 ||
           inet_pton(AF_INET6, name.c_str(), octets.data()) == 1;
}

Key new_key() {
    Key key{EVP_EC_gen("P-256")};
    if (!key) fail("cannot make a key");
    return key;
}

std::string text_of(BIO* bio) {
    char* data = nullptr;
    const long size = BIO_get_mem_data(bio, &data);
    return {data, static_cast<std::size_t>(size)};
}

std::string pem_of(EVP_PKEY* key) {
    const Bio bio{BIO_new(BIO_s_mem())};
    if (PEM_write_bio_PrivateKey(bio.get(), key, nullptr, nullptr, 0, nullptr, nullptr) != 1)
        fail("cannot write a key");
    return text_of(bio.get());
}

std::string pem_of(X509* paper) {
    const Bio bio{BIO_new(BIO_s_mem())};
    if (PEM_write_bio_X509(bio.get(), paper) != 1) fail("cannot write a certificate");
    return text_of(bio.get());
}

Paper read_paper(const fs::path& file) {
    const std::string text = read_file(file);
    const Bio bio{BIO_new_mem_buf(text.data(), static_cast<int>(text.size()))};
    Paper paper{PEM_read_bio_X509(bio.get(), nullptr, nullptr, nullptr)};
    if (!paper) fail(file.string() + ": no certificate in PEM");
    return paper;
}

Key read_key(const fs::path& file) {
    const std::string text = read_file(file);
    const Bio bio{BIO_new_mem_buf(text.data(), static_cast<int>(text.size()))};
    Key key{PEM_read_bio_PrivateKey(bio.get(), nullptr, nullptr, nullptr)};
    if (!key) fail(file.string() + ": no private key in PEM, without a passphrase");
    return key;
}

std::string fingerprint_of(X509* paper) {
    std::array<unsigned char, EVP_MAX_MD_SIZE> octets{};
    unsigned size = 0;
    if (X509_digest(paper, EVP_sha256(), octets.data(), &size) != 1) fail("no fingerprint");
    constexpr const char* kDigits = "0123456789ABCDEF";
    std::string text;
    for (unsigned i = 0; i < size; ++i) {
        if (i > 0) text += ':';
        text += kDigits[octets[i] >> 4];
        text += kDigits[octets[i] & 15];
    }
    return text;
}

void extend(X509* paper, X509* issuer, int what, const std::string& value) {
    X509V3_CTX context;
    X509V3_set_ctx(&context, issuer, paper, nullptr, nullptr, 0);
    X509_EXTENSION* extension = X509V3_EXT_conf_nid(nullptr, &context, what, value.c_str());
    if (extension == nullptr) fail("extension " + value);
    const bool added = X509_add_ext(paper, extension, -1) == 1;
    X509_EXTENSION_free(extension);
    if (!added) fail("extension " + value);
}

/// Not yet signed; good from an hour ago, for clocks that are not right.
Paper blank(EVP_PKEY* key, const std::string& name, long days) {
    Paper paper{X509_new()};
    std::array<unsigned char, 16> serial{};
    if (!paper || RAND_bytes(serial.data(), serial.size()) != 1) fail("cannot make a certificate");
    serial[0] &= 0x7F; // positive
    const std::unique_ptr<BIGNUM, FreedBy<BN_free>> number{BN_bin2bn(serial.data(), serial.size(), nullptr)};
    BN_to_ASN1_INTEGER(number.get(), X509_get_serialNumber(paper.get()));
    X509_set_version(paper.get(), X509_VERSION_3);
    X509_gmtime_adj(X509_getm_notBefore(paper.get()), -3600);
    X509_gmtime_adj(X509_getm_notAfter(paper.get()), days * kDay);
    X509_set_pubkey(paper.get(), key);
    X509_NAME* subject = X509_get_subject_name(paper.get());
    const auto add = [&](const char* field, const std::string& text) {
        X509_NAME_add_entry_by_txt(subject, field, MBSTRING_UTF8,
                                   reinterpret_cast<const unsigned char*>(text.data()),
                                   static_cast<int>(text.size()), -1, 0);
    };
    add("O", "Windlass");
    add("CN", name);
    return paper;
}

void sign(X509* paper, EVP_PKEY* by) {
    if (X509_sign(paper, by, EVP_sha256()) == 0) fail("cannot sign a certificate");
}

/// "permitted;DNS:NAME,permitted;IP:ADDRESS/MASK,...": what the authority may vouch for.
std::string permitted(const std::vector<std::string>& names) {
    std::string list = "permitted;IP:10.0.0.0/255.0.0.0,permitted;IP:172.16.0.0/255.240.0.0,"
                       "permitted;IP:192.168.0.0/255.255.0.0,permitted;IP:127.0.0.0/255.0.0.0,"
                       "permitted;IP:fc00::/fe00::,permitted;IP:fe80::/ffc0::,"
                       "permitted;IP:::1/ffff:ffff:ffff:ffff:ffff:ffff:ffff:ffff";
    for (const std::string& name : names) {
        const bool v6 = name.find(':') != std::string::npos;
        if (!is_address(name))
            list += ",permitted;DNS:" + name;
        else
            list += ",permitted;IP:" + name +
                    (v6 ? "/ffff:ffff:ffff:ffff:ffff:ffff:ffff:ffff" : "/255.255.255.255");
    }
    return list;
}

std::string alternative(const std::string& name) {
    return (is_address(name) ? "IP:" : "DNS:") + name;
}

/// A certificate that has one name too many is good for none.
bool may_vouch_for(X509* issuer, const std::string& name) {
    const std::unique_ptr<NAME_CONSTRAINTS, FreedBy<NAME_CONSTRAINTS_free>> limits{
        static_cast<NAME_CONSTRAINTS*>(X509_get_ext_d2i(issuer, NID_name_constraints, nullptr, nullptr))};
    if (!limits) return true;
    const Paper paper{X509_new()};
    extend(paper.get(), issuer, NID_subject_alt_name, alternative(name));
    X509_check_purpose(paper.get(), -1, 0); // which has it read its own extensions
    return NAME_CONSTRAINTS_check(paper.get(), limits.get()) == X509_V_OK;
}

std::string host_name() {
    std::array<char, 256> name{};
    gethostname(name.data(), name.size() - 1);
    return name.data();
}

void make_authority(const fs::path& paper_file, const fs::path& key_file,
                    const std::vector<std::string>& names) {
    const Key key = new_key();
    const Paper paper = blank(key.get(), "authority of " + host_name(), kAuthorityDays);
    X509_set_issuer_name(paper.get(), X509_get_subject_name(paper.get()));
    extend(paper.get(), paper.get(), NID_basic_constraints, "critical,CA:TRUE,pathlen:0");
    extend(paper.get(), paper.get(), NID_key_usage, "critical,keyCertSign");
    extend(paper.get(), paper.get(), NID_subject_key_identifier, "hash");
    extend(paper.get(), paper.get(), NID_name_constraints, "critical," + permitted(names));
    sign(paper.get(), key.get());
    write_private(key_file, pem_of(key.get()));
    write_private(paper_file, pem_of(paper.get())); // last: with it the authority is there
}

} // namespace

Certificate given_certificate(const fs::path& chain, const fs::path& key) {
    const Paper paper = read_paper(chain);
    const Key its_key = read_key(key);
    if (X509_check_private_key(paper.get(), its_key.get()) != 1)
        fail(key.string() + " is not the key of " + chain.string());
    return {.chain = chain,
            .key = key,
            .authority = {},
            .fingerprint = fingerprint_of(paper.get()),
            .authority_fingerprint = {}};
}

Certificate own_certificate(const fs::path& folder, const std::vector<std::string>& names) {
    const fs::path authority = folder / "authority.crt", authority_key = folder / "authority.key";
    if (!fs::exists(authority)) make_authority(authority, authority_key, names);
    const Paper issuer = read_paper(authority);
    const Key issuer_key = read_key(authority_key);
    const Key key = new_key();
    const Paper paper = blank(key.get(), host_name(), kCertificateDays);
    X509_set_issuer_name(paper.get(), X509_get_subject_name(issuer.get()));
    std::string alternatives;
    std::vector<std::string> left_out;
    for (const std::string& name : names)
        if (may_vouch_for(issuer.get(), name))
            alternatives += (alternatives.empty() ? "" : ",") + alternative(name);
        else
            left_out.push_back(name);
    extend(paper.get(), issuer.get(), NID_basic_constraints, "critical,CA:FALSE");
    extend(paper.get(), issuer.get(), NID_key_usage, "critical,digitalSignature");
    extend(paper.get(), issuer.get(), NID_ext_key_usage, "serverAuth");
    extend(paper.get(), issuer.get(), NID_subject_alt_name, alternatives);
    extend(paper.get(), issuer.get(), NID_authority_key_identifier, "keyid");
    sign(paper.get(), issuer_key.get());
    Certificate made{.chain = folder / "door.crt",
                     .key = folder / "door.key",
                     .authority = authority,
                     .fingerprint = fingerprint_of(paper.get()),
                     .authority_fingerprint = fingerprint_of(issuer.get()),
                     .left_out = std::move(left_out)};
    write_private(made.key, pem_of(key.get()));
    write_private(made.chain, pem_of(paper.get()) + pem_of(issuer.get()));
    return made;
}

std::vector<std::string> own_names() {
    const std::string host = host_name();
    std::vector<std::string> names{"localhost", host};
    if (host.find('.') == std::string::npos) names.push_back(host + ".local");
    ifaddrs* all = nullptr;
    if (getifaddrs(&all) == 0) {
        for (const ifaddrs* each = all; each != nullptr; each = each->ifa_next) {
            if (each->ifa_addr == nullptr || (each->ifa_flags & IFF_UP) == 0) continue;
            std::array<char, INET6_ADDRSTRLEN> text{};
            const int family = each->ifa_addr->sa_family;
            const void* octets = family == AF_INET
                                     ? static_cast<const void*>(
                                           &reinterpret_cast<const sockaddr_in*>(each->ifa_addr)->sin_addr)
                                     : &reinterpret_cast<const sockaddr_in6*>(each->ifa_addr)->sin6_addr;
            if ((family == AF_INET || family == AF_INET6) &&
                inet_ntop(family, octets, text.data(), text.size()) != nullptr)
                names.emplace_back(text.data());
        }
        freeifaddrs(all);
    }
    std::ranges::sort(names);
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

} // namespace windlass::door
