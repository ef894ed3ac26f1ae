#include "server/physics/contact/pair_contacts.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::physics {

namespace {

/// Sweeps over the contacts. They are soft, so a few do; what is left over the next step finds as
/// penetration.
constexpr int kMaxSweeps = 10;
constexpr double kSweepTolerance = 3e-3; // of the largest impulse

/// Calls end(side, cable, point, sign) for each point of a contact that is one of an anchor; side 0 is a.
template <class End>
void each_anchor(const PairContact& p, const End& end) {
    if (p.body_a == Body::anchor) end(0, p.cable_a, p.on_a, 1.0);
    if (p.body_b == Body::anchor) end(1, p.cable_b, p.on_b, -1.0);
}

} // namespace

void PairContacts::clear() {
    pairs_.clear();
    ties_.clear();
    cables_ = {};
}

PairContacts::PairContacts(int capacity) {
    pairs_.reserve(capacity);
    ties_.reserve(capacity);
    pushes_.resize(capacity);
}

bool PairContacts::add(const PairContact& contact) {
    if (pairs_.size() == pairs_.capacity()) return false;
    pairs_.push_back(contact);
    return true;
}

void PairContacts::enter(std::span<const CableInStep> cables, const StepTime& time) {
    time_ = time;
    per_dt_ = 1 / time.dt;
    cables_ = {};
    for (std::size_t c = 0; c < cables.size(); ++c)
        cables_[c].in = cables[c];
    ties_.clear();
    for (const PairContact& p : pairs_) {
        Tie& tie = ties_.emplace_back();
        tie.node = {p.link_a, p.link_a + 1, p.link_b, p.link_b + 1};
        tie.share = {1 - p.at_a, p.at_a, p.at_b - 1, -p.at_b};
        tie.ends = (p.body_a == Body::chain ? 2 : 0) + (p.body_b == Body::chain ? 2 : 0);
        const double damping = p.penetration > 0 ? p.damping : 0; // none before they touch
        tie.softness = 1 / (time_.kick * (damping + time_.dt * p.stiffness));
        tie.spring = time_.kick * p.stiffness * p.penetration * tie.softness;
        for (int e = 0; e < tie.ends; ++e) {
            const ChainState& state = *cable_of(p, e).in.state;
            if (tie.node[e] < state.asleep) tie.share[e] = 0; // what sleeps stays
            tie.from += tie.share[e] * state.position.at(tie.node[e]);
            // The lip moves as it is told: what is done to it is the ship's.
            if (tie.node[e] < state.links) tie.apart_before += tie.share[e] * state.velocity.at(tie.node[e]);
        }
        each_anchor(p, [&](int, int cable, const AnchorPoint& point, double sign) {
            tie.apart_before += sign * point_velocity(point, cables_[cable].in.anchor->before);
        });
    }
}

void PairContacts::press() {
    for (Cable& cable : cables_)
        cable.pushed = cable.pulled = Vector7::Zero();
    for (std::size_t k = 0; k < ties_.size(); ++k) {
        Tie& tie = ties_[k];
        const PairContact& p = pairs_[k];
        tie.give = tie.friction_give = 0;
        for (int e = 0; e < tie.ends; ++e) {
            tie.carries[e] = time_.dt * tie.share[e] * cable_of(p, e).in.inverse_mass->at(tie.node[e]);
            const double weight = tie.share[e] / time_.dt;
            tie.give += weight * p.normal.dot(tie.carries[e] * p.normal);
            tie.friction_give += weight * tie.carries[e].trace();
        }
        each_anchor(p, [&](int side, int cable, const AnchorPoint& point, double sign) {
            pushes_[k][side] = sign * pushed_by(point, cables_[cable].in.anchor->yielding);
            Eigen::Matrix3d w;
            for (int axis = 0; axis < 3; ++axis)
                w.col(axis) = sign * point_velocity(point, pushes_[k][side].col(axis));
            tie.give += p.normal.dot(w * p.normal);
            tie.friction_give += w.trace();
        });
        give(k, tie.impulse * p.normal + tie.rubbing);
    }
    for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
        double change = 0, largest = 0;
        for (std::size_t k = 0; k < ties_.size(); ++k) {
            change = std::max(change, press(k));
            largest = std::max(largest, ties_[k].impulse);
        }
        at_rest_ = change <= kSweepTolerance * largest;
        if (at_rest_) break;
    }
}

