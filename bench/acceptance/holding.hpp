#pragma once
// What anchor and cable hold by soil, scope and uplift: closed form against the whole simulation.

#include <iosfwd>

namespace windlass::lab {

/// Writes both tables in Markdown: every soil at three scopes, and sand as the cable leads up. Some 25 runs
/// of ten minutes of exercise time.
void write_holding(std::ostream& out);

} // namespace windlass::lab
