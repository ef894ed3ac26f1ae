#pragma once
// Snapshot -> topics, on threads of a pool, so that no write ever holds up the exercise.

#include "idl/wire.hpp"
#include "server/assess/result.hpp"
#include "server/dds/publishing_pool.hpp"
#include "server/dds/rate_gate.hpp"
#include "server/dds/spsc_ring.hpp"
#include "server/dds/still_cable.hpp"
#include "server/perceive/perceive.hpp"
#include "server/run/prediction.hpp"
#include "server/run/status.hpp"

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <span>

namespace windlass::dds {

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
    wire::Writer<Alert> alert, forecastle_alert, server_alert;
    wire::Writer<ExerciseTruth> truth;
    wire::Writer<EnvironmentState> environment;
    wire::Writer<Daylight> daylight;
    wire::Writer<LightsAndShapes> lights_and_shapes;
    wire::Writer<ForecastleView> forecastle, camera;
    wire::Writer<BridgeView> bridge;
    wire::Writer<ForecastleView> forecastle_ghost;
    wire::Writer<BridgeView> bridge_ghost;
    wire::Writer<SeatEvent> forecastle_event, bridge_event, forecastle_instruction, bridge_instruction;
    wire::Writer<Question> forecastle_question, bridge_question;
    wire::Writer<BridgeOrder> bridge_order;
    wire::Writer<SceneDescription> scene;
    wire::Writer<SeabedDescription> seabed;
    wire::Writer<Chart> chart;
    wire::Writer<Landmarks> landmarks;
    wire::Writer<SeaState> sea;
    wire::Writer<Checkpoint> checkpoint;
    wire::Writer<OrderTaken> order;
    wire::Writer<Assessment> assessment, seat_assessment;
    wire::Writer<Prediction> prediction;
};

/// All methods are for the exercise thread. Rates: ship, anchor, chain and cable force 60 Hz (the chain 5 Hz
/// while it lies still), windlass load 100 Hz, forecastle view 30 Hz, bridge view and camera 10 Hz of
/// exercise time and at most the same per wall second; status, truth and environment 5 Hz of wall time and on
/// change. What a seat is given is made by perceive.hpp.
class Publisher final : private Outbox {
public:
    /// The pool must outlive it.
    Publisher(wire::Participant& participant, PublishingPool& pool);
    /// Writes what still waits.
    ~Publisher() override;
    Publisher(const Publisher&) = delete;
    Publisher& operator=(const Publisher&) = delete;

    /// Makes room for cables of that many nodes, so that offer() need not. To be called before the first
    /// offer() of an exercise.
    void prepare(std::size_t sides, std::size_t nodes_per_side);

    /// Whether offer() of a picture of that tick at wall time now (s) would send any of it to anybody who
    /// hears. Weather and faults that changed by themselves are told with the next picture that is due.
    bool wants(std::uint64_t tick, const run::RunStatus& run, double now) const;

    /// Hands over what is due at wall time now (s, never going back). Neither waits nor allocates,
    /// except that an event copies its text.
    void offer(const exercise::Snapshot& snapshot, const run::RunStatus& run, double now);

    /// Hands over at once a CheckpointView, OrderView, QuestionView, PredictionView or assess::Result;
    /// dropped and counted only when thousands wait already.
    template <class View>
    void offer(const View& view);
    /// The same of an alert, for each panel that it is of; one of none is about the simulation.
    void offer(const run::AlertView& alert);
    /// The same of an event, and of what is noticed of it, for each seat that does; seen: the picture at it.
    void offer(const exercise::ExerciseEvent& event, const exercise::Snapshot& seen,
               const run::RunStatus& run);

    /// What the seats are shown of the model's hands, made by ghost.hpp. Allocates nothing once a few were.
    void offer(const ForecastleView& ghost);
    void offer(const BridgeView& ghost);

    /// What came of the lesson, for the seats to read; and that it has not come to its end (again), where
    /// they were told before.
    void tell_seats(const assess::Result& marks);
    void take_marks_back();

    /// What an exercise is made of, at each set-up: its scene, ground, chart and landmarks, and what it fits
    /// and allows. Builds and writes at once, on the caller's thread.
    void describe(const exercise::ExerciseDef& def, const exercise::Snapshot& seen);

    /// Snapshots, events, alerts, checkpoints and orders that found no room, since the start.
    std::uint64_t dropped() const { return dropped_; }

