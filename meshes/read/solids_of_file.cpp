#include "meshes/read/solids_of_file.h"

#include <algorithm>

#include "meshes/read/cad.h"
#include "meshes/read/opened_surface.h"

namespace tw {

std::vector<SolidNames> solids_of_file(const std::filesystem::path& file) {
    const OpenedSurface opened = opened_surface(file);
    if (!opened.names_solids()) return {};
    if (opened.step()) return solids_in_step(file, opened.readable);
    return opened.type == ".obj" ? solids_in_obj(opened.content) : solids_in_stl(opened.content);
}

std::vector<std::string> names_of_bodies(const std::vector<SolidNames>& solids) {
    const auto alone = [&](const std::string& name) {
        return std::ranges::count_if(
                   solids, [&](const SolidNames& names) { return std::ranges::find(names, name) != names.end(); }) == 1;
    };
    std::vector<std::string> bodies;
    for (const SolidNames& names : solids) {
        if (names.empty()) continue;
        const auto first = std::ranges::find_if(names, alone);
        const std::string& name = first != names.end() ? *first : names.front();
        if (std::ranges::find(bodies, name) == bodies.end()) bodies.push_back(name);
    }
    return bodies;
}

}  // namespace tw
