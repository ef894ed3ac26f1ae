#include "server/dds/publisher.hpp"

#include "server/dds/convert.hpp"
#include "server/dds/order_taken.hpp"

#include <algorithm>

namespace windlass::server {

namespace {

constexpr double kIdleRate = 5;       // Hz, of an exercise that stands still
constexpr double kStatusPeriod = 0.2; // s of wall time
constexpr std::size_t kFrames = 16;   // a quarter of a second behind at 60 Hz
constexpr std::size_t kEvents = 4096;
constexpr std::size_t kAlerts = 256;
constexpr std::size_t kCheckpoints = 4;
constexpr std::size_t kOrders = 1024; // as many as one tick's mailbox holds

bool same(const exercise::EnvironmentView& a, const exercise::EnvironmentView& b) {
    // Not the depth: it changes as the ship moves.
    return a.wind_speed == b.wind_speed && a.wind_from == b.wind_from && a.current_speed == b.current_speed &&
           a.current_towards == b.current_towards;
}

bool same(const std::vector<exercise::FaultView>& a, const std::vector<exercise::FaultView>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& one, const auto& other) {
        return one.phase == other.phase && one.order.code == other.order.code &&
               one.order.side == other.order.side && one.order.severity == other.order.severity;
    });
}

/// All that can be seen but the events, which have a queue of their own. Vectors keep their memory.
void copy_view(const exercise::Snapshot& from, exercise::Snapshot& to) {
    to.tick = from.tick;
    to.time = from.time;
    to.state_hash = from.state_hash;
    to.environment = from.environment;
    to.ship = from.ship;
    to.cable_force = from.cable_force;
    to.cable_moment = from.cable_moment;
    to.tackle = from.tackle;
    to.faults = from.faults;
    to.model_level = from.model_level;
    to.model_error = from.model_error;
    to.model_nodes = from.model_nodes;
    to.model_substeps = from.model_substeps;
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
      checkpoint(participant, wire::topics::checkpoint),
      order(participant, wire::topics::order_taken) {}

Publisher::Publisher(wire::Participant& participant)
    : writers_(participant),
      state_gate_(wire::topics::chain_state.rate, kIdleRate),
      load_gate_(wire::topics::windlass_load.rate, kIdleRate),
      frames_(kFrames),
      events_(kEvents),
      alerts_(kAlerts),
      checkpoints_(kCheckpoints),
      orders_(kOrders),
      thread_([this] { work(); }) {}

Publisher::~Publisher() {
    stop_ = true;
    wake_.release();
    thread_.join();
}

void Publisher::prepare(std::size_t sides, std::size_t nodes_per_side) {
    flush(std::chrono::milliseconds(100)); // the slots are ours only when none waits
    if (!frames_.empty()) return;          // a slow writer: the slots grow as they are filled
    frames_.for_each([&](Frame& frame) {
        frame.snapshot.tackle.resize(sides);
        for (auto& tackle : frame.snapshot.tackle) {
            tackle.chain.nodes.reserve(nodes_per_side);
            tackle.chain.tension.reserve(nodes_per_side);
        }
    });
}

bool Publisher::status_due(const exercise::Snapshot& snapshot, const RunStatus& run, double now) {
    const bool changed = run.state != last_run_.state || run.run != last_run_.run ||
                         run.time_scale != last_run_.time_scale || run.exercise != last_run_.exercise ||
                         !same(snapshot.environment, last_environment_) ||
                         !same(snapshot.faults, last_faults_);
    if (status_sent_ >= 0 && !changed && now - status_sent_ < kStatusPeriod) return false;
    status_sent_ = now;
    last_run_ = run;
    last_environment_ = snapshot.environment;
    last_faults_ = snapshot.faults;
    return true;
}

void Publisher::offer(const exercise::Snapshot& snapshot, const RunStatus& run, double now) {
    // The picture at which a run begins, pauses or ends is always shown.
    const bool turned = run.state != last_run_.state || run.run != last_run_.run;
    const bool states = state_gate_.due(snapshot.tick, run.tick_rate_hz, now) || turned;
    const bool loads = load_gate_.due(snapshot.tick, run.tick_rate_hz, now) || turned;
    const bool status = status_due(snapshot, run, now);
    if (!states && !loads && !status) return;
    Frame* frame = frames_.free_slot();
    if (frame == nullptr) {
        ++dropped_;
        if (status) status_sent_ = -1; // a change must not go unseen: try again at the next tick
        return;
    }
    copy_view(snapshot, frame->snapshot);
    frame->run = run;
    frame->run.samples_dropped = dropped_ + lost_;
    frame->states = states;
    frame->loads = loads;
    frame->status = status;
    frames_.push();
    wake_.release();
}

template <class View, class Sample>
void Publisher::hand_over(const View& view, SpscRing<Sample>& ring) {
    Sample* slot = ring.free_slot();
    if (slot == nullptr) {
        ++dropped_;
        return;
    }
    convert(view, *slot);
    ring.push();
    wake_.release();
}

void Publisher::offer(const exercise::ExerciseEvent& event) {
    hand_over(event, events_);
}
void Publisher::offer(const AlertView& alert) {
    hand_over(alert, alerts_);
}
void Publisher::offer(const CheckpointView& checkpoint) {
    hand_over(checkpoint, checkpoints_);
}
void Publisher::offer(const OrderView& order) {
    hand_over(order, orders_);
}

void Publisher::flush(std::chrono::milliseconds timeout) {
    const auto end = std::chrono::steady_clock::now() + timeout;
    const auto left = [&] {
        return std::max(std::chrono::milliseconds(0), std::chrono::duration_cast<std::chrono::milliseconds>(
                                                          end - std::chrono::steady_clock::now()));
    };
    while (
        !(frames_.empty() && events_.empty() && alerts_.empty() && checkpoints_.empty() && orders_.empty()) &&
        left().count() > 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    writers_.event.wait_acknowledged(left());
    writers_.alert.wait_acknowledged(left());
    writers_.order.wait_acknowledged(left());
    writers_.checkpoint.wait_acknowledged(left());
    writers_.status.wait_acknowledged(left());
}

void Publisher::work() {
    for (;;) {
        wake_.acquire();
        const bool last_round = stop_; // before writing: what was handed over earlier is still written
        while (write_waiting()) {
        }
        if (last_round) return;
    }
}

template <class Sample>
bool Publisher::write_oldest(SpscRing<Sample>& ring, wire::Writer<Sample>& writer) {
    const Sample* sample = ring.oldest();
    if (sample == nullptr) return false;
    if (!writer.write(*sample)) ++lost_;
    ring.pop();
    return true;
}

bool Publisher::write_waiting() {
    if (write_oldest(events_, writers_.event) || write_oldest(alerts_, writers_.alert) ||
        write_oldest(orders_, writers_.order) || write_oldest(checkpoints_, writers_.checkpoint))
        return true;
    if (const Frame* frame = frames_.oldest()) {
        write(*frame);
        frames_.pop();
        return true;
    }
    return false;
}

void Publisher::write(const Frame& frame) {
    const auto& view = frame.snapshot;
    bool written = true;
    if (frame.states) {
        convert(view, ship_);
        convert(view, force_);
        written = writers_.ship.write(ship_) && writers_.force.write(force_) && written;
    }
    for (const auto& tackle : view.tackle) {
        if (frame.loads) {
            convert(view, tackle, load_);
            written = writers_.load.write(load_) && written;
        }
        if (frame.states) {
            convert(view, tackle, anchor_);
            convert(view, tackle, chain_);
            written = writers_.anchor.write(anchor_) && writers_.chain.write(chain_) && written;
        }
    }
    if (frame.status) {
        convert(view, frame.run, status_);
        written = writers_.status.write(status_) && written;
    }
    if (!written) ++lost_;
}

} // namespace windlass::server
