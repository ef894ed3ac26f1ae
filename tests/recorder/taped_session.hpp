#pragma once
// A run of an exercise and its recording, without a network: what the server publishes goes to the tape.

#include "server/config/config.hpp"
#include "server/dds/convert.hpp"
#include "server/dds/order_taken.hpp"
#include "server/run/session.hpp"

#include "tests/recorder/made_recording.hpp"

#include <functional>
#include <optional>

namespace windlass::test {

class TapedSession {
public:
    /// May change a sample before it is written, or say (false) that it is lost.
    template <class T>
    using Tamper = std::function<bool(T&)>;
    Tamper<OrderTaken> orders = [](OrderTaken&) { return true; };
    Tamper<Checkpoint> checkpoints = [](Checkpoint&) { return true; };
    Tamper<Assessment> assessments = [](Assessment&) { return true; };
    Tamper<ExerciseTruth> truths = [](ExerciseTruth&) { return true; };

    explicit TapedSession(const std::filesystem::path& folder, const exercise::ExerciseDef& def = {})
        : def_(def), session_(std::in_place, def, options()), tape_({.folder = folder}) {}

    /// The server is killed, and started again: the exercise is taken up at the state that it kept at `kept`
    /// beats before, and stands paused.
    void lose_server(const std::vector<std::uint8_t>& kept) {
        run::SessionOptions again = options();
        again.first_run = session_->status().run + 1000;
        again.resumption = run::Resumption{.checkpoint = kept, .refused = {}, .set_back = {}};
        session_.emplace(def_, again);
        publish(true);
    }
    /// What a server that is killed now has kept.
    std::vector<std::uint8_t> kept() {
        session_->take_checkpoint_now();
        std::vector<std::uint8_t> bytes = session_->checkpoint()->data;
        publish(false);
        return bytes;
    }

    /// The order is taken before the next tick, and what comes of it is recorded.
    void give(run::OrderContent order, const char* source = "trainee-1") {
        run::Inbox inbox;
        inbox.orders.push_back({source, std::move(order)});
        session_->carry_out(inbox, now_);
    }
    void give(run::RunAction action, double restore_time = 0) {
        run::RunOrder order;
        order.action = action;
        order.restore_time = restore_time;
        give(order, "instructor");
    }

    int every = 20; ///< beats from one status, truth and load to the next
    /// So many beats of the server.
    void run(int beats) {
        for (int i = 0; i < beats; ++i) {
            session_->carry_out({}, now_);
            session_->tick();
            now_ += session_->dt();
            publish(++beats_ % every == 0);
        }
    }
    void close() { tape_.close({}); }
    run::Session& session() { return *session_; }
    const std::vector<exercise::ExerciseEvent>& heard() const { return heard_; } ///< every event

private:
    static run::SessionOptions options() {
        run::SessionOptions options;
        options.check = config::check_definition;
        options.first_run = 1'700'000'000'000;
        options.seed = 1;
        return options;
    }

    void publish(bool status) {
        for (const auto& event : session_->events()) {
            write(wire::topics::event, {}, event);
            heard_.push_back(event);
        }
        for (const auto& order : session_->orders())
            write(wire::topics::order_taken, orders, order);
        if (session_->assessment()) write(wire::topics::assessment, assessments, *session_->assessment());
        if (const auto* checkpoint = session_->checkpoint())
            write(wire::topics::checkpoint, checkpoints, *checkpoint);
        session_->clear_news();
        if (!status) return;
        ExerciseStatus seen;
        dds::convert(session_->snapshot(), session_->status(), seen);
        put(wire::topics::exercise_status, {}, seen);
        ExerciseTruth truth;
        dds::convert(session_->snapshot(), session_->status(), truth);
        put(wire::topics::exercise_truth, truths, truth);
        for (const auto& tackle : session_->snapshot().tackle) {
            WindlassLoad load;
            dds::convert(session_->snapshot(), tackle, load);
            put(wire::topics::windlass_load, {}, load);
        }
        for (const auto& order : session_->snapshot().bridge_orders) {
            BridgeOrder given;
            dds::convert(order, session_->status().run, given);
            put(wire::topics::bridge_order, {}, given);
        }
        ShipState ship;
        dds::convert(session_->snapshot(), ship);
        put(wire::topics::ship_state, {}, ship);
    }
    template <class T, class View>
    void write(const wire::Topic<T>& topic, const Tamper<T>& tamper, const View& view) {
        using dds::convert;
        T sample;
        convert(view, sample);
        put(topic, tamper, sample);
    }
    template <class T>
    void put(const wire::Topic<T>& topic, const Tamper<T>& tamper, T& value) {
        if (!tamper || tamper(value)) tape_.write(sample(topic, value, now_));
    }

    const exercise::ExerciseDef def_;
    std::optional<run::Session> session_;
    recorder::Tape tape_;
    double now_ = 0; // s of wall time
    int beats_ = 0;
    std::vector<exercise::ExerciseEvent> heard_;
};

} // namespace windlass::test
