#include "meshes/health.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "meshes/check/edges.h"
#include "meshes/check/intersections.h"
#include "meshes/check/shells.h"
#include "meshes/check/sliver.h"
#include "meshes/check/thin_walls.h"

namespace tw {
namespace {
using Level = Finding::Level;

std::string at(const Vec3& p) { return fmt::format("near ({:.4g}, {:.4g}, {:.4g}) m", p.x(), p.y(), p.z()); }

Vec3 middle(const Surface& s, const EdgeUse& use) {
    return 0.5 * (s.points[static_cast<std::size_t>(use.low)] + s.points[static_cast<std::size_t>(use.high)]);
}
Vec3 centre(const Surface& s, int t) { return (s.corner(t, 0) + s.corner(t, 1) + s.corner(t, 2)) / 3; }

/// How many edges have a property, and the middle of the first.
struct Count {
    std::size_t number = 0;
    Vec3 first = Vec3::Zero();
    void add(const Vec3& place) {
        if (number++ == 0) first = place;
    }
};

void check_edges(const Surface& s, const Edges& edges, std::vector<Finding>& findings) {
    Count open, non_manifold, flipped;
    for (const Edge& e : edges.edges) {
        const Vec3 place = middle(s, edges.uses[e.begin]);
        if (edges.open(e)) open.add(place);
        if (edges.non_manifold(e)) non_manifold.add(place);
        if (edges.flipped(e)) flipped.add(place);
    }
    if (open.number > 0) {
        const auto holes = find_holes(s, edges);
        findings.push_back(
            {Level::error, "open_edges",
             fmt::format("the surface is not closed: {} open edges round {} hole(s), {}; close it in your CAD "
                         "(a deck, a transom, unmerged parts), or try \"hull repair\" for small holes",
                         open.number, holes.size(), at(open.first)),
             open.first});
    }
    if (non_manifold.number > 0)
        findings.push_back(
            {Level::error, "non_manifold_edges",
             fmt::format("{} edges are shared by more than two triangles, {}: inner walls, doubled faces or "
                         "parts that touch along an edge; unite the parts in your CAD",
                         non_manifold.number, at(non_manifold.first)),
             non_manifold.first});
    if (flipped.number > 0)
        findings.push_back(
            {Level::error, "flipped_normals",
             fmt::format("neighbouring triangles face opposite ways at {} edges, {}; \"hull repair\" turns them",
                         flipped.number, at(flipped.first)),
             flipped.first});
}

void check_shells(const Surface& s, const Edges& edges, std::vector<Finding>& findings) {
    const std::vector<ShellState> shells = examine_shells(s, find_shells(s, edges));
    Count inverted, nested, separate;
    bool hollow = false;
    for (const ShellState& shell : shells) {
        if (shell.within >= 0) {
            nested.add(shell.a_corner);
            hollow = hollow || shell.volume * shells[static_cast<std::size_t>(shell.within)].volume < 0;
        } else {
            separate.add(shell.a_corner);
            if (shell.volume < 0) inverted.add(shell.a_corner);
        }
    }
    if (inverted.number > 0)
        findings.push_back(
            {Level::error, "inverted",
             fmt::format("the normals point inward ({} of {} shells have a negative volume), {}; \"hull repair\" "
                         "turns them",
                         inverted.number, shells.size(), at(inverted.first)),
             inverted.first});
    if (nested.number > 0)
        findings.push_back({Level::error, "nested_shells",
                            fmt::format("{} shell(s) lie inside another, {}: {}; keep the outer shell only",
                                        nested.number, at(nested.first),
                                        hollow ? "a hollow body with an inner and an outer skin"
                                               : "one body within another, or the hull twice"),
                            nested.first});
    if (separate.number > 1)
        findings.push_back(
            {Level::warning, "several_shells",
             fmt::format("the surface has {} separate bodies; one of them is {}. Right for a catamaran; else "
                         "remove what is not hull",
                         separate.number, at(shells.back().a_corner)),
             shells.back().a_corner});
}

void check_intersections(const Surface& s, std::vector<Finding>& findings) {
    constexpr std::size_t limit = 1000;
    const auto pairs = find_intersections(s, limit);
    if (pairs.empty()) return;
    const Vec3 place = centre(s, pairs.front().first);
    findings.push_back(
        {Level::error, "self_intersection",
         fmt::format("{}{} pairs of triangles pass through or lie upon each other, {}; unite the parts in your CAD",
                     pairs.size(), pairs.size() >= limit ? " or more" : "", at(place)),
         place});
}

void check_size_and_place(const Surface& s, std::vector<Finding>& findings) {
    const Box box = s.bounds();
    const double size = box.size().maxCoeff();
    const Vec3 centre_of_box = 0.5 * (box.min + box.max);
    if (size > 500)
        findings.push_back(
            {Level::error, "suspicious_size",
             fmt::format("the hull is {:.4g} m long; this looks like millimetres: set unit = \"mm\"", size),
             centre_of_box});
    else if (size < 0.005)
        findings.push_back(
            {Level::warning, "suspicious_size",
             fmt::format("the hull is only {:.4g} m in size; check its unit (known: m, mm, cm, ft, in)", size),
             centre_of_box});
    const double away = centre_of_box.cwiseAbs().maxCoeff();
    if (away > 100 * size)
        findings.push_back(
            {Level::error, "far_from_origin",
             fmt::format("the hull is {:.4g} m from the origin, {:.0f} times its size: single-precision files lose "
                         "its shape there; move it to the origin before the export, or shift it by its position",
                         away, away / size),
             centre_of_box});
}

void check_thickness(const Surface& s, double particle_spacing, std::vector<Finding>& findings) {
    constexpr double layers = 6;  // three wall-particle layers from either side
    const double limit = layers * particle_spacing;
    const ThinWalls thin = find_thin_walls(s, limit);
    if (thin.area <= 9 * particle_spacing * particle_spacing) return;  // a corner of a wedge
    findings.push_back(
        {Level::warning, "thin_walls",
         fmt::format("{:.3g} m2 of the surface belongs to walls thinner than {:.4g} m (6 particle layers), e.g. "
                     "{:.4g} m {}; refine to {:.2g} m or thicken the part",
                     thin.area, limit, thin.typical, at(thin.place), thin.typical / layers),
         thin.place});
}
}  // namespace

std::vector<Finding> check_surface(const Surface& surface, double particle_spacing) {
    if (surface.triangles.empty())
        return {{Level::error, "empty", "the surface has no triangles; export it again", Vec3::Zero()}};
    std::vector<Finding> findings;
    for (std::size_t i = 0; i < surface.points.size(); ++i)
        if (!surface.points[i].allFinite())
            return {{Level::error, "not_finite",
                     fmt::format("corner {} is not a finite number (NaN or infinite); export the surface again", i),
                     Vec3::Zero()}};
    check_size_and_place(surface, findings);

    Count slivers;
    for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t)
        if (has_no_area(surface, t)) slivers.add(centre(surface, t));
    if (slivers.number > 0)
        findings.push_back({Level::error, "zero_area",
                            fmt::format("{} triangles have no area, {}; \"hull repair\" removes them", slivers.number,
                                        at(slivers.first)),
                            slivers.first});

    const Edges edges = find_edges(surface);
    check_edges(surface, edges, findings);
    // Volumes and insides mean something on a sound, closed surface only.
    const bool closed = std::ranges::none_of(findings, [](const Finding& f) {
        return f.name == "open_edges" || f.name == "non_manifold_edges" || f.name == "flipped_normals";
    });
    if (closed) check_shells(surface, edges, findings);
    check_intersections(surface, findings);
    if (closed && particle_spacing > 0) check_thickness(surface, particle_spacing, findings);
    return findings;
}

bool usable(const std::vector<Finding>& findings) {
    return std::ranges::none_of(findings, [](const Finding& f) { return f.level == Level::error; });
}

}  // namespace tw
