#pragma once
// A link that lies round an edge: it goes straight to the edge, round it at half its own width, and straight
// on, and so pulls at its two nodes in two directions. As a straight rod on the edge it would be a lever, and
// what it carries over the edge would depend on how it happens to lie.

#include "server/physics/chain/chain.hpp"
#include "server/physics/chain/chain_forces.hpp"
#include "server/physics/chain/step_time.hpp"

#include <array>

namespace windlass::physics {

/// An edge that a link may lie round.
struct Edge {
    int link = 0;
    Vec3 foot = Vec3::Zero();             ///< m, a point of it, world, at the start of the step
    Vec3 along = Vec3::UnitX();           ///< unit vector
    Vec3 out = Vec3::UnitZ();             ///< unit vector out of the body, halfway between its two faces
    double radius = 0;                    ///< m, of the bend
    double friction = 0;                  ///< Coulomb's coefficient
    Vec3 surface_velocity = Vec3::Zero(); ///< m/s
};

/// A link's way round an edge, or straight past it.
struct LinkWay {
    double length = 0; ///< m
    double turn = 0;   ///< rad, by which it bends
    Vec3 at_lower = Vec3::UnitZ(),
         at_upper = Vec3::UnitZ(); ///< unit vectors along it from its lower to its upper node, at either
    double straight_lower = 0, straight_upper = 0; ///< m, between either node and the edge
    double cosine_lower = 1, cosine_upper = 1;     ///< between `out` and where it meets and leaves the edge
};

/// The shortest way from the lower to the upper node (m, world) that passes the edge on its outer hand.
/// Across the edge it is a belt round a drum, along it a straight line on what is unrolled. It turns by less
/// than half a circle.
LinkWay way_round(const Edge& edge, const Vec3& lower, const Vec3& upper);

/// The links of one step that lie round edges, or are about to. Fixed capacity.
class LinkWraps {
public:
    explicit LinkWraps(int capacity) { wraps_.reserve(capacity); }

    void clear() { wraps_.clear(); }
    bool empty() const { return wraps_.empty(); }
    int size() const { return static_cast<int>(wraps_.size()); }
    /// False where there is no place for it.
    bool add(const Edge& edge);

    /// Enters friction on the edges into W and p* of a step: between its ends a link's pull changes by the
    /// capstan equation, F e^(mu turn), at most.
    void enter(const ChainState& state, const StepTime& time, SymmetricField& inverse_mass, Field& predicted);

    struct Wrap {
        Edge edge;
        LinkWay before;     ///< at the start of the step
        Vec3 pull_on_lower; ///< what a pull of one newton does to its lower node, N; along the way, and less
        Vec3 pull_on_upper; ///< than on the upper one, taken the other way, by friction
        std::array<double, 2>
            rubbing{};                ///< N s/m, the part of friction that is entered as such, at either node
        std::array<Vec3, 2> velocity; ///< m/s, of its nodes before the step
        double pull = 0;              ///< N, mean of the step
    };
    const std::vector<Wrap>& all() const { return wraps_; }
    /// The one of a link, if it has one.
    const Wrap* of(int link) const;
    /// The link's way if its nodes are at these places (m) at the end of the step.
    LinkWay way_after(const Wrap& wrap, const Vec3& lower, const Vec3& upper) const;

    /// Takes the pulls (N) that the step came to. straight: they acted straight from node to node.
    void load(const std::vector<double>& pull, const Field* straight);

    /// What the edge did to the link in the step, N s; and J taken from the chain.
    struct Reaction {
        Vec3 impulse;
        double work;
    };
    Reaction reaction(const Wrap& wrap, const ChainState& state) const;

private:
    void enter(int end, double stiffness, const Wrap& wrap, const ChainState& state,
               SymmetricField& inverse_mass, Field& predicted) const;

    std::vector<Wrap> wraps_;
    StepTime time_;
};

} // namespace windlass::physics
