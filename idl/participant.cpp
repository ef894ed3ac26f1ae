#include "idl/participant.hpp"

#include "idl/security.hpp"

#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/log/Log.hpp>
#include <fastdds/dds/log/StdoutErrConsumer.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastdds/rtps/transport/shared_mem/SharedMemTransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>

#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <typeinfo>

namespace windlass::wire {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastdds::rtps;

namespace {

constexpr const char* kProfilesVariable = "FASTRTPS_DEFAULT_PROFILES_FILE";
constexpr int kHighestDomain = 232; // the next one has its ports beyond 65535

/// Programs of ours print their results on stdout; messages of Fast DDS belong to stderr.
void send_dds_messages_to_stderr() {
    static std::once_flag once;
    std::call_once(once, [] {
        auto consumer = std::make_unique<dds::StdoutErrConsumer>();
        consumer->stderr_threshold(dds::Log::Kind::Info);
        dds::Log::ClearConsumers();
        dds::Log::RegisterConsumer(std::move(consumer));
    });
}

/// Number of the participant on this host, from which its ports follow; where they are taken, Fast DDS goes
/// on from there. Left to itself it always begins at 0: a program started again then gets the ports of the
/// one that was killed, and is deaf for some 2 s, until the others notice that they write into shared memory
/// that nobody reads any more.
std::int32_t fresh_participant_id() {
    constexpr std::int32_t kIds = 40; // 20 below kParticipantsPerHost: room to go on
    static std::atomic<std::int32_t> made{0};
    const std::int32_t earlier = made++;
    return earlier < kIds ? (getpid() + earlier) % kIds : -1;
}

/// Everything on one host, also where multicast does not work: shared memory for the samples, UDP on
/// loopback for discovery and for peers without shared memory.
dds::DomainParticipantQos one_host() {
    constexpr std::uint32_t kSegment = 4 * 1024 * 1024;
    constexpr std::uint32_t kSocketBuffer = 1024 * 1024;
    // Participants are looked for at as many ports as may run side by side on a host: a classroom. More than
    // 62 would lead beyond port 65535 in domain 232, at which Fast DDS ends the program.
    constexpr std::uint32_t kParticipantsPerHost = 60;

    dds::DomainParticipantQos qos;
    qos.transport().use_builtin_transports = false;
    auto shared_memory = std::make_shared<rtps::SharedMemTransportDescriptor>();
    shared_memory->segment_size(kSegment);
    auto udp = std::make_shared<rtps::UDPv4TransportDescriptor>();
    udp->interfaceWhiteList.emplace_back("127.0.0.1");
    udp->sendBufferSize = kSocketBuffer;
    udp->receiveBufferSize = kSocketBuffer;
    udp->maxInitialPeersRange = kParticipantsPerHost;
    qos.transport().user_transports = {shared_memory, udp};

    qos.wire_protocol().participant_id = fresh_participant_id();
    auto& builtin = qos.wire_protocol().builtin;
    builtin.avoid_builtin_multicast = true;
    builtin.discovery_config.leaseDuration = {5, 0};
    builtin.discovery_config.leaseDuration_announcementperiod = {1, 0};
    eprosima::fastrtps::rtps::Locator_t loopback;
    eprosima::fastrtps::rtps::IPLocator::setIPv4(loopback, 127, 0, 0, 1);
    builtin.initialPeersList.push_back(loopback);
    return qos;
}

/// The operator's profile file, when there is one, or the one-host setting.
dds::DomainParticipantQos participant_qos(dds::DomainParticipantFactory& factory) {
    const char* file = std::getenv(kProfilesVariable);
    if (file == nullptr || *file == '\0') return one_host();
    if (!std::filesystem::exists(file)) {
        throw std::runtime_error(std::string("DDS: ") + kProfilesVariable + " names " + file +
                                 ", which does not exist");
    }
    dds::DomainParticipantQos qos;
    if (factory.load_profiles() != eprosima::fastrtps::types::ReturnCode_t::RETCODE_OK ||
        factory.get_default_participant_qos(qos) != eprosima::fastrtps::types::ReturnCode_t::RETCODE_OK) {
        throw std::runtime_error(std::string("DDS: cannot use the profiles of ") + file);
    }
    return qos;
}

} // namespace

Participant::Participant(const Session& session)
    : impl_(std::make_shared<Impl>(std::make_shared<Member>(session), session.partition)) {}

Participant::Participant(const Participant& member, const std::string& partition)
    : impl_(std::make_shared<Impl>(member.impl_->member, partition)) {}

Member::Member(const Session& session) {
    if (session.domain < 0 || session.domain > kHighestDomain) {
        throw std::runtime_error("DDS: domain " + std::to_string(session.domain) + " is not in 0.." +
                                 std::to_string(kHighestDomain));
    }
    send_dds_messages_to_stderr();

    auto& factory = *dds::DomainParticipantFactory::get_instance();
    auto qos = participant_qos(factory);
    qos.name(session.name);
    if (!session.security.empty()) use_identity(session.security, qos);
    participant_ = factory.create_participant(static_cast<std::uint32_t>(session.domain), qos);
    if (participant_ == nullptr && !session.security.empty()) {
        throw std::runtime_error("DDS: no secure participant can be created in domain " +
                                 std::to_string(session.domain) + " with the identity in " +
                                 session.security.string() +
                                 " (its certificate, permissions or governance "
                                 "are not in order: see the message above)");
    }
    if (participant_ == nullptr) {
        throw std::runtime_error("DDS: no participant can be created in domain " +
                                 std::to_string(session.domain) +
                                 " (are there free UDP ports on 127.0.0.1, and room in /dev/shm?)");
    }
}

Member::~Member() {
    participant_->delete_contained_entities();
    dds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
}

dds::Topic* Member::topic(const TopicInfo& info, const dds::TypeSupport& type) {
    const std::lock_guard lock(topics_);
    if (auto* known = participant_->lookup_topicdescription(info.name)) {
        // Raw and typed ends read the same memory as different types: one participant has one or the other.
        if (const auto other = participant_->find_type(type.get_type_name());
            typeid(*other) != typeid(*type)) {
            throw std::logic_error(std::string("DDS: raw and typed ends of topic ") + info.name +
                                   " in one participant");
        }
        return dynamic_cast<dds::Topic*>(known);
    }
    // A peer that announces a large type object crashes Fast DDS 2.9.1 participants without the type.
    type->auto_fill_type_object(false);
    type->auto_fill_type_information(false);
    type.register_type(participant_);
    auto* made = participant_->create_topic(info.name, type.get_type_name(), dds::TopicQos{});
    if (made == nullptr) throw std::runtime_error(std::string("DDS: no topic ") + info.name);
    return made;
}

Participant::Impl::Impl(std::shared_ptr<Member> of, const std::string& partition) : member(std::move(of)) {
    if (partition.empty()) throw std::runtime_error("DDS: the partition has no name");
    dds::PublisherQos publisher_qos;
    publisher_qos.partition().push_back(partition.c_str());
    publisher = member->participant().create_publisher(publisher_qos);
    dds::SubscriberQos subscriber_qos;
    subscriber_qos.partition().push_back(partition.c_str());
    subscriber = member->participant().create_subscriber(subscriber_qos);
    if (publisher == nullptr || subscriber == nullptr)
        throw std::runtime_error("DDS: no publisher or subscriber in partition " + partition);
}

Participant::Impl::~Impl() {
    member->participant().delete_publisher(publisher);
    member->participant().delete_subscriber(subscriber);
}

} // namespace windlass::wire
