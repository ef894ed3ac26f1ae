#pragma once
// Where commands wait for the next tick. DDS threads only put samples in; the exercise thread drains the
// box once per tick, and only there is anything decided.

#include "idl/wire.hpp"
#include "server/dds/check.hpp"

#include <array>
#include <atomic>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace windlass::dds {

/// Remembers the last serial accepted from each sender, for each kind of sample: a flood of one kind makes
/// no hand forgotten. A client that was started anew writes with a new writer, so that it may count from 1
/// again. Clocks of senders order nothing: one that is far ahead would shut out everybody of its name. That
/// an overheard sample is not sent again by another writer is for DDS Security to see to.
class Serials {
public:
    /// Accepts a serial above the last one accepted from that sender, or, where there was none, above 0. Any
    /// other is refused: then the last one is returned.
    std::optional<std::uint64_t> accept(std::size_t kind, const wire::WriterId& writer,
                                        const std::string& source, std::uint64_t serial);

private:
    struct Entry {
        wire::WriterId writer{};
        std::string source;
        std::uint64_t serial = 0;
        std::uint64_t used = 0;
    };
    /// By kind; each bounded: the sender not heard for longest makes room.
    std::map<std::size_t, std::vector<Entry>> entries_;
    std::uint64_t uses_ = 0;
};

class Mailbox {
public:
    using Sample = std::variant<WindlassCommand, HelmCommand, ExerciseCommand, FaultCommand, Report,
                                AlertCommand, RestoreCommand, EnvironmentCommand, BridgeOrderCommand,
                                WatchCircle, OwnShipInput, AssessmentCommand, LightsAndShapesCommand,
                                DeckWorkCommand, ForecastleAnswer, BridgeAnswer>;

    explicit Mailbox(std::size_t capacity = 1024);

    /// From a DDS thread: keeps the sample, or counts it as refused when the box is full. instructor: it came
    /// over the instructors' own topic of that type. moved_in_run: as in ReceivedOrder.
    void put(const Sample& sample, const wire::WriterId& writer, bool instructor = false,
             std::uint64_t moved_in_run = 0);

    /// From a DDS thread: counts a sample of that topic (its place in Sample) as refused unseen.
    enum class Unseen { malformed, too_fast };
    void refuse(std::size_t kind, Unseen why);

    /// From a DDS thread: a writer of levers is there no more. Of many at once the first 256 are told.
    void leave(const wire::WriterId& writer);
    /// From a DDS thread: a writer of levers is there, for the first time or again.
    void come(const wire::WriterId& writer);

    /// Whether nothing was put in or refused since it was emptied. From any thread; waits for none.
    bool empty() const { return empty_; }

    /// From the exercise thread: empties the box into inbox (cleared first), each sample checked.
    void drain(const run::Limits& limits, run::Inbox& inbox);

private:
    struct Received {
        Sample sample;
        wire::WriterId writer;
        bool instructor = false;
        std::uint64_t moved_in_run = 0;
    };

    const std::size_t capacity_;
    std::mutex mutex_;
    std::vector<Received> waiting_;                                                  // guarded by mutex_
    std::uint64_t overflow_ = 0;                                                     // guarded by mutex_
    std::vector<wire::WriterId> left_, came_;                                        // guarded by mutex_
    std::array<std::array<std::uint64_t, 2>, std::variant_size_v<Sample>> unseen_{}; // guarded by mutex_
    std::atomic<bool> empty_{true};                                                  // written under mutex_
    std::vector<Received> drained_; // the exercise thread's, swapped with waiting_
    Serials serials_;
};

} // namespace windlass::dds
