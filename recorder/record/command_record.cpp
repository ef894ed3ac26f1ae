// recorder record: hears every topic of an exercise, and writes it down.

#include "recorder/command.hpp"
#include "recorder/record/capture.hpp"
#include "recorder/record/disk_space.hpp"
#include "recorder/record/tape_feed.hpp"
#include "recorder/recording/typed.hpp"
#include "station/options.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <csignal>
#include <unistd.h>

namespace windlass::recorder {

namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

struct RecordOptions {
    station::SessionOptions session{.name = "recorder"};
    std::filesystem::path output;
    std::string compression = "zstd";
    double roll_mb = 512, keep_free_mb = 256, queue_mb = 64;
    double duration = 0;
    pid_t parent = 0;
    std::filesystem::path config_root = "config";
};

constexpr std::string_view kStatus = wire::topics::exercise_status.name;

std::uint64_t bytes(double megabytes) {
    return static_cast<std::uint64_t>(megabytes * 1e6);
}

std::string utc_now(const char* format) {
    return fmt::format(fmt::runtime(format), fmt::gmtime(std::time(nullptr)));
}

mcap::Strings metadata(const RecordOptions& options) {
    const std::string started = utc_now("{:%Y-%m-%dT%H:%M:%SZ}");
    return {{"recording", fmt::format("{} {} {}", options.session.partition, started, getpid())},
            {"started", started},
            {"recorder", WINDLASS_VERSION},
            {"fast_dds", WINDLASS_FAST_DDS_VERSION},
            {"domain", std::to_string(options.session.domain)},
            {"partition", options.session.session().partition}};
}

/// One recording, from the first sample to the last.
class Session {
public:
    explicit Session(const RecordOptions& options)
        : options_(options),
          queue_(bytes(options.queue_mb)),
          capture_(std::in_place, options.session.session(), queue_),
          tape_({.folder = options.output,
                 .compression = options.compression == "lz4"    ? mcap::Compression::lz4
                                : options.compression == "zstd" ? mcap::Compression::zstd
                                                                : mcap::Compression::none,
                 .roll_size = bytes(options.roll_mb),
                 .metadata = metadata(options)}) {}

    int run() {
        tell(fmt::format("recording partition {}, domain {}, into {}", options_.session.session().partition,
                         options_.session.domain, options_.output.string()));
        try {
            while (!over()) {
                write_what_came(100ms);
                every_second();
            }
            capture_.reset(); // hear no more; then write what has been heard
            write_what_came(0ms);
            tape_.close(closing());
        } catch (const mcap::WriteError& error) {
            disk_refused(error);
        }
        if (!feed_.heard_something()) tape_.discard();
        return report();
    }

private:
    bool over() {
        if (station::stop_asked()) ended_ = "stopped";
        if (options_.duration > 0 &&
            Clock::now() - started_ > std::chrono::duration<double>(options_.duration))
            ended_ = "the set duration is over";
        if (options_.parent > 0 && getppid() != options_.parent)
            ended_ = "the program that began it has gone";
        return !ended_.empty();
    }

    void write_what_came(std::chrono::milliseconds wait) {
        feed_.write_what_came(wait, [this](const Sample& sample) {
            if (wire::topics::all[sample.topic].name == kStatus) look_at(sample);
        });
    }

