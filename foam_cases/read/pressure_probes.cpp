#include <algorithm>

#include "foam_cases/read/number_rows.h"
#include "foam_cases/read/probes.h"

namespace tw {
namespace fs = std::filesystem;

namespace {

/// In the tank's own axes, at a time [s], [m/s2].
Vec3 gravity_at(const Scene& scene, double time) {
    const Vec3 gravity(0, 0, -scene.water.gravity);
    return scene.tank_motion ? Vec3(scene.tank_motion->force(time, gravity).at(Vec3::Zero(), Vec3::Zero())) : gravity;
}

/// Rows of a field at the probes, asked for by time.
class Rows {
public:
    Rows(const fs::path& function_object, const char* field) : rows_(joined_rows(function_object, field)) {}
    const std::vector<std::vector<double>>& all() const { return rows_; }
    /// Times ascend from call to call; null: there is none at that time.
    const std::vector<double>* at(double time) {
        while (next_ < rows_.size() && rows_[next_][0] < time) ++next_;
        return next_ < rows_.size() && rows_[next_][0] == time ? &rows_[next_] : nullptr;
    }

private:
    std::vector<std::vector<double>> rows_;
    std::size_t next_ = 0;
};

}  // namespace

void read_pressure_probes(const CasePlan& plan, const fs::path& post, RunRecord& record) {
    const Scene& scene = *plan.scene;
    const auto& probes = scene.sampling.pressure;
    if (probes.empty()) return;
    Table& t = record.table("pressure");
    t.time.clear();
    t.columns.clear();
    for (const PressureProbe& p : probes) t.column(p.name, "Pa");
    const fs::path folder = post / "pressureProbes";
    const Rows pressures(folder, "p");
    Rows dynamic(folder, "p_rgh"), water(folder, "alpha.water");
    for (const std::vector<double>& p : pressures.all()) {
        const std::vector<double>*p_rgh = dynamic.at(p[0]), *alpha = water.at(p[0]);
        if (p.size() != probes.size() + 1 || !p_rgh || !alpha || p_rgh->size() != p.size() || alpha->size() != p.size())
            continue;
        const std::size_t row = t.append(p[0]);
        const Vec3 gravity = gravity_at(scene, p[0]);
        for (std::size_t i = 0; i < probes.size(); ++i) {
            const double share = std::clamp((*alpha)[i + 1], 0.0, 1.0);
            const double density = share * scene.water.density + (1 - share) * scene.water.air_density;
            const double wet = (*p_rgh)[i + 1] + density * gravity.dot(probes[i].place);
            t.set(row, probes[i].name, "Pa", found_by_probe(share >= 0.5 ? wet : p[i + 1]));
        }
    }
}

}  // namespace tw
