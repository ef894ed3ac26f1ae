#include "lesson/whatif/trials.hpp"

#include "lesson/play.hpp"
#include "server/assess/aids.hpp"
#include "server/assess/result.hpp"
#include "server/run/limits.hpp"
#include "server/run/questions.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace windlass::whatif {

using lesson::another_sea;
using lesson::kLongest;
using lesson::kLook;

namespace {

/// A hand's own: levers, reports, what she shows, what the men are set to; of one who has the conn also what
/// the bridge orders and watches.
bool of_a_hand(const exercise::Order& order, bool conns) {
    if (std::holds_alternative<exercise::BridgeOrderGiven>(order) ||
        std::holds_alternative<exercise::WatchCircleOrder>(order))
        return conns;
    return std::holds_alternative<exercise::WindlassOrder>(order) ||
           std::holds_alternative<exercise::HelmOrder>(order) ||
           std::holds_alternative<exercise::ReportMade>(order) ||
           std::holds_alternative<exercise::LightsAndShapes>(order) ||
           std::holds_alternative<exercise::DeckWorkOrder>(order);
}

/// What the lesson's bridge, faults and weather order: the fold orders it again where it has come to be due.
bool of_the_lesson(const run::OrderView& order) {
    return order.source == run::kServerName &&
           (std::holds_alternative<exercise::BridgeOrderGiven>(order.command) ||
            std::holds_alternative<exercise::FaultOrder>(order.command) ||
            std::holds_alternative<exercise::EnvironmentOrder>(order.command));
}

/// What was asked for in practice comes at its tick, as all else.
bool answers_a_question(const exercise::Order& order) {
    const auto* answer = std::get_if<exercise::AnswerGiven>(&order);
    return answer != nullptr && !assess::is_aid(answer->question);
}

run::Course begin_at(const run::CheckpointView& checkpoint, const Attempt& attempt) {
    assess::Assessor assessor;
    exercise::Exercise exercise = exercise::read_checkpoint(checkpoint.data, attempt.check, &assessor);
    return {std::move(exercise), std::move(assessor), checkpoint.orders_taken};
}

} // namespace

/// One way through, tick by tick.
class Trials::Walk {
public:
    Walk(const Trials& trials, const std::vector<run::OrderView>& orders, std::size_t checkpoint)
        : trials_(trials),
          orders_(orders),
          course_(begin_at(trials.attempt_.checkpoints[checkpoint], trials.attempt_)),
          look_every_(trials.ticks(kLook)) {
        const run::CheckpointView& from = trials.attempt_.checkpoints[checkpoint];
        status_.state = exercise::RunState::running;
        status_.exercise = course_.exercise().def().name;
        status_.tick_rate_hz = course_.exercise().def().tick_rate_hz;
        status_.run = 1;
        // Those that were taken before the checkpoint are in it.
        while (next_ < orders_.size() &&
               (orders_[next_].tick < from.tick ||
                (orders_[next_].number != 0 && orders_[next_].number <= from.orders_taken)))
            ++next_;
    }

    /// The model's hands stand beside from now on.
    void stand_by(Hands hands) { hands_.emplace(std::move(hands)); }
    const Hands& hands() const { return *hands_; }

    /// They have levers and voice from that tick on.
    void hand_over(std::uint64_t tick) { model_from_ = tick; }
    void put_down_into(std::vector<run::OrderView>& taken) { taken_ = &taken; }

    std::uint64_t tick() const { return course_.exercise().tick(); }
    run::Course& course() { return course_; }
    /// Number of the next recorded order; 0: there is none.
    std::uint64_t next_number() const { return next_ < orders_.size() ? orders_[next_].number : 0; }
    std::uint64_t next_tick() const { return next_ < orders_.size() ? orders_[next_].tick : UINT64_MAX; }

    /// A sea that is a little another, from now on.
    void change_sea(double more_water, bool other_gusts) {
        course_.exercise().view_unhashed(seen_);
        take(another_sea(seen_, more_water, other_gusts ? 1 : 0));
    }

    /// The recorded orders that are due.
    void take_recorded() {
        const bool model = tick() >= model_from_;
        const bool conned = hands_ && std::ranges::any_of(hands_->seats, &lesson::Seat::conns);
        for (; next_ < orders_.size() && orders_[next_].tick <= tick(); ++next_)
            if (!answers_a_question(orders_[next_].command) && // that is taken when it is asked
                (!model || !of_a_hand(orders_[next_].command, conned)))
                take(orders_[next_].command);
    }

