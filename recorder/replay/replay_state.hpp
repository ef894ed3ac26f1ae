#pragma once
// What of a recording is shown, and how: which topics, the flag of a replay, the picture at a moment.

#include "recorder/recording/recording.hpp"

#include "idl/types.hpp"

#include <tuple>

namespace windlass::recorder {

/// Topics that a replay writes: those of the server, but for the state of a replay itself. Commands are
/// never among them, so that nothing that a replay writes can move a windlass.
std::set<std::string> shown_topics();

/// Sets ExerciseStatus.state in its payload to RUN_REPLAY and leaves every other byte as it is. False when
/// it is no payload of an ExerciseStatus.
bool flag_as_replay(mcap::Buffer& payload);

/// What a station that had been there all the time would know at that moment: all events, the last of every
/// alert and order of the bridge, of status, truth, environment, scene, assessment and checkpoint, the newest
/// of the streams; by time.
std::vector<recording::KeptMessage> picture_at(recording::Recording& recording, recording::Nanoseconds time);

/// What stands on the stations until a sample says otherwise: alerts and orders of the bridge. Kept up to
/// date with keep().
class Standing {
public:
    /// Samples of other topics are passed over.
    void keep(const std::string& topic, mcap::Bytes payload);

    struct Sample {
        std::string topic;
        mcap::Buffer payload;
    };
    /// Samples that take all of it back: alerts are back to normal, orders cancelled. After a jump in time,
    /// nothing recorded may say so.
    std::vector<Sample> taken_back();

private:
    using Key = std::tuple<std::string, std::string, std::int32_t>; // topic, code, side
    std::map<Key, Alert> alerts_;                                   // not back to normal
    std::map<std::int32_t, BridgeOrder> orders_;                    // by number; not cancelled
};

} // namespace windlass::recorder
