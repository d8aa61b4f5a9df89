#include "sph_solver/run_sph.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "record/snapshot.h"
#include "record/spray_table.h"
#include "record/water_surface.h"
#include "scene/hash.h"
#include "scene/new_record.h"
#include "scene/refined_places.h"
#include "scene/time_left.h"
#include "sph_solver/backend/threads.h"
#include "sph_solver/choose_passes.h"
#include "sph_solver/measure/certificate.h"
#include "sph_solver/measure/level_ledger.h"
#include "sph_solver/measure/recorder.h"
#include "sph_solver/scene_setup.h"
#include "sph_solver/state/checkpoint.h"

namespace tw {
namespace fs = std::filesystem;

namespace {

double wall_now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }
double cpu_now() {
    rusage u{};
    getrusage(RUSAGE_SELF, &u);
    const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
    return seconds(u.ru_utime) + seconds(u.ru_stime);
}
double peak_memory() {
    rusage u{};
    getrusage(RUSAGE_SELF, &u);
    return 1024.0 * double(u.ru_maxrss);
}

/// Adds wall and processor time to a phase of the record while it lives.
class PhaseTimer {
public:
    PhaseTimer(RunRecord& record, std::string name)
        : record_(record), name_(std::move(name)), wall_(wall_now()), cpu_(cpu_now()) {}
    ~PhaseTimer() {
        auto p =
            std::find_if(record_.phases.begin(), record_.phases.end(), [&](const Phase& q) { return q.name == name_; });
        if (p == record_.phases.end()) p = record_.phases.insert(p, Phase{name_, 0, 0});
        p->wall += wall_now() - wall_;
        p->cpu += cpu_now() - cpu_;
    }
    PhaseTimer(const PhaseTimer&) = delete;
    PhaseTimer& operator=(const PhaseTimer&) = delete;

private:
    RunRecord& record_;
    std::string name_;
    double wall_, cpu_;
};

/// The next multiple of `interval` after `time`.
double next_after(double time, double interval) { return (std::floor(time / interval + 1e-9) + 1) * interval; }

/// ParaView files of one moment: particles, the hull with its pressure, and bodies where they are.
class Snapshots {
public:
    explicit Snapshots(const fs::path& folder) : folder_(folder / "snapshots") {}
    void write(const Simulation& simulation, const RunRecord& record) {
        fs::create_directories(folder_);
        const std::string stamp = fmt::format("{:09.5f}", simulation.time());
        write_levels(simulation.water(), "particles", particles_, stamp);
        if (simulation.gas()) write_levels(simulation.levels().last(1), "air", air_, stamp);
        write_water(record);
        const bool has_hull = !record.hull_pressure.empty();  // written with its pressure
        for (const auto& body : simulation.bodies())
            if (!body->fixed() && !(has_hull && body->is_hull())) write_body(simulation, *body, stamp);
        if (!has_hull) return;
        const std::string hull = "hull_" + stamp + ".vtp";
        write_surface(folder_ / hull, record.hull,
                      {{"pressure", 1, record.hull_pressure}, {"wet", 1, record.hull_wet}});
        hulls_.emplace_back(hull, simulation.time());
        write_series(folder_ / "hull.vtp.series", hulls_);
    }
    /// The free surface of the last raster frame, under its own time; a frame that is there already is left.
    void write_water(const RunRecord& record) {
        if (record.frames.empty()) return;
        const RasterFrame& frame = record.frames.back();
        const std::string name = fmt::format("free_surface_{:09.5f}.vtp", frame.time);
        if (!waters_.empty() && waters_.back().first == name) return;
        const Surface water = water_surface(record, frame);
        if (water.triangles.empty()) return;
        write_surface(folder_ / name, water, {});
        waters_.emplace_back(name, frame.time);
        write_series(folder_ / "free_surface.vtp.series", waters_);
    }
    /// After a restart: the files already there, up to `time`.
    void find_written(double time) {
        if (!fs::exists(folder_)) return;
        for (const auto& entry : fs::directory_iterator(folder_)) {
            const std::string name = entry.path().filename().string();
            if (name.starts_with("body_") && name.ends_with(".vtp"))
                if (const double at = std::stod(name.substr(name.rfind('_') + 1)); at <= time)
                    bodies_[name.substr(0, name.rfind('_'))].emplace_back(name, at);
            for (auto [prefix, suffix, list] :
                 {std::tuple{"particles_", ".hdf", &particles_}, std::tuple{"air_", ".hdf", &air_},
                  std::tuple{"hull_", ".vtp", &hulls_}, std::tuple{"free_surface_", ".vtp", &waters_}})
                if (name.starts_with(prefix) && name.ends_with(suffix)) {
                    const double at = std::stod(name.substr(std::string(prefix).size()));
                    if (at <= time) list->emplace_back(name, at);
                }
        }
        const auto earlier = [](const auto& a, const auto& b) { return a.second < b.second; };
        std::sort(particles_.begin(), particles_.end(), earlier);
        std::sort(air_.begin(), air_.end(), earlier);
        std::sort(hulls_.begin(), hulls_.end(), earlier);
        std::sort(waters_.begin(), waters_.end(), earlier);
        for (auto& [name, series] : bodies_) std::sort(series.begin(), series.end(), earlier);
    }

private:
    using Series = std::vector<std::pair<std::string, double>>;

