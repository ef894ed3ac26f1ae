#pragma once
// Recordings of several exercises by one member of the domain, begun and ended by the program that has
// started this one: it says so on stdin, and hears on stdout of each that has ended.

#include "recorder/record/live_recording.hpp"

#include <map>

namespace windlass::recorder {

class ManyRecordings {
public:
    /// Joins the domain. Outlived by the options. Throws std::runtime_error when DDS does not start.
    ManyRecordings(const wire::JoinOptions& session, const RecordingOptions& options);

    /// Does what stdin says, waiting for it at most so long, and writes what has come. False: stdin is
    /// closed.
    bool go_on(std::chrono::milliseconds wait);

    /// All that still go on end. The code of the last that had to end before, else kOk.
    int end(const std::string& because);

private:
    bool read_orders(std::chrono::milliseconds wait);
    void obey(const std::string& line);
    void begin(const std::string& exercise, const std::filesystem::path& folder);
    void end(const std::string& exercise, const std::string& because);
    void tell_ended(const std::string& exercise, int code);

    const wire::JoinOptions session_;
    const RecordingOptions& options_;
    wire::Participant member_;
    std::map<std::string, LiveRecording> recordings_; // by exercise
    std::string unread_;                              // of stdin: a line that is not whole yet
    int code_;
};

} // namespace windlass::recorder
