#include "sph_solver/measure/height_probes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "record/gauge_level.h"
#include "sph_solver/equations/half_space.h"

namespace tw {

namespace {

/// Of the particles whose size is sampled at a place [m].
double smoothing_length_at(const Simulation& simulation, const Vec3& place) {
    std::size_t k = 0;
    while (k < simulation.refinements().size() && simulation.refinements()[k].zone().outside(place) < 0) ++k;
    return simulation.level(k).system().h;
}

/// What solids leave of the kernel at a place in the water.
double room_at(const Simulation& simulation, const Vec3& place) {
    const double h = smoothing_length_at(simulation, place);
    double nearest = 2 * h;
    for (const auto& body : simulation.bodies())
        nearest = std::min(nearest, body->query().nearest(body->at_start(place), nearest).distance);
    return 1 - half_space_support(std::max(nearest, 0.0) / h);
}

}  // namespace

HeightProbes::HeightProbes(const Scene& scene, const SimulationSetup& setup)
    : scene_(scene),
      line_{setup.domain.min.z(), setup.domain.max.z()},
      step_(setup.dp / 2),
      stiffness_(setup.at_rest ? HUGE_VAL : setup.rho0 * setup.state_equation.c0 * setup.state_equation.c0),
      per_probe_(static_cast<std::size_t>(std::ceil(line_.length() / step_))) {
    for (const HeightProbe& g : scene.sampling.height)
        for (std::size_t k = 0; k < per_probe_; ++k)
            points_.places.emplace_back(g.x, g.y, line_.low + (static_cast<double>(k) + 0.5) * step_);
}

std::vector<Stretch> HeightProbes::solids_at(const Simulation& simulation, const HeightProbe& probe) const {
    SolidColumn column(probe.x, probe.y);
    for (const auto& body : simulation.bodies()) {
        const Box at = body->bounds();
        if (probe.x >= at.min.x() && probe.x <= at.max.x() && probe.y >= at.min.y() && probe.y <= at.max.y())
            column.add(body->surface_now());
    }
    return column.stretches();
}

void HeightProbes::record(Simulation& simulation, RunRecord& record) {
    if (points_.places.empty()) return;
    Table& t = record.table("height");
    const std::size_t row = t.append(simulation.time());
    simulation.sample(points_);
    std::vector<GaugePart> parts(per_probe_);
    for (std::size_t n = 0; n < scene_.sampling.height.size(); ++n) {
        const HeightProbe& probe = scene_.sampling.height[n];
        for (std::size_t k = 0; k < per_probe_; ++k) {
            const std::size_t i = n * per_probe_ + k;
            const double support = points_.support[i];
            parts[k].at = {points_.places[i].z() - step_ / 2, points_.places[i].z() + step_ / 2};
            parts[k].water = 0;
            if (!(support > 0)) continue;
            const double room = room_at(simulation, points_.places[i]);
            const double water = support * (1 + points_.p[i] / stiffness_) / room;
            parts[k].water = room < 1 ? std::min(water, 1.0) : water;  // beside edges of solids the room is not exact
        }
        t.set(row, probe.name.c_str(), "m", gauge_level(line_, solids_at(simulation, probe), parts, 2 * step_));
    }
}

}  // namespace tw
