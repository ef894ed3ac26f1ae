#pragma once
// Snapshot -> topics, on a thread of its own, so that no write ever holds up the exercise.

#include "idl/wire.hpp"
#include "server/dds/rate_gate.hpp"
#include "server/dds/spsc_ring.hpp"
#include "server/run/status.hpp"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <semaphore>
#include <span>
#include <thread>

namespace windlass::server {

/// What the publisher writes with.
struct Writers {
    explicit Writers(wire::Participant& participant);

    wire::Writer<ExerciseStatus> status;
    wire::Writer<ShipState> ship;
    wire::Writer<AnchorState> anchor;
    wire::Writer<ChainState> chain;
    wire::Writer<WindlassLoad> load;
    wire::Writer<CableForce> force;
    wire::Writer<Event> event;
    wire::Writer<Alert> alert;
    wire::Writer<Checkpoint> checkpoint;
    wire::Writer<OrderTaken> order;
};

/// All methods are for the exercise thread. Rates: ship, anchor, chain and cable force 60 Hz, windlass load
/// 100 Hz of exercise time and at most the same per wall second; status 5 Hz of wall time and on change.
class Publisher {
public:
    explicit Publisher(wire::Participant& participant);
    /// Writes what still waits, then ends the thread.
    ~Publisher();
    Publisher(const Publisher&) = delete;
    Publisher& operator=(const Publisher&) = delete;

    /// Makes room for cables of that many nodes, so that offer() need not. To be called before the first
    /// offer() of an exercise.
    void prepare(std::size_t sides, std::size_t nodes_per_side);

    /// LeverOwnership over what is due at wall time now (s, never going back). Neither waits nor allocates,
    /// except that an event copies its text.
    void offer(const exercise::Snapshot& snapshot, const RunStatus& run, double now);

    /// LeverOwnership over at once; dropped and counted only when thousands wait already.
    void offer(const exercise::ExerciseEvent& event);
    void offer(const AlertView& alert);
    void offer(const CheckpointView& checkpoint);
    void offer(const OrderView& order);

    /// Snapshots, events, alerts, checkpoints and orders that found no room, since the start.
    std::uint64_t dropped() const { return dropped_; }

    /// Waits until all is written and every connected reader of the reliable topics has it, or time is up.
    void flush(std::chrono::milliseconds timeout);

private:
    struct Frame {
        exercise::Snapshot snapshot;
        RunStatus run;
        bool states = false, loads = false, status = false;
    };

    bool status_due(const exercise::Snapshot& snapshot, const RunStatus& run, double now);
    template <class View, class Sample>
    void hand_over(const View& view, SpscRing<Sample>& ring);
    void work();
    template <class Sample>
    bool write_oldest(SpscRing<Sample>& ring, wire::Writer<Sample>& writer);
    bool write_waiting();
    void write(const Frame& frame);

    Writers writers_;

    // The exercise thread's
    RateGate state_gate_, load_gate_;
    RunStatus last_run_;
    exercise::EnvironmentView last_environment_;
    std::vector<exercise::FaultView> last_faults_;
    double status_sent_ = -1;
    std::uint64_t dropped_ = 0;

    // Between the two
    SpscRing<Frame> frames_;
    SpscRing<Event> events_;
    SpscRing<Alert> alerts_;
    SpscRing<Checkpoint> checkpoints_;
    SpscRing<OrderTaken> orders_;
    std::counting_semaphore<> wake_{0};
    std::atomic<bool> stop_{false};
    std::atomic<std::uint64_t> lost_{0}; // writes that DDS refused

    // The publisher thread's: samples that keep their memory
    ExerciseStatus status_;
    ShipState ship_;
    AnchorState anchor_;
    ChainState chain_;
    WindlassLoad load_;
    CableForce force_;
    std::thread thread_; // last: starts when all else is there
};

} // namespace windlass::server
