#pragma once
// The anchor against the ship: corners of its boxes on the plating, ridges of the hull (stem) on its boxes,
// its shank in the hawse pipe.
//
// Each touch is a spring, a damper and friction, implicit in the anchor's own motion, that of its flukes
// included: it adds to the resistance with which the chain's solve meets the anchor, so that the load in the
// chain and what holds the anchor off the ship are found together, and no energy is made.

#include "server/physics/anchor/anchor_drift.hpp"
#include "server/physics/contact/anchor_point.hpp"
#include "server/physics/contact/contact.hpp"
#include "server/physics/ship/hull_surface.hpp"

#include <vector>

namespace windlass::physics {

class Anchor;
struct AnchorBox;

/// A point of the anchor against the ship.
struct HullTouch {
    AnchorPoint at{};
    Vec3 normal = Vec3::UnitZ();          ///< unit vector out of the ship
    double penetration = 0;               ///< m at the start of the step; negative: the gap
    Vec3 surface_velocity = Vec3::Zero(); ///< m/s, of the ship there
};

/// The touches of one step: find(), enter(), settle(). Keeps from step to step memory to work in, and how far
/// the anchor was clear of the ship: nothing that decides what is found. Of one ship and one anchor.
class HullTouches {
public:
    HullTouches();

    /// Where the anchor touches the hull, or will in a step of dt (s). An anchor that was found clear is left
    /// alone until it has gone as far as it was clear.
    void find(const Anchor& anchor, double dt, const HullSurface& hull);
    bool empty() const { return touches_.empty(); }
    /// Whether it was within a quarter of a metre of the ship at the start of the step.
    bool near_ship() const { return near_ship_; }
    /// Whether there may be more than it has places for.
    bool full() const {
        return touches_.size() == touches_.capacity() || triangles_.size() == triangles_.capacity();
    }

    /// Adds what the touches resist and push to the anchor's mass (kg, kg m, kg m2) and momentum (N s, N m s)
    /// in the step. before: its motion at the start, by which is decided which of them bear.
    void enter(const StepTime& time, const Vector7& before, Matrix7& mass, Vector7& momentum);

    /// N m s that springs and dampers would turn the flukes with, at the motion at the start.
    double turns_flukes() const { return turns_flukes_; }

    /// What the ship did to the anchor, given its motion before and after the step. position: m, world, of
    /// its centre of mass at the start.
    ContactLoad settle(const Vec3& position, const Vector7& before, const Vector7& after) const;
    /// J, of what it did, the part that turned the flukes on their pin.
    double work_on_flukes(const Vector7& before, const Vector7& after) const;

private:
    /// A touch as coefficients of the step.
    struct Bearing {
        int touch;               ///< in touches_
        double normal, friction; ///< N s/m, times the kick
        double push;             ///< N s, of the spring at rest
    };
    Vec3 impulse(const Bearing& bearing, const Vector7& after) const;
    void look(const Vec3& centre, double ahead);
    void find_corners(const AnchorBox& box);
    void find_ridges(const AnchorBox& box);
    bool find_in_pipe(const HawsePipe& pipe);
    void look_at(bool fluke, const Vec3& point, const Vec3& normal, double penetration);

    // Of the step under way:
    const Anchor* anchor_ = nullptr;
    const HullSurface* hull_ = nullptr;
    double dt_ = 0, room_ = 0; ///< s; m, that anything of the anchor may come nearer in the step
    double damping_ = 0;       ///< N s/m
    ContactMaterial material_;
    Vector7 before_ = Vector7::Zero(); ///< motion of the anchor
    std::vector<int> triangles_;       ///< near the anchor
    std::vector<int> near_;            ///< of them, near one box
    std::vector<HullTouch> touches_;
    std::vector<Bearing> bearings_; ///< those that bear
    double turns_flukes_ = 0;
    bool near_ship_ = false;
    double clear_ = 0; ///< m, that every point of the anchor can go until it touches; found by look()

    AnchorDrift drift_;
    int looks_nearby_ = 0; ///< that are not to ask how far it is clear
};

} // namespace windlass::physics
