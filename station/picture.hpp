#pragma once
// The picture that a station has of an exercise: the latest sample of every topic, and what was largest.
// Plain values without DDS, so that views, scripts and their tests need no network.

#include <windlass.h>

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

/// Largest values met at one windlass since the start of the run, SI.
struct Extremes {
    double hawse_tension = 0;      ///< N
    double hawse_tension_time = 0; ///< s, when it was met
    double brake_load = 0;         ///< N
    double pay_out_speed = 0;      ///< m/s
    double lining_temperature = 0; ///< K
};

/// One anchor with its cable and windlass.
struct TacklePicture {
    Latest<AnchorState> anchor;
    Latest<ChainState> chain;
    Latest<WindlassLoad> load;
    Latest<WindlassCommand> levers; ///< set points in force, and who gives them
    Extremes extremes;
};

inline constexpr const char* kReplayTakesNoOrders = "this is a replay, which takes no orders";

/// Everything that a station knows. take() files a sample that has just come; a run that starts again
/// (tick or event number going back) clears events and extremes.
struct Picture {
    Latest<ExerciseStatus> status;
    Latest<ShipState> ship;
    Latest<HelmCommand> helm;
    std::array<TacklePicture, 2> tackle; ///< by side
    std::deque<Event> events;            ///< of this run, oldest first, at most kEventsKept
    std::uint64_t events_received = 0;   ///< since this station joined, over all runs
    std::uint64_t runs = 1;              ///< runs seen; counts up when the exercise starts again
    std::vector<Alert> alerts;           ///< not yet back to normal, one per code and side

    static constexpr std::size_t kEventsKept = 500;

    void take(const ExerciseStatus& sample, Clock::time_point now);
    void take(const ShipState& sample, Clock::time_point now);
    void take(const HelmCommand& sample, Clock::time_point now);
    void take(const AnchorState& sample, Clock::time_point now);
    void take(const ChainState& sample, Clock::time_point now);
    void take(const WindlassLoad& sample, Clock::time_point now);
    void take(const WindlassCommand& sample, Clock::time_point now);
    void take(const Event& sample, Clock::time_point now);
    void take(const Alert& sample, Clock::time_point now);

    /// Events that came after the first `seen` ones, oldest first; those no longer kept are left out.
    std::vector<Event> events_after(std::uint64_t seen) const;

    /// The server's words when it refused an order of that source, among the events after the first `seen`
    /// that are not older than `since` s of exercise time.
    std::optional<std::string> refusal(const std::string& source, std::uint64_t seen, double since = 0) const;

    /// s of exercise, the newest that was heard: that side's loads come 100 times a second, the status only 5
    /// times. 0 before the first status.
    double time(int side) const;

    /// A recording is shown: nobody is there to take an order.
    bool replayed() const;

    /// Seconds since the server was last heard; nothing before the first sample.
    std::optional<double> silence(Clock::time_point now) const;
};

} // namespace windlass::station
