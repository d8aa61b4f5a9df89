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
    const auto has = [](const SolidNames& names, const std::string& name) {
        return std::ranges::find(names, name) != names.end();
    };
    const auto alone = [&](const std::string& name) {
        return std::ranges::count_if(solids, [&](const SolidNames& names) { return has(names, name); }) == 1;
    };
    std::vector<std::string> shared;
    for (const SolidNames& names : solids)
        if (!names.empty() && std::ranges::none_of(names, alone)) shared.push_back(names.front());
    std::vector<std::string> bodies;
    for (const SolidNames& names : solids) {
        if (names.empty()) continue;
        const auto together = std::ranges::find_if(shared, [&](const std::string& name) { return has(names, name); });
        const std::string& name = together != shared.end() ? *together : *std::ranges::find_if(names, alone);
        if (std::ranges::find(bodies, name) == bodies.end()) bodies.push_back(name);
    }
    return bodies;
}

}  // namespace tw
