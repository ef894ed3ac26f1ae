#include "lesson/play_on.hpp"

#include "lesson/play.hpp"
#include "lesson/seat.hpp"

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

void play_on(run::Course& course, const std::vector<trainee::Script>& scripts,
             const std::vector<run::OrderView>& others,
             const std::function<void(const exercise::Snapshot&)>& look) {
    const exercise::ExerciseDef& def = course.exercise().def();
    const assess::Assessor& assessor = course.assessor();
    if (!assessor.assesses()) throw std::runtime_error(def.name + ": has no lesson");
    std::vector<Seat> seats = seats_of(scripts, def);
    run::RunStatus status;
    status.state = exercise::RunState::running;
    status.exercise = def.name;
    status.tick_rate_hz = def.tick_rate_hz;
    status.run = 1;
    const auto ticks = [&](double seconds) {
        return static_cast<std::uint64_t>(std::llround(seconds * def.tick_rate_hz));
    };
    const double limit = assessor.lesson()->time_limit;
    const std::uint64_t last = course.exercise().tick() + ticks(limit > 0 ? limit + 1 : kLongest);
    const auto take = [&](const exercise::Order& order) {
        course.take(
            {.run = 0, .tick = course.exercise().tick(), .number = 0, .source = {}, .command = order});
    };
    exercise::Snapshot seen;
    course.exercise().view(seen);
    look(seen);
    for (auto next = others.begin(); !assessor.ended() && course.exercise().tick() < last;) {
        for (; next != others.end() && next->tick <= course.exercise().tick(); ++next)
            take(next->command);
        if (course.exercise().tick() % ticks(kLook) == 0) {
            course.exercise().view(seen);
            const auto orders = look_and_act(seats, seen, status);
            for (const run::ReceivedOrder& order : orders)
                take(std::get<exercise::Order>(order.what));
            for (Seat& seat : seats)
                seat.take_words();
        }
        if (!course.step()) throw std::runtime_error(def.name + ": its state ceases to be finite");
        for (const exercise::Order& order : course.ordered())
            take(order);
        answer_questions(assessor, seats, take);
        for (const exercise::ExerciseEvent& event : course.seen().events)
            for (Seat& seat : seats)
                seat.notice(event, course.seen());
        if (course.ordered().empty()) {
            look(course.seen());
        } else { // as a server shows it: with what the lesson has ordered at this tick
            course.exercise().view(seen);
            look(seen);
        }
    }
}

} // namespace windlass::lesson
