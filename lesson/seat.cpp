#include "lesson/seat.hpp"

#include "server/dds/check.hpp"
#include "server/dds/convert.hpp"
#include "server/dds/order_taken.hpp"
#include "server/run/questions.hpp"
#include "station/names.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace windlass::lesson {

namespace {

using Clock = station::Clock;

/// Exercise time as the time at which a sample came: nothing is ever late here.
Clock::time_point at(double time) {
    return Clock::time_point{} +
           std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(time));
}

} // namespace

Seat::Seat(Part part, const exercise::ExerciseDef& def, std::string name)
    : side_(part.script.side),
      voice_only_(part.voice_only),
      conns_(part.script.conns),
      mate_(part.script.mate),
      keys_(part.keys),
      coach_(part.coach),
      name_(std::move(name)),
      aids_(perceive::seat_aids(def)),
      ship_(perceive::seat_ship(def)),
      answers_(part.script.answers),
      player_(std::move(part.script), side_) {
    for (const exercise::GroundTackleDef& tackle : def.tackle)
        if (static_cast<int>(tackle.side) == side_)
            levers_.windlass = {tackle.brake, 0, tackle.clutch_in, tackle.stopper_closed, false};
}

void Seat::look(const exercise::Snapshot& seen, const run::RunStatus& run) {
    const auto now = at(seen.time);
    ExerciseStatus status;
    dds::convert(seen, run, status);
    picture_.receive(status, now);
    for (const exercise::TackleView& tackle : seen.tackle) {
        ForecastleView view;
        perceive::perceive_forecastle(seen, tackle, ship_, aids_, view);
        picture_.receive(view, now);
    }
    BridgeView bridge;
    perceive::perceive_bridge(seen, ship_, bridge);
    picture_.receive(bridge, now);
    for (const exercise::BridgeOrderView& order : seen.bridge_orders) {
        BridgeOrder sample;
        dds::convert(order, run.run, sample);
        picture_.receive(sample, now);
    }
    if (coach_) look_at_truth(seen);
}

void Seat::look_at_truth(const exercise::Snapshot& seen) {
    const auto now = at(seen.time);
    const auto receive = [&](auto sample, const auto&... of) {
        dds::convert(seen, of..., sample);
        picture_.receive(sample, now);
    };
    receive(ShipState{});
    for (const exercise::TackleView& tackle : seen.tackle) {
        receive(AnchorState{}, tackle);
        receive(ChainState{}, tackle);
        receive(WindlassLoad{}, tackle);
    }
}

void Seat::notice(const exercise::ExerciseEvent& event, const exercise::Snapshot& seen) {
    if (coach_) {
        Event sample;
        dds::convert(event, sample);
        picture_.receive(sample, at(seen.time));
    }
    if (perceive::is_instruction(event)) return; // a script takes no advice
    auto noticed = perceive::perceive_event(event, seen);
    if (!noticed) return;
    noticed->number(++noticed_);
    if (noticed->forecastle())
        picture_.take_forecastle_event(*noticed, at(seen.time));
    else
        picture_.take_bridge_event(*noticed, at(seen.time));
}

void Seat::perform(const trainee::Step& step, std::vector<run::ReceivedOrder>& orders) {
    step.orders.apply(levers_);
    has_helm_ = has_helm_ || step.orders.engine || step.orders.rudder || step.orders.bow_thruster ||
                step.orders.stern_thruster;
    if (!step.say.empty()) words_.push_back(step.say);
    if (step.show)
        orders.push_back({name_, exercise::Order{exercise::LightsAndShapes{step.show->anchor_ball,
                                                                           step.show->anchor_lights}}});
    if (step.circle)
        orders.push_back({name_, exercise::Order{exercise::WatchCircleOrder{
                                     true, step.circle->x, step.circle->y, step.circle->radius}}});
    if (step.deck_work)
        orders.push_back({name_, exercise::Order{exercise::DeckWorkOrder{
                                     static_cast<exercise::Side>(side_),
                                     static_cast<exercise::DeckWork>(*step.deck_work)}}});
    if (step.report) {
        const Report& report = reports_.emplace_back(trainee::sample_of(*step.report, side_, picture_));
        orders.push_back({name_, dds::order(report)});
    }
    if (step.order)
        orders.push_back({name_, exercise::Order{exercise::BridgeOrderGiven{
                                     .code = static_cast<exercise::BridgeOrderCode>(step.order->code),
                                     .side = step.order->side.value_or(side_),
                                     .value = step.order->value,
                                     .text = step.order->text,
                                     .by = name_}}});
}

