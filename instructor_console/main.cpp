// The instructor's console, one command at a time: what the exercise does, and what shall go wrong.

#include "instructor_console/ask.hpp"
#include "instructor_console/classroom_command.hpp"
#include "instructor_console/hold.hpp"
#include "instructor_console/recording_position.hpp"
#include "instructor_console/status_text.hpp"
#include "server/exercise/orders.hpp"
#include "station/json_view.hpp"
#include "station/names.hpp"
#include "station/options.hpp"
#include "station/view.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <atomic>
#include <iostream>
#include <numbers>
#include <thread>
#include <unistd.h>

using namespace windlass;
using console::Answer;
using console::meet_server;
using nlohmann::json;
using station::to_json;

namespace {

constexpr double kDegree = std::numbers::pi / 180;

struct Options {
    station::SessionOptions session{.name = fmt::format("console-{}", getpid())};
    double timeout = 3;
    bool as_json = false;

    double time_scale = 1;
    std::string restore_to;
    std::size_t run = 0;
    std::string file;
    std::optional<double> wind_speed, wind_from_deg, current_speed, current_towards_deg;

    std::string fault;
    std::string side = "port";
    double severity = 1;
    std::optional<double> at_time, at_cable_out, at_load_kn;
    bool clear = false;

    std::string view;
    double duration = 0;

    console::LeverWish levers;

