#include "bench/methods/pbd_obstacles.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>

namespace windlass::lab {

namespace {

/// Within this distance a particle touches: m. It is stopped from there behind a face, too, lest rounding or
/// a face met by two others let it through.
constexpr double kTouch = 1e-3;

/// What rounding may leave of a way behind a face, m; and what faces overlap at their edges.
constexpr double kRounding = 1e-9;

/// Sharper edges (152 degrees turned) are cut off: tangent of half the turn.
constexpr double kSharpest = 4;

/// Turns after which a particle that is pushed from one face through another stops where it meets it.
constexpr int kMaxTurns = 4;

btVector3 bullet(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

/// Whether a point lies over the face, its edges moved outwards by beyond + prolonged where asked.
bool over_face(const PbdFace& face, const Vec3& at, bool prolonged) {
    if (face.plane) return true;
    for (int k = 0; k < 3; ++k)
        if (face.inwards[k].dot(at) < face.edge[k] - kRounding - (prolonged ? face.prolonged[k] : 0))
            return false;
    return true;
}

/// Share of the way at which the face as it stands off stops it; nothing when it does not.
std::optional<double> crossing(const PbdFace& face, const Vec3& from, const Vec3& to) {
    const double before = face.normal.dot(from) - face.offset, after = face.normal.dot(to) - face.offset;
    if (after >= -kRounding) return std::nullopt;
    const double depth = face.plane ? 1e300 : kTouch + std::max(0.0, face.standing_off);
    if (before >= -depth) {
        const double share = before > 0 ? before / (before - after) : 0;
        if (over_face(face, from + share * (to - from), true)) return share;
    }
    // What came past an edge is stopped by the face as it is drawn.
    const double drawn = before + face.standing_off;
    if (face.standing_off > 0 && drawn >= 0 && after + face.standing_off < 0) {
        const double share = drawn / (before - after);
        if (over_face(face, from + share * (to - from), false)) return share;
    }
    return std::nullopt;
}

bool touches(const PbdFace& face, const Vec3& at) {
    return std::abs(face.normal.dot(at) - face.offset) <= kTouch && over_face(face, at, true);
}

/// Moves a particle that is behind the face to it; of its way along the face friction takes as much as the
/// push allows.
void push_out(const PbdFace& face, const Vec3& from, Vec3& to, double gap) {
    to -= gap * face.normal;
    const Vec3 way = to - from;
    const Vec3 slip = way - way.dot(face.normal) * face.normal;
    const double max = -gap * face.friction, size = slip.norm();
    to -= size <= max ? slip : Vec3(max / size * slip);
}

template <class Visit>
struct Leaves final : btDbvt::ICollide {
    const Visit& visit;
    explicit Leaves(const Visit& one) : visit(one) {}
    void Process(const btDbvtNode* leaf) override { visit(leaf->dataAsInt); }
};

} // namespace

PbdObstacles::PbdObstacles(const std::vector<Obstacle>& obstacles, double rest_distance) {
    for (const Obstacle& obstacle : obstacles) {
        if (!obstacle.is_plane()) continue;
        PbdFace face;
        face.normal = obstacle.normal.normalized();
        face.standing_off = obstacle.material.thickness + rest_distance;
        face.offset = face.normal.dot(obstacle.point) + face.standing_off;
        face.friction = obstacle.material.friction;
        face.stickiness = obstacle.material.stickiness;
        faces_.push_back(face);
    }
    planes_ = faces_.size();
    for (const Obstacle& obstacle : obstacles)
        if (!obstacle.is_plane()) add_mesh(obstacle, rest_distance);
}

void PbdObstacles::add_mesh(const Obstacle& obstacle, double rest_distance) {
    const double off = obstacle.material.thickness + rest_distance;
    // Corners in one place are one, so that faces know their neighbours.
    std::map<std::array<double, 3>, int> numbers;
    std::vector<int> same;
    for (const Vec3& corner : obstacle.corners)
        same.push_back(
            numbers.try_emplace({corner.x(), corner.y(), corner.z()}, static_cast<int>(same.size()))
                .first->second);
    std::map<std::pair<int, int>, int> third; // of the triangle to the left of an edge, its other corner
    for (const auto& t : obstacle.triangles)
        for (int k = 0; k < 3; ++k)
            third[{same[t[k]], same[t[(k + 1) % 3]]}] = t[(k + 2) % 3];

    for (const auto& t : obstacle.triangles) {
        const std::array corners{obstacle.corners[t[0]], obstacle.corners[t[1]], obstacle.corners[t[2]]};
        PbdFace face;
        face.plane = false;
        face.normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
        face.standing_off = off;
        face.offset = face.normal.dot(corners[0]) + off;
        face.friction = obstacle.material.friction;
        face.stickiness = obstacle.material.stickiness;
        double max = 0;
        for (int k = 0; k < 3; ++k) {
            const Vec3 &from = corners[k], &to = corners[(k + 1) % 3];
            face.inwards[k] = face.normal.cross(to - from).normalized();
            face.edge[k] = face.inwards[k].dot(from);
            const auto beyond = third.find({same[t[(k + 1) % 3]], same[t[k]]});
            if (beyond == third.end()) continue;
            const Vec3& other = obstacle.corners[beyond->second];
            const Vec3 neighbour = (from - to).cross(other - to).normalized();
            const bool valley = face.normal.dot(other - from) > 0;
            if (valley != (off < 0)) continue;
            const double cosine = std::clamp(face.normal.dot(neighbour), -1.0, 1.0);
            const double tangent = std::sqrt((1 - cosine) / std::max(1e-12, 1 + cosine));
            face.prolonged[k] = std::abs(off) * std::min(kSharpest, tangent);
            max = std::max(max, face.prolonged[k]);
        }
        const Vec3 room = Vec3::Constant(std::abs(off) + 2 * max + kTouch);
        const Vec3 low = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]) - room;
        const Vec3 high = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]) + room;
        const auto number = static_cast<std::intptr_t>(faces_.size());
        tree_.insert(btDbvtVolume::FromMM(bullet(low), bullet(high)), reinterpret_cast<void*>(number));
        faces_.push_back(face);
    }
    tree_.optimizeTopDown();
}

