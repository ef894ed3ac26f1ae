#pragma once
// Contact of the chain: what touches a node or a link, and how that enters the step.
//
// A contact is a spring, a damper and friction, each as the coefficient of an implicit step. One with an
// obstacle (hull, lip, ground) adds to the effective mass of the node, so that W and p* already know it when
// the links are solved, and bears or lets go with that solve (ContactSet::revise): the load in a taut chain
// and what holds it aside are found together, and neither depends on the step or on a number of iterations.
// A contact of chain with chain ties nodes that may lie far apart along the chain, which a matrix of three
// diagonals cannot hold: it enters p* alone, as equal and opposite impulses, implicit in the free motion
// (PairContacts). So does one of the chain with its anchor.

#include "server/physics/chain/chain.hpp"
#include "server/physics/chain/chain_forces.hpp"
#include "server/physics/chain/step_time.hpp"
#include "server/physics/contact/link_wrap.hpp"
#include "server/physics/contact/pair_contacts.hpp"

#include <cstdint>

namespace windlass::physics {

/// One node against an obstacle.
struct NodeContact {
    int node = 0;                         ///< 0 < node < links
    int touch = 0;                        ///< contacts of one touch (the two ends of a link) hold or let go
                                          ///< together; numbered from ContactSet::new_touch()
    Vec3 normal = Vec3::UnitZ();          ///< unit vector out of the obstacle
    double penetration = 0;               ///< m at the start of the step; negative: the gap still to close
    double stiffness = 0;                 ///< N/m
    double damping = 0;                   ///< N s/m along the normal
    double friction = 0;                  ///< Coulomb's coefficient
    double adhesion = 0;                  ///< N that it pulls back with before it lets go
    Vec3 surface_velocity = Vec3::Zero(); ///< m/s
};

/// What the obstacles did to the chain in a step.
struct ContactLoad {
    Vec3 impulse = Vec3::Zero(); ///< N s on the chain
    Vec3 moment = Vec3::Zero();  ///< N m s about the world's origin
    double work = 0;             ///< J taken from the chain: friction, impact, and what springs store
    int borne = 0;               ///< node contacts and edges that carried

    ContactLoad& operator+=(const ContactLoad& other) {
        impulse += other.impulse, moment += other.moment;
        work += other.work, borne += other.borne;
        return *this;
    }
};

/// The contacts of one step. Fixed capacity, no memory taken after the constructor. Use in each step:
/// clear(), the finders add(), the solver enters and revises, settle().
class ContactSet {
public:
    /// Most contacts of each kind; what does not fit is dropped (and counted).
    ContactSet(int node_contacts, int pair_contacts);

    void clear();
    bool empty() const { return contacts_.empty() && ties_.empty() && wraps_.empty(); }
    int new_touch() { return touches_++; }
    void add(const NodeContact& contact);
    void add(const PairContact& contact);
    void add(const Edge& edge);
    PairContacts& ties() { return ties_; } ///< contacts of the chain with itself and its anchor
    LinkWraps& wraps() { return wraps_; }  ///< links round edges, part of the links' own solution
    const LinkWraps& wraps() const { return wraps_; }
    const std::vector<NodeContact>& node_contacts() const { return contacts_; }
    const std::vector<PairContact>& pair_contacts() const { return ties_.all(); }
    void drop(int count) { dropped_ += count; } ///< contacts that a finder had no place for
    int dropped() const { return dropped_; }    ///< since clear()

    /// Puts the contacts into W and p* of a step. state: its start. Nodes that are asleep or held stay so.
    /// anchor: at the chain's lower end; may be null where no contact is with it.
    void enter(const ChainState& state, const StepTime& time, SymmetricField& inverse_mass, Field& predicted,
               const AnchorEnd* anchor = nullptr);

    /// Looks at a solution: contacts that would pull let go, those that are driven in now bear. True when W
    /// and p* changed and the links must be solved again.
    bool revise(const Field& placed, SymmetricField& inverse_mass, Field& predicted);

    /// Whether it stopped looking at solutions while contacts would still let go or begin to bear, or while
    /// impulses between pairs had not come to rest.
    bool unsettled(const Field& placed);

    /// Takes what the contacts made of W and p* out of them, so that something else may change there, and
    /// puts it in again.
    void take_off(SymmetricField& inverse_mass, Field& predicted) const;
    void put_on(SymmetricField& inverse_mass, Field& predicted);

    /// What contacts with the anchor's body gave it, as a change of its motion; the shackle has moved with
    /// it.
    const Vector7& pushed_anchor() const { return ties_.pushed(0); }

    /// After the step: what the contacts did to the chain, given where it is now. anchor: its motion now.
    ContactLoad settle(const ChainState& state, const Vector7& anchor = Vector7::Zero()) const;

private:
    struct Node { ///< a node that something touches, as it is without contact
        int index = 0;
        SymmetricMatrix inverse_mass;
        Vec3 position, velocity, predicted;
        explicit Node(int node) : index(node) { position.setZero(), velocity.setZero(), predicted.setZero(); }
    };
    struct Bearing {             ///< a node contact as coefficients of the step
        int node;                ///< in nodes_
        double normal, friction; ///< N s/m
        double push;             ///< N s, of the spring at rest
        double min;              ///< N s, below which it lets go
    };
    void gather_nodes();
    int place_of(int node) const;
    void prepare_bearing(std::size_t k);
    void apply(SymmetricField& inverse_mass, Field& predicted);
    double reaction(std::size_t k, const Vec3& velocity) const;
    void react(const Field& placed);
    Vec3 velocity(const Node& node, const Field& placed) const;

    StepTime time_;
    int touches_ = 0, dropped_ = 0;
    std::vector<NodeContact> contacts_;
    PairContacts ties_;
    LinkWraps wraps_;
    std::vector<int> touched_; // nodes of all contacts, some more than once
    std::vector<Node> nodes_;
    std::vector<Bearing> bearings_;
    std::vector<double> reactions_;   ///< N s, per touch
    std::vector<double> minima_;      ///< N s, per touch
    std::vector<std::uint8_t> borne_; ///< per touch
    int revisions_ = 0;
};

} // namespace windlass::physics
