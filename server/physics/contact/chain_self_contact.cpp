#include "server/physics/contact/chain_self_contact.hpp"

#include "server/physics/base/closest.hpp"
#include "server/physics/contact/bend_limit.hpp"

#include <cmath>
#include <numbers>

namespace windlass::physics {

namespace {

constexpr int kRun = 4; ///< links in the smallest box

/// Pairs of links that are near each other, for each link of the chain: in a heap some dozens are.
constexpr int kNearPerLink = 48;

/// Of the way that nodes may go, left for rounding.
constexpr double kNearlyAll = 1 - 1e-9;

/// The weight of so much chain (m) on one touch presses the links into each other by so much of their width:
/// a heap keeps its height, and the spring stays slow enough for the steps that a taut chain takes.
constexpr double kHeaped = 30, kPressed = 0.07;

/// Steel on steel, wet and rusty (0.3 to 0.5 in common tables).
constexpr double kLinkFriction = 0.4;

} // namespace

LinkTouch link_touch(const ChainDef& def) {
    const double mass = 0.5 * def.mass_per_metre * def.node_spacing; // of two nodes that meet
    const double stiffness = kHeaped * weight_in_air(def) / (kPressed * def.contact_diameter);
    return {stiffness, 2 * std::sqrt(stiffness * mass), kLinkFriction};
}

SelfContacts::SelfContacts(int capacity) : drift_(capacity) {
    int boxes = (capacity + kRun - 1) / kRun;
    do {
        levels_.emplace_back(boxes);
        boxes = (boxes + 1) / 2;
    } while (levels_.back().size() > 1);
    waiting_.reserve(4096);
    near_.reserve(static_cast<std::size_t>(kNearPerLink) * capacity);
}

void SelfContacts::find(const ChainDef& def, const ChainState& chain, double dt, ContactSet& set) {
    def_ = &def, chain_ = &chain, set_ = &set, dt_ = dt;
    double gone = drift_.farthest(chain, dt);
    if (gone >= room_) {
        look();
        gone = drift_.farthest(chain, dt);
    }
    const LinkTouch how = link_touch(def);
    for (const Couple& couple : near_)
        if (couple.upper >= chain.asleep && couple.lower != chain.parted && couple.upper != chain.parted)
            touch(couple.lower, couple.upper, how);
    set.drop(missed_);
    if (gone >= bend_room_)
        find_bend_limits(def, chain, dt, set);
    else
        find_bend_limits_at_top(def, chain, dt, set);
}

/// Looks at every link, and says how far the nodes may go before that must be done again.
void SelfContacts::look() {
    const double width = def_->contact_diameter, spacing = def_->node_spacing;
    apart_ = 1 + std::max(1, static_cast<int>(std::ceil(std::numbers::pi * def_->bend_radius / spacing)));
    drift_.mark(*chain_);
    bend_room_ = 0.5 * kNearlyAll * bend_room(*def_, *chain_);
    near_.clear();
    missed_ = 0;
    // Links just so far apart along a taut chain must not all count as near.
    const double beyond = std::min(width, 0.5 * std::max(0.0, (apart_ - 1) * spacing - width));
    double gap = gap_along_chord() - width;
    if (gap < beyond) {
        gap = beyond;
        build(0.5 * (width + beyond));
        gather(width + beyond);
    }
    room_ = 0.5 * kNearlyAll * gap;
}

/// Every link leads on along the chord of the whole chain so far that links between which there might be
/// contact are this far apart (m), if they do: a cable that hangs or grows in a bight, which is nearly always
/// so.
double SelfContacts::gap_along_chord() const {
    const Field& x = chain_->position;
    const Vec3 chord = (x.at(chain_->links) - x.at(0)).normalized();
    double min = 1e300;
    for (int i = 0; i < chain_->links - 1; ++i) {
        const double along = chord.dot(x.at(i + 1) - x.at(i));
        min = along < min ? along : min;
    }
    return min * (apart_ - 1);
}

void SelfContacts::build(double room) {
    const ChainState& chain = *chain_;
    const Vec3 around = Vec3::Constant(room);
    const int boxes = (chain.links + kRun - 1) / kRun;
    for (int b = 0; b < boxes; ++b) {
        Vec3 low = Vec3::Constant(1e300), high = -low;
        for (int i = b * kRun; i <= std::min((b + 1) * kRun, chain.links); ++i) {
            low = low.cwiseMin(chain.position.at(i));
            high = high.cwiseMax(chain.position.at(i));
        }
        levels_[0][b] = {low - around, high + around};
    }
    int below = boxes;
    for (std::size_t level = 1; level < levels_.size(); ++level) {
        const std::vector<Box>& small = levels_[level - 1];
        for (int b = 0; 2 * b < below; ++b) {
            levels_[level][b] = small[2 * b];
            if (2 * b + 1 < below) {
                levels_[level][b].low = levels_[level][b].low.cwiseMin(small[2 * b + 1].low);
                levels_[level][b].high = levels_[level][b].high.cwiseMax(small[2 * b + 1].high);
            }
        }
        below = (below + 1) / 2;
    }
}

/// Keeps the pairs nearer than reach (m), always in the same order.
void SelfContacts::gather(double reach) {
    const int boxes = (chain_->links + kRun - 1) / kRun;
    waiting_.clear();
    waiting_.push_back({static_cast<int>(levels_.size()) - 1, 0, 0});
    while (!waiting_.empty()) {
        const auto [level, first, second] = waiting_.back();
        waiting_.pop_back();
        const int used = ((boxes - 1) >> level) + 1;
        if (second >= used) continue;
        const Box &a = levels_[level][first], &b = levels_[level][second];
        if (first != second && ((a.low.array() > b.high.array()) || (b.low.array() > a.high.array())).any())
            continue;
        if (level == 0) {
            compare(first, second, reach);
        } else if (waiting_.size() + 4 <= waiting_.capacity()) {
            waiting_.push_back({level - 1, 2 * first + 1, 2 * second + 1});
            if (first != second) waiting_.push_back({level - 1, 2 * first + 1, 2 * second});
            waiting_.push_back({level - 1, 2 * first, 2 * second + 1});
            waiting_.push_back({level - 1, 2 * first, 2 * second});
        } else {
            ++missed_;
        }
    }
}

/// All links of one run against all of another (or the same).
void SelfContacts::compare(int first, int second, double reach) {
    const Field& x = chain_->position;
    for (int i = first * kRun; i < std::min((first + 1) * kRun, chain_->links); ++i) {
        const Vec3 from = x.at(i), link = x.at(i + 1) - from;
        const double room = reach + 0.5 * link.norm();
        for (int j = std::max(second * kRun, i + apart_); j < std::min((second + 1) * kRun, chain_->links);
             ++j) {
            const Vec3 other = x.at(j), other_link = x.at(j + 1) - other;
            // Balls round the two links tell most of them apart: no farther than this may their middles be.
            const double max = room + 0.5 * other_link.norm();
            if ((other + 0.5 * other_link - from - 0.5 * link).squaredNorm() > max * max) continue;
            const auto [at_i, at_j] = closest_shares(from, link, other, other_link);
            if ((other + at_j * other_link - from - at_i * link).squaredNorm() > reach * reach) continue;
            if (near_.size() < near_.capacity())
                near_.push_back({i, j});
            else
                ++missed_;
        }
    }
}

/// Adds a pair of links if they touch, or are about to.
void SelfContacts::touch(int i, int j, const LinkTouch& touch) {
    const double width = def_->contact_diameter;
    const Field &x = chain_->position, &v = chain_->velocity;
    const Vec3 from = x.at(i), link = x.at(i + 1) - from, other = x.at(j), other_link = x.at(j + 1) - other;
    const auto [at_i, at_j] = closest_shares(from, link, other, other_link);
    const Vec3 apart = other + at_j * other_link - from - at_i * link;
    const double distance = apart.norm();
    // Crossing exactly, the link nearer to the ship came later and lies on top.
    Vec3 normal = apart / distance;
    if (distance < 1e-6 * width) {
        const Vec3 across = link.cross(other_link);
        normal = across.norm() > 1e-9 ? Vec3(across.normalized()) : Vec3::UnitZ();
        if (normal.z() < 0) normal = -normal;
    }
    const Vec3 speed = v.at(j) + at_j * (v.at(j + 1) - v.at(j)) - v.at(i) - at_i * (v.at(i + 1) - v.at(i));
    if (distance + dt_ * normal.dot(speed) > width) return;
    set_->add(PairContact{.link_a = j,
                          .link_b = i,
                          .at_a = at_j,
                          .at_b = at_i,
                          .normal = normal,
                          .penetration = width - distance,
                          .stiffness = touch.stiffness,
                          .damping = touch.damping,
                          .friction = touch.friction});
}

} // namespace windlass::physics
