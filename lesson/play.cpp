#include "lesson/play.hpp"

#include "lesson/seat.hpp"
#include "server/run/questions.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

namespace windlass::lesson {

namespace {

constexpr double kAfter = 2; // s that are played on when it is over, to see it stand still

/// What the first script that is not done has failed in or waits for; empty: all are done.
std::string stuck_at(const std::vector<Seat>& seats) {
    const auto stuck = std::ranges::find_if(
        seats, [](const Seat& seat) { return seat.failure() || !seat.waiting_for().empty(); });
    return stuck == seats.end() ? "" : stuck->failure().value_or(stuck->waiting_for());
}

/// Of the log, what a reader of the lesson wants: everything but what is in the words of others.
bool worth_telling(const exercise::ExerciseEvent& event) {
    return event.code != "levers.taken" && event.code != "exercise.ready";
}

constexpr const char* kChanceName = "chance";

/// A freeze: the seats answer, and where none knows the exercise goes on without.
void answer_at_freeze(run::Session& session, const std::vector<Seat>& seats) {
    while (session.held()) {
        run::Inbox inbox;
        for (const bool forecastle : {true, false})
            if (session.assessor().open_question(forecastle) >= 0)
                if (auto answer = answer_to(run::question_to(forecastle, session.assessor()), seats))
                    inbox.orders.push_back(std::move(*answer));
        if (inbox.orders.empty()) {
            run::RunOrder start;
            start.action = run::RunAction::start;
            inbox.orders.push_back({"instructor", start});
        }
        session.carry_out(inbox, session.snapshot().time);
    }
}

} // namespace

exercise::EnvironmentOrder another_sea(const exercise::Snapshot& seen, double more_water,
                                       unsigned other_waves) {
    constexpr double kRamp = 5; // s
    exercise::EnvironmentOrder order{seen.environment.after, std::max(kRamp, seen.environment.ramp_left)};
    order.weather.tide_height += more_water;
    order.weather.wave_seed += other_waves;
    return order;
}

Luck luck(unsigned k) {
    constexpr double kLater = 0.5; // s: no captain could tell four such hands apart
    return {.seed = 1 + k, .more_water = kMillimetre * k, .other_waves = k, .later = kLater * (k % 4)};
}

trainee::Script later(trainee::Script script, double seconds) {
    for (trainee::Step& step : script.steps)
        if (step.when.ordered || step.when.order) step.when.after = step.when.after.value_or(0) + seconds;
    return script;
}

Played play(const exercise::ExerciseDef& def, const std::vector<trainee::Script>& scripts,
            const std::function<void(run::Session&)>& tick, const Luck& luck) {
    std::vector<Part> parts;
    for (const trainee::Script& script : scripts)
        parts.push_back({.script = script});
    return play(def, parts, tick, luck);
}

Played play(const exercise::ExerciseDef& def, const std::vector<Part>& parts,
            const std::function<void(run::Session&)>& tick, const Luck& luck) {
    run::SessionOptions options;
    options.id = def.name;
    options.time_scale = 0;
    options.seed = luck.seed;
    run::Session session(def, std::move(options));
    std::vector<Seat> seats;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        Part part = parts[k];
        if (luck.later > 0) part.script = later(std::move(part.script), luck.later);
        seats.emplace_back(std::move(part), def, "trainee-" + std::to_string(k + 1));
    }

    Played played;
    const auto tell = [&](const std::string& who, const std::string& text) {
        played.told.push_back({session.snapshot().time, who, text});
    };
    const bool has_lesson = session.assessor().assesses();
    const double limit = has_lesson ? session.assessor().lesson()->time_limit : 0;
    const auto over = [&] {
        return has_lesson ? session.assessor().ended() : std::ranges::all_of(seats, &Seat::done);
    };
    const double longest = session.snapshot().time + (limit > 0 ? limit : kLongest) + kAfter;
    const auto look_every = static_cast<std::uint64_t>(std::llround(kLook * def.tick_rate_hz));
    double over_at = -1;
    const std::uint64_t began = session.snapshot().tick;
    run::Inbox inbox;
    while (session.snapshot().time < longest && (over_at < 0 || session.snapshot().time < over_at + kAfter)) {
        inbox.orders.clear();
        if (session.snapshot().tick == began && (luck.more_water != 0 || luck.other_waves != 0))
            inbox.orders.push_back(
                {kChanceName,
                 exercise::Order{another_sea(session.snapshot(), luck.more_water, luck.other_waves)}});
        if (session.snapshot().tick % look_every == 0) {
            std::ranges::move(look_and_act(seats, session.snapshot(), session.status()),
                              std::back_inserter(inbox.orders));
            for (Seat& seat : seats)
                for (const std::string& words : seat.take_words())
                    tell("trainee", words);
        }
        session.carry_out(inbox, session.snapshot().time);
        // A lesson's own look at each tick will do.
        if (!session.tick(!has_lesson)) throw std::runtime_error(def.name + ": " + session.failure());
        answer_at_freeze(session, seats);
        for (const exercise::ExerciseEvent& event : session.events()) {
            for (Seat& seat : seats)
                seat.notice(event, session.snapshot());
            if (worth_telling(event)) tell(event.code, event.text);
        }
        if (tick) tick(session);
        session.clear_news();
        if (over_at < 0 && over()) {
            over_at = session.snapshot().time;
            played.stuck = stuck_at(seats);
        }
    }
    if (over_at < 0) played.stuck = stuck_at(seats);
    if (has_lesson) played.result = session.assessor().result();
    played.time = session.snapshot().time;
    return played;
}

} // namespace windlass::lesson
