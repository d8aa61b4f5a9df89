#pragma once
#include "structure/shell/shell.h"

namespace tw::structure {

/// A shell whose elements turn as far as they like while each by itself is strained little: the corotational way
/// (Rankin & Brogan 1986, doi:10.1115/1.3264765; Felippa & Haugen 2005, doi:10.1016/j.cma.2004.07.035). A rotation Q
/// goes with each element; what is left of its nodes' motion is small and strains the linear element:
///
///   d_i = Q^T (x_i - c) - (X_i - C),  r_i = log(Q^T R_i),  (n, m) = K (d, r),  turned forward by Q
///
/// Q takes the normal along and, about it, turns by the angle that fits the corners best. The moment that is then left
/// over of the nodes' forces goes to the nodes as the derivative of Q by their places demands, so that every element is
/// balanced where it lies now. A node's degrees of freedom are its displacement and the vector of its whole rotation
/// R_i.
class Corotational {
public:
    explicit Corotational(const Shell& shell);

    /// Forces [N] and moments about global axes [N m] on the six degrees of freedom of every node.
    Eigen::VectorXd internal_force(const Eigen::VectorXd& u) const;
    /// Its derivative by displacements and small further turns about global axes, by differences of the forces.
    SparseMatrix tangent(const Eigen::VectorXd& u) const;
    /// Displacements added, turns about global axes put upon the rotations that are there.
    Eigen::VectorXd moved(const Eigen::VectorXd& u, const Eigen::VectorXd& by) const;
    double energy(const Eigen::VectorXd& u) const;  ///< [J]

    /// An element's 24 degrees of freedom as the linear element sees them, for strains and gauges.
    Eigen::Matrix<double, 24, 1> deformation(const Eigen::VectorXd& u, int element) const;

private:
    using Vector24 = Eigen::Matrix<double, 24, 1>;
    struct Frame {
        Eigen::Matrix3d Q;
        std::array<Vec3, 4> y;  ///< corners about their mean [m]
    };
    Frame frame(const Vector24& u, std::size_t element) const;
    Vector24 deformation(const Frame& frame, const Vector24& u, std::size_t element) const;
    Vector24 force(const Vector24& u, std::size_t element) const;
    Vec3 corner(std::size_t element, int i) const;  ///< of the reference [m]

    const Shell* shell_;
    std::vector<Mitc4::Matrix24> stiffness_;
};

}  // namespace tw::structure
