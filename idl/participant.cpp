#include "idl/participant.hpp"

#include "idl/fast_dds_2_9/abandoned_memory.hpp"
#include "idl/fast_dds_2_9/ports.hpp"
#include "idl/network.hpp"
#include "idl/security.hpp"

#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/log/Log.hpp>
#include <fastdds/dds/log/StdoutErrConsumer.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <fastrtps/xmlparser/XMLProfileManager.h>

#include <stdexcept>
#include <typeinfo>

namespace windlass::wire {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

namespace {

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

/// Members of one process talk as those of two would. Fast DDS 2.9.1 else calls across them, and where one
/// ends while another has not yet heard of it the call goes to a reader that is no more (SIGSEGV in
/// StatefulWriter::intraprocess_gap; 1 in 650 of a test with four members, on a busy machine).
void keep_members_of_this_process_apart() {
    static std::once_flag once;
    std::call_once(once, [] {
        eprosima::fastrtps::LibrarySettingsAttributes settings;
        settings.intraprocess_delivery = eprosima::fastrtps::INTRAPROCESS_OFF;
        eprosima::fastrtps::xmlparser::XMLProfileManager::library_settings(settings);
    });
}

} // namespace

Participant::Participant(const JoinOptions& session)
    : impl_(std::make_shared<Impl>(std::make_shared<Member>(session), session.partition, true)) {}

Participant::Participant(const Participant& member, const std::string& partition)
    : impl_(std::make_shared<Impl>(member.impl_->member, partition, false)) {}

Member::Member(const JoinOptions& session)
    : versions_(session.on_other_version), identity_(session.security), has_ports_(!by_profile()) {
    if (session.domain < 0 || session.domain > kHighestDomain) {
        throw std::runtime_error("DDS: domain " + std::to_string(session.domain) + " is not in 0.." +
                                 std::to_string(kHighestDomain));
    }
    if (!session.security.empty() && !session.network.discovery_server.empty()) {
        throw std::runtime_error("DDS: --security does not go with --discovery-server, which has no identity "
                                 "and is told nothing; use --lan");
    }
    send_dds_messages_to_stderr();
    keep_members_of_this_process_apart();
    static std::once_flag tidied;
    std::call_once(tidied, [] { remove_abandoned_memory(); });

    auto& factory = *dds::DomainParticipantFactory::get_instance();
    auto qos = participant_qos(session.domain, session.network, !session.security.empty());
    qos.name(session.name);
    if (!session.security.empty()) use_identity(session.security, qos);
    if (session.ignore_own_process)
        qos.wire_protocol().builtin.discovery_config.ignoreParticipantFlags =
            eprosima::fastrtps::rtps::ParticipantFilteringFlags_t::FILTER_SAME_PROCESS;
    participant_ = factory.create_participant(static_cast<std::uint32_t>(session.domain), qos, &versions_,
                                              dds::StatusMask::none());
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
                                 " (are there free UDP ports, and room in /dev/shm?)");
    }
}

Member::~Member() {
    participant_->set_listener(nullptr);
    participant_->delete_contained_entities();
    dds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
}

dds::Topic* Member::topic(const TopicInfo& info, const dds::TypeSupport& type) {
    const std::lock_guard lock(topics_);
    if (auto* known = participant_->lookup_topicdescription(info.name)) {
        // Raw and typed ends read the same memory as different types: one participant has one or the other.
        const auto other = participant_->find_type(type.get_type_name());
        if (const dds::TopicDataType& was = *other, &is = *type; typeid(was) != typeid(is)) {
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

rtps::LocatorList_t Member::heard_at(const std::string& partition) {
    rtps::LocatorList_t list;
    if (!has_ports_) return list;
    const std::lock_guard lock(port_choice_);
    std::uint16_t& port = ports_.at(std::hash<std::string>{}(partition) % kPorts);
    if (port == 0) port = fresh_udp_port();
    if (port == 0) return list;
    if (!identity_.empty()) { // shared memory, as all samples of secure members
        rtps::Locator_t memory(LOCATOR_KIND_SHM, port);
        memory.address[0] = 'U'; // for one, not for a group
        list.push_back(memory);
    }
    list.push_back(rtps::Locator_t(LOCATOR_KIND_UDPv4, port)); // at every address of the transport's
    return list;
}

Participant::Impl::Impl(std::shared_ptr<Member> of, const std::string& in, bool first)
    : member(std::move(of)), partition(in) {
    if (partition.empty()) throw std::runtime_error("DDS: the partition has no name");
    dds::PublisherQos publisher_qos;
    publisher_qos.partition().push_back(partition.c_str());
    publisher = member->participant().create_publisher(publisher_qos);
    dds::SubscriberQos subscriber_qos;
    subscriber_qos.partition().push_back(partition.c_str());
    subscriber = member->participant().create_subscriber(subscriber_qos);
    if (publisher == nullptr || subscriber == nullptr)
        throw std::runtime_error("DDS: no publisher or subscriber in partition " + partition);
    if (!first) heard_at = member->heard_at(partition);
    member->versions().add_partition(partition);
}

std::runtime_error Participant::Impl::none_of(const char* end, const TopicInfo& info) const {
    const auto& identity = member->identity();
    return std::runtime_error(
        std::string("DDS: no ") + end + " of topic " + info.name + " in partition " + partition +
        (identity.empty() ? "" : ": the permissions in " + identity.string() + " forbid it"));
}

Participant::Impl::~Impl() {
    member->participant().delete_publisher(publisher);
    member->participant().delete_subscriber(subscriber);
}

} // namespace windlass::wire
