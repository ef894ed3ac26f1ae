#pragma once
// Recordings as the recorder writes them, of samples that a test makes up.

#include "recorder/record/tape.hpp"
#include "recorder/recording/typed.hpp"

#include <algorithm>

namespace windlass::test {

inline constexpr std::int64_t kStart = 1'700'000'000'000'000'000; ///< ns since 1970
inline constexpr std::int64_t kSecond = 1'000'000'000;

inline std::size_t row_of(const wire::TopicInfo& topic) {
    const auto& all = wire::topics::all;
    return static_cast<std::size_t>(
        std::ranges::find_if(all, [&](const auto& row) { return row.name == std::string_view(topic.name); }) -
        all.begin());
}

/// A sample heard so many seconds after the start, from writer 1 unless told.
template <class T>
recorder::Sample sample(const wire::Topic<T>& topic, const T& value, double seconds,
                        std::uint32_t sequence = 1, std::uint8_t writer = 1) {
    recorder::Sample made;
    made.topic = row_of(topic);
    made.writer.fill(writer);
    made.sequence = sequence;
    made.log_time = kStart + static_cast<std::int64_t>(seconds * 1e9);
    made.publish_time = made.log_time - 1'000'000; // 1 ms under way
    made.payload = recording::encode(value);
    return made;
}

} // namespace windlass::test
