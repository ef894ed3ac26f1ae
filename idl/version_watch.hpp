#pragma once
// Members of other versions of the wire, and writers of exclusive topics, as they are discovered. For
// participant.cpp (heavy headers).

#include "idl/exclusive_writers.hpp"
#include "idl/wire.hpp"

#include <fastdds/dds/domain/DomainParticipantListener.hpp>

#include <map>
#include <mutex>
#include <set>
#include <vector>

namespace windlass::wire {

/// Version in a type's name: N of "windlass::vN::TYPE", 1 of "windlass::TYPE"; 0: no type of ours.
int version_of_type(const std::string& type_name);

/// Hears of every writer and reader in the domain and tells of those that a member in one of our partitions
/// means for us, but whose types are another version's. DDS itself keeps the two apart: their types' names
/// differ. DDS tells one listener of a participant only: so this keeps the exclusive writers as well.
class VersionWatch final : public eprosima::fastdds::dds::DomainParticipantListener {
public:
    using Tell = std::function<void(const OtherVersion&)>;
    explicit VersionWatch(Tell tell) : tell_(std::move(tell)) {}

    /// Members of this partition matter, those that are known already among them.
    void add_partition(const std::string& partition);

    const ExclusiveWriters& exclusive_writers() const { return exclusive_writers_; }

    using Participant = eprosima::fastdds::dds::DomainParticipant;
    void on_participant_discovery(Participant*,
                                  eprosima::fastrtps::rtps::ParticipantDiscoveryInfo&& info) override;
    void on_publisher_discovery(Participant*, eprosima::fastrtps::rtps::WriterDiscoveryInfo&& info) override;
    void on_subscriber_discovery(Participant*, eprosima::fastrtps::rtps::ReaderDiscoveryInfo&& info) override;

private:
    using Prefix = std::array<std::uint8_t, 12>;
    struct Stranger {
        int version = 0;
        std::set<std::string> partitions;
        bool told = false;
    };
    template <class ProxyData>
    void look_at(const ProxyData& end);
    void tell_of_those_who_matter();

    Tell tell_;
    ExclusiveWriters exclusive_writers_;
    std::mutex mutex_;
    std::map<Prefix, std::string> names_;  // of the participants that are there
    std::map<Prefix, Stranger> strangers_; // of another version
    std::vector<std::string> partitions_;  // ours
};

} // namespace windlass::wire
