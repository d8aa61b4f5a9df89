#include "sph_solver/levels/on_processor.h"

#include "sph_solver/backend/for_particles.h"
#include "sph_solver/loops/surface.h"

namespace tw {

// --- an evaluation
// ----------------------------------------------------------------------------------------------------

void LevelOnProcessor::first_pair_loop(const OtherSums* other) {
    FirstPairLoopData d = level_.first_pair_loop_data();
    d.other = other;
    for_pairs(level_.passes, d, level_.near.clusters);
}

void LevelOnProcessor::mark_surface() {
    Particles& p = level_.particles;
    const MarkBits mark{level_.lacks_support(p.view()), level_.ghosts.links().data(), p.size(), p.place.size(),
                        p.surface.data()};
    for_particles(p.surface.size(), mark);
}

void LevelOnProcessor::compress(double compress, double drift) {
    Particles& p = level_.particles;
    if (p.has(With::coarser)) p.density_rate.assign(p.size(), 0);
    const AfterFirstPairLoop after = level_.after_first_pair_loop(p.view(), compress, drift);
    for_particles(p.size(), [&](std::size_t i) {
        after(
            i, [&](float drho) { return level_.setup.state_equation.pressure(level_.setup.rho0, drho); },
            [&](std::size_t k, const V3<double>& u) { return level_.leaving(k, u); });
    });
}

void LevelOnProcessor::refresh_images(double t) {
    Particles& p = level_.particles;
    level_.ghosts.refresh(p, t, p.velocity_density, p.gradient_pressure, p.carried);
}

void LevelOnProcessor::press_walls() {
    Walls& walls = level_.walls;
    for (const Walls::Part& part : walls.parts()) {
        ExtrapolateData e = level_.extrapolation();
        e.list = part.water.view();
        e.at = walls.places().data() + part.first;
        e.p = walls.pressures().data() + part.first;
        if (walls.accelerations()) e.acceleration = walls.accelerations() + part.first;
        for_pairs(level_.passes, e, part.near_water);
    }
}

void LevelOnProcessor::second_pair_loop(double t) {
    for_pairs(level_.passes, level_.second_pair_loop_data(t), level_.near.clusters);
}

// --- loads and the end of a step
// --------------------------------------------------------------------------------------

Vec3 LevelOnProcessor::centre_of_cluster(std::size_t k) const {
    const Cluster& g = level_.near.clusters[k];
    const auto i = static_cast<std::size_t>(g.first);
    const Particles& p = level_.particles;
    const FixedPoint& q = level_.fixed_point;
    return {q.metres(g.x, 0, p.x[i]), q.metres(g.y, 1, p.y[i]), q.metres(g.z, 2, p.z[i])};
}

std::vector<std::int32_t> LevelOnProcessor::copy_pressed_to_host(MayBePressed condition) {
    const Particles& p = level_.particles;
    condition.wall = p.wall_normal.data(), condition.kind = p.kind.data();
    std::vector<std::int32_t> which;
    for (std::size_t i = 0; i < p.size(); ++i)
        if (condition(i)) which.push_back(static_cast<std::int32_t>(i));
    return which;
}

void LevelOnProcessor::push(const std::vector<std::int32_t>& which, const std::vector<V3<float>>& accelerations) {
    const AddPushes add{which.data(), accelerations.data(), level_.particles.rate.data()};
    for (std::size_t k = 0; k < which.size(); ++k) add(k);
}

std::vector<Moved> LevelOnProcessor::move(const Move& by, const Hold& hold) {
    Particles& p = level_.particles;
    const ControlVolume* const control = level_.control ? &*level_.control : nullptr;
    const double held_from = Move::held_at_wall_over_dp * level_.setup.dp;
    const auto move_range = [&](Moved& part, std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const double u0 = p.u[i], v0 = p.v[i], w0 = p.w[i];
            const double was_inside =
                control ? control->share(p.x[i] - by.drifted * u0, p.y[i] - by.drifted * v0, p.z[i] - by.drifted * w0)
                        : 0;
            const V3<double> shift = by.kick(i, part);
            const V3<double> along = by.along(i);
            by.drift_along(i, along, shift);
            if (!p.wall_normal.empty() && kept_out_of_solids(p.kind[i])) {
                PackedWallNormal& r = p.wall_normal[i];
                r.distance += static_cast<float>(by.drift * level_.leaving(i, along) + dot(shift, normal_of(r)));
                if (r.distance < held_from) hold(i, part);
            }
            by.note(i, part);
            if (control && share_.owns(i)) {
                // momentum of what crosses a face, with the velocity in the middle of the step
                const double crossing = control->share(p.x[i], p.y[i], p.z[i]) - was_inside;
                if (crossing != 0)
                    part.crossed += crossing * Vec3((u0 + double(p.u[i])) / 2, (v0 + double(p.v[i])) / 2,
                                                    (w0 + double(p.w[i])) / 2);
            }
            if (part.broken) break;
        }
    };
    return in_fixed_ranges<Moved>(p.size(), move_range);
}

KindCounts LevelOnProcessor::count(CountKinds kinds) {
    KindCounts counts;
    kinds.kind = level_.particles.kind.data(), kinds.x = level_.particles.x.data(), kinds.counts = &counts;
    kinds.own = share_.own();
    for (std::size_t i = 0; i < level_.particles.size(); ++i) kinds(i, [](int* count) { ++*count; });
    return counts;
}

}  // namespace tw
