#pragma once
// Symmetric 3 x 3 matrices by their components, for loops over nodes that vectorise.

#include "server/physics/base/vec3.hpp"

#include <vector>

namespace windlass::physics {

/// Symmetric 3 x 3 matrix.
struct SymmetricMatrix {
    double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;

    Vec3 operator*(const Vec3& v) const {
        return {xx * v.x() + xy * v.y() + xz * v.z(), xy * v.x() + yy * v.y() + yz * v.z(),
                xz * v.x() + yz * v.y() + zz * v.z()};
    }
    void add(double size, const Vec3& v) { ///< size v v^T
        xx += size * v.x() * v.x(), yy += size * v.y() * v.y(), zz += size * v.z() * v.z();
        xy += size * v.x() * v.y(), xz += size * v.x() * v.z(), yz += size * v.y() * v.z();
    }
    double trace() const { return xx + yy + zz; }
    /// The inverse; the matrix must be positive definite.
    SymmetricMatrix inverse() const {
        const double a = yy * zz - yz * yz, b = xz * yz - xy * zz, c = xy * yz - xz * yy;
        const double scale = 1 / (xx * a + xy * b + xz * c);
        return {.xx = a * scale,
                .yy = (xx * zz - xz * xz) * scale,
                .zz = (xx * yy - xy * xy) * scale,
                .xy = b * scale,
                .xz = c * scale,
                .yz = (xy * xz - xx * yz) * scale};
    }
};

inline SymmetricMatrix operator*(double size, const SymmetricMatrix& m) {
    return {size * m.xx, size * m.yy, size * m.zz, size * m.xy, size * m.xz, size * m.yz};
}

/// The same value in every direction across a unit axis, another along it.
inline SymmetricMatrix about_axis(const Vec3& axis, double across, double along) {
    const double more = along - across;
    return {.xx = across + more * axis.x() * axis.x(),
            .yy = across + more * axis.y() * axis.y(),
            .zz = across + more * axis.z() * axis.z(),
            .xy = more * axis.x() * axis.y(),
            .xz = more * axis.x() * axis.z(),
            .yz = more * axis.y() * axis.z()};
}

/// One such matrix at every node, an array for each component.
struct SymmetricField {
    std::vector<double> xx, yy, zz, xy, xz, yz;

    explicit SymmetricField(int size = 0) : xx(size), yy(size), zz(size), xy(size), xz(size), yz(size) {}
    SymmetricMatrix at(int i) const { return {xx[i], yy[i], zz[i], xy[i], xz[i], yz[i]}; }
    void set(int i, const SymmetricMatrix& m) {
        xx[i] = m.xx, yy[i] = m.yy, zz[i] = m.zz, xy[i] = m.xy, xz[i] = m.xz, yz[i] = m.yz;
    }
};

} // namespace windlass::physics
