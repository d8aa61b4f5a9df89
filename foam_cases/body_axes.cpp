#include "foam_cases/body_axes.h"

#include <Eigen/Eigenvalues>

namespace tw {

BodyAxes body_axes(const RigidBodySetup& motion) {
    BodyAxes b;
    const auto& about = motion.free.about;
    const int turns = about[0] + about[1] + about[2];
    const Eigen::Matrix3d& inertia = motion.mass.inertia;
    if (turns == 1)
        for (int a = 0; a < 3; ++a)
            if (about[static_cast<std::size_t>(a)]) b.moments = Vec3::Constant(inertia(a, a));
    if (turns < 3) return b;
    if ((inertia - Eigen::Matrix3d(inertia.diagonal().asDiagonal())).norm() < 1e-9 * inertia.norm()) {
        b.moments = inertia.diagonal();
        return b;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(inertia);
    b.axes = solver.eigenvectors();
    if (b.axes.determinant() < 0) b.axes.col(0) = -b.axes.col(0);
    b.moments = solver.eigenvalues();
    return b;
}

}  // namespace tw
