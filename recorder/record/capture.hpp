#pragma once
// Hears every topic of an exercise and puts each sample into a queue, unopened.

#include "idl/raw.hpp"
#include "recorder/record/sample_queue.hpp"

namespace windlass::recorder {

class Capture {
public:
    /// Of the partition that the participant is in. Throws std::runtime_error when DDS makes no reader.
    Capture(const wire::Participant& participant, SampleQueue& queue);

    /// Samples that were no payloads of their topic's type, and are not recorded.
    std::uint64_t wrong() const;

private:
    wire::Participant participant_;
    std::vector<wire::RawReader> readers_;
};

} // namespace windlass::recorder
