#include "server/run/session.hpp"

#include "common/text.hpp"
#include "server/exercise/checkpoint.hpp"
#include "server/exercise/picture/published.hpp"
#include "server/run/briefing.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace windlass::run {

using exercise::RunState;

namespace {

const char* name(RunState state) {
    switch (state) {
    case RunState::ready:
        return "ready";
    case RunState::running:
        return "running";
    case RunState::paused:
        return "paused";
    case RunState::finished:
        return "finished";
    case RunState::stopped_by_fault:
        return "stopped by a fault";
    case RunState::replay:
        return "replaying";
    }
    return "unknown";
}

const char* name(RunAction action) {
    switch (action) {
    case RunAction::load:
        return "LOAD";
    case RunAction::start:
        return "START";
    case RunAction::pause:
        return "PAUSE";
    case RunAction::reset:
        return "RESET";
    case RunAction::time_scale:
        return "TIME_SCALE";
    case RunAction::stop:
        return "STOP";
    case RunAction::snapshot:
        return "SNAPSHOT";
    case RunAction::restore:
        return "RESTORE";
    case RunAction::bookmark:
        return "BOOKMARK";
    case RunAction::predict:
        return "PREDICT";
    }
    return "unknown";
}

constexpr const char* kNotFinite = "its state ceased to be finite";

/// Levers, and where a foreign ship is, are sent again and again; the other orders are given once.
bool is_stream(const exercise::Order& command) {
    return LeverOwnership::levers_of(command).has_value() ||
           std::holds_alternative<exercise::OwnShipSample>(command);
}

/// Whether the picture has those levers where they stand, as far as they get there without a tick.
bool shows_levers(LeverGroup levers, const exercise::Exercise& exercise, const exercise::Snapshot& seen) {
    if (levers == LeverGroup::helm) {
        const exercise::ShipView& ship = seen.ship;
        return exercise.helm() == exercise::HelmOrder{ship.engine_ordered, ship.rudder_ordered,
                                                      ship.bow_thruster_ordered, ship.stern_thruster_ordered};
    }
    const auto side = static_cast<exercise::Side>(levers);
    const exercise::WindlassOrder order = exercise.levers(side);
    return std::ranges::all_of(seen.tackle, [&](const exercise::TackleView& tackle) {
        return tackle.side != side || (tackle.windlass.speed_lever == order.speed_lever &&
                                       tackle.windlass.emergency_stop == order.emergency_stop);
    });
}

} // namespace

Session::Session(const exercise::ExerciseDef& def, SessionOptions options)
    : options_(std::move(options)),
      // What is brought back needs no prelude.
      exercise_(options_.resumption && !options_.resumption->checkpoint.empty()
                    ? exercise::Exercise::blank(def)
                    : exercise::Exercise(def)),
      chance_(options_.seed ? *options_.seed : std::random_device{}()) {
    status_.time_scale = options_.time_scale;
    if (options_.resumption && !options_.resumption->checkpoint.empty()) {
        begin_after_loss();
        return;
    }
    set_up();
    if (options_.resumption) begin_after_loss();
    if (!options_.wait) {
        status_.state = RunState::running;
        log("exercise.started", "exercise started");
    }
}

/// What is so at the beginning of every run: of an exercise set up, reset, or taken up again.
void Session::begin_run() {
    status_.run = options_.first_run + setups_++;
    status_.exercise = def().name;
    status_.title_instructor = def().title;
    status_.title_trainee = exercise::title_for_trainees(def());
    status_.tick_rate_hz = def().tick_rate_hz;
    status_.definition_hash = exercise::definition_hash(def());
    orders_taken_ = 0;
    look();
    next_ = snapshot_;
    history_.clear();
    failure_.clear();
    kept_course_ = {};
    held_ = false;
    forget_hands();
}

/// 0 to 1, from chance.
double Session::draw() {
    return std::uniform_real_distribution<double>(0, 1)(chance_);
}

/// Shows the exercise as it is now, orders of this tick included.
void Session::look() {
    exercise_.view(snapshot_);
    tick_ = snapshot_.tick, time_ = snapshot_.time;
    seen_ = true;
    status_.orders_taken = orders_taken_;
}

