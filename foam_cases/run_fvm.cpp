#include "foam_cases/run_fvm.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <thread>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "base/folder_lock.h"
#include "base/in_words.h"
#include "foam_cases/doctor.h"
#include "foam_cases/files/case_files.h"
#include "foam_cases/mesh/make_mesh.h"
#include "foam_cases/one_way.h"
#include "foam_cases/plan_case.h"
#include "foam_cases/read/frame_reader.h"
#include "foam_cases/read/gaps.h"
#include "foam_cases/read/hull_patch.h"
#include "foam_cases/read/number_rows.h"
#include "foam_cases/read/plate_pressures.h"
#include "foam_cases/release.h"
#include "foam_cases/run/first_steps.h"
#include "foam_cases/run/solve.h"
#include "foam_cases/run/watchdog.h"
#include "foam_cases/take_up.h"
#include "foam_cases/write_case.h"
#include "methods/names.h"
#include "scene/new_record.h"
#include "scene/run/run_end.h"

namespace tw {
namespace fs = std::filesystem;

namespace {

const char* const release_factor_name = "release_factor";  // in the record: on the scene's first velocity of a body
constexpr double save_interval = 20;  // wall seconds between saves of the record while the solver runs

/// One run of one scene, from the empty folder to the record.
class FvmRun {
public:
    FvmRun(const Scene& scene, const RunOptions& options, const OpenFoam& openfoam)
        : options_(options),
          case_(options.folder / "case"),
          record_file_(options.folder / "record.h5"),
          plan_(plan_case(scene, openfoam)),
          openfoam_(openfoam),
          record_(new_record(scene, fvm_method)) {
        note_prediction(record_, options);
    }

    RunRecord run() {
        if (std::optional<RunRecord> done = finished_already()) return std::move(*done);
        prepare();
        const CasePrograms programs(openfoam_, case_);
        try {
            if (!fs::exists(meshed_mark()) && !mesh(programs))
                return end("stopped", "stopped while meshing, as asked; --resume meshes anew");
            return solve_and_read(programs);
        } catch (const std::exception& e) { fail(in_words(e)); }
    }

private:
    fs::path meshed_mark() const { return case_ / "meshed"; }

    /// The record of a run that is to be resumed and has nothing left to do.
    std::optional<RunRecord> finished_already() const {
        if (!options_.resume || !fs::exists(record_file_)) return {};
        RunRecord earlier = read_record(record_file_);
        if (earlier.attributes["run_hash"] != record_.attributes.at("run_hash") ||
            !is_complete(*plan_.scene, earlier) || !(earlier.numbers["write_interval"] > 0))
            return {};
        const double duration = std::min(plan_.scene->run.duration, earlier.numbers["duration"]);
        SolverLog log;
        follow(CasePrograms(openfoam_, case_).log("solver"), 0, log);
        if (first_gap(plan_, log, earlier, duration) || lacks_picture(plan_, earlier)) return {};
        return earlier;
    }

    void prepare() {
        const bool holds_run = fs::exists(case_) || fs::exists(record_file_);
        if (holds_run && !options_.resume && !options_.overwrite)
            throw InputError(options_.folder.string() +
                             ": holds a run already; --resume continues it, --overwrite begins anew");
        if (holds_run && !options_.resume) {
            fs::remove_all(case_);
            fs::remove(record_file_);
        }
        if (options_.resume && fs::exists(record_file_))
            take_up(read_record(record_file_));
        else if (options_.resume && fs::exists(meshed_mark()))
            throw InputError(record_file_.string() +
                             ": is not there, and the case beside it was begun: rows that only the record had would be "
                             "missing; put it back, or begin anew with --overwrite");
        if (options_.resume && fs::exists(meshed_mark())) {
            if (record_.numbers.contains(release_factor_name)) release_with(record_.numbers[release_factor_name]);
            if (const std::string file = changed_file(plan_, case_); !file.empty())
                throw InputError((case_ / file).string() +
                                 ": the scene (or this file) was changed since the run began, so the run cannot be "
                                 "continued; restore it, or begin anew with --overwrite");
            // interFoam adds digits to its time names as it needs them; begun with fewer it does not find its last
            // folder
            for (const TimeFolders::Moment& m : TimeFolders(case_).moments())
                plan_.time_precision = std::max(plan_.time_precision, static_cast<int>(m.name.size()));
            write_text_atomically(case_ / "system/controlDict", control_dict(plan_));  // the duration may have grown
        } else {
            write_case(plan_, case_, 1);
            if (!plan_.solids.empty()) record_.attributes[loads_of] = plan_.scene->hull ? "the hull" : "all solids";
        }
        record_.attributes["openfoam"] = openfoam_.vendor + " " + openfoam_.version;
        record_.attributes["openfoam_solver"] = openfoam_.command();
        record_.attributes["openfoam_self_test"] = openfoam_.verdict;
        record_.numbers["openfoam_self_test_error"] = openfoam_.self_test_error;
        if (!plan_.solids.empty()) record_.attributes["walls"] = plan_.walls;
        record_.attributes["restart"] = "not bitwise: after a restart of interFoam forces differ by about 0.1 %";
        record_.numbers["write_interval"] = plan_.write_interval;
        record_.numbers["raster_every"] = plan_.raster_every;
        record_.numbers["cell_far"] = plan_.background_cell;
        record_.numbers["cell_finest"] = plan_.finest_cell;
        if (!plan_.mesh_moves()) return;
        record_.attributes["mesh_motion"] = plan_.mesh_motion.sentence();
        if (!plan_.hull_release.empty()) record_.attributes["hull_release"] = plan_.hull_release;
        record_.numbers["body_relaxation"] = plan_.relaxation;
        record_.numbers["outer_correctors"] = plan_.outer_correctors;
    }

