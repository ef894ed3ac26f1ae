#include "server/dds/publisher.hpp"

#include "server/dds/convert.hpp"
#include "server/dds/order_taken.hpp"
#include "server/perceive/landmarks.hpp"
#include "server/perceive/scene.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::dds {

namespace {

constexpr double kIdleRate = 5;       // Hz, of an exercise that stands still
constexpr double kStatusPeriod = 0.2; // s of wall time
constexpr std::size_t kFrames = 16;   // a quarter of a second behind at 60 Hz
constexpr std::size_t kEvents = 4096;
constexpr std::size_t kInstructions = 256; // a lesson has 32 hints, and some dozens of pieces of briefings
constexpr std::size_t kQuestions = 16;
constexpr std::size_t kPredictions = 4;
constexpr std::size_t kGhosts = 8; // of two windlasses, at 10 Hz
constexpr std::size_t kAlerts = 256;
constexpr std::size_t kBridgeOrders = 256; // as many as an exercise keeps
constexpr std::size_t kCheckpoints = 4;
constexpr std::size_t kAssessments = 64;
constexpr std::size_t kSeas = 8;
constexpr std::size_t kOrders = 1024; // as many as one tick's mailbox holds
constexpr double kStreamRuns = 0.01;  // m/s
constexpr double kTideRuns = 0.01;    // m

/// What of the weather goes on by itself: a veering wind, the time of day, and what a tide changes.
constexpr bool runs_on(std::string_view field) {
    return field == "wind_from" || field == "time_of_day" || field == "tide_height" ||
           field.starts_with("current_");
}

/// Whether somebody changed the weather: what goes on by itself is no change; of stream and height what a
/// tide makes of them in a few seconds is none.
bool same(const exercise::Weather& a, const exercise::Weather& b) {
    const physics::Vec3 stream = a.current_speed * physics::compass(a.current_towards) -
                                 b.current_speed * physics::compass(b.current_towards);
    bool same = stream.norm() <= kStreamRuns && std::abs(a.tide_height - b.tide_height) <= kTideRuns;
    for_each_field<exercise::Weather>([&](auto field) {
        if constexpr (!runs_on(field.name)) same = same && field.of(a) == field.of(b);
    });
    return same;
}

bool same(const std::vector<exercise::FaultView>& a, const std::vector<exercise::FaultView>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& one, const auto& other) {
        return one.phase == other.phase && one.order.code == other.order.code &&
               one.order.side == other.order.side && one.order.severity == other.order.severity &&
               one.order.trigger == other.order.trigger;
    });
}

bool same(const exercise::LightsAndShapes& a, const exercise::LightsAndShapes& b) {
    return a.anchor_ball == b.anchor_ball && a.anchor_lights == b.anchor_lights;
}

} // namespace

Writers::Writers(wire::Participant& participant)
    : status(participant, wire::topics::exercise_status),
      ship(participant, wire::topics::ship_state),
      anchor(participant, wire::topics::anchor_state),
      chain(participant, wire::topics::chain_state),
      load(participant, wire::topics::windlass_load),
      force(participant, wire::topics::cable_force),
      event(participant, wire::topics::event),
      alert(participant, wire::topics::alert),
      forecastle_alert(participant, wire::topics::forecastle_alert),
      server_alert(participant, wire::topics::server_alert),
      truth(participant, wire::topics::exercise_truth),
      environment(participant, wire::topics::environment_state),
      daylight(participant, wire::topics::daylight),
      lights_and_shapes(participant, wire::topics::lights_and_shapes),
      forecastle(participant, wire::topics::forecastle_view),
      camera(participant, wire::topics::forecastle_camera),
      bridge(participant, wire::topics::bridge_view),
      forecastle_ghost(participant, wire::topics::forecastle_ghost),
      bridge_ghost(participant, wire::topics::bridge_ghost),
      forecastle_event(participant, wire::topics::forecastle_event),
      bridge_event(participant, wire::topics::bridge_event),
      forecastle_instruction(participant, wire::topics::forecastle_instruction),
      bridge_instruction(participant, wire::topics::bridge_instruction),
      forecastle_question(participant, wire::topics::forecastle_question),
      bridge_question(participant, wire::topics::bridge_question),
      bridge_order(participant, wire::topics::bridge_order),
      scene(participant, wire::topics::scene_description),
      seabed(participant, wire::topics::seabed_description),
      chart(participant, wire::topics::chart),
      landmarks(participant, wire::topics::landmarks),
      sea(participant, wire::topics::sea_state),
      checkpoint(participant, wire::topics::checkpoint),
      order(participant, wire::topics::order_taken),
      assessment(participant, wire::topics::assessment),
      seat_assessment(participant, wire::topics::seat_assessment),
      prediction(participant, wire::topics::prediction) {}

