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
    Link(const wire::JoinOptions& wanted, Seat its_seat)
        : session{wanted}, seat{its_seat}, participant{hearing_versions(wanted)} {}

    wire::JoinOptions hearing_versions(wire::JoinOptions options) {
        options.on_other_version = [this](const wire::OtherVersion& other) {
            {
                const std::scoped_lock lock{mutex};
                other_version = other.text();
            }
            news.notify_all();
        };
        return options;
    }

    template <class T>
    void file(void (Picture::*receive)(const T&, Clock::time_point), const T& sample) {
        {
            const std::scoped_lock lock{mutex};
            (picture.*receive)(sample, Clock::now());
            ++samples;
        }
        news.notify_all();
    }

    /// A reader of that topic where the seat has it.
    template <class T>
    std::optional<wire::Reader<T>> hear(bool granted, const wire::Topic<T>& topic,
                                        void (Picture::*receive)(const T&,
                                                                 Clock::time_point) = &Picture::receive) {
        if (!granted) return std::nullopt;
        return std::make_optional<wire::Reader<T>>(
            participant, topic,
            typename wire::Reader<T>::OnSample{[this, receive](const T& sample) { file(receive, sample); }});
    }

    wire::JoinOptions session;
    const Seat seat;
    // A serial must rise over a restart under the same name too, so it starts at the time of day.
    std::atomic<std::uint64_t> serial{static_cast<std::uint64_t>(
        std::chrono::duration_cast<std::chrono::milliseconds>(unix_time()).count())};
    mutable std::mutex mutex;
    mutable std::condition_variable news;
    Picture picture;
    std::optional<wire::WriterId> status_writer;
    std::uint64_t samples = 0;
    std::optional<std::string> other_version;
    wire::Participant participant;

    // Last, so that they stop before what their callbacks use goes away.
    template <class T>
    using Ear = std::optional<wire::Reader<T>>;
    Ear<ExerciseStatus> status{std::in_place, participant, wire::topics::exercise_status,
                               [this](const ExerciseStatus& sample, const wire::WriterId& writer) {
                                   {
                                       const std::scoped_lock lock{mutex};
                                       status_writer = writer;
                                   }
                                   file(&Picture::receive, sample);
                               }};
    Ear<Alert> alert = hear(on_bridge(seat) || has_truth(seat), wire::topics::alert);
    Ear<Alert> forecastle_alert =
        hear(on_forecastle(seat) || has_truth(seat), wire::topics::forecastle_alert);
    Ear<BridgeOrder> order = hear(true, wire::topics::bridge_order);
    Ear<WindlassCommand> levers = hear(true, wire::topics::windlass_command);
    Ear<HelmCommand> helm = hear(true, wire::topics::helm_command);
    Ear<WindlassCommand> instructor_levers =
        hear(true, wire::topics::instructor_windlass_command, &Picture::take_instructor);
    Ear<HelmCommand> instructor_helm =
        hear(true, wire::topics::instructor_helm_command, &Picture::take_instructor);

    Ear<ForecastleView> forecastle = hear(on_forecastle(seat), wire::topics::forecastle_view);
    Ear<BridgeView> bridge = hear(on_bridge(seat), wire::topics::bridge_view);
    Ear<Report> report = hear(on_bridge(seat), wire::topics::report);
    Ear<SeatEvent> forecastle_event =
        hear(on_forecastle(seat), wire::topics::forecastle_event, &Picture::take_forecastle_event);
    Ear<SeatEvent> bridge_event =
        hear(on_bridge(seat), wire::topics::bridge_event,
             on_forecastle(seat) ? &Picture::take_event_beside : &Picture::take_bridge_event);
    Ear<SeatEvent> forecastle_instruction =
        hear(on_forecastle(seat), wire::topics::forecastle_instruction, &Picture::take_instruction);
    Ear<SeatEvent> bridge_instruction =
        hear(on_bridge(seat), wire::topics::bridge_instruction, &Picture::take_instruction);
    Ear<Question> forecastle_question =
        hear(on_forecastle(seat), wire::topics::forecastle_question, &Picture::take_forecastle_question);
    Ear<Question> bridge_question =
        hear(on_bridge(seat), wire::topics::bridge_question, &Picture::take_bridge_question);

    Ear<ExerciseTruth> truth = hear(has_truth(seat), wire::topics::exercise_truth);
    Ear<ShipState> ship = hear(has_truth(seat), wire::topics::ship_state);
    Ear<AnchorState> anchor = hear(has_truth(seat), wire::topics::anchor_state);
    Ear<ChainState> chain = hear(has_truth(seat), wire::topics::chain_state);
    Ear<WindlassLoad> load = hear(has_truth(seat), wire::topics::windlass_load);
    Ear<Event> event = hear(has_truth(seat), wire::topics::event);
    Ear<EnvironmentState> environment = hear(seat == Seat::instructor, wire::topics::environment_state);
    Ear<Alert> server_alert = hear(seat == Seat::instructor, wire::topics::server_alert);
};

Client::Client(const wire::JoinOptions& session, Seat seat) : link_{std::make_unique<Link>(session, seat)} {}
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

bool Client::meet_server(std::chrono::duration<double> timeout) const {
    std::unique_lock lock{link_->mutex};
    const Picture& picture = link_->picture;
    const auto whole = [&] {
        return picture.status && (!has_truth(link_->seat) || picture.truth) &&
               (link_->seat != Seat::instructor || picture.environment);
    };
    link_->news.wait_for(lock, timeout, [&] { return whole() || (link_->other_version && !picture.status); });
    return bool(picture.status);
}

bool Client::server_present() const {
    return link_->status->matched() > 0;
}

std::optional<wire::WriterId> Client::status_writer() const {
    const std::scoped_lock lock{link_->mutex};
    return link_->status_writer;
}

std::optional<std::string> Client::other_version() const {
    const std::scoped_lock lock{link_->mutex};
    return link_->other_version;
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

Seat Client::seat() const {
    return link_->seat;
}

wire::Participant& Client::participant() {
    return link_->participant;
}

} // namespace windlass::station
