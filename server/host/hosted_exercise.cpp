#include "server/host/hosted_exercise.hpp"

#include "server/exercise/checkpoint.hpp"
#include "server/exercise/definition/def_fields.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>

namespace windlass::host {

namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto kShownEvery = 100ms;
constexpr double kMeasuringTime = 1; // s
/// What is hurried gives its thread back between two ticks, so that an exercise in real time waits for one at
/// most.
constexpr auto kLongestHurry = 2ms;

void tell(const std::string& id, const exercise::ExerciseEvent& event) {
    constexpr std::array levels{spdlog::level::info, spdlog::level::warn, spdlog::level::warn,
                                spdlog::level::err};
    const std::string side =
        event.side < 0 ? ""
                       : std::string{exercise::kSideNames.at(static_cast<std::size_t>(event.side))} + ": ";
    spdlog::log(levels.at(static_cast<std::size_t>(event.severity)), "{} {:8.2f} s {}: {}{}", id, event.time,
                event.code, side, event.text);
}

} // namespace

HostedExercise::HostedExercise(const wire::Participant& member, HostThreads& threads, std::string id,
                               const exercise::ExerciseDef& def, run::SessionOptions options)
    : id_(std::move(id)),
      start_(Clock::now()),
      since_unix_ns_(std::chrono::duration_cast<std::chrono::nanoseconds>(
                         std::chrono::system_clock::now().time_since_epoch())
                         .count()),
      session_(def, std::move(options)),
      participant_(member, wire::exercise_partition(id_)),
      publisher_(participant_, threads.publishing),
      readers_(participant_, mailbox_),
      timekeeping_(threads.timekeeping),
      kept_(threads.keeper != nullptr ? threads.keeper->keep(id_, exercise::definition_hash(def)) : nullptr),
      lookout_(threads.lookout),
      outlook_(lookout_.add()),
      companion_(std::make_shared<Companion>(session_.model_hands())),
      pacer_(session_.dt(), session_.status().time_scale, Clock::now()),
      scale_(session_.status().time_scale),
      measured_since_(start_),
      shown_at_(start_ - 1h) {
    lookout_.add(companion_);
    prepare();
    measure(start_, start_);
}

HostedExercise::~HostedExercise() {
    outlook_->close();
    companion_->close();
    lookout_.call();
    stop_keeping(false);
}

void HostedExercise::stop_keeping(bool in_order) {
    const auto kept = std::exchange(kept_, nullptr);
    if (!kept) return;
    if (!in_order) kept->look(session_, true);
    kept->close(in_order);
}

void HostedExercise::keep() {
    if (!kept_) return;
    kept_->look(session_);
    session_.report_keeping(kept_->trouble());
}

void HostedExercise::look_ahead(Time now) {
    const auto tell = [this](const run::PredictionView& prediction) { publisher_.offer(prediction); };
    const auto show = [this](const dds::Ghost& hands, bool forecastle) {
        if (!forecastle) return publisher_.offer(hands.bridge);
        for (const ForecastleView& view : hands.forecastle)
            publisher_.offer(view);
    };
    try {
        const bool ahead = outlook_->look(session_, now, tell);
        const bool beside = companion_->look(session_, now, show);
        if (ahead || beside) lookout_.call();
    } catch (const std::bad_alloc&) { // there is none, then, and the exercise goes on
    }
}

/// Room for the whole cable, so that paying out never makes the publisher's slots grow.
void HostedExercise::prepare() {
    setups_ = session_.setups();
    const auto& def = session_.def();
    std::size_t nodes = 0;
    for (const auto& tackle : def.tackle) {
        const double spacing = exercise::modelled_chain(def, tackle).node_spacing;
        nodes = std::max(nodes, static_cast<std::size_t>(tackle.chain.length / spacing) + 16);
    }
    publisher_.prepare(def.tackle.size(), nodes);
    publisher_.describe(def, session_.snapshot());
}

void HostedExercise::publish(double now) {
    keep();
    for (const auto& event : session_.events()) {
        tell(id_, event);
        publisher_.offer(event, session_.snapshot(), session_.status());
    }
    for (const auto& alert : session_.alerts())
        publisher_.offer(alert);
    for (const auto& question : session_.questions())
        publisher_.offer(question);
    for (const auto& order : session_.orders())
        publisher_.offer(order);
    if (session_.assessment()) {
        publisher_.offer(*session_.assessment());
        if (session_.marks_are_told()) publisher_.tell_seats(*session_.assessment());
    }
    if (!session_.marks_are_told()) publisher_.take_marks_back();
    if (const run::CheckpointView* checkpoint = session_.checkpoint()) publisher_.offer(*checkpoint);
    session_.clear_news();
    if (session_.seen()) publisher_.offer(session_.snapshot(), session_.status(), now);
}

