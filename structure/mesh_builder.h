#pragma once
#include <array>
#include <map>
#include <string>
#include <vector>

#include "structure/mesh.h"

namespace tw::structure {

/// A mesh as it stands in its file: nodes and elements by the file's own numbers.
class MeshBuilder {
public:
    bool has_node(int number) const { return nodes_.contains(number); }
    /// False where the number is taken.
    bool add_node(int number, const Vec3& place) { return nodes_.emplace(number, place).second; }  // [m]
    /// Nodes by number; a set that is not there begins empty.
    std::vector<int>& set(const std::string& name) { return sets_[name]; }
    const std::map<std::string, std::vector<int>>& sets() const { return sets_; }
    void add_quad(int number, const std::array<int, 4>& nodes);
    void add_hexahedron(int number, const std::array<int, 8>& nodes, const std::string& material);
    bool has_elements() const { return !quads_.empty() || !hexahedra_.empty(); }

    /// The mesh, with its nodes numbered anew.
    MeshFile finish() const;

private:
    template <std::size_t N>
    std::vector<std::array<int, N>> used(std::vector<std::array<int, N>> elements, std::vector<Vec3>& nodes,
                                         NodeSets& sets) const;

    std::map<int, Vec3> nodes_;
    std::map<std::string, std::vector<int>> sets_;
    std::vector<std::array<int, 4>> quads_;
    std::vector<std::array<int, 8>> hexahedra_;
    std::vector<int> quad_numbers_, hexahedron_numbers_, material_;
    std::vector<std::string> materials_;
};

}  // namespace tw::structure
