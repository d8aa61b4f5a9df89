#include "meshes/health.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "meshes/check/edges.h"
#include "meshes/check/hole.h"
#include "meshes/check/intersections.h"
#include "meshes/check/shells.h"
#include "meshes/check/sliver.h"
#include "meshes/check/thin_walls.h"

namespace tw {
namespace {
using Level = Finding::Level;

std::string near(const Vec3& p) { return fmt::format("near ({:.4g}, {:.4g}, {:.4g}) m", p.x(), p.y(), p.z()); }

Vec3 middle(const Surface& s, const EdgeUse& use) {
    return 0.5 * (s.points[static_cast<std::size_t>(use.low)] + s.points[static_cast<std::size_t>(use.high)]);
}
Vec3 centre(const Surface& s, int t) { return (s.corner(t, 0) + s.corner(t, 1) + s.corner(t, 2)) / 3; }

/// A finding, and what to do where repair_surface does not help.
struct Found {
    Finding finding;
    std::string otherwise;
};
using FoundList = std::vector<Found>;

void add(FoundList& all, Level level, const char* name, const Vec3& place, const std::string& what,
         const std::string& otherwise) {
    Found f;
    f.finding.level = level;
    f.finding.name = name;
    f.finding.message = what;
    f.finding.place = place;
    f.otherwise = otherwise;
    all.push_back(std::move(f));
}

/// How many edges have a property, and the middle of the first.
struct Count {
    std::size_t number = 0;
    Vec3 first = Vec3::Zero();
    void add(const Vec3& place) {
        if (number++ == 0) first = place;
    }
};

std::string about_holes(const Surface& s, const std::vector<Loop>& holes) {
    const double diagonal = s.bounds().size().norm();
    Hole widest;
    for (const Loop& loop : holes)
        if (const Hole hole = measured(s, loop); hole.diameter > widest.diameter) widest = hole;
    const std::string cad = "close it in your CAD (a missing deck or transom, parts that are not merged)";
    if (widest.diameter == 0) return cad;
    return fmt::format("{}; the widest hole is {:.3g} m across, and only flat holes of up to {:.3g} m can be filled",
                       cad, widest.diameter, widest_filled_hole * diagonal);
}

void check_edges(const Surface& s, const Edges& edges, FoundList& found) {
    Count open, non_manifold, flipped;
    for (const Edge& e : edges.edges) {
        const Vec3 place = middle(s, edges.uses[e.begin]);
        if (edges.open(e)) open.add(place);
        if (edges.non_manifold(e)) non_manifold.add(place);
        if (edges.flipped(e)) flipped.add(place);
    }
    if (open.number > 0) {
        const auto holes = find_holes(s, edges);
        add(found, Level::error, "open_edges", open.first,
            fmt::format("the surface is not closed: {} open edges around {} hole(s), {}", open.number, holes.size(),
                        near(open.first)),
            about_holes(s, holes));
    }
    if (non_manifold.number > 0)
        add(found, Level::error, "non_manifold_edges", non_manifold.first,
            fmt::format("{} edges are shared by more than two triangles, {}: inner walls, doubled faces or parts that "
                        "touch along an edge",
                        non_manifold.number, near(non_manifold.first)),
            "unite the parts in your CAD");
    if (flipped.number > 0)
        add(found, Level::error, "flipped_normals", flipped.first,
            fmt::format("neighbouring triangles face opposite ways near {} edges, {}", flipped.number,
                        near(flipped.first)),
            "export the surface with consistent normals");
}

void check_shells(const Surface& s, const Edges& edges, FoundList& found) {
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
        add(found, Level::error, "inverted", inverted.first,
            fmt::format("the normals point inward ({} of {} shells have a negative volume), {}", inverted.number,
                        shells.size(), near(inverted.first)),
            "export the surface with normals that point outward");
    if (nested.number > 0)
        add(found, Level::error, "nested_shells", nested.first,
            fmt::format("{} shell(s) lie inside another, {}: {}", nested.number, near(nested.first),
                        hollow ? "a hollow body with an inner and an outer skin"
                               : "one body within another, or the hull twice"),
            "keep only the outer shell");
    if (separate.number > 1)
        add(found, Level::warning, "several_shells", shells.back().a_corner,
            fmt::format("the surface has {} separate bodies; one of them is {}", separate.number,
                        near(shells.back().a_corner)),
            "this is right for a catamaran; otherwise remove what is not hull");
}

void check_intersections(const Surface& s, FoundList& found) {
    constexpr std::size_t limit = 1000;
    const auto pairs = find_intersections(s, limit);
    if (pairs.empty()) return;
    const Vec3 place = centre(s, pairs.front().first);
    add(found, Level::error, "self_intersection", place,
        fmt::format("{}{} pairs of triangles pass through or lie upon each other, {}", pairs.size(),
                    pairs.size() >= limit ? " or more" : "", near(place)),
        "unite the parts in your CAD");
}

void check_size_and_place(const Surface& s, FoundList& found) {
    const Box box = s.bounds();
    const double size = box.size().maxCoeff();
    const Vec3 centre_of_box = 0.5 * (box.min + box.max);
    if (size > 500)
        add(found, Level::error, "suspicious_size", centre_of_box, fmt::format("the hull is {:.4g} m long", size),
            "this looks like millimetres: set unit = \"mm\" in the scene, or --unit mm on the command line");
    else if (size < 0.005)
        add(found, Level::warning, "suspicious_size", centre_of_box,
            fmt::format("the hull is only {:.4g} m in size", size), "check its unit (known: m, mm, cm, ft, in)");
    const double away = centre_of_box.cwiseAbs().maxCoeff();
    if (away > 100 * size) {
        const double whole = std::pow(10, std::floor(std::log10(size)));
        const auto rounded = [&](double x) { return std::round(x / whole) * whole; };
        add(found, Level::error, "far_from_origin", centre_of_box,
            fmt::format("the hull is {:.4g} m from the origin, {:.0f} times its size, as in coordinates of a map: in "
                        "single precision, in which surfaces are read, its corners are known to {:.2g} m only",
                        away, away / size, away * std::ldexp(1.0, -23)),
            fmt::format("before the export take ({:.10g}, {:.10g}, {:.10g}) m off all its coordinates; position and "
                        "draft place it in the water",
                        rounded(centre_of_box.x()), rounded(centre_of_box.y()), rounded(centre_of_box.z())));
    }
}

void check_thickness(const Surface& s, double particle_spacing, FoundList& found) {
    constexpr double layers = 6;  // three wall-particle layers from either side
    const double limit = layers * particle_spacing;
    const ThinWalls thin = find_thin_walls(s, limit);
    if (thin.area <= 9 * particle_spacing * particle_spacing) return;  // a corner of a wedge
    add(found, Level::warning, "thin_walls", thin.place,
        fmt::format(
            "{:.3g} m2 of the surface belongs to walls thinner than {:.4g} m (6 particle layers), e.g. {:.4g} m {}",
            thin.area, limit, thin.typical, near(thin.place)),
        fmt::format("refine to {:.2g} m or thicken the part", thin.typical / layers));
}

FoundList examined(const Surface& surface, double particle_spacing) {
    FoundList found;
    if (surface.triangles.empty()) {
        add(found, Level::error, "empty", Vec3::Zero(), "the surface has no triangles", "export it again");
        return found;
    }
    for (std::size_t i = 0; i < surface.points.size(); ++i)
        if (!surface.points[i].allFinite()) {
            add(found, Level::error, "not_finite", Vec3::Zero(),
                fmt::format("corner {} is not a finite number (NaN or infinite)", i), "export the surface again");
            return found;
        }
    check_size_and_place(surface, found);

    Count slivers;
    for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t)
        if (has_no_area(surface, t)) slivers.add(centre(surface, t));
    if (slivers.number > 0)
        add(found, Level::error, "zero_area", slivers.first,
            fmt::format("{} triangles have no area, {}", slivers.number, near(slivers.first)),
            "remove them before the export");

