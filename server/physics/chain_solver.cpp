#include "server/physics/chain_solver.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace windlass::physics {

namespace {

constexpr int kMostIterations = 20;

/// A link that turns further than this in one step (cosine) is pulled along its new direction instead of its
/// old one: robust, first order. So is a chain whose solution is hard to find.
constexpr double kFoldCosine = 0.9;
constexpr int kPatientIterations = 8;

/// Shortfall of a link's length, as a fraction, within which it is first taken to be taut.
constexpr double kNearlyTaut = 1e-3;

} // namespace

ChainSolver::ChainSolver(const ChainDef& def, int capacity, ForceWeights weights)
    : def_(def),
      weights_(weights),
      direction_(capacity),
      length_(capacity),
      predicted_(capacity + 1),
      inverse_mass_(capacity + 1),
      up_(capacity + 1),
      down_(capacity + 1),
      weight_(capacity),
      known_(capacity),
      pull_(capacity),
      upper_(capacity),
      change_(capacity) {}

ChainStepResult ChainSolver::step(ChainState& state, const EnvironmentDef& environment, double dt,
                                  const ChainTail& tail, TopDrive& drive, const Vec3& hawse,
                                  EnergyLedger* ledger) {
    dt2_ = dt * dt;
    deck_length_ = drive.deck_length();
    current_ = compass(environment.current_towards) * environment.current_speed;
    measure_links(state);
    predict(state, environment, dt, tail, hawse);
    ChainStepResult result;
    // Newton converges quadratically: a last change below a ten-thousandth of a link's weight leaves far
    // less.
    const double tolerance = 1e-4 * def_.mass_per_metre * kGravity * def_.node_spacing;
    result.converged = false;
    while (!result.converged && result.iterations < kMostIterations) {
        ++result.iterations;
        result.converged = newton(state, dt, drive, result) < tolerance;
    }
    for (int i = 0; i < state.links; ++i)
        pull_[i] = std::max(0.0, pull_[i]);
    if (ledger != nullptr) {
        const double feed_speed = 0.5 * (drive.speed_before() + result.travel / dt);
        account(state, environment, dt, tail, feed_speed, result.travel, *ledger);
    }
    finish(state, dt, result);
    return result;
}

void ChainSolver::measure_links(const ChainState& state) {
    const Field& p = state.position;
    for (int i = 0; i < state.links; ++i) {
        const double dx = p.x[i + 1] - p.x[i], dy = p.y[i + 1] - p.y[i], dz = p.z[i + 1] - p.z[i];
        length_[i] = std::sqrt(dx * dx + dy * dy + dz * dz);
        // A link of no length (slack chain fallen onto itself) has no direction; any will do, it does not
        // pull.
        const bool point = length_[i] < 1e-9 * def_.node_spacing;
        const double scale = point ? 0 : 1 / length_[i];
        direction_.x[i] = dx * scale;
        direction_.y[i] = dy * scale;
        direction_.z[i] = point ? 1 : dz * scale;
    }
}

void ChainSolver::predict(const ChainState& state, const EnvironmentDef& environment, double dt,
                          const ChainTail& tail, const Vec3& hawse) {
    const int n = state.links;
    for (int i = 0; i < n; ++i) {
        // A link that was slack has no past to weigh in: its new pull counts whole (implicit Euler).
        const bool fresh = state.tension[i] == 0 || state.tension_before[i] == 0;
        weight_[i] = fresh ? 1 : weights_.next;
        known_[i] = fresh ? 0 : weights_.now * state.tension[i] + weights_.before * state.tension_before[i];
        pull_[i] = known_[i] + weight_[i] * state.tension[i];
    }

    inverse_mass_[0] = tail.inverse_mass;
    predicted_.set(0, state.position.at(0) + dt * tail.velocity);
    for (int i = 1; i < n; ++i) {
        const Vec3 v = state.velocity.at(i);
        const NodeMedium m = node_medium(def_, environment, state, i);
        const NodeDamping damping = node_damping(def_, environment, m, v, current_, dt);
        inverse_mass_[i] = inverse_effective_mass(m, damping, dt);

        const auto along = [&](const Vec3& u, double normal, double axial) {
            return Vec3(normal * u + (axial - normal) * u.dot(m.tangent) * m.tangent);
        };
        Vec3 momentum = along(v, m.mass_normal, m.mass_axial) +
                        dt * along(damping.current, damping.normal, damping.axial);
        momentum.z() -= dt * node_weight(def_, environment, m);
        if (damping.bed_normal > 0) momentum.z() += dt * m.bed_stiffness * m.penetration;
        predicted_.set(i, state.position.at(i) + dt * (inverse_mass_[i] * momentum));
    }
    inverse_mass_[n] = {};
    predicted_.set(n, hawse);
    for (int i = 0; i < n; ++i)
        point_link(i, direction_.at(i));
}

/// Lets link i pull along the given unit vector in this step.
void ChainSolver::point_link(int i, const Vec3& direction) {
    direction_.set(i, direction);
    up_.set(i, inverse_mass_[i] * direction);
    down_.set(i + 1, inverse_mass_[i + 1] * direction);
}

