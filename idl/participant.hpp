#pragma once
// Inside of wire::Participant, shared by participant.cpp and wire.cpp only (heavy headers).

#include "idl/qos.hpp"
#include "idl/version_watch.hpp"

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <mutex>
#include <stdexcept>
#include <string>

namespace windlass::wire {

inline WriterId writer_id(const eprosima::fastrtps::rtps::GUID_t& guid) {
    WriterId id;
    std::copy_n(guid.guidPrefix.value, 12, id.begin());
    std::copy_n(guid.entityId.value, 4, id.begin() + 12);
    return id;
}

/// The DDS participant: what costs ports and threads, once for all partitions.
class Member {
public:
    explicit Member(const JoinOptions& session);
    ~Member();
    Member(const Member&) = delete;
    Member& operator=(const Member&) = delete;

    /// The DDS topic of that name, made on first use.
    eprosima::fastdds::dds::Topic* topic(const TopicInfo& info,
                                         const eprosima::fastdds::dds::TypeSupport& type);

    eprosima::fastdds::dds::DomainParticipant& participant() { return *participant_; }
    /// Ports at which the ends in that partition hear; none: at the member's own, with all others.
    eprosima::fastrtps::rtps::LocatorList_t heard_at(const std::string& partition);

    VersionWatch& versions() { return versions_; }
    const std::filesystem::path& identity() const { return identity_; }

private:
    VersionWatch versions_;
    std::filesystem::path identity_; // empty: open to all
    eprosima::fastdds::dds::DomainParticipant* participant_ = nullptr;
    std::mutex topics_;

    /// Fast DDS 2.9.1 looks through all readers of a port at each sample and heartbeat that is for several of
    /// them, and all that come at one port are one thread's: for a member of many exercises that is all it
    /// does (bench/README.md, bench_door). So a few ports share the partitions.
    static constexpr std::size_t kPorts = 16;
    bool has_ports_;
    std::mutex port_choice_;
    std::array<std::uint16_t, kPorts> ports_{}; // 0: nobody hears there yet
};

/// A member in one partition.
struct Participant::Impl {
    /// first: of the member's partitions; it is heard at the member's own port.
    Impl(std::shared_ptr<Member> of, const std::string& partition, bool first);
    ~Impl();
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    eprosima::fastdds::dds::Topic* topic(const TopicInfo& info,
                                         const eprosima::fastdds::dds::TypeSupport& type) {
        return member->topic(info, type);
    }

    /// Why there is none, as far as we know. end: "reader" or "writer".
    std::runtime_error none_of(const char* end, const TopicInfo& info) const;

    /// The QoS of an end in this partition.
    template <class Qos>
    Qos qos_of(const TopicInfo& info, std::uint32_t largest_sample) const {
        auto qos = shared_qos<Qos>(info, largest_sample);
        qos.endpoint().unicast_locator_list = heard_at;
        return qos;
    }

    std::shared_ptr<Member> member;
    std::string partition;
    eprosima::fastrtps::rtps::LocatorList_t heard_at; // nothing: at the member's own port
    eprosima::fastdds::dds::Publisher* publisher = nullptr;
    eprosima::fastdds::dds::Subscriber* subscriber = nullptr;
};

} // namespace windlass::wire
