#pragma once
// Contacts that press two moving things apart: chain on chain, chain on an anchor, anchor on anchor.
// Each is a spring, a damper and Coulomb friction, implicit in what both would do if no link pulled (p*).
// What it gives to one side it takes from the other.

#include "server/physics/chain/chain.hpp"
#include "server/physics/chain/chain_forces.hpp"
#include "server/physics/chain/step_time.hpp"
#include "server/physics/contact/anchor_point.hpp"

#include <array>
#include <span>

namespace windlass::physics {

/// What either side of a contact is.
enum class Body { chain, anchor };

/// Two points that are pressed apart, each of a cable (link a, at the share at_a of its length) or of an
/// anchor.
struct PairContact {
    int link_a = 0, link_b = 0;
    double at_a = 0, at_b = 0;    ///< 0..1; 0 is the link's lower node, 1 its upper one
    Vec3 normal = Vec3::UnitZ();  ///< unit vector from b to a
    double penetration = 0;       ///< m at the start of the step; negative: the gap
    double stiffness = 0;         ///< N/m
    double damping = 0;           ///< N s/m
    double friction = 0;          ///< Coulomb's coefficient
    int cable_a = 0, cable_b = 0; ///< of those that the step is taken with
    Body body_a = Body::chain;    ///< what a is; an anchor: that of cable_a, at on_a; b is one, too
    Body body_b = Body::chain;    ///< what b is; an anchor: that of cable_b, at on_b
    AnchorPoint on_a{}, on_b{};
};

/// An anchor as contacts press it in a step.
struct AnchorEnd {
    Vector7 before = Vector7::Zero();   ///< its motion before the step, what the ground did to it included
    Vector7 motion = Vector7::Zero();   ///< after it, if neither chain nor contacts pushed
    Matrix7 yielding = Matrix7::Zero(); ///< inverse mass, soil's resistance included; zero: it is held
    Vec3 shackle = Vec3::Zero();        ///< m, arm of the cable's end, world
};

/// A cable in a step under way: how it stood at the start, and W and p*, which contacts change.
struct CableInStep {
    const ChainState* state = nullptr;
    SymmetricField* inverse_mass = nullptr; ///< of nodes that sleep it says nothing: they yield nothing
    Field* predicted = nullptr;
    const AnchorEnd* anchor = nullptr; ///< may be null where no contact is with it
};

/// The same cable after the step, for the balance of energy.
struct CableAfter {
    const ChainState* state = nullptr;
    Vector7 anchor = Vector7::Zero(); ///< its motion, before its flukes came to a stop
};

/// The pair contacts of one step. Fixed capacity, no memory taken after the constructor.
class PairContacts {
public:
    explicit PairContacts(int capacity);

    void clear();
    bool empty() const { return pairs_.empty(); }
    /// False where there is no place for it.
    bool add(const PairContact& contact);
    bool full() const { return pairs_.size() == pairs_.capacity(); }
    const std::vector<PairContact>& all() const { return pairs_; }

    /// Makes the contacts ready for a step of these cables; they must stay where they are until it is over.
    void enter(std::span<const CableInStep> cables, const StepTime& time);
    /// Puts their impulses, found by Gauss-Seidel from those found before, into p* as it is now.
    void press();
    /// Whether the sweeps over them ended because no impulse changed any more.
    bool at_rest() const { return at_rest_; }

    /// What contacts gave the anchor of a cable, as a change of its motion. p* of its shackle has it already.
    const Vector7& pushed(int cable) const { return cables_[cable].pushed; }
    /// N s, the sum of what presses the contacts apart in the step.
    double pressing() const;
    /// J taken from cables and anchors: friction, impact, and what springs store.
    double work(std::span<const CableAfter> cables) const;

private:
    static constexpr int kCables = 2;
    struct Cable {
        CableInStep in;
        Vector7 pushed = Vector7::Zero(); ///< change of the anchor's motion by contacts on its body
        Vector7 pulled = Vector7::Zero(); ///< ... at its shackle, by contacts of the lowest link
    };
    struct Tie {                                ///< a pair contact as coefficients of the step
        std::array<int, 4> node;                ///< of cable_a, cable_a, cable_b, cable_b
        std::array<double, 4> share;            ///< none of a node that sleeps
        std::array<SymmetricMatrix, 4> carries; ///< m, where an impulse (N s) takes a node in the step
        Vec3 from = Vec3::Zero();               ///< m, shares of where the nodes are before the step, summed
        int ends = 0;                           ///< nodes in use: none of anchors
        double spring = 0;                      ///< m/s, that the spring would part them with
        double softness = 0, give = 0, friction_give = 0; ///< m/s per N s
        double impulse = 0;                               ///< N s
        Vec3 rubbing = Vec3::Zero();                      ///< N s, across the normal
        Vec3 apart_before = Vec3::Zero();                 ///< m/s, of the two points before the step
    };

    Cable& cable_of(const PairContact& pair, int end) {
        return cables_[end < 2 ? pair.cable_a : pair.cable_b];
    }
    Vec3 apart(std::size_t k);
    void give(std::size_t k, const Vec3& impulse);
    double press(std::size_t k);

    StepTime time_;
    std::array<Cable, kCables> cables_;
    std::vector<PairContact> pairs_;
    std::vector<Tie> ties_; // small: a heap has hundreds, and each sweep goes through all of them
    std::vector<std::array<AnchorPush, 2>> pushes_; // what one makes of the motion of the anchor that a, b is
    double per_dt_ = 0;                             // 1/s
    bool at_rest_ = true;
};

} // namespace windlass::physics
