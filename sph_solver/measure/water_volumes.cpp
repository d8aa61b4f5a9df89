#include "sph_solver/measure/water_volumes.h"

#include "base/exact_sum.h"
#include "record/water_in_box.h"

namespace tw {

void record_volumes(const Simulation& simulation, const Scene& scene, RunRecord& record) {
    if (scene.sampling.volumes.empty()) return;
    Table& t = record.table(volume_table);
    const std::size_t row = t.append(simulation.time());
    for (const WaterBox& asked : scene.sampling.volumes) {
        double volume = 0;
        for (const auto& level : simulation.water()) {
            const Particles& p = level->fields().particles();
            const Vec3 edges = Vec3::Constant(level->system().setup.dp);
            const ExactSum shares = level->fields().sum_over_all<ExactSum>([&](ExactSum& sum, std::size_t i) {
                if (p.kind[i] == Kind::fluid) sum += share_in_box(asked.box, Vec3(p.x[i], p.y[i], p.z[i]), edges);
            });
            volume += level->system().mass / level->system().setup.rho0 * shares.value();
        }
        t.set(row, asked.name, scene.spanwise_unit("m3"), volume);
    }
}

}  // namespace tw
