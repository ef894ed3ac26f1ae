#pragma once
// Inside of wire::Participant, shared by participant.cpp and wire.cpp only (heavy headers).

#include "idl/wire.hpp"

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>

#include <mutex>

namespace windlass::wire {

struct Participant::Impl {
    explicit Impl(const Session& session);
    ~Impl();
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    /// The DDS topic of that name, made on first use.
    eprosima::fastdds::dds::Topic* topic(const TopicInfo& info,
                                         const eprosima::fastdds::dds::TypeSupport& type);

    eprosima::fastdds::dds::DomainParticipant* participant = nullptr;
    eprosima::fastdds::dds::Publisher* publisher = nullptr;
    eprosima::fastdds::dds::Subscriber* subscriber = nullptr;

private:
    std::mutex topics_;
};

} // namespace windlass::wire
