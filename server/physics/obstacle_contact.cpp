#include "server/physics/obstacle_contact.hpp"

#include "server/physics/closest.hpp"
#include "server/physics/lanes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace windlass::physics {

namespace {

constexpr int kMostTriangles = 256; ///< of a mesh near one link

/// A node or link deeper inside a body than this (m) is not pushed out: it came there in another way.
constexpr double kDeepest = 0.6;

/// A link is found clear of a body by no more than this, m.
constexpr double kLook = 1.2;

/// A link so near a body that it would soon be due again is looked at for so many steps without asking how
/// far it is clear, which costs as much as looking.
constexpr int kPause = 10;

/// Links that are told apart from the body's box together; with them one node more, which fills the lanes.
constexpr int kRun = 15;

/// Two supports of a node whose normals are closer than this (cosine) are one.
constexpr double kSameSupport = 0.95;

/// A link round a ridge may meet it so far (cosine and sine of 0.2 rad) beyond the normal of a face: nodes
/// are pressed in a little.
constexpr double kFaceTolerance[] = {0.98006658, 0.19866933};

/// Whether a direction points out of a ridge, between the normals of its two faces.
bool between(const Vec3& direction, const Vec3& a, const Vec3& b, double tolerance) {
    const double cosine = a.dot(b), da = direction.dot(a), db = direction.dot(b);
    return da - cosine * db >= -tolerance && db - cosine * da >= -tolerance;
}

} // namespace

ObstacleContacts::ObstacleContacts(int capacity)
    : around_(kMostTriangles),
      triangles_(kMostTriangles),
      clear_(capacity),
      pause_(capacity),
      lower_(capacity),
      upper_(capacity),
      at_(capacity + 1),
      way_(capacity + 1),
      due_(capacity) {}

void ObstacleContacts::find(const ChainDef& def, const ChainState& chain, double dt, const ObstacleMesh& mesh,
                            const BodyMotion& body, const ContactMaterial& material, ContactSet& set,
                            bool foot) {
    def_ = &def, chain_ = &chain, mesh_ = &mesh, body_ = &body, material_ = &material, set_ = &set;
    dt_ = dt;
    foot_ = foot;
    thickness_ = 0.5 * def.contact_diameter;
    if (marked_ != &mesh) std::fill(clear_.begin(), clear_.end(), 0);
    marked_ = &mesh;
    // Most of a chain is nowhere near the box that the body fills.
    const Eigen::Matrix3d out = body.attitude.toRotationMatrix();
    const Vec3 middle = body.position + out * (0.5 * (mesh.low() + mesh.high()));
    const double reach = (0.5 * (mesh.high() - mesh.low())).norm();
    const double spin = body.spin.norm() * (reach + (middle - body.position).norm());
    const Vec3 half = out.cwiseAbs() * (0.5 * (mesh.high() - mesh.low())) +
                      Vec3::Constant(thickness_ + dt * spin + def.node_spacing);
    // The run at the lip, which is always near, is whole; the lowest one what is left.
    int first = chain.asleep, beyond = chain.asleep + (chain.links - chain.asleep) % kRun;
    for (; first < chain.links; first = beyond, beyond += kRun)
        if (any_near(middle, half, first, beyond)) look_at_due(first, beyond - 1);
}

/// Whether any of these nodes comes into a box in this step.
bool ObstacleContacts::any_near(const Vec3& middle, const Vec3& half, int first, int last) const {
    const Field &x = chain_->position, &v = chain_->velocity;
    const Vec3 speed = body_->velocity;
    const double dt = dt_;
    std::int64_t near = 0;
    WINDLASS_LANES
    for (int i = first; i <= last; ++i) {
        const double ax = std::abs(x.x[i] - middle.x()) - dt * std::abs(v.x[i] - speed.x()) - half.x();
        const double ay = std::abs(x.y[i] - middle.y()) - dt * std::abs(v.y[i] - speed.y()) - half.y();
        const double az = std::abs(x.z[i] - middle.z()) - dt * std::abs(v.z[i] - speed.z()) - half.z();
        const double level = ax > ay ? ax : ay, away = level > az ? level : az;
        near += away < 0 ? 1 : 0;
    }
    return near > 0;
}

/// Looks at those of these links that may have come to the body since they were found clear of it.
void ObstacleContacts::look_at_due(int first, int last) {
    const Eigen::Matrix3d into = body_->attitude.conjugate().toRotationMatrix();
    const Vec3 origin = body_->position, speed = body_->velocity, spin = body_->spin;
    const double dt = dt_;
    WINDLASS_LANES
    for (int i = first; i <= last + 1; ++i) {
        const Vec3 arm = chain_->position.at(i) - origin;
        at_.set(i, into * arm);
        way_.set(i, dt * (chain_->velocity.at(i) - speed - spin.cross(arm)));
    }
    std::int64_t count = 0;
    WINDLASS_LANES
    for (int i = first; i <= last; ++i) {
        const double a = (at_.at(i) - lower_.at(i)).squaredNorm(),
                     b = (at_.at(i + 1) - upper_.at(i)).squaredNorm();
        const double c = way_.at(i).squaredNorm(), d = way_.at(i + 1).squaredNorm();
        const double gone = (a > b ? a : b) + (c > d ? c : d);
        // (g + w)^2 <= 2 (g^2 + w^2)
        const double due = 2 * gone * (1 + 1e-9) >= clear_[i] * clear_[i] ? 1 : 0;
        due_[i] = due;
        count += due > 0 ? 1 : 0;
    }
    if (count == 0) return;
    for (int i = first; i <= last; ++i)
        if (due_[i] > 0) look_at(i);
}

