#include "meshes/check/shells.h"

#include <cmath>
#include <map>
#include <memory>

#include "meshes/mass_properties.h"
#include "meshes/query.h"

namespace tw {
namespace {
Surface turned_outward(Surface shell) {
    if (mass_properties(shell).volume < 0)
        for (auto& t : shell.triangles) std::swap(t[1], t[2]);
    return shell;
}
}  // namespace

std::vector<ShellState> examine_shells(const Surface& surface, const Shells& shells) {
    std::vector<std::vector<int>> members(static_cast<std::size_t>(shells.count));
    for (std::size_t t = 0; t < shells.of_triangle.size(); ++t)
        members[static_cast<std::size_t>(shells.of_triangle[t])].push_back(static_cast<int>(t));
    std::vector<ShellState> states;
    std::vector<Surface> parts;
    for (const auto& triangles : members) {
        Surface part{{}, {}};
        for (const int t : triangles) {
            const int n = static_cast<int>(part.points.size());
            for (int k = 0; k < 3; ++k) part.points.push_back(surface.corner(t, k));
            part.triangles.push_back({n, n + 1, n + 2});
        }
        part = welded(part);
        ShellState& state = states.emplace_back();
        state.volume = mass_properties(part).volume;
        state.bounds = part.bounds();
        state.a_corner = part.points.empty() ? Vec3::Zero() : part.points.front();
        parts.push_back(turned_outward(std::move(part)));
    }
    std::map<std::size_t, std::unique_ptr<SurfaceQuery>> queries;  // built only for shells whose box holds another
    for (std::size_t i = 0; i < states.size(); ++i)
        for (std::size_t j = 0; j < states.size(); ++j) {
            if (i == j || !states[j].bounds.contains(states[i].bounds.min) ||
                !states[j].bounds.contains(states[i].bounds.max) ||
                std::abs(states[j].volume) <= std::abs(states[i].volume))
                continue;
            auto& query = queries[j];
            if (!query) query = std::make_unique<SurfaceQuery>(parts[j]);
            const int so_far = states[i].within;
            if (query->inside(states[i].a_corner) &&
                (so_far < 0 || std::abs(states[j].volume) < std::abs(states[static_cast<std::size_t>(so_far)].volume)))
                states[i].within = static_cast<int>(j);
        }
    return states;
}

}  // namespace tw
