#include "server/physics/tackle/cable_crossing.hpp"

#include "server/physics/anchor/anchor_contact.hpp"
#include "server/physics/anchor/anchor_meeting.hpp"
#include "server/physics/base/closest.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace windlass::physics {

namespace {

constexpr int kRun = 12;        ///< links in a box
constexpr int kContacts = 1024; ///< of all kinds

/// Taut cables that cross bear on each other at one point, where in a heap many share the load: a meganewton
/// presses the links of one into the other's by a third of their width. N/m; tuned.
constexpr double kCrossing = 1e7;

/// Two links, and where they come closest.
struct Meeting {
    ClosestShares at;
    Vec3 apart;            ///< m, from a to b
    Vec3 along_a, along_b; ///< m
};

Meeting meeting(const ChainState& a, int i, const ChainState& b, int j) {
    const Vec3 from = a.position.at(i), other = b.position.at(j);
    Meeting m{{}, Vec3::Zero(), a.position.at(i + 1) - from, b.position.at(j + 1) - other};
    m.at = closest_shares(from, m.along_a, other, m.along_b);
    m.apart = other + m.at.second * m.along_b - from - m.at.first * m.along_a;
    return m;
}

} // namespace

CableCrossing::CableCrossing(const GroundTackle& a, const GroundTackle& b)
    : boxes_a_(a.chain().tension.size() / kRun + 1),
      boxes_b_(b.chain().tension.size() / kRun + 1),
      ties_(kContacts) {}

void CableCrossing::build(const ChainState& chain, double room, std::vector<Bounds>& boxes) {
    for (int first = 0, run = 0; first < chain.links; first += kRun, ++run) {
        Bounds box{chain.position.at(first), chain.position.at(first)};
        for (int i = first + 1; i <= std::min(first + kRun, chain.links); ++i) {
            box.low = box.low.cwiseMin(chain.position.at(i));
            box.high = box.high.cwiseMax(chain.position.at(i));
        }
        boxes[run] = {box.low - Vec3::Constant(room), box.high + Vec3::Constant(room)};
    }
}

template <class Pair>
bool CableCrossing::any_pair(const ChainState& a, const ChainState& b, double room, const Pair& pair) {
    build(a, room, boxes_a_);
    build(b, 0, boxes_b_);
    for (int i = 0; i < a.links; i += kRun) {
        for (int j = 0; j < b.links; j += kRun) {
            const Bounds &one = boxes_a_[i / kRun], &other = boxes_b_[j / kRun];
            if ((one.low.array() > other.high.array()).any() || (other.low.array() > one.high.array()).any())
                continue;
            for (int p = i; p < std::min(i + kRun, a.links); ++p)
                for (int q = j; q < std::min(j + kRun, b.links); ++q, ++visits_)
                    if (pair(p, q)) return true;
        }
    }
    return false;
}

bool CableCrossing::near(const GroundTackle& a, const GroundTackle& b, double distance) {
    const ChainState &one = a.chain(), &other = b.chain();
    const auto close = [&](int i, int j) { return meeting(one, i, other, j).apart.norm() < distance; };
    const auto anchor_near = [&](const Anchor& anchor, const ChainState& chain) {
        const Vec3 at = anchor.pose().position;
        const double reach = anchor.reach() + distance;
        for (int i = 0; i <= chain.links; ++i)
            if ((chain.position.at(i) - at).squaredNorm() < reach * reach) return true;
        return false;
    };
    return anchors_near(a.anchor(), b.anchor(), distance) || anchor_near(a.anchor(), other) ||
           anchor_near(b.anchor(), one) || any_pair(one, other, distance, close);
}

void CableCrossing::find(const GroundTackle& a, const GroundTackle& b, const EnvironmentDef& environment,
                         double dt) {
    const ChainDef &def_a = a.setup().chain, &def_b = b.setup().chain;
    const ChainState &one = a.chain(), &other = b.chain();
    const double width = 0.5 * (def_a.contact_diameter + def_b.contact_diameter);
    const double mass_a = def_a.mass_per_metre * def_a.node_spacing,
                 mass_b = def_b.mass_per_metre * def_b.node_spacing;
    const double damping = 2 * std::sqrt(kCrossing * mass_a * mass_b / (mass_a + mass_b)); // critical
    const double friction = link_touch(def_a).friction;
    ties_.clear();
    const auto touch = [&](int i, int j) {
        if (i == one.parted || j == other.parted) return false;
        const Meeting m = meeting(one, i, other, j);
        const double distance = m.apart.norm();
        if (distance > 2 * width) return false; // no cable goes by half a metre in a step
        // Crossing exactly, the second lies on top.
        Vec3 normal = -m.apart / distance;
        if (distance < 1e-6 * width) {
            const Vec3 across = m.along_a.cross(m.along_b);
            normal = across.norm() > 1e-9 ? Vec3(across.normalized()) : Vec3::UnitZ();
            if (normal.z() > 0) normal = -normal;
        }
        const auto speed = [](const ChainState& chain, int link, double at) {
            return Vec3((1 - at) * chain.velocity.at(link) + at * chain.velocity.at(link + 1));
        };
        const Vec3 parting = speed(one, i, m.at.first) - speed(other, j, m.at.second);
        if (distance + dt * normal.dot(parting) > width) return false;
        ties_.add({.link_a = i,
                   .link_b = j,
                   .at_a = m.at.first,
                   .at_b = m.at.second,
                   .normal = normal,
                   .penetration = width - distance,
                   .stiffness = kCrossing,
                   .damping = damping,
                   .friction = friction,
                   .cable_a = 0,
                   .cable_b = 1});
        return false;
    };
    any_pair(one, other, 2 * width, touch);
    find_anchor_contacts(def_a, environment, one, dt, b.anchor(), {.cable = 0, .anchor = 1}, ties_);
    find_anchor_contacts(def_b, environment, other, dt, a.anchor(), {.cable = 1, .anchor = 0}, ties_);
    find_anchor_meetings(environment, a.anchor(), b.anchor(), dt, ties_);
}

void CableCrossing::step(GroundTackle& a, GroundTackle& b, const EnvironmentDef& environment, double dt,
                         const TackleStep& of_a, const TackleStep& of_b) {
    assert(&a != &b && "a cable does not cross itself here: ChainContacts has that");
    find(a, b, environment, dt);
    a.begin(environment, dt, of_a.levers, of_a.causes, of_a.lip, &of_a.hull, true);
    b.begin(environment, dt, of_b.levers, of_b.causes, of_b.lip, &of_b.hull, true);
    if (!ties_.empty()) {
        const std::array cables{a.in_step(), b.in_step()};
        ties_.enter(cables, a.step_time());
        ties_.press();
    }
    a.finish(environment, of_a.causes, ties_.pushed(0), ties_.full());
    b.finish(environment, of_b.causes, ties_.pushed(1), ties_.full());
    if (ties_.empty()) return;
    const std::array after{a.after_step(), b.after_step()};
    a.book_contact(ties_.work(after));
}

} // namespace windlass::physics
