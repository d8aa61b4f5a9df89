#include "sph_solver/run_sph.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "base/folder_lock.h"
#include "base/in_words.h"
#include "record/code_version.h"
#include "record/spray_table.h"
#include "scene/cost/time_left.h"
#include "scene/defaults.h"
#include "scene/hash.h"
#include "scene/new_record.h"
#include "scene/refined_places.h"
#include "scene/run/run_end.h"
#include "sph_solver/backend/threads.h"
#include "sph_solver/choose_passes.h"
#include "sph_solver/measure/level_ledger.h"
#include "sph_solver/measure/recorder.h"
#include "sph_solver/measure/run_watch.h"
#include "sph_solver/measure/validity_checks.h"
#include "sph_solver/on_gpu.h"
#include "sph_solver/parallel/comm.h"
#include "sph_solver/phase_timer.h"
#include "sph_solver/run_files.h"
#include "sph_solver/scene_setup.h"
#include "sph_solver/state/checkpoint.h"

namespace tw {
namespace fs = std::filesystem;

namespace {

/// The next multiple of `interval` after `time`.
double next_after(double time, double interval) { return (std::floor(time / interval + 1e-9) + 1) * interval; }

/// Ranks of other programs would add other numbers.
void refuse_other_builds(const Comm& ranks) {
    const std::string version = TWINWAKE_CODE_VERSION, of_first = ranks.broadcast_from(0, version);
    ranks.together([&] {
        if (version != of_first)
            throw InputError(
                fmt::format("rank {} is twinwake {}, and rank 0 is {}: start the same program on all nodes",
                            ranks.rank(), version, of_first));
    });
}

/// Of several ranks GPUs make all steps, or none.
bool all_on_gpu(const Comm& ranks, const Scene& scene, const RunOptions& options) {
    bool wanted = false;
    ranks.together([&] { wanted = gpu_wanted(scene, options.prediction); });
    return ranks.sum(std::int64_t{wanted}) == ranks.size();
}
/// What one of them says, the same on all; empty: none says anything.
std::string said_by_one(const Comm& ranks, const std::string& own) {
    const auto who = static_cast<int>(ranks.largest(own.empty() ? -1 : ranks.rank()));
    return who < 0 ? "" : ranks.broadcast_from(who, own);
}

/// One run of one scene, from the setup to the record: `run` is the list of its parts.
class SphRun {
public:
    SphRun(const Scene& scene, const RunOptions& options)
        : scene_(scene),
          options_(options),
          hash_(run_hash(scene, "sph")),
          duration_(scene.run.duration),
          ranks_(Comm::world()),
          on_gpu_(all_on_gpu(ranks_, scene, options)),
          files_(options.folder, hash_, ranks_, !ranks_.many()),
          threads_(options.threads > 0     ? options.threads
                   : scene.run.threads > 0 ? scene.run.threads
                                           : std::max(1, processors() / ranks_.size_here())) {
        ranks_.on_first([&] { lock_.emplace(options.folder); });
    }

    RunRecord run() {
        std::optional<RunRecord> finished;
        ranks_.together([&] { finished = look_at_folder(); });
        if (finished) return std::move(*finished);
        const Threads of_run(threads_);
        RunRecord fresh = new_record(scene_, "sph");
        note_prediction(fresh, options_);
        set_up(fresh);
        describe(fresh);
        if (earlier_)
            take_up_tables(fresh);
        else
            ranks_.on_first([&] { files_.remove(); });
        recorder_.emplace(scene_, *simulation_, std::move(fresh));
        if (gate_) record().numbers[spray_gate_number] = 1;
        if (earlier_) take_up_state();
        plan_outputs();
        return advance();
    }

private:
    RunRecord& record() { return recorder_->record(); }

    /// What the folder holds: the record of a run that has nothing left to do, or in `earlier_` one to be resumed.
    std::optional<RunRecord> look_at_folder() {
        const bool holds_run = fs::exists(files_.record()) || fs::exists(files_.checkpoint());
        if (holds_run && !options_.resume && !options_.overwrite)
            throw InputError(
                options_.folder.string() +
                ": holds a run already; continue with --resume, begin anew with --overwrite, or choose another --out");
        if (!options_.resume || !holds_run) return {};
        if (fs::exists(files_.record())) {
            RunRecord before = read_record(files_.record());
            if (before.attributes["run_hash"] == hash_ && is_complete(scene_, before)) return before;
        }
        earlier_ = earlier_run(files_, hash_, ranks_.first());
        return {};
    }

