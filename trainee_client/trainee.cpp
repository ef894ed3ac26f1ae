#include "trainee_client/trainee.hpp"

#include "station/format.hpp"
#include "station/names.hpp"
#include "station/screen.hpp"

#include <fmt/format.h>

namespace windlass::trainee {

using station::Picture;

namespace {

constexpr double kServerLost = 5; // s of silence without any publisher: DDS has given the server up
constexpr int kBackspace = 0x107; // as ncurses names it; terminals also send 8 or 127
constexpr std::size_t kLongestReport = 120;

} // namespace

Trainee::Trainee(station::Client& client, int side, std::optional<Script> script, station::View& view)
    : client_{client},
      side_{side},
      view_{view},
      levers_{client, side, script ? station::LeverSender::kScriptStrength : station::LeverSender::kStrength},
      alerts_{client.participant(), wire::topics::alert_command} {
    if (station::on_forecastle(client.seat())) reports_.emplace(client.participant(), wire::topics::report);
    if (station::on_bridge(client.seat()))
        lights_and_shapes_.emplace(client.participant(), wire::topics::lights_and_shapes_command);
    if (const auto status = client.picture().status) came_at_ = status->time();
    if (script) player_.emplace(std::move(*script), side);
}

Trainee::~Trainee() {
    if (lights_and_shapes_) lights_and_shapes_->wait_acknowledged(std::chrono::seconds{1});
    if (reports_) reports_->wait_acknowledged(std::chrono::seconds{1});
}

Trainee::Outcome Trainee::work() {
    const Picture picture = client_.picture();
    const auto now = station::Clock::now();
    if (player_ && picture.replayed()) {
        reason_ = station::kReplayTakesNoOrders;
        return Outcome::server_lost;
    }
    // What is sent once, as a report is: the script begins when the server hears it.
    begun_ = begun_ || heard();
    if (picture.status)
        progress_.look(picture.time(side_), picture.status->time_scale(),
                       picture.status->state() == RUN_RUNNING, now);
    if (player_ && begun_) {
        for (const Step* step : player_->advance(picture))
            take(*step, picture);
        if (player_->failure()) {
            reason_ = *player_->failure();
            return Outcome::failed;
        }
        if (const auto refused = picture.refusal(client_.name(), {}, came_at_)) {
            reason_ = fmt::format("the server refused an order: {}", *refused);
            return Outcome::failed;
        }
    }
    if (const auto key = view_.update(picture, now)) press(*key, picture);
    if (quit_) {
        reason_ = player_ && !player_->finished() ? "stopped by hand: " + player_->waiting_for(picture) : "";
        return reason_.empty() ? Outcome::done : Outcome::failed;
    }
    if (player_ && player_->finished()) return Outcome::done;
    if (player_ && progress_.stands_still()) {
        reason_ = fmt::format("the exercise runs, but has stood still at {} for {:g} s: {}",
                              station::clock(picture.time(side_)), Progress::kStandstill,
                              player_->waiting_for(picture));
        return Outcome::failed;
    }
    if (player_ && picture.silence(now).value_or(0.0) > kServerLost && !client_.server_present()) {
        reason_ = fmt::format("the server is gone: {}", player_->waiting_for(picture));
        return Outcome::server_lost;
    }
    return Outcome::goes_on;
}

bool Trainee::heard() const {
    return (!reports_ || client_.server_hears(*reports_)) &&
           (!lights_and_shapes_ || client_.server_hears(*lights_and_shapes_));
}

std::string Trainee::waiting_for() const {
    return player_ ? player_->waiting_for(client_.picture()) : "";
}

void Trainee::take(const Step& step, const Picture& picture) {
    if (step.orders.any()) levers_.move([&step](station::LeverSet& set) { step.orders.apply(set); });
    if (!step.say.empty()) view_.note(picture, step.say);
    if (step.show) show(*step.show, picture);
    if (step.report) report(*step.report, picture);
}

void Trainee::show(const Shown& shown, const Picture& picture) {
    LightsAndShapesCommand command;
    command.origin(client_.next_origin());
    command.anchor_ball(shown.anchor_ball);
    command.anchor_lights(shown.anchor_lights);
    const bool sent = lights_and_shapes_ && lights_and_shapes_->write(command);
    view_.note(picture,
               fmt::format("{}anchor ball {}, anchor lights {}", sent ? "" : "NOT ORDERED, ",
                           shown.anchor_ball ? "hoisted" : "down", shown.anchor_lights ? "on" : "off"));
}

// Carries what was entered and nothing else.
void Trainee::report(const ReportOrder& order, const Picture& picture) {
    Report sample;
    sample.origin(client_.next_origin());
    sample.code(order.code);
    sample.side(order.side.value_or(side_));
    sample.value(order.value);
    sample.lead(order.lead);
    sample.stay(order.stay);
    sample.growing(order.growing);
    sample.weight(order.weight);
    sample.order_number(order.order_number);
    if (order.order) {
        sample.order_code(*order.order);
        if (const BridgeOrder* newest = picture.order(*order.order); newest && order.order_number == 0)
            sample.order_number(newest->number());
    }
    sample.text() = order.text;
    const bool sent = reports_ && reports_->write(sample);
    view_.note(picture, fmt::format("{}report: {}", sent ? "" : "NOT SENT, ", station::words(sample)));
}

void Trainee::press(int key, const Picture& picture) {
    if (typed_) {
        type(key, picture);
    } else if (key == 'q') {
        quit_ = true;
    } else if (key == int(station::Key::f2)) {
        acknowledge(picture);
    } else if (key == int(station::Key::f3)) {
        silence_all(picture);
    } else if (player_) {
        return; // the script has the levers and makes the reports
    } else if (key == '?') {
        for (const char* line : kHelp)
            view_.note(picture, line);
    } else if (key == 'r') {
        typed_.emplace();
        show_prompt("report");
    } else if (key == 'o') {
        repeat_back(picture);
    } else if (station::levers_known(picture, side_)) {
        // Levers are moved only from where they are known to stand. Another key moves none of them.
        levers_.move([key](station::LeverSet& set) { apply_key(key, set); });
    }
}

void Trainee::show_prompt(const std::string& question) {
    asked_ = question;
    view_.prompt(fmt::format(" {} (Enter sends, Esc drops): {}_", question, *typed_));
}

void Trainee::type(int key, const Picture& picture) {
    constexpr int kEscape = 27;
    if (key == '\n' || key == '\r') {
        enter(picture);
    } else if (key == kEscape) {
        typed_.reset();
    } else if (key == kBackspace || key == 8 || key == 127) {
        if (!typed_->empty()) typed_->pop_back();
    } else if (key >= ' ' && key < 127 && typed_->size() < kLongestReport) {
        *typed_ += static_cast<char>(key);
    }
    if (typed_) {
        show_prompt(asked_);
    } else {
        repeats_.reset();
        view_.prompt("");
    }
}

void Trainee::enter(const Picture& picture) {
    if (repeats_) {
        const auto repeated = parse_repeat(*typed_, *repeats_);
        const bool lacks_number =
            repeated && repeated->value == 0 && !station::value_unit(repeats_->code()).empty();
        const std::string question = !repeated ? "which side: port, starboard, both?"
                                     : lacks_number && asked_.find("how many") == std::string::npos
                                         ? fmt::format("how many {}?", station::value_unit(repeats_->code()))
                                         : "";
        if (!question.empty()) return show_prompt(question);
        report(*repeated, picture);
    } else if (!typed_->empty()) {
        const ReportOrder entered = parse_report(*typed_);
        // Asked once: who presses Enter again leaves it open.
        if (const auto question = left_open(entered); !question.empty() && question != asked_)
            return show_prompt(question);
        report(entered, picture);
    }
    typed_.reset();
}

// Side and number are entered, not shown as a default: a wrong hearing can show.
void Trainee::repeat_back(const Picture& picture) {
    const BridgeOrder* order = picture.order_to_repeat();
    if (!order) return view_.note(picture, "no order waits to be repeated back");
    repeats_ = *order;
    typed_.emplace();
    const auto unit = station::value_unit(order->code());
    show_prompt(fmt::format("order {}, {}: repeat side{}{}", order->number(), station::name(order->code()),
                            unit.empty() ? "" : " and ", unit));
}

void Trainee::answer(const Alert& alert, AlertAction action) {
    AlertCommand command;
    command.origin(client_.next_origin());
    command.code(alert.code());
    command.side(alert.side());
    command.action(action);
    alerts_.write(command);
}

// One at a time, as MSC.302(87) 9.9 has it: the gravest that waits, the newest of these.
void Trainee::acknowledge(const Picture& picture) {
    const Alert* topmost = nullptr;
    for (const Alert& alert : picture.alerts) {
        const bool waits =
            alert.condition() != ALERT_ACTIVE_ACKNOWLEDGED && alert.condition() != ALERT_NORMAL;
        if (waits && (!topmost || alert.priority() >= topmost->priority())) topmost = &alert;
    }
    if (!topmost) return view_.note(picture, "no alert waits to be acknowledged");
    answer(*topmost, ALERT_ACKNOWLEDGE);
    view_.note(picture, fmt::format("acknowledges: {}", topmost->text().c_str()));
}

// All by one action (9.10): a command for each.
void Trainee::silence_all(const Picture& picture) {
    int silenced = 0;
    for (const Alert& alert : picture.alerts)
        if (alert.condition() == ALERT_ACTIVE_UNACKNOWLEDGED) {
            answer(alert, ALERT_SILENCE);
            ++silenced;
        }
    view_.note(picture, fmt::format("{} alerts silenced", silenced));
}

} // namespace windlass::trainee
