#include "server/physics/anchor/hull_touches.hpp"

#include "server/physics/anchor/anchor.hpp"
#include "server/physics/base/closest.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace windlass::physics {

namespace {

constexpr int kMaxTriangles = 256, kMaxTouches = 96;

/// A point deeper inside the ship than this (m) is not pushed out: it came there in another way.
constexpr double kDeepest = 0.6;

/// m, so much further than touches are it is looked to know how far the anchor may go until the next look.
constexpr double kAhead = 1.0;
/// m: so near it may touch before a long step ends. Told by a look alone, which is made with a little to
/// spare: neither where it was last looked at nor rounding decides it.
constexpr double kNear = 0.25, kRounding = 1e-6;
/// Looks without that after one that found the anchor too near: it will be so for a while.
constexpr int kLooksNearby = 30;

/// Damping of a touch, of critical for the whole anchor: steel on plating comes back with a sixth of its
/// speed. Tuned.
constexpr double kDamping = 0.5;

/// The push of a ridge on a box may lead so far (cosine and sine of 0.2 rad) beyond the normals of its faces.
constexpr double kCosBeyond = 0.98006658, kSinBeyond = 0.19866933;

/// A point of space and the nearest of a surface.
struct Nearest {
    Vec3 normal;     ///< out of the body
    double distance; ///< m; negative: inside
};

/// The nearest of the given triangles; those that share the nearest edge have the same distance, and the
/// point is outside if it is in front of any.
Nearest nearest_of(const ObstacleMesh& mesh, const std::vector<int>& triangles, const Vec3& p) {
    double min = 1e300, front = -1e300;
    Vec3 away = Vec3::Zero(), normal = Vec3::UnitZ();
    for (const int t : triangles) {
        const MeshTriangle& triangle = mesh.triangle(t);
        const double height = triangle.normal.dot(p - triangle.corner[0]);
        if (height * height > min * (1 + 1e-9)) continue;
        const OnTriangle on = closest_on_triangle(triangle.corner, triangle.normal, p);
        const double square = (p - on.point).squaredNorm();
        if (square > min * (1 + 1e-9) || (square > min * (1 - 1e-9) && height <= front)) continue;
        min = square, front = height;
        away = p - on.point, normal = triangle.normal;
    }
    const double distance = std::sqrt(min);
    if (front < 0) return {normal, -distance};
    return {distance > 1e-9 ? Vec3(away / distance) : normal, distance};
}

} // namespace

HullTouches::HullTouches() {
    triangles_.resize(kMaxTriangles);
    near_.reserve(kMaxTriangles);
    touches_.reserve(kMaxTouches);
    bearings_.reserve(kMaxTouches);
}

void HullTouches::find(const Anchor& anchor, double dt, const HullSurface& hull) {
    touches_.clear();
    bearings_.clear();
    triangles_.clear();
    near_ship_ = false;
    if (hull.mesh == nullptr) return;
    anchor_ = &anchor, hull_ = &hull, dt_ = dt;
    const AnchorPose pose = anchor.pose();
    const BodyMotion& ship = hull.motion;
    const Eigen::Quaterniond into = ship.attitude.conjugate();
    const Vec3 centre = into * (pose.position - ship.position);
    const double fast = (pose.velocity - ship.velocity).norm() + ship.spin.norm() * centre.norm() +
                        (pose.spin.norm() + std::abs(anchor.fluke_rate())) * anchor.reach();
    room_ = 0.01 + dt * fast; // and what a step adds to the speed
    const AnchorPlace place{centre, into * pose.attitude, anchor.fluke_angle()};
    if (drift_.clear(place, anchor.reach()) > std::max(room_, kNear)) return;
    material_ = hull.material;
    damping_ = 2 * kDamping * std::sqrt(material_.stiffness * anchor.mass());
    before_ << anchor.motion(), anchor.fluke_rate();
    if (looks_nearby_ > 0) {
        --looks_nearby_;
    } else {
        look(centre, kAhead);
        drift_.mark(place, full() ? 0 : clear_);
        if (drift_.clear(place, anchor.reach()) > std::max(2 * room_, kNear)) return;
        looks_nearby_ = kLooksNearby;
    }
    look(centre, kNear);
    near_ship_ = full() || clear_ < kNear - kRounding;
}

