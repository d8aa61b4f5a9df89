#include "sph_solver/bodies/walls.h"

#include <algorithm>

#include "sph_solver/backend/for_particles.h"
#include "sph_solver/bodies/slip_normal.h"
#include "sph_solver/pair_loops/views.h"

namespace tw {

Walls::Walls(const Bodies& bodies, const Surroundings& around, const LevelSetup& level, double kernel_support,
             const PencilGrid& grid, const FixedPoint& fixed_point, int lanes)
    : bodies_(bodies), two_dimensional_(around.dimensions == 2), loads_(bodies.size()) {
    Box region = around.domain;
    region.min.array() -= kernel_support;
    region.max.array() += kernel_support;
    const bool keep_places = !all_fixed(bodies) || around.frame;
    for (const auto& body : bodies) {
        Box wanted = region;
        for (int a = 0; a < 3; ++a) {
            if (body->stays_along(a)) continue;  // else it may come in from outside
            wanted.min[a] = body->surface().bounds().min[a] - level.dp;
            wanted.max[a] = body->surface().bounds().max[a] + level.dp;
        }
        const Dummies d = body->dummies({level.dp, kernel_support + level.dp, wanted, around.dimensions});
        any_deformable_ = any_deformable_ || body->is_deformable();
        press_ = press_ || body->presses();
        Part& part = parts_.emplace_back();
        part.first = place_.size();
        std::vector<WidePlace> raw(d.places.size());
        for (std::size_t k = 0; k < raw.size(); ++k) raw[k] = fixed_point.wide(d.places[k]);
        std::vector<std::int32_t> order;
        sort_by_pencil(grid, raw, order, part.start);
        std::vector<Vec3> places;
        for (const std::int32_t n : order) {
            const auto k = static_cast<std::size_t>(n);
            place_.push_back(raw[k].packed(static_cast<float>(d.volumes[k])));
            if (keep_places) places.push_back(d.places[k]);
        }
        if (keep_places) attached_.push_back(body->attach(std::move(places)));
        body_end_.push_back(static_cast<std::int32_t>(place_.size()));
        make_clusters({&grid, place_.data() + part.first, &part.start, 0}, lanes, part.clusters);
    }
    p_.assign(place_.size(), 0);
    if (!std::ranges::all_of(bodies_, [](const auto& body) { return body->sliding().isZero(0); }))
        for (std::size_t b = 0; b < bodies_.size(); ++b) {
            const Eigen::Vector3f along = bodies_[b]->sliding().cast<float>();
            sliding_.resize(end_of(b), {along.x(), along.y(), along.z(), 0});
        }
    if (keep_places) acceleration_.resize(place_.size());
    if (all_fixed(bodies)) return;
    velocity_.resize(place_.size());
    follow(fixed_point);
}

double Walls::fastest() const {
    double most = 0;
    for (const auto& body : attached_) most = std::max(most, body->fastest());
    return most;
}

std::vector<WallMotion> Walls::motions() const {
    std::vector<WallMotion> all;
    if (move())
        for (const auto& body : attached_) all.push_back(body->surface_motion());
    return all;
}

void Walls::note_motions() {
    for (const auto& body : attached_) body->look();
}

void Walls::follow(const FixedPoint& fixed_point) {
    if (!move()) return;
    note_motions();
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        if (bodies_[b]->fixed()) continue;
        const Attached& points = *attached_[b];
        const std::size_t first = parts_[b].first;
        for (std::size_t k = 0; k < points.size(); ++k) {
            const Vec3 x = points.place(k);
            const Attached::Motion motion = points.motion(k, x);
            const Eigen::Vector3f u = motion.velocity.cast<float>(), a = motion.acceleration.cast<float>();
            place_[first + k] = fixed_point.wide(x).packed(place_[first + k].volume);
            velocity_[first + k] = {u.x(), u.y(), u.z()};
            acceleration_[first + k] = {a.x(), a.y(), a.z()};
        }
    }
}

void Walls::feel(const FrameForce& f, const Vec3& gravity) {
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const Attached& points = *attached_[b];
        for (std::size_t k = 0; k < points.size(); ++k) {
            const Vec3 x = points.place(k);
            const Attached::Motion own = bodies_[b]->fixed() ? Attached::Motion{} : points.motion(k, x);
            const Eigen::Vector3f a = (own.acceleration + gravity - f.at(x, own.velocity)).cast<float>();
            acceleration_[parts_[b].first + k] = {a.x(), a.y(), a.z()};
        }
    }
}

