#pragma once
// The wire without the types: payloads as they travel, for whoever records and replays them unchanged.

#include "idl/bounds.hpp"
#include "idl/wire.hpp"

#include <chrono>
#include <span>

namespace windlass::wire {

/// One sample as it came: the 4-byte CDR header and the CDR behind it.
struct RawSample {
    Bytes payload; ///< valid during the callback only
    WriterId writer;
    std::uint64_t sequence = 0;       ///< of this writer, counts up by one; a gap: samples were lost
    std::int64_t written_unix_ns = 0; ///< ns since 1970-01-01 UTC at the writer
};

/// Hears one topic of the table, payloads unopened. Callbacks as with Reader: samples of one key in the order
/// in which they were written, those of several keys that wait at once key by key. A participant has raw or
/// typed ends of a topic, not both (std::logic_error).
class RawReader {
public:
    using OnSample = std::function<void(const RawSample&)>;

    /// Throws std::runtime_error when the reader cannot be made.
    RawReader(Participant& participant, const TopicInfo& info, OnSample on_sample);
    ~RawReader();
    RawReader(RawReader&&) noexcept;

    int matched() const;         ///< writers connected now
    std::uint64_t wrong() const; ///< samples refused: no CDR header, or larger than the type can be

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Writes payloads to one topic of the table. One thread at a time.
class RawWriter {
public:
    /// ownership_strength as with Writer. Throws std::runtime_error when the writer cannot be made.
    RawWriter(Participant& participant, const TopicInfo& info, int ownership_strength = 0);
    ~RawWriter();
    RawWriter(RawWriter&&) noexcept;

    /// Sends the payload, byte for byte. False: not stored, or not a payload of this type.
    bool write(Bytes payload);

    /// Takes an exclusive topic over: speaks from now on with a strength above those of all other writers
    /// that are known in its partition. Readers hear of it within milliseconds. Nothing where it is above
    /// them already, or none is above theirs.
    void outrank();

    /// That writer, of another participant, has a higher strength: where both speak, it is heard.
    bool outranked_by(const WriterId& writer) const;

    /// Waits until every reliable reader has what was written. False after the timeout.
    bool wait_acknowledged(std::chrono::milliseconds timeout);

    int matched() const;                       ///< readers connected now
    bool heard_by(const WriterId& peer) const; ///< as with Writer
    WriterId id() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace windlass::wire
