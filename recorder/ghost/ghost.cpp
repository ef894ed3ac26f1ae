#include "recorder/ghost.hpp"

#include "lesson/play_on.hpp"
#include "recorder/debrief/attempt_reader.hpp"
#include "recorder/resimulate/resimulation.hpp"
#include "server/dds/convert.hpp"
#include "server/run/limits.hpp"

#include "idl/topics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace windlass::recorder {

namespace {

namespace fs = std::filesystem;
using exercise::Snapshot;

/// The run in which the attempt began: the first, where its server was lost on the way.
const Run& first_run(const std::vector<Run>& runs, const debrief::Attempt& attempt) {
    const debrief::Origin& origin = attempt.origin;
    const std::uint64_t number = origin.taken_up_from.empty() ? origin.run : origin.taken_up_from.front();
    const auto found = std::ranges::find(runs, number, &Run::number);
    if (found == runs.end() || found->first_checkpoint() == nullptr)
        throw Gap("no Checkpoint of the attempt is in the recording");
    return *found;
}

/// What did not come of the trainees' hands, and does not come of the lesson by itself. conned: hands of the
/// model give the orders of the bridge.
bool stays(const run::OrderView& order, bool conned) {
    const bool by_hand = order.source != run::kServerName;
    if (std::holds_alternative<exercise::FaultOrder>(order.command) ||
        std::holds_alternative<exercise::EnvironmentOrder>(order.command))
        return by_hand;
    if (std::holds_alternative<exercise::BridgeOrderGiven>(order.command)) return by_hand && !conned;
    return std::holds_alternative<exercise::ChanceDrawn>(order.command) ||
           std::holds_alternative<exercise::OwnShipSample>(order.command);
}

std::vector<trainee::Script> scripts_of(const assess::Lesson& lesson, const fs::path& config) {
    if (lesson.model_run.scripts.empty())
        throw std::runtime_error(fmt::format("lesson {} names no model run", lesson.id));
    std::vector<trainee::Script> scripts;
    for (const std::string& script : lesson.model_run.scripts) {
        const fs::path file = config / script;
        if (!fs::exists(file))
            throw std::runtime_error(file.string() + ": is not there; --config says where the lesson's "
                                                     "scripts are");
        scripts.push_back(trainee::load_script(file, trainee::Eyes::seat));
    }
    return scripts;
}

/// Puts down what a recorder would have heard, at the rates at which it hears it.
class Listener {
public:
    Listener(debrief::Attempt& ghost, double interval, int tick_rate)
        : reader_(ghost, interval), tick_rate_(tick_rate) {}

    void hear(const Snapshot& seen) {
        for (const exercise::ExerciseEvent& event : seen.events) {
            Event sample;
            dds::convert(event, sample);
            sample.number(++events_);
            reader_.add(sample);
        }
        if (is_due(seen.tick, wire::topics::ship_state.rate, states_)) {
            dds::convert(seen, ship_);
            reader_.add(ship_);
            for (const exercise::TackleView& tackle : seen.tackle) {
                dds::convert(seen, tackle, anchor_);
                reader_.add(anchor_);
            }
        }
        if (is_due(seen.tick, wire::topics::windlass_load.rate, loads_))
            for (const exercise::TackleView& tackle : seen.tackle) {
                dds::convert(seen, tackle, load_);
                reader_.add(load_);
            }
    }
    void hear(const assess::Result& result) {
        Assessment marks;
        dds::convert(result, marks);
        reader_.add(marks);
        reader_.finish();
    }

private:
    bool is_due(std::uint64_t tick, double rate, std::optional<double>& period) const {
        const double now = std::floor(static_cast<double>(tick) * rate / tick_rate_);
        if (period == now) return false;
        period = now;
        return true;
    }

    debrief::AttemptReader reader_;
    int tick_rate_; // Hz
    std::uint64_t events_ = 0;
    std::optional<double> states_, loads_; // period of the rate that was heard last
    ShipState ship_;
    AnchorState anchor_;
    WindlassLoad load_;
};

} // namespace

debrief::Attempt model_ghost(recording::Recording& recording, const debrief::Attempt& attempt,
                             const fs::path& config) {
    const auto runs = runs_of(recording);
    const Run& run = first_run(runs, attempt);
    const Mark& beginning = *run.first_checkpoint();
    run::Course course = course_at(recording, run, beginning);
    const assess::Assessor& assessor = course.assessor();
    if (!assessor.assesses()) throw std::runtime_error(attempt.exercise + ": has no lesson");
    if (assessor.state().begin != static_cast<std::int64_t>(course.exercise().tick()))
        throw Gap("the recording has no state of the lesson's beginning");
    const auto scripts = scripts_of(*assessor.lesson(), config);
    const bool conned = std::ranges::any_of(scripts, &trainee::Script::conns);
    std::vector<run::OrderView> others;
    std::ranges::copy_if(run.orders, std::back_inserter(others), [&](const run::OrderView& order) {
        return order.number > beginning.orders_taken && stays(order, conned);
    });

    debrief::Attempt ghost;
    ghost.exercise = attempt.exercise;
    ghost.title = attempt.title;
    ghost.definition_hash = attempt.definition_hash;
    ghost.dt = attempt.dt;
    ghost.depth = attempt.depth;
    ghost.length_overall = attempt.length_overall;
    ghost.beam = attempt.beam;
    ghost.began = beginning.time;
    ghost.ended = std::numeric_limits<double>::infinity();
    Listener listener(ghost, debrief::AttemptReader::interval_of(attempt),
                      course.exercise().def().tick_rate_hz);
    double ended = ghost.began;
    lesson::play_on(course, scripts, others, [&](const Snapshot& seen) {
        listener.hear(seen);
        ended = seen.time;
    });
    listener.hear(assessor.result());
    ghost.ended = ended;
    return ghost;
}

} // namespace windlass::recorder
