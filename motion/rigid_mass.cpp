#include "motion/rigid_mass.h"

#include <fmt/format.h>
#include <Eigen/Eigenvalues>

#include "meshes/mass_properties.h"

namespace tw {

RigidMass solid_mass(const Surface& surface, double density) {
    const MassProperties m = mass_properties(surface);
    return {density * m.volume, m.centroid, density * m.inertia};
}

RigidMass with_centre(const RigidMass& of, const Vec3& centre) {
    const Vec3 d = of.centre - centre;
    RigidMass moved = of;
    moved.centre = centre;
    moved.inertia -= of.mass * (d.squaredNorm() * Eigen::Matrix3d::Identity() - d * d.transpose());
    return moved;
}

std::string impossible(const RigidMass& m) {
    if (!(m.mass > 0)) return fmt::format("a mass of {:.6g} kg", m.mass);
    if (!m.inertia.allFinite()) return "an inertia that is not a number";
    const Vec3 principal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(m.inertia).eigenvalues();
    if (!(principal[0] > 0))
        return fmt::format("principal moments of inertia {:.6g}, {:.6g}, {:.6g} kg m2, of which one is not positive",
                           principal[0], principal[1], principal[2]);
    if (principal[2] > (principal[0] + principal[1]) * (1 + 1e-9))
        return fmt::format(
            "principal moments of inertia {:.6g}, {:.6g}, {:.6g} kg m2, of which the last is larger than the sum of "
            "the others",
            principal[0], principal[1], principal[2]);
    return {};
}

}  // namespace tw
