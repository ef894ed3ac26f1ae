#pragma once
// The thread that has what time all others leave. It looks a minute ahead, for exercises whose instructor has
// asked for it: it goes through a branch of each, made of a copy of its state. Beside those who practise it
// has a Companion.

#include "server/host/idle_work.hpp"
#include "server/run/prediction.hpp"
#include "server/run/session.hpp"

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace windlass::host {

/// One exercise between the thread that ticks it and the lookout: a state goes there, a prediction comes
/// back. The thread that ticks waits for nothing, and each frees what it allocated itself: a lookout that is
/// preempted holds up nobody.
class Outlook final : public IdleWork {
public:
    using Clock = std::chrono::steady_clock;
    using Time = Clock::time_point;
    using Tell = std::function<void(const run::PredictionView&)>;

    static constexpr double kShare = 0.1;    ///< of a core that predictions of one exercise take, at most
    static constexpr double kMostTime = 1.5; ///< s of processor time that one of them takes
    /// From one to the next, at least: more of them nobody could look at, and a recording keeps them all.
    static constexpr std::chrono::seconds kApart{2};
    /// One that takes longer is told as far as it has come; of an exercise that stands still it does not grow
    /// old.
    static constexpr std::chrono::seconds kPatience{10};

    // Of the thread that ticks, between two ticks.

    /// Tells what is new: that predictions are on or off, and each that was made. Gives the lookout a state
    /// where it is to make one: true, and it is to be called. Of an exercise that stands still there is one.
    bool look(const run::Session& session, Time now, const Tell& tell);
    /// The exercise is gone, or nearly.
    void close();

    // Of the lookout.

    /// Goes on a little. False: there is nothing to do.
    bool go_on() override;
    bool closed() const override { return closed_; }

private:
    /// What a prediction is made of: while neither changes it would be the same.
    struct Stand {
        std::uint64_t run = 0, tick = 0, orders = 0;
        bool operator==(const Stand&) const = default;
    };

    void put_down(bool made);

    // Of the thread that ticks
    bool on_ = false;       // as last told
    std::uint64_t run_ = 0; // of which that was
    Stand given_;

    // Between them
    std::atomic<std::uint64_t> wanted_{0}; // the run of which predictions are wanted; 0: none are
    std::atomic<bool> closed_{false};
    std::atomic<bool> stands_{false}; // the exercise does
    std::mutex mutex_;                // of what follows; the thread that ticks only tries it
    std::vector<std::uint8_t> state_; // the lookout's, while it is at it
    std::uint64_t of_run_ = 0;        // that it is of
    Time given_at_{};
    double spent_ = 0;   // s of processor time, from then on
    bool waits_ = false; // a state that nobody has taken up
    bool at_it_ = false; // the lookout goes on from it
    bool made_ = false;  // a prediction that was not told
    run::PredictionView prediction_;
    Time rests_until_{};

    // Of the lookout
    std::optional<run::Branch> branch_;
};

/// Owns the thread.
class Lookout {
public:
    Lookout();
    ~Lookout();
    Lookout(const Lookout&) = delete;
    Lookout& operator=(const Lookout&) = delete;

    /// Looks ahead for one more exercise, when it is asked to, until that is closed.
    std::shared_ptr<Outlook> add();
    /// The same of what else is to be done beside an exercise.
    void add(std::shared_ptr<IdleWork> work);
    /// There is something to do. From any thread; neither waits nor allocates.
    void call();

private:
    void work();
    std::vector<std::shared_ptr<IdleWork>> works();

    std::mutex mutex_; // of the list; no thread that ticks asks for it
    std::vector<std::shared_ptr<IdleWork>> works_;
    std::atomic<int> calls_{0};
    std::atomic<bool> stop_{false};
    std::thread thread_; // last: it uses all of the above
};

} // namespace windlass::host
