#include "sph_solver/measure/recorder.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "record/certificate.h"
#include "record/raster.h"
#include "sph_solver/effects/air.h"
#include "sph_solver/measure/certificate.h"

namespace tw {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::int64_t surface_every = 10;  ///< steps between samples of surface pressure and control volume faces

/// Appends a row: every column gets its value, those not named NaN.
std::size_t append_row(Table& table, double time) {
    table.time.push_back(time);
    for (Column& c : table.columns) c.values.resize(table.time.size(), nan);
    return table.time.size() - 1;
}
void set(Table& table, std::size_t row, const std::string& name, const char* unit, double value) {
    Column& c = table.column(name, unit);
    c.values.resize(table.time.size(), nan);
    c.values[row] = value;
}

}  // namespace

Recorder::Recorder(const Scene& scene, const Solver& solver, RunRecord record)
    : scene_(scene), record_(std::move(record)), factor_(scene.symmetry_factor()) {
    const SolverSetup& s = solver.setup();
    if (scene.hull) {
        Box region = scene.hull->surface.bounds();
        region.min.array() -= s.dp;
        region.max.array() += s.dp;
        if (scene.hull->half) region.min.y() = 0;
        hull_.emplace(scene.hull->surface, s.dp, region);
    }
    for (const PressureProbe& p : scene.sampling.pressure) pressure_points_.places.push_back(p.place);
    height_step_ = s.dp / 2;
    heights_per_gauge_ = static_cast<int>(std::ceil(s.domain.size().z() / height_step_));
    for (const HeightProbe& g : scene.sampling.height)
        for (int k = 0; k < heights_per_gauge_; ++k)
            height_points_.places.emplace_back(g.x, g.y, s.domain.min.z() + (k + 0.5) * height_step_);
}

void Recorder::after_step(Solver& solver, bool frame) {
    const std::size_t row = append_row(forces(), solver.time());
    if (!solver.setup().solids.empty()) {
        const Load& load = solver.load();
        Table& t = forces();
        const Vec3 whole(factor_, factor_ == 2 ? 0 : 1, factor_);  // a half model's sideways forces cancel
        const auto put = [&](const char* part, const Vec3& f) {
            const Vec3 force = f.cwiseProduct(whole);
            for (int a = 0; a < 3; ++a) set(t, row, fmt::format("f{}{}", "xyz"[a], part), "N", force[a] + 0.0);
        };
        put("", load.force);
        put("_pressure", load.force - load.friction);
        put("_viscous", load.friction);
        set(t, row, "my", "N m", factor_ * load.moment.y());
        if (solver.air()) {
            const Vec3 air = solver.air()->load().force.cwiseProduct(whole);
            set(t, row, "fx_air", "N", air.x());
            set(t, row, "fz_air", "N", air.z());
        }
    }
    if (frame || solver.steps() % surface_every == 0) sample_surface(solver, row);
    if (frame) sample_frame(solver, row);
    watch_stability(solver, record_);
    if (frame) watch_energy(record_);
}

void Recorder::sample_surface(Solver& solver, std::size_t row) {
    if (hull_) {
        solver.sample(hull_->points);
        Vec3 moment;
        const Vec3 force = factor_ * hull_->pressure_force(solver.setup().moment_reference, moment);
        set(forces(), row, "fx_surface", "N", force.x());
        set(forces(), row, "fz_surface", "N", force.z());
    }
    if (ControlVolume* cv = solver.control_volume()) {
        solver.sample(cv->faces());
        double mass_inside = 0;
        ControlVolume::momentum_inside(*cv, solver.particles(), solver.mass(), mass_inside);
        Vec3 body_force = solver.setup().gravity;
        if (solver.setup().stream) body_force.x() += solver.setup().stream->acceleration(solver.time());
        cv->add_impulse(mass_inside, body_force, solver.time() - last_face_sample_);
        last_face_sample_ = solver.time();
    }
}

