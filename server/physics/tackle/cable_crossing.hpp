#pragma once
// Two cables that lie across each other: links against links, either cable against the other's anchor, and
// anchor against anchor.

#include "server/physics/tackle/ground_tackle.hpp"

namespace windlass::physics {

/// What moves a ground tackle through one step.
struct TackleStep {
    WindlassLevers levers;
    EquipmentFaults causes;
    Vec3 lip = Vec3::Zero(); ///< m, world, at the end of the step
    HullSurface hull;
};

/// Finds and solves the contacts of two cables. Holds memory to work in only; takes none after the
/// constructor.
class CableCrossing {
public:
    /// The two tackles' capacity of links is taken from them.
    CableCrossing(const GroundTackle& a, const GroundTackle& b);

    /// Whether anything of one comes nearer to anything of the other than the given distance (m). Boxes round
    /// runs of links tell apart what lies apart.
    bool near(const GroundTackle& a, const GroundTackle& b, double distance);

    /// One step of dt (s) of both, with the contacts between them. Neither may sleep, or be left to the
    /// catenary, while they are near.
    void step(GroundTackle& a, GroundTackle& b, const EnvironmentDef& environment, double dt,
              const TackleStep& of_a, const TackleStep& of_b);

    const PairContacts& ties() const { return ties_; } ///< of the last step
    /// Pairs of links looked at since it was made, each time.
    std::int64_t visits() const { return visits_; }

private:
    struct Bounds {
        Vec3 low, high;
    };
    static void build(const ChainState& chain, double room, std::vector<Bounds>& boxes);
    /// Calls pair(i, j) for every two links whose boxes' runs meet, in a fixed order, until it says true.
    template <class Pair>
    bool any_pair(const ChainState& a, const ChainState& b, double room, const Pair& pair);
    void find(const GroundTackle& a, const GroundTackle& b, const EnvironmentDef& environment, double dt);

    std::vector<Bounds> boxes_a_, boxes_b_; ///< round runs of links
    PairContacts ties_;
    std::int64_t visits_ = 0;
};

} // namespace windlass::physics