    void take_up(RunRecord earlier) {
        const auto said = [](const RunRecord& r, const char* name) {
            const auto found = r.attributes.find(name);
            return found == r.attributes.end() ? std::string() : found->second;
        };
        if (said(earlier, "method") != fvm_method || said(earlier, "hull_hash") != said(record_, "hull_hash"))
            throw InputError(record_file_.string() +
                             ": is not a record of this scene's hull and method; begin anew with --overwrite");
        const std::string begun_with = said(earlier, "openfoam");
        if (!begun_with.empty() && begun_with != openfoam_.vendor + " " + openfoam_.version)
            throw InputError(fmt::format(
                "{}: was begun with {}, which is not the OpenFOAM that is taken now ({} {}, "
                "{}); continue with the former, or begin anew with --overwrite",
                record_file_.string(), begun_with, openfoam_.vendor, openfoam_.version, openfoam_.command()));
        if (said(earlier, "run_hash") != said(record_, "run_hash"))
            throw InputError(record_file_.string() +
                             ": belongs to another scene (or the scene file was changed); put it back, or begin anew "
                             "with --overwrite");
        // Write times stay on their grid, even where the interval follows from a duration that has grown.
        if (const double interval = earlier.numbers["write_interval"]; interval > 0) {
            plan_.write_interval = interval;
            plan_.raster_every = static_cast<int>(std::lround(earlier.numbers["raster_every"]));
        }
        tw::take_up(std::move(earlier), record_);
    }

    Phase& phase(const std::string& name) {
        for (Phase& p : record_.phases)
            if (p.name == name) return p;
        return record_.phases.emplace_back(Phase{name});
    }
    void tell(double time, double wall, double eta, long steps, const std::string& note) const {
        if (options_.progress) options_.progress({time, plan_.scene->run.duration, wall, eta, steps, note, &record_});
    }
    bool stop_asked() const { return options_.stop_asked && options_.stop_asked(); }

    bool mesh(const CasePrograms& programs) {
        const double began = wall_clock();
        if (const auto full = disk_trouble(case_, 50e6)) throw RunError(*full);
        const auto ranks = [&](double cells) {
            if (!programs.has_mpi()) return 1;
            if (options_.threads > 0) return options_.threads;
            const int cores = static_cast<int>(std::thread::hardware_concurrency());
            return std::clamp(static_cast<int>(cells / cells_per_rank), 1, std::max(1, cores));
        };
        const MeshOutcome made = make_mesh(
            plan_, programs, ranks, [&](ChildProcess&) { return stop_asked(); },
            [&](const std::string& program) { tell(0, wall_clock() - began, 0, 0, "meshing: " + program); });
        record_.phases.clear();
        phase("meshing") = {"meshing", wall_clock() - began, made.cpu};
        record_.peak_memory = std::max(record_.peak_memory, made.peak_memory);
        if (made.stopped) return false;
        record_.elements = made.cells;
        record_.attributes["mesh_check"] = made.clean ? "Mesh OK" : made.check;
        write_record(record_file_, record_);
        write_text_atomically(meshed_mark(), "the mesh, its fields and its decomposition are complete\n");
        return true;
    }

