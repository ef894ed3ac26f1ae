#pragma once
// One exercise in its partition: session, clock, and its ends on the wire.

#include "server/dds/command_readers.hpp"
#include "server/dds/publisher.hpp"
#include "server/host/companion.hpp"
#include "server/host/host_threads.hpp"
#include "server/host/pacer.hpp"
#include "server/run/session.hpp"

namespace windlass::host {

/// How an exercise does, for who looks after many.
struct HostedStatus {
    std::string id; ///< its partition is exercise/ID
    run::RunStatus run;
    std::uint64_t tick = 0;
    double time = 0;           ///< s of exercise
    double load = 0;           ///< share of a core that its ticks took, over the last second of wall time
    double worst_lateness = 0; ///< s, the latest end of a tick in that second
    std::int64_t since_unix_ns = 0; ///< ns since 1970, when it was opened
    std::string failure;            ///< why it was stopped by a fault; empty: it was not
};

/// Ticks in its own time when a thread of the pool works on it. What goes wrong inside stops this exercise
/// and no other.
class HostedExercise final : public Task {
public:
    /// Joins partition exercise/ID as that member; the threads write what it publishes, and count how late
    /// its beats begin. Throws std::invalid_argument when the exercise cannot be set
    /// up from its definition, std::runtime_error when there is no DDS.
    HostedExercise(const wire::Participant& member, HostThreads& threads, std::string id,
                   const exercise::ExerciseDef& def, run::SessionOptions options);
    /// What is kept on disk of an exercise that was not closed in order stays there.
    ~HostedExercise() override;

    Time due() const override { return pacer_.due(); }
    /// One beat: orders, ticks, what is to be published. False when the exercise has ended.
    bool run() noexcept override;
    /// One that is hurried has what the others leave.
    bool gives_way() const override { return pacer_.hurried(); }

    /// Ends the exercise and publishes that. No thread may have it any more. in_order: nothing of it is to be
    /// taken up again.
    void finish(const std::string& reason, bool in_order);
    /// Waits until all is written and every connected reader has it, or time is up.
    void flush(std::chrono::milliseconds timeout) { publisher_.flush(timeout); }

    const std::string& id() const { return id_; }
    bool ended() const { return ended_; }              ///< from any thread
    bool stopped_by_fault() const { return stopped_; } ///< from any thread
    HostedStatus status() const;                       ///< from any thread; some 0.1 s old at most
    /// How long the beat lasts already that a thread is at; 0: none is. From any thread.
    std::chrono::steady_clock::duration beat_lasts() const;

private:
    void beat();
    void set_aside(const char* why) noexcept;
    void publish(double now);
    void keep();
    void look_ahead(Time now);
    void stop_keeping(bool in_order);
    void prepare();
    void measure(Time began, Time ended);
    double seconds(Time t) const { return std::chrono::duration<double>(t - start_).count(); }

    const std::string id_;
    const Time start_;
    const std::int64_t since_unix_ns_;
    run::Session session_;
    wire::Participant participant_;
    dds::Mailbox mailbox_;
    dds::Publisher publisher_;
    const dds::CommandReaders readers_;
    Timekeeping& timekeeping_;
    std::shared_ptr<keep::KeptExercise> kept_; // none: it is not kept
    Lookout& lookout_;
    const std::shared_ptr<Outlook> outlook_;
    const std::shared_ptr<Companion> companion_;
    Pacer pacer_;
    run::Inbox inbox_;
    unsigned setups_ = 0;
    double scale_;

    Time measured_since_;
    double busy_ = 0, worst_lateness_ = 0; // s, since then
    double load_ = 0, shown_lateness_ = 0; // of the last second
    Time shown_at_;

    std::atomic<Time> beat_began_{Time{}}; // no beat: never
    std::atomic<bool> ended_{false}, stopped_{false};
    mutable std::mutex shown_mutex_;
    HostedStatus shown_; // guarded by shown_mutex_
};

} // namespace windlass::host
