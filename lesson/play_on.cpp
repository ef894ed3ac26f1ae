#include "lesson/play_on.hpp"

#include "lesson/play.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace windlass::lesson {

namespace {

std::vector<Seat> seats_of(const std::vector<trainee::Script>& scripts, const exercise::ExerciseDef& def) {
    std::vector<Seat> seats;
    for (const trainee::Script& script : scripts)
        seats.emplace_back(Part{.script = script}, def, "model-" + std::to_string(seats.size() + 1));
    return seats;
}

} // namespace

PlayedOn::PlayedOn(run::Course& course, const std::vector<trainee::Script>& scripts)
    : course_(course), seats_(seats_of(scripts, course.exercise().def())) {
    const exercise::ExerciseDef& def = course.exercise().def();
    if (!course.assessor().assesses()) throw std::runtime_error(def.name + ": has no lesson");
    status_.state = exercise::RunState::running;
    status_.exercise = def.name;
    status_.tick_rate_hz = def.tick_rate_hz;
    status_.run = 1;
    const auto ticks = [&](double seconds) {
        return static_cast<std::uint64_t>(std::llround(seconds * def.tick_rate_hz));
    };
    const double limit = course.assessor().lesson()->time_limit;
    look_every_ = ticks(kLook);
    last_ = course.exercise().tick() + ticks(limit > 0 ? limit + 1 : kLongest);
}

void PlayedOn::take(const exercise::Order& order) {
    course_.take({.run = 0, .tick = course_.exercise().tick(), .number = 0, .source = {}, .command = order});
    seen_is_now_ = false;
}

bool PlayedOn::over() const {
    return course_.assessor().ended() || course_.exercise().tick() >= last_;
}

bool PlayedOn::conned() const {
    return std::ranges::any_of(seats_, &Seat::conns);
}

void PlayedOn::step() {
    if (course_.exercise().tick() % look_every_ == 0) {
        course_.exercise().view_unhashed(seen_);
        const auto orders = look_and_act(seats_, seen_, status_);
        for (const run::ReceivedOrder& order : orders)
            take(std::get<exercise::Order>(order.what));
        for (Seat& seat : seats_)
            seat.take_words();
    }
    if (!course_.step())
        throw std::runtime_error(course_.exercise().def().name + ": its state ceases to be finite");
    seen_is_now_ = false;
    for (const exercise::Order& order : course_.ordered())
        take(order);
    answer_questions(course_.assessor(), seats_, [this](const exercise::Order& answer) { take(answer); });
    for (const exercise::ExerciseEvent& event : course_.seen().events)
        for (Seat& seat : seats_)
            seat.notice(event, course_.seen());
}

const exercise::Snapshot& PlayedOn::seen() {
    if (!std::exchange(seen_is_now_, true)) course_.exercise().view_unhashed(seen_);
    return seen_;
}

void play_on(run::Course& course, const std::vector<trainee::Script>& scripts,
             const std::vector<run::OrderView>& others,
             const std::function<void(const exercise::Snapshot&)>& look) {
    PlayedOn hands(course, scripts);
    look(hands.seen());
    for (auto next = others.begin(); !hands.over();) {
        for (; next != others.end() && next->tick <= course.exercise().tick(); ++next)
            hands.take(next->command);
        hands.step();
        // What was ordered at this tick is in no picture of the step.
        look(course.ordered().empty() ? course.seen() : hands.seen());
    }
}

} // namespace windlass::lesson
