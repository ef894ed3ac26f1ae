#include "server/physics/anchor/anchor_shape.hpp"

namespace windlass::physics {

namespace {

// Proportions from common drawings, tuned. From the crown pin.

/// Shank, crown, two flukes. The crown is one piece with the flukes and turns on their pin: a shank that
/// stands on it falls over as on a roller about the pin, and does not stand on the crown's flat foot.
std::vector<AnchorPart> stockless(const AnchorDef& def) {
    const double shank = def.shank_length, fluke = def.fluke_length, width = def.crown_width;
    return {{{0.5 * shank, 0, 0}, {0.5 * shank, 0.07 * width, 0.09 * width}, 0.35},
            {{0, 0, 0}, {0.12 * shank, 0.5 * width, 0.14 * width}, 0.30, false, 0.14 * width},
            {{0.5 * fluke, 0.30 * width, 0}, {0.5 * fluke, 0.13 * width, 0.05 * width}, 0.175, true},
            {{0.5 * fluke, -0.30 * width, 0}, {0.5 * fluke, 0.13 * width, 0.05 * width}, 0.175, true}};
}

/// Shank, crown, two arms with their palms, and the stock across them, as long as the shank. One end of a
/// stock is bent, so that it can be stowed along the shank: here the whole of it stands off by as much, and
/// it does not balance on either end.
std::vector<AnchorPart> stocked(const AnchorDef& def) {
    const double shank = def.shank_length, arm = def.fluke_length, width = def.crown_width;
    const Vec3 palm(0.10 * shank, 0.20 * width, 0.30 * arm);
    return {{{0.5 * shank, 0, 0}, {0.5 * shank, 0.06 * width, 0.06 * width}, 0.35},
            {{0, 0, 0}, {0.08 * shank, 0.10 * width, 0.08 * width}, 0.20},
            {{0.15 * shank, 0, 0.7 * arm}, palm, 0.125, true},
            {{0.15 * shank, 0, -0.7 * arm}, palm, 0.125, true},
            {{0.95 * shank, 0, 0.04 * shank}, {0.03 * shank, 0.5 * shank, 0.02 * shank}, 0.20}};
}

FlukeShape flukes_of(const AnchorDef& def, const std::vector<AnchorPart>& parts) {
    FlukeShape flukes;
    flukes.hinged = def.type != AnchorType::stock;
    flukes.limit = def.fluke_angle;
    flukes.length = def.fluke_length;
    flukes.spread = 0.3 * def.crown_width;
    // A Spek's palms balance its flukes all but for a part.
    const double unbalanced = def.type == AnchorType::spek ? 0.2 : 1;
    for (const AnchorPart& part : parts) {
        if (!part.fluke) continue;
        flukes.width += 2 * part.half.y();
        flukes.moment_over_mass += unbalanced * part.share * part.centre.x();
        flukes.inertia_over_mass +=
            part.share * (part.centre.x() * part.centre.x() + part.half.x() * part.half.x() / 3);
    }
    return flukes;
}

} // namespace

AnchorShape anchor_shape(const AnchorDef& def) {
    const bool stock = def.type == AnchorType::stock;
    AnchorShape shape;
    shape.parts = stock ? stocked(def) : stockless(def);
    shape.flukes = flukes_of(def, shape.parts);
    shape.shank_half = stock ? 0.03 * def.shank_length : 0.09 * def.crown_width;
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