void Recorder::sample_frame(Solver& solver, std::size_t row) {
    const SolverSetup& s = solver.setup();
    const Particles& p = solver.particles();
    if (ControlVolume* cv = solver.control_volume()) {
        double mass_inside = 0;
        const Vec3 momentum = ControlVolume::momentum_inside(*cv, p, solver.mass(), mass_inside);
        const ControlVolume::State& sums = cv->state();
        if (momentum_known_ && sums.since > 0) {
            const Vec3 force = factor_ * (sums.crossed + sums.impulse - (momentum - momentum_)) / sums.since;
            set(forces(), row, "fx_volume", "N", force.x());
            set(forces(), row, "fz_volume", "N", force.z());
        }
        momentum_ = momentum;
        momentum_known_ = true;
        cv->set_state({});
    }

    Table& t = record_.table("samples");
    const std::size_t k = append_row(t, solver.time());
    double kinetic = 0, potential = 0, elastic = 0;
    std::int64_t count = 0;
    Raster raster(scene_.sampling.raster);
    const bool pour = scene_.sampling.raster.spacing > 0;
    const double c0 = s.state_equation.c0, m = solver.mass();
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (pour) raster.pour(Vec3(p.x[i], p.y[i], p.z[i]), s.dp, m / (s.rho0 + double(p.drho[i])));
        if (p.kind[i] != Kind::fluid) continue;
        ++count;
        kinetic += 0.5 * m * (double(p.u[i]) * p.u[i] + double(p.v[i]) * p.v[i] + double(p.w[i]) * p.w[i]);
        potential -= m * s.gravity.z() * p.z[i];
        elastic += 0.5 * m * c0 * c0 * double(p.drho[i]) * p.drho[i] / (s.rho0 * s.rho0);
    }
    if (pour) record_.frames.push_back(raster.frame(solver.time()));
    set(t, k, "mass", "kg", factor_ * m * double(count));
    set(t, k, "kinetic_energy", "J", factor_ * kinetic);
    set(t, k, "potential_energy", "J", factor_ * potential);
    set(t, k, "elastic_energy", "J", factor_ * elastic);
    set(t, k, "dt", "s", solver.dt());
    set(t, k, "max_speed", "m/s", solver.extremes().speed);
    set(t, k, "max_mach", "-", solver.extremes().speed / c0);
    set(t, k, "density_deviation_low", "kg/m3", solver.extremes().density_deviation_low);
    set(t, k, "density_deviation_high", "kg/m3", solver.extremes().density_deviation_high);
    set(t, k, "particles", "-", double(p.size()));
    set(t, k, "particles_in", "-", double(solver.ledger().in));
    set(t, k, "particles_out", "-", double(solver.ledger().out));
    set(t, k, "particles_lost", "-", double(solver.ledger().lost));
    set(t, k, "held_at_wall", "-", double(solver.ledger().held));
    if (const Solver* air = solver.air()) {
        set(t, k, "air_particles", "-", double(air->particles().size()));
        set(t, k, "air_energy", "J", factor_ * gas_energy(*air));
        set(t, k, "air_max_speed", "m/s", air->extremes().speed);
        set(t, k, "air_density_deviation_low", "kg/m3", air->extremes().density_deviation_low);
        set(t, k, "air_density_deviation_high", "kg/m3", air->extremes().density_deviation_high);
    }
    if (hull_) {
        set(t, k, "wetted_area", "m2", factor_ * hull_->wetted_area());
        set(t, k, "wetted_length", "m", hull_->wetted_length(0.1 * scene_.hull->beam));
    }
    probe(solver);
}

void Recorder::probe(Solver& solver) {
    if (!pressure_points_.places.empty()) {
        Table& t = record_.table("pressure");
        const std::size_t k = append_row(t, solver.time());
        solver.sample(pressure_points_);
        for (std::size_t n = 0; n < pressure_points_.places.size(); ++n)
            set(t, k, scene_.sampling.pressure[n].name.c_str(), "Pa",
                pressure_points_.support[n] >= SurfaceSamples::wet || solver.air() ? double(pressure_points_.p[n])
                                                                                   : 0.0);
    }
    if (!height_points_.places.empty()) {
        // elevation of the water column over the floor: the integral of its share of each height
        Table& t = record_.table("height");
        const std::size_t k = append_row(t, solver.time());
        solver.sample(height_points_);
        for (std::size_t n = 0; n < scene_.sampling.height.size(); ++n) {
            double column = 0;
            for (int j = 0; j < heights_per_gauge_; ++j)
                column += height_step_ *
                          std::min(1.0, double(height_points_.support[n * static_cast<std::size_t>(heights_per_gauge_) +
                                                                      static_cast<std::size_t>(j)]));
            set(t, k, scene_.sampling.height[n].name.c_str(), "m", solver.setup().domain.min.z() + column);
        }
    }
}

void Recorder::rewind(Solver& solver) {
    for (auto& [name, table] : record_.tables) {
        const auto keep = static_cast<std::size_t>(
            std::upper_bound(table.time.begin(), table.time.end(), solver.time()) - table.time.begin());
        table.time.resize(keep);
        for (Column& c : table.columns) c.values.resize(keep);
    }
    std::erase_if(record_.frames, [&](const RasterFrame& f) { return f.time > solver.time(); });
    // checkpoints are made at frames, where the control volume's sums begin anew
    if (ControlVolume* cv = solver.control_volume()) {
        double mass_inside = 0;
        momentum_ = ControlVolume::momentum_inside(*cv, solver.particles(), solver.mass(), mass_inside);
        momentum_known_ = true;
    }
    last_face_sample_ = solver.time();
}

void Recorder::fill_hull_pressure(Solver& solver) {
    if (!hull_) return;
    solver.sample(hull_->points);
    record_.hull = hull_->patches();
    record_.hull_pressure.clear();
    record_.hull_wet.clear();
    for (std::size_t k = 0; k < hull_->area.size(); ++k) {
        const bool wet = hull_->points.support[k] >= SurfaceSamples::wet;
        record_.hull_wet.push_back(wet ? 1.0f : 0.0f);
        record_.hull_pressure.push_back(wet ? hull_->points.p[k] : 0.0f);
    }
}

}  // namespace tw
