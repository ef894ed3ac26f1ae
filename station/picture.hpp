#pragma once
// The picture that a station has of an exercise: the latest sample of every topic that it hears, and what was
// largest. Plain values without DDS, so that views, scripts and their tests need no network.

#include "idl/topics.hpp"
#include "idl/types.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace windlass::station {

using Clock = std::chrono::steady_clock;

/// Latest sample of a topic and when it came; nothing before the first one.
template <class T>
struct Latest {
    T sample{};
    std::optional<Clock::time_point> at;

    explicit operator bool() const { return at.has_value(); }
    const T* operator->() const { return &sample; }
    const T& operator*() const { return sample; }
};

/// Of two hands on one lever, the one that has it: the instructor's, as long as it speaks.
template <class T>
const Latest<T>& in_force(const Latest<T>& trainee, const Latest<T>& instructor) {
    constexpr std::chrono::duration<double> kSilent{wire::topics::kCommandDeadline};
    if (!instructor) return trainee;
    return trainee && *trainee.at - *instructor.at > kSilent ? trainee : instructor;
}

/// What came, oldest first, at most kKept of it.
template <class T>
struct Log {
    static constexpr std::size_t kKept = 500;

    std::deque<T> kept;
    std::uint64_t received = 0; ///< since this station joined, over all runs

    void add(const T& sample) {
        kept.push_back(sample);
        if (kept.size() > kKept) kept.pop_front();
        ++received;
    }

    /// Those that came after the first `seen` ones, oldest first; those no longer kept are left out.
    std::vector<T> after(std::uint64_t seen) const {
        const auto fresh = std::min<std::uint64_t>(received - seen, kept.size());
        return {kept.end() - static_cast<std::ptrdiff_t>(fresh), kept.end()};
    }
};

/// Events of this run. T: Event or SeatEvent.
template <class T>
struct EventLog : Log<T> {
    std::uint64_t newest = 0; ///< number of the last that came

    /// A number that goes back is of a run that begins again: what was kept is forgotten. beside: another log
    /// of this station has it.
    void receive(const T& sample, bool beside = false) {
        if (sample.number() <= newest) this->kept.clear();
        newest = sample.number();
        if (!beside) this->add(sample);
    }
};

/// How far the logs had been read.
struct LogsRead {
    std::uint64_t events = 0;
    std::array<std::uint64_t, 2> seat_events{}, instructions{};
};

/// Largest values met at one windlass since the start of the run, SI: the truth.
struct Extremes {
    double hawse_tension = 0;      ///< N
    double hawse_tension_time = 0; ///< s, when it was met
    double brake_load = 0;         ///< N
    double pay_out_speed = 0;      ///< m/s
    double lining_temperature = 0; ///< K
};

/// The same as far as a seat can tell.
struct SeenExtremes {
    double load = 0;          ///< N, by the load cell
    double load_time = 0;     ///< s, when it was met
    double pay_out_speed = 0; ///< m/s, by the counter; by eye where none is fitted
    LiningSeen lining = LINING_COOL;
};

/// One anchor with its cable and windlass.
struct TacklePicture {
    Latest<ForecastleView> view; ///< what a seat is given
    SeenExtremes seen;

    Latest<AnchorState> anchor; ///< the truth, this and the two below
    Latest<ChainState> chain;
    Latest<WindlassLoad> load;
    Extremes extremes;

    Latest<WindlassCommand> levers;            ///< set points of the trainee who is heard
    Latest<WindlassCommand> instructor_levers; ///< of the instructor, whom the server prefers

    const Latest<WindlassCommand>& levers_in_force() const { return in_force(levers, instructor_levers); }
};

inline constexpr const char* kReplayTakesNoOrders = "this is a replay, which takes no orders";