    /// Another exercise than before: its files go with the recording.
    void look_at(const Sample& sample) {
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
    void every_second() {
        if (Clock::now() < next_look_) return;
        next_look_ = Clock::now() + 1s;
        tape_.flush();
        if (const auto drops = feed_.dropped(); drops != drops_told_) {
            tell(fmt::format("{} samples dropped so far: the disk does not keep up (--queue)", drops));
            drops_told_ = drops;
        }
        if (const auto full = disk_too_full(options_.output, bytes(options_.keep_free_mb))) {
            ended_ = *full;
            code_ = kDisk;
        }
    }

    void disk_refused(const mcap::WriteError& error) {
        ended_ = error.what();
        code_ = kDisk;
        capture_.reset();
        feed_.give_up();
        try {
            tape_.close(closing()); // the end of a chunk that did not fit may be room enough
        } catch (const mcap::WriteError&) {
            tell("there is no room for the summary either; the recording can be read without");
        }
    }

    mcap::Strings closing() const { return feed_.closing(utc_now("{:%Y-%m-%dT%H:%M:%SZ}"), ended_); }

    int report() const {
        tell(fmt::format("{}: {}", code_ == kOk ? "ended" : "ended early", ended_));
        // Where nobody was heard, as in the wrong domain or partition, there is nothing to be kept.
        if (!feed_.heard_something()) {
            tell(fmt::format("nothing was heard in partition {} of domain {}: no recording is left in {}",
                             options_.session.session().partition, options_.session.domain,
                             options_.output.string()));
            return code_;
        }
        tell(fmt::format("{} messages saved in {} file{} of {} in {}", tape_.messages(), tape_.files(),
                         tape_.files() == 1 ? "" : "s", megabytes(tape_.bytes()), options_.output.string()));
        if (const auto drops = feed_.dropped(); drops > 0)
            tell(fmt::format("{} samples were dropped: the disk did not keep up (--queue)", drops));
        if (const auto lost = feed_.lost(); lost > 0)
            tell(fmt::format("{} messages at the end could not be written", lost));
        return code_;
    }

    const RecordOptions& options_;
    SampleQueue queue_;
    std::optional<Capture> capture_; // before the tape: who cannot join makes no folder
    Tape tape_;
    TapeFeed feed_{queue_, tape_};
    Clock::time_point started_ = Clock::now(), next_look_ = started_ + 1s;
    std::string ended_, exercise_;
    std::uint64_t drops_told_ = 0;
    int code_ = kOk;
};

int record(RecordOptions& options) {
    if (options.output.empty())
        options.output =
            std::filesystem::path("recordings") / (options.session.partition + utc_now("_{:%Y%m%dT%H%M%SZ}"));
    if (const auto full = disk_too_full(options.output, bytes(options.keep_free_mb))) {
        tell(*full);
        return kDisk;
    }
    station::catch_stop_signals();
    std::signal(SIGXFSZ, SIG_IGN); // a limit on file size is told by write(), like a full disk
    try {
        return Session(options).run();
    } catch (const mcap::WriteError& error) {
        tell(error.what());
        return kDisk;
    }
}

} // namespace

void add_record(CLI::App& app, Command& chosen) {
    auto options = std::make_shared<RecordOptions>();
    CLI::App& sub = *app.add_subcommand("record", "write down every topic of an exercise");
    options->session.add_to(sub);
    sub.add_option("--output", options->output,
                   "folder for the files of this recording (default: recordings/PARTITION_TIME)")
        ->type_name("DIR");
    sub.add_option("--compression", options->compression, "of the chunks")
        ->check(CLI::IsMember({"zstd", "lz4", "none"}))
        ->capture_default_str();
    sub.add_option("--roll", options->roll_mb, "MB of a file, about, at which the next one is begun")
        ->check(number_in(1.0, 1e6))
        ->capture_default_str();
    sub.add_option("--keep-free", options->keep_free_mb,
                   "MB of the disk to leave free: with less, recording does not start, or ends")
        ->check(number_in(0.0, 1e9))
        ->capture_default_str();
    sub.add_option("--queue", options->queue_mb,
                   "MB of samples that may wait for the disk; what is beyond is dropped and counted")
        ->check(number_in(1.0, 1e5))
        ->capture_default_str();
    sub.add_option("--duration", options->duration, "s of wall time; 0: until Ctrl-C or SIGTERM")
        ->check(number_in(0, 1e9))
        ->capture_default_str();
    sub.add_option("--parent", options->parent,
                   "process that starts this one: when it has gone, recording ends; 0: it goes on")
        ->check(CLI::NonNegativeNumber);
    sub.add_option(
           "--config-root", options->config_root,
           "folder with ships, windlasses, exercises: the exercise's files are kept with the recording")
        ->type_name("DIR")
        ->capture_default_str();
    sub.footer("Start it before the server, or the first samples of streams are missed.\n"
               "Exit codes: 0 ended in order, 1 failed, 2 bad option, 5 disk full or too little room.");
    sub.callback([&chosen, options] { chosen = [options] { return record(*options); }; });
}

} // namespace windlass::recorder
