#include "idl/wire.hpp"

#include "idl/bounds.hpp"
#include "idl/matched_readers.hpp"
#include "idl/participant.hpp"
#include "idl/topic_types.hpp"
#include "idl/types.hpp"

#include <windlassPubSubTypes.h>

#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <spdlog/spdlog.h>

#include <cstring>
#include <stdexcept>

namespace windlass::wire {

namespace dds = eprosima::fastdds::dds;
namespace fastrtps = eprosima::fastrtps;
using fastrtps::types::ReturnCode_t;

namespace {

void warn_incompatible(const char* topic, std::uint32_t policy) {
    spdlog::warn("DDS: topic {}: a peer's QoS does not fit (policy {}); topics.md has the right one", topic,
                 policy);
}

template <class T>
struct PubSubTypeOf;

/// The last sample that this thread opened was whole and within its bounds.
thread_local bool opened = false;

/// The compiled type, but that nothing on the wire can make it throw, or take more memory than its bounds
/// allow, and nothing beyond a bound is sent. It opens every sample: one that cannot be opened would end the
/// taking of those behind it. The reader sees by `opened` what it is worth. Keys are made one at a time: the
/// compiled type has one buffer for them, and a participant one type for its writers in all partitions.
template <class T>
class CheckedType final : public PubSubTypeOf<T>::type {
public:
    bool serialize(void* data, fastrtps::rtps::SerializedPayload_t* payload) override {
        // Between aligned fields the payload keeps what it held before, which may have been a sample of a
        // topic that not everybody may read.
        std::memset(payload->data, 0, payload->max_size);
        return PubSubTypeOf<T>::type::serialize(data, payload) &&
               claims_within_bounds<T>({payload->data, payload->length});
    }

    bool deserialize(fastrtps::rtps::SerializedPayload_t* payload, void* data) override {
        opened = false;
        if (claims_within_bounds<T>({payload->data, payload->length})) {
            try {
                opened = PubSubTypeOf<T>::type::deserialize(payload, data);
            } catch (const std::exception&) { // no CDR header, a boolean that is neither 0 nor 1
            }
        }
        return true;
    }

