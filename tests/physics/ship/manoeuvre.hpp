#pragma once
// Turning circle and zig-zag (IMO MSC.137(76)) of any ship that can be stepped with a rudder.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace windlass::physics {

/// Speeds through the water of a ship on trial: m/s, m/s, rad/s.
struct TrialMotion {
    double u = 0, v = 0, r = 0;
};

/// Advances the motion by dt (s) with the rudder (rad) as it is.
using TrialStep = std::function<void(double rudder, double dt, TrialMotion&)>;

/// A ship on trial with her helmsman: rudder 2.34 deg/s.
class Trial {
public:
    Trial(TrialStep step, double speed) : step_(std::move(step)), speed_(speed) { motion_.u = speed; }

    struct Turn {
        double advance = 0, diameter = 0; ///< m, at 90 and 180 degrees
        double speed = 0;                 ///< of that before, when she turns steadily
        double rate = 0;                  ///< rad/s
    };
    Turn turn(double rudder) {
        Turn turn;
        while (std::abs(heading_) < 3 * std::numbers::pi) {
            go(rudder);
            if (turn.advance == 0 && std::abs(heading_) >= 0.5 * std::numbers::pi) turn.advance = x_;
            if (turn.diameter == 0 && std::abs(heading_) >= std::numbers::pi) turn.diameter = std::abs(y_);
        }
        turn.speed = std::hypot(motion_.u, motion_.v) / speed_;
        turn.rate = motion_.r;
        return turn;
    }

    /// rad, first and second overshoot; first to the side of the angle.
    std::array<double, 2> zigzag(double angle) {
        std::array<double, 2> overshoot{};
        double to = angle;
        for (double& over : overshoot) {
            while (heading_ * std::copysign(1, to) < std::abs(angle))
                go(to);
            to = -to;
            double most = 0;
            while (motion_.r * to < 0) {
                go(to);
                most = std::max(most, std::abs(heading_));
            }
            over = most - std::abs(angle);
        }
        return overshoot;
    }

private:
    void go(double ordered) {
        constexpr double kStep = 0.05, kRate = 2.34 * std::numbers::pi / 180;
        rudder_ += std::clamp(ordered - rudder_, -kRate * kStep, kRate * kStep);
        step_(rudder_, kStep, motion_);
        heading_ += kStep * motion_.r;
        x_ += kStep * (motion_.u * std::cos(heading_) - motion_.v * std::sin(heading_));
        y_ += kStep * (motion_.u * std::sin(heading_) + motion_.v * std::cos(heading_));
    }

    TrialStep step_;
    double speed_, rudder_ = 0, heading_ = 0, x_ = 0, y_ = 0;
    TrialMotion motion_;
};

} // namespace windlass::physics
