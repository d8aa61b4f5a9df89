#pragma once
#include <vector>

#include "structure/degrees_of_freedom.h"
#include "structure/mesh.h"
#include "structure/solid/hexahedron.h"

namespace tw::structure {

/// A solid of hexahedra at large strain. Vectors hold three displacements per node.
class Solid {
public:
    /// Throws InputError naming the hexahedron or node: inverted, no volume, a corner or material that is not there, a
    /// material that cannot be, a node of no element.
    Solid(SolidMesh mesh, std::vector<Hyperelastic> materials);

    const SolidMesh& mesh() const { return mesh_; }
    int dofs() const { return 3 * static_cast<int>(mesh_.nodes.size()); }
    const Eigen::VectorXd& mass() const { return mass_; }  ///< lumped [kg]

    double energy(const Eigen::VectorXd& u) const;                   ///< stored [J]
    Eigen::VectorXd internal_force(const Eigen::VectorXd& u) const;  ///< [N]
    SparseMatrix tangent(const Eigen::VectorXd& u) const;            ///< [N/m]

    /// Forces [N] of a pressure [Pa] on a named surface as it lies now (a follower load), against its outward normal:
    /// -p times the integral of N_i n da, exact. Throws InputError for a surface that the mesh has not.
    Eigen::VectorXd pressure_load(const Eigen::VectorXd& u, const std::string& surface, double pressure) const;
    SparseMatrix pressure_tangent(const Eigen::VectorXd& u, const std::string& surface, double pressure) const;

    /// Largest time step of the central difference method [s] in the state u: 2 / omega, omega the highest frequency of
    /// any element by itself (Irons & Ahmad 1980). The state's own tangent: strain changes the limit.
    double explicit_step(const Eigen::VectorXd& u) const;

    const std::vector<Hexahedron>& elements() const { return elements_; }
    const Hyperelastic& material(std::size_t element) const;
    /// Places of an element's nodes in the state u [m].
    Hexahedron::Corners corners(const Eigen::VectorXd& u, std::size_t element) const;

private:
    const std::vector<std::array<int, 4>>& surface(const std::string& name) const;
    Vec3 place(const Eigen::VectorXd& u, int node) const {
        return mesh_.nodes[static_cast<std::size_t>(node)] + u.segment<3>(3 * node);
    }

    SolidMesh mesh_;
    std::vector<Hyperelastic> materials_;
    std::vector<Hexahedron> elements_;
    Eigen::VectorXd mass_;
};

}  // namespace tw::structure