bool HostedExercise::run() noexcept {
    const auto began = Clock::now();
    beat_began_ = began;
    if (pacer_.paced()) timekeeping_.began(began - pacer_.due());
    try {
        beat();
    } catch (const std::exception& error) {
        set_aside(error.what());
    } catch (...) {
        set_aside("an exception that does not say what it is");
    }
    try {
        measure(began, Clock::now());
    } catch (const std::exception&) { // no memory for what is shown: it is older, then
    }
    beat_began_ = Time{};
    return !ended_;
}

std::chrono::steady_clock::duration HostedExercise::beat_lasts() const {
    const Time began = beat_began_;
    return began == Time{} ? Clock::duration{} : Clock::now() - began;
}

/// Stops the exercise and says why, once. It goes on with the slow beats of one that stands still, so that an
/// instructor is heard, and what throws again and again neither takes a thread nor fills the log.
void HostedExercise::set_aside(const char* why) noexcept {
    const auto now = Clock::now();
    pacer_.set_standing(true, now);
    pacer_.beat_ended(0, now);
    if (!session_.failure().empty()) return;
    try {
        session_.clear_news(); // it may be what cannot be published
        session_.fail(why);
    } catch (const std::exception&) { // no memory for the words; it is stopped all the same
    }
}

void HostedExercise::beat() {
    const auto began = Clock::now();
    int ticks = 0;
    for (int i = pacer_.ticks_per_beat(); i > 0 && !session_.ended(); --i) {
        if (ticks > 0 && pacer_.hurried() && Clock::now() - began > kLongestHurry) break;
        const double now = seconds(Clock::now());
        if (mailbox_.empty()) {
            inbox_.clear();
        } else {
            mailbox_.drain(session_.limits(), inbox_);
        }
        session_.carry_out(inbox_, now);
        const bool look = publisher_.wants(session_.now_tick() + 1, session_.status(), now);
        if (session_.tick(look)) ++ticks;
        publish(now);
    }
    if (kept_ && kept_->wants_checkpoint()) session_.take_checkpoint_now();
    const auto now = Clock::now();
    // Ten times a second: what stands beside it lies in memory that no tick needs.
    if (now - shown_at_ >= kShownEvery) look_ahead(now);
    pacer_.beat_ended(ticks, now);
    session_.report_pace(pacer_.lateness(), pacer_.overruns(), pacer_.scale_achieved(), publisher_.dropped());
    if (setups_ != session_.setups()) {
        prepare();
        pacer_.set_tick(session_.dt(), Clock::now());
    }
    if (scale_ != session_.status().time_scale) {
        scale_ = session_.status().time_scale;
        pacer_.set_scale(scale_, now);
    }
    pacer_.hold_back(session_.hand_is_late(), now);
    pacer_.set_standing(!session_.running(), now);
}

void HostedExercise::measure(Time began, Time ended) {
    busy_ += std::chrono::duration<double>(ended - began).count();
    worst_lateness_ = std::max(worst_lateness_, pacer_.lateness());
    const double elapsed = std::chrono::duration<double>(ended - measured_since_).count();
    if (elapsed >= kMeasuringTime) {
        load_ = busy_ / elapsed;
        shown_lateness_ = worst_lateness_;
        busy_ = worst_lateness_ = 0;
        measured_since_ = ended;
    }
    ended_ = session_.ended();
    stopped_ = session_.status().state == exercise::RunState::stopped_by_fault;
    if (ended - shown_at_ < kShownEvery && !ended_) return;
    const std::unique_lock lock(shown_mutex_, std::try_to_lock); // the exercise waits for nobody who looks
    if (!lock) return;
    shown_at_ = ended;
    shown_ = {.id = id_,
              .run = session_.status(),
              .tick = session_.now_tick(),
              .time = session_.now_time(),
              .load = load_,
              .worst_lateness = shown_lateness_,
              .since_unix_ns = since_unix_ns_,
              .failure = session_.failure()};
}

HostedStatus HostedExercise::status() const {
    const std::lock_guard lock(shown_mutex_);
    return shown_;
}

void HostedExercise::finish(const std::string& reason, bool in_order) {
    stop_keeping(in_order); // before its end is there to be kept
    session_.finish(reason);
    flush(200ms); // room for the last picture
    publish(seconds(Clock::now()));
}

} // namespace windlass::host
