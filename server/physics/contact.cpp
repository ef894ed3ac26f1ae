#include "server/physics/contact.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace windlass::physics {

namespace {

/// Times in a step that contacts may change their mind; then they stay as they are.
constexpr int kMostRevisions = 4;

/// Sweeps over contacts of chain with chain. They are soft, so a few do; what is
/// left over the next step finds as penetration.
constexpr int kMostSweeps = 10;
constexpr double kSweepTolerance = 3e-3; // of the largest impulse

double trace(const SymmetricMatrix& m) {
    return m.xx + m.yy + m.zz;
}

} // namespace

ContactSet::ContactSet(int node_contacts, int pair_contacts) : wraps_(node_contacts) {
    contacts_.reserve(node_contacts);
    bearings_.reserve(node_contacts);
    reactions_.reserve(node_contacts);
    leasts_.reserve(node_contacts);
    borne_.reserve(node_contacts);
    pairs_.reserve(pair_contacts);
    ties_.reserve(pair_contacts);
    nodes_.reserve(node_contacts + 4 * pair_contacts);
}

void ContactSet::clear() {
    contacts_.clear();
    pairs_.clear();
    wraps_.clear();
    touches_ = dropped_ = 0;
}

void ContactSet::add(const NodeContact& contact) {
    if (contacts_.size() < contacts_.capacity())
        contacts_.push_back(contact);
    else
        ++dropped_;
}

void ContactSet::add(const PairContact& contact) {
    if (pairs_.size() < pairs_.capacity())
        pairs_.push_back(contact);
    else
        ++dropped_;
}

void ContactSet::add(const Edge& edge) {
    if (!wraps_.add(edge)) ++dropped_;
}

void ContactSet::gather_nodes() {
    nodes_.clear();
    for (const NodeContact& c : contacts_)
        nodes_.emplace_back(c.node);
    for (const PairContact& p : pairs_) {
        for (const int node : {p.link_a, p.link_a + 1, p.link_b, p.link_b + 1})
            nodes_.emplace_back(node);
    }
    std::sort(nodes_.begin(), nodes_.end(), [](const Node& a, const Node& b) { return a.index < b.index; });
    const auto same = [](const Node& a, const Node& b) { return a.index == b.index; };
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end(), same), nodes_.end());
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
                         .least = rising >= 0 ? -time_.kick * c.adhesion : 0});
}

void ContactSet::prepare_tie(std::size_t k) {
    const PairContact& p = pairs_[k];
    Tie tie{.node = {place_of(p.link_a), place_of(p.link_a + 1), place_of(p.link_b), place_of(p.link_b + 1)},
            .share = {1 - p.at_a, p.at_a, p.at_b - 1, -p.at_b},
            .softness = 0,
            .give = 0,
            .friction_give = 0,
            .impulse = 0,
            .rubbing = Vec3::Zero()};
    const double damping = p.penetration > 0 ? p.damping : 0;
    tie.softness = 1 / (time_.kick * (damping + time_.dt * p.stiffness));
    ties_.push_back(tie);
}

void ContactSet::enter(const ChainState& state, const StepTime& time, SymmetricField& inverse_mass,
                       Field& predicted) {
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
    ties_.clear();
    for (std::size_t k = 0; k < pairs_.size(); ++k)
        prepare_tie(k);

    reactions_.assign(touches_, 0);
    leasts_.assign(touches_, 0);
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
        reactions_[contacts_[k].touch] += reaction(k, nodes_[bearings_[k].node].velocity);
        leasts_[contacts_[k].touch] += bearings_[k].least;
    }
    borne_.resize(touches_);
    for (int touch = 0; touch < touches_; ++touch)
        borne_[touch] = reactions_[touch] > leasts_[touch];
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

void ContactSet::apply(SymmetricField& inverse_mass, Field& predicted) {
    for (const Node& node : nodes_) {
        inverse_mass.set(node.index, node.inverse_mass);
        predicted.set(node.index, node.predicted);
    }
    // Contacts come in any order; each adds to what the ones before it made of the node.
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
        const NodeContact& c = contacts_[k];
        if (!borne_[c.touch]) continue;
        const Bearing& b = bearings_[k];
        const Node& node = nodes_[b.node];
        if (trace(node.inverse_mass) == 0) continue; // held
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
    press_pairs(inverse_mass, predicted);
}

