#include "idl/security.hpp"

#include "idl/identity.hpp"

#include <fastrtps/config.h> // HAVE_SECURITY

#include <array>
#include <fstream>
#include <iostream>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>

namespace windlass::wire {

// Without it the properties below would be passed over in silence, and all would be open.
static_assert(HAVE_SECURITY, "this Fast DDS is built without DDS Security");

namespace {

namespace fs = std::filesystem;

struct Property {
    const char* name;
    const char* file;
};

constexpr std::array kFiles{
    Property{"dds.sec.auth.builtin.PKI-DH.identity_ca", "identity_ca.pem"},
    Property{"dds.sec.auth.builtin.PKI-DH.identity_certificate", "identity.pem"},
    Property{"dds.sec.auth.builtin.PKI-DH.private_key", "key.pem"},
    Property{"dds.sec.access.builtin.Access-Permissions.permissions_ca", "permissions_ca.pem"},
    Property{"dds.sec.access.builtin.Access-Permissions.governance", "governance.smime"},
    Property{"dds.sec.access.builtin.Access-Permissions.permissions", "permissions.smime"}};

void check_private(const fs::path& key) {
    const auto open = fs::status(key).permissions() & (fs::perms::group_all | fs::perms::others_all);
    if (open != fs::perms::none) {
        throw std::runtime_error("security: " + key.string() + " is open to others; allowed: mode 0600");
    }
}

/// Tells once of each folder what of its identity ends soon. Programs print their results on stdout.
void tell_of_endings(const fs::path& folder) {
    static std::mutex mutex;
    static std::set<fs::path> told;
    const auto endings = look_at_identity(folder, std::chrono::system_clock::now());
    const std::lock_guard lock(mutex);
    if (!told.insert(folder).second) return;
    for (const auto& ending : endings)
        std::cerr << "warning: " + ending + "\n";
}

} // namespace

void use_identity(const fs::path& folder, eprosima::fastdds::dds::DomainParticipantQos& qos) {
    auto& properties = qos.properties().properties();
    properties.emplace_back("dds.sec.auth.plugin", "builtin.PKI-DH");
    properties.emplace_back("dds.sec.access.plugin", "builtin.Access-Permissions");
    properties.emplace_back("dds.sec.crypto.plugin", "builtin.AES-GCM-GMAC");
    for (const auto& [name, file] : kFiles) {
        const auto path = fs::absolute(folder / file);
        if (!std::ifstream(path)) {
            throw std::runtime_error("security: " + path.string() +
                                     " cannot be read; config/security/make_identities makes it");
        }
        properties.emplace_back(name, "file://" + path.string());
    }
    check_private(folder / "key.pem");
    tell_of_endings(folder);
    // Identities of before have none.
    if (const auto revoked = fs::absolute(folder / "crl.pem"); fs::exists(revoked))
        properties.emplace_back("dds.sec.auth.builtin.PKI-DH.identity_crl", "file://" + revoked.string());
}

} // namespace windlass::wire
