#pragma once
// What each command of the console does: joins the exercise, asks, and tells how it went.

#include "instructor_console/bridge_options.hpp"
#include "instructor_console/classroom_command.hpp"
#include "instructor_console/fault_options.hpp"
#include "instructor_console/history/history_command.hpp"
#include "instructor_console/hold.hpp"
#include "instructor_console/orders.hpp"
#include "instructor_console/weather_options.hpp"
#include "station/gateway/ui.hpp"
#include "station/options.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <unistd.h>

namespace windlass::console::command {

/// Everything that the command line sets; a command reads its own.
struct Options {
    station::SessionOptions session{.name = fmt::format("console-{}", getpid())};
    double timeout = 10;
    bool as_json = false;

    double time_scale = 1;
    std::string restore_to;
    std::size_t run = 0;
    std::string file;
    bool practice = false; ///< load: its lesson is played for practice
    std::string bookmark;
    bool no_more = false; ///< predict: off

    std::string side = "port";
    console::WeatherOptions weather;
    console::FaultOptions fault;
    console::BridgeOrderOptions order;
    console::WatchOptions circle;
    console::SignalOptions signals;
    std::string alert;      ///< code
    std::string alert_side; ///< empty: whichever it is of

    double duration = 0;

    console::LeverWish levers;

    console::ClassroomOptions classroom;

    history::HistoryOptions history;

    gateway::UiOptions pages;
    std::filesystem::path recordings = "recordings";
    std::filesystem::path exercises = "config/exercises";
};

// Each returns the program's exit code (station/options.hpp), and throws std::exception with what is wrong.

int status(const Options& options);
int give_run_order(const Options& options, RunOrder order); ///< start, pause, step, time scale, end
int snapshot(const Options& options);                       ///< waits until the checkpoint is heard
int restore(const Options& options);                        ///< from this run or a recording
int bookmark(const Options& options);
int environment(const Options& options);
int list_faults(const Options& options); ///< every code; needs no server
int fault(const Options& options);
int bridge_order(const Options& options);
int list_orders(const Options& options);
int watch_circle(const Options& options);
int lights_and_shapes(const Options& options);
int list_alerts(const Options& options);
int answer_alerts(const Options& options, AlertAction action); ///< acknowledges one, or silences one or all
int levers(const Options& options);                            ///< until the duration's end or Ctrl-C
int watch(const Options& options);
/// Hosts the instructor's pages. Also before there is a server: the pages say that nothing is heard.
int host_pages(const Options& options);
int classroom(const Options& options);

/// Something did not go as ordered: one line on stderr, or one object on stdout. Returns code.
int complain(const Options& options, const std::string& text, int code);

} // namespace windlass::console::command
