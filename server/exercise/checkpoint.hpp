#pragma once
// An exercise as bytes: its definition and everything that changes, to go on from there bit for bit.
//
// Layout, little-endian: "WLCP", u32 kCheckpointFormat, every field of the definition (def_fields.hpp and the
// whole of its weather), u64 hash of that definition, every field of the state in the order of
// Exercise::visit_state(), u64 hash of that state, and what is kept beside it (of an exercise with a lesson,
// its assessment). Doubles and integers take 8 bytes, texts and lists stand behind their length. The fields
// have no names in the bytes: a change of any list of fields is another format.

#include "server/exercise/exercise.hpp"

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace windlass::exercise {

inline constexpr std::uint32_t kCheckpointFormat = 42;
inline constexpr std::size_t kMaxText = 65536; ///< bytes of a text of a definition: its landmarks, its lesson

/// Bytes that are no checkpoint, of another format, or of a server whose state has other fields.
struct CheckpointError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Hash of every value that a definition may have in a file: another one is another exercise.
std::uint64_t definition_hash(ExerciseDef def);

/// What is kept with an exercise and is no part of its state: its assessment.
class KeptBeside {
public:
    virtual ~KeptBeside() = default;
    /// Makes ready to be brought back, beside an exercise of that definition.
    virtual void begin(const ExerciseDef& def) = 0;
    virtual void visit(physics::ConstStateVisitor& v) const = 0;
    virtual void visit(physics::StateVisitor& v) = 0;
};

std::vector<std::uint8_t> write_checkpoint(const Exercise& exercise, const KeptBeside* beside = nullptr);

/// The same exercise at the same moment, with another text of its lesson. Throws CheckpointError where these
/// are no bytes of write_checkpoint()'s.
std::vector<std::uint8_t> with_lesson(const std::vector<std::uint8_t>& checkpoint,
                                      const std::function<std::string(const std::string&)>& change);

/// The exercise as it was. check sees the definition before anything is made of it, and throws what is wrong
/// with it: for bytes from outside, which may say anything. beside takes what was kept with it; without it,
/// bytes that have such are refused. Throws CheckpointError.
Exercise read_checkpoint(const std::vector<std::uint8_t>& bytes,
                         const std::function<void(const ExerciseDef&)>& check = {},
                         KeptBeside* beside = nullptr);

/// One field in which two states differ, and what it is in each.
struct StateDifference {
    std::string field; ///< e.g. "port.tackle.chain.position_x[17]"
    std::string first, second;
};

/// The fields in which two exercises of one definition differ, in the order of the state; at most so many.
std::vector<StateDifference> differences(const Exercise& first, const Exercise& second, std::size_t max = 10);

} // namespace windlass::exercise
