// What the links bring into a step, and what they have at its end: lengths, springs, damping.

#include "server/physics/base/fused.hpp"
#include "server/physics/base/vectorise.hpp"
#include "server/physics/solver/chain_solver.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace windlass::physics {

namespace {

/// Of undamped chain: how much of what a step cannot resolve is taken off, (1 - a) / (1 + a) of it being left
/// after a step. Tuned: from 0.02 to 0.3 a swell is told as well, and a swing that is resolved the worse the
/// more it is (docs/chain_lab.md).
constexpr double kDissipation = 0.05;

/// Of damped chain, for the same: how much of the damping goes by the third difference of the tensions, which
/// is of third order in what the step resolves and eight times what turns round from step to step. Damping by
/// the rate over two steps alone is none of the latter, which then loses 1 to 5 % a step and is kept up by
/// friction that comes and goes. With it 0.6 to 0.8 of what one spring cannot resolve is left after a step of
/// 1/60 to 1/500 s with the exercise's damping, by the roots of its equation; with twice as much no less.
constexpr double kTurnsRound = 1.0 / 32;

/// How the tensions of the instants n + 1, n, n - 1, n - 2 share the mean pull of a step. Their sum is 1.
struct Weights {
    double next, now, before, earlier;
};

/// For a step of dt after one of last (s; 0: from rest), whatever their sizes: a = 0 is Newmark's trapezoidal
/// rule, which neither gains nor loses energy; else it is the rule of Hilber, Hughes and Taylor (1977, alpha
/// = -a; beta = (1 + a)^2 / 4, gamma = 1/2 + a) with the velocities between the steps eliminated. Both are of
/// second order.
Weights weights(double dt, double last, double a) {
    const double next = dt / (dt + last), before = last / (dt + last), left = 1 - a;
    const double between = 1 - a * a + 2 * a * (before - next);
    return {0.5 * next * (1 + a) * (1 + a) * left, 0.5 * (next * a * (1 + a) * (1 + a) + left * between),
            0.5 * (a * between + before * left * left * left), 0.5 * before * a * left * left};
}

/// Newmark's weights, and after an even step what damps (damping_time: s) tensions that turn round.
Weights damped_weights(double dt, double last, double damping_time) {
    Weights share = weights(dt, last, 0);
    if (dt != last) return share;
    const double turns_round = kTurnsRound * damping_time / dt;
    share.next += turns_round, share.now -= 3 * turns_round;
    share.before += 3 * turns_round, share.earlier -= turns_round;
    return share;
}

} // namespace

ChainSolver::LinkDamping ChainSolver::link_damping(double last) const {
    return {def_.damping_time / (time_.dt + last), def_.damping_time / time_.dt};
}

/// Length and direction of each link, what earlier tensions would contribute to its mean pull, and a first
/// guess of the pull.
WINDLASS_WIDE
void ChainSolver::measure_links(const ChainState& state) {
    const double min = kPoint * def_.node_spacing, dt = time_.dt, last = state.last_step;
    const Weights share = def_.damping_time == 0 ? weights(dt, last, kDissipation)
                                                 : damped_weights(dt, last, def_.damping_time);
    const double over_next = 1 / share.next, onwards = last > 0 ? dt / last : 0;
    const auto measure = [&](int i) WINDLASS_INLINE {
        const Vec3 d = state.position.at(i + 1) - state.position.at(i);
        const double length = std::sqrt(fused_dot(d, d));
        // A link of no length (slack chain fallen onto itself) has no direction; any will do, it does not
        // pull.
        const bool point = length < min;
        const double scale = point ? 0 : 1 / length;
        length_[i] = length;
        direction_.set(i, {d.x() * scale, d.y() * scale, point ? 1 : d.z() * scale});

        const double tension = state.elastic_tension[i], tension_before = state.elastic_tension_before[i];
        const double tension_earlier = state.elastic_tension_earlier[i];
        const double past = tension * tension_before * tension_earlier;
        const double weighed = std::fma(share.earlier, tension_earlier,
                                        std::fma(share.now, tension, share.before * tension_before));
        // A link that was slack has no past to weigh in: its new pull counts whole (implicit Euler).
        const bool was_slack = past == 0;
        const double weight = was_slack ? 1 : share.next, history = was_slack ? 0 : weighed;
        inverse_weight_[i] = was_slack ? 1 : over_next;
        history_force_[i] = history;
        const double ahead =
            was_slack ? tension : positive_part(std::fma(onwards, tension - tension_before, tension));
        pull_[i] = std::fma(weight, ahead, history);
    };
    WINDLASS_VECTORISE
    for (int i = state.asleep; i < state.links; ++i)
        measure(i);
}

