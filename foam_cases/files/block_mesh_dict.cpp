#include "foam_cases/files/case_files.h"

namespace tw {
namespace {

/// Number of vertex (i, j, k) of the lattice of block corners.
std::size_t vertex(const CasePlan& plan, std::size_t i, std::size_t j, std::size_t k) {
    return (k * plan.axes[1].planes.size() + j) * plan.axes[0].planes.size() + i;
}

/// Outer faces of all blocks on one side (axis 0..2, low or high).
List side_faces(const CasePlan& plan, std::size_t axis, bool high) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    List faces;
    for (std::size_t b = 0; b < plan.axes[v].cells.size(); ++b)
        for (std::size_t a = 0; a < plan.axes[u].cells.size(); ++a) {
            const auto corner = [&](std::size_t du, std::size_t dv) {
                std::size_t index[3];
                index[axis] = high ? plan.axes[axis].cells.size() : 0;
                index[u] = a + du;
                index[v] = b + dv;
                return Value(vertex(plan, index[0], index[1], index[2]));
            };
            // Outward normals: u x v points along +axis.
            if (high)
                faces.push_back(List{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)});
            else
                faces.push_back(List{corner(0, 0), corner(0, 1), corner(1, 1), corner(1, 0)});
        }
    return faces;
}

}  // namespace

/// system/blockMeshDict: cubes of the far spacing; block faces lie on still water and on the faces of water blocks and
/// box obstacles.
std::string block_mesh_dict(const CasePlan& plan) {
    const auto& [x, y, z] = plan.axes;
    List vertices, blocks, boundary;
    for (const double pz : z.planes)
        for (const double py : y.planes)
            for (const double px : x.planes) vertices.push_back(Vec3(px, py, pz));
    for (std::size_t k = 0; k < z.cells.size(); ++k)
        for (std::size_t j = 0; j < y.cells.size(); ++j)
            for (std::size_t i = 0; i < x.cells.size(); ++i) {
                const auto at = [&](std::size_t di, std::size_t dj, std::size_t dk) {
                    return Value(vertex(plan, i + di, j + dj, k + dk));
                };
                blocks.push_back(Value::sequence({Word("hex"),
                                                  List{at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0), at(0, 0, 1),
                                                       at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)},
                                                  List{x.cells[i], y.cells[j], z.cells[k]}, Word("simpleGrading"),
                                                  List{x.grows[i], y.grows[j], z.grows[k]}}));
            }
    for (std::size_t s = 0; s < plan.sides.size(); ++s) {
        const Patch& p = plan.sides[s];
        const bool of_slab = plan.extrude && p.empty;
        boundary.push_back(Value::named(Word(of_slab ? slab_side(p) : p.name),
                                        Dictionary{{"type", Word(of_slab ? "symmetryPlane" : p.mesh_type())},
                                                   {"faces", side_faces(plan, s / 2, s % 2 == 1)}}));
    }
    return foam_file("dictionary", "blockMeshDict",
                     {{"scale", 1},
                      {"convertToMeters", 1},  // the same, for releases that do not know `scale`
                      {"vertices", vertices},
                      {"blocks", blocks},
                      {"edges", List{}},
                      {"boundary", boundary}});
}

}  // namespace tw
