#include "sph_solver/bodies/elastic/elastic_body.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tw {
namespace {
using Eigen::VectorXd;

V3<double> plain(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
Vec3 vector_of(const V3<double>& v) { return {v.x, v.y, v.z}; }

/// Points of an elastic body, tied to its nodes.
class ElasticPoints : public Attached {
public:
    ElasticPoints(const ElasticBody& body, const std::vector<Vec3>& at_start) : Attached({}), body_(body) {
        ties_.reserve(at_start.size());
        for (const Vec3& x : at_start) ties_.push_back(body.tie(x));
    }
    std::size_t size() const override { return ties_.size(); }
    Vec3 place(std::size_t k) const override { return body_.place(ties_[k]); }
    Motion motion(std::size_t k, const Vec3&) const override {
        return {body_.velocity(ties_[k]), body_.acceleration(ties_[k])};
    }
    Vec3 surface_velocity(const Vec3& x, std::int32_t triangle) const override {
        return body_.velocity_on(triangle, x);
    }
    WettedSurface wetted_surface() const override { return body_.wetted_surface(); }
    double fastest() const override { return body_.fastest(); }
    void reorder(const std::vector<std::int32_t>& order) override { ties_ = reordered(ties_, order); }
    std::size_t bytes() const override { return ties_.capacity() * sizeof(Tie); }
    const Tie& tie(std::size_t k) const { return ties_[k]; }

private:
    const ElasticBody& body_;
    std::vector<Tie> ties_;
};

}  // namespace

ElasticBody::ElasticBody(BodySetup setup)
    : Body(setup),
      setup_(std::move(setup.elastic)),
      structure_(structure_in_time(*setup_)),
      wetted_(structure_->wetted_surface()) {
    for (const DeflectionPoint& point : setup_->points) points_.push_back(tie(point.position));
    for (const Vec3& p : wetted_.points) surface_ties_.push_back(tie(p));
    for (const auto& [a, b, c] : wetted_.triangles) corners_.push_back({a, b, c});
    note_nodes(0);
    const int all = setup_->dofs.all();
    relaxation_.assign(nodes_.size(), 1.0);
    accelerations_ = VectorXd::Zero(static_cast<Eigen::Index>(3 * nodes_.size()));
    last_acceleration_ = VectorXd::Zero(all);
    force_ = impulses_ = DofSums(all);
    u_ = structure_->displacement();
    v_ = structure_->velocity();
    note_surface();
}

Tie ElasticBody::tie(const Vec3& at_start) const { return structure_->tie(at_start); }

Vec3 ElasticBody::place(const Tie& tie) const {
    Vec3 x = Vec3::Zero();
    for (std::size_t i = 0; i < 4; ++i) {
        const StructureInTime::Node& n = nodes_[static_cast<std::size_t>(tie.nodes[i])];
        x += tie.shares[i] * (n.x + n.R * tie.arm);
    }
    return x;
}

Vec3 ElasticBody::velocity(const Tie& tie) const {
    Vec3 v = Vec3::Zero();
    for (std::size_t i = 0; i < 4; ++i) v += tie.shares[i] * nodes_[static_cast<std::size_t>(tie.nodes[i])].v;
    return v;
}

Vec3 ElasticBody::acceleration(const Tie& tie) const {
    Vec3 a = Vec3::Zero();
    for (std::size_t i = 0; i < 4; ++i) a += tie.shares[i] * accelerations_.segment<3>(3 * tie.nodes[i]);
    return a;
}

/// The nodes a time `ahead` from where the structure stands [s].
void ElasticBody::note_nodes(double ahead) {
    structure_->place(ahead, nodes_);
    surface_at_.resize(wetted_.points.size());
    surface_velocity_.resize(wetted_.points.size());
    for (std::size_t k = 0; k < surface_ties_.size(); ++k) {
        surface_at_[k] = place(surface_ties_[k]);
        surface_velocity_[k] = plain(velocity(surface_ties_[k]));
    }
    moved_since_noted_ = true;
}

Dummies ElasticBody::dummies(const DummyLattice& lattice) const {
    return setup_->coupling.interface->dummies(*this, lattice);
}

std::unique_ptr<Attached> ElasticBody::attach(std::vector<Vec3> at_start) const {
    return std::make_unique<ElasticPoints>(*this, at_start);
}

// --- the closed surface ---------------------------------------------------------------------------------------------

Surface ElasticBody::surface_now(std::optional<double>) const { return {surface_at_, wetted_.triangles}; }

void ElasticBody::note_surface() {
    noted_.clear();
    for (const Vec3& x : surface_at_) noted_.push_back(plain(x));
    ++times_noted_;
    noted_query_ = std::make_unique<SurfaceQuery>(surface_now());
    moved_since_noted_ = false;
}

/// Shares of a triangle's corners, as noted, in the place of it that is nearest to `x` but for its edges.
Vec3 ElasticBody::barycentric(int triangle, const Vec3& x) const {
    return vector_of(surface_motion().shares(triangle, plain(x)));
}

Vec3 ElasticBody::at_start(const Vec3& x) const {
    if (!moved_since_noted_) return x;
    const SurfaceQuery::Nearest near = noted_query_->nearest(x);
    const Vec3 shares = barycentric(near.triangle, near.point);
    Vec3 back = x;
    for (int k = 0; k < 3; ++k) {
        const auto corner = static_cast<std::size_t>(
            wetted_.triangles[static_cast<std::size_t>(near.triangle)][static_cast<std::size_t>(k)]);
        back -= shares[k] * (surface_at_[corner] - vector_of(noted_[corner]));
    }
    return back;
}

Vec3 ElasticBody::velocity_on(int triangle, const Vec3& x) const {
    return vector_of(surface_motion().at(triangle, plain(x)));
}

double ElasticBody::fastest() const {
    double most = 0;
    for (const V3<double>& v : surface_velocity_) most = std::max(most, dot(v, v));
    return std::sqrt(most);
}

// --- time -----------------------------------------------------------------------------------------------------------

void ElasticBody::meet(const WaterNear& water, const Dummies&) {
    water_ = water;
    const std::vector<double>& areas = structure_->wet_areas();
    const VectorXd& mass = structure_->mass();
    const int per_node = setup_->dofs.per_node();
    std::vector<double> ratio(nodes_.size());
    for (std::size_t k = 0; k < nodes_.size(); ++k)
        ratio[k] = water.density * water.spacing * areas[k] / mass[static_cast<Eigen::Index>(k) * per_node];
    for (const structure::RigidPart& part : setup_->dofs.parts()) {
        double area = 0, carried = part.mass;
        for (const int n : part.nodes) {
            area += areas[static_cast<std::size_t>(n)];
            carried += mass[per_node * n];
        }
        for (const int n : part.nodes)
            ratio[static_cast<std::size_t>(n)] = water.density * water.spacing * area / carried;
    }
    lightest_ = *std::ranges::max_element(ratio);
    for (std::size_t k = 0; k < nodes_.size(); ++k) relaxation_[k] = setup_->coupling.relaxed ? 1 / (1 + ratio[k]) : 1;
    interface_step_ = setup_->coupling.interface->stable_step(water.density, water.spacing, lightest_);
}

double ElasticBody::stable_step() const {
    const double of_water = std::min(2 * water_.spacing / (water_.sound_speed * std::sqrt(lightest_)), interface_step_);
    return setup_->largest_step > 0 ? std::min(of_water, setup_->largest_step) : of_water;
}

void ElasticBody::look_ahead(double drift) {
    if (drift != 0) note_nodes(drift);
}

void ElasticBody::take(const Attached& dummies, const std::vector<Vec3>& forces) {
    const auto& points = dynamic_cast<const ElasticPoints&>(dummies);
    for (std::size_t k = 0; k < forces.size(); ++k)
        if (!forces[k].isZero(0)) push(points.tie(k), forces[k]);
}

void ElasticBody::push(const Tie& tie, const Vec3& force) {
    const Vec3 whole = width() * force;
    power_ += whole.dot(velocity(tie));
    for (std::size_t i = 0; i < 4; ++i) force_.add(setup_->dofs.per_node() * tie.nodes[i], tie.shares[i] * whole);
}

void ElasticBody::take(const WallPush& by) {
    const Vec3 shares = barycentric(by.triangle, at_start(by.place));
    const auto& corners = wetted_.triangles[static_cast<std::size_t>(by.triangle)];
    for (int k = 0; k < 3; ++k)
        push(surface_ties_[static_cast<std::size_t>(corners[static_cast<std::size_t>(k)])], shares[k] * by.force);
}

void ElasticBody::take_impulse(const WallImpulse& by) {
    const Vec3 shares = barycentric(by.triangle, at_start(by.place));
    const auto& corners = wetted_.triangles[static_cast<std::size_t>(by.triangle)];
    for (int k = 0; k < 3; ++k) {
        const Tie& tie = surface_ties_[static_cast<std::size_t>(corners[static_cast<std::size_t>(k)])];
        for (std::size_t i = 0; i < 4; ++i)
            impulses_.add(setup_->dofs.per_node() * tie.nodes[i], width() * shares[k] * tie.shares[i] * by.impulse);
    }
}

void ElasticBody::relax(const VectorXd& acceleration) {
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
        auto relaxed = accelerations_.segment<3>(static_cast<Eigen::Index>(3 * k));
        relaxed += relaxation_[k] * (acceleration.segment<3>(first_of(k)) - relaxed);
    }
}

