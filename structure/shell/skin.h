#pragma once
#include <vector>

#include "meshes/surface.h"
#include "structure/shell/shell.h"

namespace tw::structure {

/// The closed surface about a shell that a fluid sees: both faces and the rim. Each of its points hangs on a node by an
/// arm r along the mean normal there, so that
///
///   x = X + r + u + theta x r,   v = u' + theta' x r                           where the surface is and how it moves
///   f_node += F,  m_node += r x F                                              what forces F on its points do
///
/// The second is the transpose of the first: forces, moments and the power F . v pass over without loss, whatever the
/// fluid's method. Rotations are small, as the shell's are.
class Skin {
public:
    /// `thickness` [m]: that of the surface, at least the laminate's; larger where a fluid cannot resolve the laminate.
    /// Throws InputError for one that is smaller, and for an edge that more than two elements share.
    Skin(const Shell& shell, double thickness);

    const Surface& reference() const { return surface_; }  ///< triangles outward
    Surface now(const Eigen::VectorXd& u) const;
    std::vector<Vec3> velocity(const Eigen::VectorXd& v) const;  ///< of its points [m/s]

    /// Forces and moments on the shell's degrees of freedom of forces [N] on the surface's points.
    Eigen::VectorXd load(const std::vector<Vec3>& forces) const;
    /// The points' share of a pressure [Pa] on each triangle of the surface as given: -p A n / 3 to each corner [N].
    static std::vector<Vec3> forces(const Surface& now, const std::vector<double>& pressure);

private:
    Surface surface_;
    std::vector<int> node_;  ///< on which each point hangs
    std::vector<Vec3> arm_;  ///< [m]
    int dofs_;
};

}  // namespace tw::structure
