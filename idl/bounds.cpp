#include "idl/bounds.hpp"

namespace windlass::wire {

namespace {

// As windlass.idl says; a test counts its sequences.
constexpr std::uint32_t kFaults = 32, kNodes = 2048, kMarks = 64, kCriteria = 64, kCheckpoint = 1048576;
constexpr std::uint32_t kHosted = 64, kDefinition = 262144;

/// Walks over a CDR payload (XCDR1: a number of N bytes stands at a multiple of N) without opening it.
class Walk {
public:
    explicit Walk(Bytes payload)
        : body_(payload.size() < kHeader ? Bytes() : payload.subspan(kHeader)),
          big_endian_(payload.size() > 1 && (payload[1] & 1U) == 0) {}

    /// Numbers, enumerators or parts of structures: count of them, each of that many bytes.
    Walk& numbers(std::uint64_t count, std::uint64_t bytes) {
        if (count > 0) at_ = (at_ + bytes - 1) / bytes * bytes + count * bytes;
        return *this;
    }
    Walk& text() { return numbers(length(), 1); }
    /// A sequence of numbers, or of structures made of that many of them.
    Walk& sequence(std::uint32_t max, std::uint64_t numbers_each, std::uint64_t bytes) {
        const std::uint32_t count = last_sequence(max);
        return numbers(count * numbers_each, bytes);
    }
    /// One behind which nothing is looked at. Returns the number of elements that it claims.
    std::uint32_t last_sequence(std::uint32_t max) {
        const std::uint32_t count = length();
        if (count > max) fits_ = false;
        return count;
    }
    bool fits() const { return fits_; }

private:
    static constexpr std::size_t kHeader = 4;

    /// The length of a string or sequence; none when the payload ends before it.
    std::uint32_t length() {
        numbers(1, 4);
        if (at_ > body_.size()) {
            fits_ = false;
            return 0;
        }
        std::uint32_t value = 0;
        for (std::uint64_t i = 0; i < 4; ++i)
            value = value << 8U | body_[at_ - (big_endian_ ? 4 - i : 1 + i)];
        return value;
    }

    Bytes body_;
    bool big_endian_;
    std::uint64_t at_ = 0;
    bool fits_ = true;
};

} // namespace

bool within_bounds(const ExerciseStatus& sample) {
    return sample.faults().size() <= kFaults;
}
bool within_bounds(const ChainState& sample) {
    return sample.nodes().size() <= kNodes && sample.tension().size() <= kNodes &&
           sample.marks().size() <= kMarks;
}
bool within_bounds(const Assessment& sample) {
    return sample.criteria().size() <= kCriteria;
}
bool within_bounds(const Checkpoint& sample) {
    return sample.data().size() <= kCheckpoint;
}
bool within_bounds(const RestoreCommand& sample) {
    return sample.checkpoint().size() <= kCheckpoint;
}
bool within_bounds(const ClassroomStatus& sample) {
    return sample.exercises().size() <= kHosted;
}
bool within_bounds(const ClassroomCommand& sample) {
    return sample.definition().size() <= kDefinition;
}

template <>
bool claims_within_bounds<ExerciseStatus>(Bytes payload) {
    Walk walk(payload);
    walk.numbers(2, 8).numbers(1, 4).numbers(2, 8); // tick, time; state; time scale asked for and achieved
    walk.text().text();                             // exercise, title
    walk.numbers(8, 8);                             // state hash .. samples dropped
    walk.numbers(3, 4);                             // model level, nodes, substeps
    walk.numbers(7, 8);                             // errors of the model, depth, wind, current
    walk.last_sequence(kFaults);
    return walk.fits();
}

template <>
bool claims_within_bounds<ChainState>(Bytes payload) {
    Walk walk(payload);
    walk.numbers(1, 4).numbers(5, 8); // side; tick, time, cable out twice, lead
    // stay; top angle, on bottom, turns, largest tension, stretched, stretch
    walk.numbers(1, 4).numbers(6, 8);
    walk.sequence(kNodes, 3, 4).sequence(kNodes, 1, 4).last_sequence(kMarks);
    return walk.fits();
}

template <>
bool claims_within_bounds<Assessment>(Bytes payload) {
    Walk walk(payload);
    walk.numbers(3, 8).numbers(1, 1); // tick, time, score; finished
    walk.last_sequence(kCriteria);
    return walk.fits();
}

template <>
bool claims_within_bounds<Checkpoint>(Bytes payload) {
    Walk walk(payload);
    walk.numbers(6, 8).numbers(1, 4); // tick, time, hashes, run, orders taken; format
    walk.last_sequence(kCheckpoint);
    return walk.fits();
}

template <>
bool claims_within_bounds<RestoreCommand>(Bytes payload) {
    Walk walk(payload);
    walk.text().numbers(2, 8).text(); // origin; from
    walk.last_sequence(kCheckpoint);
    return walk.fits();
}

template <>
bool claims_within_bounds<ClassroomStatus>(Bytes payload) {
    Walk walk(payload);
    walk.text().numbers(3, 4); // server; threads, most exercises, neighbours
    walk.last_sequence(kHosted);
    return walk.fits();
}

template <>
bool claims_within_bounds<ClassroomCommand>(Bytes payload) {
    Walk walk(payload);
    walk.text().numbers(2, 8); // origin
    walk.numbers(1, 4);        // action
    walk.text().text().text(); // server, id, exercise
    walk.numbers(1, 1);        // wait
    walk.last_sequence(kDefinition);
    return walk.fits();
}

} // namespace windlass::wire
