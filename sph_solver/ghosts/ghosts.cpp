#include "sph_solver/ghosts/ghosts.h"

#include "sph_solver/backend/for_particles.h"

namespace tw {

Ghosts::Ghosts(const Surroundings& around, const LevelSetup& level, const Quanta& quanta)
    : around_(around), still_{level.rho0, level.state_equation.c0}, planes_(around.domain, quanta) {}

void Ghosts::find(const Surroundings& around, const Particles& p, const ColumnGrid& grid, const Quanta& quanta,
                  double reach) {
    const std::vector<MirrorImage> found = make_mirror_images(around.mirrors, around.domain, p, reach);
    std::vector<WidePlace> places(found.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
        const auto i = static_cast<std::size_t>(found[k].source);
        places[k] = planes_.place(quanta.wide({p.x[i], p.y[i], p.z[i]}), found[k]);
    }
    std::vector<std::int32_t> order;
    sort_by_column(grid, places, order, start_);
    images_.resize(found.size());
    for (std::size_t k = 0; k < found.size(); ++k) images_[k] = found[static_cast<std::size_t>(order[k])];
}

void Ghosts::refresh(Records& r, const Particles& p, double t, const Quanta& quanta, What what) const {
    const std::size_t n = p.size();
    struct Force {
        Vec3 g;                    ///< [m/s2]
        Eigen::Vector3f gradient;  ///< of the density under it [kg/m4]
    };
    const auto carry_on = [&](const auto& force_between) {
        for_particles(images_.size(), [&](std::size_t k) {
            const MirrorImage& image = images_[k];
            const auto i = static_cast<std::size_t>(image.source);
            const PlaceRecord &from = r.place[i], &to = r.place[n + k] = planes_.place(from, image);
            Vec3 step =
                quanta.size * Vec3(difference(to.x, from.x), difference(to.y, from.y), difference(to.z, from.z));
            for (int a = 0; a < 3; ++a)
                if (image.moved(a)) step[a] = 0;  // a periodic flow has the same pressure one length on
            const Force& force = force_between(i, step);
            r.velocity_density[n + k] = mirrored(r.velocity_density[i], image);
            r.velocity_density[n + k].drho += static_cast<float>(still_.deviation(force.g, step));
            if (what != What::all) return;
            GradientPressureRecord s = r.gradient_pressure[i];
            s.gx -= force.gradient.x(), s.gy -= force.gradient.y(), s.gz -= force.gradient.z();
            s = mirrored(s, image);
            s.gx += force.gradient.x(), s.gy += force.gradient.y(), s.gz += force.gradient.z();
            s.p += static_cast<float>(still_.pressure(force.g, step));
            r.gradient_pressure[n + k] = s;
            if (!r.carried.empty()) r.carried[n + k] = mirrored(r.carried[i], image);
        });
    };
    if (!around_.frame) {
        const Force gravity{around_.gravity, still_.gradient(around_.gravity).cast<float>()};
        return carry_on([&](std::size_t, const Vec3&) -> const Force& { return gravity; });
    }
    const FrameForce frame = around_.force(t);
    carry_on([&](std::size_t i, const Vec3& step) {
        const Vec3 g = frame.at(Vec3(p.x[i], p.y[i], p.z[i]) + step / 2, Vec3(p.u[i], p.v[i], p.w[i]));
        return Force{g, still_.gradient(g).cast<float>()};
    });
}

}  // namespace tw
