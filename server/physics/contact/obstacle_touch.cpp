// What a node or link of the chain touches, of the triangles near it: faces, ridges and corners.

#include "server/physics/base/closest.hpp"
#include "server/physics/contact/obstacle_contact.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::physics {

namespace {

/// Two supports of a node whose normals are closer than this (cosine) are one.
constexpr double kSameSupport = 0.95;

/// Where two ridges meet at an angle, a link that lies round the corner passes beyond the ends of both: each
/// reaches so far beyond (half widths of a link). Beside the corner it then stands off the body by a sine of
/// that, some millimetres on a ship's bow.
constexpr double kReachesBeyond = 0.25;

/// A link round a ridge may meet it so far (cosine and sine of 0.2 rad) beyond the normal of a face: nodes
/// are pressed in a little.
constexpr double kFaceTolerance[] = {0.98006658, 0.19866933};

/// Whether a direction points out of a ridge, between the normals of its two faces.
bool between(const Vec3& direction, const Vec3& a, const Vec3& b, double tolerance) {
    const double cosine = a.dot(b), da = direction.dot(a), db = direction.dot(b);
    return da - cosine * db >= -tolerance && db - cosine * da >= -tolerance;
}

} // namespace

Vec3 ObstacleContacts::surface_velocity(const Vec3& at) const {
    return body_->velocity + body_->spin.cross(at - body_->position);
}

ObstacleContacts::Point ObstacleContacts::node_at(int i) const {
    return {at_.at(i), body_->attitude.conjugate() * way_.at(i)};
}

NodeContact ObstacleContacts::contact(int node, int touch, const Support& support, double share,
                                      const Vec3& at) const {
    const double length = def_->node_spacing;
    return {.node = node,
            .touch = touch,
            .normal = body_->attitude * support.normal,
            .penetration = support.penetration,
            .stiffness = share * material_->stiffness,
            .damping =
                share * 2 * std::sqrt(material_->stiffness * def_->mass_per_metre * length), // critical
            .friction = material_->friction,
            .adhesion = share * material_->adhesion * length,
            .surface_velocity = surface_velocity(at)};
}

void ObstacleContacts::find_node(int i) {
    const Point node = node_at(i);
    const Vec3 end = node.at + node.way, room = Vec3::Constant(thickness_);
    const int boxed = meeting(node.at.cwiseMin(end) - room, node.at.cwiseMax(end) + room);
    int count = 0;
    for (int t = 0; t < boxed; ++t) { // a large triangle's box holds much that is far from it
        const MeshTriangle& triangle = mesh_->triangle(triangles_[t]);
        const double from = triangle.normal.dot(node.at - triangle.corner[0]);
        const double to = triangle.normal.dot(end - triangle.corner[0]);
        if (std::min(from, to) < thickness_ && std::max(from, to) > -thickness_ - kDeepest)
            triangles_[count++] = triangles_[t];
    }
    if (count == 0) return;
    supported_ = 0;
    behind_ = false;
    const double steps = std::min(64.0, std::ceil(node.way.norm() / (0.5 * thickness_)));
    bool through = false;
    for (int k = 0; k <= steps && !through; ++k) {
        const Vec3 at = k == 0 ? node.at : Vec3(node.at + (k / steps) * node.way);
        for (int t = 0; t < count; ++t)
            meet(mesh_->triangle(triangles_[t]), node.at, at);
        for (int s = 0; s < supported_; ++s)
            through =
                through || supports_[s].penetration - supports_[s].normal.dot(at - node.at) > thickness_;
    }
    if (supported_ == 0 && behind_) leave_by_nearest_face(node);
    for (int s = 0; s < supported_; ++s)
        set_->add(contact(i, set_->new_touch(), supports_[s], 1, chain_->position.at(i)));
}

/// Whether a triangle supports a node that began the step at start and is now at another place of its way.
void ObstacleContacts::meet(const MeshTriangle& triangle, const Vec3& start, const Vec3& at) {
    const OnTriangle nearest = closest_on_triangle(triangle.corner, triangle.normal, at);
    const Vec3 away = at - nearest.point;
    if (nearest.side < 0) {
        const double height = away.dot(triangle.normal);
        if (height >= 0 && height < thickness_)
            keep(triangle.normal, thickness_ - triangle.normal.dot(start - nearest.point));
        behind_ = behind_ || height < 0;
        return;
    }
    const double distance = away.norm();
    if (!triangle.ridge[nearest.side] || distance >= thickness_ || distance < 1e-9) return;
    const Vec3 normal = away / distance;
    if (between(normal, triangle.normal, triangle.beyond[nearest.side], 1e-6))
        keep(normal, thickness_ - normal.dot(start - nearest.point));
}