void Session::set_up() {
    begin_run();
    assessor_ = assess::Assessor(def());
    assessor_.begin(snapshot_);
    assessor_.hear(exercise::ChanceDrawn{draw()}); // the first checkpoint has it, and all that comes of it
    if (assessor_.assesses()) new_assessment_ = assessor_.result();
    tell_questions();
    lever_pickup_.hold();
    event_number_ = 0;
    status_.state = RunState::ready;
    checkpoints_.clear();
    take_checkpoint();
    look_for_the_beginning();
    alerts_.rectify(kStopped, -1, tick_, time_);
    watch_what_stands();
    log("exercise.ready", fmt::format("{}: {}", def().name, def().title));
    brief();
    keep_events();
}

/// Tells the trainees what their lesson is about, a piece in each event, and whether it is over already; and
/// those who have the truth, of a run that goes on from there, that the bridge is waiting for an answer.
void Session::brief() {
    brief_each_seat();
    tell_aids();
    if (assessor_.lesson() == nullptr) return;
    int number = 0;
    for (std::string& piece : briefing_pieces(*assessor_.lesson()))
        log("exercise.briefing", std::move(piece), -1, ++number);
    lesson_over_told_ = false;
    tell_when_the_lesson_is_over();
    tell_when_the_bridge_gives_up();
}

/// What one seat alone is told. Whoever joins late hears what was told in earlier runs, too: so a seat that
/// has been told anything, and has no briefing of its own now, is told that.
void Session::brief_each_seat() {
    constexpr std::array<words::EventCode, 2> kCodes{"briefing.forecastle", "briefing.bridge"};
    std::array<std::vector<std::string>, 2> pieces;
    if (assessor_.lesson() != nullptr) pieces = own_briefing_pieces(*assessor_.lesson());
    for (std::size_t seat = 0; seat < kCodes.size(); ++seat) {
        int number = 0;
        for (std::string& piece : pieces.at(seat))
            log(kCodes.at(seat), std::move(piece), -1, ++number);
        if (number == 0 && instructed_.at(seat)) log(kCodes.at(seat), "nothing for this seat alone");
        instructed_.at(seat) = number > 0;
    }
}

Limits Session::limits() const {
    Limits limits{.side_present = {false, false},
                  .rudder_max = def().ship.rudder_max,
                  .time_scale = status_.time_scale,
                  .unpaced = !options_.realtime};
    for (const auto& tackle : def().tackle)
        limits.side_present[static_cast<std::size_t>(tackle.side)] = true;
    return limits;
}

bool Session::over() const {
    return status_.state == RunState::finished || status_.state == RunState::stopped_by_fault;
}

bool Session::ended() const {
    return options_.duration > 0 && over();
}

void Session::carry_out(const Inbox& inbox, double now) {
    now_ = now;
    while (auto told = refusals_.overdue(now))
        log(*told);
    if (inbox.overflow > 0) {
        if (auto told = refusals_.add_overflow(inbox.overflow, now)) log(*told);
    }
    for (const auto& refusal : inbox.refusals) {
        if (auto told = refusals_.add(refusal, now)) log(*told);
    }
    lever_ownership_.listen(now);
    for (const WriterKey& writer : inbox.came)
        lever_ownership_.come(writer);
    take_what_waited();
    for (const auto& order : inbox.orders) {
        const auto* command = std::get_if<exercise::Order>(&order.what);
        if (loading_ && !(command != nullptr && is_stream(*command))) {
            wait_for_load(order);
        } else {
            std::visit([&](const auto& what) { carry_out(what, order); }, order.what);
        }
        take_what_waited();
    }
    lever_pickup_.begun();
    for (const WriterKey& writer : inbox.left)
        lever_ownership_.leave(writer);
    look_for_hands();
    alerts_.sound_again(tick_, time_, now);
    status_.commands_refused = refusals_.total();
}

void Session::refuse(const char* topic, const std::string& source, const char* field, std::string value,
                     std::string allowed) {
    const Refusal refusal{.topic = topic,
                          .source = source,
                          .field = field,
                          .value = std::move(value),
                          .allowed = std::move(allowed),
                          .side = -1,
                          .number = 0};
    if (auto told = refusals_.add(refusal, now_)) log(*told);
}

