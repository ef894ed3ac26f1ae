#pragma once
// No more model than the scene needs: how finely a cable is cut, and how wrong the model is at most.
//
// The measured chart behind the figures stands in docs/physics.md, "Model no more than the scene needs".

#include "server/physics/base/state_visitor.hpp"
#include "server/physics/chain/chain_def.hpp"
#include "server/physics/sea/environment.hpp"

namespace windlass::physics {

/// An error of the model: estimated, or allowed. Negative: nobody can say.
struct ModelError {
    double load = 0;  ///< of the windlass load, as a fraction of it (root mean square)
    double shape = 0; ///< m, distance of the cable's nodes from where they should be (root mean square)
};
template <class Visitor, StateOf<ModelError> State>
void visit_state(Visitor& v, State& error);

/// Of a scene in which what two computations differ by grows until they have nothing in common.
constexpr ModelError kNotEstimated{-1, -1};

/// How a cable is computed.
enum class ModelLevel {
    dynamic,            ///< every node
    dynamic_with_sleep, ///< chain that lies still on the bottom is left alone
    catenary            ///< the hanging part is in equilibrium
};

/// What cutting a cable into links of the given length (m) costs. hanging: m, from the lip to the seabed.
ModelError spacing_error(double spacing, double hanging);

/// Errors that have nothing to do with each other: the root of the sum of their squares.
ModelError together(const ModelError& a, const ModelError& b);

/// The larger one of each; not estimated where either is not.
ModelError worse(const ModelError& a, const ModelError& b);

/// What the links may take of a budget; the rest is for what is saved while it runs: 0.8 and 0.5 make 0.94.
ModelError spacing_share(const ModelError& budget);
ModelError saving_share(const ModelError& budget);

/// The longest links that stay within the budget, m, rounded down to whole centimetres. cable_out: m at the
/// start; the anchor must hang below the lip.
double spacing_within(const ModelError& budget, double hanging, const ChainDef& chain, double cable_out);

} // namespace windlass::physics