    /// Waits until all is written and every connected reader of the reliable topics has it, or time is up.
    void flush(std::chrono::milliseconds timeout);

private:
    /// What is sent at a rate of its own, and only where somebody hears it.
    struct Streams {
        bool states = false, loads = false, forecastle = false, bridge = false;
        bool operator==(const Streams&) const = default;
    };
    struct Output {
        exercise::Snapshot snapshot;
        run::RunStatus run;
        Streams streams;
        bool status = false;
        perceive::SeatAids aids;
        perceive::SeatShip ship;
    };

    template <class View, class Sample>
    void hand_over(const View& view, SpscRing<Sample>& ring);
    Streams heard() const; ///< by somebody who is connected now
    void hand_over_bridge_orders(const exercise::Snapshot& snapshot, const run::RunStatus& run);
    void hand_over_sea(const exercise::Snapshot& snapshot);
    bool status_due(const exercise::Snapshot& snapshot, const run::RunStatus& run, double now);
    SpscRing<Event>& ring_of(const exercise::ExerciseEvent&) { return events_; }
    SpscRing<Checkpoint>& ring_of(const run::CheckpointView&) { return checkpoints_; }
    SpscRing<OrderTaken>& ring_of(const run::OrderView&) { return orders_; }
    SpscRing<Question>& ring_of(const run::QuestionView& question) {
        return question.forecastle ? forecastle_questions_ : bridge_questions_;
    }
    SpscRing<Assessment>& ring_of(const assess::Result&) { return assessments_; }
    SpscRing<Prediction>& ring_of(const run::PredictionView&) { return predictions_; }
    void write_waiting() override;
    template <class Sample>
    bool write_oldest(SpscRing<Sample>& ring, wire::Writer<Sample>& writer);
    template <class Sample, class Make>
    bool stream(wire::Writer<Sample>& writer, Sample& sample, Make make);
    void write(const Output& output);

    Writers writers_;

    // The exercise thread's
    Streams heard_; // when last looked: with each picture, so five times a second at least
    RateGate state_gate_, load_gate_, forecastle_gate_, bridge_gate_;
    perceive::SeatAids aids_;
    perceive::SeatShip seat_ship_;
    bool seats_have_marks_ = false;
    std::uint64_t seat_event_run_ = 0;
    std::array<std::uint64_t, 2> seat_event_number_{};  ///< of that run: forecastle, bridge
    std::array<std::uint64_t, 2> instruction_number_{}; ///< the same
    std::uint64_t orders_run_ = 0,
                  order_tick_ = 0; // whose bridge orders have been handed over, and up to when

    double sea_begin_ = -1, sea_end_ = -1; ///< ramp of the sea that was handed over last; -1: none
    double sea_tide_ = 0;                  ///< m, that it stood over the datum

    run::RunStatus last_run_;
    exercise::Weather last_weather_;
    std::vector<exercise::FaultView> last_faults_;
    exercise::LightsAndShapes last_shown_;
    double status_sent_ = -1;
    std::uint64_t dropped_ = 0;

    // Between the two
    SpscRing<Output> outputs_;
    SpscRing<Event> events_;
    SpscRing<Alert> alerts_, forecastle_alerts_, server_alerts_;
    SpscRing<SeatEvent> forecastle_events_, bridge_events_;
    SpscRing<SeatEvent> forecastle_instructions_, bridge_instructions_;
    SpscRing<Question> forecastle_questions_, bridge_questions_;
    SpscRing<BridgeOrder> bridge_orders_;
    SpscRing<SeaState> seas_;
    SpscRing<Checkpoint> checkpoints_;
    SpscRing<OrderTaken> orders_;
    SpscRing<Assessment> assessments_, seat_assessments_;
    SpscRing<Prediction> predictions_;
    SpscRing<ForecastleView> forecastle_ghosts_;
    SpscRing<BridgeView> bridge_ghosts_;
    std::atomic<std::uint64_t> lost_{0}; // writes that DDS refused

    // Of the thread that writes: samples that keep their memory
    ExerciseStatus status_;
    ExerciseTruth truth_;
    EnvironmentState environment_;
    Daylight daylight_;
    LightsAndShapes lights_and_shapes_;
    ForecastleView forecastle_, camera_;
    BridgeView bridge_;
    ShipState ship_;
    AnchorState anchor_;
    ChainState chain_;
    std::array<StillCable, 2> still_; // by side
    WindlassLoad load_;
    CableForce force_;

    PublishingPool& pool_;
};

} // namespace windlass::dds
