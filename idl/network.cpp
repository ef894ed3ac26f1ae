#include "idl/network.hpp"

#include "idl/fast_dds_2_9/ports.hpp"

#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/rtps/attributes/ServerAttributes.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastdds/rtps/transport/shared_mem/SharedMemTransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace windlass::wire {

namespace dds = eprosima::fastdds::dds;
using eprosima::fastdds::rtps::SharedMemTransportDescriptor;
using eprosima::fastdds::rtps::UDPv4TransportDescriptor;
using eprosima::fastrtps::rtps::IPLocator;
using eprosima::fastrtps::rtps::Locator_t;

namespace {

constexpr const char* kProfilesVariable = "FASTRTPS_DEFAULT_PROFILES_FILE";
// Participants are looked for at as many ports as may run side by side on a host: a classroom. More than 62
// would lead beyond port 65535 in domain 232, at which Fast DDS ends the program.
constexpr std::uint32_t kParticipantsPerHost = 60;

/// Number of the participant in this process. The first ones are counted through; after that Fast DDS takes
/// those of participants that are gone.
std::int32_t participant_number() {
    static std::atomic<std::uint32_t> made{0};
    const std::uint32_t earlier = made++;
    return earlier < kParticipantsPerHost / 2 ? static_cast<std::int32_t>(earlier) : -1;
}

/// What all ways have in common: UDP, and a member that is gone is missed after 20 s. Until then one that was
/// held up goes on as if nothing had been; after that Fast DDS 2.9.1 may not bring it together with the
/// others again (docs/failures.md), so it is longer than a worker may hang (workers::Limits::silence). Who is
/// silent is told by what is heard of him, far sooner: of hands kHandSilent.
dds::DomainParticipantQos common(const std::shared_ptr<UDPv4TransportDescriptor>& udp) {
    constexpr std::uint32_t kSocketBuffer = 1024 * 1024;
    dds::DomainParticipantQos qos;
    udp->sendBufferSize = kSocketBuffer;
    udp->receiveBufferSize = kSocketBuffer;
    qos.transport().use_builtin_transports = false;
    qos.transport().user_transports = {udp};
    auto& discovery = qos.wire_protocol().builtin.discovery_config;
    discovery.leaseDuration = {20, 0};
    discovery.leaseDuration_announcementperiod = {1, 0};
    return qos;
}

/// On the loopback interface only, also where multicast does not work.
dds::DomainParticipantQos one_host() {
    auto udp = std::make_shared<UDPv4TransportDescriptor>();
    udp->interfaceWhiteList.emplace_back("127.0.0.1");
    udp->maxInitialPeersRange = kParticipantsPerHost;
    auto qos = common(udp);
    auto& builtin = qos.wire_protocol().builtin;
    builtin.avoid_builtin_multicast = true;
    Locator_t loopback;
    IPLocator::setIPv4(loopback, 127, 0, 0, 1);
    builtin.initialPeersList.push_back(loopback);
    return qos;
}

/// On every interface; the members find each other by multicast.
dds::DomainParticipantQos lan() {
    return common(std::make_shared<UDPv4TransportDescriptor>());
}

/// On every interface; a discovery server that all know tells them of each other, without multicast.
dds::DomainParticipantQos client_of(const std::string& server) {
    const auto refuse = [&](const char* why) {
        return std::runtime_error("DDS: discovery server \"" + server + "\" is not allowed: " + why);
    };
    const auto colon = server.rfind(':');
    if (colon == std::string::npos) throw refuse("HOST:PORT");
    std::uint16_t port = 0;
    const char* end = server.data() + server.size();
    const auto read = std::from_chars(server.data() + colon + 1, end, port);
    if (read.ec != std::errc() || read.ptr != end || port == 0) throw refuse("a port from 1 to 65535");
    const auto addresses = IPLocator::resolveNameDNS(server.substr(0, colon)).first;
    if (addresses.empty()) throw refuse("the host has no IPv4 address");

    auto qos = lan();
    auto& builtin = qos.wire_protocol().builtin;
    builtin.avoid_builtin_multicast = true;
    builtin.discovery_config.discoveryProtocol = eprosima::fastrtps::rtps::DiscoveryProtocol_t::CLIENT;
    eprosima::fastdds::rtps::RemoteServerAttributes remote;
    remote.ReadguidPrefix("44.53.00.5f.45.50.52.4f.53.49.4d.41"); // of fast-discovery-server -i 0
    for (const auto& address : addresses) {
        Locator_t locator;
        IPLocator::setIPv4(locator, address);
        IPLocator::setPhysicalPort(locator, port);
        remote.metatrafficUnicastLocatorList.push_back(locator);
    }
    builtin.discovery_config.m_DiscoveryServers.push_back(remote);
    return qos;
}

/// Shared memory for samples between programs of one host, for secure members only: over UDP alone a secure
/// exchange of Fast DDS 2.9.1 fails now and then (docs/failures.md). Open members do without, since Fast DDS
/// does not get over one that is killed: who writes to it waits seconds for locks it held, so that nobody
/// hears the server meanwhile. Discovery stays at the ports where every DDS looks for it (DDSI-RTPS 9.6.1.1;
/// where they are taken, Fast DDS goes on to the next participant's); samples get a port that nobody had.
void add_shared_memory(int domain, dds::DomainParticipantQos& qos) {
    constexpr std::uint32_t kSegment = 4 * 1024 * 1024;
    auto shared_memory = std::make_shared<SharedMemTransportDescriptor>();
    shared_memory->segment_size(kSegment);
    auto& transports = qos.transport().user_transports;
    transports.insert(transports.begin(), shared_memory);

    constexpr std::uint16_t kPerParticipant = 2;
    auto& wire = qos.wire_protocol();
    wire.participant_id = participant_number();
    const auto base = static_cast<std::uint16_t>(7400 + 250 * domain);
    wire.port.portBase = 0; // and what follows from the domain into the offsets, for which samples' is free
    wire.port.domainIDGain = 0;
    wire.port.participantIDGain = kPerParticipant;
    wire.port.offsetd0 = base;
    wire.port.offsetd1 = base + 10;
    wire.port.offsetd2 = base + 1;
    wire.port.offsetd3 =
        static_cast<std::uint16_t>(fresh_port() - kPerParticipant * std::max(wire.participant_id, 0));
    // Discovery goes over UDP alone: its port in shared memory could not be chosen.
    auto& builtin = wire.builtin;
    builtin.metatrafficUnicastLocatorList.push_back(Locator_t{}); // any address
    if (builtin.initialPeersList.empty()) {                       // a LAN, by multicast
        Locator_t group;
        IPLocator::setIPv4(group, 239, 255, 0, 1);
        builtin.metatrafficMulticastLocatorList.push_back(group);
    }
}

dds::DomainParticipantQos profile(const std::string& file) {
    if (!std::filesystem::exists(file)) {
        throw std::runtime_error(std::string("DDS: ") + kProfilesVariable + " names " + file +
                                 ", which does not exist");
    }
    auto& factory = *dds::DomainParticipantFactory::get_instance();
    dds::DomainParticipantQos qos;
    if (factory.load_profiles() != eprosima::fastrtps::types::ReturnCode_t::RETCODE_OK ||
        factory.get_default_participant_qos(qos) != eprosima::fastrtps::types::ReturnCode_t::RETCODE_OK) {
        throw std::runtime_error(std::string("DDS: cannot use the profiles of ") + file);
    }
    return qos;
}

} // namespace

bool by_profile() {
    const char* file = std::getenv(kProfilesVariable);
    return file != nullptr && *file != '\0';
}

dds::DomainParticipantQos participant_qos(int domain, const Network& network, bool secure) {
    const bool asked = network.lan || !network.discovery_server.empty();
    if (by_profile() && asked) {
        throw std::runtime_error(std::string("DDS: ") + kProfilesVariable +
                                 " is set and says how the others are found; --lan and --discovery-server "
                                 "do not go with it");
    }
    if (const char* file = std::getenv(kProfilesVariable); file != nullptr && by_profile())
        return profile(file);
    auto qos = !network.discovery_server.empty() ? client_of(network.discovery_server)
               : network.lan                     ? lan()
                                                 : one_host();
    if (secure) add_shared_memory(domain, qos);
    return qos;
}

} // namespace windlass::wire
