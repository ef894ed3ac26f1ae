// The instructor's console, one command at a time: what the exercise does, and what shall go wrong.

#include "instructor_console/commands.hpp"
#include "instructor_console/lesson_command.hpp"
#include "instructor_console/lesson_files.hpp"
#include "instructor_console/recording_position.hpp"

#include <iostream>

using namespace windlass;
namespace command = console::command;
using command::Options;

namespace {

using Command = std::function<int(const Options&)>;

/// One subcommand: what it does is called after parsing.
CLI::App& add(CLI::App& app, const char* name, const char* text, Command& chosen, const Command& command) {
    CLI::App* sub = app.add_subcommand(name, text);
    sub->callback([&chosen, command] { chosen = command; });
    return *sub;
}

void add_run_commands(CLI::App& app, Options& options, Command& chosen) {
    add(app, "status", "what the exercise does now", chosen, command::status);
    add(app, "start", "let the exercise run", chosen,
        [](const Options& o) { return command::give_run_order(o, console::start_order()); });
    add(app, "pause", "hold the exercise", chosen,
        [](const Options& o) { return command::give_run_order(o, console::pause_order()); });
    add(app, "reset", "back to the start of the exercise", chosen,
        [](const Options& o) { return command::give_run_order(o, console::reset_order()); });
    add(app, "stop", "end the exercise", chosen,
        [](const Options& o) { return command::give_run_order(o, console::stop_order()); });
    add(app, "snapshot", "keep the exercise as it stands, to come back to it", chosen, command::snapshot);
    CLI::App& back =
        add(app, "restore", "go on from an earlier moment of this exercise, or of a recording; paused",
            chosen, command::restore);
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
        [](const Options& o) { return command::give_run_order(o, console::time_scale_order(o.time_scale)); })
        .add_option("scale", options.time_scale, "0.1 to 20, or 0 for as fast as possible")
        ->required();
    CLI::App& load = add(app, "load", "load another exercise", chosen, [](const Options& o) {
        return command::give_run_order(o, console::load_order(o.file, o.practice));
    });
    load.add_option("file", options.file, "its file in the server's exercise folder")->required();
    load.add_flag("--practice", options.practice,
                  "its lesson is played for practice: with hints, and not as a test");
    add(app, "bookmark", "put a word into the log and the recording, at this moment", chosen,
        command::bookmark)
        .add_option("text", options.bookmark, "the word")
        ->required()
        ->check([](const std::string& text) {
            return !text.empty() && text.size() <= 127 ? "" : std::string{"1 to 127 characters are allowed"};
        });
    add(app, "predict", "look a minute ahead, again and again: how it would go on if nobody did anything",
        chosen,
        [](const Options& o) { return command::give_run_order(o, console::predict_order(!o.no_more)); })
        .add_flag("--off", options.no_more, "no more");
    CLI::App& air =
        add(app, "environment", "change wind, waves, current, tide and light; what is not given stays",
            chosen, command::environment);
    options.weather.add_to(air);
}

void add_side(CLI::App& app, Options& options) {
    app.add_option("--side", options.side, "windlass concerned")
        ->check(CLI::IsMember({"port", "starboard"}))
        ->capture_default_str();
}

void add_fault_commands(CLI::App& app, Options& options, Command& chosen) {
    add(app, "faults", "every fault code with what it does", chosen, command::list_faults);
    CLI::App& sub = add(app, "fault", "raise, arm or clear a fault", chosen, command::fault);
    add_side(sub, options);
    options.fault.add_to(sub);
}

void add_bridge_commands(CLI::App& app, Options& options, Command& chosen) {
    options.order.add_to(
        add(app, "order", "an order of the bridge to the forecastle", chosen, command::bridge_order));
    add(app, "orders", "the bridge's orders of this run, and whether they were repeated back", chosen,
        command::list_orders);
    CLI::App& circle = add(app, "watch-circle", "anchor watch: an alert when the ship leaves a circle",
                           chosen, command::watch_circle);
    options.circle.add_to(circle);
    circle.require_option(1, 0);
    CLI::App& signals = add(app, "lights-and-shapes", "what she shows at anchor: ball, lights, or neither",
                            chosen, command::lights_and_shapes);
    options.signals.add_to(signals);
    signals.require_option(1, 0);
}

void add_alerts(CLI::App& app, Options& options, Command& chosen) {
    CLI::App& sub = *app.add_subcommand("alerts", "what sounds and stands");
    sub.fallthrough();
    sub.require_subcommand(1);
    add(sub, "list", "each that stands, with what to do", chosen, command::list_alerts);
    const auto which = [&options](CLI::App& command, const char* text) {
        command.add_option("code", options.alert, text)->required();
        command.add_option("--side", options.alert_side, "where two of that code stand")
            ->check(CLI::IsMember({"port", "starboard", "neither"}));
    };
    which(add(sub, "acknowledge", "one alert, or both sides' of one code", chosen,
              [](const Options& o) { return command::answer_alerts(o, ALERT_ACKNOWLEDGE); }),
          "its code, as in the list");
    which(add(sub, "silence", "for a while; what is not acknowledged sounds again", chosen,
              [](const Options& o) { return command::answer_alerts(o, ALERT_SILENCE); }),
          "its code, or all");
}

void add_levers(CLI::App& app, Options& options, Command& chosen) {
    CLI::App& sub = add(app, "levers",
                        "take the levers over from the trainee, and hand them back at the end or on Ctrl-C",
                        chosen, command::levers);
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
    CLI::App& sub = add(app, "watch", "the truth, line by line, until Ctrl-C or the duration's end", chosen,
                        command::watch);
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
                        chosen, command::host_pages);
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
    app.add_option(
           "--timeout", options.timeout,
           "seconds to wait for the server and for its answer; a classroom's that is heard is waited for "
           "up to a minute")
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
    console::add_classroom(app, options.classroom, [&chosen] { chosen = command::classroom; });
    history::add_history(app, options.history, [&chosen] {
        chosen = [](const Options& o) {
            history::carry_out(o.history, o.as_json, console::offered_lessons);
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
        return command::complain(options, error.what(), station::kBadOption);
    } catch (const std::exception& error) {
        return command::complain(options, error.what(), station::kFailed);
    }
}
