#include "sph_solver/measure/water_raster.h"

namespace tw {

namespace {

/// Pours what is `wanted` of a level's particles.
template <class Wanted>
void pour(Raster& raster, const Level& level, double span, const Wanted& wanted) {
    const Particles& p = level.particles();
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Vec3 place(p.x[i], p.y[i], p.z[i]);
        if (level.owns(i) && wanted(p.kind[i], place))
            raster.pour(place, level.setup().dp, level.mass() * span / (level.setup().rho0 + double(p.drho[i])));
    }
}

}  // namespace

Raster water_raster(const Simulation& simulation, const RasterSpec& spec, double span) {
    // fine particles that have just left their zone, and are no guards yet, are nearer to it than that
    constexpr double spray_over_dp = 1;
    const auto levels = simulation.water();
    Raster all(spec);
    if (spec.voxel <= 0) return all;
    const auto each = [](Kind, const Vec3&) { return true; };
    pour(all, *levels[0], span, each);
    for (std::size_t k = 1; k < levels.size(); ++k) {
        const Level& level = *levels[k];
        Raster of_size(spec);
        pour(of_size, level, span, each);
        const Zone& zone = simulation.refinements()[k - 1].zone();
        const double beyond = spray_over_dp * level.setup().dp;
        pour(all, level, span,
             [&](Kind kind, const Vec3& place) { return kind == Kind::fluid && zone.outside(place) > beyond; });
        all.take_where([&](const Vec3& centre) { return zone.outside(centre) < 0; }, of_size);
    }
    levels[0]->ranks().add(all.parts());
    return all;
}

}  // namespace tw
