#pragma once
// What can be told of a recording by reading it once.

#include "recorder/recording/recording.hpp"

#include "idl/types.hpp"

namespace windlass::recorder {

/// Of one topic.
struct TopicFigures {
    std::string topic, type;
    std::set<std::string> writers; ///< writer ids
    std::uint64_t messages = 0, bytes = 0;
    double first = 0, last = 0; ///< s from the recording's start
    double largest_gap = 0;     ///< s between two messages
    double largest_gap_at = 0;  ///< s from the recording's start, where it begins
    std::uint64_t lost = 0;     ///< numbers missing between those of a writer
    std::vector<float> latency; ///< s from writing to recording, sorted; of what was written meanwhile

    double rate() const;                  ///< Hz, between the first and the last message
    double latency_at(double part) const; ///< part 0.5: the median; 0 without messages
};

struct Figures {
    std::vector<TopicFigures> topics; ///< in the order of the topic table, others behind it
    std::vector<Event> events;        ///< each once, also where several listeners' copies came
    std::uint64_t messages = 0;
};

Figures figures_of(recording::Recording& recording);

} // namespace windlass::recorder
