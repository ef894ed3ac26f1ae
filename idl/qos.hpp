#pragma once
// The topic table's row as a QoS; shared by the typed and the raw ends only (heavy headers).

#include "idl/topics.hpp"

#include <fastdds/dds/publisher/qos/DataWriterQos.hpp>
#include <fastdds/dds/subscriber/qos/DataReaderQos.hpp>

#include <algorithm>
#include <cstdint>

namespace windlass::wire {

/// The parts of a QoS that writer and reader share.
template <class Qos>
Qos shared_qos(const TopicInfo& info, std::uint32_t largest_sample) {
    namespace dds = eprosima::fastdds::dds;
    namespace fastrtps = eprosima::fastrtps;
    Qos qos;
    qos.reliability().kind = info.reliable ? dds::RELIABLE_RELIABILITY_QOS : dds::BEST_EFFORT_RELIABILITY_QOS;
    qos.durability().kind =
        info.transient_local ? dds::TRANSIENT_LOCAL_DURABILITY_QOS : dds::VOLATILE_DURABILITY_QOS;
    qos.history().kind = dds::KEEP_LAST_HISTORY_QOS;
    qos.history().depth = info.depth;
    auto& limits = qos.resource_limits();
    limits.max_instances = info.instances;
    limits.max_samples_per_instance = info.depth;
    limits.max_samples = info.depth * info.instances;
    limits.allocated_samples = std::min(limits.max_samples, 16);
    qos.ownership().kind = info.exclusive ? dds::EXCLUSIVE_OWNERSHIP_QOS : dds::SHARED_OWNERSHIP_QOS;
    if (info.deadline > 0)
        qos.deadline().period = fastrtps::Duration_t(static_cast<long double>(info.deadline));
    qos.data_sharing().off();                    // it refuses keyed types; one way for all
    constexpr std::uint32_t kLarge = 256 * 1024; // too much to preallocate at its bound
    qos.endpoint().history_memory_policy =
        largest_sample > kLarge ? fastrtps::rtps::DYNAMIC_REUSABLE_MEMORY_MODE
        : info.reliable         ? fastrtps::rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE
                                : fastrtps::rtps::PREALLOCATED_MEMORY_MODE;
    return qos;
}

} // namespace windlass::wire
