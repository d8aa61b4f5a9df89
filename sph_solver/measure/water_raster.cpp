#include "sph_solver/measure/water_raster.h"

#include "sph_solver/backend/for_particles.h"

namespace tw {

namespace {

/// Pours what is `wanted` of a level's particles.
template <class Wanted>
void pour(Raster& raster, const Level& level, double span, const Wanted& wanted) {
    const Particles& p = level.fields().particles();
    for_particles(p.size(), [&](std::size_t i) {
        const Vec3 place(p.x[i], p.y[i], p.z[i]);
        if (level.share().owns(i) && wanted(p.kind[i], place))
            raster.share_out(place, level.system().setup.dp,
                             level.system().mass * span / (level.system().setup.rho0 + double(p.drho[i])));
    });
}

/// A box that holds a zone.
Box box_of(const Zone& zone) {
    Box box = zone.boxes().front();
    for (const Box& part : zone.boxes()) box.min = box.min.cwiseMin(part.min), box.max = box.max.cwiseMax(part.max);
    return box;
}

}  // namespace

Raster water_raster(const Simulation& simulation, const RasterSpec& spec, double span) {
    // fine particles that have just left their zone, and are no buffer particles yet, are nearer to it than that
    constexpr double spray_over_dp = 1;
    const auto levels = simulation.water();
    Raster all(spec);
    if (spec.voxel <= 0) return all;
    const auto each = [](Kind, const Vec3&) { return true; };
    pour(all, *levels[0], span, each);
    for (std::size_t k = 1; k < levels.size(); ++k) {
        const Level& level = *levels[k];
        const Zone& zone = simulation.refinements()[k - 1].zone();
        Raster of_size(spec, box_of(zone));
        pour(of_size, level, span, each);
        const double beyond = spray_over_dp * level.system().setup.dp;
        pour(all, level, span,
             [&](Kind kind, const Vec3& place) { return kind == Kind::fluid && zone.outside(place) > beyond; });
        for_pieces(static_cast<std::size_t>(all.layers()), [&](std::size_t layer) {
            all.take_where([&](const Vec3& centre) { return zone.outside(centre) < 0; }, of_size,
                           static_cast<int>(layer));
        });
    }
    levels[0]->system().ranks().add(all.parts());
    return all;
}

}  // namespace tw
