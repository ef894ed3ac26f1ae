#pragma once
// What may be changed so that a criterion keeps its mark: the space that is searched.

#include "lesson/whatif/search.hpp"

namespace windlass::whatif {

/// A change that has yet to be given its size.
struct Candidate {
    Change change;          ///< kind, lever, value, report and when it was
    std::uint64_t base = 0; ///< tick that its size counts from
    double towards = 0;     ///< more, less: +1 or -1
};

/// Every lever that may be changed.
std::vector<Lever> levers_of(const Trials& trials);

/// Words alone: reports and repeats that would have been right.
std::vector<Candidate> words_that_help(Trials& trials, std::size_t criterion);

/// Moves that were made, and may be made sooner, later, less or more; the last before it was lost first.
std::vector<Candidate> moves_that_were_made(const Trials& trials, std::size_t criterion);

/// Moves that were made and may be left out, which have no size, and moves that were not.
std::vector<Candidate> moves_left_out(const Trials& trials, std::size_t criterion);
std::vector<Candidate> moves_not_made(const Trials& trials, std::size_t criterion);

/// The change at a size in steps. Nothing: the lever does not go so far.
std::optional<Change> of_size(const Trials& trials, const Candidate& candidate, int steps);

/// The change with its lever gone that many steps further, or less far below 0. Nothing: how far it goes is
/// not what is changed, or it goes to a stop of the lever, which a hand finds, or would beyond one.
std::optional<Change> further(const Change& change, int steps);

} // namespace windlass::whatif