void Walls::sort(const PencilGrid& grid, const FixedPoint& fixed_point, int lanes) {
    if (!move()) return;
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        if (bodies_[b]->fixed()) continue;
        Part& part = parts_[b];
        Attached& points = *attached_[b];
        std::vector<WidePlace> raw;
        for (std::size_t k = 0; k < points.size(); ++k) raw.push_back(fixed_point.wide(points.place(k)));
        std::vector<std::int32_t> order;
        sort_by_pencil(grid, raw, order, part.start);
        const std::vector<PackedPlace> place(place_.begin() + static_cast<std::ptrdiff_t>(part.first),
                                             place_.begin() + static_cast<std::ptrdiff_t>(end_of(b)));
        for (std::size_t k = 0; k < order.size(); ++k) {
            const auto from = static_cast<std::size_t>(order[k]);
            place_[part.first + k] = raw[from].packed(place[from].volume);
        }
        points.reorder(order);
        make_clusters({&grid, place_.data() + part.first, &part.start, 0}, lanes, part.clusters);
    }
    follow(fixed_point);
}

Dummies Walls::dummies(std::size_t body) const {
    Dummies d{attached_[body]->at_start(), {}};
    for (std::size_t k = parts_[body].first; k < end_of(body); ++k) d.volumes.push_back(double(place_[k].volume));
    return d;
}

void Walls::find_neighbours(const Passes& passes, const PencilGrid& grid, const FixedPoint& fixed_point,
                            std::vector<Cluster>& clusters, const std::vector<Source>& sources, const Reaches& reaches,
                            const std::function<bool(int pencil)>& own) {
    std::vector<Source> dummies;
    for (const Part& part : parts_)
        dummies.push_back({&grid, place_.data() + part.first, &part.start, static_cast<std::int32_t>(part.first)});
    lists_.build(passes, fixed_point, sources.front(), clusters, dummies, reaches, &Cluster::wall_list);
    for (Part& part : parts_) {
        const Source own_places{&grid, place_.data() + part.first, &part.start, 0};
        if (own)
            make_clusters(own_places, passes.lanes, part.near_water, own);
        else
            part.near_water = part.clusters;
        part.water.build(passes, fixed_point, own_places, part.near_water, sources, reaches);
        std::erase_if(part.near_water, [](const Cluster& g) { return g.list.size == 0; });
    }
    std::fill(p_.begin(), p_.end(), 0.0f);
    cluster_loads_.resize(static_cast<std::size_t>(number_wall_loads(clusters, lists_.view(), body_end_)));
}

void Walls::set_halo(const Comm& ranks, const Decomposition& pencils) {
    std::vector<Halo::Sorted> dummies;
    for (const Part& part : parts_) dummies.push_back({&part.start, static_cast<std::int32_t>(part.first)});
    halo_ = Halo(ranks, pencils, dummies);
}

void Walls::prune(const Passes& passes, const PackedPlace* particles, const std::vector<Cluster>& clusters,
                  double reach) {
    if (empty()) return;
    PruneData d;
    d.reach = reach;
    d.place = particles;
    for (const Part& part : parts_) {
        d.lists = part.water.view();
        d.of = place_.data() + part.first;
        for_pairs(passes, d, part.near_water);
    }
    d.of = particles;
    d.place = place_.data();
    d.lists = lists_.view();
    d.list = &Cluster::wall_list;
    for_pairs(passes, d, clusters);
}

Walls::Nearest Walls::nearest(const Vec3& x, const Vec3& u, double reach) const {
    Nearest r{no_wall};
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const Body& body = *bodies_[b];
        const SurfaceQuery::Nearest found = body.query().nearest(body.at_start(x), reach);
        if (found.triangle < 0 || found.distance >= r.normal.distance) continue;
        const Vec3 relative = body.fixed() ? u : Vec3(u - velocity_at(b, x, found.triangle));
        Vec3 n = body.turned(slip_normal(body.query(), found, body.turned_back(relative)));
        // the rounding of a normal would be enough: water pressed in a plane buckles out of it
        if (two_dimensional_) n = Vec3(n.x(), 0, n.z()).normalized();
        const std::optional<double> passes =
            body.is_deformable() ? std::nullopt  // of these the forces on dummies know none
            : found.on_face() ? time_to_edge(body.query(), found, body.at_start(x), body.turned_back(relative), reach)
                              : 0;
        const Eigen::Vector3f way = passes ? relative.cast<float>().eval() : Eigen::Vector3f::Zero().eval();
        r = {{static_cast<float>(n.x()), static_cast<float>(n.y()), static_cast<float>(n.z()),
              static_cast<float>(found.distance)},
             {way.x(), way.y(), way.z(), static_cast<float>(passes.value_or(0))},
             b,
             found.triangle};
    }
    return r;
}

std::size_t Walls::bytes() const {
    const auto of = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
    std::size_t sum = of(place_) + of(p_) + of(velocity_) + of(acceleration_) + of(cluster_loads_) + lists_.bytes();
    for (const auto& points : attached_) sum += points->bytes();
    for (const Part& part : parts_)
        sum += of(part.start) + of(part.clusters) + of(part.near_water) + part.water.bytes();
    return sum;
}

}  // namespace tw
