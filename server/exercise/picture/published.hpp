#pragma once
// What is published is finite: the last gate, NaN never goes out.

#include "server/exercise/picture/snapshot.hpp"

namespace windlass::exercise {

/// Whether every number of the picture is finite.
bool is_finite(const Snapshot& snapshot);

} // namespace windlass::exercise