/// A node inside the body leaves it by the nearest face. One behind a face may also be outside, on the other
/// hand of a stem: then the nearest face is one that it is in front of.
void ObstacleContacts::leave_by_nearest_face(const Point& node) {
    const Vec3 room = Vec3::Constant(kDeepest);
    const int count = mesh_->near(node.at - room, node.at + room, triangles_);
    double nearest = kDeepest;
    Support way_out{Vec3::Zero(), 0};
    for (int t = 0; t < count; ++t) {
        const MeshTriangle& triangle = mesh_->triangle(triangles_[t]);
        const OnTriangle on = closest_on_triangle(triangle.corner, triangle.normal, node.at);
        const Vec3 away = node.at - on.point;
        const double distance = away.norm(), height = away.dot(triangle.normal);
        if (distance >= nearest) continue;
        nearest = distance;
        const bool inside = on.side < 0 && height < 0;
        way_out = {inside ? triangle.normal : Vec3::Zero(), thickness_ - height};
    }
    if (way_out.normal != Vec3::Zero()) keep(way_out.normal, way_out.penetration);
}

void ObstacleContacts::keep(const Vec3& normal, double penetration) {
    for (int s = 0; s < supported_; ++s) {
        if (supports_[s].normal.dot(normal) < kSameSupport) continue;
        if (penetration > supports_[s].penetration) supports_[s] = {normal, penetration};
        return;
    }
    if (supported_ < static_cast<int>(supports_.size())) supports_[supported_++] = {normal, penetration};
}

void ObstacleContacts::find_link(int i) {
    bend_ = bend_beyond_ = -1;
    beyond_ = kReachesBeyond * thickness_;
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
    // A ridge that the link crosses counts before the end of one, but for a blunt one at a sharp one's end.
    if (bend_beyond_ > 2 * std::max(0.0, bend_)) bend_ = bend_beyond_, edge_ = edge_beyond_;
    if (bend_ < 0) return;
    edge_.surface_velocity = surface_velocity(body_->position + body_->attitude * edge_.foot);
    edge_.foot = body_->position + body_->attitude * edge_.foot;
    edge_.along = body_->attitude * edge_.along;
    edge_.out = body_->attitude * edge_.out;
    set_->add(edge_);
}

/// Keeps a ridge if the link lies round it, or may within the step, and none has bent it more; one that it
/// passes beyond an end of, if there is none that it passes closer.
void ObstacleContacts::lay_round(int i, const Point& lower, const Point& upper, const MeshTriangle& triangle,
                                 int side) {
    const Vec3 foot = triangle.corner[side], ridge = triangle.corner[(side + 1) % 3] - foot;
    const Vec3 link = upper.at - lower.at;
    const ClosestShares shares = closest_to_line(lower.at, link, foot, ridge);
    const double beyond = std::max(-shares.second, shares.second - 1) * ridge.norm();
    if (beyond >= beyond_) return;
    const Vec3 &a = triangle.normal, &b = triangle.beyond[side];
    const Vec3 off = lower.at + shares.first * link - foot - shares.second * ridge;
    const double moves = std::max(lower.way.norm(), upper.way.norm());
    if (off.dot(a + b) > 0 && off.norm() > thickness_ + moves) return; // it passes on the outer hand
    const Vec3 across = link.cross(ridge);
    if (across.norm() < 0.05 * link.norm() * ridge.norm()) return; // along the ridge: the nodes lie on it
    const Edge edge{.link = i,
                    .foot = foot,
                    .along = ridge.normalized(),
                    .out = (a + b).normalized(),
                    .radius = thickness_,
                    .friction = material_->friction};
    const LinkWay way = way_round(edge, lower.at, upper.at);
    if (way.turn <= 0 && off.norm() > thickness_ + moves) return;
    // It meets and leaves the ridge between the two faces, else it is no link round this one but one behind
    // it.
    const double c = std::clamp(a.dot(b), -1.0, 1.0);
    const double min =
        std::sqrt(0.5 * (1 + c)) * kFaceTolerance[0] - std::sqrt(0.5 * (1 - c)) * kFaceTolerance[1];
    if (way.turn > 0 && std::min(way.cosine_lower, way.cosine_upper) < min) return;
    if (beyond >= 0) {
        beyond_ = beyond, bend_beyond_ = way.turn, edge_beyond_ = edge;
    } else if (way.turn > bend_) {
        bend_ = way.turn, edge_ = edge;
    }
}

} // namespace windlass::physics
