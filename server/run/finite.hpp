#pragma once

#include "server/exercise/snapshot.hpp"

namespace windlass::server {

/// Whether every number that would be published is finite. The last gate: NaN never goes out.
bool is_finite(const exercise::Snapshot& snapshot);

} // namespace windlass::server