    bool getKey(void* data, fastrtps::rtps::InstanceHandle_t* handle, bool force_md5) override {
        const std::lock_guard lock(keys_);
        return PubSubTypeOf<T>::type::getKey(data, handle, force_md5);
    }

private:
    std::mutex keys_;
};

} // namespace

bool is_exercise_name(const std::string& name) {
    return !name.empty() && name.size() <= 64 &&
           name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_.") ==
               std::string::npos;
}

template <class T>
struct Writer<T>::Impl : MatchedReaders {
    Impl(Participant& owner, const TopicInfo& info, int ownership_strength)
        : participant(owner.impl()), name(info.name) {
        dds::TypeSupport type(new CheckedType<T>());
        auto qos = participant->qos_of<dds::DataWriterQos>(info, type->m_typeSize);
        qos.ownership_strength().value = static_cast<std::uint32_t>(ownership_strength);
        // How soon a lost sample is sent again, and an acknowledgement asked for; the default is 3 s.
        qos.reliable_writer_qos().times.heartbeatPeriod = {0, 50'000'000};
        writer = participant->publisher->create_datawriter(participant->topic(info, type), qos, this,
                                                           dds::StatusMask::offered_incompatible_qos()
                                                               << dds::StatusMask::publication_matched());
        if (writer == nullptr) throw participant->none_of("writer", info);
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl() override {
        writer->set_listener(nullptr);
        participant->publisher->delete_datawriter(writer);
    }

    void on_offered_incompatible_qos(dds::DataWriter*,
                                     const dds::OfferedIncompatibleQosStatus& status) override {
        warn_incompatible(name, status.last_policy_id);
    }

    std::shared_ptr<Participant::Impl> participant;
    const char* name;
    dds::DataWriter* writer = nullptr;
};

template <class T>
Writer<T>::Writer(Participant& participant, const Topic<T>& topic, int ownership_strength)
    : impl_(std::make_unique<Impl>(participant, topic, ownership_strength)) {}
template <class T>
Writer<T>::~Writer() = default;
template <class T>
Writer<T>::Writer(Writer&&) noexcept = default;
template <class T>
Writer<T>& Writer<T>::operator=(Writer&&) noexcept = default;

template <class T>
bool Writer<T>::write(const T& sample) {
    // The interface takes a mutable pointer for loaned samples only; serialisation does not write.
    return impl_->writer->write(const_cast<T*>(&sample));
}

template <class T>
int Writer<T>::matched() const {
    return impl_->count();
}

template <class T>
bool Writer<T>::heard_by(const WriterId& peer) const {
    return impl_->is_of(peer);
}

template <class T>
WriterId Writer<T>::id() const {
    return writer_id(impl_->writer->guid());
}

template <class T>
bool Writer<T>::wait_acknowledged(std::chrono::milliseconds timeout) {
    const auto seconds = std::chrono::duration<long double>(timeout).count();
    return impl_->writer->wait_for_acknowledgments(fastrtps::Duration_t(seconds)) == ReturnCode_t::RETCODE_OK;
}

template <class T>
struct Reader<T>::Impl : dds::DataReaderListener {
    Impl(Participant& owner, const TopicInfo& info, OnSampleFrom callback, OnWrong wrong, OnWriter writer)
        : participant(owner.impl()),
          name(info.name),
          on_sample(std::move(callback)),
          on_wrong(std::move(wrong)),
          on_writer(std::move(writer)) {
        dds::TypeSupport type(new CheckedType<T>());
        const auto qos = participant->qos_of<dds::DataReaderQos>(info, type->m_typeSize);
        auto told = dds::StatusMask::data_available() << dds::StatusMask::requested_incompatible_qos();
        if (on_writer) told << dds::StatusMask::subscription_matched();
        reader = participant->subscriber->create_datareader(participant->topic(info, type), qos, this, told);
        if (reader == nullptr) throw participant->none_of("reader", info);
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl() override {
        reader->set_listener(nullptr);
        { const std::lock_guard wait_for_a_running_callback(busy); }
        { const std::lock_guard wait_for_a_running_callback(meeting); }
        participant->subscriber->delete_datareader(reader);
    }

    void on_subscription_matched(dds::DataReader*, const dds::SubscriptionMatchedStatus& status) override {
        const std::lock_guard lock(meeting);
        on_writer(writer_id(fastrtps::rtps::iHandle2GUID(status.last_publication_handle)),
                  status.current_count_change > 0);
    }

    void on_data_available(dds::DataReader* source) override {
        const std::lock_guard lock(busy);
        dds::SampleInfo info;
        while (source->take_next_sample(&sample, &info) == ReturnCode_t::RETCODE_OK) {
            if (!info.valid_data) continue;
            if (!opened) {
                if (on_wrong) on_wrong();
                continue;
            }
            on_sample(sample, writer_id(info.sample_identity.writer_guid()));
        }
    }

    void on_requested_incompatible_qos(dds::DataReader*,
                                       const dds::RequestedIncompatibleQosStatus& status) override {
        warn_incompatible(name, status.last_policy_id);
    }

    std::shared_ptr<Participant::Impl> participant;
    const char* name;
    OnSampleFrom on_sample;
    OnWrong on_wrong;
    OnWriter on_writer;
    std::mutex busy, meeting; // two: DDS holds locks of its own while it tells of a writer
    T sample;                 // reused, so that a stream of samples does not allocate
    dds::DataReader* reader = nullptr;
};

template <class T>
Reader<T>::Reader(Participant& participant, const Topic<T>& topic, OnSampleFrom on_sample, OnWrong on_wrong,
                  OnWriter on_writer)
    : impl_(std::make_unique<Impl>(participant, topic, std::move(on_sample), std::move(on_wrong),
                                   std::move(on_writer))) {}
template <class T>
Reader<T>::Reader(Participant& participant, const Topic<T>& topic, OnSample on_sample)
    : Reader(participant, topic,
             OnSampleFrom(
                 [callback = std::move(on_sample)](const T& sample, const WriterId&) { callback(sample); }),
             {}) {}
template <class T>
Reader<T>::~Reader() = default;
template <class T>
Reader<T>::Reader(Reader&&) noexcept = default;
template <class T>
Reader<T>& Reader<T>::operator=(Reader&&) noexcept = default;

template <class T>
int Reader<T>::matched() const {
    dds::SubscriptionMatchedStatus status;
    return impl_->reader->get_subscription_matched_status(status) == ReturnCode_t::RETCODE_OK
               ? status.current_count
               : 0;
}

// Every type of the topic table, compiled here once.
#define WINDLASS_WIRE_TYPE(T)                                                                                \
    namespace {                                                                                              \
    template <>                                                                                              \
    struct PubSubTypeOf<T> {                                                                                 \
        using type = T##PubSubType;                                                                          \
    };                                                                                                       \
    }                                                                                                        \
    template class Writer<T>;                                                                                \
    template class Reader<T>;

WINDLASS_TOPIC_TYPES(WINDLASS_WIRE_TYPE)

} // namespace windlass::wire