/// Everything that a station knows, of what a seat is given and of the truth; either may be missing.
/// receive() files a sample that has just come; a run that starts again (tick or event number going back)
/// clears events and extremes.
struct Picture {
    Latest<ExerciseStatus> status;
    std::array<TacklePicture, 2> tackle; ///< by side
    std::vector<Alert> alerts;           ///< not yet back to normal, one per code and side
    std::vector<BridgeOrder> orders;     ///< of the latest run, by number
    Latest<HelmCommand> helm;            ///< set points of the trainee who is heard
    Latest<HelmCommand> instructor_helm;

    Latest<BridgeView> bridge; ///< what a seat is given, this and the one below
    /// What is noticed there: forecastle, bridge. A station of both has what both notice in the first.
    std::array<EventLog<SeatEvent>, 2> seat_events;
    /// Briefing and hints that are told to one seat alone: forecastle, bridge.
    std::array<EventLog<SeatEvent>, 2> instructions;
    /// What is asked at a freeze: forecastle, bridge; an empty id: nothing any more.
    std::array<Latest<Question>, 2> questions;
    Log<Report> reports; ///< of the forecastle, as a bridge hears them: none while its VHF is dead

    Latest<ExerciseTruth> truth; ///< the truth, this and all below
    Latest<EnvironmentState> environment;
    Latest<ShipState> ship;
    EventLog<Event> events;

    void receive(const ExerciseStatus& sample, Clock::time_point now);
    void receive(const ExerciseTruth& sample, Clock::time_point now);
    void receive(const EnvironmentState& sample, Clock::time_point now);
    void receive(const ShipState& sample, Clock::time_point now);
    void receive(const AnchorState& sample, Clock::time_point now);
    void receive(const ChainState& sample, Clock::time_point now);
    void receive(const WindlassLoad& sample, Clock::time_point now);
    void receive(const ForecastleView& sample, Clock::time_point now);
    void receive(const BridgeView& sample, Clock::time_point now);
    void receive(const Event& sample, Clock::time_point now);
    void take_forecastle_event(const SeatEvent& sample, Clock::time_point now);
    void take_bridge_event(const SeatEvent& sample, Clock::time_point now);
    /// One of the bridge's at a station that has those of the forecastle, too.
    void take_event_beside(const SeatEvent& sample, Clock::time_point now);
    void take_instruction(const SeatEvent& sample, Clock::time_point now);
    void take_forecastle_question(const Question& sample, Clock::time_point now);
    void take_bridge_question(const Question& sample, Clock::time_point now);
    void receive(const Alert& sample, Clock::time_point now);
    void receive(const BridgeOrder& sample, Clock::time_point now);
    void receive(const Report& sample, Clock::time_point now);
    /// Levers and helm of a trainee, and of an instructor.
    void receive(const WindlassCommand& sample, Clock::time_point now);
    void receive(const HelmCommand& sample, Clock::time_point now);
    void take_instructor(const WindlassCommand& sample, Clock::time_point now);
    void take_instructor(const HelmCommand& sample, Clock::time_point now);

    const Latest<HelmCommand>& helm_in_force() const { return in_force(helm, instructor_helm); }

    /// How many events came so far.
    LogsRead logs_read() const {
        return {events.received,
                {seat_events[0].received, seat_events[1].received},
                {instructions[0].received, instructions[1].received}};
    }

    /// The server's words when it refused an order of that source, among the events after those seen that are
    /// not older than `since` s of exercise time.
    std::optional<std::string> refusal(const std::string& source, const LogsRead& seen,
                                       double since = 0) const;

    /// The newest order of the bridge that waits to be repeated back; null: none.
    const BridgeOrder* order_to_repeat() const;

    /// The newest order of that code in this run; null: none.
    const BridgeOrder* order(BridgeOrderCode code) const;

    /// s of exercise, the newest that was heard: that side's loads come 100 times a second, the status only 5
    /// times. 0 before the first status.
    double time(int side) const;

    /// A recording is shown: nobody is there to take an order.
    bool replayed() const;

    /// Seconds since the server was last heard; nothing before the first sample.
    std::optional<double> silence(Clock::time_point now) const;
};

} // namespace windlass::station
