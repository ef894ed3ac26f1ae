#include "idl/raw.hpp"

#include "idl/matched_readers.hpp"
#include "idl/topic_types.hpp"

#include "idl/types.hpp"

#include <windlassPubSubTypes.h>

#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/topic/Topic.hpp>

#include <atomic>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace windlass::wire {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;
using eprosima::fastrtps::types::ReturnCode_t;

namespace {

constexpr std::size_t kHeader = 4; // CDR encapsulation: 0, endianness, two bytes of options

std::unique_ptr<dds::TopicDataType> compiled_type(const TopicInfo& info) {
    const std::string name = info.type;
#define WINDLASS_COMPILED_TYPE(T)                                                                            \
    if (name == #T) return std::make_unique<T##PubSubType>();
    WINDLASS_TOPIC_TYPES(WINDLASS_COMPILED_TYPE)
#undef WINDLASS_COMPILED_TYPE
    throw std::logic_error("no type " + name);
}

/// Carries payloads in place of the compiled type of that name, which is only asked for keys.
class RawType final : public dds::TopicDataType {
public:
    explicit RawType(std::unique_ptr<dds::TopicDataType> compiled)
        : compiled_(std::move(compiled)), opened_(compiled_->createData()) {
        setName(compiled_->getName());
        m_typeSize = compiled_->m_typeSize;
        m_isGetKeyDefined = compiled_->m_isGetKeyDefined;
    }
    ~RawType() override { compiled_->deleteData(opened_); }
    RawType(const RawType&) = delete;
    RawType& operator=(const RawType&) = delete;

    using Data = std::vector<std::uint8_t>;

    bool fits(std::size_t size) const { return size >= kHeader && size <= m_typeSize; }

    bool serialize(void* data, rtps::SerializedPayload_t* payload) override {
        const auto& bytes = *static_cast<Data*>(data);
        if (bytes.size() > payload->max_size) return false;
        std::memcpy(payload->data, bytes.data(), bytes.size());
        payload->length = static_cast<std::uint32_t>(bytes.size());
        payload->encapsulation = bytes[1] == 0 ? CDR_BE : CDR_LE;
        return true;
    }
    bool deserialize(rtps::SerializedPayload_t* payload, void* data) override {
        static_cast<Data*>(data)->assign(payload->data, payload->data + payload->length);
        return true;
    }
    std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override {
        return [data] { return static_cast<std::uint32_t>(static_cast<Data*>(data)->size()); };
    }
    void* createData() override { return new Data; }
    void deleteData(void* data) override { delete static_cast<Data*>(data); }

    bool getKey(void* data, rtps::InstanceHandle_t* handle, bool force_md5) override {
        if (!m_isGetKeyDefined) return false;
        // Keys stand first in our types. Opening no more than them costs less, and a hostile length of a
        // sequence behind them is never looked at: opening is told that the payload ends too early.
        constexpr std::size_t kWithEveryKey = kHeader + 64;
        auto& bytes = *static_cast<Data*>(data);
        const std::lock_guard lock(mutex_);
        rtps::SerializedPayload_t payload;
        payload.data = bytes.data();
        payload.length = static_cast<std::uint32_t>(std::min(bytes.size(), kWithEveryKey));
        payload.max_size = payload.length;
        bool found = bytes.size() >= kHeader;
        try {
            if (found) compiled_->deserialize(&payload, opened_);
            found = found && compiled_->getKey(opened_, handle, force_md5);
        } catch (const std::exception&) { // no CDR header
            found = false;
        }
        payload.data = nullptr; // it is not the payload's to free
        return found;
    }

private:
    std::unique_ptr<dds::TopicDataType> compiled_;
    std::mutex mutex_; // the compiled type has one buffer for keys
    void* opened_;
};

} // namespace

struct RawReader::Impl : dds::DataReaderListener {
    Impl(Participant& owner, const TopicInfo& info, OnSample callback)
        : participant(owner.impl()), type(new RawType(compiled_type(info))), on_sample(std::move(callback)) {
        const auto qos = participant->qos_of<dds::DataReaderQos>(info, type->m_typeSize);
        reader = participant->subscriber->create_datareader(participant->topic(info, type), qos, this,
                                                            dds::StatusMask::data_available());
        if (reader == nullptr) throw participant->none_of("reader", info);
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl() override {
        reader->set_listener(nullptr);
        { const std::lock_guard wait_for_a_running_callback(busy); }
        participant->subscriber->delete_datareader(reader);
    }

    void on_data_available(dds::DataReader* source) override {
        const std::lock_guard lock(busy);
        dds::SampleInfo info;
        while (source->take_next_sample(&bytes, &info) == ReturnCode_t::RETCODE_OK) {
            if (!info.valid_data) continue;
            if (!static_cast<RawType*>(type.get())->fits(bytes.size())) {
                ++wrong;
                continue;
            }
            on_sample({.payload = bytes,
                       .writer = writer_id(info.sample_identity.writer_guid()),
                       .sequence = info.sample_identity.sequence_number().to64long(),
                       .written_unix_ns = info.source_timestamp.to_ns()});
        }
    }

    std::shared_ptr<Participant::Impl> participant;
    dds::TypeSupport type;
    OnSample on_sample;
    std::mutex busy;
    RawType::Data bytes; // reused, so that a stream of samples does not allocate
    std::atomic<std::uint64_t> wrong = 0;
    dds::DataReader* reader = nullptr;
};

RawReader::RawReader(Participant& participant, const TopicInfo& info, OnSample on_sample)
    : impl_(std::make_unique<Impl>(participant, info, std::move(on_sample))) {}
RawReader::~RawReader() = default;
RawReader::RawReader(RawReader&&) noexcept = default;

int RawReader::matched() const {
    dds::SubscriptionMatchedStatus status;
    return impl_->reader->get_subscription_matched_status(status) == ReturnCode_t::RETCODE_OK
               ? status.current_count
               : 0;
}

std::uint64_t RawReader::wrong() const {
    return impl_->wrong;
}

struct RawWriter::Impl : MatchedReaders {
    Impl(Participant& owner, const TopicInfo& info, int ownership_strength)
        : participant(owner.impl()), type(new RawType(compiled_type(info))) {
        auto qos = participant->qos_of<dds::DataWriterQos>(info, type->m_typeSize);
        qos.ownership_strength().value = static_cast<std::uint32_t>(ownership_strength);
        qos.reliable_writer_qos().times.heartbeatPeriod = {0, 50'000'000}; // as with typed writers
        writer = participant->publisher->create_datawriter(participant->topic(info, type), qos, this,
                                                           dds::StatusMask::publication_matched());
        if (writer == nullptr) throw participant->none_of("writer", info);
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl() override {
        writer->set_listener(nullptr);
        participant->publisher->delete_datawriter(writer);
    }

    std::shared_ptr<Participant::Impl> participant;
    dds::TypeSupport type;
    RawType::Data bytes;
    dds::DataWriter* writer = nullptr;
};

RawWriter::RawWriter(Participant& participant, const TopicInfo& info, int ownership_strength)
    : impl_(std::make_unique<Impl>(participant, info, ownership_strength)) {}
RawWriter::~RawWriter() = default;
RawWriter::RawWriter(RawWriter&&) noexcept = default;

bool RawWriter::write(Bytes payload) {
    if (!static_cast<RawType*>(impl_->type.get())->fits(payload.size())) return false;
    impl_->bytes.assign(payload.begin(), payload.end());
    return impl_->writer->write(&impl_->bytes);
}

void RawWriter::outrank() {
    const auto partitions = impl_->participant->publisher->get_qos().partition().getNames();
    auto qos = impl_->writer->get_qos();
    std::uint32_t highest = 0;
    for (const std::string& partition : partitions)
        highest = std::max(highest, impl_->participant->member->versions().exclusive_writers().highest(
                                        impl_->writer->get_topic()->get_name(), partition));
    if (qos.ownership_strength().value > highest || highest == std::numeric_limits<std::uint32_t>::max())
        return;
    qos.ownership_strength().value = highest + 1;
    impl_->writer->set_qos(qos);
}

bool RawWriter::outranked_by(const WriterId& writer) const {
    return impl_->participant->member->versions().exclusive_writers().strength(writer) >
           impl_->writer->get_qos().ownership_strength().value;
}

bool RawWriter::wait_acknowledged(std::chrono::milliseconds timeout) {
    const auto seconds = std::chrono::duration<long double>(timeout).count();
    return impl_->writer->wait_for_acknowledgments(eprosima::fastrtps::Duration_t(seconds)) ==
           ReturnCode_t::RETCODE_OK;
}

int RawWriter::matched() const {
    return impl_->count();
}

bool RawWriter::heard_by(const WriterId& peer) const {
    return impl_->is_of(peer);
}

WriterId RawWriter::id() const {
    return writer_id(impl_->writer->guid());
}

} // namespace windlass::wire
