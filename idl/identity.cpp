#include "idl/identity.hpp"

#include "common/freed_by.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <openssl/pem.h>
#include <openssl/x509.h>

#include <array>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <stdexcept>

namespace windlass::wire {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::system_clock;

using Certificate = std::unique_ptr<X509, FreedBy<X509_free>>;
using RevocationList = std::unique_ptr<X509_CRL, FreedBy<X509_CRL_free>>;
using File = std::unique_ptr<std::FILE, FreedBy<std::fclose>>;

/// One of the files, and the time for which it holds.
struct Paper {
    fs::path file;
    Clock::time_point begins, ends;
};

/// Reads the first such thing of a PEM file.
template <class Thing, class Read>
Thing read(const fs::path& path, Read read_pem, const char* what) {
    const File file(std::fopen(path.c_str(), "r"));
    Thing thing(file ? read_pem(file.get(), nullptr, nullptr, nullptr) : nullptr);
    if (!thing) throw std::runtime_error("security: " + path.string() + " is no " + what + " (PEM)");
    return thing;
}

Clock::time_point time_of(const fs::path& file, const ASN1_TIME* time) {
    std::tm utc{};
    if (time == nullptr || ASN1_TIME_to_tm(time, &utc) != 1)
        throw std::runtime_error("security: " + file.string() + " has a date that is none");
    return Clock::from_time_t(timegm(&utc));
}

Paper paper_of(const fs::path& file, const X509& certificate) {
    return {file, time_of(file, X509_get0_notBefore(&certificate)),
            time_of(file, X509_get0_notAfter(&certificate))};
}

Paper paper_of(const fs::path& file, const X509_CRL& list) {
    const ASN1_TIME* next = X509_CRL_get0_nextUpdate(&list);
    return {file, time_of(file, X509_CRL_get0_lastUpdate(&list)),
            next == nullptr ? Clock::time_point::max() : time_of(file, next)};
}

/// The time in <tag>2026-11-27T16:40:32</tag>, which Fast DDS takes for the machine's own. Nothing where
/// there is none: that is for DDS to refuse.
std::optional<Clock::time_point> time_in(const std::string& text, const std::string& tag) {
    const auto at = text.find("<" + tag + ">");
    std::tm local{};
    if (at == std::string::npos ||
        strptime(text.c_str() + at + tag.size() + 2, "%Y-%m-%dT%H:%M:%S", &local) == nullptr)
        return std::nullopt;
    return Clock::from_time_t(std::mktime(&local));
}

std::optional<Paper> permissions(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    const auto begins = time_in(text, "not_before"), ends = time_in(text, "not_after");
    if (!begins || !ends) return std::nullopt;
    return Paper{file, *begins, *ends};
}

std::string name_of(const X509& certificate) {
    std::array<char, 128> name{};
    const int size = X509_NAME_get_text_by_NID(X509_get_subject_name(&certificate), NID_commonName,
                                               name.data(), static_cast<int>(name.size()));
    return size > 0 ? std::string(name.data()) : "NAME";
}

std::string day(Clock::time_point time) {
    return fmt::format("{:%F %H:%M} UTC", fmt::gmtime(Clock::to_time_t(time)));
}

} // namespace

std::vector<std::string> look_at_identity(const fs::path& folder, Clock::time_point now) {
    const auto own_file = folder / "identity.pem", papers_file = folder / "permissions.smime",
               list_file = folder / "crl.pem";
    const auto own = read<Certificate>(own_file, PEM_read_X509, "certificate");
    std::vector<Paper> papers{paper_of(own_file, *own)};
    for (const char* authority : {"identity_ca.pem", "permissions_ca.pem"}) {
        const auto file = folder / authority;
        papers.push_back(paper_of(file, *read<Certificate>(file, PEM_read_X509, "certificate")));
    }
    if (const auto allowed = permissions(papers_file)) papers.push_back(*allowed);
    if (fs::exists(list_file)) {
        const auto list = read<RevocationList>(list_file, PEM_read_X509_CRL, "list of revoked certificates");
        X509_REVOKED* entry = nullptr;
        if (X509_CRL_get0_by_cert(list.get(), &entry, own.get()) == 1)
            throw std::runtime_error("security: " + own_file.string() + " was revoked on " +
                                     day(time_of(list_file, X509_REVOKED_get0_revocationDate(entry))) +
                                     "; where identities are made: config/security/make_identities FOLDER "
                                     "ROLE NAME makes another");
        papers.push_back(paper_of(list_file, *list));
    }

    std::vector<std::string> endings;
    for (const auto& [file, begins, ends] : papers) {
        const bool own_paper = file == own_file || file == papers_file;
        const std::string remedy =
            "; where identities are made: config/security/make_identities renew FOLDER" +
            (own_paper ? " " + name_of(*own) : "");
        if (now >= ends)
            throw std::runtime_error("security: " + file.string() + " ended on " + day(ends) + remedy);
        if (now < begins)
            throw std::runtime_error("security: " + file.string() + " begins on " + day(begins) +
                                     ", and this computer's clock says " + day(now));
        if (ends - now <= kIdentityWarning)
            endings.push_back(fmt::format("security: {} ends on {}, in {} days{}", file.string(), day(ends),
                                          std::chrono::floor<std::chrono::days>(ends - now).count(), remedy));
    }
    return endings;
}

} // namespace windlass::wire
