#pragma once
// How unsteady the windlass load has been of late: what an estimate of its error goes by beside the links.
//
// Two computations of one anchoring do not differ by a fixed share of the load. A bight that snaps straight,
// a link that lands, a turn of the ship comes a moment earlier or later, a little higher or lower; so what
// they differ by is in proportion to how much the load changes within seconds (docs/physics.md has the
// measured coverage).

#include "server/physics/base/state_visitor.hpp"
#include "server/physics/lod/model_policy.hpp"

namespace windlass::physics {

/// What is remembered of the load; a plain value.
struct RecentLoad {
    double mean = -1;  ///< N, of about a second; negative: nothing seen yet
    double slow = 0;   ///< N, of about ten
    double square = 0; ///< N2, of the one's distance from the other, mean of about ten seconds
    double shaken = 0; ///< largest unsteadiness of late, forgotten within a minute or two
    double poor = 0;   ///< share of the steps of about ten seconds that were not second order
};
template <class Visitor, StateOf<RecentLoad> State>
void visit_state(Visitor& v, State& recent);

/// After a step of dt (s) at the end of which the load is as given (N). poor: it was first order, or left
/// something out.
void follow_load(double load, bool poor, double dt, RecentLoad& recent);

/// How far the load of about a second is from that of about ten, as a fraction of it: 0..1.
double unsteadiness(const RecentLoad& recent);

/// What it makes likely of the model's error, beside that of the links.
ModelError unsteady_error(const RecentLoad& recent);

} // namespace windlass::physics
