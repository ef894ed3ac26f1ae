#pragma once
// A let-go with the same orders at the same ticks each time, for what is kept of it.

#include "server/exercise/checkpoint.hpp"
#include "server/keep/keeper.hpp"
#include "server/run/session.hpp"

#include <cmath>
#include <filesystem>

namespace windlass::keep::test {

/// The order that is given at that tick; nothing: none is.
inline std::optional<exercise::Order> order_at(std::uint64_t tick) {
    using exercise::EnvironmentOrder, exercise::FaultCode, exercise::FaultOrder, exercise::HelmOrder,
        exercise::WindlassOrder;
    if (tick == 60) return HelmOrder{.engine = -0.2};
    if (tick == 300) return FaultOrder{.code = FaultCode::brake_lining_faded, .severity = 0.4, .ramp = 2};
    if (tick == 420) return EnvironmentOrder{.weather = {.wind_speed = 12}, .ramp = 5};
    if (tick % 15 != 0) return std::nullopt; // levers are sent 20 times a second
    const double t = static_cast<double>(tick) / 300;
    return WindlassOrder{.brake = tick < 90 ? 1 : 0.35 + 0.2 * std::sin(t)};
}

/// A session of that let-go.
class LetGo {
public:
    explicit LetGo(std::optional<run::Resumption> resumption = {}, const exercise::ExerciseDef& def = {})
        : session_(def, options(std::move(resumption))) {}

    run::Session& session() { return session_; }

    /// Gives the order of the present tick.
    void order() {
        run::Inbox inbox;
        if (const auto order = order_at(session_.now_tick())) inbox.orders.push_back({"trainee", *order});
        session_.carry_out(inbox, session_.now_time());
    }
    void give(run::RunAction action) {
        run::Inbox inbox;
        run::RunOrder order;
        order.action = action;
        inbox.orders.push_back({"instructor", order});
        session_.carry_out(inbox, session_.now_time());
    }
    /// Goes on to that tick, the orders of which are not given yet.
    void go_to(std::uint64_t tick, KeptExercise* kept = nullptr) {
        while (session_.now_tick() < tick && session_.running()) {
            order();
            session_.tick();
            look(kept);
        }
    }
    void look(KeptExercise* kept) {
        if (kept != nullptr) kept->look(session_);
        session_.clear_news();
    }

    std::uint64_t hash() { // orders of this tick included
        session_.take_checkpoint_now();
        return session_.snapshot().state_hash;
    }

private:
    static run::SessionOptions options(std::optional<run::Resumption> resumption) {
        run::SessionOptions options;
        options.fault_folder = std::filesystem::temp_directory_path();
        options.seed = 7;
        options.resumption = std::move(resumption);
        return options;
    }

    run::Session session_;
};

inline std::uint64_t let_go_hash() {
    return exercise::definition_hash(exercise::ExerciseDef());
}

} // namespace windlass::keep::test
