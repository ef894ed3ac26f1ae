#include "server/exercise/weather/tide.hpp"

#include "server/physics/sea/environment.hpp"

#include <algorithm>

namespace windlass::exercise {

namespace {

Tide of_row(const TideRow& row) {
    return {row.height, row.current_speed * physics::compass(row.current_towards)};
}

} // namespace

Tide tide_at(std::span<const TideRow> rows, double time) {
    if (rows.empty()) return {};
    const auto next = std::ranges::find_if(rows, [=](const TideRow& row) { return row.time > time; });
    if (next == rows.begin()) return of_row(rows.front());
    if (next == rows.end()) return of_row(rows.back());
    const TideRow& last = *(next - 1);
    const double share = (time - last.time) / (next->time - last.time);
    const Tide from = of_row(last), to = of_row(*next);
    return {from.height + share * (to.height - from.height), from.stream + share * (to.stream - from.stream)};
}

template <class Visitor, physics::StateOf<TideRow> State>
void visit_state(Visitor& v, State& row) {
    auto& [time, height, current_speed, current_towards] = row;
    WINDLASS_STATE(v, time, height, current_speed, current_towards);
}
WINDLASS_STATE_LISTED(TideRow);

} // namespace windlass::exercise
