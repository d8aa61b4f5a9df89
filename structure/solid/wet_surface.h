#pragma once
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "meshes/query.h"
#include "structure/solid/solid.h"

namespace tw::structure {

/// A named surface of a solid as a fluid sees it: closed, by a fan of triangles over each opening, as over the flanks of
/// a tyre's rim; where the foot of a point lies on its faces; and how they have turned.
class WetSurface {
public:
    /// As the solid stands with the displacements `start`. Throws InputError for a surface that the mesh has not.
    WetSurface(const Solid& solid, const std::string& name, const Eigen::VectorXd& start);

    const Surface& closed() const { return closed_; }            ///< triangles outward, at the start [m]
    const std::vector<double>& areas() const { return areas_; }  ///< of the surface about each node of the solid [m2]

    /// The place of the faces that is nearest to a point, by its shares of a face's four nodes, and what is left.
    struct Foot {
        std::array<int, 4> nodes{};
        std::array<double, 4> shares{};  ///< [-], their sum is 1
        Vec3 arm = Vec3::Zero();         ///< from the foot to the point [m]
    };
    Foot foot(const Vec3& at_start) const;

    /// How each node of the solid has turned since the start, where its nodes are at `x` [m]: by the mean normal of the
    /// faces about it and the direction of one edge. No turn away from the surface.
    std::vector<Eigen::Matrix3d> turns(const std::vector<Vec3>& x) const;

private:
    void close();
    Vec3 corner(const std::vector<Vec3>& x, std::size_t face, std::size_t of) const {
        return x[static_cast<std::size_t>(faces_[face][of])];
    }
    std::vector<Eigen::Matrix3d> frames(const std::vector<Vec3>& x) const;

    std::vector<Vec3> start_;  ///< places of the solid's nodes
    std::vector<std::array<int, 4>> faces_;
    std::vector<int> towards_;  ///< of each node another one along an edge of the surface; -1 off it
    std::vector<double> areas_;
    Surface closed_;
    std::unique_ptr<SurfaceQuery> query_;  ///< of the faces alone, two triangles each
    std::vector<Eigen::Matrix3d> frames_;  ///< at the start
};

}  // namespace tw::structure
