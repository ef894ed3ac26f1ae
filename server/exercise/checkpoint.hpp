#pragma once
// An exercise as bytes: its definition and everything that changes, to go on from there bit for bit.
//
// Layout, format 1, little-endian: "WLCP", u32 format, every field of the definition (config_fields.hpp),
// every field of the state in the order of Exercise::visit_state(), u64 hash of that state. Doubles and
// integers take 8 bytes, texts stand behind their length. The lists have no names in the bytes: a change of
// any list is another format.

#include "server/exercise/exercise.hpp"

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace windlass::exercise {

inline constexpr std::uint32_t kCheckpointFormat = 1;

/// Bytes that are no checkpoint, of another format, or of a server whose state has other fields.
struct CheckpointError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

std::vector<std::uint8_t> write_checkpoint(Exercise& exercise);

/// The exercise as it was. Throws CheckpointError.
Exercise read_checkpoint(const std::vector<std::uint8_t>& bytes);

/// One field in which two states differ, and what it is in each.
struct StateDifference {
    std::string field; ///< e.g. "port.tackle.chain.position_x[17]"
    std::string first, second;
};

/// The fields in which two exercises of one definition differ, in the order of the state; at most so many.
std::vector<StateDifference> differences(Exercise& first, Exercise& second, std::size_t most = 10);

} // namespace windlass::exercise
