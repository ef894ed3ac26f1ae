#pragma once
// One elastic catenary in its vertical plane, with seabed contact and friction. Sources: Irvine (1981),
// "Cable Structures", section 2.4 (elastic catenary); Jonkman (2007), "Dynamics modeling and loads analysis
// of an offshore floating wind turbine", NREL/TP-500-41958, equations 2-35 to 2-38 (with the seabed's
// friction) and 2-39 to 2-41 (starting guess); the same stand in MAP and MoorPy.
//
// H is the horizontal pull, the same wherever the line hangs, V the vertical pull at the upper end. A line
// that reaches the bed hangs from each of its ends down to a touchdown, and lies between.

#include <Eigen/Core>

namespace windlass::lab {

/// SI; x from the lower end towards the upper, z upwards from the lower end.
class PlaneCatenary {
public:
    /// Unstretched length (m), weight in water (N/m), EA (N), friction (-).
    PlaneCatenary(double length, double weight, double stiffness, double friction)
        : length_(length), weight_(weight), stiffness_(stiffness), friction_(friction) {}

    /// Finds the line between ends that lie x apart and at the given heights above the bed (m; the bed out of
    /// reach: infinite).
    void solve(double x, double low, double high);

    /// Place of the point at unstretched length s, m.
    Eigen::Vector2d place(double s) const;

    /// Tension at unstretched length s, N.
    double tension(double s) const;

private:
    double sag_x(double v) const;
    double sag_z(double v) const;
    Eigen::Vector2d arc(double v) const { return {sag_x(v), sag_z(v)}; }
    double rubbing() const;
    double lying_stretched(double lying, double part) const;
    double lifts(double height) const;
    double excess(double h);
    bool lies_on_bed();
    void hang();
    Eigen::Vector2d reach() const { return arc(vertical_) - arc(vertical_ - weight_ * length_); }
    Eigen::Matrix2d jacobian() const;

    double length_, weight_, stiffness_, friction_;
    double span_ = 0, rise_ = 0, low_ = 0, high_ = 0;
    double horizontal_ = 0;   ///< H, N
    double vertical_ = 0;     ///< V at the upper end, N
    double vertical_low_ = 0; ///< at the lower end where the line also hangs down from it, N
    bool hanging_ = false;    ///< none of it on the bed
};

} // namespace windlass::lab
