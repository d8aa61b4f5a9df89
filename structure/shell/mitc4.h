#pragma once
#include <array>
#include <Eigen/Core>

#include "base/vec3.h"
#include "structure/laminate.h"

namespace tw::structure {

/// Four-node shell with mixed interpolation of the transverse shear (MITC4: Bathe & Dvorkin 1985,
/// doi:10.1002/nme.1620210213): it bends without locking however thin it is. In the element's own plane
///
///   u(z) = u + z theta_y,  v(z) = v - z theta_x                                first-order shear deformation
///   eps0 = (u,x  v,y  u,y + v,x)   kappa = (theta_y,x  -theta_x,y  theta_y,y - theta_x,x)
///   gamma_xi  = (1 - eta)/2 gamma_xi(0, -1) + (1 + eta)/2 gamma_xi(0, 1)       tied at the middles of the edges
///   gamma_eta = (1 - xi)/2 gamma_eta(-1, 0) + (1 + xi)/2 gamma_eta(1, 0)
///   gamma_xi  = w,xi + theta_y x,xi - theta_x y,xi, and so for eta
///
/// A node has three displacements and three rotations, in this order, in global axes. The rotation about the normal is
/// bound to that of the mid-surface by a small stiffness (Hughes & Brezzi 1989, doi:10.1016/0045-7825(89)90124-2). A
/// warped element is a flat one whose corners hang on rigid links to the nodes, so rigid motions strain it not at all.
class Mitc4 {
public:
    using Matrix24 = Eigen::Matrix<double, 24, 24>;
    using Strains = Eigen::Matrix<double, 8, 24>;  ///< (eps0, kappa, gamma) by the 24 displacements and rotations

    /// `along` becomes, within the element's plane, the x axis of its laminate. Throws InputError for corners that span
    /// no area or are not convex, or an `along` across the plane.
    Mitc4(const std::array<Vec3, 4>& corners, const Vec3& along);

    Matrix24 stiffness(const Eigen::Matrix<double, 8, 8>& section) const;
    Strains strains(double xi, double eta) const;

    double area() const { return node_area_.sum(); }                 ///< [m2]
    const Eigen::Vector4d& node_area() const { return node_area_; }  ///< integrals of the shape functions [m2]
    Vec3 normal() const { return axes_.row(2); }
    const Eigen::Matrix3d& axes() const { return axes_; }  ///< rows: the element's x, y, z
    Vec3 centre() const { return centre_; }                ///< mean of the corners [m]
    Vec3 place(double xi, double eta) const;               ///< in the flat element [m]

    /// Where the line through `point` along the normal meets the flat element, as (xi, eta); beyond [-1, 1] outside.
    Eigen::Vector2d coordinates(const Vec3& point) const;

private:
    Vec3 centre_;
    Eigen::Matrix3d axes_;
    Eigen::Matrix<double, 4, 2> xy_;       ///< of the corners in the flat element [m]
    Eigen::Matrix<double, 24, 24> local_;  ///< nodes' global degrees of freedom to those of the flat element's corners
    Eigen::Vector4d node_area_;
};

}  // namespace tw::structure
