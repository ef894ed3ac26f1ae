#include "server/physics/anchor/bight.hpp"

#include "server/physics/base/state_limits.hpp"

#include <algorithm>
#include <cassert>

namespace windlass::physics {

void update_bight(const BightPull& pull, BightState& state) {
    assert(pull.dt > 0 && "a step takes time");
    constexpr double kSettles = 5;    // s; links of a heap that is drawn out bear by fits and starts; tuned
    constexpr double kTouches = 0.05; // of the pull; tuned
    constexpr double kShows = 2;      // m that the anchor must go for it to show; tuned
    const double now = std::min(1.0, pull.dt / kSettles);
    const bool drawn = pull.touching > pull.taut;
    state.body += now * ((drawn ? pull.body : Vec3::Zero()) - state.body);
    state.shackle += now * (pull.shackle - state.shackle);
    const double body = state.body.norm(), all = body + state.shackle.norm();
    if (all < pull.slides || all == 0) return;
    const bool crown_first = (state.body + state.shackle).dot(pull.shank) < 0;
    const double share = crown_first && body > kTouches * all ? 1 : body / all;
    state.share += std::min(1.0, pull.moved / kShows) * (share - state.share);
}

template <class Visitor, StateOf<BightState> State>
void visit_state(Visitor& v, State& state) {
    auto& [body, shackle, share] = state;
    WINDLASS_STATE(v, body, shackle, share);
    WINDLASS_WITHIN(v, -kStrongest, kStrongest, body, shackle);
    WINDLASS_WITHIN(v, 0, 1, share);
}
WINDLASS_STATE_LISTED(BightState);

} // namespace windlass::physics
