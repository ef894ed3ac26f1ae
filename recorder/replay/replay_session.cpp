#include "recorder/replay/replay_session.hpp"

#include "idl/topics.hpp"
#include "station/options.hpp"

#include <algorithm>
#include <sys/prctl.h>

namespace windlass::recorder {

using namespace std::chrono_literals;
using recording::KeptMessage;

namespace {

using Clock = Playhead::Clock;

constexpr auto kLook = 20ms;    // for commands, and for a server that comes
constexpr auto kStatus = 200ms; // the replay's own status, as often as a server sends its
constexpr auto kRepeat = 450ms; // without a recorded ExerciseStatus, the last is sent again: paused, or slow
constexpr auto kStreams = 1s; // while it stands where it was put: a page may have missed what is best effort
constexpr auto kMeet = 300ms; // for readers to find the writers: streams are not kept for those who come late
constexpr auto kLeave = 2000ms; // for the last events to arrive
constexpr auto kGiveUp = 500ms; // lateness that is not caught up with: the machine slept, or was stopped

double seconds(Clock::duration duration) {
    return std::chrono::duration<double>(duration).count();
}

} // namespace

ReplaySession::ReplaySession(recording::Recording& recording, ReplayWriter& stage, const ShowOptions& options)
    : recording_(recording), stage_(stage), options_(options), head_(recording.seconds()) {
    status_.recording(recording.name().substr(0, 64));
}

double ReplaySession::position_of(const KeptMessage& message) const {
    return static_cast<double>(message.log_time - recording_.start()) * 1e-9;
}

ExitCode ReplaySession::run() {
    prctl(PR_SET_TIMERSLACK, 1UL); // a sleep ends when it is due, not up to 50 us later
    stage_.open(shown_topics());
    std::this_thread::sleep_for(kMeet);
    head_.set_speed(options_.speed, Clock::now());
    jump(options_.start);
    if (!options_.paused) head_.play(Clock::now());
    while (ended_.empty()) {
        const auto now = Clock::now();
        if (now >= next_look_) look_around(now);
        if (!ended_.empty()) break;
        if (head_.playing())
            step(now);
        else
            std::this_thread::sleep_until(next_look_);
    }
    if (code_ != kLiveServer) stage_.flush(kLeave);
    return code_;
}

/// Everything but the messages themselves.
void ReplaySession::look_around(Time now) {
    next_look_ = now + kLook;
    if (station::stop_asked()) ended_ = "stopped";
    if (stage_.taken_by_another()) {
        ended_ = "a live server or another replay is in this partition now";
        code_ = kLiveServer;
        return;
    }
    obey(now);
    if (now >= next_status_) send_status(now);
    if (!exercise_status_.empty() && now - status_sent_ >= kRepeat) {
        stage_.write(wire::topics::exercise_status.name, exercise_status_);
        status_sent_ = now;
    }
    if (head_.playing()) standing_streams_.clear();
    if (!standing_streams_.empty() && now - streams_sent_ >= kStreams) {
        for (const KeptMessage& message : standing_streams_)
            stage_.write(message.topic, message.payload);
        streams_sent_ = now;
    }
}

void ReplaySession::obey(Time now) {
    const auto commands = stage_.take_commands();
    for (const auto& [command, writer] : commands) {
        if (const auto refusal = check_.refusal(command, writer, head_.duration())) {
            status_.commands_refused(status_.commands_refused() + 1);
            status_.refusal(refusal->substr(0, 256));
            continue;
        }
        carry_out(command, now);
        status_.commands_accepted(status_.commands_accepted() + 1);
    }
    if (!commands.empty()) send_status(Clock::now());
}

void ReplaySession::carry_out(const ReplayCommand& command, Time now) {
    switch (command.action()) {
    case REPLAY_PLAY:
        if (!head_.playing() && head_.position(now) >= head_.duration()) jump(0);
        head_.play(Clock::now());
        break;
    case REPLAY_PAUSE:
        head_.pause(now);
        break;
    case REPLAY_SEEK:
        jump(command.value());
        break;
    case REPLAY_SPEED:
        head_.set_speed(command.value(), now);
        break;
    case REPLAY_LOOP:
        options_.loop = command.value() >= 0.5;
        break;
    case REPLAY_STOP:
        ended_ = "stopped by " + command.origin().source().to_string();
        break;
    }
}

/// Shows the recording as it stands at that position, and goes on from there.
void ReplaySession::jump(double position) {
    next_.reset(); // reads no more, so that others may
    const auto time = recording_.start() + static_cast<recording::Nanoseconds>(position * 1e9);
    const auto picture = picture_at(recording_, time);
    for (const auto& sample : standing_.taken_back())
        stage_.write(sample.topic, sample.payload);
    standing_streams_.clear();
    for (const auto& message : picture) {
        send(message);
        if (std::ranges::any_of(wire::topics::all, [&](const wire::TopicInfo& topic) {
                return !topic.reliable && message.topic == topic.name;
            }))
            standing_streams_.push_back(message);
    }
    streams_sent_ = Clock::now();
    next_ = std::make_unique<Prefetch>(recording_, recording::Query{.topics = shown_topics(), .from = time});
    next_->front(); // what comes first is there before the clock runs
    head_.seek(position, Clock::now());
}

/// Sends the next message, or waits for it until it is time to look around.
void ReplaySession::step(Time now) {
    const KeptMessage* message = next_->front();
    if (message == nullptr) return at_end(now);
    const Time due = head_.due(position_of(*message));
    if (due > next_look_) {
        std::this_thread::sleep_until(next_look_);
        return;
    }
    std::this_thread::sleep_until(due);
    const auto late = Clock::now() - due;
    if (late > kGiveUp) {
        head_.seek(position_of(*message), Clock::now());
        ++stalls_;
    } else {
        lateness_.push_back(static_cast<float>(seconds(late)));
    }
    send(*message);
    next_->pop();
}

void ReplaySession::at_end(Time now) {
    if (head_.position(now) < head_.duration()) {
        std::this_thread::sleep_until(std::min(next_look_, head_.due(head_.duration())));
    } else if (options_.loop) {
        jump(0);
    } else if (options_.stay) {
        head_.pause(now);
        send_status(now);
    } else {
        ended_ = "the recording is at its end";
    }
}

void ReplaySession::send(const KeptMessage& message) {
    bool sent = false;
    if (message.topic == wire::topics::exercise_status.name) {
        auto flagged = message.payload;
        sent = flag_as_replay(flagged) && stage_.write(message.topic, flagged);
        if (sent) exercise_status_ = std::move(flagged);
        status_sent_ = Clock::now();
    } else {
        sent = stage_.write(message.topic, message.payload);
        standing_.keep(message.topic, message.payload);
    }
    ++(sent ? sent_ : not_sent_);
}

void ReplaySession::send_status(Time now) {
    next_status_ = now + kStatus;
    status_.position(head_.position(now));
    status_.duration(head_.duration());
    status_.speed(head_.speed());
    status_.playing(head_.playing());
    status_.loop(options_.loop);
    stage_.write(status_);
}

double ReplaySession::lateness_at(double part) {
    if (lateness_.empty()) return 0;
    const auto at = static_cast<std::ptrdiff_t>(part * static_cast<double>(lateness_.size() - 1) + 0.5);
    std::ranges::nth_element(lateness_, lateness_.begin() + at);
    return lateness_[static_cast<std::size_t>(at)];
}

} // namespace windlass::recorder