void Session::carry_out(const exercise::Order& command, const ReceivedOrder& from) {
    const std::string& source = from.source;
    if (over() &&
        !std::holds_alternative<exercise::AssessorsWord>(command)) { // which may come when all is over
        // These go on arriving and mean nothing now; who gives any other order must hear that it is lost.
        if (!is_stream(command)) {
            refuse("Order", source, "state", name(status_.state), "load or reset the exercise first");
        }
        return;
    }
    // A foreign ship that sails on while the exercise stands still leaves it.
    if (!running() && std::holds_alternative<exercise::OwnShipSample>(command)) return;
    const auto levers = LeverOwnership::levers_of(command);
    if (levers && !take_levers(*levers, from)) return;
    if (const auto* word = std::get_if<exercise::AssessorsWord>(&command);
        word != nullptr && !judged(*word, source))
        return;
    apply(lever_pickup_.taken_up(command, from, status_.run, exercise_), source);
    if (std::holds_alternative<exercise::AssessorsWord>(command)) {
        new_assessment_ = assessor_.result();
        tell_when_the_lesson_is_over(); // which the word has ended, of an exercise that a fault has stopped
        go_on_when_answered();
    }
    const auto* fault = std::get_if<exercise::FaultOrder>(&command);
    if (fault != nullptr && fault->trigger == exercise::FaultTrigger::at_chance && !fault->clear)
        apply(exercise::ChanceDrawn{draw()}, kServerName);
    // What is ordered while the exercise stands still is seen at once, not at its next tick.
    if (!running() && !(levers && shows_levers(*levers, exercise_, snapshot_))) look();
}

void Session::apply(const exercise::Order& command, const std::string& source) {
    exercise_.apply(command);
    assessor_.hear(command);
    history_.add(tick_, command);
    orders_.push_back({.run = status_.run,
                       .tick = exercise_.tick(),
                       .number = ++orders_taken_,
                       .source = source,
                       .command = command});
    keep_for_the_model(command, source);
}

void Session::carry_out(const RunOrder& order, const ReceivedOrder& from) {
    const std::string& source = from.source;
    const RunState state = status_.state;
    switch (order.action) {
    case RunAction::load:
        begin_load(order, source);
        return;
    case RunAction::reset:
        reset(source);
        return;
    case RunAction::start:
        if (state == RunState::paused && asks()) {
            if (held_) return pass_over_questions(source);
            held_ = true;
            log("exercise.held", "exercise holds for a question");
            return;
        }
        if (state == RunState::ready || state == RunState::paused) {
            status_.state = RunState::running;
            watch_for_a_hand();
            log(state == RunState::ready ? words::EventCode("exercise.started")
                                         : words::EventCode("exercise.resumed"),
                fmt::format("{} by {}", state == RunState::ready ? "exercise started" : "exercise resumed",
                            source));
            return;
        }
        if (state == RunState::running) return;
        break;
    case RunAction::pause:
        if (state == RunState::running) {
            status_.state = RunState::paused;
            log("exercise.paused", "exercise paused by " + source);
            return;
        }
        if (state == RunState::paused) {
            if (std::exchange(held_, false)) log("exercise.paused", "exercise paused by " + source);
            return;
        }
        break;
    case RunAction::time_scale:
        status_.time_scale = order.time_scale;
        log("exercise.time_scale", fmt::format("time scale {} by {}", order.time_scale, source), -1,
            order.time_scale);
        return;
    case RunAction::snapshot:
        if (state == RunState::stopped_by_fault) break; // nobody could go on from there
        take_checkpoint_now();
        log("exercise.checkpoint", "checkpoint taken by " + source);
        return;
    case RunAction::restore:
        restore(order.restore_time, source);
        return;
    case RunAction::bookmark:
        log("exercise.bookmark", order.text.empty() ? "bookmark" : order.text);
        return;
    case RunAction::predict:
        if (std::exchange(predicts_, order.predict) == order.predict) return;
        log("exercise.prediction", fmt::format("predictions {} by {}", order.predict ? "on" : "off", source));
        return;
    case RunAction::stop:
        if (over()) return;
        finish("by " + source);
        return;
    }
    refuse("ExerciseCommand", source, "action", name(order.action),
           fmt::format("the exercise is {}; {}", name(state),
                       over() ? "load or reset it first" : "start it first"));
}