Publisher::Publisher(wire::Participant& participant, PublishingPool& pool)
    : writers_(participant),
      state_gate_(wire::topics::chain_state.rate, kIdleRate),
      load_gate_(wire::topics::windlass_load.rate, kIdleRate),
      forecastle_gate_(wire::topics::forecastle_view.rate, kIdleRate),
      bridge_gate_(wire::topics::bridge_view.rate, kIdleRate),
      outputs_(kFrames),
      events_(kEvents),
      alerts_(kAlerts),
      forecastle_alerts_(kAlerts),
      server_alerts_(kAlerts),
      forecastle_events_(kEvents),
      bridge_events_(kEvents),
      forecastle_instructions_(kInstructions),
      bridge_instructions_(kInstructions),
      forecastle_questions_(kQuestions),
      bridge_questions_(kQuestions),
      bridge_orders_(kBridgeOrders),
      seas_(kSeas),
      checkpoints_(kCheckpoints),
      orders_(kOrders),
      assessments_(kAssessments),
      seat_assessments_(kAssessments),
      predictions_(kPredictions),
      forecastle_ghosts_(kGhosts),
      bridge_ghosts_(kGhosts),
      pool_(pool) {
    pool_.add(*this);
}

Publisher::~Publisher() {
    pool_.remove(*this);
    write_waiting();
}

void Publisher::prepare(std::size_t sides, std::size_t nodes_per_side) {
    flush(std::chrono::milliseconds(100)); // the slots are ours only when none waits
    if (!outputs_.empty()) return;         // a slow writer: the slots grow as they are filled
    outputs_.for_each([&](Output& output) {
        output.snapshot.tackle.resize(sides);
        for (auto& tackle : output.snapshot.tackle) {
            tackle.chain.nodes.reserve(nodes_per_side);
            tackle.chain.tension.reserve(nodes_per_side);
        }
    });
}

Publisher::Streams Publisher::heard() const {
    return {.states = writers_.ship.matched() > 0 || writers_.force.matched() > 0 ||
                      writers_.anchor.matched() > 0 || writers_.chain.matched() > 0,
            .loads = writers_.load.matched() > 0,
            .forecastle = writers_.forecastle.matched() > 0,
            .bridge = writers_.bridge.matched() > 0 || writers_.camera.matched() > 0};
}

bool Publisher::wants(std::uint64_t tick, const run::RunStatus& run, double now) const {
    return run.state != last_run_.state || run.run != last_run_.run ||
           run.time_scale != last_run_.time_scale || now - status_sent_ >= kStatusPeriod ||
           (heard_.states && state_gate_.will_be_due(tick, run.tick_rate_hz, now)) ||
           (heard_.loads && load_gate_.will_be_due(tick, run.tick_rate_hz, now)) ||
           (heard_.forecastle && forecastle_gate_.will_be_due(tick, run.tick_rate_hz, now)) ||
           (heard_.bridge && bridge_gate_.will_be_due(tick, run.tick_rate_hz, now));
}

bool Publisher::status_due(const exercise::Snapshot& snapshot, const run::RunStatus& run, double now) {
    const bool changed =
        run.state != last_run_.state || run.run != last_run_.run || run.time_scale != last_run_.time_scale ||
        run.exercise != last_run_.exercise || !same(snapshot.environment.after, last_weather_) ||
        !same(snapshot.faults, last_faults_) || !same(snapshot.lights_and_shapes, last_shown_);
    if (status_sent_ >= 0 && !changed && now - status_sent_ < kStatusPeriod) return false;
    status_sent_ = now;
    last_run_ = run;
    last_weather_ = snapshot.environment.after;
    last_faults_ = snapshot.faults;
    last_shown_ = snapshot.lights_and_shapes;
    return true;
}

