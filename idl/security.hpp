#pragma once
// DDS Security of a participant (heavy headers: for participant.cpp only).

#include <fastdds/dds/domain/qos/DomainParticipantQos.hpp>

#include <filesystem>

namespace windlass::wire {

/// Makes the participant use the identity in that folder, which config/security/make_identities made.
/// Throws std::runtime_error, naming the file, when one is missing or has ended, when the private key is open
/// to others, and when the identity is revoked. What ends within 30 days it tells on stderr, once.
void use_identity(const std::filesystem::path& folder, eprosima::fastdds::dds::DomainParticipantQos& qos);

} // namespace windlass::wire
