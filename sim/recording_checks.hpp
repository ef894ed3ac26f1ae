#pragma once
// What must hold of a recording, whatever became of its recorder: its files, read back by the recorder's own
// reader, against what was heard.

#include "recorder/record/sample_queue.hpp"
#include "sim/disk.hpp"

namespace windlass::sim {

/// A sample as a recorder heard it; of its payload a hash, so that memory stays small.
struct HeardSample {
    std::size_t topic = 0; ///< row of wire::topics::all
    recorder::WriterId writer{};
    std::uint32_t sequence = 0;
    std::int64_t log_time = 0, publish_time = 0; ///< ns since 1970
    std::uint64_t payload = 0;                   ///< its hash
    bool operator==(const HeardSample&) const = default;
};

/// What one recorder heard, and what became of it.
struct Recorded {
    std::filesystem::path folder;
    std::vector<HeardSample> heard{}; ///< that its queue had room for
    std::uint64_t dropped = 0;        ///< that it had none for
    std::size_t flushed = 0;          ///< of those it heard, up to the last flush that succeeded
    bool refused = false;             ///< by its disk: it was to end early
    bool ended = false;               ///< by itself, and was not lost before
    bool closed = false;              ///< its files are, as far as its disk let it
    bool power_cut = false;           ///< since it began
};

/// Of the payload.
std::uint64_t hash_of(files::Bytes payload);

/// Holds its files against what was heard; throws Failure.
void hold_recording(SimDisk& disk, const Recorded& recorded);

} // namespace windlass::sim
