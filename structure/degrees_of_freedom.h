#pragma once
#include <array>
#include <Eigen/SparseCore>
#include <initializer_list>
#include <span>
#include <vector>

#include "base/vec3.h"

namespace tw::structure {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// A rigid frame or drop mass that carries nodes. Small rotations; of a solid's nodes it translates only.
struct RigidPart {
    Vec3 centre = Vec3::Zero();                         ///< of its own mass [m]
    double mass = 0;                                    ///< its own [kg]
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< its own, about the centre [kg m2]
    std::vector<int> nodes;                             ///< that it carries
    bool hinged = false;                                ///< the nodes may turn against it
    std::array<bool, 6> held{};                         ///< displacements along x, y, z and rotations about them
};

/// Which displacements (and, of shells, rotations) of a structure are unknown. "All" are the nodes' `per_node` each (3:
/// displacements; 6: and rotations), node by node, then as many of each rigid part. The unknown ones are what supports
/// and rigid parts leave.
class DegreesOfFreedom {
public:
    DegreesOfFreedom(const std::vector<Vec3>& nodes, int per_node);

    /// Holds the degrees of freedom `which` (0 to per_node - 1) of the nodes. Throws InputError for a freedom or node
    /// that is none.
    void hold(std::span<const int> nodes, std::initializer_list<int> which);
    void clamp(std::span<const int> nodes);  ///< all degrees of freedom
    void hinge(std::span<const int> nodes);  ///< displacements

    /// Returns the part's number. Throws InputError for a part without nodes, a node that is none or that another part
    /// carries, and a mass that is negative or not finite.
    int carry(RigidPart part);

    int per_node() const { return per_node_; }
    int all() const { return per_node_ * static_cast<int>(nodes_.size() + parts_.size()); }
    int first_of_part(int part) const { return per_node_ * (static_cast<int>(nodes_.size()) + part); }
    const std::vector<RigidPart>& parts() const { return parts_; }

    /// All = basis * unknown. Throws InputError if nothing is unknown.
    SparseMatrix basis() const;

    /// Of all: that of a translation by `v`, or with the velocity `v`.
    Eigen::VectorXd translation(const Vec3& v) const;

    /// Loads or a stiffness of the nodes' degrees of freedom, with zeros for those of the parts.
    Eigen::VectorXd widened(const Eigen::VectorXd& of_nodes) const;
    SparseMatrix widened(const SparseMatrix& of_nodes) const;

    /// The mass matrix of all from the nodes' lumped masses and inertias, with that of the parts [kg], [kg m2].
    SparseMatrix mass(const Eigen::VectorXd& of_nodes) const;

private:
    std::vector<Vec3> nodes_;
    int per_node_;
    std::vector<bool> held_;
    std::vector<int> carrier_;  ///< of each node; -1 none
    std::vector<RigidPart> parts_;
};

}  // namespace tw::structure
