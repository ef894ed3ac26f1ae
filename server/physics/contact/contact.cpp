#include "server/physics/contact/contact.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace windlass::physics {

namespace {

/// Times in a step that contacts may change their mind; then they stay as they are.
constexpr int kMaxRevisions = 4;

} // namespace

ContactSet::ContactSet(int node_contacts, int pair_contacts) : ties_(pair_contacts), wraps_(node_contacts) {
    contacts_.reserve(node_contacts);
    bearings_.reserve(node_contacts);
    reactions_.reserve(node_contacts);
    minima_.reserve(node_contacts);
    borne_.reserve(node_contacts);
    touched_.reserve(node_contacts + 4 * pair_contacts + 1);
    nodes_.reserve(node_contacts + 4 * pair_contacts + 1);
}

void ContactSet::clear() {
    contacts_.clear();
    ties_.clear();
    wraps_.clear();
    touches_ = dropped_ = 0;
}

void ContactSet::add(const NodeContact& contact) {
    assert(contact.node > 0 && "the chain's end is held already");
    assert(!(std::abs(contact.normal.squaredNorm() - 1) > 1e-6) && "a unit vector");
    if (contacts_.size() < contacts_.capacity())
        contacts_.push_back(contact);
    else
        ++dropped_;
}

void ContactSet::add(const PairContact& contact) {
    if (!ties_.add(contact)) ++dropped_;
}

void ContactSet::add(const Edge& edge) {
    if (!wraps_.add(edge)) ++dropped_;
}

void ContactSet::gather_nodes() {
    touched_.clear();
    for (const NodeContact& c : contacts_)
        touched_.push_back(c.node);
    bool with_anchor = false;
    for (const PairContact& p : ties_.all()) {
        touched_.push_back(p.link_a);
        touched_.push_back(p.link_a + 1);
        if (p.body_b == Body::anchor) {
            with_anchor = true;
        } else {
            touched_.push_back(p.link_b);
            touched_.push_back(p.link_b + 1);
        }
    }
    if (with_anchor) touched_.push_back(0); // it moves with the anchor
    std::sort(touched_.begin(), touched_.end());
    touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
    nodes_.clear();
    for (const int node : touched_)
        nodes_.emplace_back(node);
}

int ContactSet::place_of(int node) const {
    const auto at = std::lower_bound(nodes_.begin(), nodes_.end(), node,
                                     [](const Node& entry, int index) { return entry.index < index; });
    return static_cast<int>(at - nodes_.begin());
}

void ContactSet::prepare_bearing(std::size_t k) {
    const NodeContact& c = contacts_[k];
    const int place = place_of(c.node);
    const Vec3 sliding = nodes_[place].velocity - c.surface_velocity;
    const double rising = sliding.dot(c.normal);
    const double speed = (sliding - rising * c.normal).norm();
    const double sunk = std::max(0.0, c.penetration);
    // A gap is closed without damping: a damper would act before they touch.
    const double damping = c.penetration > 0 ? c.damping : 0;
    const double pressed = c.stiffness * sunk + (c.penetration > 0 ? c.adhesion : 0);
    bearings_.push_back({.node = place,
                         .normal = damping + time_.dt * c.stiffness,
                         .friction = c.friction * pressed / std::max(speed, kFrictionCreep),
                         .push = time_.kick * c.stiffness * c.penetration,
                         .min = rising >= 0 ? -time_.kick * c.adhesion : 0});
}

void ContactSet::enter(const ChainState& state, const StepTime& time, SymmetricField& inverse_mass,
                       Field& predicted, const AnchorEnd* anchor) {
    assert(time.dt > 0 && time.kick > 0 && "a step takes time");
    time_ = time;
    revisions_ = 0;
    wraps_.enter(state, time, inverse_mass, predicted);
    gather_nodes();
    for (Node& node : nodes_) {
        node.position = node.predicted = state.position.at(node.index);
        if (node.index < state.asleep) continue;
        node.inverse_mass = inverse_mass.at(node.index);
        node.velocity = state.velocity.at(node.index);
        node.predicted = predicted.at(node.index);
    }
    bearings_.clear();
    for (std::size_t k = 0; k < contacts_.size(); ++k)
        prepare_bearing(k);
    const CableInStep cable{&state, &inverse_mass, &predicted, anchor};
    ties_.enter({&cable, 1}, time);

    reactions_.assign(touches_, 0);
    minima_.assign(touches_, 0);
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
        reactions_[contacts_[k].touch] += reaction(k, nodes_[bearings_[k].node].velocity);
        minima_[contacts_[k].touch] += bearings_[k].min;
    }
    borne_.resize(touches_);
    for (int touch = 0; touch < touches_; ++touch)
        borne_[touch] = reactions_[touch] > minima_[touch];
    apply(inverse_mass, predicted);
}

