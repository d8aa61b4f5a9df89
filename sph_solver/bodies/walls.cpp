#include "sph_solver/bodies/walls.h"

#include <algorithm>

#include "sph_solver/backend/for_particles.h"
#include "sph_solver/bodies/dummies.h"
#include "sph_solver/bodies/elastic/elastic_body.h"
#include "sph_solver/bodies/slip_normal.h"

namespace tw {

Walls::Walls(const std::vector<Body>& bodies, const Surroundings& around, const LevelSetup& level,
             double kernel_support, const ColumnGrid& grid, const Quanta& quanta, int lanes)
    : bodies_(bodies), two_dimensional_(around.dimensions == 2), loads_(bodies.size()) {
    Box region = around.domain;
    region.min.array() -= kernel_support;
    region.max.array() += kernel_support;
    std::vector<Vec3> places;
    for (const Body& body : bodies) {
        Box wanted = region;
        for (int a = 0; a < 3; ++a) {
            if (body.stays_along(a)) continue;  // else it may come in from outside
            wanted.min[a] = body.surface().bounds().min[a] - level.dp;
            wanted.max[a] = body.surface().bounds().max[a] + level.dp;
        }
        const Coupling coupling = body.elastic() ? body.elastic()->setup().coupling : Coupling{};
        Dummies d = coupling.kind == Coupling::Kind::background
                        ? body.elastic()->wet_nodes(level.dp)
                        : make_dummies(body.query(), body.surface().bounds(), level.dp, kernel_support + level.dp,
                                       wanted, around.dimensions);
        if (coupling.kind == Coupling::Kind::penalty) {  // the kernel sees no body; where it is near is found by them
            std::ranges::fill(d.volumes, 0.0);
            penalised_ = true;
        }
        Part& part = parts_.emplace_back();
        part.first = place_.size();
        std::vector<WidePlace> raw(d.places.size());
        for (std::size_t k = 0; k < raw.size(); ++k) raw[k] = quanta.wide(d.places[k]);
        std::vector<std::int32_t> order;
        sort_by_column(grid, raw, order, part.start);
        for (const std::int32_t n : order) {
            const auto k = static_cast<std::size_t>(n);
            place_.push_back(raw[k].record(static_cast<float>(d.volumes[k])));
            places.push_back(d.places[k]);
        }
        body_end_.push_back(static_cast<std::int32_t>(place_.size()));
        make_groups({&grid, place_.data() + part.first, &part.start, 0}, lanes, part.groups);
    }
    p_.assign(place_.size(), 0);
    if (!std::ranges::all_of(bodies_, [](const Body& body) { return body.sliding().isZero(0); }))
        for (std::size_t b = 0; b < bodies_.size(); ++b) {
            const Eigen::Vector3f along = bodies_[b].sliding().cast<float>();
            sliding_.resize(static_cast<std::size_t>(body_end_[b]), {along.x(), along.y(), along.z(), 0});
        }
    const bool fixed = std::ranges::all_of(bodies_, [](const Body& body) { return body.fixed(); });
    if (fixed && !around.frame) return;
    at_start_ = std::move(places);
    acceleration_.resize(place_.size());
    if (fixed) return;
    velocity_.resize(place_.size());
    motions_.resize(bodies_.size());
    for (std::size_t b = 0; b < bodies_.size(); ++b) reach_.push_back(reach_of(b));
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        if (!bodies_[b].elastic()) continue;
        ties_.resize(place_.size());
        for (std::size_t k = parts_[b].first; k < static_cast<std::size_t>(body_end_[b]); ++k)
            ties_[k] = bodies_[b].elastic()->tie(at_start_[k]);
    }
    follow(quanta);
}

double Walls::reach_of(std::size_t body) const {
    if (bodies_[body].fixed() || bodies_[body].elastic()) return 0;
    double reach = 0;
    for (std::size_t k = parts_[body].first; k < static_cast<std::size_t>(body_end_[body]); ++k)
        reach = std::max(reach, (at_start_[k] - bodies_[body].rigid().mass().centre).norm());
    return reach;
}

