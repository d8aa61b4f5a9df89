#include "meshes/check/edges.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <unordered_map>

namespace tw {

Edges find_edges(const Surface& surface) {
    Edges e;
    e.uses.reserve(3 * surface.triangles.size());
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = surface.triangles[t][k], b = surface.triangles[t][(k + 1) % 3];
            e.uses.push_back({std::min(a, b), std::max(a, b), static_cast<int>(t), a < b});
        }
    std::ranges::sort(e.uses, {}, [](const EdgeUse& u) { return std::tuple(u.low, u.high, u.triangle); });
    for (std::size_t i = 0; i < e.uses.size();) {
        std::size_t end = i + 1;
        while (end < e.uses.size() && e.uses[end].low == e.uses[i].low && e.uses[end].high == e.uses[i].high) ++end;
        e.edges.push_back({i, end});
        i = end;
    }
    return e;
}

Shells find_shells(const Surface& surface, const Edges& edges) {
    std::vector<int> parent(surface.triangles.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](int t) {
        while (parent[static_cast<std::size_t>(t)] != t) {
            int& up = parent[static_cast<std::size_t>(t)];
            up = parent[static_cast<std::size_t>(up)];
            t = up;
        }
        return t;
    };
    for (const Edge& edge : edges.edges)
        for (std::size_t i = edge.begin + 1; i < edge.end; ++i) {
            const int a = root(edges.uses[edge.begin].triangle), b = root(edges.uses[i].triangle);
            parent[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
        }
    Shells shells;
    std::vector<int> number(surface.triangles.size(), -1);
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        int& n = number[static_cast<std::size_t>(root(static_cast<int>(t)))];
        if (n < 0) n = shells.count++;
        shells.of_triangle.push_back(n);
    }
    return shells;
}

std::vector<Loop> find_holes(const Surface& surface, const Edges& edges) {
    std::unordered_map<int, std::vector<int>> next;  // against the direction of the triangle at the rim
    for (const Edge& edge : edges.edges)
        if (edges.open(edge)) {
            const EdgeUse& use = edges.uses[edge.begin];
            if (use.forward)
                next[use.high].push_back(use.low);
            else
                next[use.low].push_back(use.high);
        }
    std::vector<int> starts;
    for (const auto& [from, to] : next) starts.push_back(from);
    std::ranges::sort(starts);
    std::vector<bool> done(surface.points.size(), false);
    std::vector<Loop> loops;
    for (const int start : starts) {
        Loop loop;
        int at = start;
        while (!done[static_cast<std::size_t>(at)]) {
            const auto step = next.find(at);
            if (step == next.end() || step->second.size() != 1) break;
            done[static_cast<std::size_t>(at)] = true;
            loop.push_back(at);
            at = step->second.front();
        }
        if (loop.size() >= 3 && at == start) loops.push_back(std::move(loop));
    }
    return loops;
}

}  // namespace tw