/// Gauss-Seidel over the pairs, from the impulses found before.
void ContactSet::press_pairs(SymmetricField& inverse_mass, Field& predicted) {
    if (ties_.empty()) return;
    for (std::size_t k = 0; k < ties_.size(); ++k) {
        Tie& tie = ties_[k];
        tie.give = tie.friction_give = 0;
        for (int e = 0; e < 4; ++e) {
            const int node = nodes_[tie.node[e]].index;
            const SymmetricMatrix w = inverse_mass.at(node);
            const double weight = tie.share[e] * tie.share[e];
            tie.give += weight * pairs_[k].normal.dot(w * pairs_[k].normal);
            tie.friction_give += weight * trace(w);
            predicted.add(node,
                          time_.dt * tie.share[e] * (w * (tie.impulse * pairs_[k].normal + tie.rubbing)));
        }
    }
    for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
        double change = 0, largest = 0;
        for (std::size_t k = 0; k < ties_.size(); ++k) {
            change = std::max(change, press(k, inverse_mass, predicted));
            largest = std::max(largest, ties_[k].impulse);
        }
        if (change <= kSweepTolerance * largest) break;
    }
}

/// One pair: brings its impulses in line with the motion of its points. Returns how far the normal one moved,
/// N s.
double ContactSet::press(std::size_t k, const SymmetricField& inverse_mass, Field& predicted) {
    const PairContact& p = pairs_[k];
    Tie& tie = ties_[k];
    Vec3 apart = Vec3::Zero();
    for (int e = 0; e < 4; ++e)
        apart += tie.share[e] * velocity(nodes_[tie.node[e]], predicted);
    const double parting = apart.dot(p.normal);
    const double spring = time_.kick * p.stiffness * p.penetration * tie.softness; // m/s
    const double wanted =
        tie.impulse + (spring - parting - tie.softness * tie.impulse) / (tie.softness + tie.give);
    const double impulse = std::max(0.0, wanted);
    const double change = impulse - tie.impulse;
    tie.impulse = impulse;
    Vec3 given = change * p.normal;
    if (p.friction > 0 && tie.friction_give > 0) {
        Vec3 rubbing = tie.rubbing - (apart - parting * p.normal) / tie.friction_give;
        const double size = rubbing.norm(), most = p.friction * impulse;
        if (size > most) rubbing *= most / size;
        given += rubbing - tie.rubbing;
        tie.rubbing = rubbing;
    }
    for (int e = 0; e < 4; ++e) {
        const int node = nodes_[tie.node[e]].index;
        predicted.add(node, time_.dt * tie.share[e] * (inverse_mass.at(node) * given));
    }
    return std::abs(change);
}

bool ContactSet::revise(const Field& placed, SymmetricField& inverse_mass, Field& predicted) {
    if (contacts_.empty() || revisions_ == kMostRevisions) return false;
    std::fill(reactions_.begin(), reactions_.end(), 0);
    for (std::size_t k = 0; k < contacts_.size(); ++k)
        reactions_[contacts_[k].touch] += reaction(k, velocity(nodes_[bearings_[k].node], placed));
    bool changed = false;
    for (int touch = 0; touch < touches_; ++touch) {
        const char borne = reactions_[touch] > leasts_[touch];
        changed = changed || borne != borne_[touch];
        borne_[touch] = borne;
    }
    if (!changed) return false;
    ++revisions_;
    apply(inverse_mass, predicted);
    return true;
}

ContactLoad ContactSet::settle(const ChainState& state) const {
    ContactLoad load;
    const auto book = [&](const Node& node, const Vec3& impulse) {
        if (node.index == state.links) return; // the lip moves as it is told
        load.work -= impulse.dot(0.5 * (node.velocity + state.velocity.at(node.index)));
    };
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
        book(node, impulse);
    }
    for (const LinkWraps::Wrap& wrap : wraps_.all()) {
        const LinkWraps::Reaction reaction = wraps_.reaction(wrap, state);
        load.borne += wrap.pull > 0 && wrap.before.turn > 0 ? 1 : 0;
        load.impulse += reaction.impulse;
        load.moment += wrap.edge.foot.cross(reaction.impulse);
        load.work += reaction.work;
    }
    for (std::size_t k = 0; k < ties_.size(); ++k) {
        const Vec3 impulse = ties_[k].impulse * pairs_[k].normal + ties_[k].rubbing;
        for (int e = 0; e < 4; ++e)
            book(nodes_[ties_[k].node[e]], ties_[k].share[e] * impulse);
    }
    return load;
}

} // namespace windlass::physics