/// Whether a pull along the link's direction at the start of the step would no longer shorten it, now that it
/// lies along the given unit vector: it turned too far, or a node that the seabed holds turns the pull aside.
bool ChainSolver::folded(int i, const Vec3& unit) const {
    const double cosine = unit.dot(direction_.at(i));
    if (cosine < kFoldCosine) return true;
    if (cosine > 0.9999) return false;
    const double shortens = unit.dot(down_.at(i + 1) + up_.at(i));
    return shortens < 0.5 * unit.dot(inverse_mass_[i] * unit + inverse_mass_[i + 1] * unit);
}

/// Tension of link i at the end of the step that goes with its mean pull, N. A pull below what earlier
/// tensions would make up means that the link went slack on the way: chain lets go at once and does not push.
double ChainSolver::end_tension(int i) const {
    return std::max(0.0, pull_[i] - known_[i]) / weight_[i];
}

/// Where node i ends the step under the pulls of this iteration, m.
Vec3 ChainSolver::solved(int i, int links) const {
    Vec3 p = predicted_.at(i);
    if (i < links) p += dt2_ * pull_[i] * up_.at(i);
    if (i > 0) p -= dt2_ * pull_[i - 1] * down_.at(i);
    return p;
}

/// One iteration; returns the largest change of a pull, N.
double ChainSolver::newton(const ChainState& state, double dt, TopDrive& drive, ChainStepResult& result) {
    const int n = state.links, top = n - 1;
    const double damping = def_.damping_time / dt;
    const double gain = (1 + damping) * dt2_;
    double largest = 0;

    // Eliminate from the anchor up, until the change of each pull is change[i] + upper[i] * (change of link i
    // + 1).
    Vec3 below = solved(0, n);
    for (int i = 0; i < n; ++i) {
        const Vec3 above = solved(i + 1, n);
        const Vec3 span = above - below;
        const double length = span.norm();
        const Vec3 unit = length > 0 ? Vec3(span / length) : direction_.at(i);
        if (folded(i, unit) || result.iterations > kPatientIterations) {
            largest =
                std::max(largest, pull_[i] * unit.cross(direction_.at(i)).norm()); // it pulls elsewhere now
            point_link(i, unit);
        }
        const double rest = link_length(def_, state, i);
        const double now = rest + (i == top ? result.travel : 0);
        const double compliance = (now + (i == top ? deck_length_ : 0)) / def_.stiffness;
        const double stretch_before = std::max(0.0, length_[i] - rest);
        const double error =
            (1 + damping) * (length - now) - damping * stretch_before - compliance * end_tension(i);

        double diagonal = gain * unit.dot(down_.at(i + 1) + up_.at(i));
        if (pull_[i] >= known_[i]) diagonal += compliance / weight_[i];
        double lower = i > 0 ? gain * unit.dot(down_.at(i)) : 0;
        double upper = i < top ? gain * unit.dot(up_.at(i + 1)) : 0;
        double right = error;
        // Slack: chain does not push. The first iteration gives links that are nearly taut the benefit of the
        // doubt, else a chain at rest would be found taut only link by link from its ends.
        const double doubt = result.iterations == 1 ? kNearlyTaut * rest : 0;
        if (i < top && pull_[i] + (error + doubt) / diagonal <= 0) {
            diagonal = 1, lower = 0, upper = 0, right = -pull_[i];
        }
        if (i > 0) {
            diagonal -= lower * upper_[i - 1];
            right += lower * change_[i - 1];
        }
        change_[i] = right / diagonal;
        upper_[i] = upper / diagonal;
        if (i == top) {
            // What is left: pull against travel, one straight line. The drive line closes it.
            const double yielding = (1 + damping + end_tension(i) / def_.stiffness) / diagonal;
            const double half_link = 0.5 * def_.mass_per_metre * rest;
            result.top = {.dt = dt,
                          .pull = pull_[i] + change_[i] + yielding * result.travel,
                          .yielding = yielding,
                          .outboard_mass = half_link,
                          .outboard_pull = half_link * kGravity * direction_.z[i]};
            result.travel = drive.travel(result.top);
            change_[i] = std::max(0.0, result.top.pull - yielding * result.travel) - pull_[i];
        }
        below = above;
    }

    double change = 0;
    for (int i = top; i >= 0; --i) {
        change = i == top ? change_[i] : change_[i] + upper_[i] * change;
        largest = std::max(largest, std::abs(change));
        pull_[i] += change;
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
    Vec3 below = solved(0, n);
    Vec3 speed_below = 0.5 * (tail.velocity_before + (below - state.position.at(0)) / dt);
    for (int i = 0; i < n; ++i) {
        const Vec3 above = solved(i + 1, n);
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
    for (int i = 0; i <= n; ++i) {
        const Vec3 p = solved(i, n);
        state.velocity.set(i, (p - state.position.at(i)) / dt);
        state.position.set(i, p);
    }
    for (int i = 0; i < n; ++i) {
        state.tension_before[i] = state.tension[i];
        state.tension[i] = end_tension(i);
    }
    state.top_length += result.travel;
}

} // namespace windlass::physics
