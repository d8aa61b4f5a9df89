#include "compare/read/prepare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "record/record_numbers.h"

namespace tw {

namespace {

/// Voxels [first, end) along one axis that lie inside [low, high].
struct Inside {
    int first, end;
    Inside(double origin, double spacing, int count, double low, double high) : first(0), end(count) {
        constexpr double rounding = 1e-6;
        while (first < end && origin + first * spacing < low - rounding * spacing) ++first;
        while (end > first && origin + end * spacing > high + rounding * spacing) --end;
    }
};

}  // namespace

void crop_to_domain(RunRecord& record) {
    RasterSpec& spec = record.raster;
    constexpr double far = std::numeric_limits<double>::infinity();
    if (!(spec.voxel > 0) || spec.count[0] < 2) return;
    const Inside x(spec.origin.x(), spec.voxel, spec.count[0], number_of(record, "domain_x_min", -far),
                   number_of(record, "domain_x_max", far));
    const Inside y(spec.origin.y(), spec.voxel, spec.count[1],
                   spec.count[1] > 1 ? number_of(record, "domain_y_min", -far) : -far,
                   spec.count[1] > 1 ? number_of(record, "domain_y_max", far) : far);
    const int nx = x.end - x.first, ny = y.end - y.first;
    if ((nx == spec.count[0] && ny == spec.count[1]) || nx < 1 || ny < 1) return;
    for (RasterFrame& frame : record.frames) {
        std::vector<std::uint8_t> kept;
        kept.reserve(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny) *
                     static_cast<std::size_t>(spec.count[2]));
        for (int k = 0; k < spec.count[2]; ++k)
            for (int j = y.first; j < y.end; ++j) {
                const auto row =
                    frame.water.begin() + (static_cast<std::ptrdiff_t>(k) * spec.count[1] + j) * spec.count[0];
                kept.insert(kept.end(), row + x.first, row + x.end);
            }
        frame.water = std::move(kept);
    }
    spec.origin.x() += x.first * spec.voxel;
    spec.origin.y() += y.first * spec.voxel;
    spec.count[0] = nx;
    spec.count[1] = ny;
}

void complete_half_hull(RunRecord& record) {
    Surface& hull = record.hull;
    if (!(number_of_text(record, "symmetry_factor", 1) > 1) || hull.points.empty()) return;
    double low = hull.points[0].y(), high = low;
    for (const Vec3& p : hull.points) low = std::min(low, p.y()), high = std::max(high, p.y());
    if (low < -0.01 * high) return;  // both sides are there
    const std::size_t points = hull.points.size(), triangles = hull.triangles.size();
    for (std::size_t i = 0; i < points; ++i)
        hull.points.emplace_back(hull.points[i].x(), -hull.points[i].y(), hull.points[i].z());
    for (std::size_t t = 0; t < triangles; ++t) {
        const auto [a, b, c] = hull.triangles[t];
        const int n = static_cast<int>(points);
        hull.triangles.push_back({a + n, c + n, b + n});  // turned, so that normals stay outward
    }
    for (auto* values : {&record.hull_pressure, &record.hull_wet})
        if (values->size() == triangles) {
            values->reserve(2 * triangles);
            std::copy_n(values->begin(), triangles, std::back_inserter(*values));
        }
}

Vec3 moment_reference_of(const RunRecord& record) {
    std::istringstream text(text_of(record, "moment_reference"));
    text.imbue(std::locale::classic());
    Vec3 r;
    if (text >> r.x() >> r.y() >> r.z() && r.allFinite()) return r;
    return Vec3::Zero();
}

void refer_moments_to(RunRecord& record, const Vec3& reference) {
    const Vec3 shift = moment_reference_of(record) - reference;
    const Column *fx = record.series("forces", "fx"), *fz = record.series("forces", "fz");
    if (!fx || !fz || !record.series("forces", "my")) return;
    auto& my = record.table("forces").column("my", "N m").values;
    for (std::size_t i = 0; i < my.size(); ++i) my[i] += shift.z() * fx->values[i] - shift.x() * fz->values[i];
    record.attributes["moment_reference"] = fmt::format("{} {} {}", reference.x(), reference.y(), reference.z());
}

}  // namespace tw
