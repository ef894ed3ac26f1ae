// The ridge that a link of the chain lies round, of the triangles near it.

#include "server/physics/base/closest.hpp"
#include "server/physics/contact/obstacle_contact.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::physics {

namespace {

/// Ridges whose faces' normals are closer than this (cosine of 10 degrees) bend no link: those of a body
/// whose roundness is cut into faces, where a link that lies across one is borne by its nodes.
constexpr double kBlunt = 0.985;

/// Where two ridges meet at an angle, a link that lies round the corner passes beyond the ends of both: each
/// reaches so far beyond (half widths of a link). With a quarter of it a link that lies in the hollow under a
/// raked stem was without one in two of five slides, with the whole in one of eight (Ridges).
constexpr double kReachesBeyond = 1;

/// A link round a ridge may meet it so far (cosine and sine of 0.2 rad) beyond the normal of a face: nodes
/// are pressed in a little, and faces of a round bow fall away from each other.
constexpr double kFaceTolerance[] = {0.98006658, 0.19866933};

/// m, by which a ridge must stick out of what another one's faces shut in.
constexpr double kSticksOut = 0.01;

/// m along an edge from its foot, where a link crosses it on its way, or, passing it straight, is nearest (at
/// that share of it).
double crosses_at(const Edge& edge, const LinkWay& way, const Vec3& lower, const Vec3& link, double nearest) {
    const double half_round = 0.5 * edge.radius * way.turn;
    const double share = way.turn > 0 ? (way.straight_lower + half_round) /
                                            (way.straight_lower + 2 * half_round + way.straight_upper)
                                      : nearest;
    return (lower + share * link - edge.foot).dot(edge.along);
}

} // namespace

/// m, by which a place (body frame) is nearer than half a link's width to what the ridge's two faces shut in.
double ObstacleContacts::Ridge::depth(const Vec3& place) const {
    const Vec3 off = place - edge.foot, across = off - off.dot(edge.along) * edge.along;
    const double distance =
        between_normals(across, a, b, 0) ? across.norm() : std::max(across.dot(a), across.dot(b));
    return std::max(0.0, edge.radius - distance);
}

/// Whether another ridge sticks out of what this one's two faces shut in: they meet in a hollow.
bool ObstacleContacts::Ridge::leaves_out(const Ridge& other) const {
    const auto out = [&](const Vec3& end) {
        return std::max((end - edge.foot).dot(a), (end - edge.foot).dot(b)) > kSticksOut;
    };
    return out(other.edge.foot) || out(other.edge.foot + other.size * other.edge.along);
}

void ObstacleContacts::find_link(int i) {
    ridges_found_ = 0;
    const Point lower = node_at(i), upper = node_at(i + 1);
    const double way = std::max(lower.way.norm(), upper.way.norm());
    const Vec3 room = Vec3::Constant(thickness_ + way);
    const int count = meeting(lower.at.cwiseMin(upper.at) - room, lower.at.cwiseMax(upper.at) + room);
    for (int t = 0; t < count; ++t) {
        const MeshTriangle& triangle = mesh_->triangle(triangles_[t]);
        const double from = triangle.normal.dot(lower.at - triangle.corner[0]);
        const double to = triangle.normal.dot(upper.at - triangle.corner[0]);
        const double far = thickness_ + way; // off the triangle's plane, so off its sides
        if (std::min(from, to) > far || std::max(from, to) < -far - kDeepest) continue;
        for (int side = 0; side < 3; ++side)
            if (triangle.ridge[side] && triangle.own_side[side]) lay_round(i, lower, upper, triangle, side);
    }
    if (ridges_found_ == 0) return;
    const Ridge& least = least_way_round();
    if (least.passed) return;
    Edge edge = least.edge;
    edge.surface_velocity = surface_velocity(body_->position + body_->attitude * edge.foot);
    edge.foot = body_->position + body_->attitude * edge.foot;
    edge.along = body_->attitude * edge.along;
    edge.out = body_->attitude * edge.out;
    set_->add(edge);
}

/// Of the ridges that were found the one that leads the link round the body, in such a way that its length
/// does not jump where it slides from one onto another over the corner where they meet: what two faces shut
/// in holds the body, so that the least way round any ridge, as if it had no end, is long enough; unless
/// another ridge sticks out of it, as that of a raked stem does out of what shuts in the one below: of these
/// two the longer one.
const ObstacleContacts::Ridge& ObstacleContacts::least_way_round() const {
    const auto begin = ridges_.begin(), end = begin + ridges_found_;
    const Ridge* least = nullptr;
    for (auto ridge = begin; ridge != end; ++ridge) {
        const bool too_short = std::any_of(begin, end, [&](const Ridge& other) {
            return other.way > ridge->way && ridge->leaves_out(other);
        });
        if (!too_short && (least == nullptr || ridge->way < least->way)) least = &*ridge;
    }
    return *least; // the longest is not too short
}

/// Keeps a ridge if the link lies round it, or may within the step.
void ObstacleContacts::lay_round(int i, const Point& lower, const Point& upper, const MeshTriangle& triangle,
                                 int side) {
    const Vec3 &a = triangle.normal, &b = triangle.beyond[side];
    if (a.dot(b) > kBlunt || ridges_found_ == static_cast<int>(ridges_.size())) return;
    const Vec3 foot = triangle.corner[side], along = triangle.corner[(side + 1) % 3] - foot;
    const Vec3 link = upper.at - lower.at;
    const ClosestShares shares = closest_to_line(lower.at, link, foot, along);
    const Vec3 off = lower.at + shares.first * link - foot - shares.second * along;
    const double size = along.norm(), moves = std::max(lower.way.norm(), upper.way.norm());
    const bool far = off.norm() > thickness_ + moves;
    if (link.cross(along).norm() < 0.05 * link.norm() * size) return; // along the ridge: the nodes lie on it
    Ridge ridge{.edge = {.link = i,
                         .foot = foot,
                         .along = along / size,
                         .out = (a + b).normalized(),
                         .radius = thickness_,
                         .friction = material_->friction},
                .a = a,
                .b = b,
                .size = size};
    const LinkWay way = way_round(ridge.edge, lower.at, upper.at);
    const bool turns = way.turn > 0, outside = off.dot(a + b) > 0;
    if (far && turns == outside) return; // a way past the other hand of the body, or deep in it
    const double crossed = crosses_at(ridge.edge, way, lower.at, link, shares.first);
    if (std::max(-crossed, crossed - size) > kReachesBeyond * thickness_) return;
    // It meets and leaves the ridge between the two faces, else it is no link round this one but one behind
    // it.
    const double c = std::clamp(a.dot(b), -1.0, 1.0);
    const double min =
        std::sqrt(0.5 * (1 + c)) * kFaceTolerance[0] - std::sqrt(0.5 * (1 - c)) * kFaceTolerance[1];
    if (turns && std::min(way.cosine_lower, way.cosine_upper) < min) return;
    // A way that goes through what it is to go round is longer than it looks.
    ridge.passed = far && !turns;
    ridge.way = way.length + ridge.depth(lower.at) + ridge.depth(upper.at);
    ridges_[ridges_found_++] = ridge;
}

} // namespace windlass::physics
