#pragma once
// The bridge's anchor watch: a circle that the ship's outline is to stay in, and dragging as an officer sees
// it, by position alone. What the anchor truly does: riding.hpp.

#include "server/exercise/faults/faults.hpp"
#include "server/physics/ship/ship.hpp"
#include "server/physics/ship/ship_def.hpp"

namespace windlass::exercise {

/// m, from a point to the corner of the ship's outline that is farthest from it: length by beam.
double farthest_corner(const physics::ShipDef& def, const physics::ShipState& ship, double x, double y);

/// The circle, and whether she is outside it. She is back inside when she is so by 2 % of the radius, so that
/// a ship on the line is called once. She drags, by position, when she has been outside for a minute and is
/// farther out than GPS may be wrong; called once while she is outside.
class AnchorWatch {
public:
    void order(const WatchCircleOrder& order, const EventLog& log);
    /// dt: s since the last look.
    void look(const physics::ShipDef& def, const physics::ShipState& ship, double dt, const EventLog& log);

    const WatchCircleOrder& circle() const { return circle_; }
    bool outside() const { return outside_; }

    template <class Visitor, physics::StateOf<AnchorWatch> Self>
    friend void visit_state(Visitor& v, Self& self);

private:
    WatchCircleOrder circle_;
    bool outside_ = false;
    double outside_for_ = 0; ///< s
    bool drags_ = false;     ///< called as dragging
};

} // namespace windlass::exercise
