// The instructor's console, one command at a time: what the exercise does, and what shall go wrong.

#include "instructor_console/ask.hpp"
#include "instructor_console/bridge_options.hpp"
#include "instructor_console/classroom_command.hpp"
#include "instructor_console/debrief_page.hpp"
#include "instructor_console/exercise_files.hpp"
#include "instructor_console/fault_options.hpp"
#include "instructor_console/history/history_command.hpp"
#include "instructor_console/hold.hpp"
#include "instructor_console/lesson_command.hpp"
#include "instructor_console/recording_events.hpp"
#include "instructor_console/recording_position.hpp"
#include "instructor_console/status_text.hpp"
#include "instructor_console/weather_options.hpp"
#include "station/gateway/ui.hpp"
#include "station/json_view.hpp"
#include "station/line_view.hpp"
#include "station/names.hpp"
#include "station/options.hpp"
#include "station/view.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <atomic>
#include <iostream>
#include <thread>
#include <unistd.h>

using namespace windlass;
using console::Answer;
using nlohmann::json;
using station::to_json;

namespace {

struct Options {
    station::SessionOptions session{.name = fmt::format("console-{}", getpid())};
    double timeout = 3;
    bool as_json = false;

    double time_scale = 1;
    std::string restore_to;
    std::size_t run = 0;
    std::string file;
    std::string bookmark;

    std::string side = "port";
    console::WeatherOptions weather;
    console::FaultOptions fault;
    console::BridgeOrderOptions order;
    console::WatchOptions circle;
    std::string alert;      ///< code
    std::string alert_side; ///< empty: whichever it is of

    std::string view;
    double duration = 0;

    console::LeverWish levers;

    console::ClassroomOptions classroom;

    history::HistoryOptions history;

