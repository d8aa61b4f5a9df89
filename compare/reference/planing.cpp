#include "compare/reference/planing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "meshes/below_water.h"
#include "record/hull_motion.h"
#include "record/planing_plate.h"
#include "record/record_numbers.h"

namespace tw {

std::optional<PrismaticHull> prismatic_hull(const RunRecord& record) {
    const Column* running = record.series(hull_motion_table, "trim");
    const double trim = running && !running->values.empty() ? running->values.back() * std::numbers::pi / 180
                                                            : number_of(record, "trim", 0),
                 heel = number_of(record, "heel", 0);
    PrismaticHull hull;
    hull.draft = number_of(record, "draft", 0);
    PlaningState& s = hull.state;
    s.trim = trim;
    s.speed = number_of(record, "speed", 0);
    s.density = number_of(record, "density", 1000);
    s.gravity = number_of(record, "gravity", 9.81);
    s.kinematic_viscosity = number_of(record, "kinematic_viscosity", 1e-6);
    if (record.hull.triangles.empty() || !(trim > 0) || heel != 0 || !(hull.draft > 0) || !(s.speed > 0)) return {};

    // Bow up turns the hull's own x axis (to the stern) downward: body axes e_x = (cos, 0, -sin), e_z = (sin, 0, cos).
    const Vec3 e_x(std::cos(trim), 0, -std::sin(trim)), e_z(std::sin(trim), 0, std::cos(trim));
    struct Face {
        double area, deadrise;  // below still water [m2], [rad]
        Vec3 normal;            // in body axes
    };
    double area = 0, y_min = 0, y_max = 0;
    std::vector<Face> bottom;
    for (int t = 0; t < static_cast<int>(record.hull.triangles.size()); ++t) {
        const Vec3 a2 = record.hull.area_vector2(t);
        const double twice = a2.norm(), wet = twice > 0 ? twice / 2 * share_below_water(record.hull, t) : 0;
        if (!(wet > 0)) continue;
        const Vec3 n(a2.dot(e_x) / twice, a2.y() / twice, a2.dot(e_z) / twice);
        if (n.z() > -0.02) continue;  // upright: side, transom
        bottom.push_back({wet, std::atan2(std::abs(n.y()), -n.z()), n});
        area += wet;
        for (int k = 0; k < 3; ++k) {
            y_min = std::min(y_min, record.hull.corner(t, k).y());
            y_max = std::max(y_max, record.hull.corner(t, k).y());
        }
    }
    if (!(area > 0)) return {};
    // Of the middle of the area: a bow of another angle does not change it.
    std::ranges::sort(bottom, {}, &Face::deadrise);
    double deadrise = 0, passed = 0;
    for (const Face& f : bottom) {
        deadrise = f.deadrise;
        if ((passed += f.area) >= area / 2) break;
    }
    constexpr double steepest = 0.7;  // [rad], 40 degrees: a planing bottom, and inside the formula's data
    if (deadrise > steepest) return {};
    constexpr double tolerance = 0.01;  // of a unit normal: about half a degree
    double otherwise = 0;               // area that faces elsewhere
    for (const Face& f : bottom) {
        const Vec3 expected(0, std::copysign(std::sin(deadrise), f.normal.y()), -std::cos(deadrise));
        if ((f.normal - expected).norm() > tolerance) otherwise += f.area;
    }
    hull.bow = otherwise / area;
    if (hull.bow > largest_bow) return {};
    s.deadrise = deadrise;
    s.beam = y_max - y_min;
    return hull;
}

std::vector<Reference> planing_plate_references(const RunRecord& record) {
    const double depth = number_of(record, "depth", 0);
    if (number_of(record, "dimensions", 3) != 2 || number_of(record, "gravity", 9.81) != 0 || !(depth > 0)) return {};
    const std::optional<PrismaticHull> hull = prismatic_hull(record);
    constexpr double flat = 0.01;  // [rad]
    if (!hull || hull->state.deadrise > flat) return {};
    const PlaningState& s = hull->state;
    const std::optional<PlaningPlate> plate = planing_plate_at(s.trim, -hull->draft / depth);
    if (!plate) return {};
    const double N = plate->force * s.density * s.speed * s.speed * depth;
    const std::string remark =
        fmt::format("exact for an endless plate, without air; jet {:.4g} m thick", plate->delta * depth);
    const auto reference = [&](const char* quantity, double value) {
        return Reference{quantity, "N/m", "free streamlines", value, 0, remark, true};
    };
    return {reference("lift", N * std::cos(s.trim)), reference("drag", N * std::sin(s.trim))};
}

}  // namespace tw
