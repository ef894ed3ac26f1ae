#include "lesson/whatif/attempt.hpp"

namespace windlass::whatif {

void put_down(Attempt& attempt, const run::Session& session) {
    if (const run::CheckpointView* checkpoint = session.checkpoint())
        attempt.checkpoints.push_back(*checkpoint);
    attempt.orders.insert(attempt.orders.end(), session.orders().begin(), session.orders().end());
    attempt.last_tick = session.now_tick();
}

} // namespace windlass::whatif
