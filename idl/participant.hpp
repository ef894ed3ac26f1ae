#pragma once
// Inside of wire::Participant, shared by participant.cpp and wire.cpp only (heavy headers).

#include "idl/version_watch.hpp"

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>

#include <algorithm>
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
    VersionWatch& versions() { return versions_; }
    const std::filesystem::path& identity() const { return identity_; }

private:
    VersionWatch versions_;
    std::filesystem::path identity_; // empty: open to all
    eprosima::fastdds::dds::DomainParticipant* participant_ = nullptr;
    std::mutex topics_;
};

/// A member in one partition.
struct Participant::Impl {
    Impl(std::shared_ptr<Member> of, const std::string& partition);
    ~Impl();
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    eprosima::fastdds::dds::Topic* topic(const TopicInfo& info,
                                         const eprosima::fastdds::dds::TypeSupport& type) {
        return member->topic(info, type);
    }

    /// Why there is none, as far as we know. end: "reader" or "writer".
    std::runtime_error none_of(const char* end, const TopicInfo& info) const;

    std::shared_ptr<Member> member;
    std::string partition;
    eprosima::fastdds::dds::Publisher* publisher = nullptr;
    eprosima::fastdds::dds::Subscriber* subscriber = nullptr;
};

} // namespace windlass::wire
