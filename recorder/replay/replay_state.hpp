#pragma once
// What of a recording is shown, and how: which topics, the flag of a replay, the picture at a moment.

#include "recorder/recording/recording.hpp"

#include <windlass.h>

namespace windlass::recorder {

/// Topics that a replay writes: those of the server, but for the state of a replay itself. Commands are
/// never among them, so that nothing that a replay writes can move a windlass.
std::set<std::string> shown_topics();

/// Sets ExerciseStatus.state in its payload to RUN_REPLAY and leaves every other byte as it is. False when
/// it is no payload of an ExerciseStatus.
bool flag_as_replay(mcap::Buffer& payload);

/// What a station that had been there all the time would know at that moment: all events, the last of every
/// alert, status, assessment and checkpoint, the newest of the streams; by time.
std::vector<recording::KeptMessage> picture_at(recording::Recording& recording, recording::Nanoseconds time);

/// Alerts on the stations, by code and side; kept up to date with take().
class AlertsShown {
public:
    void take(mcap::Bytes payload);

    /// A payload for each alert that is not back to normal, which says that it is: after a jump in time,
    /// nothing recorded may say so.
    std::vector<mcap::Buffer> all_clear();

private:
    std::map<std::pair<std::string, std::int32_t>, Alert> active_;
};

} // namespace windlass::recorder
