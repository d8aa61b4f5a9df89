#include "structure/mesh_builder.h"

#include <algorithm>

namespace tw::structure {

void MeshBuilder::add_quad(int number, const std::array<int, 4>& nodes) {
    quads_.push_back(nodes);
    quad_numbers_.push_back(number);
}

void MeshBuilder::add_hexahedron(int number, const std::array<int, 8>& nodes, const std::string& material) {
    hexahedra_.push_back(nodes);
    hexahedron_numbers_.push_back(number);
    const auto found = std::ranges::find(materials_, material);
    material_.push_back(static_cast<int>(found - materials_.begin()));
    if (found == materials_.end()) materials_.push_back(material);
}

template <std::size_t N>
std::vector<std::array<int, N>> MeshBuilder::used(std::vector<std::array<int, N>> elements, std::vector<Vec3>& nodes,
                                                  NodeSets& sets) const {
    std::map<int, int> to;
    for (const auto& e : elements)
        for (const int id : e) to[id] = 0;
    for (auto& [id, index] : to) {
        index = static_cast<int>(nodes.size());
        nodes.push_back(nodes_.at(id));
    }
    for (auto& e : elements)
        for (int& id : e) id = to.at(id);
    for (const auto& [name, ids] : sets_)
        for (const int id : ids)
            if (to.contains(id)) sets[name].push_back(to.at(id));
    return elements;
}

MeshFile MeshBuilder::finish() const {
    MeshFile mesh;
    mesh.shell.quads = used(quads_, mesh.shell.nodes, mesh.shell.sets);
    mesh.solid.hexahedra = used(hexahedra_, mesh.solid.nodes, mesh.solid.sets);
    mesh.solid.material = material_;
    mesh.materials = materials_;
    mesh.quad_numbers = quad_numbers_;
    mesh.hexahedron_numbers = hexahedron_numbers_;
    return mesh;
}

}  // namespace tw::structure