/// By mass, on the nodes where they are shown to the water and on rigid parts a time `ahead` from where they stand; on
/// what turns with a shell's nodes or a rigid part too.
void ElasticBody::add_weight(VectorXd& load, double ahead) const {
    const structure::DegreesOfFreedom& dofs = setup_->dofs;
    const VectorXd& mass = structure_->mass();
    FrameForce f;
    f.at_pivot = water_.gravity;
    if (water_.frame) f = water_.frame->force(time_ + ahead, water_.gravity);
    const bool turns = water_.frame && water_.frame->law.turns && dofs.per_node() == 6;
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
        const Eigen::Index first = first_of(k);
        load.segment<3>(first) += mass[first] * f.at(nodes_[k].x, nodes_[k].v);
        if (turns)
            load.segment<3>(first + 3) +=
                moment_on(mass.segment<3>(first + 3).asDiagonal(), v_.segment<3>(first + 3), f);
    }
    for (std::size_t p = 0; p < dofs.parts().size(); ++p) {
        const structure::RigidPart& part = dofs.parts()[p];
        const int first = dofs.first_of_part(static_cast<int>(p));
        const Vec3 u = u_.segment<3>(first), v = v_.segment<3>(first);
        load.segment<3>(first) += part.mass * f.at(part.centre + u + ahead * v, v);
        if (turns) load.segment<3>(first + 3) += moment_on(part.inertia, v_.segment<3>(first + 3), f);
    }
}

