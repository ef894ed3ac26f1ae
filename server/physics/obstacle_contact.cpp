#include "server/physics/obstacle_contact.hpp"

#include "server/physics/closest.hpp"

#include <cmath>

namespace windlass::physics {

namespace {

constexpr int kMostTriangles = 128; ///< of a mesh near one node or link

/// A node or link deeper inside a body than this (m) is not pushed out: it came there in another way.
constexpr double kDeepest = 0.6;

/// Two supports of a node whose normals are closer than this (cosine) are one.
constexpr double kSameSupport = 0.95;

/// Nearer to a node than this share of the link, the node's own contact serves.
constexpr double kLinkEnd = 0.02;

/// Whether a direction points out of a ridge, between the normals of its two faces.
bool between(const Vec3& direction, const Vec3& a, const Vec3& b, double tolerance) {
    const double cosine = a.dot(b), da = direction.dot(a), db = direction.dot(b);
    return da - cosine * db >= -tolerance && db - cosine * da >= -tolerance;
}

} // namespace

ObstacleContacts::ObstacleContacts() : triangles_(kMostTriangles) {}

void ObstacleContacts::find(const ChainDef& def, const ChainState& chain, double dt, const ObstacleMesh& mesh,
                            const BodyMotion& body, const ContactMaterial& material, ContactSet& set) {
    def_ = &def, chain_ = &chain, mesh_ = &mesh, body_ = &body, material_ = &material, set_ = &set;
    dt_ = dt;
    thickness_ = 0.5 * def.contact_diameter;
    // Most of a chain is nowhere near: the body's box, in its frame, says so at once.
    const Eigen::Matrix3d into = body.attitude.conjugate().toRotationMatrix();
    const double sweep = thickness_ + dt * (body.velocity.norm() + body.spin.norm() * mesh.high().norm());
    const auto is_near = [&](int i) {
        const Vec3 at = into * (chain.position.at(i) - body.position);
        const Vec3 room = Vec3::Constant(sweep + dt * chain.velocity.at(i).norm() + def.node_spacing);
        return ((at + room).array() > mesh.low().array()).all() &&
               ((at - room).array() < mesh.high().array()).all();
    };
    bool was_near = false;
    for (int i = chain.asleep; i <= chain.links; ++i) {
        const bool near = is_near(i);
        if (near && i > 0 && i < chain.links) find_node(i);
        if (i > chain.asleep && (near || was_near)) find_link(i - 1);
        was_near = near;
    }
}

Vec3 ObstacleContacts::surface_velocity(const Vec3& at) const {
    return body_->velocity + body_->spin.cross(at - body_->position);
}

ObstacleContacts::Point ObstacleContacts::node_at(int i) const {
    const Vec3 at = chain_->position.at(i);
    const Eigen::Quaterniond into = body_->attitude.conjugate();
    return {into * (at - body_->position), into * (dt_ * (chain_->velocity.at(i) - surface_velocity(at)))};
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
    const int boxed = mesh_->near(node.at.cwiseMin(end) - room, node.at.cwiseMax(end) + room, triangles_);
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
    inside_.penetration = 1e300;
    const double steps = std::min(64.0, std::ceil(node.way.norm() / (0.5 * thickness_)));
    bool through = false;
    for (int k = 0; k <= steps && !through; ++k) {
        const Vec3 at = k == 0 ? node.at : Vec3(node.at + (k / steps) * node.way);
        for (int t = 0; t < count; ++t)
            meet(mesh_->triangle(triangles_[t]), node.at, at, k == 0);
        for (int s = 0; s < supported_; ++s)
            through =
                through || supports_[s].penetration - supports_[s].normal.dot(at - node.at) > thickness_;
    }
    if (supported_ == 0 && inside_.penetration < thickness_ + kDeepest)
        keep(inside_.normal, inside_.penetration);
    for (int s = 0; s < supported_; ++s)
        set_->add(contact(i, set_->new_touch(), supports_[s], 1, chain_->position.at(i)));
}

/// Whether a triangle supports a node that began the step at start and is now at another place of its way.
void ObstacleContacts::meet(const MeshTriangle& triangle, const Vec3& start, const Vec3& at, bool first) {
    const OnTriangle nearest = closest_on_triangle(triangle.corner, triangle.normal, at);
    const Vec3 away = at - nearest.point;
    if (nearest.side < 0) {
        const double height = away.dot(triangle.normal);
        if (height >= 0 && height < thickness_)
            keep(triangle.normal, thickness_ - triangle.normal.dot(start - nearest.point));
        if (first && height < 0 && thickness_ - height < inside_.penetration)
            inside_ = {triangle.normal, thickness_ - height};
        return;
    }
    const double distance = away.norm();
    if (!triangle.ridge[nearest.side] || distance >= thickness_ || distance < 1e-9) return;
    const Vec3 normal = away / distance;
    if (between(normal, triangle.normal, triangle.beyond[nearest.side], 1e-6))
        keep(normal, thickness_ - normal.dot(start - nearest.point));
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
    const Point lower = node_at(i), upper = node_at(i + 1);
    const double way = std::max(lower.way.norm(), upper.way.norm());
    const Vec3 room = Vec3::Constant(thickness_ + way);
    const int count =
        mesh_->near(lower.at.cwiseMin(upper.at) - room, lower.at.cwiseMax(upper.at) + room, triangles_);
    for (int t = 0; t < count; ++t) {
        const MeshTriangle& triangle = mesh_->triangle(triangles_[t]);
        const double from = triangle.normal.dot(lower.at - triangle.corner[0]);
        const double to = triangle.normal.dot(upper.at - triangle.corner[0]);
        const double far = thickness_ + way; // off the triangle's plane, so off its sides
        if (std::min(from, to) > far || std::max(from, to) < -far - kDeepest) continue;
        for (int side = 0; side < 3; ++side)
            if (triangle.ridge[side] && triangle.own_side[side]) cross_ridge(i, lower, upper, triangle, side);
    }
}

void ObstacleContacts::cross_ridge(int i, const Point& lower, const Point& upper,
                                   const MeshTriangle& triangle, int side) {
    const Vec3 foot = triangle.corner[side], ridge = triangle.corner[(side + 1) % 3] - foot;
    const Vec3 link = upper.at - lower.at;
    const ClosestShares shares = closest_shares(lower.at, link, foot, ridge);
    if (shares.first < kLinkEnd || shares.first > 1 - kLinkEnd || shares.second <= 0 || shares.second >= 1)
        return;
    const Vec3 across = link.cross(ridge);
    if (across.norm() < 0.05 * link.norm() * ridge.norm()) return; // along the ridge: the nodes lie on it
    const Vec3 &a = triangle.normal, &b = triangle.beyond[side];
    const Vec3 normal = across.normalized() * (across.dot(a + b) < 0 ? -1 : 1);
    const Vec3 off = lower.at + shares.first * link - foot - shares.second * ridge;
    const double height = off.dot(normal);
    const bool outside = height >= 0 && between(normal, a, b, 0.05);
    const bool inside = height < 0 && height > -kDeepest && off.dot(a) <= 0 && off.dot(b) <= 0;
    const Vec3 way = lower.way + shares.first * (upper.way - lower.way);
    const double penetration = thickness_ - height;
    if ((!outside && !inside) || penetration - normal.dot(way) < 0) return;

    // The touch lies between two nodes and acts on both. Each carries its share as if it moved with the
    // touch; that the link turns meanwhile goes into the surface's speed as the node meets it, so that it
    // costs nothing (it adds to the link's inertia, a share of dt^2 times the stiffness).
    const int touch = set_->new_touch();
    const Vec3 world_normal = body_->attitude * normal;
    const Vec3 v0 = chain_->velocity.at(i), v1 = chain_->velocity.at(i + 1);
    const Vec3 mean = v0 + shares.first * (v1 - v0);
    const Vec3 at =
        chain_->position.at(i) + shares.first * (chain_->position.at(i + 1) - chain_->position.at(i));
    for (const int end : {0, 1}) {
        const int node = i + end;
        if (node == 0 || node == chain_->links) continue; // the anchor's and the lip's own business
        NodeContact c =
            contact(node, touch, {normal, penetration}, end ? shares.first : 1 - shares.first, at);
        c.surface_velocity += (end ? v1 - mean : v0 - mean).dot(world_normal) * world_normal;
        set_->add(c);
    }
}

} // namespace windlass::physics
