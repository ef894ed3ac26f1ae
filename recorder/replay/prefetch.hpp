#pragma once
// Reads a recording ahead, so that opening a chunk never makes a message late.

#include "recorder/recording/recording.hpp"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

namespace windlass::recorder {

/// While one lives, nothing else may read the recording.
class Prefetch {
public:
    Prefetch(recording::Recording& recording, recording::Query query);
    ~Prefetch();
    Prefetch(const Prefetch&) = delete;
    Prefetch& operator=(const Prefetch&) = delete;

    /// The message whose turn it is, waiting for the disk if need be; nullptr at the end. Stays until pop().
    const recording::KeptMessage* front();
    void pop();

private:
    void read(const std::stop_token& stop);

    recording::Cursor cursor_;
    std::mutex mutex_;
    std::condition_variable_any change_;
    std::deque<recording::KeptMessage> messages_;
    std::size_t bytes_ = 0;
    bool at_end_ = false;
    std::jthread reader_; // last, so that it ends first
};

} // namespace windlass::recorder