    /// Water, walls and bodies where they start, on the processor or the GPU.
    void set_up(RunRecord& fresh) {
        std::optional<ControlVolume> control_volume;
        {
            const PhaseTimer timer(fresh, "particles");
            SphSetup setup = sph_setup(scene_, threads_, ranks_);
            // the same pair loops as before, and on all ranks: others may give other last digits
            const std::string isa = ranks_.broadcast_from(0, earlier_         ? earlier_->checkpoint.isa
                                                             : on_gpu_        ? passes_beside_gpu().isa
                                                             : ranks_.first() ? choose_passes().isa
                                                                              : "");
            const Passes* of_all = nullptr;
            ranks_.together([&] { of_all = &passes(isa.c_str()); });
            simulation_.emplace(setup.simulation, setup.fluid, *of_all);
            if (setup.air) add_air(*simulation_, setup.air->options, setup.air->fluid);
            control_volume = std::move(setup.control_volume);
            if (setup.pressure_iterations > 0) fresh.numbers["start_pressure_iterations"] = setup.pressure_iterations;
        }
        std::string no_room;  // others may have taken the GPU's memory
        if (on_gpu_ && scene_.run.device == "auto") no_room = said_by_one(ranks_, why_no_room_on_gpu(*simulation_));
        if (!no_room.empty()) fresh.attributes["gpu_left_alone"] = no_room;
        if (on_gpu_ && no_room.empty())
            ranks_.together([&] { fresh.attributes["device"] = leave_steps_to_gpu(*simulation_); });
        else if (control_volume)
            simulation_->set_control_volume(*control_volume);
        // the coarsest level is whole everywhere
        mass_at_start_ = earlier_ ? earlier_->checkpoint.mass_at_start
                                  : simulation_->mass() * double(simulation_->level(0).fields().count());
    }

    void describe(RunRecord& fresh) const {
        fresh.attributes["threads"] = std::to_string(threads_);
        if (ranks_.many()) fresh.attributes["ranks"] = std::to_string(ranks_.size());
        fresh.attributes["isa"] = simulation_->passes().isa;
        fresh.attributes["calibrated"] =
            "how full of neighbours a kernel has to be before water is compressed at a wall (on planing_prism, "
            "beam/12) "
            "and at a surface (on sloshing, and a wave at an edge of two sizes); how strongly particles are shifted "
            "(on "
            "a planing plate, meeting jets, an elliptic drop, Taylor-Green vortices)";
        fresh.numbers["spacing"] = scene_.resolution.near_hull;
        fresh.numbers["wall_particles"] = double(simulation_->finest().system().walls.size());
        if (const int sizes = sizes_of_particles(scene_); sizes > 1) {
            fresh.numbers["levels"] = sizes;
            fresh.numbers["finest_spacing"] = finest_spacing(scene_);
        }
    }

    /// Of the run that is resumed: what it has recorded ...
    void take_up_tables(RunRecord& fresh) {
        fresh.tables = std::move(earlier_->record.tables);
        fresh.frames = std::move(earlier_->record.frames);
        fresh.phases = std::move(earlier_->record.phases);
        if (!ranks_.first())  // the first one has them for all
            for (Phase& phase : fresh.phases) phase.cpu = 0;
        fresh.validity_checks = std::move(earlier_->record.validity_checks);
        fresh.attributes["resumed_at"] = fmt::format("{}", earlier_->checkpoint.levels.front().state.time);
        if (const std::string before = earlier_->record.attributes["code_version"];
            before != fresh.attributes["code_version"])
            fresh.attributes["resumed_from_version"] = before;
    }

    /// ... and where its particles are.
    void take_up_state() {
        restore(*simulation_, std::move(earlier_->checkpoint));
        recorder_->rewind(*simulation_);
        if (!earlier_->record.hull_pressure.empty()) {  // of the last picture, until the next one
            record().hull = std::move(earlier_->record.hull);
            record().hull_pressure = std::move(earlier_->record.hull_pressure);
            record().hull_wet = std::move(earlier_->record.hull_wet);
        }
        files_.find_written(simulation_->time());
        has_checkpoint_ = true;
        earlier_.reset();
    }