    gateway::UiOptions pages;
    std::filesystem::path recordings = "recordings";
    std::filesystem::path exercises = "config/exercises";
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

/// The instructor in the exercise; nothing when no server is heard there, which is then told.
std::unique_ptr<station::Client> join(const Options& options) {
    auto client = std::make_unique<station::Client>(options.session.session(), station::Seat::instructor);
    if (client->meet_server(std::chrono::duration<double>{options.timeout})) return client;
    complain(options,
             client->other_version().value_or(
                 fmt::format("no server heard on domain {}, partition {}, in {:g} s", options.session.domain,
                             options.session.partition, options.timeout)),
             station::kNoServer);
    return nullptr;
}

/// What is kept for late joiners, orders and alerts, comes at once after the status, but after it.
void let_kept_samples_arrive() {
    std::this_thread::sleep_for(std::chrono::milliseconds{300});
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
    if (answer.picture.status) done["status"] = console::status_json(answer.picture);
    std::cout << done << std::endl;
    return station::kOk;
}

/// Joins the exercise, makes the order from the picture found there, and gives it.
template <class Sample, class Make>
int give(const Options& options, const wire::Topic<Sample>& topic, Make make) {
    const auto joined = join(options);
    if (!joined) return station::kNoServer;
    station::Client& client = *joined;
    const console::Order<Sample> order = make(client.picture());
    return tell(options, console::ask(client, topic, order, options.timeout));
}

int give_run_order(const Options& options, console::RunOrder order) {
    return give(options, wire::topics::exercise_command, [&](const auto&) { return order; });
}

int status(const Options& options) {
    const auto joined = join(options);
    if (!joined) return station::kNoServer;
    station::Client& client = *joined;
    const auto picture = client.picture();
    if (options.as_json)
        std::cout << console::status_json(picture) << std::endl;
    else
        std::cout << console::status_text(picture) << std::flush;
    return station::kOk;
}

int environment(const Options& options) {
    const auto joined = join(options);
    if (!joined) return station::kNoServer;
    const auto picture = joined->picture();
    if (!picture.environment)
        return complain(options, "no word of the environment from the server", station::kFailed);
    const auto order = console::environment_order(options.weather.environment(), picture);
    return tell(options, console::ask(*joined, wire::topics::environment_command, order, options.timeout));
}

int fault(const Options& options) {
    const console::FaultOrder order = options.fault.order(side_of(options));
    return give(options, wire::topics::fault_command, [&](const auto&) { return order; });
}

int bridge_order(const Options& options) {
    const console::BridgeOrderWish wish = options.order.wish();
    const auto joined = join(options);
    if (!joined) return station::kNoServer;
    let_kept_samples_arrive(); // an order of before is no answer
    return tell(options, console::ask(*joined, wire::topics::bridge_order_command,
                                      console::bridge_order(wish, joined->picture()), options.timeout));
}

int list_orders(const Options& options) {
    const auto joined = join(options);
    if (!joined) return station::kNoServer;
    let_kept_samples_arrive();
    const auto picture = joined->picture();
    json list = json::array();
    for (const BridgeOrder& order : picture.orders) {
        if (options.as_json)
            list.push_back(to_json(order));
        else
            std::cout << station::line(order) << "\n";
    }
    if (options.as_json) std::cout << list << std::endl;
    return station::kOk;
}

int bookmark(const Options& options) {
    return give(options, wire::topics::exercise_command, [&](const station::Picture& picture) {
        return console::bookmark_order(options.bookmark, picture);
    });
}

int watch_circle(const Options& options) {
    const console::WatchOptions& wanted = options.circle;
    const auto joined = join(options);
    if (!joined) return station::kNoServer;
    double x = wanted.x.value_or(0), y = wanted.y.value_or(0);
    if (!wanted.off && !wanted.x) {
        if (!joined->wait(std::chrono::duration<double>{options.timeout},
                          [](const station::Picture& now) { return bool(now.ship); }))
            return complain(options, "no word of where the ship is", station::kFailed);
        const auto place = joined->picture().ship->position();
        x = place.x();
        y = place.y();
    }
    const auto order = console::watch_circle(!wanted.off, x, y, wanted.radius);
    return tell(options, console::ask(*joined, wire::topics::watch_circle, order, options.timeout));
}

int list_alerts(const Options& options) {
    const auto joined = join(options);
    if (!joined) return station::kNoServer;
    let_kept_samples_arrive();
    const auto picture = joined->picture();
    json list = json::array();
    for (const Alert& alert : picture.alerts) {
        if (options.as_json)
            list.push_back(to_json(alert));
        else
            std::cout << station::line(alert) << "\n"
                      << (alert.explanation().size() > 0
                              ? fmt::format("    {}\n", alert.explanation().c_str())
                              : "");
    }
    if (options.as_json) std::cout << list << std::endl;
    return station::kOk;
}

/// Acknowledges one alert, or silences one or all.
int answer_alerts(const Options& options, AlertAction action) {
    const auto joined = join(options);
    if (!joined) return station::kNoServer;
    let_kept_samples_arrive();
    std::vector<Alert> meant;
    for (const Alert& alert : joined->picture().alerts) {
        const bool named = options.alert == "all" || alert.code() == options.alert.c_str();
        const bool of_side =
            options.alert_side.empty() || station::side_name(alert.side()) == options.alert_side;
        if (named && of_side) meant.push_back(alert);
    }
    if (meant.empty())
        return complain(options, fmt::format("no alert {} stands", options.alert), station::kFailed);
    int code = station::kOk;
    for (const Alert& alert : meant)
        if (const int each =
                tell(options, console::ask(*joined, wire::topics::alert_command,
                                           console::alert_order(alert, action), options.timeout)))
            code = each;
    return code;
}

int snapshot(const Options& options) {
    const auto joined = join(options);
    if (!joined) return station::kNoServer;
    station::Client& client = *joined;
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
    if (options.as_json)
        std::cout << console::fault_json() << std::endl;
    else
        std::cout << console::fault_list() << std::flush;
    return station::kOk;
}

int watch(const Options& options) {
    using station::ViewKind;
    station::catch_stop_signals();
    const auto joined = join(options);
    if (!joined) return station::kNoServer;
    station::Client& client = *joined;
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
    const auto joined = join(options);
    if (!joined) return station::kNoServer;
    station::Client& client = *joined;
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
    return refused ? complain(options, *refused, station::kFailed) : station::kOk;
}

/// Hosts the instructor's pages. Also before there is a server: the pages say that nothing is heard.
int host_pages(const Options& options) {
    gateway::GatewayOptions wanted;
    wanted.member = options.session.session();
    wanted.seat = station::Seat::instructor;
    wanted.exercise = options.session.partition;
    wanted.documents["/faults.json"] = console::fault_json().dump();
    wanted.recorder = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "recorder";
    if (!std::filesystem::exists(wanted.recorder)) wanted.recorder.clear();
    wanted.recorder_arguments = options.session.arguments();
    wanted.recordings = options.recordings;
    wanted.state_at = [](const std::filesystem::path& recording, double position) {
        const auto order = console::restore_order_at(recording, position);
        const auto& octets = order.sample.checkpoint();
        return json{{"from", order.sample.from().to_string()},
                    {"checkpoint", std::string(octets.begin(), octets.end())}};
    };
    wanted.events_of = console::events_of;
    wanted.debrief_of = console::debrief_page;
    wanted.exercise_files = [files = std::make_shared<console::ExerciseFiles>(options.exercises)](
                                const json& request) { return files->answer(request); };
    return gateway::serve_pages(options.pages, std::move(wanted));
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
    add(app, "bookmark", "put a word into the log and the recording, at this moment", chosen, bookmark)
        .add_option("text", options.bookmark, "the word")
        ->required()
        ->check([](const std::string& text) {
            return !text.empty() && text.size() <= 127 ? "" : std::string{"1 to 127 characters are allowed"};
        });
    CLI::App& air =
        add(app, "environment", "change wind, waves, current, tide and light; what is not given stays",
            chosen, environment);
    options.weather.add_to(air);
}

void add_side(CLI::App& app, Options& options) {
    app.add_option("--side", options.side, "windlass concerned")
        ->check(CLI::IsMember({"port", "starboard"}))
        ->capture_default_str();
}

void add_fault_commands(CLI::App& app, Options& options, Command& chosen) {
    add(app, "faults", "every fault code with what it does", chosen, list_faults);
    CLI::App& sub = add(app, "fault", "raise, arm or clear a fault", chosen, fault);
    add_side(sub, options);
    options.fault.add_to(sub);
}

void add_bridge_commands(CLI::App& app, Options& options, Command& chosen) {
    options.order.add_to(add(app, "order", "an order of the bridge to the forecastle", chosen, bridge_order));
    add(app, "orders", "the bridge's orders of this run, and whether they were repeated back", chosen,
        list_orders);
    CLI::App& circle = add(app, "watch-circle", "anchor watch: an alert when the ship leaves a circle",
                           chosen, watch_circle);
    options.circle.add_to(circle);
    circle.require_option(1, 0);
}

void add_alerts(CLI::App& app, Options& options, Command& chosen) {
    CLI::App& sub = *app.add_subcommand("alerts", "what sounds and stands");
    sub.fallthrough();
    sub.require_subcommand(1);
    add(sub, "list", "each that stands, with what to do", chosen, list_alerts);
    const auto which = [&options](CLI::App& command, const char* text) {
        command.add_option("code", options.alert, text)->required();
        command.add_option("--side", options.alert_side, "where two of that code stand")
            ->check(CLI::IsMember({"port", "starboard", "neither"}));
    };
    which(add(sub, "acknowledge", "one alert, or both sides' of one code", chosen,
              [](const Options& o) { return answer_alerts(o, ALERT_ACKNOWLEDGE); }),
          "its code, as in the list");
    which(add(sub, "silence", "for a while; what is not acknowledged sounds again", chosen,
              [](const Options& o) { return answer_alerts(o, ALERT_SILENCE); }),
          "its code, or all");
}

void add_levers(CLI::App& app, Options& options, Command& chosen) {
    CLI::App& sub = add(app, "levers",
                        "take the levers over from the trainee, and hand them back at the end or on Ctrl-C",
                        chosen, levers);
    add_side(sub, options);
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

void add_pages(CLI::App& app, Options& options, Command& chosen) {
    CLI::App& sub = add(app, "ui",
                        "host the instructor's pages for a browser on this computer, and print their "
                        "addresses, until Ctrl-C",
                        chosen, host_pages);
    options.pages.add_to(sub);
    options.pages.add_foxglove_to(sub);
    sub.add_option("--recordings", options.recordings,
                   "folder into which the pages record, and of whose recordings they go on")
        ->capture_default_str();
    sub.add_option("--exercises", options.exercises,
                   "folder of exercise files that the page of lessons reads and writes")
        ->capture_default_str();
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
    add_bridge_commands(app, options, chosen);
    add_alerts(app, options, chosen);
    add_levers(app, options, chosen);
    add_watch(app, options, chosen);
    add_pages(app, options, chosen);
    console::add_classroom(app, options.classroom, [&chosen] { chosen = classroom; });
    history::add_history(app, options.history, [&chosen] {
        chosen = [](const Options& o) {
            history::carry_out(o.history, o.as_json);
            return int{station::kOk};
        };
    });
    console::add_lesson(app, [&chosen](std::function<int()> work) {
        chosen = [work = std::move(work)](const Options&) { return work(); };
    });
    app.require_subcommand(0, 1);
    app.footer("Exit codes: 0 done, 1 refused or failed, 2 bad option, 4 no server, or one of another "
               "version of the wire.");
    if (const auto code = station::parse(app, argc, argv)) return *code;
    if (!chosen) {
        std::cerr << "A subcommand is required\n" << app.help();
        return station::kBadOption;
    }
    try {
        return station::leave(chosen(options));
    } catch (const CLI::ValidationError& error) {
        return complain(options, error.what(), station::kBadOption);
    } catch (const std::exception& error) {
        return complain(options, error.what(), station::kFailed);
    }
}
