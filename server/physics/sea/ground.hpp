#pragma once
// The seabed where it is not level: a slope, and on it heights and soils on a grid.
//
// Between the points of the grid the bed is a quadratic B-spline: continuous with its normal, no higher or
// lower than the points around, an even slope where they have one; a peak of one point loses 7/16 of its
// height. The soils' figures go from point to point in the same way. Beyond the edges the bed goes on as
// there.
//
// Chain meets a potential, U = g^2 / 2c for each metre, with g how far it is below the bed, upright, and c
// the soil's compliance: its force, -grad U, can make no energy, whatever the shape of the bed and wherever
// one soil gives way to another.

#include "server/physics/sea/environment.hpp"

#include <vector>

namespace windlass::physics {

/// What departs from a level bed of one soil.
struct GroundDef {
    double slope = 0;                 ///< rad; the bed is at EnvironmentDef::depth below the world's origin
    double slope_towards = 0;         ///< rad clockwise from north, where it goes down
    double west = 0;                  ///< m, world, of the grid's south-western point
    double south = 0;                 ///< m
    double spacing = 10;              ///< m between its points, both ways
    int columns = 0;                  ///< points from west to east; 0: no grid
    int rows = 0;                     ///< points from south to north
    std::vector<double> heights = {}; ///< m above the slope, row by row from the south; none: all 0
    std::vector<Soil> soils = {}; ///< of each point, in the same order; none: the environment's everywhere
};

/// A bed under one point, as chain meets it.
struct BedUnder {
    Vec3 normal = Vec3::UnitZ(); ///< unit vector, out of it
    double penetration = 0;      ///< m along the normal, 0 above the bed
    double stiffness = 0;        ///< N/m along the normal, per m of chain and per m of its width
    double friction = 0;         ///< -
    double suction = 0;          ///< -
};

/// A bed that is made once and shared. All heights are above the level bed, m; x and y in the world, m.
class Ground {
public:
    /// environment: whose soil and bed are where the grid says so, or nothing.
    /// Throws std::invalid_argument where lists and sizes do not fit, or the slope is a wall.
    Ground(const GroundDef& def, const EnvironmentDef& environment);

    double height(double x, double y) const;
    Vec3 normal(double x, double y) const;     ///< unit vector, upwards
    Soil soil(double x, double y) const;       ///< of the nearest point of the grid
    double friction(double x, double y) const; ///< of chain, -
    /// Height below which alone the bed may be: cheap.
    double ceiling(double x, double y) const { return fall_x_ * x + fall_y_ * y + highest_; }
    /// level: m, of the level bed, world; at: m, of the chain.
    BedUnder under(double level, const Vec3& at) const;

    bool has_grid() const { return def_.columns > 0; }
    const GroundDef& def() const { return def_; }

private:
    struct Figures {
        double compliance, friction, suction;
    };
    struct Stencil;
    Stencil around(double x, double y) const;

    GroundDef def_;
    Soil soil_;
    double fall_x_ = 0, fall_y_ = 0; ///< gradient of the slope
    double highest_ = 0;             ///< m, of the grid
    std::vector<double> heights_;    ///< of each point of the grid
    std::vector<Figures> figures_;
};

/// Gives an environment its ground.
void lay_ground(EnvironmentDef& environment, const GroundDef& def);

/// Of any environment, level or not. Heights are z in the world, m.
double bed_height(const EnvironmentDef& environment, double x, double y);
double height_over_bed(const EnvironmentDef& environment, const Vec3& at);
Vec3 bed_normal(const EnvironmentDef& environment, double x, double y);
Soil soil_at(const EnvironmentDef& environment, double x, double y);
BedUnder bed_under(const EnvironmentDef& environment, const Vec3& at);
/// What chain that lies there can be pulled with in any direction before it slides, over its weight; 0 where
/// it slides by itself.
double bed_grip(const EnvironmentDef& environment, double x, double y);

} // namespace windlass::physics
