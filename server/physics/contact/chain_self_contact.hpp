#pragma once
// Chain against itself, and against another chain: links as rods with round ends, half a link's width thick.

#include "server/physics/contact/chain_drift.hpp"
#include "server/physics/contact/contact.hpp"

namespace windlass::physics {

/// Spring and damper of link on link.
struct LinkTouch {
    double stiffness = 0; ///< N/m
    double damping = 0;   ///< N s/m
    double friction = 0;
};
LinkTouch link_touch(const ChainDef& def);

/// Finds links of a chain that lie on each other, and folds sharper than its least bend. Boxes around runs of
/// links, halved again and again, tell apart what lies apart; the pairs that are near are kept, and looked at
/// alone until some node has gone so far that there may be others. So chain that is laid out costs next to
/// nothing. What is found does not depend on when it was looked for: this holds memory to work in only.
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
    struct Couple { ///< of links
        int lower, upper;
    };
    void look();
    double gap_along_chord() const;
    void build(double room);
    void gather(double room);
    void compare(int first, int second, double reach);
    void touch(int lower, int upper, const LinkTouch& touch);

    // Of the step under way:
    const ChainDef* def_ = nullptr;
    const ChainState* chain_ = nullptr;
    ContactSet* set_ = nullptr;
    double dt_ = 0;

    ChainDrift drift_;
    double room_ = 0;      ///< m, that every node may go before others than near_ may touch
    double bend_room_ = 0; ///< m, that every node may go before a fold may be too sharp
    std::vector<Couple> near_;
    int missed_ = 0; ///< pairs for which there was no place in near_
    int apart_ = 2;  ///< links between which there may be contact are at least so many apart
    std::vector<std::vector<Box>> levels_; ///< of boxes, from single runs up
    std::vector<Pair> waiting_;
};

} // namespace windlass::physics
