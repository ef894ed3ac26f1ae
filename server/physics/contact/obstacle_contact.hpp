#pragma once
// Finds where the chain meets a solid body, ahead of the step: nodes against its faces, ridges and corners
// along the way they are about to go, and links lying round its ridges.

#include "server/physics/contact/contact.hpp"
#include "server/physics/contact/obstacle_mesh.hpp"

#include <Eigen/Geometry>

namespace windlass::physics {

/// How chain bears on a surface.
struct ContactMaterial {
    double stiffness = 3e7; ///< N/m of one touch; a meganewton dents a tenth of a link's width
    double friction = 0.3;  ///< Coulomb's coefficient; wet steel on painted steel
    double adhesion = 0;    ///< N per metre of chain
};

/// A rigid body's place and motion at the start of the step.
struct BodyMotion {
    Vec3 position = Vec3::Zero(); ///< m, world, of the body frame's origin
    Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();
    Vec3 velocity = Vec3::Zero(); ///< m/s, of the origin
    Vec3 spin = Vec3::Zero();     ///< rad/s, world
};

/// Finds the contacts of one step with one body. A link that has been found clear of it is left alone until
/// it has gone as far as it was clear. What is found does not depend on when it was looked for: this holds
/// memory to work in only.
class ObstacleContacts {
public:
    /// capacity: most links.
    explicit ObstacleContacts(int capacity);

    /// Adds to set what a chain touches, or is about to, in a step of dt (s). A link is as thick as half its
    /// width on either hand (ChainDef::contact_diameter). Continuous: a node is followed along its way by
    /// quarters of a link's width, so that it does not pass through however fast it goes. foot: whether the
    /// lowest node, too, is looked at; it may be an anchor's.
    void find(const ChainDef& def, const ChainState& chain, double dt, const ObstacleMesh& mesh,
              const BodyMotion& body, const ContactMaterial& material, ContactSet& set, bool foot = false);

private:
    /// A node or link deeper inside a body than this (m) is not pushed out: it came there in another way.
    static constexpr double kDeepest = 0.6;

    struct Point {    ///< of the chain, in the body's frame
        Vec3 at, way; ///< m, and m in this step
    };
    struct Support {
        Vec3 normal; ///< body frame
        double penetration;
    };
    struct Ridge {
        Edge edge;           ///< body frame
        Vec3 a, b;           ///< normals of its two faces
        double size = 0;     ///< m, from foot to end
        double way = 0;      ///< m, a link's round it; more where that is none
        bool passed = false; ///< the link goes straight past it, and will within the step
        double depth(const Vec3& place) const;
        bool leaves_out(const Ridge& other) const;
    };
    // Which links are looked at (obstacle_contact.cpp):
    bool any_near(const Eigen::Vector3d& middle, const Eigen::Vector3d& half, int first, int last) const;
    void look_at_due(int first, int last);
    void look_at(int link);
    int meeting(const Vec3& low, const Vec3& high);
    double clearance(int link) const;
    // What nodes touch (obstacle_touch.cpp):
    Point node_at(int i) const;
    void find_node(int i);
    void meet(const MeshTriangle& triangle, const Vec3& start, const Vec3& at);
    void leave_by_nearest_face(const Point& node);
    void keep(const Vec3& normal, double penetration);
    Vec3 surface_velocity(const Vec3& at) const;
    NodeContact contact(int node, int touch, const Support& support, double share, const Vec3& at) const;
    // What links lie round (obstacle_ridges.cpp):
    void find_link(int i);
    void lay_round(int i, const Point& lower, const Point& upper, const MeshTriangle& triangle, int side);
    const Ridge& least_way_round() const;

    // Of the step under way:
    const ChainDef* def_ = nullptr;
    const ChainState* chain_ = nullptr;
    const ObstacleMesh* mesh_ = nullptr;
    const BodyMotion* body_ = nullptr;
    const ContactMaterial* material_ = nullptr;
    ContactSet* set_ = nullptr;
    double dt_ = 0, thickness_ = 0;
    bool foot_ = false;
    std::vector<int> around_;    ///< triangles of the mesh within kLook of the link that is looked at
    int around_count_ = 0;       ///< of them
    std::vector<int> triangles_; ///< those that what is looked at may meet
    std::array<Support, 3> supports_;
    int supported_ = 0;
    std::array<Ridge, 8> ridges_; ///< that a link lies round or near; more are left alone
    int ridges_found_ = 0;
    bool behind_ = false; ///< the node is behind some triangle, perhaps inside the body

    // Of links that were looked at:
    const ObstacleMesh* marked_ = nullptr; ///< the body they were
    std::vector<double> clear_;            ///< m, from the body's surface; 0: nothing is known
    std::vector<int> pause_;               ///< steps in which it will not be asked how far a link is clear
    Field lower_, upper_;                  ///< m, body frame, where its nodes were
    // Of links that are looked at now:
    Field at_, way_; ///< m, body frame, of nodes
    std::vector<double> due_;
};

} // namespace windlass::physics
