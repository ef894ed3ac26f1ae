#include "instructor_console/ask.hpp"

#include <fmt/format.h>

#include <thread>

namespace windlass::console {

using station::Picture;

bool meet_server(const station::Client& client, double timeout) {
    return client.wait(std::chrono::duration<double>{timeout},
                       [](const Picture& picture) { return bool(picture.status); });
}

template <class Sample>
Answer ask(station::Client& client, const wire::Topic<Sample>& topic, const Order<Sample>& order,
           const std::string& name, double timeout) {
    using Kind = Answer::Kind;
    const auto until = station::Clock::now() + std::chrono::duration<double>{timeout};
    const auto remaining = [until] { return std::chrono::duration<double>{until - station::Clock::now()}; };

    wire::Writer<Sample> writer{client.participant(), topic};
    while (writer.matched() == 0) {
        if (remaining().count() <= 0)
            return {Kind::no_server, "no server takes this order here", client.picture()};
        std::this_thread::sleep_for(std::chrono::milliseconds{10});
    }

    const Picture before = client.picture();
    const auto sent_at = station::Clock::now();
    Sample sample = order.sample;
    sample.origin(client.next_origin());
    if (!writer.write(sample)) return {Kind::none, "the order could not be sent", before};

    std::optional<std::string> refused;
    bool done = false;
    client.wait(remaining(), [&](const Picture& now) {
        refused = refusal(now, before.events_received, name);
        done = now.status && *now.status.at > sent_at && order.carried_out(before, now);
        return refused || done;
    });
    if (refused) return {Kind::refused, *refused, client.picture()};
    if (done) return {Kind::carried_out, order.done, client.picture()};
    return {Kind::none, fmt::format("no answer from the server in {:g} s", timeout), client.picture()};
}

template Answer ask(station::Client&, const wire::Topic<ExerciseCommand>&, const RunOrder&,
                    const std::string&, double);
template Answer ask(station::Client&, const wire::Topic<FaultCommand>&, const FaultOrder&, const std::string&,
                    double);

} // namespace windlass::console