/// Impulse along the normal that contact k would give a node of that velocity, N s.
double ContactSet::reaction(std::size_t k, const Vec3& velocity) const {
    const NodeContact& c = contacts_[k];
    return bearings_[k].push - time_.kick * bearings_[k].normal * c.normal.dot(velocity - c.surface_velocity);
}

Vec3 ContactSet::velocity(const Node& node, const Field& placed) const {
    return (placed.at(node.index) - node.position) / time_.dt;
}

void ContactSet::take_off(SymmetricField& inverse_mass, Field& predicted) const {
    for (const Node& node : nodes_) {
        inverse_mass.set(node.index, node.inverse_mass);
        predicted.set(node.index, node.predicted);
    }
}

void ContactSet::put_on(SymmetricField& inverse_mass, Field& predicted) {
    for (Node& node : nodes_) {
        if (node.inverse_mass.trace() == 0) continue; // held
        node.inverse_mass = inverse_mass.at(node.index);
        node.predicted = predicted.at(node.index);
    }
    apply(inverse_mass, predicted);
}

void ContactSet::apply(SymmetricField& inverse_mass, Field& predicted) {
    take_off(inverse_mass, predicted);
    // Contacts come in any order; each adds to what the ones before it made of the node.
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
        const NodeContact& c = contacts_[k];
        if (!borne_[c.touch]) continue;
        const Bearing& b = bearings_[k];
        const Node& node = nodes_[b.node];
        if (node.inverse_mass.trace() == 0) continue; // held
        SymmetricMatrix mass = inverse_mass.at(node.index).inverse();
        const Vec3 momentum = mass * velocity(node, predicted);
        const double across = time_.kick * b.friction, along = time_.kick * b.normal - across;
        const Vec3& n = c.normal;
        const Vec3& carried = c.surface_velocity;
        const Vec3 given = (b.push + along * n.dot(carried)) * n + across * carried;
        mass.xx += across + along * n.x() * n.x();
        mass.yy += across + along * n.y() * n.y();
        mass.zz += across + along * n.z() * n.z();
        mass.xy += along * n.x() * n.y();
        mass.xz += along * n.x() * n.z();
        mass.yz += along * n.y() * n.z();
        const SymmetricMatrix w = mass.inverse();
        inverse_mass.set(node.index, w);
        predicted.set(node.index, node.position + time_.dt * (w * (momentum + given)));
    }
    if (!ties_.empty()) ties_.press();
}

/// What each touch gives the chain in a solution.
void ContactSet::react(const Field& placed) {
    std::fill(reactions_.begin(), reactions_.end(), 0);
    for (std::size_t k = 0; k < contacts_.size(); ++k)
        reactions_[contacts_[k].touch] += reaction(k, velocity(nodes_[bearings_[k].node], placed));
}

bool ContactSet::unsettled(const Field& placed) {
    if (!ties_.empty() && !ties_.at_rest()) return true;
    if (contacts_.empty() || revisions_ < kMaxRevisions) return false;
    react(placed);
    for (int touch = 0; touch < touches_; ++touch)
        if ((reactions_[touch] > minima_[touch]) != (borne_[touch] != 0)) return true;
    return false;
}

bool ContactSet::revise(const Field& placed, SymmetricField& inverse_mass, Field& predicted) {
    if (contacts_.empty() || revisions_ == kMaxRevisions) return false;
    react(placed);
    bool changed = false;
    for (int touch = 0; touch < touches_; ++touch) {
        const bool borne = reactions_[touch] > minima_[touch];
        changed = changed || borne != borne_[touch];
        borne_[touch] = borne;
    }
    if (!changed) return false;
    ++revisions_;
    apply(inverse_mass, predicted);
    return true;
}

ContactLoad ContactSet::settle(const ChainState& state, const Vector7& anchor) const {
    ContactLoad load;
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
        const NodeContact& c = contacts_[k];
        if (!borne_[c.touch]) continue;
        ++load.borne;
        const Node& node = nodes_[bearings_[k].node];
        const Vec3 sliding = velocity(node, state.position) - c.surface_velocity;
        const Vec3 across = sliding - sliding.dot(c.normal) * c.normal;
        const Vec3 impulse = reaction(k, velocity(node, state.position)) * c.normal -
                             time_.kick * bearings_[k].friction * across;
        load.impulse += impulse;
        load.moment += state.position.at(node.index).cross(impulse);
        load.work -= impulse.dot(0.5 * (node.velocity + state.velocity.at(node.index)));
    }
    for (const LinkWraps::Wrap& wrap : wraps_.all()) {
        const LinkWraps::Reaction reaction = wraps_.reaction(wrap, state);
        load.borne += wrap.pull > 0 && wrap.before.turn > 0 ? 1 : 0;
        load.impulse += reaction.impulse;
        load.moment += wrap.edge.foot.cross(reaction.impulse);
        load.work += reaction.work;
    }
    const CableAfter after{&state, anchor};
    load.work += ties_.work({&after, 1});
    return load;
}

} // namespace windlass::physics
