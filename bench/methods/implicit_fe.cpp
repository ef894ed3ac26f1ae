// Finite elements in time steps of the generalised-alpha method, each solved by Newton's iteration on Eigen's
// sparse LDLT: what a general-purpose code does with a line of bars.
// Sources: Chung and Hulbert (1993), "A time integration algorithm for structural dynamics with improved
// numerical dissipation", J. Appl. Mech. 60, equations 14 to 25, with the internal force weighted between the
// two ends of the step; Crisfield (1991), "Non-linear finite element analysis", chapter 3, for the two-node
// bar in large displacements.
//
// Unknown are all three coordinates of every free node, so the matrix is general, symmetric and sparse. Bars
// pull and never push. A step that Newton does not solve is halved.

#include "bench/methods/list.hpp"
#include "bench/methods/lumped_line.hpp"
#include "server/physics/chain/chain_forces.hpp"

#include <Eigen/Cholesky>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>

namespace windlass::lab {

namespace {

using Mat3 = Eigen::Matrix3d;
using Vector = Eigen::VectorXd;

/// Spectral radius at infinite frequency. Above 0.4 bars that go slack and taut in turn feed the highest
/// modes until a fold or a fall of slack chain grows without bound; the error of a swing is twice that of
/// 0.6.
constexpr double kRho = 0.2;
constexpr double kAlphaM = (2 * kRho - 1) / (kRho + 1), kAlphaF = kRho / (kRho + 1);
constexpr double kGamma = 0.5 - kAlphaM + kAlphaF;
constexpr double kBeta = 0.25 * (1 - kAlphaM + kAlphaF) * (1 - kAlphaM + kAlphaF);

constexpr int kMaxIterations = 30;
constexpr int kMaxHalvings = 8;
constexpr int kMaxTrials = 10;
constexpr double kOvershoot = 0.8;  ///< of the slope, on the other side: Crisfield (1991), section 9.2
constexpr double kRounding = 1e-14; ///< of a place, in sums of many terms

/// Place, velocity, acceleration and internal and external force of all nodes at one instant.
struct Instant {
    Vector x, v, a, force;
};

class ImplicitFe final : public Method {
public:
    ImplicitFe(const Problem& problem, int links, double dt, const MethodSettings& settings)
        : line_(problem, links, dt),
          dt_(dt),
          max_iterations_(settings.iterations > 0 ? settings.iterations : kMaxIterations),
          tangent_(line_.nodes(), Vec3::UnitZ()),
          mass_(line_.nodes()),
          friction_(line_.nodes()),
          bed_damper_(line_.nodes()),
          wet_(line_.nodes()) {
        Field position, velocity;
        line_.start(position, velocity);
        held_position_ = position, held_velocity_ = velocity;
        now_.x = now_.v = now_.a = now_.force = Vector::Zero(3 * line_.nodes());
        for (int i = 0; i < line_.nodes(); ++i)
            node(now_.x, i) = position.at(i), node(now_.v, i) = velocity.at(i);
        freeze(now_);
        evaluate(now_, 0, 0);
        for (int i = line_.first; i <= line_.last; ++i)
            node(now_.a, i) = mass_[i].ldlt().solve(node(now_.force, i));
        set_up_matrix();
        next_ = now_;
    }

    void step() override {
        iterations_ = 0;
        advance(static_cast<double>(taken_) * dt_, dt_, 0);
        ++taken_;
    }
    double time() const override { return static_cast<double>(taken_) * dt_; }
    int links() const override { return line_.links; }
    Vec3 position(int i) const override { return now_.x.segment<3>(3 * i); }
    Vec3 velocity(int i) const override { return now_.v.segment<3>(3 * i); }
    double tension(int link) const override { return bar(now_, link).tension; }
    int iterations() const override { return iterations_; }
    long unsolved() const override { return unsolved_; }

private:
    struct Bar {
        Vec3 unit;
        double size, tension;
    };

    static Eigen::VectorBlock<Vector, 3> node(Vector& v, int i) { return v.segment<3>(3 * i); }

    Bar bar(const Instant& s, int i) const {
        const Vec3 span = s.x.segment<3>(3 * i + 3) - s.x.segment<3>(3 * i);
        const double size = std::max(span.norm(), 1e-12 * line_.rest), stretch = size - line_.rest;
        const Vec3 unit = span / size;
        if (stretch <= 0) return {unit, size, 0};
        const double rate = unit.dot(s.v.segment<3>(3 * i + 3) - s.v.segment<3>(3 * i));
        return {unit, size, std::max(0.0, line_.spring * stretch + line_.damper * rate)};
    }

