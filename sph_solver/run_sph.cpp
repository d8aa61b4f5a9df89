#include "sph_solver/run_sph.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "base/folder_lock.h"
#include "base/in_words.h"
#include "record/code_version.h"
#include "record/spray_table.h"
#include "scene/defaults.h"
#include "scene/hash.h"
#include "scene/new_record.h"
#include "scene/refined_places.h"
#include "scene/time_left.h"
#include "sph_solver/backend/threads.h"
#include "sph_solver/choose_passes.h"
#include "sph_solver/measure/certificate.h"
#include "sph_solver/measure/level_ledger.h"
#include "sph_solver/measure/recorder.h"
#include "sph_solver/measure/run_watch.h"
#include "sph_solver/on_gpu.h"
#include "sph_solver/parallel/comm.h"
#include "sph_solver/ranks_refused.h"
#include "sph_solver/run_files.h"
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

/// Adds wall and processor time to a phase of the record while it lives; without that of `files`, where they are written
/// meanwhile.
class PhaseTimer {
public:
    PhaseTimer(RunRecord& record, std::string name, const RunFiles* files = nullptr)
        : record_(record), name_(std::move(name)), files_(files), wall_(wall_now()), cpu_(cpu()) {}
    ~PhaseTimer() {
        auto p =
            std::find_if(record_.phases.begin(), record_.phases.end(), [&](const Phase& q) { return q.name == name_; });
        if (p == record_.phases.end()) p = record_.phases.insert(p, Phase{name_, 0, 0});
        p->wall += wall_now() - wall_;
        p->cpu += std::max(0.0, cpu() - cpu_);  // two clocks, which the system brings up to date at different times
    }
    PhaseTimer(const PhaseTimer&) = delete;
    PhaseTimer& operator=(const PhaseTimer&) = delete;

private:
    double cpu() const { return cpu_now() - (files_ ? files_->cpu() : 0); }

    RunRecord& record_;
    std::string name_;
    const RunFiles* files_;
    double wall_, cpu_;
};

/// The next multiple of `interval` after `time`.
double next_after(double time, double interval) { return (std::floor(time / interval + 1e-9) + 1) * interval; }

struct Earlier {
    RunRecord record;
    Checkpoint checkpoint;
};

/// The last checkpoint and the record that leads to it; nothing: the run was stopped before its first one and begins
/// again. Throws InputError naming the file that is missing, of another scene, or ends too early.
std::optional<Earlier> earlier_run(const fs::path& record_file, const fs::path& checkpoint_file,
                                   const std::string& hash) {
    Earlier run;
    if (fs::exists(record_file)) {
        run.record = read_record(record_file);
        if (run.record.attributes["run_hash"] != hash)
            throw InputError(record_file.string() +
                             ": belongs to another scene (or the scene file was changed); run in another folder or "
                             "with --overwrite");
        if (!fs::exists(checkpoint_file) && run.record.state != "finished") return {};
    }
    run.checkpoint = read_checkpoint(checkpoint_file, hash);
    const double time = run.checkpoint.levels.front().state.time;
    const std::vector<double>& frames = run.record.table("samples").time;
    if (frames.empty() || frames.back() < time)
        throw InputError(
            fmt::format("{}: {}, and its checkpoint is of {:.6g} s: what was recorded in between would be "
                        "missing; put the record back or begin anew with --overwrite",
                        record_file.string(),
                        frames.empty() ? "there is no row of samples in it, or no such file"
                                       : fmt::format("it ends at {:.6g} s", frames.back()),
                        time));
    return run;
}

/// Ranks of other programs would add other numbers.
void refuse_other_builds(const Comm& ranks) {
    const std::string version = TWINWAKE_CODE_VERSION, of_first = ranks.told_by(0, version);
    ranks.together([&] {
        if (version != of_first)
            throw InputError(
                fmt::format("rank {} is twinwake {}, and rank 0 is {}: start the same program on all nodes",
                            ranks.rank(), version, of_first));
    });
}

}  // namespace