    /// One tick: what the hands do, the step, and what the lesson orders then.
    void step() {
        if (trials_.stop_.stop_requested()) throw std::runtime_error("the search was given up");
        take_recorded();
        if (hands_ && tick() % look_every_ == 0) look(tick() >= model_from_);
        if (!course_.step()) throw std::runtime_error("the state ceases to be finite");
        for (const exercise::Order& order : course_.ordered())
            take(order);
        if (hands_ && tick() >= model_from_)
            answer_questions(course_.assessor(), hands_->seats,
                             [this](const exercise::Order& answer) { take(answer); });
        else
            answer_as_recorded();
        if (hands_)
            for (const exercise::ExerciseEvent& event : course_.seen().events)
                for (lesson::Seat& seat : hands_->seats)
                    seat.notice(event, course_.seen());
    }

private:
    void take(const exercise::Order& order) {
        const run::OrderView taken{.run = 0, .tick = tick(), .number = 0, .source = {}, .command = order};
        course_.take(taken);
        if (taken_ != nullptr) taken_->push_back(taken);
        if (const auto* report = std::get_if<exercise::ReportMade>(&order); report != nullptr && hands_)
            for (lesson::Seat& seat : hands_->seats) // as a bridge hears it, whoever has made it
                seat.hear(*report, trials_.seconds(tick()));
    }

    /// The model's hands look, and act: beside a trainee nothing comes of that, and they keep what they
    /// would have said. What he has not said by then they say as they take over.
    void look(bool acts) {
        course_.exercise().view_unhashed(seen_);
        std::vector<exercise::Order> now;
        for (lesson::Seat& seat : hands_->seats) {
            seat.look(seen_, status_);
            for (run::ReceivedOrder& order : seat.act())
                now.push_back(std::get<exercise::Order>(std::move(order.what)));
            seat.take_words();
        }
        if (!acts) {
            for (const exercise::Order& order : now)
                if (const auto* report = std::get_if<exercise::ReportMade>(&order))
                    hands_->said.push_back(*report);
            return;
        }
        for (const exercise::ReportMade& report : std::exchange(hands_->said, {}))
            if (!trials_.said_before(report, model_from_)) take(report);
        for (const exercise::Order& order : now)
            take(order);
    }

    /// A freeze may come at another tick than it did: what was answered then is answered now.
    void answer_as_recorded() {
        for (const bool forecastle : {true, false}) {
            if (course_.assessor().open_question(forecastle) < 0) continue;
            const std::string id = run::question_to(forecastle, course_.assessor()).id;
            const auto recorded = std::ranges::find_if(orders_, [&](const run::OrderView& order) {
                const auto* answer = std::get_if<exercise::AnswerGiven>(&order.command);
                return answer != nullptr && answer->question == id;
            });
            if (recorded != orders_.end()) take(recorded->command);
        }
    }

    const Trials& trials_;
    const std::vector<run::OrderView>& orders_;
    run::Course course_;
    std::uint64_t look_every_;
    std::size_t next_ = 0;
    std::optional<Hands> hands_;
    std::uint64_t model_from_ = UINT64_MAX;
    run::RunStatus status_;
    exercise::Snapshot seen_;
    std::vector<run::OrderView>* taken_ = nullptr;
};

std::uint64_t Trials::ticks(double seconds) const {
    return static_cast<std::uint64_t>(std::llround(std::max(seconds, 0.0) * tick_rate_));
}

Trials::Trials(const Attempt& attempt, const std::vector<trainee::Script>& model, std::stop_token stop)
    : attempt_(attempt), stop_(std::move(stop)) {
    if (attempt.checkpoints.empty()) throw std::runtime_error("the attempt has no checkpoint to begin at");
    std::ranges::copy_if(attempt.orders, std::back_inserter(orders_),
                         [](const run::OrderView& order) { return !of_the_lesson(order); });
    Walk walk(*this, orders_, 0);
    const exercise::ExerciseDef& def = walk.course().exercise().def();
    const assess::Assessor& assessor = walk.course().assessor();
    if (!assessor.assesses()) throw std::runtime_error(def.name + ": has no lesson");
    lesson_ = *assessor.lesson();
    tick_rate_ = def.tick_rate_hz;
    first_tick_ = walk.tick();
    levers_.helm = walk.course().exercise().helm();
    for (const exercise::GroundTackleDef& tackle : def.tackle) {
        sides_.push_back(tackle.side);
        levers_.windlass.at(static_cast<std::size_t>(tackle.side)) =
            walk.course().exercise().levers(tackle.side);
    }
    const exercise::Weather& weather = def.weather;
    has_gusts_ = (weather.gust_factor > 1 && weather.gust_period > 0) || weather.wave_height > 0 ||
                 weather.swell_height > 0;

    Hands hands;
    for (std::size_t k = 0; k < model.size(); ++k)
        hands.seats.emplace_back(lesson::Part{.script = model[k]}, def, "model-" + std::to_string(k + 1));
    beside_.push_back(hands);
    walk.stand_by(std::move(hands));
    for (std::size_t k = 1; k < attempt.checkpoints.size(); ++k) {
        const run::CheckpointView& next = attempt.checkpoints[k];
        while (walk.tick() < next.tick)
            walk.step();
        beside_.push_back(walk.hands());
        const bool all_taken = walk.next_tick() > next.tick || walk.next_number() > next.orders_taken;
        if (all_taken && walk.course().state_hash() != next.state_hash)
            throw std::runtime_error("the state at " + std::to_string(seconds(next.tick)) +
                                     " s does not come of the recorded orders, as when another version of "
                                     "the model recorded them");
    }
    while (walk.tick() < attempt.last_tick)
        walk.step();
    walk.take_recorded(); // a lesson that was ended early is so by the last of them
    if (!assessor.ended()) throw std::runtime_error(def.name + ": its lesson did not come to an end");
    recorded_ = assessor.result();
    state_ = assessor.state();
}