double Walls::fastest() const {
    double most = 0;
    for (std::size_t b = 0; b < motions_.size(); ++b)
        most = std::max(most, bodies_[b].elastic()
                                  ? bodies_[b].elastic()->fastest()
                                  : motions_[b].velocity.norm() + motions_[b].rotation.norm() * reach_[b]);
    return most;
}

void Walls::note_motions() {
    for (std::size_t b = 0; b < motions_.size(); ++b) motions_[b] = bodies_[b].motion();
}

Vec3 Walls::place_of(std::size_t body, std::size_t dummy) const {
    return bodies_[body].elastic() ? bodies_[body].elastic()->place(ties_[dummy]) : bodies_[body].now(at_start_[dummy]);
}

Vec3 Walls::velocity_at(std::size_t body, const Vec3& x, std::int32_t triangle) const {
    if (const ElasticBody* elastic = bodies_[body].elastic())
        return triangle < 0 ? Vec3(Vec3::Zero()) : elastic->velocity_on(triangle, x);
    return motions_[body].velocity_at(x);
}

void Walls::push(ElasticBody& elastic, std::size_t body, const std::vector<Vec3>& forces) const {
    for (std::size_t k = 0; k < forces.size(); ++k)
        if (!forces[k].isZero(0)) elastic.push(ties_[parts_[body].first + k], forces[k]);
}

void Walls::follow(const Quanta& quanta) {
    if (!move()) return;
    note_motions();
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        if (bodies_[b].fixed()) continue;
        const ElasticBody* const elastic = bodies_[b].elastic();
        for (std::size_t k = parts_[b].first; k < static_cast<std::size_t>(body_end_[b]); ++k) {
            const Vec3 x = place_of(b, k);
            const Eigen::Vector3f
                u = (elastic ? elastic->velocity(ties_[k]) : motions_[b].velocity_at(x)).cast<float>(),
                a = (elastic ? elastic->acceleration(ties_[k]) : motions_[b].acceleration_at(x)).cast<float>();
            place_[k] = quanta.wide(x).record(place_[k].volume);
            velocity_[k] = {u.x(), u.y(), u.z()};
            acceleration_[k] = {a.x(), a.y(), a.z()};
        }
    }
}

void Walls::feel(const FrameForce& f, const Vec3& gravity) {
    for (std::size_t k = 0; k < at_start_.size(); ++k) {
        const Eigen::Vector3f a = (gravity - f.at(at_start_[k], Vec3::Zero())).cast<float>();
        acceleration_[k] = {a.x(), a.y(), a.z()};
    }
}

void Walls::sort(const ColumnGrid& grid, const Quanta& quanta, int lanes) {
    if (!move()) return;
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        if (bodies_[b].fixed()) continue;
        Part& part = parts_[b];
        const auto end = static_cast<std::size_t>(body_end_[b]);
        std::vector<WidePlace> raw;
        for (std::size_t k = part.first; k < end; ++k) raw.push_back(quanta.wide(place_of(b, k)));
        std::vector<std::int32_t> order;
        sort_by_column(grid, raw, order, part.start);
        const std::vector<PlaceRecord> place(place_.begin() + static_cast<std::ptrdiff_t>(part.first),
                                             place_.begin() + static_cast<std::ptrdiff_t>(end));
        const std::vector<Vec3> at_start(at_start_.begin() + static_cast<std::ptrdiff_t>(part.first),
                                         at_start_.begin() + static_cast<std::ptrdiff_t>(end));
        std::vector<Tie> ties;
        if (bodies_[b].elastic())
            ties.assign(ties_.begin() + static_cast<std::ptrdiff_t>(part.first),
                        ties_.begin() + static_cast<std::ptrdiff_t>(end));
        for (std::size_t k = 0; k < order.size(); ++k) {
            const auto from = static_cast<std::size_t>(order[k]);
            place_[part.first + k] = raw[from].record(place[from].volume);
            at_start_[part.first + k] = at_start[from];
            if (bodies_[b].elastic()) ties_[part.first + k] = ties[from];
        }
        make_groups({&grid, place_.data() + part.first, &part.start, 0}, lanes, part.groups);
    }
    follow(quanta);
}