void Publisher::offer(const exercise::Snapshot& snapshot, const run::RunStatus& run, double now) {
    // The picture at which a run begins, pauses or ends is always shown.
    const bool turned = run.state != last_run_.state || run.run != last_run_.run;
    heard_ = heard();
    const auto due = [&](bool is_heard, RateGate& gate) {
        return is_heard && (gate.due(snapshot.tick, run.tick_rate_hz, now) || turned);
    };
    const Streams streams{.states = due(heard_.states, state_gate_),
                          .loads = due(heard_.loads, load_gate_),
                          // Whoever is asked at a freeze is not to read the answer off his gauges.
                          .forecastle = due(heard_.forecastle, forecastle_gate_) && !run.asked[0],
                          .bridge = due(heard_.bridge, bridge_gate_) && !run.asked[1]};
    const bool status = status_due(snapshot, run, now);
    hand_over_bridge_orders(snapshot, run);
    hand_over_sea(snapshot);
    if (!status && streams == Streams{}) return;
    Output* output = outputs_.free_slot();
    if (output == nullptr) {
        ++dropped_;
        if (status) status_sent_ = -1; // a change must not go unseen: try again at the next tick
        return;
    }
    output->snapshot = snapshot; // vectors keep their memory
    output->run = run;
    output->run.samples_dropped = dropped_ + lost_;
    output->streams = streams;
    output->status = status;
    output->aids = aids_;
    output->ship = seat_ship_;
    outputs_.push();
    pool_.ring(*this);
}

template <class View, class Sample>
void Publisher::hand_over(const View& view, SpscRing<Sample>& ring) {
    Sample* slot = ring.free_slot();
    if (slot == nullptr) {
        ++dropped_;
        return;
    }
    if constexpr (std::is_same_v<View, Sample>)
        *slot = view;
    else
        convert(view, *slot);
    ring.push();
    pool_.ring(*this);
}

template <class View>
void Publisher::offer(const View& view) {
    hand_over(view, ring_of(view));
}
template void Publisher::offer(const run::CheckpointView& checkpoint);
template void Publisher::offer(const run::OrderView& order);
template void Publisher::offer(const run::QuestionView& question);
template void Publisher::offer(const run::PredictionView& prediction);
template void Publisher::offer(const assess::Result& assessment);

void Publisher::offer(const run::AlertView& alert) {
    if (alert.bridge_panel) hand_over(alert, alerts_);
    if (alert.deck_panel) hand_over(alert, forecastle_alerts_);
    if (!alert.bridge_panel && !alert.deck_panel) hand_over(alert, server_alerts_);
}

void Publisher::offer(const ForecastleView& ghost) {
    hand_over(ghost, forecastle_ghosts_);
}

void Publisher::offer(const BridgeView& ghost) {
    hand_over(ghost, bridge_ghosts_);
}

void Publisher::tell_seats(const assess::Result& marks) {
    hand_over(marks, seat_assessments_);
    seats_have_marks_ = true;
}

void Publisher::take_marks_back() {
    if (!seats_have_marks_) return;
    hand_over(assess::Result{}, seat_assessments_);
    seats_have_marks_ = false;
}

void Publisher::offer(const exercise::ExerciseEvent& event, const exercise::Snapshot& seen,
                      const run::RunStatus& run) {
    offer(event);
    if (seat_event_run_ != run.run) {
        seat_event_run_ = run.run;
        seat_event_number_ = {};
        instruction_number_ = {};
    }
    auto noticed = perceive::perceive_event(event, seen);
    if (!noticed) return;
    const auto tell = [&](SpscRing<SeatEvent>& ring, std::uint64_t& number) {
        noticed->number(++number);
        if (SeatEvent* slot = ring.free_slot()) {
            *slot = *noticed;
            ring.push();
            pool_.ring(*this);
        } else {
            ++dropped_;
        }
    };
    const bool alone = perceive::is_instruction(event);
    auto& numbers = alone ? instruction_number_ : seat_event_number_;
    if (noticed->forecastle()) tell(alone ? forecastle_instructions_ : forecastle_events_, numbers[0]);
    if (noticed->bridge()) tell(alone ? bridge_instructions_ : bridge_events_, numbers[1]);
}

