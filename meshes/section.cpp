#include "meshes/section.h"

#include <fmt/format.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolygon.h>

#include <cmath>
#include <map>
#include <utility>

#include "base/errors.h"

namespace tw {
namespace {

using SectionLoop = std::vector<Vec3>;  // corners in the plane y = 0, the solid on the right seen along +y

/// The crossing of the plane with the surface as loops. Each triangle that has corners on both sides gives one piece,
/// from the edge where its border runs to y < 0 to the one where it comes back: neighbours of a closed surface share
/// an edge and run along it in opposite directions, so pieces join end to end.
std::vector<SectionLoop> section_loops(const Surface& surface) {
    using Edge = std::pair<int, int>;
    std::map<Edge, Edge> next;
    for (const auto& t : surface.triangles) {
        Edge down{-1, -1}, up{-1, -1};
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = t[k], b = t[(k + 1) % 3];
            const bool a_beyond = surface.points[static_cast<std::size_t>(a)].y() >= 0;
            if (a_beyond == (surface.points[static_cast<std::size_t>(b)].y() >= 0)) continue;
            (a_beyond ? down : up) = std::minmax(a, b);
        }
        if (down.first >= 0) next[down] = up;
    }
    const auto place = [&](const Edge& e) {
        const Vec3 &a = surface.points[static_cast<std::size_t>(e.first)],
                   &b = surface.points[static_cast<std::size_t>(e.second)];
        Vec3 p = a + (b - a) * (a.y() / (a.y() - b.y()));
        p.y() = 0;
        return p;
    };
    std::vector<SectionLoop> loops;
    while (!next.empty()) {
        const Edge first = next.begin()->first;
        SectionLoop loop;
        Edge at = first;
        do {
            const auto found = next.find(at);
            const Vec3 p = place(at);
            if (found == next.end())
                throw InputError(fmt::format(
                    "the section with the plane y = 0 is not closed: it ends at x = {:.6g} m, z = {:.6g} m; expected a "
                    "closed surface",
                    p.x(), p.z()));
            if (loop.empty() || p != loop.back()) loop.push_back(p);
            at = found->second;
            next.erase(found);
        } while (at != first);
        if (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
        if (loop.size() > 2) loops.push_back(std::move(loop));
    }
    return loops;
}

/// Twice the area, positive where the solid is inside the loop [m2].
double twice_area(const SectionLoop& loop) {
    double sum = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec3 &a = loop[i], &b = loop[(i + 1) % loop.size()];
        sum += a.z() * b.x() - a.x() * b.z();
    }
    return sum;
}

/// Drops corners that lie on the straight line between their neighbours to rounding: crossings of coplanar triangles.
SectionLoop without_needless_corners(const SectionLoop& loop) {
    SectionLoop kept;
    const std::size_t n = loop.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 before = loop[i] - (kept.empty() ? loop[n - 1] : kept.back()), after = loop[(i + 1) % n] - loop[i];
        const double turn = before.z() * after.x() - before.x() * after.z();
        if (std::abs(turn) > 1e-9 * before.norm() * after.norm() || before.dot(after) < 0) kept.push_back(loop[i]);
    }
    return kept;
}

std::vector<std::array<int, 3>> triangulated(const SectionLoop& loop) {
    vtkNew<vtkPolygon> polygon;
    const auto n = static_cast<vtkIdType>(loop.size());
    polygon->GetPointIds()->SetNumberOfIds(n);
    polygon->GetPoints()->SetDataTypeToDouble();
    polygon->GetPoints()->SetNumberOfPoints(n);
    for (vtkIdType i = 0; i < n; ++i) {
        polygon->GetPointIds()->SetId(i, i);
        polygon->GetPoints()->SetPoint(i, loop[static_cast<std::size_t>(i)].data());
    }
    vtkNew<vtkIdList> ears;
    if (polygon->EarCutTriangulation(ears) == 0 || ears->GetNumberOfIds() != 3 * (n - 2))
        throw InputError(
            fmt::format("the section with the plane y = 0 crosses itself near x = {:.6g} m, z = {:.6g} m; expected a "
                        "surface that does not",
                        loop.front().x(), loop.front().z()));
    std::vector<std::array<int, 3>> triangles;
    for (vtkIdType i = 0; i < ears->GetNumberOfIds(); i += 3)
        triangles.push_back({static_cast<int>(ears->GetId(i)), static_cast<int>(ears->GetId(i + 1)),
                             static_cast<int>(ears->GetId(i + 2))});
    return triangles;
}

void add_prism(const SectionLoop& loop, double span, Surface& out) {
    const int n = static_cast<int>(loop.size()), first = static_cast<int>(out.points.size());
    for (const double y : {-0.5 * span, 0.5 * span})
        for (const Vec3& p : loop) out.points.emplace_back(p.x(), y, p.z());
    for (int i = 0; i < n; ++i) {
        const int a = first + i, b = first + (i + 1) % n;
        out.triangles.push_back({a, b, b + n});
        out.triangles.push_back({a, b + n, a + n});
    }
    for (std::array<int, 3> t : triangulated(loop)) {
        const Vec3 &a = loop[static_cast<std::size_t>(t[0])], &b = loop[static_cast<std::size_t>(t[1])],
                   &c = loop[static_cast<std::size_t>(t[2])];
        if ((b - a).cross(c - a).y() > 0) std::swap(t[1], t[2]);  // looks to y < 0
        out.triangles.push_back({first + t[0], first + t[1], first + t[2]});
        out.triangles.push_back({first + n + t[0], first + n + t[2], first + n + t[1]});
    }
}

}  // namespace

Surface section_prism(const Surface& closed, double span) {
    std::vector<SectionLoop> loops = section_loops(closed);
    Surface prism;
    for (const SectionLoop& all : loops) {
        const SectionLoop loop = without_needless_corners(all);
        if (loop.size() < 3) continue;
        if (!(twice_area(loop) > 0))
            throw InputError(fmt::format(
                "the section with the plane y = 0 has a hollow inside, near x = {:.6g} m, z = {:.6g} m; expected loops "
                "that lie beside each other",
                loop.front().x(), loop.front().z()));
        add_prism(loop, span, prism);
    }
    if (prism.points.empty()) {
        const Box box = closed.bounds();
        throw InputError(
            fmt::format("there is no section with the plane y = 0: the surface spans y from {:.6g} to {:.6g} m",
                        box.min.y(), box.max.y()));
    }
    return prism;
}

Surface with_span(const Surface& prism, double span) {
    Surface out = prism;
    for (Vec3& p : out.points) p.y() = std::copysign(0.5 * span, p.y());
    return out;
}

double endless_span(const Surface& prism) {
    const Vec3 size = prism.bounds().size();
    return 10 * (size.x() + size.z());
}

}  // namespace tw
