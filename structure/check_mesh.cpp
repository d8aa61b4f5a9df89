#include "structure/check_mesh.h"

#include <fmt/format.h>

#include <map>
#include <numeric>

#include "base/errors.h"

namespace tw::structure {
namespace {

constexpr double none = 1e-9;  ///< areas and volumes below this share of the edges' square or cube are none

struct Checked {
    const std::filesystem::path& file;

    [[noreturn]] void refuse(int number, const std::string& why) const {
        throw InputError(fmt::format("{}: element {} {}", file.string(), number, why));
    }

    void quadrilateral(const std::array<int, 4>& q, const std::vector<Vec3>& nodes, int number) const {
        const auto at = [&](std::size_t k) { return nodes[static_cast<std::size_t>(q[k % 4])]; };
        const Vec3 area = (at(2) - at(0)).cross(at(3) - at(1)) / 2;
        double longest = 0;
        for (std::size_t k = 0; k < 4; ++k) longest = std::max(longest, (at(k + 1) - at(k)).squaredNorm());
        if (!(area.norm() > none * longest)) refuse(number, "has no area; remove it, or move its nodes apart");
        for (std::size_t k = 0; k < 4; ++k)
            if (!((at(k + 1) - at(k)).cross(at(k + 3) - at(k)).dot(area) > none * longest * area.norm()))
                refuse(number,
                       fmt::format("is not convex at its corner {}; expected its corners in turn round it", k + 1));
    }

    /// The Jacobian at each corner, by the edges that meet there.
    void hexahedron(const std::array<int, 8>& h, const std::vector<Vec3>& nodes, int number) const {
        static constexpr std::size_t along[8][3] = {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7},
                                                    {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};
        const auto at = [&](std::size_t k) { return nodes[static_cast<std::size_t>(h[k])]; };
        for (std::size_t k = 0; k < 8; ++k) {
            const Vec3 a = at(along[k][0]) - at(k), b = at(along[k][1]) - at(k), c = at(along[k][2]) - at(k);
            const double volume = a.cross(b).dot(c), edges = std::max({a.norm(), b.norm(), c.norm()});
            if (!(volume > none * edges * edges * edges))
                refuse(number, fmt::format("{} at its corner {}; expected its lower face counter-clockwise seen from "
                                           "above, then the upper one",
                                           volume < 0 ? "is turned inside out" : "has no volume", k + 1));
        }
    }

    template <std::size_t N>
    void connected(const std::vector<std::array<int, N>>& elements, std::size_t nodes,
                   const std::vector<int>& numbers) const {
        std::vector<int> part(nodes);
        std::iota(part.begin(), part.end(), 0);
        const auto root = [&](int n) {
            while (part[static_cast<std::size_t>(n)] != n) n = part[static_cast<std::size_t>(n)];
            return n;
        };
        for (const auto& e : elements)
            for (const int n : e) part[static_cast<std::size_t>(root(n))] = root(e[0]);
        for (std::size_t k = 0; k < elements.size(); ++k)
            if (root(elements[k][0]) != root(elements[0][0]))
                refuse(numbers[k], fmt::format("hangs together with element {} by no node: the mesh has parts that are "
                                               "not connected; merge the nodes where they meet, or make bodies of them",
                                               numbers[0]));
    }

    /// An edge that two elements share is walked once each way.
    void oriented(const ShellMesh& shell, const std::vector<int>& numbers) const {
        std::map<std::pair<int, int>, int> walked;
        for (std::size_t k = 0; k < shell.quads.size(); ++k)
            for (std::size_t i = 0; i < 4; ++i) {
                const auto [edge, first] =
                    walked.emplace(std::pair(shell.quads[k][i], shell.quads[k][(i + 1) % 4]), numbers[k]);
                if (!first)
                    refuse(numbers[k],
                           fmt::format("is turned the other way than element {} beside it; expected all corners "
                                       "counter-clockwise seen from one side",
                                       edge->second));
            }
    }
};

}  // namespace

void check_mesh(const MeshFile& mesh, const std::filesystem::path& file) {
    const Checked checked{file};
    for (std::size_t k = 0; k < mesh.shell.quads.size(); ++k)
        checked.quadrilateral(mesh.shell.quads[k], mesh.shell.nodes, mesh.quad_numbers[k]);
    for (std::size_t k = 0; k < mesh.solid.hexahedra.size(); ++k)
        checked.hexahedron(mesh.solid.hexahedra[k], mesh.solid.nodes, mesh.hexahedron_numbers[k]);
    checked.oriented(mesh.shell, mesh.quad_numbers);
    checked.connected(mesh.shell.quads, mesh.shell.nodes.size(), mesh.quad_numbers);
    checked.connected(mesh.solid.hexahedra, mesh.solid.nodes.size(), mesh.hexahedron_numbers);
}

}  // namespace tw::structure
