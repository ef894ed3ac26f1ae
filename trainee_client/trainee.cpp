#include "trainee_client/trainee.hpp"

#include "station/format.hpp"
#include "station/names.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace windlass::trainee {

using station::Picture;

namespace {

/// s of wall time for which one without an answer leaves it to another at his seat.
constexpr double kAtALoss = 5;
constexpr double kServerLost = 5; // s of silence without any publisher: DDS has given the server up

} // namespace

Trainee::Trainee(station::Client& client, int side, std::optional<Script> script, station::View& view)
    : client_{client},
      side_{side},
      view_{view},
      levers_{client, side, station::LeverSender::kScriptStrength} {
    if (station::on_forecastle(client.seat())) {
        reports_.emplace(client.participant(), wire::topics::report);
        deck_works_.emplace(client.participant(), wire::topics::deck_work_command);
        answers_to_[0].emplace(client.participant(), wire::topics::forecastle_answer);
    }
    if (station::on_bridge(client.seat())) {
        lights_and_shapes_.emplace(client.participant(), wire::topics::lights_and_shapes_command);
        circles_.emplace(client.participant(), wire::topics::watch_circle);
        answers_to_[1].emplace(client.participant(), wire::topics::bridge_answer);
    }
    if (client.seat() == station::Seat::conning)
        orders_.emplace(client.participant(), wire::topics::bridge_order_command);
    if (const auto status = client.picture().status) came_at_ = status->time();
    if (!script) return;
    answers_ = script->answers;
    player_.emplace(std::move(*script), side);
}

Trainee::~Trainee() {
    for (auto& answer : answers_to_)
        if (answer) answer->wait_acknowledged(std::chrono::seconds{1});
    if (orders_) orders_->wait_acknowledged(std::chrono::seconds{1});
    if (circles_) circles_->wait_acknowledged(std::chrono::seconds{1});
    if (lights_and_shapes_) lights_and_shapes_->wait_acknowledged(std::chrono::seconds{1});
    if (deck_works_) deck_works_->wait_acknowledged(std::chrono::seconds{1});
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
            perform(*step, picture);
        answer_questions(picture, now);
        if (player_->failure()) {
            reason_ = *player_->failure();
            return Outcome::failed;
        }
        if (const auto refused = picture.refusal(client_.name(), {}, came_at_)) {
            reason_ = fmt::format("the server refused an order: {}", *refused);
            return Outcome::failed;
        }
    }
    view_.update(picture, now);
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
           (!deck_works_ || client_.server_hears(*deck_works_)) &&
           (!lights_and_shapes_ || client_.server_hears(*lights_and_shapes_)) &&
           (!circles_ || client_.server_hears(*circles_)) &&
           std::ranges::all_of(answers_to_,
                               [this](const auto& to) { return !to || client_.server_hears(*to); }) &&
           (!orders_ || client_.server_hears(*orders_));
}

std::string Trainee::waiting_for() const {
    return player_ ? player_->waiting_for(client_.picture()) : "";
}

void Trainee::perform(const Step& step, const Picture& picture) {
    if (step.orders.any()) levers_.move([&step](station::LeverSet& set) { step.orders.apply(set); });
    if (!step.say.empty()) view_.note(picture, step.say);
    if (step.show) show(*step.show, picture);
    if (step.circle) keep(*step.circle, picture);
    if (step.deck_work) set_men(*step.deck_work, picture);
    if (step.report) report(*step.report, picture);
    if (step.order) order(*step.order, picture);
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

void Trainee::keep(const Circle& circle, const Picture& picture) {
    WatchCircle command;
    command.origin(client_.next_origin());
    command.kept(true);
    command.x(circle.x);
    command.y(circle.y);
    command.radius(circle.radius);
    const bool sent = circles_ && circles_->write(command);
    view_.note(picture, fmt::format("{}anchor watch: {:g} m round x {:.0f} m, y {:.0f} m",
                                    sent ? "" : "NOT KEPT, ", circle.radius, circle.x, circle.y));
}

void Trainee::set_men(DeckWork work, const Picture& picture) {
    DeckWorkCommand command;
    command.origin(client_.next_origin());
    command.side(side_);
    command.work(work);
    const bool sent = deck_works_ && deck_works_->write(command);
    view_.note(picture, fmt::format("{}sets the men to: {}", sent ? "" : "NOT DONE, ",
                                    words::kDeckWork.at(static_cast<std::size_t>(work)).said));
}

void Trainee::order(const BridgesOrder& order, const Picture& picture) {
    BridgeOrderCommand sample;
    sample.origin(client_.next_origin());
    sample.code(order.code);
    sample.side(order.side.value_or(side_));
    sample.value(order.value);
    sample.text() = order.text;
    const bool sent = orders_ && orders_->write(sample);
    view_.note(picture, fmt::format("{}orders: {}", sent ? "" : "NOT ORDERED, ",
                                    station::words(order.code, sample.side(), order.value)));
}

/// What is asked at a freeze: by the script's answers, or in the end that he cannot tell, so that the
/// exercise goes on.
void Trainee::answer_questions(const Picture& picture, station::Clock::time_point now) {
    for (std::size_t seat = 0; seat < answers_to_.size(); ++seat) {
        const auto& asked = picture.questions.at(seat);
        auto& [id, tick, run, at_a_loss_since] = answered_.at(seat);
        if (!answers_to_.at(seat) || !asked || asked->id().size() == 0) continue;
        if (asked->id().to_string() == id && asked->tick() == tick && asked->run() == run) continue;
        auto answer = answer_to(*asked, answers_);
        if (!answer) {
            if (!at_a_loss_since) at_a_loss_since = now;
            if (now - *at_a_loss_since < std::chrono::duration<double>(kAtALoss)) continue;
            answer.emplace();
            answer->question() = asked->id();
            answer->kind(ANSWER_NOT_KNOWN);
        }
        answer->origin(client_.next_origin());
        const bool sent = answers_to_.at(seat)->write(*answer);
        at_a_loss_since.reset();
        id = asked->id().to_string(), tick = asked->tick(), run = asked->run();
        view_.note(picture,
                   fmt::format("{}asked: {} answers {}", sent ? "" : "NOT SENT, ", asked->text().to_string(),
                               answer->kind() == ANSWER_NUMBER ? fmt::format("{:g}", answer->value())
                               : answer->kind() == ANSWER_CHOICE
                                   ? asked->choices().at(answer->choice()).text().to_string()
                                   : "that he cannot tell"));
    }
}

void Trainee::report(const ReportOrder& order, const Picture& picture) {
    Report sample = sample_of(order, side_, picture);
    sample.origin(client_.next_origin());
    const bool sent = reports_ && reports_->write(sample);
    view_.note(picture, fmt::format("{}report: {}", sent ? "" : "NOT SENT, ", station::words(sample)));
}

} // namespace windlass::trainee