void Session::carry_out(const AlertOrder& order, const ReceivedOrder& from) {
    if (alerts_.acknowledge(order, tick_, time_, now_)) return;
    refuse("AlertCommand", from.source, "code", '"' + order.code + '"',
           "an alert that waits for this action");
}

bool Session::tick(bool show) {
    if (!running()) {
        if (!seen_) look();
        return false;
    }
    if (!exercise_.step(dt())) {
        fail(kNotFinite);
        return false;
    }
    const std::uint64_t now = exercise_.tick();
    const bool last = options_.duration > 0 &&
                      now >= static_cast<std::uint64_t>(std::llround(options_.duration * def().tick_rate_hz));
    // What is published or kept has its hash; the lesson looks at every tick, and at no hash.
    const bool whole = show || last || exercise_.called() || checkpoint_due(now);
    seen_ = whole;
    if (!whole && !assessor_.assesses()) {
        tick_ = now, time_ = exercise_.time();
        return true;
    }
    if (whole)
        exercise_.view(next_);
    else
        exercise_.view_unhashed(next_);
    if (!is_finite(next_)) {
        fail(kNotFinite);
        return false;
    }
    std::swap(snapshot_, next_);
    tick_ = snapshot_.tick, time_ = snapshot_.time;
    status_.orders_taken = orders_taken_;
    keep_events();
    watch_what_stands();
    assess();
    if (checkpoint_due(tick_)) take_checkpoint();
    if (last) finish("the set duration was run");
    return true;
}

void Session::finish(const std::string& reason) {
    if (over()) return;
    if (!seen_) look();
    close_assessment(reason);
    status_.state = RunState::finished;
    log("exercise.finished", "exercise finished: " + reason);
}

void Session::fail(const std::string& why) {
    status_.state = RunState::stopped_by_fault;
    failure_ = why;
    seen_ = true; // the last picture that was good: nobody is to look at what there is now
    std::string where;
    try {
        const std::string name = options_.id.empty() ? def().name : options_.id + "-" + def().name;
        const auto path = write_fault_dump(options_.fault_folder, name, snapshot_, history_);
        where = "last good state and commands in " + path.string();
    } catch (const std::exception& error) {
        where = std::string("no dump: ") + error.what();
    }
    log(kStopped, fmt::format("exercise stopped: {}; {}", why, where));
    alerts_.raise(alert(kStopped, -1, 0, {why}));
}

void Session::keep_events() {
    for (const auto& event : snapshot_.events) {
        events_.push_back(event);
        events_.back().number = ++event_number_; // one count for the exercise's events and ours
    }
}

void Session::log(words::EventCode code, std::string text, int side, double value) {
    log(code, code.row().severity, std::move(text), side, value);
}

/// Of a severity that hangs on what is so, and not on the code alone.
void Session::log(words::EventCode code, words::Severity severity, std::string text, int side, double value) {
    events_.push_back({.tick = tick_,
                       .time = time_,
                       .number = ++event_number_,
                       .severity = severity,
                       .code = std::string(code.row().name),
                       .side = side,
                       .value = value,
                       .text = std::move(text)});
}

void Session::log(const RefusalLog::Told& refusal) {
    log("command.refused", refusal.text, refusal.side, refusal.number);
}

void Session::report_pace(double lateness, std::uint64_t overruns, double scale_achieved,
                          std::uint64_t dropped) {
    status_.lateness = lateness;
    status_.overruns = overruns;
    status_.time_scale_achieved = scale_achieved;
    status_.samples_dropped = dropped;
}

void Session::clear_news() {
    new_checkpoint_ = false;
    new_assessment_.reset();
    questions_.clear();
    events_.clear();
    orders_.clear();
    alerts_.clear_changes();
}

} // namespace windlass::run
