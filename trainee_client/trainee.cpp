#include "trainee_client/trainee.hpp"

#include "station/format.hpp"
#include "station/names.hpp"

#include <fmt/format.h>

namespace windlass::trainee {

using station::Picture;

namespace {

constexpr int kStrength = 10;     // of the levers; the instructor's 20 takes them over
constexpr double kServerLost = 5; // s of silence without any publisher: DDS has given the server up
constexpr int kBackspace = 0x107; // as ncurses names it; terminals also send 8 or 127
constexpr std::size_t kLongestReport = 120;

} // namespace

Trainee::Trainee(station::Client& client, int side, std::optional<Script> script, station::View& view)
    : client_{client},
      side_{side},
      view_{view},
      levers_{client, side, kStrength},
      reports_{client.participant(), wire::topics::report} {
    if (const auto status = client.picture().status) came_at_ = status->time();
    if (script) player_.emplace(std::move(*script), side);
}

Trainee::~Trainee() {
    reports_.wait_acknowledged(std::chrono::seconds{1});
}

Trainee::Outcome Trainee::work() {
    const Picture picture = client_.picture();
    const auto now = station::Clock::now();
    if (player_ && picture.replayed()) {
        reason_ = station::kReplayTakesNoOrders;
        return Outcome::server_lost;
    }
    // A report is sent once: the script begins when somebody is there to hear it.
    begun_ = begun_ || reports_.matched() > 0;
    if (player_ && begun_) {
        for (const Step* step : player_->advance(picture))
            take(*step, picture);
        if (player_->failure()) {
            reason_ = *player_->failure();
            return Outcome::failed;
        }
        if (const auto refused = picture.refusal(client_.name(), 0, came_at_)) {
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
    if (player_ && picture.silence(now).value_or(0) > kServerLost && !client_.server_present()) {
        reason_ = fmt::format("the server is gone: {}", player_->waiting_for(picture));
        return Outcome::server_lost;
    }
    return Outcome::goes_on;
}

std::string Trainee::waiting_for() const {
    return player_ ? player_->waiting_for(client_.picture()) : "";
}

void Trainee::take(const Step& step, const Picture& picture) {
    if (step.orders.any()) levers_.move([&step](station::LeverSet& set) { step.orders.apply(set); });
    if (!step.say.empty()) view_.note(picture, step.say);
    if (step.report) report(*step.report, picture);
}

void Trainee::report(const ReportOrder& order, const Picture& picture) {
    Report sample;
    sample.origin(client_.next_origin());
    sample.code(order.code);
    sample.side(side_);
    sample.value(order.value);
    sample.text() = order.text;
    if (const auto& chain = picture.tackle.at(static_cast<std::size_t>(side_)).chain)
        sample.stay(chain->stay());
    const std::string words = order.text.empty() ? station::words(order.code, order.value) : order.text;
    const bool sent = reports_.write(sample);
    view_.note(picture, fmt::format("{}report: {}", sent ? "" : "NOT SENT, ", words));
}

void Trainee::press(int key, const Picture& picture) {
    constexpr int kEscape = 27;
    if (typed_) { // a report is being typed
        if (key == '\n' || key == '\r') {
            if (!typed_->empty()) report(parse_report(*typed_), picture);
            typed_.reset();
        } else if (key == kEscape) {
            typed_.reset();
        } else if (key == kBackspace || key == 8 || key == 127) {
            if (!typed_->empty()) typed_->pop_back();
        } else if (key >= ' ' && key < 127 && typed_->size() < kLongestReport) {
            *typed_ += static_cast<char>(key);
        }
        view_.prompt(typed_ ? " report (Enter sends, Esc drops): " + *typed_ + "_" : "");
    } else if (key == 'q') {
        quit_ = true;
    } else if (!player_ && key == 'r') {
        typed_.emplace();
        view_.prompt(" report (Enter sends, Esc drops): _");
    } else if (!player_ && picture.tackle.at(static_cast<std::size_t>(side_)).load) {
        // Levers are moved only from where they are known to stand.
        station::LeverSet tried;
        if (apply_key(key, tried)) levers_.move([key](station::LeverSet& set) { apply_key(key, set); });
    }
}

} // namespace windlass::trainee
