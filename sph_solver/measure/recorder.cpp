#include "sph_solver/measure/recorder.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/numbers.h"
#include "meshes/mass_properties.h"
#include "record/body_work.h"
#include "record/hull_motion.h"
#include "record/recorded_checks.h"
#include "record/spray_table.h"
#include "record/tank_table.h"
#include "record/wet_wall.h"
#include "scene/solids/friction_line.h"
#include "scene/solids/hull_motion.h"
#include "sph_solver/air.h"
#include "sph_solver/bodies/rigid_in_water.h"
#include "sph_solver/equations/half_space.h"
#include "sph_solver/measure/level_ledger.h"
#include "sph_solver/measure/packing.h"
#include "sph_solver/measure/validity_checks.h"
#include "sph_solver/measure/water_energy.h"
#include "sph_solver/measure/water_raster.h"
#include "sph_solver/measure/water_volumes.h"

namespace tw {

namespace {

constexpr std::int64_t surface_every = 10;  ///< steps between samples of surface pressure and control volume faces

/// Between samples of the pressure probes [s]: a tenth of the 5 ms over which their peaks are means (compare/metrics/
/// probes.cpp).
constexpr double pressure_interval = 5e-4;

/// Whether a multiple of `interval` lies after the table's last row, up to `time`: known from the table alone, so a
/// resumed run samples at the same steps.
bool is_due(const Table& table, double time, double interval) {
    return table.time.empty() || std::floor(time / interval) > std::floor(table.time.back() / interval);
}

/// A solid's surface in patches of about a spacing, not too many.
SurfaceSamples samples_of(const Body& body, const SimulationSetup& s) {
    constexpr double most = 20000;
    if (s.dimensions == 2 && !body.fixed()) return SurfaceSamples::of_section(body.surface(), s.dp);
    if (s.dimensions == 2) {
        Box region = s.domain;
        region.min.y() = -HUGE_VAL, region.max.y() = HUGE_VAL;
        return SurfaceSamples::of_section(body.surface(), s.dp, region);
    }
    const double size = std::max(s.dp, std::sqrt(mass_properties(body.surface()).area / most));
    return {body.surface(), size, body.fixed() ? s.domain : body.surface().bounds()};
}

/// Of the water in the control volume [N s], [kg].
Vec3 momentum_inside(const Simulation& simulation, double& mass_inside) {
    using Inside = ControlVolume::Inside;
    const Level& level = simulation.at_bodies();
    const Inside inside = level.fields().sum_over_all<Inside>([&](Inside& sum, std::size_t i) {
        simulation.control_volume()->add_inside(level.fields().particles(), i, sum);
    });
    mass_inside = level.system().mass * inside.share.value();
    return level.system().mass * inside.momentum.value();
}

/// Whether the particles of the control volume's size still hold all of it: their zone may have gone with a free hull.
bool holds_control_volume(Simulation& simulation) {
    if (!simulation.setup().zones_round) return true;
    const Zone& zone = simulation.refinements().back().zone();
    return std::ranges::all_of(simulation.control_volume()->faces().places,
                               [&](const Vec3& x) { return zone.outside(x) < 0; });
}

/// What the water has done on a body up to a row of its table [J]: a step's load kicks it from the velocity of the row
/// before to that of its own.
double work_up_to(const Table& t, std::size_t row) {
    if (row == 0) return 0;
    const auto column = [&](const char* name) -> const std::vector<double>& { return t.find(name)->values; };
    double power = 0;
    for (const auto& [load, rate] :
         {std::pair{"fx", "vx"}, {"fy", "vy"}, {"fz", "vz"}, {"mx", "spin_x"}, {"my", "spin_y"}, {"mz", "spin_z"}})
        power += column(load)[row] * (column(rate)[row - 1] + column(rate)[row]) / 2;
    return column(body_work)[row - 1] + (t.time[row] - t.time[row - 1]) * power;
}

}  // namespace

Recorder::Recorder(const Scene& scene, const Simulation& simulation, RunRecord record)
    : scene_(scene),
      record_(std::move(record)),
      factor_(scene.symmetry_factor()),
      height_probes_(scene, simulation.setup()) {
    const SimulationSetup& s = simulation.setup();
    if (scene.hull) {
        Box region = scene.hull->surface.bounds();
        region.min.array() -= s.dp;
        region.max.array() += s.dp;
        if (scene.hull->half) region.min.y() = 0;
        hull_at_start_ = s.dimensions == 2 ? SurfaceSamples::of_section(scene.hull->surface, s.dp)
                                           : SurfaceSamples(scene.hull->surface, s.dp, region);
        hull_ = hull_at_start_;
    }
    for (std::size_t b = 0; b < simulation.bodies().size(); ++b)
        if (const Body& body = simulation.body(b); !body.is_hull() && !body.is_deformable())
            solids_.push_back({b, samples_of(body, s)});
    for (const PressureProbe& p : scene.sampling.pressure) pressure_points_.places.push_back(p.place);
    if (scene.tank_motion) tank_.emplace().begin(simulation);
}

void Recorder::after_step(Simulation& simulation, bool frame) {
    if (!simulation.refinements().empty()) {
        sizes_ = level_ledgers(simulation);
        zone_mass_.add(sizes_);
    }
    const std::size_t row = forces().append(simulation.time());
    if (!simulation.setup().bodies.empty()) {
        const std::optional<std::size_t> hull = simulation.hull_index();
        const Load load = hull ? simulation.load(*hull) : simulation.load();
        Table& t = forces();
        const Vec3 whole(factor_, factor_ == 2 ? 0 : 1, factor_);  // a half model's sideways forces cancel
        const auto put = [&](const char* part, const Vec3& f) {
            const Vec3 force = f.cwiseProduct(whole);
            for (int a = 0; a < 3; ++a) t.set(row, fmt::format("f{}{}", "xyz"[a], part), per_span("N"), force[a] + 0.0);
        };
        put("", load.force);
        put("_pressure", load.force - load.friction);
        put("_viscous", load.friction);
        t.set(row, "my", per_span("N m"), factor_ * load.moment.y());
        if (const Level* gas = simulation.gas()) {
            const std::vector<Load>& on_bodies = gas->system().walls.loads();
            Load by_air;
            for (std::size_t b = 0; b < on_bodies.size(); ++b)
                if (!hull || b == *hull) by_air += on_bodies[b];
            const Vec3 air = by_air.force.cwiseProduct(whole);
            t.set(row, "fx_air", per_span("N"), air.x());
            t.set(row, "fz_air", per_span("N"), air.z());
        }
    }
    if (tank_) tank_->after_step(simulation);
    record_bodies(simulation);
    if (frame || simulation.steps() % surface_every == 0) sample_surface(simulation, row);
    if (frame) sample_frame(simulation, row);
    if (!pressure_points_.places.empty() &&
        (frame || is_due(record_.table("pressure"), simulation.time(), pressure_interval)))
        probe_pressure(simulation);
    watch_stability(simulation, sizes_, record_);
    if (frame) watch_energy(record_);
}

void Recorder::sample_hull(Simulation& simulation) {
    if (scene_.hull->free) hull_ = hull_at_start_->moved_with(*simulation.hull());
    simulation.sample(hull_->points);
}

void Recorder::sample_surface(Simulation& simulation, std::size_t row) {
    if (hull_) {
        sample_hull(simulation);
        Vec3 moment;
        const Vec3 force = factor_ * hull_->pressure_force(simulation.setup().moment_reference, moment);
        forces().set(row, "fx_surface", per_span("N"), force.x());
        forces().set(row, "fz_surface", per_span("N"), force.z());
    }
    if (ControlVolume* cv = simulation.control_volume()) {
        simulation.sample(cv->faces());
        volume_held_ = volume_held_ && holds_control_volume(simulation);
        double mass_inside = 0;
        momentum_inside(simulation, mass_inside);
        Vec3 body_force = simulation.setup().gravity;
        if (simulation.setup().stream) body_force.x() += simulation.setup().stream->acceleration(simulation.time());
        cv->add_impulse(mass_inside, body_force, simulation.time() - last_face_sample_);
        last_face_sample_ = simulation.time();
    }
}

void Recorder::sample_frame(Simulation& simulation, std::size_t row) {
    const SimulationSetup& s = simulation.setup();
    if (ControlVolume* cv = simulation.control_volume()) {
        double mass_inside = 0;
        const Vec3 momentum = momentum_inside(simulation, mass_inside);
        const ControlVolume::State& sums = cv->state();
        if (momentum_known_ && volume_held_ && sums.since > 0) {
            const Vec3 force = factor_ * (sums.crossed + sums.impulse - (momentum - momentum_)) / sums.since;
            forces().set(row, "fx_volume", per_span("N"), force.x());
            forces().set(row, "fz_volume", per_span("N"), force.z());
        }
        momentum_ = momentum;
        momentum_known_ = true;
        volume_held_ = holds_control_volume(simulation);
        cv->set_state({});
    }

    Table& t = record_.table("samples");
    const std::size_t k = t.append(simulation.time());
    const WaterEnergy energy = water_energy(simulation);
    std::int64_t count = 0;
    const double c0 = s.state_equation.c0;
    double fastest = 0, low = 0, high = 0;
    Ledger ledger;
    for (const auto& level : simulation.water()) {
        count += level->fields().sum_over_all<std::int64_t>(
            [&](std::int64_t& sum, std::size_t i) { sum += is_active(level->fields().particles().kind[i]); });
        const Extremes& e = level->system().extremes;
        fastest = std::max(fastest, e.speed);
        low = std::min(low, e.density_deviation_low), high = std::max(high, e.density_deviation_high);
        const Ledger& l = level->system().ledger;
        ledger.in += l.in, ledger.out += l.out, ledger.lost += l.lost, ledger.held += l.held;
    }
    if (const RasterSpec& raster = scene_.sampling.raster; raster.voxel > 0)
        record_.frames.push_back(water_raster(simulation, raster, scene_.span()).frame(simulation.time()));
    t.set(k, "mass", per_span("kg"), factor_ * energy.mass);
    t.set(k, "kinetic_energy", per_span("J"), factor_ * energy.kinetic);
    t.set(k, "potential_energy", per_span("J"), factor_ * energy.potential);
    t.set(k, "elastic_energy", per_span("J"), factor_ * energy.elastic);
    const double crowded = crowding(simulation);
    t.set(k, "crowding", "-", crowded);
    if (std::isfinite(crowded))
        note_worst(record_, {crowding_line, "%", 100 * std::abs(crowded), 100 * largest_crowding, simulation.time()});
    t.set(k, "dt", "s", simulation.dt());
    t.set(k, "max_speed", "m/s", fastest);
    t.set(k, "max_mach", "-", fastest / c0);
    t.set(k, "density_deviation_low", "kg/m3", low);
    t.set(k, "density_deviation_high", "kg/m3", high);
    t.set(k, "particles", "-", double(count));
    t.set(k, "particles_in", "-", double(ledger.in));
    t.set(k, "particles_out", "-", double(ledger.out));
    t.set(k, "particles_lost", "-", double(ledger.lost));
    t.set(k, "held_at_wall", "-", double(ledger.held));
    if (record_.numbers.contains(spray_gate_number)) {
        double taken = 0;  // before this frame
        for (const double m : record_.table(spray_table).column("mass", "kg").values) taken += m;
        t.set(k, "spray_mass", "kg", factor_ * taken);
    }
    if (const Level* air = simulation.gas()) {
        t.set(k, "air_particles", "-", double(air->fields().count()));
        t.set(k, "air_energy", per_span("J"), factor_ * gas_energy(*air, s.gravity));
        t.set(k, "air_max_speed", "m/s", air->system().extremes.speed);
        t.set(k, "air_density_deviation_low", "kg/m3", air->system().extremes.density_deviation_low);
        t.set(k, "air_density_deviation_high", "kg/m3", air->system().extremes.density_deviation_high);
    }
    if (hull_) {
        const double area = factor_ * hull_->wetted_area(), length = hull_->wetted_length(scene_.hull->beam);
        t.set(k, "wetted_area", per_span("m2"), area);
        t.set(k, "wetted_length", "m", length);
        if (scene_.effect_on("friction"))
            t.set(k, "friction_line", per_span("N"), friction_by_line(scene_, area, length));
    }
    record_walls(simulation, k);
    height_probes_.record(simulation, record_);
    record_volumes(simulation, scene_, record_);
    if (tank_) tank_->record(simulation, record_.table(tank_table), per_span("N"), per_span("J"));
    record_levels(simulation.time());
}

/// Of each body that moves, in a table of its own: where it is, how it moves, and the water's force on it.
void Recorder::record_bodies(const Simulation& simulation) {
    for (std::size_t b = 0; b < simulation.bodies().size(); ++b) {
        const Body& body = simulation.body(b);
        if (body.fixed()) continue;
        if (body.is_hull()) {
            append_hull_motion(record_.table(hull_motion_table), simulation.time(), *scene_.hull,
                               rigid_of(body).state(), rigid_of(body).spin());
            continue;
        }
        Table& t = record_.table(body_table(body.name()));
        const std::size_t k = t.append(simulation.time());
        Load load = simulation.load(b);
        if (const Level* air = simulation.gas()) load += air->system().walls.loads()[b];
        body.describe(load, [&](const std::string& name, const std::string& unit, double value) {
            const bool of_span = unit == "N" || unit == "N m" || unit == "J";
            t.set(k, name, of_span ? per_span(unit.c_str()) : unit, value);
        });
        if (!body.knows_its_work()) t.set(k, body_work, per_span("J"), work_up_to(t, k));
    }
}

/// Of each solid that keeps its shape: how hard its wall pulls at the water, and where water leaves one that moves. In
/// a tank without a hull also the integral of the surface pressure over all of them, which measures what `fx`, `fz`
/// sum.
void Recorder::record_walls(Simulation& simulation, std::size_t row) {
    Table& t = record_.table("samples");
    const double h_over_dp = simulation.finest().system().h / simulation.finest().system().setup.dp;
    const auto put = [&](const SurfaceSamples& samples, const Body& body) {
        WetWall wall;
        for (std::size_t k = 0; k < samples.area.size(); ++k)
            wall.add(samples.area[k], samples.presses(k) ? double(samples.points.p[k]) : 0.0, samples.wet(k),
                     h_over_dp * half_space_distance(double(samples.points.support[k])));
        t.set(row, "suction_area_" + body.name(), per_span("m2"), factor_ * wall.suction_area());
        t.set(row, "suction_force_" + body.name(), per_span("N"), factor_ * wall.suction_force());
        if (!body.fixed() && !body.is_hull())
            t.set(row, "leaving_angle_" + body.name(), "deg", wall.leaving_angle() / degree);
    };
    if (hull_) put(*hull_, *simulation.hull());
    Vec3 on_solids = Vec3::Zero(), moment;
    for (const SampledSolid& solid : solids_) {
        const Body& body = simulation.body(solid.body);
        SurfaceSamples now = body.fixed() ? solid.at_start : solid.at_start.moved_with(body);
        simulation.sample(now.points);
        put(now, body);
        on_solids += now.pressure_force(simulation.setup().moment_reference, moment);
    }
    if (hull_ || solids_.empty() || solids_.size() < simulation.bodies().size()) return;  // bodies that bend have none
    const std::size_t last = forces().time.size() - 1;
    forces().set(last, "fx_surface", per_span("N"), factor_ * on_solids.x());
    forces().set(last, "fz_surface", per_span("N"), factor_ * on_solids.z());
}

/// Of each size of particles, in a table of its own: who is there, and what has passed the edge of its zone.
void Recorder::record_levels(double time) {
    for (std::size_t k = 0; k < sizes_.size(); ++k) {
        const LevelLedger& l = sizes_[k];
        Table& t = record_.table(level_table(k));
        const std::size_t row = t.append(time);
        const auto put = [&](const char* name, double value, const char* unit = "-") { t.set(row, name, unit, value); };
        put("spacing", l.spacing, "m");
        put("dt", l.dt, "s");
        put("active", double(l.active));
        if (k + 1 < sizes_.size()) {
            put("band", double(l.overlap));
            put("carried", double(l.slaves));
        }
        if (k == 0) continue;
        put("guards", double(l.buffers));
        put("births", double(l.edge.splits));
        put("deaths", double(l.edge.merges));
        put("spray", double(l.edge.spray));
        put("orphans", double(l.edge.orphans));
        put("mass_drift", 100 * zone_mass_.take_mean(k), "%");
        check_zone_mass(t, record_);
    }
}

void Recorder::probe_pressure(Simulation& simulation) {
    Table& t = record_.table("pressure");
    const std::size_t k = t.append(simulation.time());
    simulation.sample(pressure_points_);
    for (std::size_t n = 0; n < pressure_points_.places.size(); ++n)
        t.set(k, scene_.sampling.pressure[n].name.c_str(), "Pa",
              pressure_points_.support[n] >= SurfaceSamples::has_pressure || simulation.gas()
                  ? double(pressure_points_.p[n])
                  : 0.0);
}

/// The control volume's sums begin anew at a frame, with what is in it then.
void Recorder::begin_balance(Simulation& simulation) {
    if (tank_) tank_->begin(simulation);
    if (!simulation.control_volume()) return;
    double mass_inside = 0;
    momentum_ = momentum_inside(simulation, mass_inside);
    momentum_known_ = true;
    volume_held_ = holds_control_volume(simulation);
}

void Recorder::take_spray(Simulation& simulation, const SprayGate& gate) {
    const std::vector<SprayLump> lumps = gate.take(simulation);
    if (lumps.empty()) return;
    Table& t = record_.table(spray_table);
    for (const SprayLump& lump : lumps) {
        const std::size_t row = t.append(simulation.time());
        for (int a = 0; a < 3; ++a) {
            t.set(row, fmt::format("{}", "xyz"[a]), "m", lump.place[a]);
            t.set(row, fmt::format("v{}", "xyz"[a]), "m/s", lump.velocity[a]);
        }
        t.set(row, "mass", "kg", lump.mass);
        t.set(row, "inner_energy", "J", lump.inner_energy);
        t.set(row, "particles", "-", double(lump.particles));
    }
    begin_balance(simulation);
}

void Recorder::rewind(Simulation& simulation) {
    record_.rewind(simulation.time());
    begin_balance(simulation);  // checkpoints are made at frames
    last_face_sample_ = simulation.time();
}

void Recorder::fill_hull_pressure(Simulation& simulation) {
    if (!hull_) return;
    sample_hull(simulation);
    record_.hull = hull_at_start_->patches_with(*simulation.hull());
    record_.hull_pressure.clear();
    record_.hull_wet.clear();
    for (std::size_t k = 0; k < hull_->area.size(); ++k) {
        record_.hull_wet.push_back(hull_->wet(k) ? 1.0f : 0.0f);
        record_.hull_pressure.push_back(hull_->presses(k) ? hull_->points.p[k] : 0.0f);
    }
}

}  // namespace tw
