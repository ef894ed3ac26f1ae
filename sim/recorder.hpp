#pragma once
// The centre's recorder, a process of its own: hears what the session publishes, writes it with the
// recorder's own code to a disk of its own, ends in order, is killed, or goes with the power; another one
// begins then, in another folder. Draws by a chance of its own, and cuts the power for nobody, so that the
// rest of a seed is what it would be without it.

#include "recorder/record/tape_feed.hpp"
#include "server/run/session.hpp"
#include "sim/centre.hpp"
#include "sim/recording_checks.hpp"

#include <array>
#include <deque>
#include <map>
#include <optional>

namespace windlass::sim {

class Recorder {
public:
    Recorder(World& world, std::uint64_t seed, Sabotage sabotage);

    /// What is published from now on comes from other writers.
    void server_begins();
    /// A tick's news, as the server publishes them; before they are cleared.
    void hear(const run::Session& session);
    /// As the server's machine loses it.
    void lose_power();
    /// Holds what there is against what was heard.
    void end();

    std::uint64_t recordings() const { return recordings_; } ///< begun
    std::uint64_t kills() const { return kills_; }

private:
    using Samples = std::vector<recorder::Sample>;
    /// One recorder, as `recorder record` is.
    struct Process {
        Process(std::filesystem::path folder, std::size_t queue_size, const recorder::QueueClock& clock,
                recorder::TapeOptions options, SimDisk& disk);
        recorder::SampleQueue queue;
        recorder::Tape tape;
        recorder::TapeFeed feed{queue, tape};
        Recorded recorded;
        double flushes_at;      // s
        bool listens = true;    // no more, as it ends
        bool closed = false;    // its tape, while it waits for the disk
        bool discarded = false; // it heard nothing, and leaves nothing
    };

    template <class Sample, class View>
    void publish(const wire::Topic<Sample>& topic, const View& view, Samples& samples);
    void send(Samples samples);
    void arrive(std::uint64_t life, double sent, Samples& samples);
    void account(const recorder::Sample& sample);
    std::int64_t unix_ns(double at) const;
    bool listens(std::uint64_t life) const { return process_ && life == life_ && process_->listens; }

    void begin();
    void begin_in(double seconds);
    void step();
    void close(const char* because);
    void finish();
    void lose(Loss how);
    void hold(Recorded recorded);
    void clear_away_old();
    void weather_the_disk();
    template <class What>
    void after(double seconds, What what);

    World& world_;
    Chance chance_;
    SimDisk disk_;
    const Sabotage sabotage_;
    bool sabotaged_ = false;

    std::uint64_t servers_ = 0;
    std::array<std::uint32_t, wire::topics::all.size()> sequences_{}; // of this server's writers, by topic
    std::map<recorder::WriterId, std::uint32_t> accounted_;           // that came last, heard or not
    double arrived_ = 0, congested_until_ = 0;                        // s

    std::uint64_t life_ = 0; // of this recorder, or of the time between two
    std::optional<Process> process_;
    double ends_at_ = 0; // s
    std::deque<Recorded> kept_;
    std::uint64_t folders_ = 0, recordings_ = 0, kills_ = 0;
};

} // namespace windlass::sim