/// Velocity of a against b as it is now, m/s.
Vec3 PairContacts::apart(std::size_t k) {
    const Tie& tie = ties_[k];
    const PairContact& pair = pairs_[k];
    Vec3 apart = -tie.from; // m first
    for (int e = 0; e < tie.ends; ++e)
        apart += tie.share[e] * cable_of(pair, e).in.predicted->at(tie.node[e]);
    apart *= per_dt_;
    each_anchor(pair, [&](int, int end, const AnchorPoint& point, double sign) {
        const Cable& cable = cables_[end];
        apart += sign * point_velocity(point, cable.in.anchor->motion + cable.pushed + cable.pulled);
    });
    return apart;
}

/// Gives an impulse (N s) to a and takes it from b.
void PairContacts::give(std::size_t k, const Vec3& impulse) {
    const Tie& tie = ties_[k];
    const PairContact& pair = pairs_[k];
    for (int e = 0; e < tie.ends; ++e) {
        Cable& cable = cable_of(pair, e);
        const int node = tie.node[e];
        cable.in.predicted->add(node, tie.carries[e] * impulse);
        if (node == 0 && cable.in.anchor != nullptr) // the shackle, a point of the anchor
            cable.pulled += tie.share[e] *
                            pushed_by(impulse, {.arm = cable.in.anchor->shackle}, cable.in.anchor->yielding);
    }
    each_anchor(pair, [&](int side, int end, const AnchorPoint&, double) {
        Cable& cable = cables_[end];
        const Vector7 change = pushes_[k][side] * impulse;
        cable.pushed += change;
        if (cable.in.state->asleep == 0)
            cable.in.predicted->add(0, time_.dt * point_velocity({.arm = cable.in.anchor->shackle}, change));
    });
}

/// One contact: brings its impulses in line with the motion of its points. Returns how far the normal one
/// moved, N s.
double PairContacts::press(std::size_t k) {
    const PairContact& p = pairs_[k];
    Tie& tie = ties_[k];
    const Vec3 moving = apart(k);
    const double parting = moving.dot(p.normal);
    const double wanted =
        tie.impulse + (tie.spring - parting - tie.softness * tie.impulse) / (tie.softness + tie.give);
    const double impulse = std::max(0.0, wanted);
    const double change = impulse - tie.impulse;
    tie.impulse = impulse;
    Vec3 given = change * p.normal;
    if (p.friction > 0 && tie.friction_give > 0) {
        Vec3 rubbing = tie.rubbing - (moving - parting * p.normal) / tie.friction_give;
        const double size = rubbing.norm(), max = p.friction * impulse;
        if (size > max) rubbing *= max / size;
        given += rubbing - tie.rubbing;
        tie.rubbing = rubbing;
    }
    give(k, given);
    return std::abs(change);
}

double PairContacts::pressing() const {
    double sum = 0;
    for (const Tie& tie : ties_)
        sum += tie.impulse;
    return sum;
}

double PairContacts::work(std::span<const CableAfter> cables) const {
    double sum = 0;
    for (std::size_t k = 0; k < ties_.size(); ++k) {
        const Tie& tie = ties_[k];
        const PairContact& p = pairs_[k];
        Vec3 after = Vec3::Zero();
        for (int e = 0; e < tie.ends; ++e) {
            const ChainState& state = *cables[e < 2 ? p.cable_a : p.cable_b].state;
            if (tie.node[e] < state.links) after += tie.share[e] * state.velocity.at(tie.node[e]);
        }
        each_anchor(p, [&](int, int cable, const AnchorPoint& point, double sign) {
            after += sign * point_velocity(point, cables[cable].anchor);
        });
        sum -= (tie.impulse * p.normal + tie.rubbing).dot(0.5 * (tie.apart_before + after));
    }
    return sum;
}

} // namespace windlass::physics
