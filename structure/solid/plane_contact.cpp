#include "structure/solid/plane_contact.h"

#include <algorithm>
#include <cmath>

#include "structure/solid/wet_surface.h"

namespace tw::structure {

PlaneContact::PlaneContact(const Solid& solid, const std::string& surface, double height, double stiffness)
    : solid_(&solid), height_(height), stiffness_(stiffness) {
    const WetSurface all(solid, surface, Eigen::VectorXd::Zero(solid.dofs()));
    for (std::size_t n = 0; n < all.areas().size(); ++n)
        if (all.areas()[n] > 0) {
            nodes_.push_back(static_cast<int>(n));
            areas_.push_back(all.areas()[n]);
        }
}

double PlaneContact::depth(const Eigen::VectorXd& u, std::size_t k) const {
    const int n = nodes_[k];
    return std::max(0.0, height_ - solid_->mesh().nodes[static_cast<std::size_t>(n)].z() - u[3 * n + 2]);
}

Eigen::VectorXd PlaneContact::force(const Eigen::VectorXd& u) const {
    Eigen::VectorXd f = Eigen::VectorXd::Zero(solid_->dofs());
    for (std::size_t k = 0; k < nodes_.size(); ++k) f[3 * nodes_[k] + 2] = stiffness_ * areas_[k] * depth(u, k);
    return f;
}

double PlaneContact::total(const Eigen::VectorXd& u) const {
    double sum = 0;
    for (std::size_t k = 0; k < nodes_.size(); ++k) sum += stiffness_ * areas_[k] * depth(u, k);
    return sum;
}

double PlaneContact::energy(const Eigen::VectorXd& u) const {
    double sum = 0;
    for (std::size_t k = 0; k < nodes_.size(); ++k) sum += stiffness_ * areas_[k] * std::pow(depth(u, k), 2) / 2;
    return sum;
}

SparseMatrix PlaneContact::tangent(const Eigen::VectorXd& u) const {
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t k = 0; k < nodes_.size(); ++k)
        if (depth(u, k) > 0) entries.emplace_back(3 * nodes_[k] + 2, 3 * nodes_[k] + 2, stiffness_ * areas_[k]);
    SparseMatrix K(solid_->dofs(), solid_->dofs());
    K.setFromTriplets(entries.begin(), entries.end());
    return K;
}

double PlaneContact::highest_frequency() const {
    double most = 0;
    for (std::size_t k = 0; k < nodes_.size(); ++k)
        most = std::max(most, stiffness_ * areas_[k] / solid_->mass()[3 * nodes_[k]]);
    return std::sqrt(most);
}

}  // namespace tw::structure