/// Finds the touches, and how clear the anchor is of any. centre: m, of its mass, in the ship's frame. ahead:
/// m, looked further than touches are: how clear it is, is told up to that.
void HullTouches::look(const Vec3& centre, double ahead) {
    touches_.clear();
    // Whether a point is inside is told by what is nearest to it: everything so near is looked at. From where
    // nothing is so near, a point that is inside touches when it has come within kDeepest.
    const double far = std::max(room_, kDeepest) + ahead;
    clear_ = far - kDeepest;
    const Vec3 reach = Vec3::Constant(anchor_->reach() + far);
    triangles_.resize(kMaxTriangles);
    triangles_.resize(hull_->mesh->near(centre - reach, centre + reach, triangles_));
    if (triangles_.empty()) return;
    const BodyMotion& ship = hull_->motion;
    const bool shank_in_pipe = hull_->pipe != nullptr && find_in_pipe(*hull_->pipe);
    const Eigen::Matrix3d into = ship.attitude.conjugate().toRotationMatrix();
    for (int k = shank_in_pipe ? 1 : 0; k < anchor_->boxes(); ++k) {
        AnchorBox box = anchor_->box(k); // in the ship's frame
        box.centre = into * (box.centre - ship.position);
        box.axes = into * box.axes;
        const double radius = box.half.norm() + far;
        near_.clear();
        for (const int t : triangles_) {
            const MeshTriangle& triangle = hull_->mesh->triangle(t);
            if (std::abs(triangle.normal.dot(box.centre - triangle.corner[0])) < radius &&
                ((triangle.low - box.centre).array() < radius).all() &&
                ((box.centre - triangle.high).array() < radius).all())
                near_.push_back(t);
        }
        if (near_.empty()) continue;
        find_corners(box);
        find_ridges(box);
    }
}

/// Keeps a touch (all in the ship's frame) that is there, or will be within the step.
void HullTouches::look_at(bool fluke, const Vec3& point, const Vec3& normal, double penetration) {
    if (penetration > kDeepest || touches_.size() == touches_.capacity()) return;
    const BodyMotion& ship = hull_->motion;
    const Vec3 at = ship.attitude * point, world = ship.position + at;
    const HullTouch touch{.at = anchor_->point(world, fluke),
                          .normal = ship.attitude * normal,
                          .penetration = penetration,
                          .surface_velocity = ship.velocity + ship.spin.cross(at)};
    const double rising = touch.normal.dot(point_velocity(touch.at, before_) - touch.surface_velocity);
    if (penetration > dt_ * rising) touches_.push_back(touch);
}

/// The shank's end in bore or funnel, and the shank where it crosses the edges of both. True while its end is
/// in the mouth or further up: there the shank meets no plating.
bool HullTouches::find_in_pipe(const HawsePipe& pipe) {
    const BodyMotion& ship = hull_->motion;
    const Vec3 end = ship.attitude.conjugate() * (anchor_->shackle() - ship.position) - pipe.mouth;
    const Vec3 foot = ship.attitude.conjugate() * (anchor_->pin() - ship.position) - pipe.mouth;
    const double inboard = pipe.bore.dot(end), from = pipe.bore.dot(foot);
    const Vec3 off = end - inboard * pipe.bore;
    const double outside = std::max({-pipe.funnel - inboard, 0.5 * (from - inboard),
                                     off.norm() - (pipe.room + 2 * pipe.funnel)}); // m to go until it is in
    clear_ = std::min(clear_, outside);
    if (outside > 0) return false;
    const auto keep_off = [&](const Vec3& point, Vec3 outwards, double room, const Vec3& clear_of) {
        const double distance = outwards.norm();
        if (distance < 1e-6) return;
        outwards /= distance;
        const Vec3 normal = (clear_of * clear_of.dot(outwards) - outwards).normalized();
        look_at(false, pipe.mouth + point, normal, (room - distance) * normal.dot(outwards));
    };
    if (inboard > 0) {
        const bool in_funnel = inboard < pipe.funnel;
        // The funnel's wall leans outwards by 45 degrees.
        const Vec3 along = (pipe.bore - off.normalized()).normalized();
        keep_off(end, off, pipe.room + (in_funnel ? pipe.funnel - inboard : 0),
                 in_funnel ? along : pipe.bore);
    }
    const Vec3 shank = (end - foot).normalized();
    for (const double edge : {0.0, pipe.funnel}) {
        if (inboard < edge || from > edge) continue;
        const Vec3 crossing = foot + (end - foot) * ((edge - from) / (inboard - from));
        keep_off(crossing, crossing - edge * pipe.bore, pipe.room + pipe.funnel - edge, shank);
    }
    return true;
}

