#include "instructor_console/ask.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ranges>
#include <thread>

namespace windlass::console {

using station::Picture;
using namespace std::chrono_literals;

namespace {
constexpr auto kRefusalTime = 500ms;
constexpr auto kHeard = 10s;                        // a server whose status comes 5 times a second
constexpr std::chrono::duration<double> kLook{0.2}; // s, between looks whether the server is still there

/// The server reads an exercise, so that orders wait: it says so, and answers when it has read it.
bool reads(const Picture& now) {
    for (const Event& event : std::views::reverse(now.events.kept)) {
        if (event.code() == "exercise.reading") return true;
        if (event.code() == "exercise.ready") return false;
        if (event.code() == "command.refused" && event.text().to_string().starts_with("ExerciseCommand"))
            return false;
    }
    return false;
}

} // namespace

template <class Sample>
Answer ask(station::Client& client, const wire::Topic<Sample>& topic, const ServerOrder<Sample>& order,
           double timeout) {
    using Kind = Answer::Kind;
    if (client.picture().replayed())
        return {Kind::no_server, station::kReplayTakesNoOrders, client.picture()};
    const auto until = station::Clock::now() + std::chrono::duration<double>{timeout};
    const auto remaining = [until] { return std::chrono::duration<double>{until - station::Clock::now()}; };

    wire::Writer<Sample> writer{client.participant(), topic};
    while (!client.server_hears(writer)) {
        if (remaining().count() <= 0)
            return {Kind::no_server, "no server takes this order here", client.picture()};
        std::this_thread::sleep_for(std::chrono::milliseconds{10});
    }

    const Picture before = client.picture();
    Sample sample = order.sample;
    sample.origin(client.next_origin());
    if (!writer.write(sample)) return {Kind::none, "the order could not be sent", before};

    // What was so before the order proves nothing: a refusal gets time to arrive.
    const auto sure_from =
        station::Clock::now() + (order.carried_out(before, client.name()) ? kRefusalTime : 0ms);

    std::optional<std::string> refused;
    bool done = false;
    const auto answered = [&](const Picture& now) {
        refused = now.refusal(client.name(), before.logs_read());
        done = now.status && *now.status.at > sure_from && order.carried_out(now, client.name());
        return refused || done;
    };
    bool there = true;
    const auto patient = [&] { // with one that is at work, as long as it is heard
        const Picture now = client.picture();
        return remaining().count() > 0 ||
               (reads(now) && now.status && station::Clock::now() - *now.status.at < kHeard);
    };
    while (there && patient() && !client.wait(kLook, answered))
        there = client.server_present();
    if (!there) client.wait(kRefusalTime, answered); // what was under way when it went
    if (!there && !refused && !done)
        return order.ends_server
                   ? Answer{Kind::carried_out, order.done, client.picture()}
                   : Answer{Kind::none, "the server ended before it answered", client.picture()};
    if (refused) return {Kind::refused, *refused, client.picture()};
    if (done) return {Kind::carried_out, order.done, client.picture()};
    return {Kind::none, fmt::format("no answer from the server in {:g} s", timeout), client.picture()};
}

template Answer ask(station::Client&, const wire::Topic<ExerciseCommand>&, const RunOrder&, double);
template Answer ask(station::Client&, const wire::Topic<RestoreCommand>&, const ServerOrder<RestoreCommand>&,
                    double);
template Answer ask(station::Client&, const wire::Topic<FaultCommand>&, const FaultOrder&, double);
template Answer ask(station::Client&, const wire::Topic<EnvironmentCommand>&,
                    const ServerOrder<EnvironmentCommand>&, double);
template Answer ask(station::Client&, const wire::Topic<BridgeOrderCommand>&,
                    const ServerOrder<BridgeOrderCommand>&, double);
template Answer ask(station::Client&, const wire::Topic<WatchCircle>&, const ServerOrder<WatchCircle>&,
                    double);
template Answer ask(station::Client&, const wire::Topic<LightsAndShapesCommand>&,
                    const ServerOrder<LightsAndShapesCommand>&, double);
template Answer ask(station::Client&, const wire::Topic<AlertCommand>&, const ServerOrder<AlertCommand>&,
                    double);

} // namespace windlass::console