bool Trials::said_before(const exercise::ReportMade& report, std::uint64_t tick) const {
    return std::ranges::any_of(orders_, [&](const run::OrderView& order) {
        const auto* made = std::get_if<exercise::ReportMade>(&order.command);
        return made != nullptr && order.tick < tick && made->code == report.code &&
               made->side == report.side && made->order_number == report.order_number &&
               made->value == report.value;
    });
}

std::size_t Trials::checkpoint_before(std::uint64_t tick) const {
    // At the tick itself it may have orders in it that are to be changed.
    const auto at = std::ranges::lower_bound(attempt_.checkpoints, tick, {}, &run::CheckpointView::tick);
    return at == attempt_.checkpoints.begin()
               ? 0
               : static_cast<std::size_t>(at - attempt_.checkpoints.begin()) - 1;
}

Outcome Trials::go(const Variation& variation, const Goal& goal) {
    ++tried_;
    const std::uint64_t from = std::min(variation.from, variation.model_from.value_or(UINT64_MAX));
    const std::size_t checkpoint = checkpoint_before(from);
    Walk walk(*this, variation.orders, checkpoint);
    if (variation.model_from) {
        walk.stand_by(beside_[checkpoint]);
        walk.hand_over(*variation.model_from);
    }
    if (variation.more_water != 0 || variation.other_gusts)
        walk.change_sea(variation.more_water, variation.other_gusts);
    const assess::Assessor& assessor = walk.course().assessor();
    const std::uint64_t began = walk.tick();
    const std::uint64_t last = static_cast<std::uint64_t>(state_.begin) +
                               ticks(lesson_->time_limit > 0 ? lesson_->time_limit + 1 : kLongest);
    const auto lost = [&] {
        if (assess::verdict(*lesson_, assessor.state(), goal.criterion, goal.milli) == false) return true;
        for (std::size_t k = 0; k < lesson_->criteria.size(); ++k) // a must that was met
            if (lesson_->criteria[k].must && recorded_.criteria[k].met &&
                assess::verdict(*lesson_, assessor.state(), k, 500) == false)
                return true;
        return false;
    };
    Outcome outcome;
    bool open = true;
    while (open && !assessor.ended() && walk.tick() < last) {
        walk.step();
        open = !lost();
    }
    ticks_gone_ += walk.tick() - began;
    if (!open || !assessor.ended()) return outcome;
    outcome.result = assessor.result();
    outcome.kept = outcome.result.tenths > recorded_.tenths;
    return outcome;
}

void Trials::show(const Variation& variation, std::uint64_t from, std::uint64_t until,
                  const std::function<void(const exercise::Snapshot&, const assess::State&)>& look) {
    const std::size_t checkpoint = checkpoint_before(std::min(from, variation.from));
    Walk walk(*this, variation.orders, checkpoint);
    if (variation.model_from) {
        walk.stand_by(beside_[checkpoint]);
        walk.hand_over(*variation.model_from);
    }
    const std::uint64_t began = walk.tick();
    const assess::Assessor& assessor = walk.course().assessor();
    while (walk.tick() < until && !assessor.ended()) {
        walk.step();
        if (walk.tick() >= from && walk.tick() % ticks(kLook) == 0)
            look(walk.course().seen(), assessor.state());
    }
    ticks_gone_ += walk.tick() - began;
}

void Trials::look_at(std::uint64_t tick, const std::function<void(run::Course&)>& look) {
    Walk walk(*this, orders_, checkpoint_before(tick));
    const std::uint64_t began = walk.tick();
    while (walk.tick() < tick)
        walk.step();
    ticks_gone_ += walk.tick() - began;
    look(walk.course());
}

std::vector<run::OrderView> Trials::orders_of_model(std::uint64_t model_from, std::uint64_t until) {
    const std::size_t checkpoint = checkpoint_before(model_from);
    Walk walk(*this, orders_, checkpoint);
    walk.stand_by(beside_[checkpoint]);
    walk.hand_over(model_from);
    std::vector<run::OrderView> taken;
    walk.put_down_into(taken);
    while (walk.tick() < until && !walk.course().assessor().ended())
        walk.step();
    return taken;
}

} // namespace windlass::whatif
