#include "server/physics/chain_solver.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

// The loops over nodes and links are written without branches and with one array for each field, so that the
// compiler vectorises them; the pragma tells it that the arrays do not overlap.
#define WINDLASS_LANES _Pragma("GCC ivdep")
#define WINDLASS_INLINE __attribute__((always_inline))

namespace windlass::physics {

namespace {

constexpr int kMostIterations = 20;

/// A link that turns further than this in one step (cosine) is pulled along its new direction instead of its
/// old one: robust, first order. So is a chain whose solution is hard to find.
constexpr double kFoldCosine = 0.9;
constexpr double kHardlyTurned = 0.9999;
constexpr int kPatientIterations = 8;

/// Shortfall of a link's length, as a fraction, within which it is first taken to be taut.
constexpr double kNearlyTaut = 1e-3;

/// Length (as a fraction of the spacing) below which a link has no direction.
constexpr double kPoint = 1e-9;

} // namespace

ChainSolver::ChainSolver(const ChainDef& def, int capacity, ForceWeights weights)
    : def_(def),
      weights_(weights),
      direction_(capacity),
      unit_(capacity),
      length_(capacity),
      span_(capacity),
      weight_(capacity),
      known_(capacity),
      pull_(capacity),
      diagonal_(capacity),
      lower_(capacity),
      upper_(capacity),
      change_(capacity),
      predicted_(capacity + 1),
      placed_(capacity + 1),
      up_(capacity + 1),
      down_(capacity + 1),
      inverse_mass_(capacity + 1) {}

ChainStepResult ChainSolver::step(ChainState& state, const EnvironmentDef& environment, double dt,
                                  const ChainTail& tail, TopDrive& drive, const Vec3& hawse,
                                  EnergyLedger* ledger, ContactSet* contacts) {
    dt2_ = dt * dt;
    damping_ = def_.damping_time / dt;
    deck_length_ = drive.deck_length();
    current_ = compass(environment.current_towards) * environment.current_speed;
    measure_links(state);
    weigh_tensions(state);
    predict(state, environment, dt, tail, hawse);
    if (contacts != nullptr) contacts->enter(state, dt, inverse_mass_, predicted_);
    spread_pulls(state.links);

    ChainStepResult result;
    const double link_mass = def_.mass_per_metre * def_.node_spacing;
    const double tolerance = 1e-4 * link_mass * kGravity; // N, on each link's mean pull
    result.converged = false;
    place_nodes(state.links);
    while (!result.converged && result.iterations < kMostIterations) {
        ++result.iterations;
        set_up_rows(state, result.iterations == 1, result);
        const bool turned = turn_folded_links(state.links, result.iterations > kPatientIterations);
        if (turned) {
            place_nodes(state.links);
            set_up_rows(state, result.iterations == 1, result);
        }
        const double change = eliminate(state, dt, drive, result);
        // Of an iteration that moves the nodes by d the next one would correct the lengths by d^2 / 2 l at
        // most (Newton converges quadratically). Where links are slack or change their mind, that is no
        // bound.
        const double error =
            steady_ ? std::min(change, change * change * dt2_ / (2 * link_mass * def_.node_spacing)) : change;
        result.converged = error < tolerance && !turned;
        place_nodes(state.links);
        // Contacts that let go or begin to bear are part of the same solution: on with Newton's method.
        if (result.converged && contacts != nullptr && contacts->revise(placed_, inverse_mass_, predicted_)) {
            spread_pulls(state.links);
            place_nodes(state.links);
            result.converged = false;
        }
    }
    if (std::any_of(pull_.begin(), pull_.begin() + state.links, [](double pull) { return pull < 0; })) {
        for (int i = 0; i < state.links; ++i)
            pull_[i] = std::max(0.0, pull_[i]);
        place_nodes(state.links);
    }
    if (ledger != nullptr) {
        const double feed_speed = 0.5 * (drive.speed_before() + result.travel / dt);
        account(state, environment, dt, tail, feed_speed, result.travel, *ledger);
    }
    finish(state, dt, result);
    return result;
}

void ChainSolver::measure_links(const ChainState& state) {
    const double least = kPoint * def_.node_spacing;
    WINDLASS_LANES
    for (int i = 0; i < state.links; ++i) {
        const Vec3 d = state.position.at(i + 1) - state.position.at(i);
        length_[i] = d.norm();
        // A link of no length (slack chain fallen onto itself) has no direction; any will do, it does not
        // pull.
        const bool point = length_[i] < least;
        const double scale = point ? 0 : 1 / length_[i];
        direction_.set(i, {d.x() * scale, d.y() * scale, point ? 1 : d.z() * scale});
    }
}

/// What earlier tensions would contribute to each link's mean pull, and a first guess of the pull.
void ChainSolver::weigh_tensions(const ChainState& state) {
    WINDLASS_LANES
    for (int i = 0; i < state.links; ++i) {
        const double now = state.tension[i], before = state.tension_before[i];
        // A link that was slack has no past to weigh in: its new pull counts whole (implicit Euler).
        const bool fresh = now * before == 0;
        const double weighed = weights_.now * now + weights_.before * before;
        const double weight = fresh ? 1 : weights_.next, known = fresh ? 0 : weighed;
        weight_[i] = weight;
        known_[i] = known;
        pull_[i] = known + weight * now;
    }
}

/// Where the nodes from first to last, each standing for length (m) of chain, would end the step if no link
/// pulled, and how they yield to a pull; clear of the seabed.
void ChainSolver::predict_in_water(const ChainState& state, const EnvironmentDef& environment, double dt,
                                   int first, int last, double length) {
    WINDLASS_LANES
    for (int i = first; i <= last; ++i) {
        const Vec3 at = state.position.at(i), v = state.velocity.at(i);
        const NodeMedium m =
            node_medium(def_, environment, state.position.at(i - 1), at, state.position.at(i + 1), length);
        const NodeDamping damping = water_damping(def_, environment, m, v, current_);
        const SymmetricMatrix w = inverse_mass_afloat(m, damping, dt);
        inverse_mass_.set(i, w);
        predicted_.set(i, at + dt * (w * free_momentum(def_, environment, m, damping, v, dt)));
    }
}

/// The same in air, where nothing but weight acts.
void ChainSolver::predict_in_air(const ChainState& state, double dt, int first, int last, double length) {
    const double inverse = 1 / (def_.mass_per_metre * length);
    const Vec3 fall(0, 0, -dt * kGravity);
    WINDLASS_LANES
    for (int i = first; i <= last; ++i) {
        inverse_mass_.set(i, {.xx = inverse, .yy = inverse, .zz = inverse});
        predicted_.set(i, state.position.at(i) + dt * (state.velocity.at(i) + fall));
    }
}

/// The same for those nodes that the seabed bears.
void ChainSolver::predict_on_bed(const ChainState& state, const EnvironmentDef& environment, double dt) {
    for (int i = 1; i < state.links; ++i) {
        if (state.position.z[i] >= -environment.depth) continue;
        const Vec3 v = state.velocity.at(i);
        const NodeMedium m = node_medium(def_, environment, state, i);
        if (!on_bed(m, v, dt)) continue;
        const NodeDamping damping = node_damping(def_, environment, m, v, current_, dt);
        const SymmetricMatrix w = inverse_mass_on_bed(m, damping, dt);
        Vec3 momentum = free_momentum(def_, environment, m, damping, v, dt);
        momentum.z() += dt * m.bed_stiffness * m.penetration;
        inverse_mass_.set(i, w);
        predicted_.set(i, state.position.at(i) + dt * (w * momentum));
    }
}

void ChainSolver::predict(const ChainState& state, const EnvironmentDef& environment, double dt,
                          const ChainTail& tail, const Vec3& hawse) {
    const int n = state.links;
    inverse_mass_.set(0, tail.inverse_mass);
    predicted_.set(0, state.position.at(0) + dt * tail.velocity);
    const double top = node_length(def_, state, n - 1);
    if (environment.water_density > 0) {
        predict_in_water(state, environment, dt, 1, n - 2, def_.node_spacing);
        if (n > 1) predict_in_water(state, environment, dt, n - 1, n - 1, top);
    } else {
        predict_in_air(state, dt, 1, n - 2, def_.node_spacing);
        if (n > 1) predict_in_air(state, dt, n - 1, n - 1, top);
    }
    predict_on_bed(state, environment, dt);
    inverse_mass_.set(n, {});
    predicted_.set(n, hawse);
}

/// What a pull of one newton along each link does to its two nodes.
void ChainSolver::spread_pulls(int links) {
    down_.set(0, Vec3::Zero());
    up_.set(links, Vec3::Zero());
    WINDLASS_LANES
    for (int i = 0; i < links; ++i) {
        const Vec3 g = direction_.at(i);
        up_.set(i, inverse_mass_.at(i) * g);
        down_.set(i + 1, inverse_mass_.at(i + 1) * g);
    }
}

/// Tension of link i at the end of the step that goes with its mean pull, N. A pull below what earlier
/// tensions would make up means that the link went slack on the way: chain lets go at once and does not push.
double ChainSolver::end_tension(int i) const {
    return positive_part(pull_[i] - known_[i]) / weight_[i];
}

/// Where the nodes end the step under the pulls of this iteration.
void ChainSolver::place_nodes(int links) {
    placed_.set(0, predicted_.at(0) + dt2_ * pull_[0] * up_.at(0));
    WINDLASS_LANES
    for (int i = 1; i < links; ++i) {
        placed_.set(i, predicted_.at(i) + dt2_ * (pull_[i] * up_.at(i) - pull_[i - 1] * down_.at(i)));
    }
    placed_.set(links, predicted_.at(links) - dt2_ * pull_[links - 1] * down_.at(links));
}

/// Newton's matrix: how far each link is from its length, and what the pulls around it do about that. Change
/// i obeys diagonal change(i) - lower change(i - 1) - upper change(i + 1) = right, the last kept in change_.
void ChainSolver::set_up_rows(const ChainState& state, bool first, const ChainStepResult& result) {
    const int n = state.links;
    const double gain = (1 + damping_) * dt2_;
    const double least = kPoint * def_.node_spacing;
    const auto row = [&](int i, double before, double rest, double compliance, double doubt) WINDLASS_INLINE {
        const Vec3 d = placed_.at(i + 1) - placed_.at(i);
        const double length = d.norm();
        const bool point = length < least;
        const double scale = point ? 0 : 1 / length;
        const Vec3 unit(d.x() * scale, d.y() * scale, point ? 1 : d.z() * scale);
        span_[i] = length;
        unit_.set(i, unit);
        const double stretch_before = positive_part(length_[i] - before);
        const double error =
            (1 + damping_) * (length - rest) - damping_ * stretch_before - compliance * end_tension(i);
        const double springy = compliance / weight_[i], stiff = 0; // going slack, it lets go without stretch
        const double give = pull_[i] >= known_[i] ? springy : stiff;
        const double diagonal = gain * unit.dot(down_.at(i + 1) + up_.at(i)) + give;
        const double lower = gain * unit.dot(down_.at(i)), upper = gain * unit.dot(up_.at(i + 1));
        // Slack: chain does not push. The first iteration gives links that are nearly taut the benefit of the
        // doubt, else a chain at rest would be found taut only link by link from its ends.
        const bool slack = pull_[i] * diagonal + error + doubt <= 0;
        diagonal_[i] = slack ? 1 : diagonal;
        lower_[i] = slack ? 0 : lower;
        upper_[i] = slack ? 0 : upper;
        change_[i] = slack ? -pull_[i] : error;
    };
    const double spacing = def_.node_spacing;
    const double doubt = first ? kNearlyTaut * spacing : 0;
    WINDLASS_LANES
    for (int i = 0; i < n - 1; ++i)
        row(i, spacing, spacing, spacing / def_.stiffness, doubt);
    int slack = 0;
    for (int i = 0; i < n - 1; ++i)
        slack += lower_[i] == 0 && upper_[i] == 0;
    steady_ = slack == 0;
    // The top link is what the windlass made of it, and never given up here: the drive line says when it is
    // slack.
    const double rest = state.top_length + result.travel;
    row(n - 1, state.top_length, rest, (rest + deck_length_) / def_.stiffness, 1e9);
}

/// Finds links that pull in vain along their direction at the start of the step: they turned too far, or a
/// node that the seabed holds turns the pull aside. Lets these (or all) pull along their present direction.
/// Returns whether any did so.
bool ChainSolver::turn_folded_links(int links, bool all) {
    const auto cosine = [&](int i) { return unit_.at(i).dot(direction_.at(i)); };
    int turned = 0;
    for (int i = 0; i < links; ++i)
        turned += cosine(i) < kHardlyTurned;
    if (turned == 0 && !all) return false;

    bool any = false;
    for (int i = 0; i < links; ++i) {
        const Vec3 unit = unit_.at(i);
        bool folded = all || cosine(i) < kFoldCosine;
        if (!folded && cosine(i) < kHardlyTurned) {
            const double shortens = unit.dot(down_.at(i + 1) + up_.at(i));
            folded = shortens < 0.5 * unit.dot(inverse_mass_.at(i) * unit + inverse_mass_.at(i + 1) * unit);
        }
        if (!folded) continue;
        any = any || (pull_[i] > 0 && unit.cross(direction_.at(i)).norm() > 1e-9) || (pull_[i] == 0 && !all);
        direction_.set(i, unit);
        up_.set(i, inverse_mass_.at(i) * unit);
        down_.set(i + 1, inverse_mass_.at(i + 1) * unit);
    }
    return any;
}

/// Solves the rows from the anchor up, closes them with the drive line and takes the changes; returns the
/// largest, N.
double ChainSolver::eliminate(const ChainState& state, double dt, TopDrive& drive, ChainStepResult& result) {
    const int top = state.links - 1;
    // Until the change of each pull is change[i] + upper[i] * (change of link i + 1).
    double upper = 0, change = 0;
    for (int i = 0; i <= top; ++i) {
        const double scale = 1 / (diagonal_[i] - lower_[i] * upper);
        upper = upper_[i] *= scale;
        change = change_[i] = (change_[i] + lower_[i] * change) * scale;
        diagonal_[i] = scale;
    }
    // What is left: pull against travel, one straight line.
    const double yielding = (1 + damping_ + end_tension(top) / def_.stiffness) * diagonal_[top];
    const double half_link = 0.5 * def_.mass_per_metre * state.top_length;
    result.top = {.dt = dt,
                  .pull = pull_[top] + change + yielding * result.travel,
                  .yielding = yielding,
                  .outboard_mass = half_link,
                  .outboard_pull = half_link * kGravity * direction_.z[top]};
    result.travel = drive.travel(result.top);
    change = std::max(0.0, result.top.pull - yielding * result.travel) - pull_[top];

    double largest = std::abs(change);
    pull_[top] += change;
    for (int i = top - 1; i >= 0; --i) {
        change = change_[i] + upper_[i] * change;
        largest = std::max(largest, std::abs(change));
        const double pull = pull_[i] + change;
        steady_ = steady_ && (pull_[i] >= known_[i]) == (pull >= known_[i]);
        pull_[i] = pull;
    }
    return largest;
}

/// Books what the step turned into heat or gave away: each force times the mean of the speeds before and
/// after, which is what it takes from leapfrog's kinetic energy. Called while state still holds the start of
/// the step.
void ChainSolver::account(const ChainState& state, const EnvironmentDef& environment, double dt,
                          const ChainTail& tail, double feed_speed, double travel,
                          EnergyLedger& ledger) const {
    const int n = state.links;
    const auto spring_energy = [](double stiffness, double stretch) {
        return 0.5 * stiffness * std::max(0.0, stretch) * std::max(0.0, stretch);
    };
    Vec3 below = placed_.at(0);
    Vec3 speed_below = 0.5 * (tail.velocity_before + (below - state.position.at(0)) / dt);
    for (int i = 0; i < n; ++i) {
        const Vec3 above = placed_.at(i + 1);
        const Vec3 v = (above - state.position.at(i + 1)) / dt;
        const Vec3 speed = 0.5 * (state.velocity.at(i + 1) + v);
        const bool top = i == n - 1;
        const double rest = link_length(def_, state, i), now = rest + (top ? travel : 0),
                     deck = top ? deck_length_ : 0;
        // What the link took from its ends, less what it stores.
        const double lengthening = (speed - speed_below).dot(direction_.at(i)) - (top ? feed_speed : 0);
        ledger.internal += pull_[i] * lengthening * dt -
                           (spring_energy(def_.stiffness / (now + deck), (above - below).norm() - now) -
                            spring_energy(def_.stiffness / (rest + deck), length_[i] - rest));
        below = above;
        speed_below = speed;
        if (top) break;

        const NodeMedium m = node_medium(def_, environment, state, i + 1);
        const NodeDamping damping =
            node_damping(def_, environment, m, state.velocity.at(i + 1), current_, dt);
        const Vec3 flow = v - damping.current;
        const Vec3 drag =
            damping.normal * flow + (damping.axial - damping.normal) * flow.dot(m.tangent) * m.tangent;
        ledger.drag += dt * drag.dot(speed);
        const double sunk = -environment.depth - above.z();
        ledger.bed -= spring_energy(m.bed_stiffness, sunk) - spring_energy(m.bed_stiffness, m.penetration);
        if (damping.bed_normal > 0) {
            const double support = m.bed_stiffness * sunk - damping.bed_normal * v.z();
            ledger.bed +=
                dt * (damping.friction * (v.x() * speed.x() + v.y() * speed.y()) - support * speed.z());
        }
    }
}

void ChainSolver::finish(ChainState& state, double dt, ChainStepResult& result) {
    const int n = state.links;
    result.tail_impulse = dt * pull_[0] * direction_.at(0);
    result.hawse_impulse = -dt * pull_[n - 1] * direction_.at(n - 1);
    result.top_pull = pull_[n - 1];
    const double rate = 1 / dt;
    WINDLASS_LANES
    for (int i = 0; i <= n; ++i) {
        const Vec3 p = placed_.at(i);
        state.velocity.set(i, (p - state.position.at(i)) * rate);
        state.position.set(i, p);
    }
    WINDLASS_LANES
    for (int i = 0; i < n; ++i) {
        state.tension_before[i] = state.tension[i];
        state.tension[i] = end_tension(i);
    }
    state.top_length += result.travel;
}

} // namespace windlass::physics
