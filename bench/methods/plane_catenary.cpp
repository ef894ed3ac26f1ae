#include "bench/methods/plane_catenary.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace windlass::lab {

void PlaneCatenary::solve(double x, double low, double high) {
    span_ = std::max(x, 1e-9 * length_);
    low_ = low < 1e-3 * length_ ? 0 : low; // an end that lies on the bed may have sunk in a little
    high_ = std::max(0.0, high);
    rise_ = high - low;
    hanging_ = !lies_on_bed();
    if (hanging_) hang();
}

Eigen::Vector2d PlaneCatenary::place(double s) const {
    if (hanging_) {
        const double from = vertical_ - weight_ * length_;
        return arc(from + weight_ * s) - arc(from);
    }
    const double off = vertical_low_ / weight_, on = length_ - vertical_ / weight_;
    if (s < off)
        return {sag_x(vertical_low_) - sag_x(vertical_low_ - weight_ * s), sag_z(weight_ * (off - s)) - low_};
    if (s > on)
        return {span_ - sag_x(vertical_) + sag_x(weight_ * (s - on)), sag_z(weight_ * (s - on)) - low_};
    // Between the touchdowns, stretched by what friction leaves of the pull; slack lies evenly.
    const double from = sag_x(vertical_low_), to = span_ - sag_x(vertical_);
    const double whole = lying_stretched(on - off, on - off);
    const double part = on > off ? whole - lying_stretched(on - off, on - s) : 0;
    return {from + (to - from) * (whole > 0 ? part / whole : 0), -low_};
}

double PlaneCatenary::tension(double s) const {
    if (hanging_) return std::hypot(horizontal_, vertical_ - weight_ * (length_ - s));
    const double off = vertical_low_ / weight_, on = length_ - vertical_ / weight_;
    if (s < off) return std::hypot(horizontal_, weight_ * (off - s));
    if (s > on) return std::hypot(horizontal_, weight_ * (s - on));
    return std::max(0.0, horizontal_ - rubbing() * (on - s));
}

/// Of a hanging line from its apex to where the vertical pull is v, m: Irvine's parametric form.
double PlaneCatenary::sag_x(double v) const {
    if (horizontal_ <= 0) return 0;
    return horizontal_ / weight_ * std::asinh(v / horizontal_) + horizontal_ * v / (weight_ * stiffness_);
}
double PlaneCatenary::sag_z(double v) const {
    return (std::hypot(horizontal_, v) - horizontal_) / weight_ + 0.5 * v * v / (weight_ * stiffness_);
}

/// Friction counts where the lower end lies on the bed; a line that hangs at both ends is pulled alike
/// from both.
double PlaneCatenary::rubbing() const {
    return low_ > 0 ? 0 : friction_ * weight_;
}

/// Stretched length of the uppermost part (m, unstretched) of all that lies on the bed.
double PlaneCatenary::lying_stretched(double lying, double part) const {
    part = std::min(part, lying);
    const double loss = rubbing();
    const double pulled = loss > 0 ? std::min(part, horizontal_ / loss) : part;
    return part + (horizontal_ - 0.5 * loss * pulled) * pulled / stiffness_;
}

/// Vertical pull that lifts a hanging part to the given height, N. Newton from the inextensible line's,
/// which is above it: the function is convex, so that it comes down to the root without passing it.
double PlaneCatenary::lifts(double height) const {
    double v = std::sqrt(weight_ * height * (weight_ * height + 2 * horizontal_));
    for (int k = 0; k < 30 && v > 0; ++k) {
        const double slope = v / (weight_ * std::hypot(horizontal_, v)) + v / (weight_ * stiffness_);
        const double change = (sag_z(v) - height) / slope;
        v -= change;
        if (std::abs(change) < 1e-13 * v) break;
    }
    return v;
}

/// Metres by which the line at this H reaches further than its ends lie apart; not a number where it is
/// all off the bed.
double PlaneCatenary::excess(double h) {
    horizontal_ = h;
    vertical_low_ = lifts(low_);
    vertical_ = lifts(high_);
    const double lying = length_ - (vertical_low_ + vertical_) / weight_;
    if (lying < 0) return std::numeric_limits<double>::quiet_NaN();
    return sag_x(vertical_low_) + sag_x(vertical_) + lying_stretched(lying, lying) - span_;
}

/// Solves the line with a part on the bed. False if there is none.
bool PlaneCatenary::lies_on_bed() {
    if (!std::isfinite(low_) || weight_ <= 0) return false;
    double below = 0;
    const double slack = excess(0);
    if (std::isnan(slack)) return false;
    if (slack >= 0) return true; // more chain than room: it hangs straight down and lies in a heap
    double above = 0.01 * weight_ * length_, end = excess(above);
    while (end < 0) {
        below = above;
        above *= 4;
        end = excess(above);
    }
    // A line all off the bed counts as too far: the root, if there is one, is below.
    bool found = !std::isnan(end);
    for (int k = 0; k < 200 && above - below > 1e-14 * above; ++k) {
        const double middle = 0.5 * (below + above), value = excess(middle);
        if (value < 0) {
            below = middle;
        } else {
            above = middle;
            found = found || !std::isnan(value);
        }
    }
    if (!found) return false;
    return !std::isnan(excess(above)) || !std::isnan(excess(below));
}

/// Solves the line that hangs free of the bed: Newton on H and V.
void PlaneCatenary::hang() {
    const double chord2 = span_ * span_ + rise_ * rise_;
    const double bow = length_ * length_ <= chord2
                           ? 0.2
                           : std::sqrt(3 * ((length_ * length_ - rise_ * rise_) / (span_ * span_) - 1));
    horizontal_ = std::max(std::abs(weight_ * span_ / (2 * bow)), 1e-9 * weight_ * length_);
    vertical_ = 0.5 * weight_ * (rise_ / std::tanh(bow) + length_);
    const Eigen::Vector2d goal(span_, rise_);
    Eigen::Vector2d miss = reach() - goal;
    for (int k = 0; k < 100 && miss.norm() > 1e-12 * length_; ++k) {
        const Eigen::Vector2d change = jacobian().fullPivLu().solve(miss);
        const double h = horizontal_, v = vertical_;
        double share = 1;
        Eigen::Vector2d next = miss;
        for (int halving = 0; halving < 40; ++halving, share *= 0.5) {
            horizontal_ = h - share * change.x();
            vertical_ = v - share * change.y();
            if (horizontal_ <= 0) continue; // a line that hangs has none or pulls inwards
            next = reach() - goal;
            if (next.norm() < miss.norm()) break;
        }
        if (next.norm() >= miss.norm()) {
            horizontal_ = h, vertical_ = v;
            return;
        }
        miss = next;
    }
}
Eigen::Matrix2d PlaneCatenary::jacobian() const {
    const double h = horizontal_, v = vertical_, u = vertical_ - weight_ * length_;
    const double top = std::hypot(h, v), foot = std::hypot(h, u), along = length_ / stiffness_;
    Eigen::Matrix2d j;
    j(0, 0) = (std::asinh(v / h) - std::asinh(u / h) - v / top + u / foot) / weight_ + along;
    j(0, 1) = j(1, 0) = (h / top - h / foot) / weight_;
    j(1, 1) = (v / top - u / foot) / weight_ + along;
    return j;
}

} // namespace windlass::lab
