// Which links are looked at: those that may have come to the body since they were found clear of it.

#include "server/physics/contact/obstacle_contact.hpp"

#include "server/physics/base/closest.hpp"
#include "server/physics/base/vectorise.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace windlass::physics {

namespace {

constexpr int kMaxTriangles = 256; ///< of a mesh near one link

/// A link is found clear of a body by no more than this, m.
constexpr double kLook = 1.2;

/// A link so near a body that it would soon be due again is looked at for so many steps without asking how
/// far it is clear, which costs as much as looking.
constexpr int kPause = 10;

/// Links that are told apart from the body's box together; with them one node more, which fills the lanes.
constexpr int kLinksAtOnce = 15;

} // namespace

ObstacleContacts::ObstacleContacts(int capacity)
    : around_(kMaxTriangles),
      triangles_(kMaxTriangles),
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
    int first = chain.asleep, beyond = chain.asleep + (chain.links - chain.asleep) % kLinksAtOnce;
    for (; first < chain.links; first = beyond, beyond += kLinksAtOnce)
        if (any_near(middle, half, first, beyond)) look_at_due(first, beyond - 1);
}

/// Whether any of these nodes comes into a box in this step.
bool ObstacleContacts::any_near(const Vec3& middle, const Vec3& half, int first, int last) const {
    const Field &x = chain_->position, &v = chain_->velocity;
    const Vec3 speed = body_->velocity;
    const double dt = dt_;
    std::int64_t near = 0;
    WINDLASS_VECTORISE
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
    WINDLASS_VECTORISE
    for (int i = first; i <= last + 1; ++i) {
        const Vec3 arm = chain_->position.at(i) - origin;
        at_.set(i, into * arm);
        way_.set(i, dt * (chain_->velocity.at(i) - speed - spin.cross(arm)));
    }
    std::int64_t count = 0;
    WINDLASS_VECTORISE
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
        return around_count_ < kMaxTriangles; // else there may be more
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
        const double min = std::min(height[0], height[1]);
        if (min > 0 && min * min >= nearest) continue; // its whole plane is farther than another triangle
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

} // namespace windlass::physics
