#include "server/run/prediction.hpp"

#include "server/exercise/picture/published.hpp"

namespace windlass::run {

PredictedMoment moment_of(const exercise::Snapshot& seen) {
    PredictedMoment moment{.time = seen.time,
                           .x = seen.ship.position.x(),
                           .y = seen.ship.position.y(),
                           .heading = seen.ship.heading,
                           .cables = {}};
    for (const exercise::TackleView& tackle : seen.tackle)
        moment.cables.push_back({.side = tackle.side,
                                 .cable_out = tackle.windlass.cable_out,
                                 .cable_speed = tackle.windlass.cable_speed,
                                 .hawse_tension = tackle.windlass.hawse_tension,
                                 .gypsy_load = tackle.windlass.gypsy_load,
                                 .brake_load = tackle.windlass.brake_load,
                                 .lining_temperature = tackle.windlass.lining_temperature,
                                 .anchor = tackle.anchor.phase});
    return moment;
}

Branch::Branch(const std::vector<std::uint8_t>& checkpoint, std::uint64_t run)
    : course_(course_of(checkpoint)) {
    found_.run = run;
    found_.tick = course_.exercise().tick();
    found_.time = course_.exercise().time();
    found_.state = PredictionState::awaited;
    look();
    if (course_.exercise().foreign()) {
        // How she goes on is another simulator's to say.
        found_.state = PredictionState::foreign;
        found_.moments.clear();
    } else if (asks()) {
        found_.state = PredictionState::asked;
    }
}

bool Branch::asks() const {
    return course_.assessor().open_question(true) >= 0 || course_.assessor().open_question(false) >= 0;
}

/// A branch whose figures are not finite shows none of them: the server would stop there, too.
void Branch::look() {
    course_.exercise().view_unhashed(seen_);
    if (exercise::is_finite(seen_))
        found_.moments.push_back(moment_of(seen_));
    else
        found_.state = PredictionState::stopped;
}

void Branch::note_events() {
    if (!course_.exercise().called() || found_.events.size() == kMostEvents) return;
    course_.exercise().view_unhashed(seen_);
    for (const exercise::ExerciseEvent& event : seen_.events)
        if (found_.events.size() < kMostEvents) found_.events.push_back(event);
}

bool Branch::step() {
    if (found_.state != PredictionState::awaited) return false;
    if (!course_.step()) {
        found_.state = PredictionState::stopped;
        return false;
    }
    note_events();
    for (const exercise::Order& order : course_.ordered())
        course_.take({.run = 0, .tick = 0, .number = 0, .source = {}, .command = order});
    if (asks()) found_.state = PredictionState::asked;
    const auto second = static_cast<std::uint64_t>(course_.exercise().def().tick_rate_hz);
    const std::uint64_t gone = course_.exercise().tick() - found_.tick;
    if (found_.state != PredictionState::asked && gone % second != 0) return true;
    look();
    if (found_.state == PredictionState::awaited && gone == kSeconds * second)
        found_.state = PredictionState::whole;
    return found_.state == PredictionState::awaited;
}

} // namespace windlass::run