/// The surface, when it became another: at an order, at the end of its ramp, and as the tide rises or falls.
void Publisher::hand_over_sea(const exercise::Snapshot& snapshot) {
    const double tide = snapshot.environment.now.tide_height;
    if (snapshot.sea.ramp_begin == sea_begin_ && snapshot.sea.ramp_end == sea_end_ &&
        std::abs(tide - sea_tide_) <= kTideRuns)
        return;
    SeaState* slot = seas_.free_slot();
    if (slot == nullptr) return; // the next picture brings it
    perceive::describe_sea(snapshot, *slot);
    seas_.push();
    pool_.ring(*this);
    sea_begin_ = snapshot.sea.ramp_begin, sea_end_ = snapshot.sea.ramp_end, sea_tide_ = tide;
}

/// Those that changed since the last picture: given, repeated back, overdue, taken back.
void Publisher::hand_over_bridge_orders(const exercise::Snapshot& snapshot, const run::RunStatus& run) {
    if (orders_run_ != run.run) orders_run_ = run.run, order_tick_ = 0;
    std::uint64_t latest = order_tick_;
    for (const exercise::BridgeOrderView& order : snapshot.bridge_orders) {
        if (order.tick < order_tick_) continue;
        if (BridgeOrder* slot = bridge_orders_.free_slot()) {
            convert(order, run.run, *slot);
            bridge_orders_.push();
            pool_.ring(*this);
        } else {
            ++dropped_;
        }
        latest = std::max(latest, order.tick + 1);
    }
    order_tick_ = latest;
}

void Publisher::describe(const exercise::ExerciseDef& def, const exercise::Snapshot& seen) {
    aids_ = perceive::seat_aids(def);
    seat_ship_ = perceive::seat_ship(def);
    SceneDescription scene;
    perceive::describe_scene(def, aids_, scene);
    SeabedDescription seabed;
    perceive::describe_seabed(def, seabed);
    Chart chart;
    perceive::draw_chart(def, chart);
    Landmarks landmarks;
    perceive::describe_landmarks(def, landmarks);
    SeaState sea;
    perceive::describe_sea(seen, sea);
    sea_begin_ = seen.sea.ramp_begin, sea_end_ = seen.sea.ramp_end;
    sea_tide_ = seen.environment.now.tide_height;
    const bool written = writers_.scene.write(scene) && writers_.seabed.write(seabed) &&
                         writers_.chart.write(chart) && writers_.landmarks.write(landmarks) &&
                         writers_.sea.write(sea);
    if (!written) ++lost_;
}

