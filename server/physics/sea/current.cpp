#include "server/physics/sea/current.hpp"

#include <algorithm>

namespace windlass::physics {

namespace {

Vec3 of_layer(const EnvironmentDef& environment, const CurrentLayer& layer) {
    return compass(environment.current_towards + layer.turn) * (environment.current_speed * layer.share);
}

} // namespace

Vec3 current_at(const EnvironmentDef& environment, double z) {
    const std::vector<CurrentLayer>& profile = environment.current_profile;
    if (profile.empty()) return of_layer(environment, {});
    const double depth = -z;
    const auto below = std::find_if(profile.begin(), profile.end(),
                                    [=](const CurrentLayer& layer) { return layer.depth > depth; });
    if (below == profile.begin()) return of_layer(environment, profile.front());
    if (below == profile.end()) return of_layer(environment, profile.back());
    const CurrentLayer &a = *(below - 1), &b = *below;
    const double share = (depth - a.depth) / (b.depth - a.depth);
    const Vec3 above = of_layer(environment, a);
    return above + share * (of_layer(environment, b) - above);
}

Vec3 mean_current(const EnvironmentDef& environment, double draught) {
    if (environment.current_profile.empty()) return current_at(environment, 0);
    constexpr int kSlices = 16;
    Vec3 sum = Vec3::Zero();
    for (int k = 0; k < kSlices; ++k)
        sum += current_at(environment, -draught * (k + 0.5) / kSlices);
    return sum / kSlices;
}

} // namespace windlass::physics