    RunRecord solve_and_read(const CasePrograms& programs) {
        const TimeFolders folders(case_);
        const int ranks = static_cast<int>(folders.roots().size());
        record_.attributes["ranks"] = record_.attributes["threads"] = std::to_string(ranks);
        folders.prune(plan_.writes_at_steps ? 0 : plan_.write_interval);
        drop_behind_gaps(folders, programs.log("solver"));
        const auto moments = folders.moments();
        const double restart = moments.empty() ? 0 : moments.back().time;
        record_.rewind(restart * (1 + 1e-9));  // rounding of a time in the records
        folders.forget_output_after(restart);
        FrameReader reader(plan_, case_);
        record_.elements = static_cast<double>(reader.cells());
        if (!moments.empty()) reader.show_hull(moments.back(), record_);  // where nothing is left to be read
        if (plan_.plate_interval > 0) plate_.emplace(plan_, case_);

        if (moments.empty() && released_in_air(plan_) && !record_.numbers.contains(release_factor_name) &&
            !find_release(programs, ranks))
            return end("stopped", "stopped in the body's first steps, as asked; --resume begins them anew");

        const double began = wall_clock(), earlier_wall = phase("solving").wall, earlier_cpu = phase("solving").cpu;
        double saved = began;
        const double duration = plan_.scene->run.duration;
        const auto account = [&](double cpu_of_this_start) {
            Phase& p = phase("solving");
            p.wall = earlier_wall + wall_clock() - began;
            p.cpu = earlier_cpu + cpu_of_this_start;
            record_.steps = static_cast<double>(log_.steps().size());
        };
        SolverOutcome outcome;
        if (restart < duration * (1 - 1e-9)) {
            long first_steps = -1;
            const auto growing = [&] {
                const auto& steps = log_.steps();
                if (first_steps < 0) first_steps = static_cast<long>(steps.size());
                if (!steps.empty()) {
                    const auto& last = steps.back();
                    const double wall = wall_clock() - began, gone = last.time - restart;
                    const double eta = gone > 0 ? wall / gone * (duration - last.time) : 0;
                    tell(last.time, earlier_wall + wall, eta, static_cast<long>(steps.size()),
                         fmt::format("dt {:.2g} s, Courant {:.2g}", last.step, last.courant));
                    // The step under way has a later time: everything of the write times before it is on disk.
                    read_new(folders, reader, last.time * (1 - 1e-9));
                }
                if (wall_clock() - saved > save_interval) {
                    account(ranks * (steps.empty() ? 0 : steps.back().cpu));
                    save(folders);
                    saved = wall_clock();
                }
                return settled_.has_value() || stop_asked();
            };
            outcome =
                solve(plan_, programs, ranks, log_, growing, [&] { return water_trouble(record_, limits_of(plan_)); });
            account(outcome.process.cpu);
            record_.peak_memory = std::max(record_.peak_memory, ranks * outcome.process.peak_memory);
        } else {
            follow(programs.log("solver"), 0, log_);
            record_.steps = static_cast<double>(log_.steps().size());
        }
        read_new(folders, reader, 2 * duration);
        save(folders);
        if (!outcome.failure.empty()) throw RunError(outcome.failure);
        if (outcome.stopped && !settled_)
            return end("stopped", folders.moments().empty()
                                      ? fmt::format("stopped as asked before its first write time ({:.4g} s), so that "
                                                    "nothing could be saved: --resume begins at t = 0",
                                                    plan_.write_interval)
                                      : "stopped as asked; --resume continues from the last write time");
        if (const auto gap = first_gap(plan_, log_, record_, settled_.value_or(duration)))
            throw RunError(
                fmt::format("{}: the solver's tables are not whole: {}; often the disk was full for a while; --resume "
                            "computes anew "
                            "from the last saved state before that",
                            (case_ / "postProcessing").string(), gap->what));
        if (lacks_picture(plan_, record_))
            throw RunError((case_ / "postProcessing/hullSurface").string() +
                           ": the hull's pressure at the last write time is not there, and the run does not count as "
                           "finished without it; begin anew with --overwrite");
        return end("finished", note_end(*plan_.scene, record_, settled_));
    }

    /// False: a stop was asked for.
    bool find_release(const CasePrograms& programs, int ranks) {
        const double began = wall_clock();
        tell(0, 0, 0, 0, "first steps of the body, to find the speed of its release");
        const auto factor = release_factor(plan_, programs, ranks, [&] { return stop_asked(); });
        phase("first steps") = {"first steps", wall_clock() - began, 0};
        if (!factor) return false;
        record_.numbers[release_factor_name] = *factor;
        write_record(record_file_, record_);
        release_with(*factor);
        return true;
    }
    void release_with(double factor) {
        plan_.release_factor = factor;
        for (const CaseFile& f : mesh_motion_files(plan_))
            if (f.path == "constant/dynamicMeshDict") write_text_atomically(case_ / f.path, f.text);
    }