    /// Lower half of the matrix: block (i, i) and, where the next node is free too, block (i + 1, i). Column
    /// c of node i holds them one after the other, so that entries are written in place.
    void set_up_matrix() {
        const int free = line_.last - line_.first + 1;
        std::vector<Eigen::Triplet<double>> entries;
        for (int i = 0; i < free; ++i)
            for (int column = 0; column < 3; ++column)
                for (int row = 0; row < (i + 1 < free ? 6 : 3); ++row)
                    entries.emplace_back(3 * i + row, 3 * i + column, 1);
        matrix_.resize(3 * free, 3 * free);
        matrix_.setFromTriplets(entries.begin(), entries.end());
        solver_.analyzePattern(matrix_);
    }
    void add(int row_node, int column_node, const Mat3& block) {
        if (column_node < line_.first || row_node > line_.last) return;
        const int column = column_node - line_.first, offset = row_node == column_node ? 0 : 3;
        for (int c = 0; c < 3; ++c) {
            double* entry = matrix_.valuePtr() + matrix_.outerIndexPtr()[3 * column + c] + offset;
            for (int r = 0; r < 3; ++r)
                entry[r] += block(r, c);
        }
    }

    /// What a step takes from its start: directions along the line, mass with added mass, most friction
    /// and immersion.
    void freeze(const Instant& s) {
        const physics::ChainDef& def = line_.problem.line;
        const physics::EnvironmentDef& sea = line_.problem.environment;
        for (int i = 0; i < line_.nodes(); ++i) {
            const int up = std::min(i + 1, line_.links), down = std::max(i - 1, 0);
            const Vec3 across = s.x.segment<3>(3 * up) - s.x.segment<3>(3 * down);
            if (across.norm() > 1e-9 * line_.rest) tangent_[i] = across.normalized();
            const double z = s.x[3 * i + 2], sunk = std::max(0.0, -sea.depth - z);
            wet_[i] = std::clamp(0.5 - z / line_.length[i], 0.0, 1.0);
            const double water = wet_[i] * line_.displaced[i], body = line_.mass[i] + line_.end_mass[i];
            const double normal = body + def.added_mass_normal * water;
            const double axial = body + def.added_mass_axial * water;
            mass_[i] = normal * Mat3::Identity() + (axial - normal) * tangent_[i] * tangent_[i].transpose();
            bed_damper_[i] = 2 * std::sqrt(line_.bed_spring[i] * normal); // critical: chain does not bounce
            friction_[i] = sea.bed_friction * line_.bed_spring[i] * sunk;
        }
    }

    /// Forces of an instant; adds, unless both factors are 0, the matrix by * dF/dx and by_speed * dF/dv with
    /// their signs turned.
    void evaluate(Instant& s, double by, double by_speed) {
        s.force.setZero();
        for (int i = 0; i < line_.links; ++i) {
            const Bar b = bar(s, i);
            if (b.tension <= 0) continue;
            node(s.force, i) += b.tension * b.unit;
            node(s.force, i + 1) -= b.tension * b.unit;
            if (by == 0) continue;
            const Mat3 along = b.unit * b.unit.transpose();
            const Mat3 block = (by * line_.spring + by_speed * line_.damper) * along +
                               by * b.tension / b.size * (Mat3::Identity() - along);
            add(i, i, block), add(i + 1, i + 1, block), add(i + 1, i, -block);
        }
        for (int i = line_.first; i <= line_.last; ++i) {
            Mat3 block = Mat3::Zero();
            node(s.force, i) += drag(s, i, by_speed, block) + bed(s, i, by, by_speed, block);
            s.force[3 * i + 2] -=
                (line_.mass[i] - wet_[i] * line_.displaced[i]) * physics::kGravity + line_.end_weight[i];
            if (by != 0) add(i, i, block);
        }
    }

    /// Morison's drag across and along.
    Vec3 drag(const Instant& s, int i, double by_speed, Mat3& block) const {
        if (wet_[i] == 0 || !line_.in_water()) return Vec3::Zero();
        const physics::ChainDef& def = line_.problem.line;
        const double area =
            0.5 * line_.problem.environment.water_density * def.diameter * line_.length[i] * wet_[i];
        const Vec3& t = tangent_[i];
        const Vec3 flow = s.v.segment<3>(3 * i) - line_.current;
        const double along = flow.dot(t);
        const Vec3 across = flow - along * t;
        const double speed = across.norm();
        const Mat3 lengthwise = t * t.transpose();
        if (by_speed != 0) {
            Mat3 slope = speed * (Mat3::Identity() - lengthwise);
            if (speed > 0) slope += across * across.transpose() / speed;
            block += by_speed * area *
                     (def.drag_normal * slope + 2 * def.drag_axial * std::abs(along) * lengthwise);
        }
        return -area * (def.drag_normal * speed * across + def.drag_axial * std::abs(along) * along * t);
    }

    /// The seabed: spring, damper and friction.
    Vec3 bed(const Instant& s, int i, double by, double by_speed, Mat3& block) const {
        const double sunk = -line_.problem.environment.depth - s.x[3 * i + 2];
        if (sunk <= 0) return Vec3::Zero();
        const double support = line_.bed_spring[i] * sunk - bed_damper_[i] * s.v[3 * i + 2];
        if (support <= 0) return Vec3::Zero(); // mud does not pull
        const Eigen::Vector2d slide = s.v.segment<2>(3 * i);
        const double speed = slide.norm();
        const double rate = friction_[i] / std::max(speed, physics::kFrictionCreep);
        Eigen::Matrix2d slope = rate * Eigen::Matrix2d::Identity();
        if (speed > physics::kFrictionCreep) slope -= rate * slide * slide.transpose() / (speed * speed);
        block.topLeftCorner<2, 2>() += by_speed * slope;
        block(2, 2) += by * line_.bed_spring[i] + by_speed * bed_damper_[i];
        return {-rate * slide.x(), -rate * slide.y(), support};
    }

