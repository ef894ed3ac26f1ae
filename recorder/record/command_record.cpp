// recorder record: hears every topic of an exercise, and writes it down. recorder record-many: of several.

#include "recorder/command.hpp"
#include "recorder/record/live_recording.hpp"
#include "recorder/record/many_recordings.hpp"
#include "station/options.hpp"

#include <csignal>

namespace windlass::recorder {

namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr const char* kExitCodes = "Exit codes: 0 ended in order, 1 failed, 2 bad option, 5 disk full or too "
                                   "little room.";

struct RecordOptions {
    station::SessionOptions session{.name = "recorder"};
    RecordingOptions recording;
    std::filesystem::path output;
    double duration = 0;
};

void prepare() {
    station::catch_stop_signals();
    std::signal(SIGXFSZ, SIG_IGN); // a limit on file size is told by write(), like a full disk
}

int record(RecordOptions& options) {
    if (options.output.empty())
        options.output =
            std::filesystem::path("recordings") / (options.session.partition + utc_now("_{:%Y%m%dT%H%M%SZ}"));
    prepare();
    const auto session = options.session.session();
    const auto started = Clock::now();
    try {
        LiveRecording recording(wire::Participant(session),
                                {session.domain, session.partition, options.output}, options.recording);
        std::string ended;
        while (ended.empty() && recording.go_on(100ms)) {
            if (station::stop_asked()) ended = "stopped";
            if (options.duration > 0 &&
                Clock::now() - started > std::chrono::duration<double>(options.duration))
                ended = "the set duration is over";
        }
        return recording.end(ended);
    } catch (const mcap::WriteError& error) {
        tell(error.what());
        return kDisk;
    }
}

struct RecordManyOptions {
    station::SessionOptions session{.name = "recorder"};
    RecordingOptions recording;
};

int record_many(const RecordManyOptions& options) {
    prepare();
    auto session = options.session.session();
    session.partition = wire::kClassroomPartition; // where it hears nothing: each order names its exercise
    ManyRecordings recordings(session, options.recording);
    while (!station::stop_asked())
        if (!recordings.go_on(100ms)) return recordings.end("the program that began it has gone");
    return recordings.end("stopped");
}

} // namespace

void add_record(CLI::App& app, Command& chosen) {
    auto options = std::make_shared<RecordOptions>();
    CLI::App& sub = *app.add_subcommand("record", "write down every topic of an exercise");
    options->session.add_to(sub);
    options->recording.add_to(sub);
    sub.add_option("--output", options->output,
                   "folder for the files of this recording (default: recordings/PARTITION_TIME)")
        ->type_name("DIR");
    sub.add_option("--duration", options->duration, "s of wall time; 0: until Ctrl-C or SIGTERM")
        ->check(number_in(0, 1e9))
        ->capture_default_str();
    sub.footer(std::string("Start it before the server, or the first samples of streams are missed.\n") +
               kExitCodes);
    sub.callback([&chosen, options] { chosen = [options] { return record(*options); }; });
}

void add_record_many(CLI::App& app, Command& chosen) {
    auto options = std::make_shared<RecordManyOptions>();
    CLI::App& sub = *app.add_subcommand(
        "record-many", "write down several exercises, as the program that starts it says on stdin");
    options->session.add_to(sub);
    sub.remove_option(sub.get_option("--partition"));
    options->recording.add_to(sub);
    sub.footer(std::string("A line each: {\"record\": \"EXERCISE\", \"output\": \"DIR\"}, {\"end\": "
                           "\"EXERCISE\"}. On stdout, when one has\n"
                           "ended: {\"ended\": \"EXERCISE\", \"code\": as record's exit code}. When stdin is "
                           "closed all end.\n") +
               kExitCodes);
    sub.callback([&chosen, options] { chosen = [options] { return record_many(*options); }; });
}

} // namespace windlass::recorder