/// Visits all planes, and the faces whose boxes the box of the way meets.
template <class Visit>
void PbdObstacles::near(const Vec3& from, const Vec3& to, const Visit& visit) const {
    for (std::size_t k = 0; k < planes_; ++k)
        visit(static_cast<int>(k));
    if (tree_.m_root == nullptr) return;
    const btDbvtVolume way = btDbvtVolume::FromMM(bullet(from.cwiseMin(to)), bullet(from.cwiseMax(to)));
    if (!Intersect(tree_.m_root->volume, way)) return;
    Leaves<Visit> leaves(visit);
    tree_.collideTV(tree_.m_root, way, leaves);
}

void PbdObstacles::find(const Field& from, const Field& to, const std::vector<double>& inverse_mass,
                        double dt, std::vector<PbdContact>& contacts) const {
    contacts.clear();
    for (int i = 0; i < from.size(); ++i) {
        if (inverse_mass[i] == 0) continue;
        const Vec3 start = from.at(i), end = to.at(i);
        double first = 2;
        int face = -1;
        near(start, end, [&](int k) {
            const PbdFace& one = faces_[k];
            const std::optional<double> share = crossing(one, start, end);
            const double hold = one.stickiness * dt * dt;
            if (share && *share > 0 && *share < first) first = *share, face = k;
            if ((share && *share == 0) || (one.stickiness > 0 && touches(one, start)))
                contacts.push_back({i, k, touches(one, start) ? hold : 0});
        });
        if (face >= 0) contacts.push_back({i, face, 0});
    }
}

void PbdObstacles::project(std::vector<PbdContact>& contacts, const Field& from, Field& to) const {
    for (PbdContact& contact : contacts) {
        const PbdFace& face = faces_[contact.face];
        Vec3 place = to.at(contact.particle);
        const double gap = face.normal.dot(place) - face.offset;
        if (gap < 0) {
            push_out(face, from.at(contact.particle), place, gap);
        } else if (contact.hold > 0) {
            const double back = std::min(gap, contact.hold);
            contact.hold -= back;
            place -= back * face.normal;
        }
        to.set(contact.particle, place);
    }
}

std::optional<std::pair<double, int>> PbdObstacles::first_hit(const Vec3& from, const Vec3& to) const {
    std::optional<std::pair<double, int>> first;
    near(from, to, [&](int k) {
        const std::optional<double> share = crossing(faces_[k], from, to);
        if (share && (!first || *share < first->first)) first = {*share, k};
    });
    return first;
}

void PbdObstacles::guard(const Field& from, Field& to, const std::vector<double>& inverse_mass) const {
    for (int i = 0; i < from.size(); ++i) {
        if (inverse_mass[i] == 0) continue;
        const Vec3 start = from.at(i);
        Vec3 end = to.at(i);
        auto hit = first_hit(start, end);
        if (!hit) continue;
        for (int turn = 0; hit && turn < kMaxTurns; ++turn) {
            const PbdFace& face = faces_[hit->second];
            push_out(face, start, end, face.normal.dot(end) - face.offset);
            hit = first_hit(start, end);
        }
        if (hit) end = start + hit->first * (end - start);
        to.set(i, end);
    }
}

} // namespace windlass::lab
