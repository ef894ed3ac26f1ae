#pragma once
// One replay, from the first message to the last.

#include "recorder/command.hpp"
#include "recorder/recording/recording.hpp"
#include "recorder/replay/orders.hpp"
#include "recorder/replay/playhead.hpp"
#include "recorder/replay/prefetch.hpp"
#include "recorder/replay/replay_state.hpp"
#include "recorder/replay/replay_writer.hpp"

namespace windlass::recorder {

struct ShowOptions {
    double start = 0; ///< s from the recording's beginning
    double speed = 1; ///< 0.1..10
    bool loop = false;
    bool paused = false; ///< begin paused
    bool stay = false;   ///< at the end: hold the last picture and wait for commands
};

class ReplaySession {
public:
    ReplaySession(recording::Recording& recording, ReplayWriter& stage, const ShowOptions& options);

    /// Until the end, a command, a signal, or until a live server comes: then an exit code and, in ended(),
    /// why.
    ExitCode run();

    const std::string& ended() const { return ended_; }
    std::uint64_t sent() const { return sent_; }
    std::uint64_t not_sent() const { return not_sent_; } ///< no payloads of their topic
    std::uint64_t stalls() const { return stalls_; }     ///< times that it was too late to catch up

    /// s that messages were sent after they were due; of the part: 0.5 is the median.
    double lateness_at(double part);

private:
    using Time = Playhead::Time;

    void look_around(Time now);
    void obey(Time now);
    void carry_out(const ReplayCommand& command, Time now);
    void jump(double position);
    void step(Time now);
    void at_end(Time now);
    void send(const recording::KeptMessage& message);
    void send_status(Time now);
    double position_of(const recording::KeptMessage& message) const;

    recording::Recording& recording_;
    ReplayWriter& stage_;
    ShowOptions options_;
    Playhead head_;
    OrderCheck check_;
    std::unique_ptr<Prefetch> next_;
    Standing standing_;
    mcap::Buffer exercise_status_;                         // the last one sent, to be repeated
    std::vector<recording::KeptMessage> standing_streams_; // of the moment jumped to, until it plays
    ReplayStatus status_;
    Time streams_sent_{};
    Time next_look_{}, next_status_{}, status_sent_{};
    std::string ended_;
    ExitCode code_ = kOk;
    std::uint64_t sent_ = 0, not_sent_ = 0, stalls_ = 0;
    std::vector<float> lateness_;
};

} // namespace windlass::recorder
