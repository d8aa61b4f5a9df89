#include "meshes/generate/loft.h"

#include <algorithm>
#include <utility>

#include "meshes/mass_properties.h"

namespace tw {

Surface outward(Surface surface) {
    if (mass_properties(surface).volume < 0)
        for (auto& t : surface.triangles) std::swap(t[1], t[2]);
    return surface;
}

Surface loft(const std::vector<HalfSection>& sections) {
    Surface s;
    const int per_section = static_cast<int>(sections.front().size());
    for (const HalfSection& section : sections) s.points.insert(s.points.end(), section.begin(), section.end());
    const int rows = static_cast<int>(sections.size());
    const auto id = [&](int row, int k) { return row * per_section + k; };
    for (int row = 0; row + 1 < rows; ++row)
        for (int k = 0; k + 1 < per_section; ++k) {
            const int a = id(row, k), b = id(row, k + 1), c = id(row + 1, k + 1), d = id(row + 1, k);
            const auto length = [&](int i, int j) {
                return (s.points[static_cast<std::size_t>(i)] - s.points[static_cast<std::size_t>(j)]).norm();
            };
            // The shorter diagonal makes the smoother surface; one in the symmetry plane would be shared with the
            // mirror image.
            const auto in_plane = [&](int i) { return s.points[static_cast<std::size_t>(i)].y() == 0; };
            if ((length(a, c) <= length(b, d) && !(in_plane(a) && in_plane(c))) || (in_plane(b) && in_plane(d))) {
                s.triangles.push_back({a, b, c});
                s.triangles.push_back({a, c, d});
            } else {
                s.triangles.push_back({a, b, d});
                s.triangles.push_back({b, c, d});
            }
        }
    const auto has_area = [](const HalfSection& section) {  // not a stem: a line in the symmetry plane
        return std::ranges::any_of(section, [](const Vec3& p) { return p.y() > 0; });
    };
    for (int k = 0; k + 2 < per_section; ++k) {
        if (has_area(sections.front())) s.triangles.push_back({id(0, per_section - 1), id(0, k + 1), id(0, k)});
        if (has_area(sections.back()))
            s.triangles.push_back({id(rows - 1, per_section - 1), id(rows - 1, k), id(rows - 1, k + 1)});
    }
    const std::size_t half_points = s.points.size(), half_triangles = s.triangles.size();
    for (std::size_t i = 0; i < half_points; ++i)
        s.points.emplace_back(s.points[i].x(), -s.points[i].y(), s.points[i].z());
    for (std::size_t t = 0; t < half_triangles; ++t) {
        const int n = static_cast<int>(half_points);
        const auto [a, b, c] = s.triangles[t];
        s.triangles.push_back({a + n, c + n, b + n});
    }
    return outward(welded(s));  // welding drops what collapsed
}

}  // namespace tw
