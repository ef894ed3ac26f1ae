#include "server/physics/tackle/hawse_pipe_fit.hpp"

#include "server/physics/anchor/anchor.hpp"
#include "server/physics/base/closest.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::physics {

namespace {

constexpr double kBend = 12;          ///< diameters of chain: radius of the lip; tuned
constexpr double kFunnel = 0.3;       ///< m; tuned
constexpr double kLook = 3;           ///< m from the lip in which the plating is sought
constexpr double kFlattest = 0.5;     ///< sine of the bore's slope: 30 degrees
constexpr double kSteepest = 0.96592; ///< 75 degrees

/// Normal of the plating nearest to a point of it.
Vec3 plating(const ObstacleMesh& hull, const Vec3& point) {
    std::vector<int> near(512);
    near.resize(hull.near(point - Vec3::Constant(kLook), point + Vec3::Constant(kLook), near));
    double min = 1e300;
    Vec3 normal = Vec3::UnitX();
    for (const int t : near) {
        const MeshTriangle& triangle = hull.triangle(t);
        const double square =
            (point - closest_on_triangle(triangle.corner, triangle.normal, point).point).squaredNorm();
        if (square < min) min = square, normal = triangle.normal;
    }
    return normal;
}

/// Shank along the bore's axis, shackle so far (m) inboard of the mouth: whether anything else of the anchor
/// would be inside the ship.
bool inside(const HawsePipe& pipe, const ObstacleMesh& hull, double inboard, Anchor& anchor) {
    anchor.hang(pipe.mouth + inboard * pipe.bore, Eigen::Quaterniond(anchor_axes(pipe.bore, pipe.bore)));
    HullTouches touches;
    touches.find(anchor, 0, {&hull, {}, {}, &pipe});
    return !touches.empty();
}

/// m, inboard of the mouth, at which the shackle is when the first of crown and flukes touches the plating.
double seat(const HawsePipe& pipe, const AnchorDef& def, const ObstacleMesh& hull) {
    constexpr double kStep = 0.05, kSharp = 1e-6; // m
    Anchor anchor(def, 0, {}, {});
    anchor.turn_flukes(-def.fluke_angle);
    double in = 0;
    while (in < def.shank_length && !inside(pipe, hull, in + kStep, anchor))
        in += kStep;
    double step = 0.5 * kStep;
    while (step > kSharp) {
        if (!inside(pipe, hull, in + step, anchor)) in += step;
        step *= 0.5;
    }
    return in;
}

} // namespace

Eigen::Matrix3d anchor_axes(const Vec3& shank, const Vec3& across) {
    Eigen::Matrix3d axes;
    axes.col(0) = shank;
    axes.col(1) = Vec3::UnitZ().cross(across).normalized();
    axes.col(2) = axes.col(0).cross(axes.col(1));
    return axes;
}

HawsePipe fit_hawse_pipe(const ShipDef& ship, const WindlassDef& windlass, const ChainDef& chain,
                         const AnchorDef& anchor, const ObstacleMesh& hull, double side) {
    HawsePipe pipe;
    pipe.lip = {ship.hawse_forward, -side * ship.hawse_outboard, ship.hawse_height};
    const double sine =
        std::clamp(windlass.hawse_pipe_height / windlass.hawse_pipe_length, kFlattest, kSteepest);
    const Vec3 out = plating(hull, pipe.lip);
    const Vec3 inboard = -Vec3(out.x(), out.y(), 0).normalized();
    pipe.bore = std::sqrt(1 - sine * sine) * inboard + sine * Vec3::UnitZ();
    pipe.bend = kBend * chain.diameter;
    // The lip lies off the axis by what the bend takes; the shank has as much room, and passes the lip.
    const double offset = pipe.bend * (1 - sine);
    const Vec3 upper = Vec3::UnitZ() - sine * pipe.bore; // of the bore's section
    pipe.mouth = pipe.lip + offset * upper.normalized();
    pipe.room = offset + 0.02;
    pipe.funnel = kFunnel;
    pipe.seat = seat(pipe, anchor, hull);
    return pipe;
}

} // namespace windlass::physics
