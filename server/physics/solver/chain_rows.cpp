// Newton's matrix of the chain: its rows, and what pulls do to the nodes.

#include "server/physics/base/fused.hpp"
#include "server/physics/base/vectorise.hpp"
#include "server/physics/solver/chain_solver.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>

namespace windlass::physics {

namespace {

/// A link that turns further than this in one step (cosine) is pulled along its new direction instead of its
/// old one: robust, first order.
constexpr double kFoldCosine = 0.9;
constexpr double kHardlyTurned = 0.9999;

/// Added to what must not be zero, m2.
constexpr double kNearZero = 1e-300;

/// A benefit of the doubt, m, that no link outdoes.
constexpr double kNoDoubt = 1e9;

} // namespace

/// What a pull of one newton along each link does to its two nodes.
WINDLASS_WIDE
void ChainSolver::spread_pulls(const ChainState& state) {
    WINDLASS_VECTORISE
    for (int i = state.asleep; i < state.links; ++i) {
        const Vec3 g = direction_.at(i);
        up_.set(i, motion_.inverse_mass.at(i) * g);
        down_.set(i + 1, motion_.inverse_mass.at(i + 1) * g);
    }
    if (wraps_ == nullptr) return;
    for (const LinkWraps::Wrap& wrap : wraps_->all()) {
        const int i = wrap.edge.link;
        up_.set(i, motion_.inverse_mass.at(i) * wrap.pull_on_lower);
        down_.set(i + 1, motion_.inverse_mass.at(i + 1) * wrap.pull_on_upper);
    }
}

/// Places the nodes by what the given pulls (N, of each link) do in the step to nodes at the given places.
WINDLASS_WIDE
void ChainSolver::shift_nodes(const ChainState& state, const Field& from, const std::vector<double>& pulls) {
    const int foot = state.asleep, n = state.links;
    placed_.set(foot, fused(reach_ * pulls[foot], up_.at(foot), from.at(foot)));
    WINDLASS_VECTORISE
    for (int i = foot + 1; i < n; ++i) {
        const Vec3 lowered = fused(-(reach_ * pulls[i - 1]), down_.at(i), from.at(i));
        placed_.set(i, fused(reach_ * pulls[i], up_.at(i), lowered));
    }
    placed_.set(n, fused(-(reach_ * pulls[n - 1]), down_.at(n), from.at(n)));
}

/// Newton's matrix: how far each link is from its length, and what the pulls around it do about that.
WINDLASS_WIDE
ChainSolver::Rows ChainSolver::set_up_rows(const ChainState& state, double doubt, double travel) {
    const int foot = state.asleep, n = state.links;
    std::int64_t turned = 0, slack_links = 0;
    const auto row = [&](int i, auto has_below, auto has_above, double rest, double compliance,
                         double benefit) WINDLASS_INLINE {
        // The whole row is multiplied by the link's length, which saves a division; kNearZero saves that of
        // nothing.
        const Vec3 span = placed_.at(i + 1) - placed_.at(i);
        const double length = std::sqrt(fused_dot(span, span));
        turned += fused_dot(span, direction_.at(i)) < kHardlyTurned * length ? 1 : 0;
        const double damps = 1 + damping_[i], gain = damps * reach_;
        const double error =
            std::fma(-compliance, end_tension(i), std::fma(damps, length - rest, -damped_[i]));
        const double springy =
            pull_[i] >= history_force_[i] ? inverse_weight_[i] : 0; // going slack, it lets go without stretch
        const double diagonal =
            gain * fused_dot(span, down_.at(i + 1) + up_.at(i)) + springy * compliance * length;
        const double inverse = 1 / (diagonal + kNearZero);
        // Slack: chain does not push. The first iteration gives links that are nearly taut the benefit of the
        // doubt, else a chain at rest would be found taut only link by link from its ends.
        const bool slack = pull_[i] * diagonal + (error + benefit) * length <= 0;
        slack_links += slack ? 1 : 0;
        // Sums of both cases, of which one counts nothing: a branch would end the vectors.
        const double taut = slack ? 0 : inverse, free = slack ? 1 : 0;
        matrix_.diagonal_inverse[i] = taut * length + free;
        matrix_.right[i] = taut * error * length - free * pull_[i];
        if constexpr (has_below) matrix_.lower[i] = taut * gain * fused_dot(span, down_.at(i));
        if constexpr (has_above) matrix_.upper[i] = taut * gain * fused_dot(span, up_.at(i + 1));
    };
    matrix_.lower[foot] = matrix_.upper[n - 1] = 0;
    const double spacing = def_.node_spacing, compliance = spacing / def_.stiffness;
    constexpr std::true_type yes;
    constexpr std::false_type no;
    const auto inner = [&](int i, auto has_below) WINDLASS_INLINE {
        const double longer = 1 + state.stretch[i];
        row(i, has_below, yes, spacing * longer, compliance * longer, doubt);
    };
    if (n - foot > 1) inner(foot, no);
    WINDLASS_VECTORISE
    for (int i = foot + 1; i < n - 1; ++i)
        inner(i, yes);
    const bool all_taut = slack_links == 0;
    // The top link is what the windlass made of it, and never given up here: the drive line says when it is
    // slack.
    const double rest = state.top_length + travel;
    const double top_compliance = (rest + deck_length_) / def_.stiffness;
    if (n - foot > 1)
        row(n - 1, yes, no, rest, top_compliance, kNoDoubt);
    else
        row(n - 1, no, no, rest, top_compliance, kNoDoubt);
    if (state.parted >= foot) { // slack, whatever its ends do
        matrix_.lower[state.parted] = matrix_.upper[state.parted] = 0;
        matrix_.diagonal_inverse[state.parted] = 1;
        matrix_.right[state.parted] = -pull_[state.parted];
    }
    Rows rows{all_taut, turned > 0, spacing};
    if (wraps_ != nullptr) set_up_wrapped(state, doubt, travel, rows);
    return rows;
}

/// The rows of links round edges: along their way, and with another direction at either end.
void ChainSolver::set_up_wrapped(const ChainState& state, double doubt, double travel, Rows& rows) {
    const int foot = state.asleep, top = state.links - 1;
    for (const LinkWraps::Wrap& wrap : wraps_->all()) {
        const int i = wrap.edge.link;
        const bool at_top = i == top;
        const LinkWay way = wraps_->way_after(wrap, placed_.at(i), placed_.at(i + 1));
        const double before = link_length(def_, state, i), rest = before + (at_top ? travel : 0);
        const double compliance = (rest + (at_top ? deck_length_ : 0)) / def_.stiffness;
        const double damps = 1 + damping_[i], gain = damps * reach_;
        const double error = damps * (way.length - rest) - damped_[i] - compliance * end_tension(i);
        const double springy = pull_[i] >= history_force_[i] ? inverse_weight_[i] : 0;
        const double diagonal =
            gain * (way.at_upper.dot(down_.at(i + 1)) + way.at_lower.dot(up_.at(i))) + springy * compliance;
        const bool slack = pull_[i] * diagonal + error + (at_top ? kNoDoubt : doubt) <= 0;
        rows.all_taut = rows.all_taut && !slack;
        if (way.turn > 0) rows.shortest = std::min({rows.shortest, way.straight_lower, way.straight_upper});
        const double inverse = slack ? 0 : 1 / (diagonal + kNearZero);
        matrix_.diagonal_inverse[i] = slack ? 1 : inverse;
        matrix_.right[i] = slack ? -pull_[i] : error * inverse;
        if (i > foot) matrix_.lower[i] = inverse * gain * way.at_lower.dot(down_.at(i));
        if (i < top) matrix_.upper[i] = inverse * gain * way.at_upper.dot(up_.at(i + 1));
    }
}

/// Whether link i, of the given span and length (m), pulls in vain along its direction: because it turned too
/// far, or because a node that the seabed holds turns its pull aside.
bool ChainSolver::folded(int i, const Vec3& span, double length) const {
    const double along = span.dot(direction_.at(i));
    if (along < kFoldCosine * length || along >= kHardlyTurned * length) return along < kFoldCosine * length;
    const double straight =
        span.dot(motion_.inverse_mass.at(i) * span + motion_.inverse_mass.at(i + 1) * span);
    // Shortened by less than half of that.
    return fused_dot(span, down_.at(i + 1) + up_.at(i)) * length < 0.5 * straight;
}

/// Lets links that pull in vain along their direction at the start of the step pull along their present one.
/// Returns whether any did so; those that lie round an edge have their own way.
bool ChainSolver::turn_folded_links(const ChainState& state) {
    bool any = false;
    for (int i = state.asleep; i < state.links; ++i) {
        const Vec3 span = placed_.at(i + 1) - placed_.at(i);
        const double length = span.norm();
        if (!folded(i, span, length) || (wraps_ != nullptr && wraps_->of(i) != nullptr)) continue;
        any = true;
        direction_.set(i, length < kPoint * def_.node_spacing ? Vec3::UnitZ() : Vec3(span / length));
    }
    if (!any) return false;
    spread_pulls(state);
    shift_nodes(state, motion_.place, pull_);
    return true;
}

} // namespace windlass::physics
