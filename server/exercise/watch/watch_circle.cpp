#include "server/exercise/watch/watch_circle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace windlass::exercise {

namespace {
constexpr double kInsideAgain = 0.98; ///< of the radius
constexpr double kSure = 60;          ///< s outside
constexpr double kFix = 13;           ///< m, by which a fix may be wrong: GPS, 95 % (IMO MSC.112(73))

std::string metres(const char* format, double value) {
    std::array<char, 80> text{};
    std::snprintf(text.data(), text.size(), format, value);
    return text.data();
}
} // namespace

double farthest_corner(const physics::ShipDef& def, const physics::ShipState& ship, double x, double y) {
    const physics::Vec3 from(ship.x - x, ship.y - y, 0);
    double farthest = 0;
    for (const double ahead : {-0.5, 0.5})
        for (const double abeam : {-0.5, 0.5})
            farthest = std::max(farthest, (from + ahead * def.length_overall * physics::forward(ship) +
                                           abeam * def.beam * physics::starboard(ship))
                                              .norm());
    return farthest;
}

void AnchorWatch::order(const WatchCircleOrder& order, const EventLog& log) {
    circle_ = order;
    outside_ = drags_ = false;
    outside_for_ = 0;
    if (order.kept)
        log("watch.kept", -1, order.radius);
    else
        log("watch.ended", -1, 0);
}

void AnchorWatch::look(const physics::ShipDef& def, const physics::ShipState& ship, double dt,
                       const EventLog& log) {
    if (!circle_.kept) return;
    const double out = farthest_corner(def, ship, circle_.x, circle_.y);
    const bool was = outside_;
    outside_ = out > (was ? kInsideAgain : 1) * circle_.radius;
    if (!outside_) drags_ = false;
    outside_for_ = outside_ ? outside_for_ + dt : 0;
    if (outside_ && !was)
        log("watch.circle", -1, out,
            metres("ship has left the anchor watch circle of %.0f m", circle_.radius));
    if (!drags_ && outside_for_ >= kSure && out > circle_.radius + kFix) {
        drags_ = true;
        log("watch.dragging", -1, out,
            metres("by her position the ship drags: %.0f m from the anchor's place", out));
    }
}

template <class Visitor, physics::StateOf<AnchorWatch> Self>
void visit_state(Visitor& v, Self& self) {
    auto& [kept, x, y, radius] = self.circle_;
    WINDLASS_STATE(v, kept, x, y, radius, self.outside_, self.outside_for_, self.drags_);
}
WINDLASS_STATE_LISTED(AnchorWatch);

} // namespace windlass::exercise
