#pragma once
#include <string>

#include "structure/solid/solid.h"

namespace tw::structure {

/// Contact without friction of a solid's surface with a rigid plane z = height below it, by a penalty on its nodes:
///
///   f_n = k A_n max(0, height - z_n) e_z,   E = sum_n k A_n max(0, height - z_n)^2 / 2
///
/// A_n is the reference area of the surface about the node. `stiffness` k [Pa/m] is the one parameter: a pressure p
/// presses a node p / k into the plane, and the highest frequency that it adds is sqrt(k A_n / m_n).
class PlaneContact {
public:
    /// Throws InputError for a surface that the mesh has not.
    PlaneContact(const Solid& solid, const std::string& surface, double height, double stiffness);

    double height() const { return height_; }
    void set_height(double height) { height_ = height; }
    Eigen::VectorXd force(const Eigen::VectorXd& u) const;  ///< on the solid's degrees of freedom [N]
    double total(const Eigen::VectorXd& u) const;           ///< the plane's upward force [N]
    double energy(const Eigen::VectorXd& u) const;          ///< [J]
    SparseMatrix tangent(const Eigen::VectorXd& u) const;   ///< of what resists: - d force / d u [N/m]
    double highest_frequency() const;                       ///< largest sqrt(k A_n / m_n) [rad/s]

private:
    double depth(const Eigen::VectorXd& u, std::size_t k) const;

    const Solid* solid_;
    double height_, stiffness_;
    std::vector<int> nodes_;
    std::vector<double> areas_;
};

}  // namespace tw::structure