    const Edges edges = find_edges(surface);
    const std::size_t before = found.size();
    check_edges(surface, edges, found);
    const bool closed = found.size() == before;  // volumes and insides mean something on a sound, closed surface only
    if (closed) check_shells(surface, edges, found);
    check_intersections(surface, found);
    if (closed && particle_spacing > 0) check_thickness(surface, particle_spacing, found);
    return found;
}

bool is_error(const Found& f) { return f.finding.level == Level::error; }

}  // namespace

std::vector<Finding> check_surface(const Surface& surface, double particle_spacing) {
    FoundList found = examined(surface, particle_spacing);
    // Repair is tried rather than guessed: it is suggested only where nothing wrong is left after it.
    const bool mendable = std::ranges::any_of(found, is_error) &&
                          std::ranges::none_of(examined(repair_surface(surface).surface, 0), is_error);
    std::vector<Finding> findings;
    for (Found& f : found) {
        f.finding.mendable = mendable && is_error(f);
        if (!f.finding.mendable) f.finding.message += "; " + f.otherwise;
        findings.push_back(std::move(f.finding));
    }
    return findings;
}

bool usable(const std::vector<Finding>& findings) {
    return std::ranges::none_of(findings, [](const Finding& f) { return f.level == Level::error; });
}

}  // namespace tw