WaterShell Walls::shell(std::size_t body, double rho0) const {
    WaterShell shell;
    for (std::size_t k = parts_[body].first; k < static_cast<std::size_t>(body_end_[body]); ++k) {
        const double m = rho0 * double(place_[k].volume);
        const Vec3 r = at_start_[k] - bodies_[body].rigid().mass().centre;
        shell.mass += m;
        shell.inertia += m * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
    }
    return shell;
}

void Walls::find_neighbours(const Passes& passes, const ColumnGrid& grid, const Quanta& quanta,
                            std::vector<Group>& groups, const std::vector<Source>& sources, const Reaches& reaches) {
    std::vector<Source> dummies;
    for (const Part& part : parts_)
        dummies.push_back({&grid, place_.data() + part.first, &part.start, static_cast<std::int32_t>(part.first)});
    lists_.build(passes, quanta, sources.front(), groups, dummies, reaches, &Group::wall_list);
    for (Part& part : parts_) {
        part.near_water = part.groups;
        part.water.build(passes, quanta, {&grid, place_.data() + part.first, &part.start, 0}, part.near_water, sources,
                         reaches);
        std::erase_if(part.near_water, [](const Group& g) { return g.list.size == 0; });
    }
    std::fill(p_.begin(), p_.end(), 0.0f);
    group_loads_.resize(static_cast<std::size_t>(number_wall_loads(groups, lists_.view(), body_end_)));
}

void Walls::prune(const Passes& passes, const PlaceRecord* particles, const std::vector<Group>& groups, double reach) {
    if (empty()) return;
    PruneData d;
    d.reach = reach;
    d.place = particles;
    for (const Part& part : parts_) {
        d.lists = part.water.view();
        d.of = place_.data() + part.first;
        for_pairs(passes.prune, d, part.near_water);
    }
    d.of = particles;
    d.place = place_.data();
    d.lists = lists_.view();
    d.list = &Group::wall_list;
    for_pairs(passes.prune, d, groups);
}

Walls::Nearest Walls::nearest(const Vec3& x, const Vec3& u, double reach) const {
    Nearest r{no_wall};
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const Body& body = bodies_[b];
        const SurfaceQuery::Nearest found = body.query().nearest(body.at_start(x), reach);
        if (found.triangle < 0 || found.distance >= r.normal.distance) continue;
        const Vec3 relative = body.fixed() ? u : Vec3(u - velocity_at(b, x, found.triangle));
        Vec3 n = body.turned(slip_normal(body.query(), found, body.turned_back(relative)));
        // the rounding of a normal would be enough: water pressed in a plane buckles out of it
        if (two_dimensional_) n = Vec3(n.x(), 0, n.z()).normalized();
        const bool no_edge = found.on_face() || body.elastic();  // of these the forces on dummies know none
        const Eigen::Vector3f e =
            no_edge ? Eigen::Vector3f::Zero().eval() : relative.stableNormalized().cast<float>().eval();
        r = {{static_cast<float>(n.x()), static_cast<float>(n.y()), static_cast<float>(n.z()),
              static_cast<float>(found.distance)},
             {e.x(), e.y(), e.z(), no_edge ? 0 : static_cast<float>(relative.squaredNorm())},
             b,
             found.triangle};
    }
    return r;
}

std::size_t Walls::bytes() const {
    const auto of = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
    std::size_t sum = of(place_) + of(p_) + of(velocity_) + of(acceleration_) + of(at_start_) + of(ties_) +
                      of(group_loads_) + lists_.bytes();
    for (const Part& part : parts_) sum += of(part.start) + of(part.groups) + of(part.near_water) + part.water.bytes();
    return sum;
}

}  // namespace tw
