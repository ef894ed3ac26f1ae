#pragma once
// The hawse pipe of one side, as shank and chain meet it: a mouth that opens outwards, a straight bore behind
// it, and a rounded lip that the chain hangs over.

#include "server/physics/base/vec3.hpp"

namespace windlass::physics {

/// A pipe in the ship's frame (hull_surface.hpp), m.
struct HawsePipe {
    Vec3 lip = Vec3::Zero();   ///< where chain leaves it that hangs plumb
    Vec3 bore = Vec3::UnitZ(); ///< unit vector inboard and up along the bore
    Vec3 mouth = Vec3::Zero(); ///< middle of the mouth: the bore's axis abreast of the lip
    double bend = 0;           ///< radius round which chain turns from plumb into the bore
    double room = 0;           ///< that the middle of the shank may be off the bore's axis
    double funnel = 0;         ///< depth over which the mouth opens, by as much at its edge
    double seat = 0;           ///< of the shackle's pin from the mouth along the bore, anchor home

    /// Where chain is that lies so many metres up the pipe from the lip, m.
    Vec3 chain_at(double inboard) const;
    /// m, of cable from lip to shackle when the anchor is home: less than zero.
    double cable_at_home() const;
    /// rad, by which chain is bent in all from the deck, where it comes level from the gypsy, to a lead
    /// outboard (unit vector, ship's frame): into the bore, and at the lip out of it. However steep the bore,
    /// a quarter turn where the lead is plumb.
    double bent(const Vec3& lead) const;
};

} // namespace windlass::physics