void HullTouches::find_corners(const AnchorBox& box) {
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
        const Vec3 point = box.centre + box.axes * box.half.cwiseProduct(sign);
        const Nearest nearest = nearest_of(*hull_->mesh, near_, point);
        const double inside = -nearest.distance;
        clear_ = std::min(clear_, inside > 0 ? inside - kDeepest : nearest.distance);
        if (nearest.distance < room_) look_at(box.fluke, point, nearest.normal, -nearest.distance);
    }
}

/// A ridge pushes between the normals of its two faces, or it is not that ridge which the box meets.
void HullTouches::find_ridges(const AnchorBox& box) {
    for (const int t : near_) {
        const MeshTriangle& triangle = hull_->mesh->triangle(t);
        for (int side = 0; side < 3; ++side) {
            if (!triangle.ridge[side] || !triangle.own_side[side]) continue;
            const Vec3 foot = triangle.corner[side], ridge = triangle.corner[(side + 1) % 3] - foot;
            const OnBox on = closest_on_box(box.axes.transpose() * (foot - box.centre),
                                            box.axes.transpose() * ridge, box.half);
            clear_ = std::min(clear_, on.distance);
            if (on.distance > room_) continue;
            const Vec3 push = -(box.axes * on.normal), between = triangle.normal + triangle.beyond[side];
            const double cosine = 0.5 * between.norm(), sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
            if (push.dot(between) < 2 * cosine * (cosine * kCosBeyond - sine * kSinBeyond)) continue;
            look_at(box.fluke, box.centre + box.axes * on.point, push, -on.distance);
        }
    }
}

void HullTouches::enter(const StepTime& time, const Vector7& before, Matrix7& mass, Vector7& momentum) {
    bearings_.clear();
    turns_flukes_ = 0;
    for (std::size_t k = 0; k < touches_.size(); ++k) {
        const HullTouch& touch = touches_[k];
        const Vec3 sliding = point_velocity(touch.at, before) - touch.surface_velocity;
        const double rising = touch.normal.dot(sliding), sunk = std::max(0.0, touch.penetration);
        // A gap is closed without damping: a damper would act before they touch.
        const double damping = touch.penetration > 0 ? damping_ : 0;
        const Bearing b{.touch = static_cast<int>(k),
                        .normal = time.kick * (damping + time.dt * material_.stiffness),
                        .friction = time.kick * material_.friction * material_.stiffness * sunk /
                                    std::max((sliding - rising * touch.normal).norm(), kFrictionCreep),
                        .push = time.kick * material_.stiffness * touch.penetration};
        const double reaction = b.push - b.normal * rising;
        if (reaction <= 0) continue;
        bearings_.push_back(b);
        Eigen::Matrix<double, 3, 7> at;
        at << point_motion(touch.at.arm), touch.at.lever;
        const Eigen::Matrix<double, 1, 7> out = touch.normal.transpose() * at;
        const Eigen::Matrix<double, 3, 7> along = at - touch.normal * out;
        mass += b.normal * out.transpose() * out + b.friction * along.transpose() * along;
        momentum += (b.push + b.normal * touch.normal.dot(touch.surface_velocity)) * out.transpose() +
                    b.friction * along.transpose() * touch.surface_velocity;
        turns_flukes_ += reaction * out[6];
    }
}

/// N s that a touch gave the anchor.
Vec3 HullTouches::impulse(const Bearing& bearing, const Vector7& after) const {
    const HullTouch& touch = touches_[bearing.touch];
    const Vec3 sliding = point_velocity(touch.at, after) - touch.surface_velocity;
    const double rising = touch.normal.dot(sliding);
    return (bearing.push - bearing.normal * rising) * touch.normal -
           bearing.friction * (sliding - rising * touch.normal);
}

ContactLoad HullTouches::settle(const Vec3& position, const Vector7& before, const Vector7& after) const {
    assert((empty() || anchor_ != nullptr) && "find() comes first");
    ContactLoad load;
    load.borne = static_cast<int>(bearings_.size());
    for (const Bearing& b : bearings_) {
        const HullTouch& touch = touches_[b.touch];
        const Vec3 given = impulse(b, after);
        load.impulse += given;
        load.moment += (position + touch.at.arm).cross(given);
        load.work -= given.dot(point_velocity(touch.at, 0.5 * (before + after)));
    }
    return load;
}

double HullTouches::work_on_flukes(const Vector7& before, const Vector7& after) const {
    double work = 0;
    for (const Bearing& b : bearings_)
        work += impulse(b, after).dot(touches_[b.touch].at.lever) * 0.5 * (before[6] + after[6]);
    return work;
}

} // namespace windlass::physics
