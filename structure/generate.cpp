#include "structure/generate.h"

#include <algorithm>

namespace tw::structure {

ShellMesh plate_mesh(double a, double b, int cells_x, int cells_y) {
    ShellMesh m;
    const auto node = [&](int i, int j) { return j * (cells_x + 1) + i; };
    for (int j = 0; j <= cells_y; ++j)
        for (int i = 0; i <= cells_x; ++i) {
            const int n = node(i, j);
            m.nodes.emplace_back(a * i / cells_x, b * j / cells_y, 0);
            if (i == 0) m.sets["x_min"].push_back(n);
            if (i == cells_x) m.sets["x_max"].push_back(n);
            if (j == 0) m.sets["y_min"].push_back(n);
            if (j == cells_y) m.sets["y_max"].push_back(n);
            if (i == 0 || i == cells_x || j == 0 || j == cells_y) m.sets["edges"].push_back(n);
        }
    for (int j = 0; j < cells_y; ++j)
        for (int i = 0; i < cells_x; ++i)
            m.quads.push_back({node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)});
    return m;
}

SolidMesh block_mesh(std::array<int, 3> cells, const std::function<Vec3(const Vec3&)>& place, bool closed_x) {
    SolidMesh m;
    const int nx = cells[0], ny = cells[1], nz = cells[2];
    const int columns = closed_x ? nx : nx + 1;
    const auto node = [&](int i, int j, int k) { return (k * (ny + 1) + j) * columns + i % columns; };
    const auto into = [&](const char* set, bool is_in, int n) {
        if (is_in) m.sets[set].push_back(n);
    };
    for (int k = 0; k <= nz; ++k)
        for (int j = 0; j <= ny; ++j)
            for (int i = 0; i < columns; ++i) {
                m.nodes.push_back(place(Vec3(double(i) / nx, double(j) / ny, double(k) / nz)));
                into("x_min", !closed_x && i == 0, node(i, j, k));
                into("x_max", !closed_x && i == nx, node(i, j, k));
                into("y_min", j == 0, node(i, j, k));
                into("y_max", j == ny, node(i, j, k));
                into("z_min", k == 0, node(i, j, k));
                into("z_max", k == nz, node(i, j, k));
            }
    for (int k = 0; k < nz; ++k)
        for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx; ++i) {
                const std::array<int, 8> c{
                    node(i, j, k),     node(i + 1, j, k),     node(i + 1, j + 1, k),     node(i, j + 1, k),
                    node(i, j, k + 1), node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1), node(i, j + 1, k + 1)};
                m.hexahedra.push_back(c);
                if (!closed_x && i == 0) m.surfaces["x_min"].push_back({c[0], c[4], c[7], c[3]});
                if (!closed_x && i == nx - 1) m.surfaces["x_max"].push_back({c[1], c[2], c[6], c[5]});
                if (j == 0) m.surfaces["y_min"].push_back({c[0], c[1], c[5], c[4]});
                if (j == ny - 1) m.surfaces["y_max"].push_back({c[3], c[7], c[6], c[2]});
                if (k == 0) m.surfaces["z_min"].push_back({c[0], c[3], c[2], c[1]});
                if (k == nz - 1) m.surfaces["z_max"].push_back({c[4], c[5], c[6], c[7]});
            }
    m.material.assign(m.hexahedra.size(), 0);
    return m;
}

SolidMesh joined(const std::vector<SolidMesh>& parts, double tolerance) {
    SolidMesh all;
    for (const SolidMesh& part : parts) {
        std::vector<int> to;  // the node of the whole for each of the part's
        for (const Vec3& p : part.nodes) {
            const auto same = std::find_if(all.nodes.begin(), all.nodes.end(),
                                           [&](const Vec3& q) { return (p - q).norm() < tolerance; });
            to.push_back(static_cast<int>(same - all.nodes.begin()));
            if (same == all.nodes.end()) all.nodes.push_back(p);
        }
        const auto renamed = [&](auto corners) {
            for (int& n : corners) n = to[static_cast<std::size_t>(n)];
            return corners;
        };
        for (const auto& h : part.hexahedra) all.hexahedra.push_back(renamed(h));
        all.material.insert(all.material.end(), part.material.begin(), part.material.end());
        for (const auto& [name, nodes] : part.sets) {
            auto& set = all.sets[name];
            for (const int n : renamed(nodes))
                if (std::find(set.begin(), set.end(), n) == set.end()) set.push_back(n);
        }
        for (const auto& [name, quads] : part.surfaces)
            for (const auto& quad : quads) all.surfaces[name].push_back(renamed(quad));
    }
    return all;
}

}  // namespace tw::structure
