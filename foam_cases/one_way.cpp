#include "foam_cases/one_way.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "structure/freedoms.h"
#include "structure/shell/shell_history.h"

namespace tw {
namespace {

constexpr double steps_per_period = 100;

structure::PressureHistory pressures_of(const Table& table) {
    structure::PressureHistory history;
    history.time = table.time;
    for (std::size_t k = 0; k < table.time.size(); ++k) {
        Eigen::VectorXd& p = history.pressure.emplace_back(static_cast<Eigen::Index>(table.columns.size()));
        for (std::size_t e = 0; e < table.columns.size(); ++e)
            p[static_cast<Eigen::Index>(e)] = table.columns[e].values[k];
    }
    return history;
}

/// Of a history, linear between its times; NaN after its end.
double value_at(const std::vector<double>& time, const std::vector<double>& values, double t) {
    const auto after = static_cast<std::size_t>(std::ranges::lower_bound(time, t) - time.begin());
    if (after == time.size()) return std::nan("");
    if (after == 0) return values.front();
    const double share = (t - time[after - 1]) / (time[after] - time[after - 1]);
    return (1 - share) * values[after - 1] + share * values[after];
}

std::string sentence(const std::string& body, double gap, double period) {
    std::string text = fmt::format(
        "strains and displacements of {} are one way: the pressures on the rigid plate, put onto the shell after the "
        "run; they are there every {:.3g} ms, {:.0f} times in the shell's first period of {:.3g} ms",
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
        if (found->second.time.size() < 2) continue;
        const ElasticPlate& plate = *body.plate();
        const structure::PressureHistory history = pressures_of(found->second);
        const structure::Shell shell = shell_of(plate, plate.strip());
        const structure::Freedoms freedoms = freedoms_of(plate, shell, plate.strip());
        const double period = plate.first_period();
        std::vector<structure::Gauge> gauges;
        std::vector<Vec3> points;
        for (const ElasticGauge& g : plate.gauges)
            if (g.direction)
                gauges.push_back({g.name, g.position, *g.direction, g.top});
            else
                points.push_back(g.position);
        const structure::ShellHistory answer = structure::shell_history(shell, freedoms, history, gauges, points,
                                                                        {.velocity = plate.velocity,
                                                                         .gravity = Vec3(0, 0, -scene.water.gravity),
                                                                         .damping = plate.damping,
                                                                         .large_rotations = plate.large_rotations,
                                                                         .step = period / steps_per_period});
        Table& table = record.table(body_table(body.name));
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
                for (const Vec3& d : answer.displacements[point]) along.push_back(d[axis]);
                put(fmt::format("{}_{}", g.name, "xyz"[axis]), "m", along);
            }
            ++point;
        }
        record.attributes["structure"] = "rigid, strains one way";
        record.attributes["one_way"] = sentence(body.name, history.longest_gap(), period);
    }
}

}  // namespace tw
