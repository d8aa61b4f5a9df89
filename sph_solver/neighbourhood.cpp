// Which particles are there and who is whose neighbour: open boundaries, sorting, mirror images, groups, lists, wall
// particles and normals; and the records that the pair passes read.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/errors.h"
#include "sph_solver/bodies/slip_normal.h"
#include "sph_solver/bodies/dummies.h"
#include "sph_solver/backend/stopwatch.h"
#include "sph_solver/solver.h"

namespace tw {

void Solver::build_wall() {
    if (!setup_.sliding.empty() && setup_.sliding.size() != setup_.solids.size())
        throw InputError(fmt::format("{} sliding velocities for {} solids; expected one for each, or none",
                                     setup_.sliding.size(), setup_.solids.size()));
    WallDummies all;
    std::vector<VelocityDensityRecord> motion;
    Box region = setup_.domain;
    region.min.array() -= kernel_.support();
    region.max.array() += kernel_.support();
    for (const Surface& surface : setup_.solids) {
        queries_.emplace_back(surface);
        const WallDummies d = make_wall_dummies(queries_.back(), surface.bounds(), setup_.dp,
                                                kernel_.support() + setup_.dp, region, setup_.dimensions);
        all.places.insert(all.places.end(), d.places.begin(), d.places.end());
        all.volumes.insert(all.volumes.end(), d.volumes.begin(), d.volumes.end());
        if (setup_.sliding.empty()) continue;
        const Eigen::Vector3f u = setup_.sliding[queries_.size() - 1].cast<float>();
        motion.resize(all.places.size(), {u.x(), u.y(), u.z(), 0});
    }
    std::vector<WidePlace> raw(all.places.size());
    for (std::size_t k = 0; k < raw.size(); ++k) raw[k] = quanta_.wide(all.places[k]);
    std::vector<std::int32_t> order;
    sort_by_column(grid_, raw, order, wall_start_);
    wall_place_.resize(raw.size());
    wall_motion_.resize(motion.size());
    for (std::size_t k = 0; k < raw.size(); ++k) {
        const auto from = static_cast<std::size_t>(order[k]);
        wall_place_[k] = raw[from].record(static_cast<float>(all.volumes[from]));
    }
    for (std::size_t k = 0; k < motion.size(); ++k) wall_motion_[k] = motion[static_cast<std::size_t>(order[k])];
    wall_p_.assign(raw.size(), 0);
    make_groups(grid_, {wall_place_.data(), &wall_start_, 0}, passes_->lanes, wall_groups_);
}

/// Who has crossed a plane, who has left (marked), who is new (appended).
std::vector<char> Solver::cross_open_boundaries() {
    const SolverSetup& s = setup_;
    Particles& p = particles_;
    std::vector<char> gone(p.size(), 0);
    if (s.stream) {
        const Stream& stream = *s.stream;
        const std::size_t n = p.size();
        for (std::size_t i = 0; i < n; ++i) {
            switch (p.kind[i]) {
                case Kind::inlet:
                    if (p.x[i] < s.domain.min.x()) break;
                    p.kind[i] = Kind::fluid;
                    p.add(p.x[i] - stream.buffer, p.y[i], p.z[i], p.u[i], p.drho[i], next_id_++, Kind::inlet);
                    ++ledger_.in;
                    break;
                case Kind::fluid:
                    if (p.x[i] > s.domain.max.x())
                        p.kind[i] = Kind::outlet;
                    else if (p.x[i] < s.domain.min.x() - 0.5 * s.dp)
                        gone[i] = 1;  // washed back into the inlet
                    break;
                case Kind::outlet:
                    if (p.x[i] > s.domain.max.x() + stream.buffer) gone[i] = 1;
                    break;
            }
        }
        gone.resize(p.size(), 0);
    }
    return_from_mirrors(s.mirrors, s.domain, p);
    for (std::size_t i = 0; i < p.size(); ++i)
        if (p.z[i] > s.domain.max.z() && !s.mirrors.on[2][1] && !s.mirrors.periodic[2])
            gone[i] = 1;  // through the open top
    return gone;
}

void Solver::rebuild(double drift) {
    const Stopwatch watch(timers_.lists);
    ++timers_.rebuilds;
    const SolverSetup& s = setup_;
    Particles& p = particles_;

    const std::vector<char> gone = cross_open_boundaries();
    place_.resize(p.size());
    std::vector<WidePlace> kept;
    std::vector<std::int32_t> index;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (gone[i]) {
            ++ledger_.out;
            continue;
        }
        kept.push_back(quanta_.wide({p.x[i], p.y[i], p.z[i]}));
        index.push_back(static_cast<std::int32_t>(i));
    }
    std::vector<std::int32_t> order;
    sort_by_column(grid_, kept, order, start_);
    for (auto& k : order) k = index[static_cast<std::size_t>(k)];
    p.reorder(order);
    const std::size_t n = p.size();

