#pragma once
#include <Eigen/SparseCore>
#include <vector>

#include "structure/degrees_of_freedom.h"
#include "structure/mesh.h"
#include "structure/shell/mitc4.h"

namespace tw::structure {

/// A shell of one laminate: its mesh, elements, stiffness, masses and loads. Vectors hold six degrees of freedom per
/// node. Displacements are small; see corotational.h for large rotations.
class Shell {
public:
    /// `along` is the laminate's x axis, projected on each element; its z axis is the elements' normal. Throws
    /// InputError naming the element or node: no area, not convex, a corner that is no node, a node of no element.
    Shell(ShellMesh mesh, Laminate laminate, const Vec3& along = Vec3::UnitX());

    const ShellMesh& mesh() const { return mesh_; }
    const Laminate& laminate() const { return laminate_; }
    const std::vector<Mitc4>& elements() const { return elements_; }
    int dofs() const { return 6 * static_cast<int>(mesh_.nodes.size()); }

    SparseMatrix stiffness() const;

    /// Lumped: the mass of the area about each node, with the section's inertia for its rotations [kg], [kg m2].
    const Eigen::VectorXd& mass() const { return mass_; }

    /// Forces [N] of a pressure [Pa], one for each element, on the face out of which the normal points.
    Eigen::VectorXd pressure_load(const Eigen::VectorXd& pressure) const;
    /// Weight of the shell [N].
    Eigen::VectorXd weight(const Vec3& gravity) const;

    /// The six degrees of freedom of an element's four nodes, out of those of all.
    Eigen::Matrix<double, 24, 1> of_element(const Eigen::VectorXd& all, int element) const;

    /// Largest time step of the central difference method [s]: 2 / omega, omega the highest frequency of any element by
    /// itself, above which the structure has none (Irons & Ahmad, Techniques of Finite Elements, 1980).
    double explicit_step() const;

private:
    ShellMesh mesh_;
    Laminate laminate_;
    std::vector<Mitc4> elements_;
    Eigen::VectorXd mass_;
};

}  // namespace tw::structure
