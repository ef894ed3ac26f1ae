// Above the lips both cables are thought to go on straight up, below the anchors straight down: then they are
// two strands of a braid, and where one is seen to pass before the other, from whatever side, tells how often
// they wind. Looked at aslant from above, so that what lies on the bottom lies side by side.

#include "server/assess/hawse.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace windlass::assess {

namespace {

using Eigen::Vector2d;

constexpr double kFar = 1e4;         ///< m, by which strands go on up and down
constexpr std::ptrdiff_t kPiece = 8; ///< links that are looked at together: most are far from all others

/// As one sees it who looks aslant down on it: aside and up, m; and how far it is from him.
struct Seen {
    Vector2d at;
    double away;
};

/// Aside and away on the plan, for a bearing on which neither ships nor anchors lie on purpose.
Vector2d plan(const Eigen::Vector3f& place) {
    const double x = place.x(), y = place.y();
    return {0.8 * x + 0.6 * y, 0.8 * y - 0.6 * x};
}

/// A cable with its ends going on: node -1 is far above the lip, node size() far below the anchor.
struct Strand {
    CableNodes nodes;

    std::ptrdiff_t links() const { return static_cast<std::ptrdiff_t>(nodes.size()) + 1; }
    Seen operator[](std::ptrdiff_t k) const {
        const std::ptrdiff_t last = links() - 2, inside = std::clamp<std::ptrdiff_t>(k, 0, last);
        const Eigen::Vector3f& node = nodes[static_cast<std::size_t>(inside)];
        const Vector2d on_plan = plan(node);
        const double up = node.z() + kFar * static_cast<double>(inside - k);
        return {{on_plan.x(), up + on_plan.y()}, on_plan.y()};
    }
    /// What the links from a node on to another cover.
    Eigen::AlignedBox2d covers(std::ptrdiff_t from, std::ptrdiff_t to) const {
        Eigen::AlignedBox2d box;
        for (std::ptrdiff_t k = from; k <= to; ++k)
            box.extend((*this)[k].at);
        return box;
    }
};

double cross(const Vector2d& a, const Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// Whether one link is seen to pass the other, and which way the line between them turns there, from the
/// first to the second and down: 1 counter-clockwise from above, -1 clockwise, 0 none.
int passing(const Seen& a, const Seen& a_end, const Seen& b, const Seen& b_end) {
    const Vector2d u = a_end.at - a.at, v = b_end.at - b.at, off = b.at - a.at;
    const auto left = [](const Vector2d& of, const Vector2d& at) { return cross(of, at) > 0; };
    if (left(u, off) == left(u, off + v) || left(v, -off) == left(v, u - off)) return 0;
    const double turn = cross(u, v);
    const double a_away = a.away + cross(off, v) / turn * (a_end.away - a.away);
    const double b_away = b.away + cross(off, u) / turn * (b_end.away - b.away);
    return (turn > 0) == (b_away > a_away) ? -1 : 1;
}

int passings(const Strand& a, const Strand& b) {
    int sum = 0;
    for (std::ptrdiff_t i = -1; i < a.links() - 1; i += kPiece) {
        const std::ptrdiff_t a_end = std::min(i + kPiece, a.links() - 1);
        const Eigen::AlignedBox2d box = a.covers(i, a_end);
        for (std::ptrdiff_t j = -1; j < b.links() - 1; j += kPiece) {
            const std::ptrdiff_t b_end = std::min(j + kPiece, b.links() - 1);
            if (!box.intersects(b.covers(j, b_end))) continue;
            for (std::ptrdiff_t k = i; k < a_end; ++k)
                for (std::ptrdiff_t l = j; l < b_end; ++l)
                    sum += passing(a[k], a[k + 1], b[l], b[l + 1]);
        }
    }
    return sum;
}

/// Half turns from straight aside, -1 to 1, counter-clockwise.
double half_turns_of(const Vector2d& direction) {
    return std::atan2(direction.y(), direction.x()) / std::numbers::pi;
}

} // namespace

double half_turns_between(CableNodes port, CableNodes starboard) {
    if (port.empty() || starboard.empty()) return 0;
    const double lips = half_turns_of(plan(starboard.front()) - plan(port.front()));
    const double anchors = half_turns_of(plan(starboard.back()) - plan(port.back()));
    // The line between the strands goes through "straight away" as often as one is seen to pass the other.
    const auto beyond_away = [](double half_turns) { return std::floor(half_turns + 0.5); };
    const double whole = (beyond_away(lips) + passings({port}, {starboard}) - beyond_away(anchors)) / 2;
    return anchors + 2 * std::round(whole) - lips;
}

int turns_in_hawse(CableNodes port, CableNodes starboard) {
    constexpr double kShort = 0.25; // half turns
    const double half_turns = half_turns_between(port, starboard);
    return static_cast<int>(std::copysign(std::floor(std::abs(half_turns) + kShort), half_turns));
}

} // namespace windlass::assess
