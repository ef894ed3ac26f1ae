#pragma once
// Which readers a writer is connected with (heavy headers: for the typed and the raw writer only).

#include "idl/participant.hpp"

#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/DataWriterListener.hpp>

#include <atomic>
#include <mutex>
#include <vector>

namespace windlass::wire {

/// Keeps itself up to date as the listener of one writer, on DDS threads.
class MatchedReaders : public eprosima::fastdds::dds::DataWriterListener {
public:
    using Status = eprosima::fastdds::dds::PublicationMatchedStatus;

    int count() const { return count_; }

    /// One of them is of the participant that has this writer.
    bool is_of(const WriterId& peer) const {
        const std::lock_guard lock(mutex_);
        // Two that come at the same time may be told as one: then who is not known may be meant.
        if (static_cast<std::size_t>(count_) > readers_.size()) return true;
        return std::ranges::any_of(readers_, [&](const WriterId& reader) {
            return std::equal(reader.begin(), reader.begin() + kParticipant, peer.begin());
        });
    }

    /// Of two calls at once the one that is told later may be the older: how many are left is asked again.
    void on_publication_matched(eprosima::fastdds::dds::DataWriter* writer, const Status& status) override {
        const std::lock_guard lock(mutex_);
        count(status);
        Status now;
        if (writer->get_publication_matched_status(now) ==
            eprosima::fastrtps::types::ReturnCode_t::RETCODE_OK)
            count(now);
    }

private:
    static constexpr std::size_t kParticipant = 12; ///< bytes of a GUID that name the participant

    void count(const Status& status) {
        count_ = status.current_count;
        if (status.current_count_change == 0) return;
        const WriterId reader =
            writer_id(eprosima::fastrtps::rtps::iHandle2GUID(status.last_subscription_handle));
        std::erase(readers_, reader);
        if (status.current_count_change > 0) readers_.push_back(reader);
    }

    mutable std::mutex mutex_;
    std::atomic<int> count_{0}; // asked for before each sample of a stream
    std::vector<WriterId> readers_;
};

} // namespace windlass::wire