void Publisher::flush(std::chrono::milliseconds timeout) {
    pool_.call();
    const auto end = std::chrono::steady_clock::now() + timeout;
    const auto left = [&] {
        return std::max(std::chrono::milliseconds(0), std::chrono::duration_cast<std::chrono::milliseconds>(
                                                          end - std::chrono::steady_clock::now()));
    };
    while (!(outputs_.empty() && events_.empty() && forecastle_events_.empty() && bridge_events_.empty() &&
             forecastle_instructions_.empty() && bridge_instructions_.empty() &&
             forecastle_questions_.empty() && bridge_questions_.empty() && alerts_.empty() &&
             forecastle_alerts_.empty() && server_alerts_.empty() && bridge_orders_.empty() &&
             seas_.empty() && checkpoints_.empty() && orders_.empty() && assessments_.empty() &&
             seat_assessments_.empty() && predictions_.empty()) &&
           left().count() > 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    // First what a console waits for that stopped an exercise, with which its server may end.
    writers_.status.wait_acknowledged(left());
    writers_.event.wait_acknowledged(left());
    writers_.forecastle_event.wait_acknowledged(left());
    writers_.bridge_event.wait_acknowledged(left());
    writers_.forecastle_instruction.wait_acknowledged(left());
    writers_.bridge_instruction.wait_acknowledged(left());
    writers_.forecastle_question.wait_acknowledged(left());
    writers_.bridge_question.wait_acknowledged(left());
    writers_.alert.wait_acknowledged(left());
    writers_.forecastle_alert.wait_acknowledged(left());
    writers_.server_alert.wait_acknowledged(left());
    writers_.bridge_order.wait_acknowledged(left());
    writers_.order.wait_acknowledged(left());
    writers_.assessment.wait_acknowledged(left());
    writers_.seat_assessment.wait_acknowledged(left());
    writers_.checkpoint.wait_acknowledged(left());
}

template <class Sample>
bool Publisher::write_oldest(SpscRing<Sample>& ring, wire::Writer<Sample>& writer) {
    const Sample* sample = ring.oldest();
    if (sample == nullptr) return false;
    if (!writer.write(*sample)) ++lost_;
    ring.pop();
    return true;
}

void Publisher::write_waiting() {
    for (;;) {
        if (write_oldest(events_, writers_.event) ||
            write_oldest(forecastle_events_, writers_.forecastle_event) ||
            write_oldest(bridge_events_, writers_.bridge_event) ||
            write_oldest(forecastle_instructions_, writers_.forecastle_instruction) ||
            write_oldest(bridge_instructions_, writers_.bridge_instruction) ||
            write_oldest(forecastle_questions_, writers_.forecastle_question) ||
            write_oldest(bridge_questions_, writers_.bridge_question) ||
            write_oldest(alerts_, writers_.alert) ||
            write_oldest(forecastle_alerts_, writers_.forecastle_alert) ||
            write_oldest(server_alerts_, writers_.server_alert) ||
            write_oldest(bridge_orders_, writers_.bridge_order) || write_oldest(seas_, writers_.sea) ||
            write_oldest(orders_, writers_.order) || write_oldest(checkpoints_, writers_.checkpoint) ||
            write_oldest(assessments_, writers_.assessment) ||
            write_oldest(seat_assessments_, writers_.seat_assessment) ||
            write_oldest(predictions_, writers_.prediction) ||
            write_oldest(forecastle_ghosts_, writers_.forecastle_ghost) ||
            write_oldest(bridge_ghosts_, writers_.bridge_ghost))
            continue;
        const Output* output = outputs_.oldest();
        if (output == nullptr) return;
        write(*output);
        outputs_.pop();
    }
}

/// Makes a stream's sample and writes it, where somebody hears it: nothing of a stream is kept for those who
/// come later. False when it could not be written.
template <class Sample, class Make>
bool Publisher::stream(wire::Writer<Sample>& writer, Sample& sample, Make make) {
    if (writer.matched() == 0) return true;
    make(sample);
    return writer.write(sample);
}

void Publisher::write(const Output& output) {
    const auto& view = output.snapshot;
    bool written = true;
    const auto whole = [&](auto& sample) { convert(view, sample); };
    if (output.streams.states) {
        written = stream(writers_.ship, ship_, whole) && written;
        written = stream(writers_.force, force_, whole) && written;
    }
    for (const auto& tackle : view.tackle) {
        const auto part = [&](auto& sample) { convert(view, tackle, sample); };
        if (output.streams.loads) written = stream(writers_.load, load_, part) && written;
        if (output.streams.states) {
            written = stream(writers_.anchor, anchor_, part) && written;
            if (writers_.chain.matched() > 0 &&
                still_.at(static_cast<std::size_t>(tackle.side)).due(tackle.chain, view.time))
                written = stream(writers_.chain, chain_, part) && written;
        }
        if (output.streams.forecastle)
            written = stream(writers_.forecastle, forecastle_,
                             [&](ForecastleView& seen) {
                                 perceive::perceive_forecastle(view, tackle, output.ship, output.aids, seen);
                             }) &&
                      written;
        if (output.streams.bridge && writers_.camera.matched() > 0 &&
            perceive::perceive_camera(view, tackle, camera_))
            written = writers_.camera.write(camera_) && written;
    }
    if (output.streams.bridge)
        written = stream(writers_.bridge, bridge_,
                         [&](BridgeView& seen) { perceive::perceive_bridge(view, output.ship, seen); }) &&
                  written;
    if (output.status) {
        convert(view, output.run, status_);
        convert(view, output.run, truth_);
        convert(view, environment_);
        perceive::perceive_daylight(view, daylight_);
        perceive::perceive_lights_and_shapes(view, lights_and_shapes_);
        written = writers_.status.write(status_) && writers_.truth.write(truth_) &&
                  writers_.environment.write(environment_) && writers_.daylight.write(daylight_) &&
                  writers_.lights_and_shapes.write(lights_and_shapes_) && written;
    }
    if (!written) ++lost_;
}

} // namespace windlass::dds
