#include "meshes/mass_properties.h"

namespace tw {

// The surface integrals are those of Mirtich 1996 (Fast and accurate computation of polyhedral mass properties, J.
// Graphics Tools 1(2)), written as a sum over the tetrahedra that the triangles span with a reference point.
MassProperties mass_properties(const Surface& surface) {
    MassProperties m;
    const Box box = surface.bounds();
    const Vec3 origin = 0.5 * (box.min + box.max);     // far from the world's origin the sums would cancel digits away
    Vec3 first = Vec3::Zero();                         // integral of x
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();  // integral of x x^T
    for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
        const Vec3 a = surface.corner(t, 0) - origin, b = surface.corner(t, 1) - origin,
                   c = surface.corner(t, 2) - origin;
        const double det = a.dot(b.cross(c));
        const Vec3 sum = a + b + c;
        m.volume += det / 6;
        m.area += surface.area_vector2(t).norm() / 2;
        first += det / 24 * sum;
        second += det / 120 * (sum * sum.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose());
    }
    if (m.volume == 0) {
        m.centroid = origin;
        return m;
    }
    const Vec3 centroid = first / m.volume;
    m.centroid = origin + centroid;
    const Eigen::Matrix3d about_centroid = second - m.volume * centroid * centroid.transpose();
    m.inertia = about_centroid.trace() * Eigen::Matrix3d::Identity() - about_centroid;
    return m;
}

}  // namespace tw
