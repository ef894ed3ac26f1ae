#pragma once
// Particles against planes and triangle meshes, found by continuous detection on the way of the step.
// Sources: Mueller and others (2007), section 3.4 (collision constraints from the way of the particle, held
// for the step); Macklin, Mueller, Chentanez, Kim (2014), "Unified particle physics for real-time
// applications", ACM TOG 33(4), equation 24, for friction in positions. Thickness, rest distance, friction
// and stickiness as in Jiang, Ren, He (2020), doi 10.1371/journal.pone.0237563.
//
// A surface stands off by its thickness and the particles' rest distance together; a mesh's faces stand off
// one by one and are prolonged until they meet again over its edges (mitred), so that no gap opens. An open
// edge stands off nowhere to its side.

#include "bench/methods/lumped_line.hpp"
#include "bench/problem/obstacle.hpp"

#include <BulletCollision/BroadphaseCollision/btDbvt.h>

#include <optional>

namespace windlass::lab {

/// A surface where it stops particles.
struct PbdFace {
    Vec3 normal = Vec3::UnitZ();
    double offset = 0;       ///< m, of the surface as it stops along the normal from the world's origin
    double standing_off = 0; ///< m, of it before what is drawn
    bool plane = true;       ///< no edges, solid however deep
    /// Unit vectors in the face, square to each edge.
    std::array<Vec3, 3> inwards{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
    std::array<double, 3> edge{};      ///< m, where each edge is along them
    std::array<double, 3> prolonged{}; ///< m, by which the standing-off face goes beyond each edge
    double friction = 0, stickiness = 0;
};

/// A particle that a face stops or holds back in this step.
struct PbdContact {
    int particle = 0, face = 0;
    double hold = 0; ///< m, by which stickiness may still pull it back in this step
};

/// All surfaces, ready to be asked.
class PbdObstacles {
public:
    PbdObstacles(const std::vector<Obstacle>& obstacles, double rest_distance);
    PbdObstacles(const PbdObstacles&) = delete;
    PbdObstacles& operator=(const PbdObstacles&) = delete;

    bool empty() const { return planes_ == 0 && faces_.empty(); }

    /// Contacts of the particles that move (inverse mass above 0) on their straight ways, in a step of dt
    /// (s).
    void find(const Field& from, const Field& to, const std::vector<double>& inverse_mass, double dt,
              std::vector<PbdContact>& contacts) const;

    /// Puts the particles of the contacts back onto the right side, with friction and stickiness.
    void project(std::vector<PbdContact>& contacts, const Field& from, Field& to) const;

    /// At the end of the step: whatever the other constraints did, no way leads through a surface.
    void guard(const Field& from, Field& to, const std::vector<double>& inverse_mass) const;

private:
    void add_mesh(const Obstacle& obstacle, double rest_distance);
    template <class Visit>
    void near(const Vec3& from, const Vec3& to, const Visit& visit) const;
    std::optional<std::pair<double, int>> first_hit(const Vec3& from, const Vec3& to) const;

    std::vector<PbdFace> faces_; ///< planes first
    std::size_t planes_ = 0;
    btDbvt tree_;
};

} // namespace windlass::lab