    console::ClassroomOptions classroom;
};

int side_of(const Options& options) {
    return options.side == "starboard" ? SIDE_STARBOARD : SIDE_PORT;
}

/// Something did not go as ordered: one line on stderr, or one object on stdout.
int complain(const Options& options, const std::string& text, int code) {
    if (options.as_json)
        std::cout << json{{"ok", false}, {"error", text}, {"exit_code", code}} << std::endl;
    else
        std::cerr << "instructor_console: " << text << std::endl;
    return code;
}

int no_server(const Options& options) {
    return complain(options,
                    fmt::format("no server heard on domain {}, partition {}, in {:g} s",
                                options.session.domain, options.session.partition, options.timeout),
                    station::kNoServer);
}

int tell(const Options& options, const Answer& answer) {
    using Kind = Answer::Kind;
    if (answer.kind == Kind::no_server) return complain(options, answer.text, station::kNoServer);
    if (answer.kind != Kind::carried_out) return complain(options, answer.text, station::kFailed);
    if (!options.as_json) {
        std::cout << answer.text << std::endl;
        return station::kOk;
    }
    json done{{"ok", true}, {"done", answer.text}};
    if (answer.picture.status) done["status"] = to_json(*answer.picture.status);
    std::cout << done << std::endl;
    return station::kOk;
}

/// Joins the exercise, makes the order from the picture found there, and gives it.
template <class Sample, class Make>
int give(const Options& options, const wire::Topic<Sample>& topic, Make make) {
    station::Client client{options.session.session()};
    if (!meet_server(client, options.timeout)) return no_server(options);
    const console::Order<Sample> order = make(client.picture());
    return tell(options, console::ask(client, topic, order, options.timeout));
}

int give_run_order(const Options& options, console::RunOrder order) {
    return give(options, wire::topics::exercise_command, [&](const auto&) { return order; });
}

int status(const Options& options) {
    station::Client client{options.session.session()};
    if (!meet_server(client, options.timeout)) return no_server(options);
    const auto picture = client.picture();
    if (options.as_json)
        std::cout << to_json(*picture.status) << std::endl;
    else
        std::cout << console::status_text(*picture.status) << std::flush;
    return station::kOk;
}

int environment(const Options& options) {
    const auto radians = [](std::optional<double> degrees) {
        return degrees ? std::optional{*degrees * kDegree} : std::nullopt;
    };
    const console::Environment wanted{.wind_speed = options.wind_speed,
                                      .wind_from = radians(options.wind_from_deg),
                                      .current_speed = options.current_speed,
                                      .current_towards = radians(options.current_towards_deg)};
    return give(options, wire::topics::exercise_command,
                [&](const station::Picture& picture) { return console::environment_order(wanted, picture); });
}

int fault(const Options& options) {
    const FaultCode code = station::fault_code(options.fault).value();
    console::FaultOrder order;
    if (options.clear)
        order = console::clear_order(code, side_of(options));
    else if (options.at_time)
        order =
            console::fault_order(code, side_of(options), options.severity, TRIGGER_AT_TIME, *options.at_time);
    else if (options.at_cable_out)
        order = console::fault_order(code, side_of(options), options.severity, TRIGGER_AT_CABLE_OUT,
                                     *options.at_cable_out);
    else if (options.at_load_kn)
        order = console::fault_order(code, side_of(options), options.severity, TRIGGER_AT_LOAD,
                                     *options.at_load_kn * 1000);
    else
        order = console::fault_order(code, side_of(options), options.severity, TRIGGER_NOW, 0);
    return give(options, wire::topics::fault_command, [&](const auto&) { return order; });
}

int snapshot(const Options& options) {
    station::Client client{options.session.session()};
    if (!meet_server(client, options.timeout)) return no_server(options);
    std::atomic<bool> taken = false;
    const auto from = client.picture().status->tick();
    const wire::Reader<Checkpoint> reader{
        client.participant(), wire::topics::checkpoint,
        [&](const Checkpoint& sample) { taken = taken || sample.tick() >= from; }};
    console::RunOrder order;
    order.sample.action(EXERCISE_SNAPSHOT);
    order.done = "snapshot taken";
    order.carried_out = [&taken](const auto&, const auto&) { return taken.load(); };
    return tell(options, console::ask(client, wire::topics::exercise_command, order, options.timeout));
}

int restore(const Options& options) {
    double seconds = 0;
    if (CLI::detail::lexical_cast(options.restore_to, seconds))
        return give_run_order(options, console::restore_order(seconds));
    // Before anybody is asked anything: a recording that is not fit leaves the exercise alone.
    auto order = console::restore_order(console::moment_in(options.restore_to).value(), options.run);
    return give(options, wire::topics::restore_command, [&](const auto&) { return std::move(order); });
}

int list_faults(const Options& options) {
    if (!options.as_json) {
        std::cout << console::fault_list() << std::flush;
        return station::kOk;
    }
    json list = json::array();
    for (const auto& text : station::fault_texts())
        list.push_back({{"code", text.name},
                        {"explanation", text.explanation},
                        {"modelled", exercise::modelled(static_cast<exercise::FaultCode>(list.size()))}});
    std::cout << list << std::endl;
    return station::kOk;
}

int watch(const Options& options) {
    using station::ViewKind;
    station::catch_stop_signals();
    station::Client client{options.session.session()};
    if (!meet_server(client, options.timeout)) return no_server(options);
    ViewKind kind = options.as_json ? ViewKind::json : ViewKind::line;
    if (options.view == "screen" || (options.view.empty() && !options.as_json && isatty(STDOUT_FILENO)))
        kind = ViewKind::screen;
    const auto view = station::make_view({.kind = kind,
                                          .who = station::Onlooker::instructor,
                                          .side = side_of(options),
                                          .heading = "instructor",
                                          .keys = " Tab other side   q quit"});
    const auto started = station::Clock::now();
    while (!station::stop_asked()) {
        const auto now = station::Clock::now();
        if (options.duration > 0 && std::chrono::duration<double>{now - started}.count() > options.duration)
            break;
        if (view->update(client.picture(), now) == 'q') break;
        client.wait_for_news(std::chrono::milliseconds{100});
        if (kind == ViewKind::screen) continue;
        std::this_thread::sleep_for(std::chrono::milliseconds{20}); // a picture costs a copy; 50 a second do
    }
    return station::kOk;
}

int levers(const Options& options) {
    station::catch_stop_signals();
    station::Client client{options.session.session()};
    if (!meet_server(client, options.timeout)) return no_server(options);
    if (client.picture().replayed())
        return complain(options, station::kReplayTakesNoOrders, station::kNoServer);
    const auto told = [&options](const std::string& text) {
        if (options.as_json)
            std::cout << json{{"ok", true}, {"done", text}} << std::endl;
        else
            std::cout << text << std::endl;
    };
    const auto refused =
        hold_levers(client, side_of(options), options.levers, options.duration, options.timeout, told);
    if (refused) return complain(options, *refused, station::kFailed);
    return station::kOk;
}

int classroom(const Options& options) {
    if (options.classroom.what != console::ClassroomOptions::What::list) {
        return tell(options,
                    console::carry_out(options.classroom, options.session.session(), options.timeout));
    }
    const auto servers = console::hear_servers(options.session.session(), options.timeout);
    if (servers.empty()) {
        return complain(
            options,
            fmt::format("no server heard on domain {} in {:g} s", options.session.domain, options.timeout),
            station::kNoServer);
    }
    if (options.as_json)
        std::cout << console::to_json(servers) << std::endl;
    else
        std::cout << console::classroom_text(servers) << std::flush;
    return station::kOk;
}

using Command = std::function<int(const Options&)>;

/// One subcommand: what it does is called after parsing.
CLI::App& add(CLI::App& app, const char* name, const char* text, Command& chosen, const Command& command) {
    CLI::App* sub = app.add_subcommand(name, text);
    sub->callback([&chosen, command] { chosen = command; });
    return *sub;
}

void add_run_commands(CLI::App& app, Options& options, Command& chosen) {
    add(app, "status", "what the exercise does now", chosen, status);
    add(app, "start", "let the exercise run", chosen,
        [](const Options& o) { return give_run_order(o, console::start_order()); });
    add(app, "pause", "hold the exercise", chosen,
        [](const Options& o) { return give_run_order(o, console::pause_order()); });
    add(app, "reset", "back to the start of the exercise", chosen,
        [](const Options& o) { return give_run_order(o, console::reset_order()); });
    add(app, "stop", "end the exercise", chosen,
        [](const Options& o) { return give_run_order(o, console::stop_order()); });
    add(app, "snapshot", "keep the exercise as it stands, to come back to it", chosen, snapshot);
    CLI::App& back =
        add(app, "restore", "go on from an earlier moment of this exercise, or of a recording; paused",
            chosen, restore);
    back.add_option("to", options.restore_to,
                    "s of exercise: the last checkpoint up to then (one each 10 s, and each snapshot); or "
                    "RECORDING@TIME, TIME in s of exercise or M:SS: that very tick")
        ->required()
        ->check([](const std::string& text) {
            double seconds = 0;
            const bool known = CLI::detail::lexical_cast(text, seconds) || console::moment_in(text);
            return known ? "" : text + " is neither s of exercise nor RECORDING@TIME";
        });
    back.add_option("--run", options.run,
                    "of the recording, 1 for the first; default: the last that has that time");
    add(app, "time-scale", "exercise seconds per second", chosen,
        [](const Options& o) { return give_run_order(o, console::time_scale_order(o.time_scale)); })
        .add_option("scale", options.time_scale, "0.1 to 20, or 0 for as fast as possible")
        ->required();
    add(app, "load", "load another exercise", chosen,
        [](const Options& o) { return give_run_order(o, console::load_order(o.file)); })
        .add_option("file", options.file, "its file in the server's exercise folder")
        ->required();
    CLI::App& air =
        add(app, "environment", "change wind and current; what is not given stays", chosen, environment);
    air.add_option("--wind-speed", options.wind_speed, "m/s, 0 to 60");
    air.add_option("--wind-from", options.wind_from_deg, "degrees clockwise from north, where it blows from");
    air.add_option("--current-speed", options.current_speed, "m/s, 0 to 5");
    air.add_option("--current-towards", options.current_towards_deg,
                   "degrees clockwise from north, where it flows");
    air.require_option(1, 0);
}

void add_fault_commands(CLI::App& app, Options& options, Command& chosen) {
    add(app, "faults", "every fault code with what it does", chosen, list_faults);
    CLI::App& sub = add(app, "fault", "raise, arm or clear a fault", chosen, fault);
    sub.add_option("code", options.fault, "see the subcommand faults")
        ->required()
        ->check([](const std::string& text) {
            return station::fault_code(text) ? ""
                                             : text + " is no fault code; the subcommand faults lists them";
        });
    sub.add_option("--side", options.side, "windlass concerned")
        ->check(CLI::IsMember({"port", "starboard"}))
        ->capture_default_str();
    auto* severity = sub.add_option("--severity", options.severity, "0 to 1; 1: the part does nothing at all")
                         ->check(CLI::Range(0.0, 1.0))
                         ->capture_default_str();
    auto* at = sub.add_option("--at", options.at_time, "s of exercise time");
    auto* at_cable = sub.add_option("--at-cable-out", options.at_cable_out, "m of cable out");
    auto* at_load = sub.add_option("--at-load", options.at_load_kn, "kN of load on the gypsy");
    auto* clear = sub.add_flag("--clear", options.clear, "end the fault, armed or active");
    for (auto* trigger : {at, at_cable, at_load})
        trigger->check(CLI::NonNegativeNumber);
    at->excludes(at_cable)->excludes(at_load);
    at_cable->excludes(at_load);
    clear->excludes(at)->excludes(at_cable)->excludes(at_load)->excludes(severity);
}

void add_levers(CLI::App& app, Options& options, Command& chosen) {
    CLI::App& sub = add(app, "levers",
                        "take the levers over from the trainee, and hand them back at the end or on Ctrl-C",
                        chosen, levers);
    sub.add_option("--side", options.side, "windlass concerned")
        ->check(CLI::IsMember({"port", "starboard"}))
        ->capture_default_str();
    sub.add_option("--brake", options.levers.brake, "0 open to 1 hard on")->check(CLI::Range(0.0, 1.0));
    sub.add_option("--speed", options.levers.speed_lever, "-1 full lower to 1 full heave")
        ->check(CLI::Range(-1.0, 1.0));
    sub.add_option("--clutch-in", options.levers.clutch_in, "true or false");
    sub.add_option("--stopper-closed", options.levers.stopper_closed, "true or false");
    sub.add_option("--emergency-stop", options.levers.emergency_stop, "true or false");
    sub.add_option("--duration", options.duration, "s of wall time; 0: until Ctrl-C")
        ->check(CLI::NonNegativeNumber);
    sub.footer("What is not given stays as the trainee left it.");
}

void add_watch(CLI::App& app, Options& options, Command& chosen) {
    CLI::App& sub = add(app, "watch", "live view until q, Ctrl-C or the duration's end", chosen, watch);
    sub.add_option("--view", options.view, "default: screen on a terminal, otherwise line")
        ->check(CLI::IsMember({"line", "screen"}));
    sub.add_option("--side", options.side, "windlass shown")
        ->check(CLI::IsMember({"port", "starboard"}))
        ->capture_default_str();
    sub.add_option("--duration", options.duration, "s of wall time; 0: no end")
        ->check(CLI::NonNegativeNumber);
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app{"Instructor's console: runs a Windlass exercise and injects faults."};
    Options options;
    Command chosen;
    app.fallthrough(); // the common options may stand behind the command too
    options.session.add_to(app);
    app.add_option("--timeout", options.timeout, "seconds to wait for the server and for its answer")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app.add_flag("--json", options.as_json, "answers as JSON, one object a line");
    add_run_commands(app, options, chosen);
    add_fault_commands(app, options, chosen);
    add_levers(app, options, chosen);
    add_watch(app, options, chosen);
    console::add_classroom(app, options.classroom, [&chosen] { chosen = classroom; });
    app.require_subcommand(0, 1);
    app.footer("Exit codes: 0 done, 1 refused or failed, 2 bad option, 4 no server.");
    if (const auto code = station::parse(app, argc, argv)) return *code;
    if (!chosen) {
        std::cerr << "A subcommand is required\n" << app.help();
        return station::kBadOption;
    }
    try {
        return station::leave(chosen(options));
    } catch (const std::exception& error) {
        return complain(options, error.what(), station::kFailed);
    }
}
