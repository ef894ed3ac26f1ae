#include "server/physics/anchor/anchor_contact.hpp"

#include "server/physics/base/closest.hpp"
#include "server/physics/base/vectorise.hpp"
#include "server/physics/contact/chain_self_contact.hpp"
#include "server/physics/sea/ground.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <span>

namespace windlass::physics {

namespace {

/// Chain so near the shackle (widths of a link, along it) cannot lie on the anchor.
constexpr double kLeavesShackle = 2;

/// A bight drawn tight round shank or flukes bears on them at one or two points: a meganewton presses it in
/// by a third of a link's width. As soft as links in a heap it would be pulled through the steel, or stick in
/// it. N/m; tuned.
constexpr double kBight = 1e7;

/// Of critical damping: a link that is wedged between shank and flukes does not rattle there; tuned.
constexpr double kDamped = 4;

/// A link that lies along a face of the anchor bears on all of it that is within this share of half its width
/// of the nearest. Tuned: a link between shank and flukes comes to rest.
constexpr double kSpread = 0.25;

/// How deep a node is, in half widths of a link below where it would lie on a rigid bed: 1.3 under its own
/// weight. To the first of these it lies beside an anchor, from the second on under it; tuned.
constexpr double kBeside = 1.5, kUnder = 3;

/// Whether the middle of any of these links comes within reach (m) of a point.
bool any_near(const ChainState& chain, const Vec3& point, double reach, int first, int last) {
    const Field& x = chain.position;
    const double square = reach * reach;
    std::int64_t near = 0;
    WINDLASS_VECTORISE
    for (int i = first; i <= last; ++i)
        near += (0.5 * (x.at(i) + x.at(i + 1)) - point).squaredNorm() < square ? 1 : 0;
    return near > 0;
}

} // namespace

int find_anchor_contacts(const ChainDef& def, const EnvironmentDef& environment, const ChainState& chain,
                         double dt, const Anchor& anchor, const AnchorTouch& who, PairContacts& ties) {
    constexpr int kRun = 16; // links looked at together
    const double leaves = who.own() ? kLeavesShackle * def.contact_diameter / def.node_spacing : 0;
    const int free = static_cast<int>(std::ceil(leaves - 1e-9));
    int dropped = 0;
    const AnchorPose pose = anchor.pose();
    const double half_width = 0.5 * def.contact_diameter;
    const double fast = anchor.fastest();
    const double reach = anchor.reach() + half_width + 0.5 * def.node_spacing + 2 * dt * fast;
    const double mass = 0.5 * def.mass_per_metre * def.node_spacing; // of two nodes that meet
    const double damping = kDamped * 2 * std::sqrt(kBight * mass);
    const double friction = link_touch(def).friction;
    std::array<AnchorBox, 8> lying; // made once any link is near
    assert(anchor.boxes() <= static_cast<int>(lying.size()) && "no type of anchor has as many");
    std::span<const AnchorBox> boxes;
    // The bed bears nodes at its face, and there an anchor comes against their side; but those that it stands
    // on, it presses in until it stands on the bed itself.
    const auto on_bed = [&](Vec3 at) {
        const double sunk = std::max(0.0, half_width - height_over_bed(environment, at));
        at.z() += sunk * std::clamp((kUnder - sunk / half_width) / (kUnder - kBeside), 0.0, 1.0);
        return at;
    };
    const auto touch = [&](int i) {
        const Vec3 lower = on_bed(chain.position.at(i)), along = on_bed(chain.position.at(i + 1)) - lower;
        const Vec3 low_speed = chain.velocity.at(i), high_speed = chain.velocity.at(i + 1);
        const double room =
            half_width + dt * (fast + std::sqrt(std::max(low_speed.squaredNorm(), high_speed.squaredNorm())));
        for (const AnchorBox& box : boxes) {
            const Vec3 a = box.axes.transpose() * (lower - box.centre), u = box.axes.transpose() * along;
            const Vec3 far = box.half + Vec3::Constant(room);
            if ((a.cwiseMin(a + u).array() > far.array()).any() ||
                (a.cwiseMax(a + u).array() < -far.array()).any())
                continue;
            const OnBox on = bearing_on_box(a, u, box.half, kSpread * half_width, room);
            const Vec3 normal = box.axes * on.normal;
            const Vec3 arm = box.centre + box.axes * on.point - pose.position;
            const Vec3 speed =
                low_speed + on.share * (high_speed - low_speed) - pose.velocity - pose.spin.cross(arm);
            if (on.distance + dt * normal.dot(speed) > half_width) continue;
            const bool fits = ties.add({.link_a = i,
                                        .at_a = on.share,
                                        .normal = normal,
                                        .penetration = half_width - on.distance,
                                        .stiffness = kBight,
                                        .damping = damping,
                                        .friction = friction,
                                        .cable_a = who.cable,
                                        .cable_b = who.anchor,
                                        .body_b = Body::anchor,
                                        .on_b = {.arm = arm}});
            dropped += fits ? 0 : 1;
        }
    };
    for (int first = std::max(free, chain.asleep); first < chain.links; first += kRun) {
        const int last = std::min(first + kRun, chain.links) - 1;
        if (!any_near(chain, pose.position, reach, first, last)) continue;
        if (boxes.empty()) {
            for (int k = 0; k < anchor.boxes(); ++k)
                lying[k] = anchor.box(k);
            boxes = {lying.data(), static_cast<std::size_t>(anchor.boxes())};
        }
        for (int i = first; i <= last; ++i)
            touch(i);
    }
    return dropped;
}

} // namespace windlass::physics