    // mirror images, sorted the same way
    const double support = kernel_.support(), skin = skin_over_dp * s.dp, wall_skin = wall_skin_over_dp * s.dp;
    const auto reaches = [&](double now, double slack) {
        return Reaches{std::max(support + slack, now), now, support - slack};
    };
    const Reaches among = reaches(reach_among(drift), skin), to_walls = reaches(reach_to_walls(drift), wall_skin);
    images_ = make_mirror_images(s.mirrors, s.domain, p, std::max(among.far, to_walls.far));
    std::vector<WidePlace> image_places(images_.size());
    for (std::size_t k = 0; k < images_.size(); ++k) {
        const auto i = static_cast<std::size_t>(images_[k].source);
        image_places[k] = mirror_planes_->place(quanta_.wide({p.x[i], p.y[i], p.z[i]}), images_[k]);
    }
    sort_by_column(grid_, image_places, order, image_start_);
    {
        std::vector<MirrorImage> sorted(images_.size());
        for (std::size_t k = 0; k < images_.size(); ++k) sorted[k] = images_[static_cast<std::size_t>(order[k])];
        images_ = std::move(sorted);
    }
    place_.resize(n + images_.size());
    motion_.resize(n + images_.size());
    stress_.resize(n + images_.size());
    shift_.resize(n);
    rate_.resize(n);
    surface_.assign((n + images_.size()) / 32 + 2, 0);
    if (!wall_place_.empty()) normal_.resize(n);
    if (control_) carried_.resize(n + images_.size());
    update_records();

    const std::vector<Source> sources = {{place_.data(), &start_, 0},
                                         {place_.data() + n, &image_start_, static_cast<std::int32_t>(n)}};
    make_groups(grid_, sources[0], passes_->lanes, groups_);
    lists_.build(*passes_, grid_, quanta_, sources[0], groups_, sources, among);
    if (!wall_place_.empty()) {
        const Source walls{wall_place_.data(), &wall_start_, 0};
        wall_lists_.build(*passes_, grid_, quanta_, sources[0], groups_, {walls}, to_walls, &Group::wall_list);
        live_wall_groups_ = wall_groups_;
        wall_source_lists_.build(*passes_, grid_, quanta_, walls, live_wall_groups_, sources, to_walls);
        std::fill(wall_p_.begin(), wall_p_.end(), 0.0f);
        std::erase_if(live_wall_groups_, [](const Group& g) { return g.list.size == 0; });
        std::int32_t near_wall = 0;
        for (Group& g : groups_)
            if (g.wall_list.size > 0) g.wall_load = near_wall++;
        wall_load_.resize(static_cast<std::size_t>(near_wall));
        find_normals();
    }
    travel_ = travel_in_stream_ = 0;
    rebuild_due_ = false;
}

WallNormalRecord Solver::nearest_wall(std::size_t i, double reach) const {
    WallNormalRecord r = no_wall;
    const Vec3 x(particles_.x[i], particles_.y[i], particles_.z[i]);
    const Vec3 u(particles_.u[i], particles_.v[i], particles_.w[i]);
    for (const SurfaceQuery& query : queries_) {
        const SurfaceQuery::Nearest nearest = query.nearest(x, reach);
        if (nearest.triangle < 0 || nearest.distance >= r.distance) continue;
        const Vec3 n = slip_normal(query, nearest, u);
        r = {static_cast<float>(n.x()), static_cast<float>(n.y()), static_cast<float>(n.z()),
             static_cast<float>(nearest.distance)};
    }
    return r;
}

void Solver::find_normals() {
    const double reach = 2 * kernel_.support() + setup_.dp;
    std::int64_t through = -1;
#pragma omp parallel for schedule(dynamic, 16)
    for (std::size_t k = 0; k < groups_.size(); ++k) {
        const Group& g = groups_[k];
        for (int l = 0; l < g.size; ++l) {
            const auto i = static_cast<std::size_t>(g.first + l);
            normal_[i] = g.wall_list.size > 0 ? nearest_wall(i, reach) : no_wall;
            if (normal_[i].distance < -setup_.dp) {
#pragma omp critical
                through = std::max(through, static_cast<std::int64_t>(i));
            }
        }
    }
    if (through >= 0) {
        ++ledger_.lost;
        fail_at(static_cast<std::size_t>(through),
                "has gone through the hull; often a wall thinner than the kernel's support 2 h, or a spacing too "
                "coarse for a sharp edge");
    }
}

void Solver::update_records() {
    const Particles& p = particles_;
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < p.size(); ++i) {
        place_[i] = place_record(i);
        motion_[i] = {p.u[i], p.v[i], p.w[i], p.drho[i]};
    }
    update_mirror_images(false);
}

void Solver::update_mirror_images(bool stress) {
    const Hydrostatic still{setup_.gravity, setup_.rho0, setup_.state_equation.c0};
    const Eigen::Vector3f gradient = still.gradient().cast<float>();
    const std::size_t n = particles_.size();
#pragma omp parallel for schedule(static)
    for (std::size_t k = 0; k < images_.size(); ++k) {
        const MirrorImage& image = images_[k];
        const auto i = static_cast<std::size_t>(image.source);
        const PlaceRecord &from = place_[i], &to = place_[n + k] = mirror_planes_->place(from, image);
        Vec3 step = quanta_.size * Vec3(difference(to.x, from.x), difference(to.y, from.y), difference(to.z, from.z));
        for (int a = 0; a < 3; ++a)
            if (image.moved(a)) step[a] = 0;  // a periodic flow has the same pressure one length on
        motion_[n + k] = mirrored(motion_[i], image);
        motion_[n + k].drho += static_cast<float>(still.deviation(step));
        if (!stress) continue;
        GradientPressureRecord s = stress_[i];
        s.gx -= gradient.x(), s.gy -= gradient.y(), s.gz -= gradient.z();
        s = mirrored(s, image);
        s.gx += gradient.x(), s.gy += gradient.y(), s.gz += gradient.z();
        s.p += static_cast<float>(still.pressure(step));
        stress_[n + k] = s;
        if (!carried_.empty()) carried_[n + k] = carried_[i];
    }
}

}  // namespace tw
