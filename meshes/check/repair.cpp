#include <fmt/format.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolygon.h>

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <map>
#include <set>

#include "meshes/check/edges.h"
#include "meshes/check/hole.h"
#include "meshes/check/shells.h"
#include "meshes/check/sliver.h"
#include "meshes/health.h"

namespace tw {
namespace {

std::string at(const Vec3& p) { return fmt::format("near ({:.4g}, {:.4g}, {:.4g}) m", p.x(), p.y(), p.z()); }

/// A triangle without area hides in a long side of its neighbour: the middle corner splits that neighbour instead, so
/// that the surface stays closed. Triangles with two corners at one place have been removed by welding before.
std::size_t remove_slivers(Surface& s) {
    std::size_t removed = 0;
    for (std::size_t round = 0; round < 1000; ++round) {
        int sliver = -1;
        for (int t = 0; t < static_cast<int>(s.triangles.size()) && sliver < 0; ++t)
            if (has_no_area(s, t)) sliver = t;
        if (sliver < 0) break;
        const auto corners = s.triangles[static_cast<std::size_t>(sliver)];
        std::size_t k = 0;  // corner opposite to the longest side
        double longest = -1;
        for (std::size_t i = 0; i < 3; ++i) {
            const double side = (s.points[static_cast<std::size_t>(corners[(i + 1) % 3])] -
                                 s.points[static_cast<std::size_t>(corners[(i + 2) % 3])])
                                    .squaredNorm();
            if (side > longest) {
                longest = side;
                k = i;
            }
        }
        const int split = corners[k], a = corners[(k + 1) % 3], b = corners[(k + 2) % 3];
        s.triangles.erase(s.triangles.begin() + sliver);
        ++removed;
        for (std::size_t t = 0; t < s.triangles.size(); ++t) {
            const auto n = s.triangles[t];
            std::size_t e = 0;
            while (e < 3 && !((n[e] == a && n[(e + 1) % 3] == b) || (n[e] == b && n[(e + 1) % 3] == a))) ++e;
            if (e == 3 || n[(e + 2) % 3] == split) continue;
            s.triangles[t] = {n[e], split, n[(e + 2) % 3]};
            s.triangles.push_back({split, n[(e + 1) % 3], n[(e + 2) % 3]});
            break;
        }
    }
    return removed;
}

std::array<int, 3> sorted_corners(std::array<int, 3> t) {
    std::ranges::sort(t);
    return t;
}

/// Two parts that touch have a wall inside, of pairs of faces that lie upon each other and look opposite ways. A patch of
/// such pairs goes where the surface is closed without it, all along its outline. Elsewhere it is one wall, exported
/// twice, or a plate without thickness.
std::size_t remove_inner_walls(Surface& s) {
    const auto turned = [](const std::array<int, 3>& t) {  // an odd number of swaps from its sorted corners
        return (t[0] > t[1]) != ((t[1] > t[2]) != (t[0] > t[2]));
    };
    std::map<std::array<int, 3>, std::array<int, 2>> faces;
    for (const auto& t : s.triangles) ++faces[sorted_corners(t)][turned(t)];
    const auto paired = [&](const std::array<int, 3>& t) {
        const auto& [one, other] = faces.at(sorted_corners(t));
        return one == 1 && other == 1;
    };
    const auto edge = [](const std::array<int, 3>& t, std::size_t k) { return std::minmax({t[k], t[(k + 1) % 3]}); };
    std::map<std::pair<int, int>, int> of_others;
    std::map<std::pair<int, int>, std::vector<std::array<int, 3>>> of_pairs;
    for (const auto& t : s.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            if (paired(t))
                of_pairs[edge(t, k)].push_back(sorted_corners(t));
            else
                ++of_others[edge(t, k)];
    std::set<std::array<int, 3>> seen, gone;
    for (const auto& [first, count] : faces) {
        if (!paired(first) || !seen.insert(first).second) continue;
        std::vector<std::array<int, 3>> patch{first};
        bool bounded = false, closed_without = true;
        for (std::size_t i = 0; i < patch.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                const auto side = edge(patch[i], k);
                const auto found = of_others.find(side);
                const int others = found == of_others.end() ? 0 : found->second;
                const bool outline = of_pairs[side].size() == 2;
                bounded = bounded || outline;
                closed_without = closed_without && others != 1 && (others > 0 || !outline);
                for (const auto& next : of_pairs[side])
                    if (seen.insert(next).second) patch.push_back(next);
            }
        if (bounded && closed_without) gone.insert(patch.begin(), patch.end());
    }
    return std::erase_if(s.triangles, [&](const auto& t) { return gone.contains(sorted_corners(t)); });
}

std::size_t remove_duplicates(Surface& s) {
    std::set<std::array<int, 3>> seen;
    const std::size_t before = s.triangles.size();
    std::erase_if(s.triangles, [&](const auto& t) { return !seen.insert(sorted_corners(t)).second; });
    return before - s.triangles.size();
}

/// Neighbours get the same direction as the first triangle of their shell. Returns how many were turned.
std::size_t make_consistent(Surface& s) {
    const Edges edges = find_edges(s);
    std::vector<std::vector<std::pair<int, bool>>> neighbours(s.triangles.size());  // (triangle, faces the other way)
    for (const Edge& e : edges.edges)
        if (e.count() == 2) {
            const EdgeUse &u = edges.uses[e.begin], &v = edges.uses[e.begin + 1];
            neighbours[static_cast<std::size_t>(u.triangle)].emplace_back(v.triangle, edges.flipped(e));
            neighbours[static_cast<std::size_t>(v.triangle)].emplace_back(u.triangle, edges.flipped(e));
        }
    std::vector<int> turn(s.triangles.size(), -1);
    std::size_t turned = 0;
    for (std::size_t start = 0; start < turn.size(); ++start) {
        if (turn[start] >= 0) continue;
        turn[start] = 0;
        std::vector<int> shell{static_cast<int>(start)};
        std::size_t count = 0;
        for (std::size_t i = 0; i < shell.size(); ++i)
            for (const auto& [other, opposite] : neighbours[static_cast<std::size_t>(shell[i])])
                if (int& state = turn[static_cast<std::size_t>(other)]; state < 0) {
                    state = turn[static_cast<std::size_t>(shell[i])] ^ static_cast<int>(opposite);
                    count += static_cast<std::size_t>(state);
                    shell.push_back(other);
                }
        // The majority is left as it was; which side is out is decided afterwards.
        const bool majority = 2 * count > shell.size();
        turned += majority ? shell.size() - count : count;
        if (majority)
            for (const int t : shell) turn[static_cast<std::size_t>(t)] ^= 1;
    }
    for (std::size_t t = 0; t < turn.size(); ++t)
        if (turn[t] == 1) std::swap(s.triangles[t][1], s.triangles[t][2]);
    return turned;
}

/// Fills a hole that may be filled with triangles between its rim points; false: it was left open.
bool fill_hole(Surface& s, const Loop& loop, double diagonal) {
    if (!may_be_filled(measured(s, loop), diagonal)) return false;
    vtkNew<vtkPolygon> polygon;
    polygon->GetPointIds()->SetNumberOfIds(static_cast<vtkIdType>(loop.size()));
    polygon->GetPoints()->SetDataTypeToDouble();
    polygon->GetPoints()->SetNumberOfPoints(static_cast<vtkIdType>(loop.size()));
    for (std::size_t i = 0; i < loop.size(); ++i) {
        polygon->GetPointIds()->SetId(static_cast<vtkIdType>(i), static_cast<vtkIdType>(i));
        polygon->GetPoints()->SetPoint(static_cast<vtkIdType>(i), s.points[static_cast<std::size_t>(loop[i])].data());
    }
    vtkNew<vtkIdList> ears;
    if (polygon->EarCutTriangulation(ears) == 0 ||
        ears->GetNumberOfIds() != 3 * (static_cast<vtkIdType>(loop.size()) - 2))
        return false;
    for (vtkIdType i = 0; i < ears->GetNumberOfIds(); i += 3) {
        std::array<int, 3> t{};
        for (vtkIdType k = 0; k < 3; ++k)
            t[static_cast<std::size_t>(k)] = loop[static_cast<std::size_t>(ears->GetId(i + k))];
        s.triangles.push_back(t);
    }
    return true;
}

std::size_t turn_inverted_shells(Surface& s) {
    const Edges edges = find_edges(s);
    if (std::ranges::any_of(edges.edges, [&](const Edge& e) { return e.count() != 2; })) return 0;
    const Shells shells = find_shells(s, edges);
    const auto states = examine_shells(s, shells);
    if (std::ranges::any_of(states, [](const ShellState& state) { return state.within >= 0; }))
        return 0;  // refused anyway
    std::size_t turned = 0;
    for (std::size_t t = 0; t < s.triangles.size(); ++t)
        if (states[static_cast<std::size_t>(shells.of_triangle[t])].volume < 0) {
            std::swap(s.triangles[t][1], s.triangles[t][2]);
            ++turned;
        }
    return turned;
}

}  // namespace

Repaired repair_surface(const Surface& surface) {
    Repaired r{surface, {}};
    for (const Vec3& p : surface.points)
        if (!p.allFinite()) return r;  // nothing to repair: which place was meant is lost
    const Box box = surface.bounds();
    const double diagonal = box.size().norm();
    // Exporters write single precision: corners meant to be one differ by its rounding.
    const double reach = std::max(box.min.cwiseAbs().maxCoeff(), box.max.cwiseAbs().maxCoeff());
    const double tolerance = std::max(1e-6 * diagonal, 4e-7 * reach);
    r.surface = welded(surface, tolerance);
    const std::size_t merged = surface.points.size() - r.surface.points.size();
    if (merged > 0)
        r.done.push_back(
            fmt::format("merged or dropped {} corners closer than {:.2g} m to another or unused", merged, tolerance));
    const std::size_t collapsed = surface.triangles.size() - r.surface.triangles.size();
    const std::size_t slivers = collapsed + remove_slivers(r.surface);
    if (slivers > 0) r.done.push_back(fmt::format("removed {} triangles without area", slivers));
    if (const std::size_t n = remove_inner_walls(r.surface); n > 0)
        r.done.push_back(fmt::format("removed {} triangles of walls inside, where two parts touch", n));
    if (const std::size_t n = remove_duplicates(r.surface); n > 0)
        r.done.push_back(fmt::format("removed {} triangles that were there twice", n));
    if (const std::size_t n = make_consistent(r.surface); n > 0)
        r.done.push_back(fmt::format("turned {} triangles that faced the other way than their neighbours", n));
    for (const Loop& loop : find_holes(r.surface, find_edges(r.surface))) {
        const Vec3 place = r.surface.points[static_cast<std::size_t>(loop.front())];
        if (fill_hole(r.surface, loop, diagonal))
            r.done.push_back(fmt::format("closed a flat hole of {} edges {}", loop.size(), at(place)));
    }
    if (turn_inverted_shells(r.surface) > 0) r.done.push_back("turned the normals outward: the volume was negative");
    r.surface = welded(r.surface);
    return r;
}

}  // namespace tw
