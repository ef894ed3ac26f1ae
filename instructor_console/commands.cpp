#include "instructor_console/commands.hpp"

#include "instructor_console/ask.hpp"
#include "instructor_console/pages.hpp"
#include "instructor_console/recording_position.hpp"
#include "instructor_console/status_text.hpp"
#include "station/json_view.hpp"
#include "station/line_view.hpp"
#include "station/names.hpp"
#include "station/view.hpp"
#include "words/words.hpp"

#include <nlohmann/json.hpp>

#include <atomic>
#include <iostream>
#include <thread>

namespace windlass::console::command {

using nlohmann::json;
using station::to_json;

int complain(const Options& options, const std::string& text, int code) {
    if (options.as_json)
        std::cout << json{{"ok", false}, {"error", text}, {"exit_code", code}} << std::endl;
    else
        std::cerr << "instructor_console: " << text << std::endl;
    return code;
}

namespace {

int side_of(const Options& options) {
    return options.side == "starboard" ? SIDE_STARBOARD : SIDE_PORT;
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
    const console::ServerOrder<Sample> order = make(client.picture());
    return tell(options, console::ask(client, topic, order, options.timeout));
}

} // namespace

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
    const auto order = console::environment_order(options.weather.wanted, picture);
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

int lights_and_shapes(const Options& options) {
    return give(options, wire::topics::lights_and_shapes_command, [&](const station::Picture&) {
        return console::lights_and_shapes(options.signals.ball, options.signals.lights);
    });
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
    station::catch_stop_signals();
    const auto joined = join(options);
    if (!joined) return station::kNoServer;
    station::Client& client = *joined;
    const auto view =
        station::make_view({.kind = options.as_json ? station::ViewKind::json : station::ViewKind::line,
                            .who = station::Onlooker::instructor,
                            .side = side_of(options)});
    const auto started = station::Clock::now();
    while (!station::stop_asked()) {
        const auto now = station::Clock::now();
        if (options.duration > 0 && std::chrono::duration<double>{now - started}.count() > options.duration)
            break;
        view->update(client.picture(), now);
        client.wait_for_news(std::chrono::milliseconds{100});
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

int host_pages(const Options& options) {
    return gateway::serve_pages(options.pages,
                                instructor_pages(options.session, options.recordings, options.exercises));
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

} // namespace windlass::console::command
