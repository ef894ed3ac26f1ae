#include "server/exercise/watch_circle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace windlass::exercise {

namespace {
constexpr double kInsideAgain = 0.98; ///< of the radius
}

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

void AnchorWatch::order(const WatchCircleOrder& order, const FaultBook::Log& log) {
    circle_ = order;
    outside_ = false;
    if (order.kept)
        log(Severity::info, "watch.kept", -1, order.radius, "anchor watch is kept on the bridge");
    else
        log(Severity::info, "watch.ended", -1, 0, "anchor watch has ended");
}

void AnchorWatch::look(const physics::ShipDef& def, const physics::ShipState& ship,
                       const FaultBook::Log& log) {
    if (!circle_.kept) return;
    const double out = farthest_corner(def, ship, circle_.x, circle_.y);
    if (outside_) {
        outside_ = out > kInsideAgain * circle_.radius;
    } else if (out > circle_.radius) {
        outside_ = true;
        std::array<char, 80> text{};
        std::snprintf(text.data(), text.size(), "ship has left the anchor watch circle of %.0f m",
                      circle_.radius);
        log(Severity::alarm, "watch.circle", -1, out, text.data());
    }
}

template <class Visitor, physics::StateOf<AnchorWatch> Self>
void visit_state(Visitor& v, Self& self) {
    auto& [kept, x, y, radius] = self.circle_;
    WINDLASS_STATE(v, kept, x, y, radius, self.outside_);
}
WINDLASS_STATE_LISTED(AnchorWatch);

} // namespace windlass::exercise
