#include "station/client.hpp"

#include <atomic>
#include <condition_variable>
#include <mutex>

namespace windlass::station {

namespace {

std::chrono::nanoseconds unix_time() {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(
        std::chrono::system_clock::now().time_since_epoch());
}

} // namespace

struct Client::Link {
    explicit Link(const wire::JoinOptions& wanted) : session{wanted}, participant{wanted} {}

    template <class T>
    std::function<void(const T&)> filed() {
        return [this](const T& sample) {
            {
                const std::scoped_lock lock{mutex};
                picture.take(sample, Clock::now());
                ++samples;
            }
            news.notify_all();
        };
    }

    wire::JoinOptions session;
    // A serial must rise over a restart under the same name too, so it starts at the time of day.
    std::atomic<std::uint64_t> serial{static_cast<std::uint64_t>(
        std::chrono::duration_cast<std::chrono::milliseconds>(unix_time()).count())};
    mutable std::mutex mutex;
    mutable std::condition_variable news;
    Picture picture;
    std::uint64_t samples = 0;
    wire::Participant participant;

    // Last, so that they stop before what their callbacks use goes away.
    wire::Reader<ExerciseStatus> status{participant, wire::topics::exercise_status, filed<ExerciseStatus>()};
    wire::Reader<ShipState> ship{participant, wire::topics::ship_state, filed<ShipState>()};
    wire::Reader<AnchorState> anchor{participant, wire::topics::anchor_state, filed<AnchorState>()};
    wire::Reader<ChainState> chain{participant, wire::topics::chain_state, filed<ChainState>()};
    wire::Reader<WindlassLoad> load{participant, wire::topics::windlass_load, filed<WindlassLoad>()};
    wire::Reader<Event> event{participant, wire::topics::event, filed<Event>()};
    wire::Reader<Alert> alert{participant, wire::topics::alert, filed<Alert>()};
    wire::Reader<WindlassCommand> levers{participant, wire::topics::windlass_command,
                                         filed<WindlassCommand>()};
    wire::Reader<HelmCommand> helm{participant, wire::topics::helm_command, filed<HelmCommand>()};
};

Client::Client(const wire::JoinOptions& session) : link_{std::make_unique<Link>(session)} {}
Client::~Client() = default;

Picture Client::picture() const {
    const std::scoped_lock lock{link_->mutex};
    return link_->picture;
}

bool Client::wait(std::chrono::duration<double> timeout,
                  const std::function<bool(const Picture&)>& condition) const {
    std::unique_lock lock{link_->mutex};
    return link_->news.wait_for(lock, timeout, [&] { return condition(link_->picture); });
}

void Client::wait_for_news(std::chrono::duration<double> timeout) const {
    std::unique_lock lock{link_->mutex};
    link_->news.wait_for(lock, timeout, [this, before = link_->samples] { return link_->samples != before; });
}

bool Client::server_present() const {
    return link_->status.matched() > 0;
}

Origin Client::next_origin() {
    Origin origin;
    origin.source() = link_->session.name;
    origin.serial(++link_->serial);
    origin.sent_unix_ns(unix_time().count());
    return origin;
}

const std::string& Client::name() const {
    return link_->session.name;
}

wire::Participant& Client::participant() {
    return link_->participant;
}

} // namespace windlass::station
