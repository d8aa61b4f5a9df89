#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "compare/checks/checks.h"
#include "compare/reference/planing.h"
#include "meshes/shedding_edges.h"
#include "record/force_names.h"
#include "record/record_numbers.h"

namespace tw {

namespace {

/// Of the rows from `mean_from` on in which the column is known, and `where` too.
std::optional<double> time_mean(const RunRecord& record, const std::string& table, const std::string& column,
                                const Column* where = nullptr) {
    const Column* c = record.series(table, column);
    if (!c) return {};
    const auto& time = record.tables.at(table).time;
    const double from = number_of(record, "mean_from", 0);
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < time.size(); ++i)
        if (time[i] >= from && std::isfinite(c->values[i]) && (!where || std::isfinite(where->values[i])))
            sum += c->values[i], ++count;
    if (count == 0) return {};
    return sum / count;
}

bool is_section(const RunRecord& record) { return number_of(record, "dimensions", 3) == 2; }

/// Whether the hull has an edge at which water should leave it and let air in: of a transom, a step, a chine. A round hull
/// has none, and no air comes to a hull that is wholly under water; the stream sucks at both by more than rho U^2 / 2 (at
/// a cylinder by up to three times that), and rightly so. The ends of a section are not its edges.
bool has_edges_in_air(const RunRecord& record) {
    const Box hull = record.hull.bounds();
    if (!(hull.max.z() >= 0)) return false;
    const std::vector<SheddingEdge> edges = shedding_edges(record.hull, hull);
    return std::ranges::any_of(edges, [&](const SheddingEdge& e) {
        const Vec3 along = e.to - e.from;
        return !is_section(record) || std::abs(along.y()) > 0.5 * along.norm();
    });
}

/// What the pressure on the wet hull pushes up and down, without regard to sign (last picture) [N], of a section per
/// metre of span.
double load_up_and_down(const RunRecord& record) {
    if (record.hull_pressure.size() != record.hull.triangles.size()) return 0;
    double load = 0;
    for (std::size_t t = 0; t < record.hull_pressure.size(); ++t) {
        if (t < record.hull_wet.size() && record.hull_wet[t] < 0.5f) continue;
        const double here =
            std::abs(double(record.hull_pressure[t]) * record.hull.area_vector2(static_cast<int>(t)).z() / 2);
        if (std::isfinite(here)) load += here;
    }
    const double span = is_section(record) ? record.hull.bounds().size().y() : 1;
    return span > 0 ? load / span : 0;
}

/// Share of the wet hull's pressure load (last picture) that is suction, [%]. Fast water leaves a step or a transom and
/// lets air in; where a method keeps it attached, because the edge is not resolved, it sucks at the hull.
std::optional<double> suction_share(const RunRecord& record) {
    if (record.hull_pressure.size() != record.hull.triangles.size()) return {};
    double suction = 0, all = 0;
    for (std::size_t t = 0; t < record.hull_pressure.size(); ++t) {
        if (t < record.hull_wet.size() && record.hull_wet[t] < 0.5f) continue;
        const double load = double(record.hull_pressure[t]) * record.hull.area_vector2(static_cast<int>(t)).norm();
        if (!std::isfinite(load)) continue;
        suction += std::max(0.0, -load);
        all += std::abs(load);
    }
    if (all <= 0) return {};
    return 100 * suction / all;
}

/// Wet faces that are sucked at harder than the stream's dynamic pressure rho U^2 / 2 (last picture).
struct Pocket {
    double coefficient = 0;     ///< largest suction over rho U^2 / 2, wherever it stands [-]
    Vec3 place = Vec3::Zero();  ///< of it [m]
    double of_drag = 0;         ///< drag of the faces where it exceeds 1, over that of all wet faces [-]
};

/// Along smooth surfaces fast water sucks by less than rho U^2 / 2 unless it is led round a bulge. Where the stream
/// leaves an edge a single cell of the mesh may suck by several times that (docs/decisions/028-shedding-edges.md), on
/// too small an area for `suction_share` to see.
std::optional<Pocket> deepest_suction(const RunRecord& record, double speed) {
    if (record.hull_pressure.empty() || record.hull_pressure.size() != record.hull.triangles.size()) return {};
    const double dynamic = 0.5 * number_of(record, "density", 1000) * speed * speed;
    Pocket pocket;
    double drag = 0, all_drag = 0;
    for (std::size_t t = 0; t < record.hull_pressure.size(); ++t) {
        if (t < record.hull_wet.size() && record.hull_wet[t] < 0.5f) continue;
        const double coefficient = -double(record.hull_pressure[t]) / dynamic;
        if (!std::isfinite(coefficient)) continue;
        const double here = coefficient * record.hull.area_vector2(static_cast<int>(t)).x();
        all_drag += here;
        if (coefficient > 1) drag += here;
        if (coefficient <= pocket.coefficient) continue;
        pocket.coefficient = coefficient;
        pocket.place.setZero();
        for (const int corner : record.hull.triangles[t])
            pocket.place += record.hull.points[static_cast<std::size_t>(corner)] / 3;
    }
    if (all_drag != 0) pocket.of_drag = drag / all_drag;
    return pocket;
}

/// Drag that the resolution makes on a closed body wholly under water, where potential flow has none (d'Alembert):
///
///   D_num = C 1/2 rho U^2 A,   C = 1.65 dp / d
///
/// A: frontal area, d: the hull's smaller extent across the stream, dp: spacing at the hull. First order: the artificial
/// viscosity or the cells' diffusion lets the flow leave the tail. Measured on an ellipse (C = 0.28 and 0.14 at d/dp = 6
/// and 12, docs/results/numerics.md); a size, good to a factor of two.
struct NumericalDrag {
    double force = 0;        ///< D_num [N]
    double coefficient = 0;  ///< C [-]
    double spacings = 0;     ///< d / dp [-]
};
/// Nothing for a hull that reaches up to still water, or where the record lacks a number.
std::optional<NumericalDrag> numerical_drag(const RunRecord& record) {
    const double speed = number_of(record, "speed", 0), dp = number_of(record, "near_hull", 0);
    const bool flat = number_of(record, "dimensions", 3) == 2;  // a section has no frontal area
    if (flat || !(speed > 0) || !(dp > 0) || record.hull.triangles.empty()) return {};
    const Box hull = record.hull.bounds();
    if (hull.max.z() >= 0) return {};
    NumericalDrag d;
    d.spacings = std::min(hull.size().y(), hull.size().z()) / dp;
    if (!(d.spacings > 0)) return {};
    d.coefficient = 1.65 / d.spacings;
    double area = 0;  // what faces the stream
    for (int t = 0; t < static_cast<int>(record.hull.triangles.size()); ++t)
        area += std::max(0.0, -record.hull.area_vector2(t).x() / 2);
    d.force = d.coefficient * 0.5 * number_of(record, "density", 1000) * speed * speed * area;
    return d;
}

}  // namespace

