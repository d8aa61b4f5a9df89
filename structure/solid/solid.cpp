#include "structure/solid/solid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "structure/eigenvalues.h"

namespace tw::structure {
namespace {

/// Adds a dense element matrix of three degrees of freedom a node.
template <std::size_t Nodes, class Matrix>
void scatter(const std::array<int, Nodes>& nodes, const Matrix& K, std::vector<Eigen::Triplet<double>>& to) {
    for (int i = 0; i < K.rows(); ++i)
        for (int j = 0; j < K.cols(); ++j)
            to.emplace_back(3 * nodes[static_cast<std::size_t>(i / 3)] + i % 3,
                            3 * nodes[static_cast<std::size_t>(j / 3)] + j % 3, K(i, j));
}

/// The bilinear quadrilateral at its four Gauss points, all of weight 1.
struct QuadPoint {
    double N[4], by_xi[4], by_eta[4];
};
std::array<QuadPoint, 4> quad_points() {
    constexpr double xi[] = {-1, 1, 1, -1}, eta[] = {-1, -1, 1, 1};
    const double g = 1 / std::sqrt(3.0);
    std::array<QuadPoint, 4> points{};
    for (std::size_t q = 0; q < 4; ++q)
        for (std::size_t i = 0; i < 4; ++i) {
            points[q].N[i] = (1 + g * xi[q] * xi[i]) * (1 + g * eta[q] * eta[i]) / 4;
            points[q].by_xi[i] = xi[i] * (1 + g * eta[q] * eta[i]) / 4;
            points[q].by_eta[i] = eta[i] * (1 + g * xi[q] * xi[i]) / 4;
        }
    return points;
}

/// a x b = cross(a) b.
Eigen::Matrix3d cross_matrix(const Vec3& a) {
    Eigen::Matrix3d m;
    m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
    return m;
}
}  // namespace

Solid::Solid(SolidMesh mesh, std::vector<Hyperelastic> materials)
    : mesh_(std::move(mesh)), materials_(std::move(materials)) {
    const int nodes = static_cast<int>(mesh_.nodes.size());
    for (std::size_t m = 0; m < materials_.size(); ++m)
        if (const std::string why = impossible(materials_[m]); !why.empty())
            throw InputError(fmt::format("material {}: {}", m, why));
    mass_ = Eigen::VectorXd::Zero(3 * nodes);
    for (std::size_t e = 0; e < mesh_.hexahedra.size(); ++e) {
        for (const int n : mesh_.hexahedra[e])
            if (n < 0 || n >= nodes) throw InputError(fmt::format("hexahedron {}: node {} does not exist", e, n));
        const int m = mesh_.material.at(e);
        if (m < 0 || m >= static_cast<int>(materials_.size()))
            throw InputError(fmt::format("hexahedron {}: material {} does not exist", e, m));
        try {
            elements_.emplace_back(corners(Eigen::VectorXd::Zero(3 * nodes), e));
        } catch (const InputError& error) { throw InputError(fmt::format("hexahedron {}: {}", e, error.what())); }
        for (std::size_t i = 0; i < 8; ++i)
            mass_.segment<3>(3 * mesh_.hexahedra[e][i]).array() +=
                material(e).density * elements_.back().node_volume()[static_cast<int>(i)];
    }
    for (int n = 0; n < nodes; ++n)
        if (!(mass_[3 * n] > 0)) throw InputError(fmt::format("node {} belongs to no hexahedron", n));
}

const Hyperelastic& Solid::material(std::size_t element) const {
    return materials_[static_cast<std::size_t>(mesh_.material[element])];
}

Hexahedron::Corners Solid::corners(const Eigen::VectorXd& u, std::size_t element) const {
    Hexahedron::Corners x;
    for (int i = 0; i < 8; ++i) x.col(i) = place(u, mesh_.hexahedra[element][static_cast<std::size_t>(i)]);
    return x;
}

double Solid::energy(const Eigen::VectorXd& u) const {
    double sum = 0;
    for (std::size_t e = 0; e < elements_.size(); ++e) sum += elements_[e].energy(corners(u, e), material(e));
    return sum;
}

Eigen::VectorXd Solid::internal_force(const Eigen::VectorXd& u) const {
    Eigen::VectorXd f = Eigen::VectorXd::Zero(dofs());
    for (std::size_t e = 0; e < elements_.size(); ++e) {
        const Hexahedron::Vector24 fe = elements_[e].force(corners(u, e), material(e));
        for (int i = 0; i < 8; ++i)
            f.segment<3>(3 * mesh_.hexahedra[e][static_cast<std::size_t>(i)]) += fe.segment<3>(3 * i);
    }
    return f;
}

SparseMatrix Solid::tangent(const Eigen::VectorXd& u) const {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(elements_.size() * 576);
    for (std::size_t e = 0; e < elements_.size(); ++e)
        scatter(mesh_.hexahedra[e], elements_[e].tangent(corners(u, e), material(e)), entries);
    SparseMatrix K(dofs(), dofs());
    K.setFromTriplets(entries.begin(), entries.end());
    return K;
}

const std::vector<std::array<int, 4>>& Solid::surface(const std::string& name) const {
    const auto found = mesh_.surfaces.find(name);
    if (found == mesh_.surfaces.end()) throw InputError(fmt::format("the mesh has no surface named \"{}\"", name));
    return found->second;
}

Eigen::VectorXd Solid::pressure_load(const Eigen::VectorXd& u, const std::string& name, double pressure) const {
    static const auto points = quad_points();
    Eigen::VectorXd f = Eigen::VectorXd::Zero(dofs());
    for (const auto& quad : surface(name))
        for (const QuadPoint& q : points) {
            Vec3 a = Vec3::Zero(), b = Vec3::Zero();
            for (std::size_t i = 0; i < 4; ++i) {
                a += q.by_xi[i] * place(u, quad[i]);
                b += q.by_eta[i] * place(u, quad[i]);
            }
            for (std::size_t i = 0; i < 4; ++i) f.segment<3>(3 * quad[i]) -= pressure * q.N[i] * a.cross(b);
        }
    return f;
}

SparseMatrix Solid::pressure_tangent(const Eigen::VectorXd& u, const std::string& name, double pressure) const {
    static const auto points = quad_points();
    std::vector<Eigen::Triplet<double>> entries;
    for (const auto& quad : surface(name)) {
        Eigen::Matrix<double, 12, 12> K = Eigen::Matrix<double, 12, 12>::Zero();
        for (const QuadPoint& q : points) {
            Vec3 a = Vec3::Zero(), b = Vec3::Zero();
            for (std::size_t i = 0; i < 4; ++i) {
                a += q.by_xi[i] * place(u, quad[i]);
                b += q.by_eta[i] * place(u, quad[i]);
            }
            for (int i = 0; i < 4; ++i)
                for (int j = 0; j < 4; ++j)  // d(a x b) = a x db - b x da
                    K.block<3, 3>(3 * i, 3 * j) -=
                        pressure * q.N[i] * (q.by_eta[j] * cross_matrix(a) - q.by_xi[j] * cross_matrix(b));
        }
        scatter(quad, K, entries);
    }
    SparseMatrix K(dofs(), dofs());
    K.setFromTriplets(entries.begin(), entries.end());
    return K;
}

double Solid::explicit_step(const Eigen::VectorXd& u) const {
    double highest = 0;  // omega^2
    for (std::size_t e = 0; e < elements_.size(); ++e) {
        Hexahedron::Vector24 root;
        for (int i = 0; i < 8; ++i)
            root.segment<3>(3 * i).setConstant(1 / std::sqrt(material(e).density * elements_[e].node_volume()[i]));
        highest = std::max(highest, largest_eigenvalue(root.asDiagonal() *
                                                       elements_[e].tangent(corners(u, e), material(e)) *
                                                       root.asDiagonal()));
    }
    return 2 / std::sqrt(highest);
}

}  // namespace tw::structure