    void plan_outputs() {
        const double now = simulation_->time(), pictures = scene_.sampling.snapshot_interval;
        next_frame_ = next_after(now, scene_.sampling.interval);
        next_checkpoint_ = next_after(now, scene_.run.checkpoint > 0 ? scene_.run.checkpoint : duration_);
        next_snapshot_ = pictures > 0 ? next_after(now, pictures) : 2 * duration_;
    }

    /// Steps to the end, a stop or a failure; what is written then is the whole record.
    RunRecord advance() {
        started_ = wall_now(), time_at_start_ = simulation_->time();
        RunWatch watch({.speed = explained_speed(scene_),
                        .duration = duration_ - time_at_start_,
                        .steps = options_.predicted_steps});
        try {
            while (simulation_->time() < duration_ && !settled_) {
                {
                    const PhaseTimer timer(record(), "solving", &files_);
                    simulation_->step();
                    watch.after_step(*simulation_);
                }
                {
                    const PhaseTimer timer(record(), "output", &files_);
                    put_out(watch);
                }
                if (wall_now() - last_report_ > 0.5) report();
                if (stop_asked()) return stopped();
            }
            return finished();
        } catch (const std::exception& e) {
            // What ends the run ends it on all ranks alike; anything else has hit this one alone, see Comm::end.
            if (ranks_.many() && dynamic_cast<const RunError*>(&e) == nullptr) throw;
            fail(in_words(e));
        }
    }

    /// What is due after a step: rows of the record, a picture, a checkpoint.
    void put_out(RunWatch& watch) {
        const double time = simulation_->time();
        const bool at_bound = time >= duration_, frame = at_bound || time >= next_frame_;
        recorder_->after_step(*simulation_, frame);
        if (frame && !at_bound && ranks_.largest(may_end(scene_, record()) ? 1 : 0) > 0) settled_ = time;
        const bool last = at_bound || settled_;
        if (frame) watch.after_frame(record()), next_frame_ = next_after(time, scene_.sampling.interval);
        const bool picture = last || time >= next_snapshot_, checkpoint = frame && !last && time >= next_checkpoint_;
        if (picture || checkpoint) files_.finish();  // so that one output at a time takes memory
        RunOutput output;
        if (picture) {
            recorder_->fill_hull_pressure(*simulation_);
            const double drawn = scene_.sampling.snapshot_interval;
            if (drawn > 0 || (last && drawn == 0)) output.picture = picture_of(*simulation_, record());
            next_snapshot_ = next_after(time, std::max(scene_.sampling.snapshot_interval, 1e-300));
        }
        if (frame && gate_) recorder_->take_spray(*simulation_, *gate_);
        if (checkpoint) {  // at a frame, where the control volume's sums begin anew
            put_checkpoint(output);
            next_checkpoint_ = next_after(time, scene_.run.checkpoint);
        }
        // At every frame, saved or not: neighbours found anew are summed in another order, and how often a run is saved
        // must not show in its numbers.
        if (frame) simulation_->mark_restart_point();
        if (output.picture || output.record) files_.write(std::move(output));
    }

    void put_checkpoint(RunOutput& output) {
        output.record = record_now("running", "");
        output.checkpoint = checkpoint_of(*simulation_, mass_at_start_);
        has_checkpoint_ = true;
    }

    std::int64_t particles_of_water() const {
        std::int64_t n = 0;
        for (const auto& level : simulation_->water()) n += level->fields().count();
        return n;
    }

