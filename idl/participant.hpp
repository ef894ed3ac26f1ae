#pragma once
// Inside of wire::Participant, shared by participant.cpp and wire.cpp only (heavy headers).

#include "idl/version_watch.hpp"

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>

#include <algorithm>
#include <mutex>

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

    /// Makes the partition's publisher or subscriber, and the topics that it writes or reads.
    eprosima::fastdds::dds::DomainParticipant& writing() { return *writing_; }
    /// first: it is the first partition that is joined.
    eprosima::fastdds::dds::DomainParticipant& reading(bool first) { return first ? *writing_ : *reading_; }

    /// The DDS topic of that name in one of the two, made on first use.
    eprosima::fastdds::dds::Topic* topic(eprosima::fastdds::dds::DomainParticipant& participant,
                                         const TopicInfo& info,
                                         const eprosima::fastdds::dds::TypeSupport& type);

    VersionWatch& versions() { return versions_; }

private:
    VersionWatch versions_;
    eprosima::fastdds::dds::DomainParticipant* writing_ = nullptr;
    eprosima::fastdds::dds::DomainParticipant* reading_ = nullptr; // the same, but of a host
    std::mutex topics_;
};

/// A member in one partition.
struct Participant::Impl {
    Impl(std::shared_ptr<Member> of, const std::string& partition, bool first);
    ~Impl();
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    eprosima::fastdds::dds::Topic* written(const TopicInfo& info,
                                           const eprosima::fastdds::dds::TypeSupport& type) {
        return member->topic(writing, info, type);
    }
    eprosima::fastdds::dds::Topic* read(const TopicInfo& info,
                                        const eprosima::fastdds::dds::TypeSupport& type) {
        return member->topic(reading, info, type);
    }

    std::shared_ptr<Member> member;
    eprosima::fastdds::dds::DomainParticipant &writing, &reading;
    eprosima::fastdds::dds::Publisher* publisher = nullptr;
    eprosima::fastdds::dds::Subscriber* subscriber = nullptr;
};

} // namespace windlass::wire
