#include "server/physics/sea/current.hpp"

#include <algorithm>

namespace windlass::physics {

Vec3 current_at(double speed, double towards, std::span<const CurrentLayer> profile, double over_surface) {
    const auto of_layer = [=](const CurrentLayer& layer) -> Vec3 {
        return compass(towards + layer.turn) * (speed * layer.share);
    };
    if (profile.empty()) return of_layer({});
    const double depth = -over_surface;
    const auto below = std::find_if(profile.begin(), profile.end(),
                                    [=](const CurrentLayer& layer) { return layer.depth > depth; });
    if (below == profile.begin()) return of_layer(profile.front());
    if (below == profile.end()) return of_layer(profile.back());
    const CurrentLayer &a = *(below - 1), &b = *below;
    const double share = (depth - a.depth) / (b.depth - a.depth);
    const Vec3 above = of_layer(a);
    return above + share * (of_layer(b) - above);
}

Vec3 current_at(const EnvironmentDef& environment, double z) {
    return current_at(environment.current_speed, environment.current_towards, environment.current_profile,
                      z - environment.level);
}

Vec3 mean_current(const EnvironmentDef& environment, double draught) {
    const auto at = [&](double over_surface) {
        return current_at(environment.current_speed, environment.current_towards, environment.current_profile,
                          over_surface);
    };
    if (environment.current_profile.empty()) return at(0);
    constexpr int kSlices = 16;
    Vec3 sum = Vec3::Zero();
    for (int k = 0; k < kSlices; ++k)
        sum += at(-draught * (k + 0.5) / kSlices);
    return sum / kSlices;
}

} // namespace windlass::physics
