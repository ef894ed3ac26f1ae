#include "server/physics/anchor_shape.hpp"

namespace windlass::physics {

namespace {

/// Stockless anchor as four boxes: shank, crown, two flukes; from the crown pin. Proportions from common Hall
/// drawings; tuned.
std::vector<AnchorPart> stockless(const AnchorDef& def) {
    const double shank = def.shank_length, fluke = def.fluke_length, width = def.crown_width;
    return {{{0.5 * shank, 0, 0}, {0.5 * shank, 0.07 * width, 0.09 * width}, 0.35},
            {{0, 0, 0}, {0.12 * shank, 0.5 * width, 0.14 * width}, 0.30},
            {{0.5 * fluke, 0.30 * width, 0}, {0.5 * fluke, 0.13 * width, 0.05 * width}, 0.175},
            {{0.5 * fluke, -0.30 * width, 0}, {0.5 * fluke, 0.13 * width, 0.05 * width}, 0.175}};
}

} // namespace

AnchorShape anchor_shape(const AnchorDef& def) {
    AnchorShape shape{.parts = stockless(def)};
    Vec3 centre = Vec3::Zero();
    for (const AnchorPart& part : shape.parts)
        centre += part.share * part.centre;
    for (AnchorPart& part : shape.parts) {
        part.centre -= centre;
        const Vec3 square = part.half.cwiseAbs2() / 3 + part.centre.cwiseAbs2();
        shape.inertia_over_mass +=
            part.share * Vec3(square.y() + square.z(), square.x() + square.z(), square.x() + square.y());
    }
    shape.crown = -centre;
    shape.shackle = Vec3(def.shank_length, 0, 0) - centre;
    return shape;
}

} // namespace windlass::physics
