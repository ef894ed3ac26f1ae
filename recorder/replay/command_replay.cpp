// recorder replay: shows a recording to stations as if it were live.

#include "recorder/command.hpp"
#include "recorder/replay/replay_session.hpp"
#include "server/host/realtime.hpp"
#include "station/options.hpp"

#include <fmt/format.h>

namespace windlass::recorder {

namespace {

using namespace std::chrono_literals;

// Discovery takes some 10 to 90 ms on one host, and up to a second by way of a discovery server.
constexpr auto kListen = 1500ms;

struct ReplayOptions {
    std::vector<std::filesystem::path> paths;
    station::SessionOptions session{.partition = "replay", .name = "replay"};
    ShowOptions show;
    bool realtime = false;
};

bool taken_while_listening(const ReplayWriter& stage) {
    const auto end = Playhead::Clock::now() + kListen;
    while (Playhead::Clock::now() < end && !station::stop_asked()) {
        if (stage.taken_by_another()) return true;
        std::this_thread::sleep_for(10ms);
    }
    return false;
}

int replay(const ReplayOptions& options) {
    recording::Recording recording(options.paths);
    for (const auto& damage : recording.damage())
        tell(damage);
    if (recording.start() == 0) throw mcap::Damage(recording.name() + ": there is no message in it");
    if (options.show.start > recording.seconds())
        throw std::runtime_error(fmt::format("--start {:g} is behind the end of the recording, {:.1f} s",
                                             options.show.start, recording.seconds()));
    station::catch_stop_signals();
    if (options.realtime) {
        for (const auto& refused : host::enter_realtime())
            tell("--realtime: " + refused);
    }
    const auto session = options.session.session();
    ReplayWriter stage(session);
    if (taken_while_listening(stage)) {
        tell(fmt::format("a live server (or another replay) is in domain {}, partition {}; nothing was sent. "
                         "Name another one with --partition",
                         session.domain, session.partition));
        return kLiveServer;
    }
    tell(fmt::format("{} of {:.1f} s in domain {}, partition {}", recording.name(), recording.seconds(),
                     session.domain, session.partition));
    ReplaySession show(recording, stage, options.show);
    const int code = show.run();
    tell(fmt::format(
        "ended: {}; {} messages sent, late by {:.3f} ms (median), {:.3f} ms (p99), {:.3f} ms (max)",
        show.ended(), show.sent(), show.lateness_at(0.5) * 1e3, show.lateness_at(0.99) * 1e3,
        show.lateness_at(1) * 1e3));
    if (show.not_sent() > 0)
        tell(fmt::format("{} messages are of no type of ours, and were not sent", show.not_sent()));
    if (show.stalls() > 0)
        tell(
            fmt::format("{} times it fell behind by more than 0.5 s, and went on from there", show.stalls()));
    return code == kOk && !recording.damage().empty() ? kDamaged : code;
}

} // namespace

void add_replay(CLI::App& app, Command& chosen) {
    auto options = std::make_shared<ReplayOptions>();
    CLI::App& sub = *app.add_subcommand("replay", "show a recording to stations as if it were live");
    sub.add_option("recording", options->paths, "folder of a recording, or its MCAP files")->required();
    options->session.add_to(sub);
    sub.add_option("--start", options->show.start, "s from the recording's beginning")
        ->check(number_in(0, 1e9))
        ->capture_default_str();
    sub.add_option("--speed", options->show.speed, "seconds of the recording per second")
        ->check(number_in(Playhead::kSlowest, Playhead::kFastest))
        ->capture_default_str();
    sub.add_flag("--loop", options->show.loop, "begin again at the end");
    sub.add_flag("--paused", options->show.paused, "begin paused, with the picture at --start");
    sub.add_flag("--stay", options->show.stay, "at the end, hold the last picture and wait for commands");
    sub.add_flag("--realtime", options->realtime,
                 "run under SCHED_FIFO with memory locked (needs the right to; warns if refused)");
    sub.footer(
        "Stations join with the same --partition. While it runs, `recorder control` steers it.\n"
        "It writes no command topics, and goes nowhere where a server is.\n"
        "Exit codes: 0 ended in order, 1 failed, 2 bad option, 3 the recording cannot be read, or not\n"
        "all of it, 4 a live server or another replay is in that partition, or came.");
    sub.callback([&chosen, options] { chosen = [options] { return replay(*options); }; });
}

} // namespace windlass::recorder