std::optional<run::ReceivedOrder> Seat::answer(const run::QuestionView& question) const {
    if (conns_ && question.forecastle) return std::nullopt; // put to another
    Question sample;
    dds::convert(question, sample);
    const auto answer = trainee::answer_to(sample, answers_);
    if (!answer) return std::nullopt;
    return run::ReceivedOrder{name_, question.forecastle ? dds::order(dds::ForecastleAnswer{*answer})
                                                         : dds::order(dds::BridgeAnswer{*answer})};
}

/// Keys set no wheel between two of their steps: he opens it until the cable runs as fast as he likes it, and
/// closes it by a step until it does not.
double Seat::wheel_by_keys() const {
    constexpr double kFast = 2; // m/s of cable, as it is seen
    const double steps = levers_.windlass.brake / kKeyStep;
    const auto& view = picture_.tackle.at(static_cast<std::size_t>(side_)).view;
    const bool fast = view && view->cable_speed_seen() >= kFast;
    // 1e-6: a step that is one but for rounding.
    return kKeyStep * (fast ? std::ceil(steps - 1e-6) : std::floor(steps + 1e-6));
}

std::vector<run::ReceivedOrder> Seat::act() {
    std::vector<run::ReceivedOrder> orders;
    for (const trainee::Step* step : player_.advance(picture_))
        perform(*step, orders);
    if (voice_only_) return orders;
    const auto& [brake, speed_lever, clutch_in, stopper_closed, emergency_stop] = levers_.windlass;
    if (!conns_)
        orders.push_back({name_, exercise::Order{exercise::WindlassOrder{
                                     static_cast<exercise::Side>(side_), keys_ ? wheel_by_keys() : brake,
                                     speed_lever, clutch_in, stopper_closed, emergency_stop}}});
    const auto& [engine, rudder, bow_thruster, stern_thruster] = levers_.helm;
    if (has_helm_)
        orders.push_back(
            {name_, exercise::Order{exercise::HelmOrder{engine, rudder, bow_thruster, stern_thruster}}});
    return orders;
}

void Seat::hear(const Report& report, double time) {
    picture_.receive(report, at(time));
}

void Seat::hear(const exercise::ReportMade& report, double time) {
    OrderTaken taken;
    dds::convert(
        run::OrderView{.run = 0, .tick = 0, .number = 0, .source = name_, .command = exercise::Order{report}},
        taken);
    hear(taken.report(), time);
}

std::vector<Report> Seat::take_reports() {
    return std::exchange(reports_, {});
}

std::vector<std::string> Seat::take_words() {
    return std::exchange(words_, {});
}

std::string Seat::waiting_for() const {
    return player_.waiting_for(picture_);
}

std::vector<run::ReceivedOrder> look_and_act(std::vector<Seat>& seats, const exercise::Snapshot& seen,
                                             const run::RunStatus& status) {
    std::vector<run::ReceivedOrder> orders;
    std::vector<Report> reports;
    for (Seat& seat : seats) {
        seat.look(seen, status);
        std::ranges::move(seat.act(), std::back_inserter(orders));
        std::ranges::move(seat.take_reports(), std::back_inserter(reports));
    }
    for (const Report& report : reports)
        for (Seat& seat : seats)
            seat.hear(report, seen.time);
    return orders;
}

std::optional<run::ReceivedOrder> answer_to(const run::QuestionView& question,
                                            const std::vector<Seat>& seats) {
    for (const Seat& seat : seats)
        if (auto answer = seat.answer(question)) return answer;
    return std::nullopt;
}

void answer_questions(const assess::Assessor& assessor, const std::vector<Seat>& seats,
                      const std::function<void(const exercise::Order&)>& take) {
    for (const bool forecastle : {true, false})
        while (assessor.open_question(forecastle) >= 0) {
            const run::QuestionView question = run::question_to(forecastle, assessor);
            const auto answer = answer_to(question, seats);
            take(answer ? std::get<run::AnswerOrder>(answer->what).answer
                        : exercise::AnswerGiven{.question = question.id,
                                                .kind = exercise::AnswerKind::passed_over});
        }
}

} // namespace windlass::lesson
