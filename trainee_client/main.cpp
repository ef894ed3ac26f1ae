// The trainee's station: its pages for a browser, a script that works one windlass and the helm, or lines of
// text of what the seat is given.

#include "common/json_file.hpp"
#include "station/gateway/ui.hpp"
#include "station/options.hpp"
#include "station/summary.hpp"
#include "trainee_client/trainee.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <iostream>

using namespace windlass;
using station::ViewKind;

namespace {

struct Options {
    station::SessionOptions session{.name = "trainee"};
    std::string side;
    std::string script;
    std::string view = "line";
    std::string seat = "ship";
    bool coach = false;
    double timeout = 0;
    double connect = 10;
    bool json = false;
    bool ui = false;
    gateway::UiOptions pages;
};

void add_options(CLI::App& app, Options& options) {
    options.session.add_to(app);
    app.add_option("--side", options.side, "windlass to work (default: the script's, or port)")
        ->check(CLI::IsMember({"port", "starboard"}));
    app.add_option("--seat", options.seat, "forecastle: the windlass; bridge: the helm; ship: both")
        ->check(CLI::IsMember({"ship", "forecastle", "bridge"}))
        ->capture_default_str();
    app.add_option("--script", options.script,
                   "play this script (config/schema/script.schema.json), then leave");
    app.add_flag("--coach", options.coach,
                 "hear the truth beside what the seat is given: for scripts that look at it, and for their "
                 "summary; in a secure exercise a coach's identity is needed")
        ->excludes("--seat");
    app.add_option("--view", options.view, "lines of text of what the seat is given, or none")
        ->check(CLI::IsMember({"line", "none"}))
        ->capture_default_str();
    app.add_option(
           "--timeout", options.timeout,
           "give up a script after that many seconds of wall time, and say how fast the machine ran; 0: "
           "never. A script's own limits go by the exercise's time")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    app.add_option("--connect", options.connect, "seconds to wait for a server")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    app.add_flag("--json", options.json, "line view and summary as JSON, one object a line");
    app.add_flag("--ui", options.ui,
                 "host the seat's pages for a browser on this computer, and print their addresses")
        ->excludes("--script")
        ->excludes("--coach")
        ->excludes("--view")
        ->excludes("--json");
    options.pages.add_to(app);
    app.footer(
        "Exit codes: 0 done, 1 the script failed, timed out or was stopped, 2 bad option, 3 bad script,\n"
        "4 no server (none found, it went away, a replay is in its place, or it speaks another version of "
        "the\n"
        "wire).\n"
        "Without a script and without --ui it tells what the seat is given, line by line, and moves "
        "nothing.");
}

station::Seat seat_of(const Options& options) {
    if (options.coach) return station::Seat::coach;
    if (options.seat == "forecastle") return station::Seat::forecastle;
    return options.seat == "bridge" ? station::Seat::conning : station::Seat::trainee;
}

/// The script that was asked for. Throws ConfigError: also of what the seat cannot do, which nobody would
/// hear.
trainee::Script script_of(const Options& options) {
    trainee::Script script =
        trainee::load_script(options.script, options.coach ? trainee::Eyes::coach : trainee::Eyes::seat);
    const station::Seat seat = seat_of(options);
    const auto refuse = [&](const std::string& place, const char* needed) {
        throw ConfigError(fmt::format("{}: {} is not allowed at --seat {}: {}", options.script, place,
                                      options.seat, needed));
    };
    if (script.mate && !station::on_forecastle(seat)) refuse("/mate", "forecastle or ship");
    for (std::size_t k = 0; k < script.steps.size(); ++k) {
        const trainee::Step& step = script.steps[k];
        const auto at = [k](const char* name) { return fmt::format("/steps/{}/{}", k, name); };
        if (step.order && seat != station::Seat::conning) refuse(at("order"), "bridge");
        if (step.when.reported && !station::on_bridge(seat)) refuse(at("when/reported"), "bridge or ship");
        if (step.report && !station::on_forecastle(seat)) refuse(at("report"), "forecastle or ship");
        if (step.deck_work && !station::on_forecastle(seat)) refuse(at("deck_work"), "forecastle or ship");
        if (step.show && !station::on_bridge(seat)) refuse(at("show"), "bridge or ship");
        if (step.circle && !station::on_bridge(seat)) refuse(at("circle"), "bridge or ship");
    }
    return script;
}

ViewKind view_kind(const Options& options) {
    if (options.view == "none") return ViewKind::none;
    return options.json ? ViewKind::json : ViewKind::line;
}

int exit_code(trainee::Trainee::Outcome outcome) {
    using Outcome = trainee::Trainee::Outcome;
    if (outcome == Outcome::failed) return station::kFailed;
    return outcome == Outcome::server_lost ? station::kNoServer : station::kOk;
}

/// Plays until the end; fills reason when that was not as wished.
int play(station::Client& client, const Options& options, int side, std::optional<trainee::Script> script,
         std::string& reason) {
    const auto started = station::Clock::now();
    const bool with_script = script.has_value();
    const auto view =
        station::make_view({.kind = view_kind(options), .who = station::Onlooker::seat, .side = side});
    trainee::Trainee trainee{client, side, std::move(script), *view};
    for (;;) {
        const auto outcome = trainee.work();
        reason = trainee.reason();
        if (outcome != trainee::Trainee::Outcome::goes_on) {
            if (with_script && trainee.progress().slow())
                std::cerr << "trainee_client: " << trainee.progress().speed() << std::endl;
            return exit_code(outcome);
        }
        const std::chrono::duration<double> elapsed = station::Clock::now() - started;
        if (options.timeout > 0 && elapsed.count() > options.timeout) {
            reason = fmt::format("gave up after {:g} s of wall time: {}. {}", options.timeout,
                                 trainee.progress().speed(), trainee.waiting_for());
            return station::kFailed;
        }
        if (station::stop_asked()) {
            if (const auto waiting = trainee.waiting_for(); !waiting.empty())
                reason = "stopped by a signal, or nobody reads the output: " + waiting;
            return reason.empty() ? station::kOk : station::kFailed;
        }
        client.wait_for_news(std::chrono::milliseconds{10});
    }
}

/// What the script came to: of the truth for a coach, else as far as the seat could tell.
void tell_summary(const Options& options, const station::Picture& picture, int side, int code) {
    const auto tell = [&](const auto& summary) {
        if (options.json)
            std::cout << nlohmann::json{{"summary", station::to_json(summary)}, {"exit_code", code}}
                      << std::endl;
        else
            std::cout << station::to_text(summary) << std::flush;
    };
    if (options.coach)
        tell(station::summarise(picture, side));
    else
        tell(station::summarise_seat(picture, side));
}

/// Also before there is a server: the pages say that nothing is heard, until something is.
int host_pages(const Options& options) {
    gateway::GatewayOptions wanted;
    wanted.member = options.session.session();
    wanted.seat = seat_of(options);
    wanted.exercise = options.session.partition;
    return gateway::serve_pages(options.pages, std::move(wanted));
}

int run(const Options& options) {
    if (options.ui) return host_pages(options);
    std::optional<trainee::Script> script;
    if (!options.script.empty()) script = script_of(options);
    int side = script ? script->side : SIDE_PORT;
    if (!options.side.empty()) side = options.side == "starboard" ? SIDE_STARBOARD : SIDE_PORT;
    const bool with_script = script.has_value();

    station::catch_stop_signals();
    station::Client client{options.session.session(), seat_of(options)};
    const auto connect_until = station::Clock::now() + std::chrono::duration<double>{options.connect};
    while (!client.meet_server(std::chrono::milliseconds{100})) {
        const auto other = client.other_version();
        if (!other && !station::stop_asked() && station::Clock::now() < connect_until) continue;
        std::cerr << "trainee_client: "
                  << other.value_or(fmt::format("no server heard on domain {}, partition {}, in {:g} s",
                                                options.session.domain, options.session.partition,
                                                options.connect))
                  << std::endl;
        return station::kNoServer;
    }

    std::string reason;
    const int code = play(client, options, side, std::move(script), reason);
    if (with_script) tell_summary(options, client.picture(), side, code);
    if (!reason.empty()) std::cerr << "trainee_client: " << reason << std::endl;
    return code;
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app{"Trainee's station: works a windlass and the helm of a Windlass exercise."};
    Options options;
    add_options(app, options);
    if (const auto code = station::parse(app, argc, argv)) return *code;
    try {
        return station::leave(run(options));
    } catch (const ConfigError& error) {
        std::cerr << error.what() << std::endl;
        return station::kBadScript;
    } catch (const std::exception& error) {
        std::cerr << "trainee_client: " << error.what() << std::endl;
        return station::kFailed;
    }
}
