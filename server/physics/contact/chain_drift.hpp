#pragma once
// How far the nodes of a chain have gone since they were last looked at closely: as long as that is less than
// what lay between them, nothing has touched, and nothing need be looked for.

#include "server/physics/chain/chain.hpp"

namespace windlass::physics {

/// Remembers where nodes were. It decides what is looked at, never what is found: it is no part of the state.
class ChainDrift {
public:
    /// capacity: most links.
    explicit ChainDrift(int capacity) : marked_(capacity + 1) {}

    /// Remembers the chain as it is now.
    void mark(const ChainState& chain);

    /// m, no node has gone further, and will have in a step of dt (s) at its present speed. What all of them
    /// have gone alike does not count. Infinite for a chain that has changed its nodes.
    double farthest(const ChainState& chain, double dt) const;

private:
    Field marked_; ///< m
    int links_ = -1, asleep_ = 0;
};

} // namespace windlass::physics