    /// Removes the time folders from the first gap on: a kill or a full disk can take rows and leave fields, and what
    /// is gone on from has to have its rows up to there.
    void drop_behind_gaps(const TimeFolders& folders, const fs::path& log_file) const {
        const auto moments = folders.moments();
        if (moments.empty()) return;
        SolverLog log;
        follow(log_file, 0, log);
        RunRecord left;
        left.attributes = record_.attributes;
        left.numbers = record_.numbers;
        left.tables = record_.tables;
        read_step_tables(plan_, case_, log, left);
        std::vector<double>&samples = left.table("samples").time, &forces = left.table("forces").time;
        const double read_to = samples.empty() ? 0 : samples.back() * (1 + 1e-9);
        for (const TimeFolders::Moment& m : moments) {
            if (m.time <= read_to) continue;
            samples.push_back(m.time);
            if (read_load(plan_, case_, read_walls(plan_, case_, m.name))) forces.push_back(m.time);
        }
        const auto gap = first_gap(plan_, log, left, moments.back().time);
        if (!gap) return;
        for (const TimeFolders::Moment& m : moments)
            if (m.time > gap->time * (1 - time_name_precision)) folders.remove(m);
    }

    /// Reads the write times that are not in the record yet and lie before `limit`, up to the one at which the run may
    /// end: what the solver has written behind that before it stopped is left to be read when the run is resumed.
    void read_new(const TimeFolders& folders, FrameReader& reader, double limit) {
        if (plate_) plate_->read_before(limit, record_);
        for (const TimeFolders::Moment& moment : folders.moments()) {
            const std::vector<double>& known = record_.table("samples").time;
            if (settled_) return;
            if (moment.time >= limit || (!known.empty() && moment.time <= known.back() * (1 + 1e-9)) ||
                !folders.whole(moment))
                continue;
            const double began = wall_clock(), cpu = own_cpu();
            reader.read(moment, log_, record_);
            if (moment.time < plan_.scene->run.duration * (1 - 1e-9) && may_end(*plan_.scene, record_))
                settled_ = moment.time;
            Phase& p = phase("reading");
            p.wall += wall_clock() - began;
            p.cpu += own_cpu() - cpu;
        }
    }

    /// Saves the record; only then are time folders that it holds removed, but for the last two and the kept pictures.
    void save(const TimeFolders& folders) {
        const double began = wall_clock(), cpu = own_cpu();
        read_step_tables(plan_, case_, log_, record_);
        if (settled_) record_.rewind(*settled_ * (1 + time_name_precision));
        write_record(record_file_, record_);
        const auto moments = folders.moments();
        const std::vector<double>& known = record_.table("samples").time;
        const double read_to = known.empty() ? 0 : known.back() * (1 + 1e-9);
        for (std::size_t i = 0; i + 2 < moments.size(); ++i) {
            if (moments[i].time > read_to) break;
            folders.remove(moments[i]);
            const long n = std::lround(moments[i].time / plan_.write_interval);
            const bool keep_picture = plan_.snapshot_every > 0 && n % plan_.snapshot_every == 0;
            std::error_code none;
            for (const char* surfaces : {"hullSurface", "bodySurfaces"})
                if (!keep_picture) fs::remove_all(case_ / "postProcessing" / surfaces / moments[i].name, none);
        }
        Phase& p = phase("reading");
        p.wall += wall_clock() - began;
        p.cpu += own_cpu() - cpu;
    }

    RunRecord end(const std::string& state, const std::string& reason) {
        record_.state = state;
        record_.reason = reason;
        add_one_way_strains(*plan_.scene, record_);
        write_record(record_file_, record_);
        return record_;
    }

    [[noreturn]] void fail(const std::string& why) {
        record_.state = "failed";
        record_.reason = why;
        std::string unsaved;
        try {
            write_record(record_file_, record_);
        } catch (const std::exception& e) {
            unsaved = std::string("\n  and the record could not be saved: ") + in_words(e);
        }
        throw RunError(why + unsaved);
    }

    static double own_cpu() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

    const RunOptions& options_;
    fs::path case_, record_file_;
    CasePlan plan_;
    OpenFoam openfoam_;
    RunRecord record_;
    SolverLog log_;
    std::optional<PlatePressures> plate_;
    std::optional<double> settled_;  // when the loads had [s]
};

}  // namespace

RunRecord run_fvm(const Scene& scene, const RunOptions& options) {
    refuse_unmeshable(scene);
    const OpenFoam openfoam = openfoam_for(scene);
    const FolderLock lock(options.folder);
    return FvmRun(scene, options, openfoam).run();
}

}  // namespace tw