void add_hull_checks(CheckList& list) {
    const RunRecord& record = list.record;
    const double speed = number_of(record, "speed", 0);
    if (const auto air = time_mean(record, "samples", "ventilation"))
        list.add("air in the water at the hull", "-", *air, 0.2,
                 "its mean share; beyond the limit, air smeared under the hull makes friction too low in proportion, "
                 "and a sharper "
                 "surface lowers the lift by 3 to 4 % (measured)");
    const bool edges = speed > 0 && !record.hull_pressure.empty() && has_edges_in_air(record);
    if (const auto suction = suction_share(record); suction && edges)
        list.add("suction on the hull", "%", *suction, 15,
                 "beyond it, water stays attached where it should leave the hull: a step or transom edge that the "
                 "resolution "
                 "misses");
    if (edges)
        if (const auto pocket = deepest_suction(record, speed))
            list.add(
                "suction over rho U^2 / 2", "-", pocket->coefficient, 1,
                fmt::format("at ({:.3g}, {:.3g}, {:.3g}) m", pocket->place.x(), pocket->place.y(), pocket->place.z()) +
                    (pocket->coefficient > 1
                         ? fmt::format(", usually a single bad cell at an edge; such faces make {:.3g} % of the "
                                       "pressure drag, and the lift beside them is too low",
                                       100 * pocket->of_drag)
                         : ""));
    constexpr double of_equal_sections = 0.01;
    if (const auto hull = prismatic_hull(record); hull && hull->bow <= of_equal_sections) {
        const auto drag = time_mean(record, "forces", "fx_pressure"), lift = time_mean(record, "forces", "fz_pressure");
        const double expected = lift.value_or(0) * std::tan(hull->state.trim);
        if (drag && expected > 0)
            list.add(
                "drag against lift times tan trim", "%", 100 * std::abs(*drag / expected - 1), 5,
                fmt::format(
                    "on a bottom of equal sections the pressure acts normal to the keel: with a dry transom {:.4g} N "
                    "of drag belong to this lift, and {:.4g} N were found; the difference acts on the edges",
                    expected, *drag));
    }
    const Column* const sampled = record.series("forces", "fz_surface");  // more rarely than the pairs sum
    const auto sum = time_mean(record, "forces", "fz", sampled), surface = time_mean(record, "forces", "fz_surface"),
               volume = time_mean(record, "forces", "fz_volume");
    // What is left of a load up and a load down that nearly cancel is known no better than they are.
    const double of_load = 0.1 * load_up_and_down(record), scale = std::max(std::abs(sum.value_or(0)), of_load);
    if (sum && (surface || volume) && scale > 0) {
        const double low = std::min({*sum, surface.value_or(*sum), volume.value_or(*sum)});
        const double high = std::max({*sum, surface.value_or(*sum), volume.value_or(*sum)});
        list.add("spread of the force measures", "%", 100 * (high - low) / scale, 3,
                 std::string("pair sum, surface pressure and control volume measure one force") +
                     (scale > std::abs(*sum) ? fmt::format("; there is hardly any {}, so in percent of a tenth of the "
                                                           "pressure's load",
                                                           lower_case_first(force_names(is_stream(record)).up))
                                             : ""));
    }
    if (const auto numerical = numerical_drag(record); numerical)
        if (const auto drag = time_mean(record, "forces", "fx"); drag && *drag != 0) {
            const std::string share =
                numerical->force < std::abs(*drag)
                    ? fmt::format("about {:.3g} N of the {:.3g} N are due to the resolution", numerical->force, *drag)
                    : fmt::format("all of the {:.3g} N may be due to the resolution ({:.3g} N would be expected)",
                                  *drag, numerical->force);
            list.add(
                "numerical drag of a closed body", "%", 100 * numerical->force / std::abs(*drag), 20,
                share + fmt::format(": a coefficient of {:.3g} on the frontal area at a thickness of {:.3g} spacings, "
                                    "where a submerged body in a flow without friction has almost no drag; only runs "
                                    "of several sizes show what remains",
                                    numerical->coefficient, numerical->spacings));
        }
}

}  // namespace tw