/// A link and the node above it.
void ObstacleContacts::look_at(int link) {
    const auto found = [&] {
        return set_->node_contacts().size() +
               static_cast<std::size_t>(set_->wraps().size() + set_->dropped());
    };
    const std::size_t before = found();
    // The mesh is asked once for all: its tree costs more than the triangles.
    const Vec3 lower = at_.at(link), upper = at_.at(link + 1);
    const Vec3 low = lower.cwiseMin(upper), high = lower.cwiseMax(upper);
    const double way = std::sqrt(std::max(way_.at(link).squaredNorm(), way_.at(link + 1).squaredNorm()));
    const auto gather = [&](double room) {
        around_count_ = mesh_->near(low - Vec3::Constant(room), high + Vec3::Constant(room), around_);
        return around_count_ < kMostTriangles; // else there may be more
    };
    const bool pauses = pause_[link] > 0, all = !pauses && gather(std::max(kLook, thickness_ + way));
    if (!all) gather(thickness_ + way);
    if (foot_ && link == 0) find_node(0);
    if (link + 1 < chain_->links) find_node(link + 1);
    if (link != chain_->parted) find_link(link);
    const bool touches = found() > before;
    clear_[link] = all && !touches ? clearance(link) : 0;
    if (pauses)
        --pause_[link];
    else if (clear_[link] < kPause * way)
        pause_[link] = kPause;
    lower_.set(link, at_.at(link));
    upper_.set(link, at_.at(link + 1));
}

/// Puts into triangles_ those of around_ whose box meets the given one (m). Returns their number.
int ObstacleContacts::meeting(const Vec3& low, const Vec3& high) {
    int count = 0;
    for (int t = 0; t < around_count_; ++t) {
        const MeshTriangle& triangle = mesh_->triangle(around_[t]);
        const bool apart =
            (triangle.low.array() > high.array()).any() || (triangle.high.array() < low.array()).any();
        if (!apart) triangles_[count++] = around_[t];
    }
    return count;
}

/// How far a link is off the surface, m, at most kLook, less what a contact is found from; 0 when it is
/// inside or behind a face that is near, and so must be looked at in each step.
double ObstacleContacts::clearance(int link) const {
    const Vec3 lower = at_.at(link), upper = at_.at(link + 1), along = upper - lower;
    double nearest = kLook * kLook;
    for (int t = 0; t < around_count_; ++t) {
        const MeshTriangle& triangle = mesh_->triangle(around_[t]);
        const double height[2] = {triangle.normal.dot(lower - triangle.corner[0]),
                                  triangle.normal.dot(upper - triangle.corner[0])};
        const double least = std::min(height[0], height[1]);
        if (least > 0 && least * least >= nearest)
            continue; // its whole plane is farther than another triangle
        for (const int end : {0, 1}) {
            const Vec3& at = end ? upper : lower;
            const OnTriangle on = closest_on_triangle(triangle.corner, triangle.normal, at);
            if (on.side < 0 && height[end] < 0 && height[end] > -thickness_ - kDeepest) return 0;
            nearest = std::min(nearest, (at - on.point).squaredNorm());
        }
        for (int side = 0; side < 3; ++side) {
            const Vec3 foot = triangle.corner[side], edge = triangle.corner[(side + 1) % 3] - foot;
            const ClosestShares shares = closest_shares(lower, along, foot, edge);
            const Vec3 off = lower + shares.first * along - foot - shares.second * edge;
            const bool within = off.dot(triangle.normal) <= 0 && off.dot(triangle.beyond[side]) <= 0;
            if (triangle.ridge[side] && within && off.norm() < kDeepest) return 0;
            nearest = std::min(nearest, off.squaredNorm());
        }
        if (height[0] * height[1] >= 0) continue;
        const Vec3 through = lower + height[0] / (height[0] - height[1]) * along;
        if (closest_on_triangle(triangle.corner, triangle.normal, through).side < 0) return 0;
    }
    return std::max(0.0, std::sqrt(nearest) - thickness_);
}

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
    bend_ = -1;
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
    if (bend_ < 0) return;
    edge_.surface_velocity = surface_velocity(body_->position + body_->attitude * edge_.foot);
    edge_.foot = body_->position + body_->attitude * edge_.foot;
    edge_.along = body_->attitude * edge_.along;
    edge_.out = body_->attitude * edge_.out;
    set_->add(edge_);
}

/// Keeps a ridge if the link lies round it, or may within the step, and none has bent it more.
void ObstacleContacts::lay_round(int i, const Point& lower, const Point& upper, const MeshTriangle& triangle,
                                 int side) {
    const Vec3 foot = triangle.corner[side], ridge = triangle.corner[(side + 1) % 3] - foot;
    const Vec3 link = upper.at - lower.at;
    const ClosestShares shares = closest_shares(lower.at, link, foot, ridge);
    if (shares.second <= 0 || shares.second >= 1) return;
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
    const double least =
        std::sqrt(0.5 * (1 + c)) * kFaceTolerance[0] - std::sqrt(0.5 * (1 - c)) * kFaceTolerance[1];
    if (way.turn > 0 && std::min(way.cosine_lower, way.cosine_upper) < least) return;
    if (way.turn <= bend_) return;
    bend_ = way.turn;
    edge_ = edge;
}

} // namespace windlass::physics
