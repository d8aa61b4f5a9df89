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
    const FrameForce force = around_.force(t);
    for_particles(images_.size(), [&](std::size_t k) {
        const MirrorImage& image = images_[k];
        const auto i = static_cast<std::size_t>(image.source);
        const PlaceRecord &from = r.place[i], &to = r.place[n + k] = planes_.place(from, image);
        Vec3 step = quanta.size * Vec3(difference(to.x, from.x), difference(to.y, from.y), difference(to.z, from.z));
        for (int a = 0; a < 3; ++a)
            if (image.moved(a)) step[a] = 0;  // a periodic flow has the same pressure one length on
        Vec3 g = around_.gravity;
        if (around_.frame) g = force.at(Vec3(p.x[i], p.y[i], p.z[i]) + step / 2, Vec3(p.u[i], p.v[i], p.w[i]));
        r.velocity_density[n + k] = mirrored(r.velocity_density[i], image);
        r.velocity_density[n + k].drho += static_cast<float>(still_.deviation(g, step));
        if (what != What::all) return;
        const Eigen::Vector3f gradient = still_.gradient(g).cast<float>();
        GradientPressureRecord s = r.gradient_pressure[i];
        s.gx -= gradient.x(), s.gy -= gradient.y(), s.gz -= gradient.z();
        s = mirrored(s, image);
        s.gx += gradient.x(), s.gy += gradient.y(), s.gz += gradient.z();
        s.p += static_cast<float>(still_.pressure(g, step));
        r.gradient_pressure[n + k] = s;
        if (!r.carried.empty()) r.carried[n + k] = r.carried[i];
    });
}

}  // namespace tw
