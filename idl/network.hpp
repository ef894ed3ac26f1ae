#pragma once
// How a participant finds the others, as a QoS (heavy headers: for participant.cpp only).

#include "idl/wire.hpp"

#include <fastdds/dds/domain/qos/DomainParticipantQos.hpp>

namespace windlass::wire {

/// Transports and discovery as the network asks for; with neither --lan nor a discovery server, those of the
/// profile file that FASTRTPS_DEFAULT_PROFILES_FILE names, or of one host. Throws std::runtime_error saying
/// what is wrong. domain, secure: of the participant.
eprosima::fastdds::dds::DomainParticipantQos participant_qos(int domain, const Network& network, bool secure);

/// FASTRTPS_DEFAULT_PROFILES_FILE names a file, by which the others are found.
bool by_profile();

} // namespace windlass::wire
