#include "recorder/record/live_recording.hpp"

#include "recorder/command.hpp"
#include "recorder/record/disk_space.hpp"
#include "recorder/recording/typed.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <cerrno>
#include <unistd.h>

namespace windlass::recorder {

using namespace std::chrono_literals;

namespace {

constexpr std::string_view kStatus = wire::topics::exercise_status.name;
constexpr const char* kIso = "{:%Y-%m-%dT%H:%M:%SZ}";

std::uint64_t bytes(double megabytes) {
    return static_cast<std::uint64_t>(megabytes * 1e6);
}

mcap::Compression compression(const std::string& name) {
    if (name == "lz4") return mcap::Compression::lz4;
    return name == "zstd" ? mcap::Compression::zstd : mcap::Compression::none;
}

/// Only where there is room for it.
LiveRecording::Of with_room(LiveRecording::Of of, const RecordingOptions& options) {
    if (const auto full = disk_too_full(of.folder, bytes(options.keep_free_mb)))
        throw mcap::WriteError(*full, ENOSPC);
    return of;
}

} // namespace

void RecordingOptions::add_to(CLI::App& app) {
    app.add_option("--compression", compression, "of the chunks")
        ->check(CLI::IsMember({"zstd", "lz4", "none"}))
        ->capture_default_str();
    app.add_option("--roll", roll_mb, "MB of a file, about, at which the next one is begun")
        ->check(number_in(1.0, 1e6))
        ->capture_default_str();
    app.add_option("--keep-free", keep_free_mb,
                   "MB of the disk to leave free: with less, recording does not start, or ends")
        ->check(number_in(0.0, 1e9))
        ->capture_default_str();
    app.add_option("--queue", queue_mb,
                   "MB of samples that may wait for the disk; what is beyond is dropped and counted")
        ->check(number_in(1.0, 1e5))
        ->capture_default_str();
    app.add_option(
           "--config-root", config_root,
           "folder with ships, windlasses, exercises: the exercise's files are kept with the recording")
        ->type_name("DIR")
        ->capture_default_str();
}

std::string utc_now(const char* format) {
    return fmt::format(fmt::runtime(format), fmt::gmtime(std::time(nullptr)));
}

LiveRecording::LiveRecording(const wire::Participant& participant, Of of, const RecordingOptions& options)
    : of_(with_room(std::move(of), options)),
      options_(options),
      queue_(bytes(options.queue_mb)),
      capture_(std::in_place, participant, queue_),
      tape_({.folder = of_.folder,
             .compression = compression(options.compression),
             .roll_size = bytes(options.roll_mb),
             .metadata = metadata()}),
      code_(kOk) {
    tell(fmt::format("recording partition {}, domain {}, into {}", of_.partition, of_.domain,
                     of_.folder.string()));
}

bool LiveRecording::go_on(std::chrono::milliseconds wait) {
    try {
        write_what_came(wait);
        every_second();
    } catch (const mcap::WriteError& error) {
        has_refused(error);
    }
    return had_to_end_.empty();
}

int LiveRecording::end(const std::string& because) {
    if (had_to_end_.empty()) had_to_end_ = because;
    capture_.reset(); // hear no more; then write what has been heard
    try {
        if (!refused_) {
            write_what_came(0ms);
            tape_.close(closing());
        }
    } catch (const mcap::WriteError& error) {
        has_refused(error);
    }
    if (refused_) {
        feed_.give_up();
        try {
            tape_.close(closing()); // the end of a chunk that did not fit may be room enough
        } catch (const mcap::WriteError&) {
            tell("there is no room for the summary either; the recording can be read without");
        }
    }
    if (!feed_.heard_something()) tape_.discard();
    report();
    return code_;
}

/// The disk.
void LiveRecording::has_refused(const mcap::WriteError& error) {
    had_to_end_ = error.what();
    refused_ = true;
    code_ = kDisk;
}

void LiveRecording::write_what_came(std::chrono::milliseconds wait) {
    feed_.write_what_came(wait, [this](const Sample& sample) {
        if (wire::topics::all[sample.topic].name == kStatus) look_at(sample);
    });
}

/// Another exercise than before: its files go with the recording.
void LiveRecording::look_at(const Sample& sample) {
    std::string name;
    try {
        name = recording::decode<ExerciseStatus>(sample.payload).exercise().to_string();
    } catch (const mcap::Damage&) {
        return; // recorded as it is; what it says is not known
    }
    if (name == exercise_) return;
    exercise_ = name;
    std::vector<ExerciseFile> files;
    try {
        files = find_exercise(options_.config_root, name);
    } catch (const std::exception& error) {
        tell(fmt::format("exercise {}: its files are not attached: {}", name, error.what()));
        return;
    }
    tell(fmt::format("exercise {}: {} files attached", name, files.size()));
    tape_.attach(std::move(files));
}

/// What a kill would lose is the last second; and room on the disk and in memory is looked after.
void LiveRecording::every_second() {
    if (Clock::now() < next_look_) return;
    next_look_ = Clock::now() + 1s;
    tape_.flush();
    if (const auto drops = feed_.dropped(); drops != drops_told_) {
        tell(fmt::format("{}: {} samples dropped so far: the disk does not keep up (--queue)", of_.partition,
                         drops));
        drops_told_ = drops;
    }
    if (const auto full = disk_too_full(of_.folder, bytes(options_.keep_free_mb))) {
        had_to_end_ = *full;
        code_ = kDisk;
    }
}

mcap::Strings LiveRecording::metadata() const {
    const std::string started = utc_now(kIso);
    return {{"recording", fmt::format("{} {} {}", of_.partition, started, getpid())},
            {"started", started},
            {"recorder", WINDLASS_VERSION},
            {"fast_dds", WINDLASS_FAST_DDS_VERSION},
            {"domain", std::to_string(of_.domain)},
            {"partition", of_.partition}};
}

mcap::Strings LiveRecording::closing() const {
    return feed_.closing(utc_now(kIso), had_to_end_);
}

void LiveRecording::report() const {
    tell(fmt::format("{}: {}", code_ == kOk ? "ended" : "ended early", had_to_end_));
    // Where nobody was heard, as in the wrong domain or partition, there is nothing to be kept.
    if (!feed_.heard_something()) {
        tell(fmt::format("nothing was heard in partition {} of domain {}: no recording is left in {}",
                         of_.partition, of_.domain, of_.folder.string()));
        return;
    }
    tell(fmt::format("{} messages saved in {} file{} of {} in {}", tape_.messages(), tape_.files(),
                     tape_.files() == 1 ? "" : "s", megabytes(tape_.bytes()), of_.folder.string()));
    if (const auto drops = feed_.dropped(); drops > 0)
        tell(fmt::format("{} samples were dropped: the disk did not keep up (--queue)", drops));
    if (const auto lost = feed_.lost(); lost > 0)
        tell(fmt::format("{} messages at the end could not be written", lost));
}

} // namespace windlass::recorder
