#include <algorithm>
#include <cmath>

#include "foam_cases/read/body_rows.h"
#include "foam_cases/read/number_rows.h"
#include "foam_cases/read/probes.h"
#include "record/gauge_level.h"

namespace tw {
namespace fs = std::filesystem;

namespace {

/// What solids take of the gauges' lines, where bodies have come to.
class SolidsAtGauges {
public:
    SolidsAtGauges(const CasePlan& plan, const fs::path& post, const SolverLog& log, const std::vector<double>& times)
        : gauges_(plan.scene->sampling.height) {
        for (const HeightProbe& g : gauges_) at_rest_.emplace_back(g.x, g.y);
        for (const Solid& solid : plan.solids)
            if (!solid.moves)
                for (SolidColumn& column : at_rest_) column.add(solid.surface);
        for (const BodyInMesh& body : plan.bodies) {
            const auto solid = std::ranges::find(plan.solids, body.patch, &Solid::name);
            Moving& m = moving_.emplace_back(
                Moving{&solid->surface, body.body.motion.mass.centre, 0, body_places(plan, body, post, log, times)});
            for (const Vec3& p : body.body.surface.points) m.reach = std::max(m.reach, (p - m.start).norm());
        }
    }

    /// The stretches of a gauge's line at a time [s]; times ascend from call to call.
    std::vector<Stretch> at(std::size_t gauge, double time) {
        SolidColumn column = at_rest_[gauge];
        for (Moving& m : moving_) {
            while (m.row + 1 < m.places.size() && m.places[m.row + 1].time <= time * (1 + 1e-6)) ++m.row;
            const BodyPlace now = m.places.empty() ? BodyPlace{.centre = m.start} : m.places[m.row];
            const HeightProbe& g = gauges_[gauge];
            // of a section the line is in its plane; its ends are far off
            if (std::abs(now.centre.x() - g.x) > m.reach || std::abs(now.centre.y() - g.y) > m.reach) continue;
            Surface surface = *m.surface;
            for (Vec3& p : surface.points) p = now.centre + now.attitude * (p - m.start);
            column.add(surface);
        }
        return column.stretches();
    }

private:
    struct Moving {
        const Surface* surface;
        Vec3 start;  ///< of its centre of mass [m]
        double reach;
        std::vector<BodyPlace> places;
        std::size_t row = 0;
    };
    const std::vector<HeightProbe>& gauges_;
    std::vector<SolidColumn> at_rest_;
    std::vector<Moving> moving_;
};

}  // namespace

void read_height_probes(const CasePlan& plan, const fs::path& post, const SolverLog& log, RunRecord& record) {
    const auto& probes = plan.scene->sampling.height;
    if (probes.empty()) return;
    Table& t = record.table("height");
    t.time.clear();
    t.columns.clear();
    for (const HeightProbe& p : probes) t.column(p.name, "m");
    std::size_t points = 0;
    for (const auto& column : plan.height_columns) points += column.size();
    const std::vector<std::vector<double>> rows = joined_rows(post / "heightColumns", "alpha.water");
    std::vector<double> times;
    for (const auto& row : rows) times.push_back(row[0]);
    SolidsAtGauges solids(plan, post, log, times);
    const Stretch line{plan.axes[2].planes.front(), plan.axes[2].planes.back()};
    for (const auto& row : rows) {
        if (row.size() != points + 1) continue;
        const std::size_t time = t.append(row[0]);
        std::size_t at = 1;
        for (std::size_t i = 0; i < probes.size(); ++i) {
            std::vector<GaugePart> parts;
            for (const auto& point : plan.height_columns[i]) {
                const double z = point.place.z(), half = point.height / 2;
                parts.push_back({{z - half, z + half}, found_by_probe(row[at++])});
            }
            t.set(time, probes[i].name, "m", gauge_level(line, solids.at(i, row[0]), parts, plan.finest_cell));
        }
    }
}

}  // namespace tw
