#pragma once
// One recording while it is made, from the first sample to the last.

#include "recorder/record/capture.hpp"
#include "recorder/record/tape_feed.hpp"

#include <CLI/CLI.hpp>

#include <optional>

namespace windlass::recorder {

/// How recordings are made, whatever they are of.
struct RecordingOptions {
    std::filesystem::path config_root = "config"; ///< whose files of the exercise go with a recording
    std::string compression = "zstd";             ///< of the chunks: zstd, lz4, none
    double roll_mb = 512;                         ///< of a file, at which the next one is begun
    double keep_free_mb = 256;                    ///< of the disk
    double queue_mb = 64;                         ///< of samples that wait for the disk

    void add_to(CLI::App& app);
};

/// UTC, by a format of fmt::gmtime.
std::string utc_now(const char* format);

class LiveRecording {
public:
    /// What a recording is of, and where its files go.
    struct Of {
        int domain;
        std::string partition; ///< as DDS has it
        std::filesystem::path folder;
    };
    /// Hears that partition from now on. Outlived by the options. Throws std::runtime_error when DDS makes no
    /// reader, mcap::WriteError when the disk has too little room or the folder cannot be made or has a
    /// recording already.
    LiveRecording(const wire::Participant& participant, Of of, const RecordingOptions& options);

    /// Writes what has come, waiting for the first at most so long. False: it has to end, as end() tells.
    bool go_on(std::chrono::milliseconds wait);

    /// Hears no more, writes what was heard, closes the files and tells how it went. because: unless it had
    /// to end. Returns the program's exit code.
    int end(const std::string& because);

private:
    using Clock = std::chrono::steady_clock;

    void write_what_came(std::chrono::milliseconds wait);
    void look_at(const Sample& sample);
    void every_second();
    void has_refused(const mcap::WriteError& error);
    mcap::Strings metadata() const;
    mcap::Strings closing() const;
    void report() const;

    const Of of_;
    const RecordingOptions& options_;
    SampleQueue queue_;
    std::optional<Capture> capture_; // before the tape: who cannot join makes no folder
    Tape tape_;
    TapeFeed feed_{queue_, tape_};
    Clock::time_point next_look_ = Clock::now() + std::chrono::seconds(1);
    std::string had_to_end_, exercise_;
    bool refused_ = false; // by the disk
    std::uint64_t drops_told_ = 0;
    int code_;
};

} // namespace windlass::recorder