VectorXd ElasticBody::load_of(const VectorXd& water, const BodyStep& step) const {
    VectorXd load = water;
    add_weight(load, step.drifted);
    if (setup_->damping > 0) load -= setup_->damping * (setup_->dofs.mass(structure_->mass()) * v_);
    return load;
}

void ElasticBody::sub_iterate(const BodyStep& step) {
    const std::vector<double> now = structure_->state();
    structure_->step(step.kick, step.drift, load_of(force_.value() + impulses_.value() / step.kick, step));
    relax((structure_->velocity() - v_) / step.kick);
    structure_->restore(now);
    force_ = DofSums(v_.size());
    power_ = {};
}

void ElasticBody::move(const BodyStep& step) {
    const double dt = step.kick, felt = 2 * step.drifted;
    const VectorXd force = force_.value(), impulses = impulses_.value(), water = force + impulses / dt;
    const VectorXd before = v_;
    const VectorXd change = structure_->step(dt, step.drift, load_of(water, step));
    time_ += step.drifted + step.drift;
    u_ = structure_->displacement();
    v_ = structure_->velocity();
    const double taken = water.dot(change);
    const double given = felt / 2 * (power_before_ + power_.value()) + impulses.dot(before);
    work_taken_ += taken;
    work_exchanged_ += std::abs(taken);
    work_given_ += given;
    constexpr double kept = 15. / 16;
    made_lately_ = kept * made_lately_ + taken - given;
    exchanged_lately_ = kept * exchanged_lately_ + std::abs(taken);
    power_before_ = force.dot(v_);
    for (std::size_t k = 0; k < nodes_.size(); ++k) impulse_ += dt * water.segment<3>(first_of(k));
    last_acceleration_ = (v_ - before) / dt;
    relax(last_acceleration_);
    force_ = impulses_ = DofSums(v_.size());
    power_ = {};
    note_nodes(0);
}

