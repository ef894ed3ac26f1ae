// What a node of the chain touches, of the triangles near it: faces, ridges and corners.

#include "server/physics/base/closest.hpp"
#include "server/physics/contact/obstacle_contact.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::physics {

namespace {

/// Two supports of a node whose normals are closer than this (cosine) are one.
constexpr double kSameSupport = 0.95;

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
    if (between_normals(normal, triangle.normal, triangle.beyond[nearest.side], 1e-6))
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

} // namespace windlass::physics