/// Damping in the mean pull of a step goes by the rate of a link's stretch from the step before last to the
/// end of this; where a pull counts whole, by the rate in this step. feed_speed: m/s paid out before.
WINDLASS_WIDE
void ChainSolver::damp_links(const ChainState& state, double feed_speed) {
    if (def_.damping_time == 0) return;
    const double last = state.last_step;
    const int top = state.links - 1;
    const LinkDamping damping = link_damping(last);
    const auto damp_link = [&](int i, double rest, double rest_before) WINDLASS_INLINE {
        const Vec3 was = state.position.at(i + 1) - state.position.at(i) -
                         last * (state.velocity.at(i + 1) - state.velocity.at(i));
        damp(damping, i, length_[i] - rest, was.norm() - rest_before);
    };
    WINDLASS_VECTORISE
    for (int i = state.asleep; i < top; ++i) {
        const double rest = def_.node_spacing * (1 + state.stretch[i]);
        damp_link(i, rest, rest);
    }
    damp_link(top, state.top_length, state.top_length - feed_speed * last);
}

/// Links round edges start with the length of their way round, and pull along its ends.
void ChainSolver::lay_links_round_edges(const ChainState& state, double feed_speed, ContactSet& contacts) {
    wraps_ = &contacts.wraps();
    for (const LinkWraps::Wrap& wrap : wraps_->all()) {
        const int i = wrap.edge.link;
        round_[i] = wrap.before.length - length_[i];
        length_[i] = wrap.before.length;
        const Vec3 edge = wrap.edge.surface_velocity;
        const double rate = (state.velocity.at(i + 1) - edge).dot(wrap.before.at_upper) -
                            (state.velocity.at(i) - edge).dot(wrap.before.at_lower) -
                            (i == state.links - 1 ? feed_speed : 0);
        const double stretch = length_[i] - link_length(def_, state, i);
        damp(link_damping(state.last_step), i, stretch, stretch - rate * state.last_step);
    }
}

/// What the links' springs have at the end of the step, and their tension with damping, by the rate then.
WINDLASS_WIDE
void ChainSolver::take_tensions(ChainState& state, double travel) {
    const int top = state.links - 1;
    const auto keep = [&](int i, double elastic, double tension) WINDLASS_INLINE {
        state.tension[i] = tension;
        state.elastic_tension_earlier[i] = state.elastic_tension_before[i];
        state.elastic_tension_before[i] = state.elastic_tension[i];
        state.elastic_tension[i] = elastic;
    };
    if (def_.damping_time == 0) {
        WINDLASS_VECTORISE
        for (int i = state.asleep; i <= top; ++i) {
            const double pull = end_tension(i);
            keep(i, pull, pull);
        }
        return;
    }
    const double last = state.last_step, ahead = last > 0 ? time_.dt / (time_.dt + last) : 0;
    const double onwards = def_.damping_time * (1 + ahead) / time_.dt,
                 back = last > 0 ? def_.damping_time * ahead / last : 0;
    const auto take = [&](int i, double stiffness) WINDLASS_INLINE {
        const double was = state.elastic_tension_before[i], now = state.elastic_tension[i],
                     pull = end_tension(i);
        const double undamped = positive_part((pull + stiffness * damped_[i]) / (1 + damping_[i]));
        const double next = pull > 0 ? undamped : 0;
        const double damped = positive_part(next + onwards * (next - now) - back * (now - was));
        keep(i, next, inverse_weight_[i] == 1 ? pull : damped);
    };
    WINDLASS_VECTORISE
    for (int i = state.asleep; i < top; ++i)
        take(i, def_.stiffness / (def_.node_spacing * (1 + state.stretch[i])));
    take(top, def_.stiffness / (state.top_length + travel + deck_length_));
}

} // namespace windlass::physics
