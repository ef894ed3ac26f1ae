#pragma once
// Chain against itself, and against another chain: links as rods with round ends, half a link's width thick.

#include "server/physics/contact.hpp"

namespace windlass::physics {

/// Spring and damper of link on link.
struct LinkTouch {
    double stiffness = 0; ///< N/m
    double damping = 0;   ///< N s/m
    double friction = 0;
};
LinkTouch link_touch(const ChainDef& def);

/// Finds links of a chain that lie on each other. Boxes around runs of links, halved again and again, tell
/// apart at once what lies apart; so chain that is laid out costs next to nothing. Holds memory to work in
/// only.
class SelfContacts {
public:
    /// capacity: most links.
    explicit SelfContacts(int capacity);

    /// Adds to set the pairs of links that touch or are about to in a step of dt (s). Links nearer along the
    /// chain than a fold of the least radius needs do not count: there the bend limit holds.
    void find(const ChainDef& def, const ChainState& chain, double dt, ContactSet& set);

private:
    struct Box {
        Vec3 low, high;
    };
    struct Pair {
        int level, first, second;
    };
    bool leads_on() const;
    void build(const ChainState& chain, double dt);
    void compare(int first, int second);

    // Of the step under way:
    const ChainDef* def_ = nullptr;
    const ChainState* chain_ = nullptr;
    ContactSet* set_ = nullptr;
    double dt_ = 0;
    int apart_ = 2; ///< links between which there may be contact are at least so many apart
    std::vector<std::vector<Box>> levels_; ///< of boxes, from single runs up
    std::vector<Pair> waiting_;
};

} // namespace windlass::physics