RunRecord run_sph(const Scene& scene, const RunOptions& options) {
    const std::string hash = run_hash(scene, "sph");
    const Comm& ranks = Comm::world();
    refuse_ranks(scene, ranks.size());
    refuse_other_builds(ranks);
    const bool on_gpu = gpu_wanted(scene);
    std::optional<FolderLock> lock;
    ranks.on_first([&] { lock.emplace(options.folder); });
    RunFiles files(options.folder, hash, ranks, !ranks.many());
    std::optional<RunRecord> finished;
    std::optional<Earlier> earlier;
    ranks.together([&] {
        const bool holds_run = fs::exists(files.record()) || fs::exists(files.checkpoint());
        if (holds_run && !options.resume && !options.overwrite)
            throw InputError(
                options.folder.string() +
                ": holds a run already; go on with --resume, begin anew with --overwrite, or choose another --out");
        if (options.resume && fs::exists(files.record())) {
            RunRecord before = read_record(files.record());
            if (before.state == "finished" && before.attributes["run_hash"] == hash &&
                before.numbers["duration"] >= scene.run.duration)
                finished = std::move(before);
        }
        if (!finished && options.resume && holds_run) earlier = earlier_run(files.record(), files.checkpoint(), hash);
    });
    if (finished) return *finished;

    const int threads = options.threads > 0     ? options.threads
                        : scene.run.threads > 0 ? scene.run.threads
                                                : std::max(1, processors() / ranks.size_here());
    const Threads of_run(threads);
    RunRecord fresh = new_record(scene, "sph");
    note_prediction(fresh, options);
    std::optional<SphSetup> setup;
    std::optional<Simulation> simulation;
    {
        const PhaseTimer timer(fresh, "particles");
        setup = sph_setup(scene, threads);
        if (ranks.many()) setup->simulation.ranks = &ranks;
        // the same pair loops as before, and on all ranks: others may give other last digits
        const std::string isa = ranks.told_by(0, earlier         ? earlier->checkpoint.isa
                                                 : on_gpu        ? passes_beside_gpu().isa
                                                 : ranks.first() ? choose_passes().isa
                                                                 : "");
        ranks.together([&] { simulation.emplace(setup->simulation, setup->fluid, passes(isa.c_str())); });
        if (setup->air) add_air(*simulation, setup->air->options, setup->air->fluid);
    }
    std::string no_room;  // others may have taken the GPU's memory
    if (on_gpu && scene.run.device == "auto") no_room = why_no_room_on_gpu(*simulation);
    if (!no_room.empty()) fresh.attributes["gpu_left_alone"] = no_room;
    if (on_gpu && no_room.empty())
        fresh.attributes["device"] = leave_steps_to_gpu(*simulation);
    else if (setup->control_volume)
        simulation->set_control_volume(*setup->control_volume);
    fresh.attributes["threads"] = std::to_string(threads);
    if (ranks.many()) fresh.attributes["ranks"] = std::to_string(ranks.size());
    fresh.attributes["isa"] = simulation->passes().isa;
    fresh.attributes["calibrated"] =
        "support of 0.9 to 1 at which a wall begins to compress, on planing_prism at beam/12; support of 0.8 to 0.9, "
        "with a plane surface's share given back, at which water begins to compress at a surface, on the potential "
        "energy of sloshing and the reflection of a wave at an edge of two sizes; strength of the shifting, on a "
        "planing plate, jets that meet, an elliptic drop and Taylor-Green vortices";
    if (setup->pressure_iterations > 0) fresh.numbers["start_pressure_iterations"] = setup->pressure_iterations;
    fresh.numbers["spacing"] = scene.resolution.near_hull;
    fresh.numbers["wall_particles"] = double(simulation->finest().walls().size());
    if (const int sizes = sizes_of_particles(scene); sizes > 1) {
        fresh.numbers["levels"] = sizes;
        fresh.numbers["finest_spacing"] = finest_spacing(scene);
    }
    const auto count = [&] {
        std::int64_t n = 0;
        for (const auto& level : simulation->water()) n += level->count();
        return n;
    };
    // the coarsest level is whole everywhere
    const double mass_at_start =
        earlier ? earlier->checkpoint.mass_at_start : simulation->mass() * double(simulation->level(0).count());
    setup->fluid = {}, setup->air = {};

    if (!earlier) ranks.on_first([&] { files.remove(); });
    if (earlier) {
        fresh.tables = std::move(earlier->record.tables);
        fresh.frames = std::move(earlier->record.frames);
        fresh.phases = std::move(earlier->record.phases);
        if (!ranks.first())  // the first one has them for all
            for (Phase& phase : fresh.phases) phase.cpu = 0;
        fresh.certificate = std::move(earlier->record.certificate);
        fresh.attributes["resumed_at"] = fmt::format("{}", earlier->checkpoint.levels.front().state.time);
        if (const std::string before = earlier->record.attributes["code_version"];
            before != fresh.attributes["code_version"])
            fresh.attributes["resumed_from_version"] = before;
    }
    Recorder recorder(scene, *simulation, std::move(fresh));
    RunRecord& record = recorder.record();
    const std::optional<SprayGate> gate = SprayGate::of(scene.sph);
    if (gate) record.numbers[spray_gate_number] = 1;
    bool has_checkpoint = earlier.has_value();
    if (earlier) {
        restore(*simulation, std::move(earlier->checkpoint));
        recorder.rewind(*simulation);
        if (!earlier->record.hull_pressure.empty()) {  // of the last picture, until the next one
            record.hull = std::move(earlier->record.hull);
            record.hull_pressure = std::move(earlier->record.hull_pressure);
            record.hull_wet = std::move(earlier->record.hull_wet);
        }
        files.find_written(simulation->time());
    }

    const double duration = scene.run.duration, interval = scene.sampling.interval;
    double next_frame = next_after(simulation->time(), interval);
    double next_checkpoint = next_after(simulation->time(), scene.run.checkpoint > 0 ? scene.run.checkpoint : duration);
    double next_snapshot = scene.sampling.snapshot_interval > 0
                               ? next_after(simulation->time(), scene.sampling.snapshot_interval)
                               : 2 * duration;
    const double started = wall_now(), time_at_start = simulation->time();
    double last_report = 0;
    RunWatch watch(
        {.speed = explained_speed(scene), .duration = duration - time_at_start, .steps = options.predicted_steps});

    /// The record as it is now, with the processor time and memory of all ranks.
    const auto record_now = [&](const std::string& state, const std::string& reason) {
        record.state = state;
        record.reason = reason;
        const Level* air = simulation->gas();
        const std::int64_t gas = air ? air->count() : 0;
        record.elements = double(count() + gas);
        if (gas > 0) record.numbers["air_particles"] = double(gas);
        record.steps = double(simulation->steps());
        if (record.resolution.empty() || simulation->setup().zones_round)
            record.resolution = resolution_of(*simulation);
        if (const std::vector<LevelLedger> sizes = level_ledgers(*simulation); sizes.size() > 1)
            for (std::size_t k = 0; k < sizes.size(); ++k) {
                record.numbers[level_table(k) + "_seconds"] = sizes[k].seconds;
                record.numbers[level_table(k) + "_edge_seconds"] = sizes[k].edge.seconds;
            }
        if (std::ranges::any_of(scene.bodies, [](const MovingBody& b) { return b.elastic.has_value(); }))
            record.numbers["structure_seconds"] = simulation->structure_seconds();
        record.peak_memory = std::max(record.peak_memory, ranks.sum(peak_memory()));
        const auto bytes = ranks.sum(static_cast<std::int64_t>(simulation->bytes()));
        if (record.elements > 0) record.numbers["bytes_per_particle"] = double(bytes) / record.elements;
        RunRecord now = record;
        for (Phase& phase : now.phases) {
            if (phase.name == "output") phase.cpu += files.cpu();
            phase.cpu = ranks.sum(phase.cpu);
        }
        return now;
    };
    const auto end_as = [&](const std::string& state, const std::string& reason) {
        RunRecord end = record_now(state, reason);
        ranks.on_first([&] { write_record(files.record(), end); });
        return end;
    };
    const auto checkpoint_now = [&](RunOutput& output) {
        output.record = record_now("running", "");
        output.checkpoint = checkpoint_of(*simulation, mass_at_start);
        has_checkpoint = true;
    };
    const auto report = [&] {
        if (!options.progress) return;
        const double wall = wall_now() - started, done = (simulation->time() - time_at_start) / duration;
        Progress p;
        p.time = simulation->time(), p.duration = duration, p.wall = wall, p.steps = simulation->steps();
        p.eta = time_left(done, 1 - simulation->time() / duration, wall, options.predicted_seconds);
        const Level* air = simulation->gas();
        p.note = fmt::format("sph {} particles{}, dt {:.3g} s", count(),
                             air ? fmt::format(" and {} of air", air->count()) : "", simulation->dt());
        options.progress(p);
        last_report = wall_now();
    };

    // Of several ranks all stop where one is asked to; they ask each other now and then.
    const auto stop_asked = [&] {
        constexpr std::int64_t every = 16;
        if (ranks.many() && simulation->steps() % every != 0) return false;
        return ranks.largest(options.stop_asked && options.stop_asked() ? 1 : 0) > 0;
    };
    try {
        while (simulation->time() < duration) {
            {
                const PhaseTimer timer(record, "solving", &files);
                simulation->step();
                watch.after_step(*simulation);
            }
            const bool last = simulation->time() >= duration, frame = last || simulation->time() >= next_frame;
            {
                const PhaseTimer timer(record, "output", &files);
                recorder.after_step(*simulation, frame);
                if (frame) watch.after_frame(record), next_frame = next_after(simulation->time(), interval);
                const bool picture = last || simulation->time() >= next_snapshot,
                           checkpoint = frame && !last && simulation->time() >= next_checkpoint;
                if (picture || checkpoint) files.finish();  // so that one output at a time takes memory
                RunOutput output;
                if (picture) {
                    recorder.fill_hull_pressure(*simulation);
                    if (scene.sampling.snapshot_interval > 0) output.picture = picture_of(*simulation, record);
                    next_snapshot = next_after(simulation->time(), std::max(scene.sampling.snapshot_interval, 1e-300));
                }
                if (frame && gate) recorder.take_spray(*simulation, *gate);
                if (checkpoint) {  // at a frame, where the control volume's sums begin anew
                    checkpoint_now(output);
                    next_checkpoint = next_after(simulation->time(), scene.run.checkpoint);
                }
                // At every frame, saved or not: neighbours found anew are summed in another order, and how often a run
                // is saved must not show in its numbers.
                if (frame) simulation->mark_restart_point();
                if (output.picture || output.record) files.write(std::move(output));
            }
            if (wall_now() - last_report > 0.5) report();
            if (stop_asked()) {
                files.finish();
                return end_as(
                    "stopped",
                    fmt::format("asked to stop at t = {:.6g} s; --resume {}", simulation->time(),
                                has_checkpoint ? "goes on from the last checkpoint"
                                               : "begins it again, as it has not reached its first checkpoint"));
            }
        }
        files.finish();
        RunOutput at_end;
        checkpoint_now(at_end);
        files.write(std::move(at_end));
        files.finish();
        RunRecord end = end_as("finished", "");
        report();
        return end;
    } catch (const std::exception& e) {
        // What ends the run ends it on all ranks alike; anything else has hit this one alone, see Comm::end.
        if (ranks.many() && dynamic_cast<const RunError*>(&e) == nullptr) throw;
        watch_stability(*simulation, record);  // what the run was stopped for
        try {
            files.finish();
        } catch (const std::exception&) {}  // what ended the run was before it
        try {
            end_as("failed", in_words(e));
        } catch (const std::exception& nested) {
            throw RunError(in_words(e) + "; and the record could not be saved: " + in_words(nested));
        }
        throw RunError(in_words(e));
    }
}

}  // namespace tw
