#include "recorder/record/capture.hpp"

namespace windlass::recorder {

Capture::Capture(const wire::Participant& participant, SampleQueue& queue) : participant_(participant) {
    readers_.reserve(wire::topics::all.size());
    for (std::size_t topic = 0; topic < wire::topics::all.size(); ++topic) {
        readers_.emplace_back(participant_, wire::topics::all[topic],
                              [&queue, topic](const wire::RawSample& heard) {
                                  Sample sample;
                                  sample.topic = topic;
                                  sample.writer = heard.writer;
                                  sample.sequence = static_cast<std::uint32_t>(heard.sequence);
                                  sample.payload.assign(heard.payload.begin(), heard.payload.end());
                                  queue.push(std::move(sample), heard.written_unix_ns);
                              });
    }
}

std::uint64_t Capture::wrong() const {
    std::uint64_t wrong = 0;
    for (const auto& reader : readers_)
        wrong += reader.wrong();
    return wrong;
}

} // namespace windlass::recorder
