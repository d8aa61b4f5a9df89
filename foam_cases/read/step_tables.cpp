#include <algorithm>
#include <cmath>

#include "foam_cases/read/body_rows.h"
#include "foam_cases/read/frame_reader.h"
#include "foam_cases/read/probes.h"
#include "foam_cases/read/step_loads.h"

namespace tw {
namespace fs = std::filesystem;

namespace {

void read_forces(const CasePlan& plan, const fs::path& case_folder, RunRecord& record) {
    const StepLoads loads = read_loads(case_folder / "postProcessing" / "forces");
    if (loads.time.empty()) return;
    const Scene& scene = *plan.scene;
    const double factor = scene.symmetry_factor() / scene.span(), side = scene.symmetry_factor() > 1 ? 0 : factor;
    Table& t = record.table("forces_total");
    t.time = loads.time;
    t.columns.clear();
    const auto column = [&](const char* name, const char* of_whole, double scale, std::size_t k, bool with_pressure,
                            bool with_viscous) {
        Column& c = t.column(name, scene.spanwise_unit(of_whole));
        c.values.clear();
        for (std::size_t i = 0; i < loads.time.size(); ++i)
            c.values.push_back(
                scale * ((with_pressure ? loads.pressure[i][k] : 0) + (with_viscous ? loads.viscous[i][k] : 0)) + 0.0);
    };
    column("fx", "N", factor, 0, true, true);
    column("fy", "N", side, 1, true, true);
    column("fz", "N", factor, 2, true, true);
    column("my", "N m", factor, 4, true, true);
    column("fx_pressure", "N", factor, 0, true, false);
    column("fz_pressure", "N", factor, 2, true, false);
    column("fx_viscous", "N", factor, 0, false, true);

    // Beside the water's force at the write times: what the solver's own sum over water and air says then.
    Table& water = record.table("forces");
    for (const char* name : {"fx", "fz"}) {
        const std::vector<double>& all = t.find(name)->values;
        std::vector<double> total;
        for (const double time : water.time) {
            const auto at = std::lower_bound(t.time.begin(), t.time.end(), time * (1 - 1e-7));
            const bool met = at != t.time.end() && std::abs(*at - time) <= 1e-6 * time;
            total.push_back(met ? all[static_cast<std::size_t>(at - t.time.begin())] : std::nan(""));
        }
        water.column(std::string(name) + "_total", scene.spanwise_unit("N")).values = total;
    }
}

}  // namespace

void read_step_tables(const CasePlan& plan, const fs::path& case_folder, const SolverLog& log, RunRecord& record) {
    if (!plan.solids.empty()) read_forces(plan, case_folder, record);
    const fs::path post = case_folder / "postProcessing";
    if (plan.scene->hull_is_free()) read_free_hull(plan, post, record);
    for (const BodyInMesh& b : plan.bodies)
        if (!plan.scene->hull_is_free()) read_body(plan, b, post, log, record);
    read_pressure_probes(plan, post, record);
    read_height_probes(plan, post, log, record);
}

}  // namespace tw