    /// One step of h from the given time, in halves where it does not converge.
    void advance(double time, double h, int halved) {
        freeze(now_);
        const bool solved = solve(time + h, h);
        if (solved || halved == kMaxHalvings) {
            std::swap(now_, next_);
            unsolved_ += solved ? 0 : 1;
            return;
        }
        advance(time, 0.5 * h, halved + 1);
        advance(time + 0.5 * h, 0.5 * h, halved + 1);
    }

    /// Newton's iteration for the end of a step; a change that does not lessen the miss is halved, since
    /// links that go slack or taut lead it astray. False if it did not converge.
    bool solve(double end, double h) {
        const double by = 1 - kAlphaF, by_speed = by * kGamma / (kBeta * h);
        const double inertia = (1 - kAlphaM) / (kBeta * h * h);
        const int from = 3 * line_.first, size = static_cast<int>(matrix_.rows());
        // N, as production's; no less than what rounding of places leaves.
        const double stiff = inertia * line_.min_mass() + by * line_.spring + by_speed * line_.damper;
        const double tolerance =
            std::max(1e-4 * line_.min_mass() * physics::kGravity, kRounding * line_.problem.length * stiff);
        next_.x = now_.x + h * now_.v;
        hold(end, next_);
        double slope = 0, share = 1; // of the energy along the last change; how much of that was taken
        for (int k = 0, trial = 0; k < max_iterations_;) {
            move(h);
            std::fill_n(matrix_.valuePtr(), matrix_.nonZeros(), 0.0);
            evaluate(next_, by, by_speed);
            right_ = by * next_.force.segment(from, size) + kAlphaF * now_.force.segment(from, size);
            for (int i = line_.first; i <= line_.last; ++i) {
                const Vec3 a = (1 - kAlphaM) * node(next_.a, i) + kAlphaM * node(now_.a, i);
                right_.segment<3>(3 * i - from) -= mass_[i] * a;
                add(i, i, inertia * mass_[i]);
            }
            const double miss = right_.cwiseAbs().maxCoeff();
            if (!std::isfinite(miss)) return false;
            if (miss < tolerance) return true;
            if (const double here = k > 0 ? right_.dot(change_) : 0;
                here < -kOvershoot * slope && trial < kMaxTrials) {
                ++trial;
                const double less = share * std::clamp(slope / (slope - here), 0.1, 0.9);
                next_.x.segment(from, size) -= (share - less) * change_;
                share = less;
                continue;
            }
            solver_.factorize(matrix_);
            if (solver_.info() != Eigen::Success) return false;
            change_ = solver_.solve(right_);
            slope = right_.dot(change_), share = 1, trial = 0;
            next_.x.segment(from, size) += change_;
            ++k, ++iterations_;
        }
        return false;
    }

    /// Velocity and acceleration that go with the place at the end of the step (Newmark).
    void move(double h) {
        for (int i = 3 * line_.first; i < 3 * (line_.last + 1); ++i) {
            const double gone = next_.x[i] - now_.x[i];
            next_.a[i] = gone / (kBeta * h * h) - now_.v[i] / (kBeta * h) - (0.5 / kBeta - 1) * now_.a[i];
            next_.v[i] = now_.v[i] + h * ((1 - kGamma) * now_.a[i] + kGamma * next_.a[i]);
        }
    }

    void hold(double time, Instant& s) {
        line_.hold(time, held_position_, held_velocity_);
        for (const int end : {0, line_.links}) {
            if (end >= line_.first && end <= line_.last) continue;
            node(s.x, end) = held_position_.at(end);
            node(s.v, end) = held_velocity_.at(end);
        }
    }

    LumpedLine line_;
    double dt_;
    int max_iterations_;
    Instant now_, next_;
    std::vector<Vec3> tangent_;
    std::vector<Mat3> mass_;       ///< kg, added mass included
    std::vector<double> friction_; ///< N, most that the seabed's can be, of its load as the last step left it
    std::vector<double> bed_damper_; ///< N s/m
    std::vector<double> wet_;        ///< 0..1
    Field held_position_, held_velocity_;
    Eigen::SparseMatrix<double> matrix_;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>> solver_;
    Vector right_, change_;
    int iterations_ = 0;
    long taken_ = 0, unsolved_ = 0;
};

} // namespace

MethodEntry implicit_fe_method() {
    return {"implicit_fe",
            "finite elements, generalised-alpha and Newton on a general sparse solver (Chung, Hulbert 1993)",
            "",
            [](const Problem& problem, int links, double dt,
               const MethodSettings& settings) -> std::unique_ptr<Method> {
                return std::make_unique<ImplicitFe>(problem, links, dt, settings);
            }};
}

} // namespace windlass::lab