    /// The record as it is now, with the processor time and memory of all ranks.
    RunRecord record_now(const std::string& state, const std::string& reason) {
        RunRecord& r = record();
        r.state = state;
        r.reason = reason;
        const Level* air = simulation_->gas();
        const std::int64_t gas = air ? air->fields().count() : 0;
        r.elements = double(particles_of_water() + gas);
        if (gas > 0) r.numbers["air_particles"] = double(gas);
        r.steps = double(simulation_->steps());
        if (r.resolution.empty() || simulation_->setup().zones_round) r.resolution = resolution_of(*simulation_);
        if (const std::vector<LevelLedger> sizes = level_ledgers(*simulation_); sizes.size() > 1)
            for (std::size_t k = 0; k < sizes.size(); ++k) {
                r.numbers[level_table(k) + "_seconds"] = sizes[k].seconds;
                r.numbers[level_table(k) + "_edge_seconds"] = sizes[k].edge.seconds;
            }
        if (std::ranges::any_of(scene_.bodies, [](const MovingBody& b) { return b.elastic.has_value(); }))
            r.numbers["structure_seconds"] = simulation_->structure_seconds();
        r.peak_memory = std::max(r.peak_memory, ranks_.sum(peak_memory()));
        const auto bytes = ranks_.sum(static_cast<std::int64_t>(simulation_->bytes()));
        if (r.elements > 0) r.numbers["bytes_per_particle"] = double(bytes) / r.elements;
        RunRecord now = r;
        for (Phase& phase : now.phases) {
            if (phase.name == "output") phase.cpu += files_.cpu();
            phase.cpu = ranks_.sum(phase.cpu);
        }
        return now;
    }

    void report() {
        if (!options_.progress) return;
        const double time = simulation_->time(), wall = wall_now() - started_,
                     done = (time - time_at_start_) / duration_;
        Progress p;
        p.time = time, p.duration = duration_, p.wall = wall, p.steps = simulation_->steps();
        p.eta = time_left(done, 1 - time / duration_, wall, options_.predicted_seconds);
        const Level* air = simulation_->gas();
        p.note = fmt::format("sph {} particles{}, dt {:.3g} s", particles_of_water(),
                             air ? fmt::format(" and {} of air", air->fields().count()) : "", simulation_->dt());
        p.so_far = &record();
        options_.progress(p);
        last_report_ = wall_now();
    }

    /// Of several ranks all stop where one is asked to; they ask each other now and then.
    bool stop_asked() const {
        constexpr std::int64_t every = 16;
        if (ranks_.many() && simulation_->steps() % every != 0) return false;
        return ranks_.largest(options_.stop_asked && options_.stop_asked() ? 1 : 0) > 0;
    }

    RunRecord end_as(const std::string& state, const std::string& reason) {
        RunRecord end = record_now(state, reason);
        ranks_.on_first([&] { write_record(files_.record(), end); });
        return end;
    }

    RunRecord stopped() {
        files_.finish();
        return end_as("stopped",
                      fmt::format("asked to stop at t = {:.6g} s; --resume {}", simulation_->time(),
                                  has_checkpoint_ ? "continues from the last checkpoint"
                                                  : "begins it again, as it has not reached its first checkpoint"));
    }

    RunRecord finished() {
        files_.finish();
        RunOutput at_end;
        put_checkpoint(at_end);
        files_.write(std::move(at_end));
        files_.finish();
        const std::string reason = note_end(scene_, record(), settled_);
        RunRecord end = end_as("finished", reason);
        report();
        return end;
    }

    [[noreturn]] void fail(const std::string& why) {
        watch_stability(*simulation_, record());  // what the run was stopped for
        try {
            files_.finish();
        } catch (const std::exception&) {}  // what ended the run was before it
        try {
            end_as("failed", why);
        } catch (const std::exception& nested) {
            throw RunError(why + "; and the record could not be saved: " + in_words(nested));
        }
        throw RunError(why);
    }

    const Scene& scene_;
    const RunOptions& options_;
    std::string hash_;
    double duration_;                // [s]; the run's bound where it ends as soon as its loads have settled
    std::optional<double> settled_;  // when they had [s]
    const Comm& ranks_;
    bool on_gpu_;
    std::optional<FolderLock> lock_;  // of the first rank
    RunFiles files_;
    int threads_;
    std::optional<EarlierRun> earlier_;
    std::optional<Simulation> simulation_;
    std::optional<Recorder> recorder_;
    std::optional<SprayGate> gate_ = SprayGate::of(scene_.sph);
    double mass_at_start_ = 0;                                         // [kg]
    double next_frame_ = 0, next_checkpoint_ = 0, next_snapshot_ = 0;  // [s]
    bool has_checkpoint_ = false;
    double started_ = 0, time_at_start_ = 0, last_report_ = 0;  // by the clock, of the run, by the clock [s]
};

}  // namespace

RunRecord run_sph(const Scene& scene, const RunOptions& options) {
    refuse_other_builds(Comm::world());
    return SphRun(scene, options).run();
}

}  // namespace tw
