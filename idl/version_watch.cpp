#include "idl/version_watch.hpp"

#include "idl/moved_in_run.hpp"
#include "idl/participant.hpp"

#include <fnmatch.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <string_view>

namespace windlass::wire {

namespace rtps = eprosima::fastrtps::rtps;

namespace {

template <class Guid>
std::array<std::uint8_t, 12> prefix_of(const Guid& guid) {
    std::array<std::uint8_t, 12> prefix;
    std::copy_n(guid.guidPrefix.value, prefix.size(), prefix.begin());
    return prefix;
}

/// Either may be a pattern, as DDS has it.
bool meet(const std::string& one, const std::string& other) {
    return fnmatch(one.c_str(), other.c_str(), 0) == 0 || fnmatch(other.c_str(), one.c_str(), 0) == 0;
}

} // namespace

std::string OtherVersion::text() const {
    return name + " speaks version " + std::to_string(version) + " of the wire, this program version " +
           std::to_string(WIRE_VERSION) + ": neither hears the other";
}

int version_of_type(const std::string& type_name) {
    constexpr std::string_view kModule = "windlass::";
    if (!type_name.starts_with(kModule)) return 0;
    const std::string rest = type_name.substr(kModule.size());
    const std::size_t end = rest.find("::");
    if (end == std::string::npos) return 1; // before the version stood in the name
    const std::string digits = rest[0] == 'v' ? rest.substr(1, end - 1) : "";
    const bool number = !digits.empty() && digits.size() < 6 &&
                        std::ranges::all_of(digits, [](char c) { return c >= '0' && c <= '9'; });
    return number ? std::stoi(digits) : 0;
}

void VersionWatch::add_partition(const std::string& partition) {
    {
        const std::lock_guard lock(mutex_);
        partitions_.push_back(partition);
    }
    tell_of_those_who_matter();
}

void VersionWatch::on_participant_discovery(Participant*, rtps::ParticipantDiscoveryInfo&& info) {
    const auto prefix = prefix_of(info.info.m_guid);
    const std::lock_guard lock(mutex_);
    if (info.status == rtps::ParticipantDiscoveryInfo::DISCOVERED_PARTICIPANT ||
        info.status == rtps::ParticipantDiscoveryInfo::CHANGED_QOS_PARTICIPANT) {
        names_[prefix] = info.info.m_participantName.to_string();
    } else {
        names_.erase(prefix);
        strangers_.erase(prefix);
    }
}

void VersionWatch::on_publisher_discovery(Participant*, rtps::WriterDiscoveryInfo&& info) {
    if (info.status == rtps::WriterDiscoveryInfo::DISCOVERED_WRITER) look_at(info.info);
    if (info.info.m_qos.m_ownership.kind != eprosima::fastdds::dds::EXCLUSIVE_OWNERSHIP_QOS) return;
    const WriterId writer = writer_id(info.info.guid());
    if (info.status == rtps::WriterDiscoveryInfo::REMOVED_WRITER)
        exclusive_writers_.gone(writer);
    else
        exclusive_writers_.found(writer,
                                 {.topic = info.info.topicName().to_string(),
                                  .partitions = info.info.m_qos.m_partition.getNames(),
                                  .strength = info.info.m_qos.m_ownershipStrength.value,
                                  .moved_in_run = moved_in_run_of(info.info.m_qos.m_userData.getValue())});
}

void VersionWatch::on_subscriber_discovery(Participant*, rtps::ReaderDiscoveryInfo&& info) {
    if (info.status == rtps::ReaderDiscoveryInfo::DISCOVERED_READER) look_at(info.info);
}

template <class ProxyData>
void VersionWatch::look_at(const ProxyData& end) {
    const int version = version_of_type(end.typeName().to_string());
    if (version == 0 || version == WIRE_VERSION) return;
    {
        const std::lock_guard lock(mutex_);
        Stranger& stranger = strangers_[prefix_of(end.guid())];
        stranger.version = version;
        for (const std::string& partition : end.m_qos.m_partition.getNames())
            stranger.partitions.insert(partition);
    }
    tell_of_those_who_matter();
}

void VersionWatch::tell_of_those_who_matter() {
    std::vector<OtherVersion> news;
    {
        const std::lock_guard lock(mutex_);
        for (auto& [prefix, stranger] : strangers_) {
            const bool ours = std::ranges::any_of(stranger.partitions, [&](const std::string& theirs) {
                return std::ranges::any_of(partitions_,
                                           [&](const std::string& p) { return meet(p, theirs); });
            });
            if (stranger.told || !ours) continue;
            stranger.told = true;
            const auto name = names_.find(prefix);
            news.push_back(
                {name == names_.end() || name->second.empty() ? "somebody" : name->second, stranger.version});
        }
    }
    for (const OtherVersion& other : news) {
        if (tell_) {
            tell_(other);
        } else {
            spdlog::warn("{}", other.text());
        }
    }
}

} // namespace windlass::wire