    /// Active particles of one material in one file.
    void write_levels(std::span<const std::unique_ptr<Level>> levels, const std::string& name, Series& series,
                      const std::string& stamp) {
        std::vector<Vec3> places;
        Field velocity{"velocity", 3, {}}, pressure{"pressure", 1, {}}, kind{"kind", 1, {}}, size{"spacing", 1, {}};
        for (const auto& level : levels) {
            const Particles& p = level->particles();
            for (std::size_t i = 0; i < p.size(); ++i) {
                if (!is_active(p.kind[i])) continue;
                places.emplace_back(p.x[i], p.y[i], p.z[i]);
                velocity.values.insert(velocity.values.end(), {p.u[i], p.v[i], p.w[i]});
                pressure.values.push_back(static_cast<float>(level->pressure(i)));
                kind.values.push_back(static_cast<float>(p.kind[i]));
                size.values.push_back(static_cast<float>(level->setup().dp));
            }
        }
        const double time = levels.front()->time();
        const std::string file = name + "_" + stamp + ".hdf";
        write_particles(folder_ / file, time, places, {velocity, pressure, kind, size});
        series.emplace_back(file, time);
        write_series(folder_ / (name + ".hdf.series"), series);
    }

    /// The surface of a body where it is now; a section as thick as the water.
    void write_body(const Simulation& simulation, const Body& body, const std::string& stamp) {
        const SimulationSetup& s = simulation.setup();
        const Surface now = body.surface_now(s.dimensions == 2 ? std::optional(s.domain.size().y()) : std::nullopt);
        const std::string name = body_table(body.name()), file = name + "_" + stamp + ".vtp";
        write_surface(folder_ / file, now, {});
        bodies_[name].emplace_back(file, simulation.time());
        write_series(folder_ / (name + ".vtp.series"), bodies_[name]);
    }

    fs::path folder_;
    std::map<std::string, Series> bodies_;
    Series particles_, air_, hulls_, waters_;
};

void remove_old_run(const fs::path& folder) {
    for (const char* name : {"record.h5", "checkpoint.h5", "snapshots"}) fs::remove_all(folder / name);
}

}  // namespace