std::optional<double> ElasticBody::energy_made_lately() const {
    const double exchanged = std::max(exchanged_lately_, 0.01 * work_exchanged_);
    return exchanged > 0 ? std::abs(made_lately_) / exchanged : 0;
}

bool ElasticBody::meets_wall(const Vec3& normal) const {
    const auto* solid = std::get_if<ElasticSolid>(&setup_->structure);
    return solid && solid->floor && normal == Vec3::UnitZ();
}

// --- what is recorded -----------------------------------------------------------------------------------------------

Vec3 ElasticBody::deflection(std::size_t point) const { return place(points_[point]) - setup_->points[point].position; }

double ElasticBody::strain(std::size_t gauge) const { return structure_->strain(gauge); }

ElasticBody::PartMotion ElasticBody::part(std::size_t part) const {
    const int first = setup_->dofs.first_of_part(static_cast<int>(part));
    return {u_.segment<3>(first), v_.segment<3>(first), last_acceleration_.segment<3>(first)};
}

void ElasticBody::describe(const Load& load, const Note& note) const {
    const auto put = [&](const std::string& before, const std::string& unit, const Vec3& v) {
        for (int a = 0; a < 3; ++a) note(before + "xyz"[a], unit, v[a] + 0.0);
    };
    if (!setup_->dofs.parts().empty()) {
        const PartMotion frame = part(0);
        put("", "m", setup_->dofs.parts()[0].centre + frame.displacement);
        put("v", "m/s", frame.velocity);
        put("a", "m/s2", frame.acceleration);
    }
    double lowest = HUGE_VAL;
    for (const Vec3& p : surface_at_) lowest = std::min(lowest, p.z());
    note("lowest", "m", lowest);
    put("f", "N", load.force);
    if (meets_wall(Vec3::UnitZ())) note("floor_force", "N", floor_force() / width());
    for (std::size_t n = 0; n < points_.size(); ++n) put(setup_->points[n].name + "_", "m", deflection(n));
    for (std::size_t n = 0; n < setup_->gauges.size(); ++n) note(setup_->gauges[n].name, "-", strain(n));
    for (const auto& [name, value] : {std::pair{"kinetic_energy", kinetic_energy()},
                                      {"elastic_energy", elastic_energy()},
                                      {"work_taken", work_taken()},
                                      {"work_given", work_given()},
                                      {"work_exchanged", work_exchanged()}})
        note(name, "J", value / width());
}

std::vector<double> ElasticBody::state() const {
    std::vector<double> all;
    const VectorXd impulses = impulses_.value();
    for (const VectorXd* part : {&accelerations_, &last_acceleration_, &impulses})
        all.insert(all.end(), part->begin(), part->end());
    all.insert(all.end(), {power_before_, work_taken_, work_given_, work_exchanged_, impulse_.x(), impulse_.y(),
                           impulse_.z(), made_lately_, exchanged_lately_, time_});
    const std::vector<double> own = structure_->state();
    all.insert(all.end(), own.begin(), own.end());
    return all;
}

void ElasticBody::restore(std::span<const double> state) {
    std::size_t at = 0;
    const auto next = [&](std::size_t size) {
        if (at + size > state.size()) throw std::invalid_argument("too few numbers");
        at += size;
        return state.subspan(at - size, size);
    };
    VectorXd impulses(v_.size());
    for (VectorXd* part : {&accelerations_, &last_acceleration_, &impulses})
        std::ranges::copy(next(static_cast<std::size_t>(part->size())), part->begin());
    impulses_ = DofSums(impulses);
    const auto sums = next(10);
    power_before_ = sums[0], work_taken_ = sums[1], work_given_ = sums[2], work_exchanged_ = sums[3];
    impulse_ = Vec3(sums[4], sums[5], sums[6]);
    made_lately_ = sums[7], exchanged_lately_ = sums[8], time_ = sums[9];
    structure_->restore(state.subspan(at));
    u_ = structure_->displacement();
    v_ = structure_->velocity();
    note_nodes(0);
    note_surface();
}

}  // namespace tw
