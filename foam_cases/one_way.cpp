#include "foam_cases/one_way.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "structure/degrees_of_freedom.h"
#include "structure/shell_history.h"

namespace tw {
namespace {

constexpr double steps_per_period = 100;

/// From the time `from` on [s].
structure::PressureHistory pressures_of(const Table& table, double from) {
    structure::PressureHistory history;
    for (std::size_t k = 0; k < table.time.size(); ++k) {
        if (table.time[k] < from * (1 - 1e-9)) continue;
        history.time.push_back(table.time[k]);
        Eigen::VectorXd& p = history.pressure.emplace_back(static_cast<Eigen::Index>(table.columns.size()));
        for (std::size_t e = 0; e < table.columns.size(); ++e)
            p[static_cast<Eigen::Index>(e)] = table.columns[e].values[k];
    }
    return history;
}

/// Of a history, linear between its times; NaN before and after them.
double value_at(const std::vector<double>& time, const std::vector<double>& values, double t) {
    const auto after = static_cast<std::size_t>(std::ranges::lower_bound(time, t) - time.begin());
    if (after == time.size()) return std::nan("");
    if (after == 0) return t < time.front() * (1 - 1e-9) ? std::nan("") : values.front();
    const double share = (t - time[after - 1]) / (time[after] - time[after - 1]);
    return (1 - share) * values[after - 1] + share * values[after];
}

/// Three columns of a table as vectors; nothing where it lacks one.
std::vector<Vec3> vectors(const Table& table, const std::array<const char*, 3>& names) {
    std::vector<Vec3> out(table.time.size());
    for (int axis = 0; axis < 3; ++axis) {
        const Column* c = table.find(names[static_cast<std::size_t>(axis)]);
        if (!c) return {};
        for (std::size_t k = 0; k < out.size(); ++k) out[k][axis] = c->values[k];
    }
    return out;
}

/// How the rigid plate came through the times at its start at which the record has no force.
struct FalseStart {
    double end = 0;                ///< the first time with a force [s]
    Vec3 moved = Vec3::Zero();     ///< until then [m]
    std::optional<Vec3> velocity;  ///< there [m/s]; none where the record does not say
    double share = 0;              ///< of all that the fluid changes the velocity by in the whole record

    FalseStart(const Table& body, const ElasticPlate& plate, double gravity) {
        const Column* force = body.find("fz");
        std::size_t first = 0;
        while (force && first < body.time.size() && std::isnan(force->values[first])) ++first;
        const std::vector<Vec3> x = vectors(body, {"x", "y", "z"}), v = vectors(body, {"vx", "vy", "vz"});
        if (first == 0 || first == body.time.size() || x.empty() || v.empty()) return;
        end = body.time[first];
        moved = x[first] - plate.centre();
        velocity = v[first];
        const auto by_fluid = [&](std::size_t k) {
            return (v[k] - plate.velocity + body.time[k] * Vec3(0, 0, gravity)).norm();
        };
        double most = 0;
        for (std::size_t k = first; k < v.size(); ++k) most = std::max(most, by_fluid(k));
        if (most > 0) share = by_fluid(first) / most;
    }

    std::string sentence() const {
        if (!velocity) return "";
        std::string text = fmt::format(
            "; before {:.3g} ms, while the solver sets air and water in motion, nothing loads the shell: {:.0f} % of "
            "the change of velocity that the fluid causes on the rigid plate is left out",
            1e3 * end, 100 * share);
        if (share > largest_false_start)
            text += ", so this is not the response to the impact; let the plate start farther from the water";
        return text;
    }
};

std::string sentence(const std::string& body, double gap, double period) {
    std::string text = fmt::format(
        "strains and displacements of {} are one way: the pressures on the rigid plate, applied to the shell after the "
        "run; they were written every {:.3g} ms, {:.0f} times in the shell's first period of {:.3g} ms",
        body, 1e3 * gap, period / gap, 1e3 * period);
    if (period / gap < fewest_per_period)
        text +=
            fmt::format(", which is too few: expected {:.0f}, with a smaller near_hull or a smaller [fvm] max_courant",
                        fewest_per_period);
    return text;
}

}  // namespace

void add_one_way_strains(const Scene& scene, RunRecord& record) {
    for (const MovingBody& body : scene.bodies) {
        const auto found = record.tables.find(plate_pressure_table(body.name));
        if (!body.plate() || body.plate()->gauges.empty() || found == record.tables.end()) continue;
        const ElasticPlate& plate = *body.plate();
        Table& table = record.table(body_table(body.name));
        const FalseStart start(table, plate, scene.water.gravity);
        const structure::PressureHistory history = pressures_of(found->second, start.end);
        if (history.time.size() < 2) continue;
        const structure::Shell shell = shell_of(plate, plate.strip());
        const structure::DegreesOfFreedom dofs = dofs_of(plate, shell, plate.strip());
        const double period = plate.first_period();
        std::vector<structure::Gauge> gauges;
        std::vector<Vec3> points;
        for (const ElasticGauge& g : plate.gauges)
            if (g.direction)
                gauges.push_back({g.name, g.position, *g.direction, g.top});
            else
                points.push_back(g.position);
        const structure::ShellHistory answer =
            structure::shell_history(shell, dofs, history, gauges, points,
                                     {.velocity = start.velocity.value_or(plate.velocity),
                                      .gravity = Vec3(0, 0, -scene.water.gravity),
                                      .damping = plate.damping,
                                      .large_rotations = plate.large_rotations,
                                      .step = period / steps_per_period});
        const auto put = [&](const std::string& name, const std::string& unit, const std::vector<double>& values) {
            Column& column = table.column(name, unit);
            column.values.clear();
            for (const double t : table.time) column.values.push_back(value_at(answer.time, values, t));
        };
        std::size_t strain = 0, point = 0;
        for (const ElasticGauge& g : plate.gauges) {
            if (g.direction) {
                put(g.name, "-", answer.strains[strain++]);
                continue;
            }
            for (int axis = 0; axis < 3; ++axis) {
                std::vector<double> along;
                for (const Vec3& d : answer.displacements[point]) along.push_back(start.moved[axis] + d[axis]);
                put(fmt::format("{}_{}", g.name, "xyz"[axis]), "m", along);
            }
            ++point;
        }
        record.attributes["structure"] = "rigid, strains one way";
        record.attributes["one_way"] = sentence(body.name, history.longest_gap(), period) + start.sentence();
    }
}

}  // namespace tw