RunRecord run_sph(const Scene& scene, const RunOptions& options) {
    const fs::path record_file = options.folder / "record.h5", checkpoint_file = options.folder / "checkpoint.h5";
    const std::string hash = run_hash(scene, "sph");
    const FolderLock lock(options.folder);
    const bool holds_run = fs::exists(record_file) || fs::exists(checkpoint_file);
    if (holds_run && !options.resume && !options.overwrite)
        throw InputError(
            options.folder.string() +
            ": holds a run already; go on with --resume, begin anew with --overwrite, or choose another --out");
    if (options.resume && fs::exists(record_file)) {
        RunRecord done = read_record(record_file);
        if (done.state == "finished" && done.attributes["run_hash"] == hash &&
            done.numbers["duration"] >= scene.run.duration)
            return done;
    }
    std::optional<Checkpoint> checkpoint;
    if (options.resume && holds_run) checkpoint = read_checkpoint(checkpoint_file, hash);

    const int threads = options.threads > 0     ? options.threads
                        : scene.run.threads > 0 ? scene.run.threads
                                                : processors();
    const Threads of_run(threads);
    RunRecord fresh = new_record(scene, "sph");
    note_prediction(fresh, options);
    std::optional<SphSetup> setup;
    std::optional<Simulation> simulation;
    {
        const PhaseTimer timer(fresh, "particles");
        setup = sph_setup(scene, threads);
        // the same pair loops as before: others may give other last digits
        simulation.emplace(setup->simulation, setup->fluid,
                           checkpoint ? passes(checkpoint->isa.c_str()) : choose_passes());
        if (setup->air) add_air(*simulation, setup->air->options, setup->air->fluid);
    }
    if (setup->control_volume) simulation->set_control_volume(*setup->control_volume);
    fresh.attributes["threads"] = std::to_string(threads);
    fresh.attributes["isa"] = simulation->passes().isa;
    fresh.attributes["calibrated"] =
        "support of 0.9 to 1 at which a wall begins to compress, on planing_prism at beam/12; support of 0.8 to 0.9, "
        "with a plane surface's share given back, at which water begins to compress at a surface, on the potential "
        "energy "
        "of sloshing and the reflection of a wave at an edge of two sizes; strength of the "
        "shifting, on a planing plate, jets that meet, an elliptic drop and Taylor-Green vortices";
    if (setup->pressure_iterations > 0) fresh.numbers["release_pressure_iterations"] = setup->pressure_iterations;
    fresh.numbers["spacing"] = scene.resolution.near_hull;
    fresh.numbers["wall_particles"] = double(simulation->finest().walls().size());
    if (const int sizes = sizes_of_particles(scene); sizes > 1) {
        fresh.numbers["levels"] = sizes;
        fresh.numbers["finest_spacing"] = finest_spacing(scene);
    }
    const auto count = [&] {
        std::size_t n = 0;
        for (const auto& level : simulation->water()) n += level->particles().size();
        return n;
    };
    // the coarsest level is whole everywhere
    const double mass_at_start =
        checkpoint ? checkpoint->mass_at_start : simulation->mass() * double(simulation->particles().size());
    setup->fluid = {}, setup->air = {};

    if (!checkpoint) remove_old_run(options.folder);
    if (checkpoint && fs::exists(record_file)) {
        RunRecord before = read_record(record_file);
        fresh.tables = std::move(before.tables);
        fresh.frames = std::move(before.frames);
        fresh.phases = std::move(before.phases);
        fresh.certificate = std::move(before.certificate);
        fresh.attributes["resumed_at"] = fmt::format("{}", checkpoint->levels.front().state.time);
    }
    Recorder recorder(scene, *simulation, std::move(fresh));
    RunRecord& record = recorder.record();
    Snapshots snapshots(options.folder);
    const std::optional<SprayGate> gate = SprayGate::of(scene.sph);
    if (gate) record.numbers[spray_gate_number] = 1;
    if (checkpoint) {
        restore(*simulation, std::move(*checkpoint));
        recorder.rewind(*simulation);
        snapshots.find_written(simulation->time());
    }

    const double duration = scene.run.duration, interval = scene.sampling.interval;
    double next_frame = next_after(simulation->time(), interval);
    double next_checkpoint = next_after(simulation->time(), scene.run.checkpoint > 0 ? scene.run.checkpoint : duration);
    double next_snapshot = scene.sampling.snapshot_interval > 0
                               ? next_after(simulation->time(), scene.sampling.snapshot_interval)
                               : 2 * duration;
    const double started = wall_now(), time_at_start = simulation->time();
    double last_report = 0;

    const auto save = [&](const std::string& state, const std::string& reason) {
        record.state = state;
        record.reason = reason;
        const Level* air = simulation->gas();
        const std::size_t gas = air ? air->particles().size() : 0;
        record.elements = double(count() + gas);
        if (gas > 0) record.numbers["air_particles"] = double(gas);
        record.steps = double(simulation->steps());
        record.resolution = resolution_of(*simulation);
        for (std::size_t k = 0; k < simulation->water().size() && !simulation->refinements().empty(); ++k) {
            const LevelLedger l = level_ledger(*simulation, k);
            record.numbers[level_table(k) + "_seconds"] = l.seconds;
            record.numbers[level_table(k) + "_edge_seconds"] = l.edge.seconds;
        }
        if (std::ranges::any_of(scene.bodies, [](const MovingBody& b) { return b.elastic.has_value(); }))
            record.numbers["structure_seconds"] = simulation->structure_seconds();
        record.peak_memory = std::max(record.peak_memory, peak_memory());
        record.numbers["bytes_per_particle"] = simulation->bytes() / record.elements;
        write_record(record_file, record);
    };
    const auto report = [&] {
        if (!options.progress) return;
        const double wall = wall_now() - started, done = (simulation->time() - time_at_start) / duration;
        Progress p;
        p.time = simulation->time(), p.duration = duration, p.wall = wall, p.steps = simulation->steps();
        p.eta = time_left(done, 1 - simulation->time() / duration, wall, options.predicted_seconds);
        const Level* air = simulation->gas();
        p.note = fmt::format("sph {} particles{}, dt {:.3g} s", count(),
                             air ? fmt::format(" and {} of air", air->particles().size()) : "", simulation->dt());
        options.progress(p);
        last_report = wall_now();
    };

    try {
        while (simulation->time() < duration) {
            {
                const PhaseTimer timer(record, "solving");
                simulation->step();
            }
            const bool last = simulation->time() >= duration, frame = last || simulation->time() >= next_frame;
            {
                const PhaseTimer timer(record, "output");
                recorder.after_step(*simulation, frame);
                if (frame) next_frame = next_after(simulation->time(), interval);
                if (last || simulation->time() >= next_snapshot) {
                    recorder.fill_hull_pressure(*simulation);
                    if (scene.sampling.snapshot_interval > 0) snapshots.write(*simulation, record);
                    next_snapshot = next_after(simulation->time(), std::max(scene.sampling.snapshot_interval, 1e-300));
                }
                if (frame && gate) recorder.take_spray(*simulation, *gate);
                // at a frame, where the control volume's sums begin anew
                if (frame && !last && simulation->time() >= next_checkpoint) {
                    save("running", "");
                    write_checkpoint(checkpoint_file, hash, *simulation, mass_at_start);
                    simulation->mark_restart_point();
                    next_checkpoint = next_after(simulation->time(), scene.run.checkpoint);
                }
            }
            if (wall_now() - last_report > 0.5) report();
            if (options.stop_asked && options.stop_asked()) {
                save("stopped", fmt::format("asked to stop at t = {:.6g} s; --resume goes on from the last checkpoint",
                                            simulation->time()));
                return record;
            }
        }
        write_checkpoint(checkpoint_file, hash, *simulation, mass_at_start);
        save("finished", "");
        report();
    } catch (const RunError& e) {
        watch_stability(*simulation, record);  // what the run was stopped for
        try {
            save("failed", e.what());
        } catch (const RunError& nested) {
            throw RunError(std::string(e.what()) + "; and the record could not be saved: " + nested.what());
        }
        throw;
    }
    return record;
}

}  // namespace tw
