#include "app/runs/run_method.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <cstdlib>

#include "app/arguments/output.h"
#include "app/pace/machine_pace.h"
#include "app/progress/overdue.h"
#include "app/progress/run_teller.h"
#include "app/runs/solvers.h"
#include "app/terminal/progress_bar.h"
#include "app/terminal/stop_signal.h"
#include "base/in_words.h"
#include "compare/report/numbers.h"
#include "foam_cases/run/child.h"
#include "methods/methods.h"
#include "record/this_machine.h"
#include "scene/cost/node.h"
#include "scene/cost/program_memory.h"
#include "sph_solver/parallel/comm.h"
#include "text/plain_number.h"

namespace tw::app {
namespace {

/// This machine; of those that mpirun has started ranks on, the smallest memory and the most ranks.
Node node_of(const RunRequest& request, const Scene& scene) {
    if (request.elsewhere) return {.memory = {}};
    const Comm& ranks = Comm::world();
    if (!ranks.many()) return {.ranks = scene.run.ranks};
    return {.memory = -ranks.largest(-machine_memory()), .ranks = static_cast<int>(ranks.largest(ranks.size_here()))};
}

/// Whether other programs leave this one, and those that it starts, the processors it works with.
class Share {
public:
    bool left(double threads) const {
        const double wall = wall_clock() - wall_, others = processor_time_of_all() - all_ - (own() - own_);
        constexpr double play = 0.1;  // of the machine
        return !(others > ((1 + play) * processors_online() - threads) * wall);
    }

private:
    static double own() {
        double sum = 0;
        for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
            rusage used{};
            getrusage(who, &used);
            for (const timeval& t : {used.ru_utime, used.ru_stime}) sum += double(t.tv_sec) + 1e-6 * double(t.tv_usec);
        }
        return sum;
    }
    double wall_ = wall_clock(), all_ = processor_time_of_all(), own_ = own();
};

}  // namespace

PlannedRun plan_run(const RunRequest& request) {
    Scene scene = read_scene(request.file, request.overrides, request.numbers);
    if (request.method == every_method)
        scene.run.methods = method_names();
    else if (!request.method.empty())
        scene.run.methods = {request.method};
    if (request.threads > 0) scene.run.threads = request.threads;
    if (request.ranks > 0) scene.run.ranks = request.ranks;
    if (!request.snapshots) scene.sampling.snapshot_interval = -1;
    for (const std::string& m : scene.run.methods)
        if (const Solver& solver = solver_of(m); solver.refuse) solver.refuse(scene);
    const Prediction prediction = predict_here(scene);
    refuse_oversize(scene, prediction, node_of(request, scene));
    return {request, std::move(scene), prediction};
}

namespace {

RunRecord run_and_tell(const std::string& method, const Scene& scene, const RunOptions& options, RunTeller& teller) {
    try {
        RunRecord record = solver_of(method).run(scene, options);
        teller.end(record);
        return record;
    } catch (const std::exception& e) {
        teller.failed(in_words(e));
        throw;
    }
}

/// What the throughput table expects of the steps that a run made with the elements that it had, of `price`, a time of
/// the prediction [s]. Wrongly predicted steps are the scene's, not the machine's, and must not enter its pace. 0:
/// starting and meshing, whose cost hardly depends on the processor, take most of it, so that the run says little of
/// throughput.
double expected_of_work(const Scene& scene, const std::string& method, const RunRecord& record,
                        double MethodCost::*price) {
    Scene longer = scene;
    longer.run.duration *= 2;
    const MethodCost cost = predict_by_table(scene).of(method);
    const double stepping = predict_by_table(longer).of(method).*price - cost.*price;
    const double made = stepping * (record.steps / cost.steps) * (record.elements / cost.with_walls);
    const double beside = cost.*price - stepping;
    return made > beside ? beside + made : 0;
}

/// Processors are learned by the time that they worked, which other programs beside a run hardly change; a GPU, whose own
/// time nobody counts, by the clock. Ranks of MPI that wait for others count as working, so that with several of them
/// other programs do change it.
void learn_from(const RunRecord& record, const PlannedRun& plan, const std::string& method, const Share& share) {
    const Scene& scene = plan.scene;
    const PaceName pace = pace_of(scene, method, &plan.prediction);
    double wall = 0, processor = 0;
    for (const Phase& phase : record.phases) wall += phase.wall, processor += phase.cpu;
    const auto threads = record.attributes.find("threads");
    const int workers = threads == record.attributes.end() ? 1 : std::atoi(threads->second.c_str());
    if (pace.of_gpu)
        return learn_pace(pace.name, expected_of_work(scene, method, record, &MethodCost::seconds) * pace.cores, wall,
                          share.left(workers));
    const bool waits_working = solver_of(method).elements_per_rank > 0 && workers > 1;
    learn_pace(pace.name, expected_of_work(scene, method, record, &MethodCost::core_seconds), processor,
               !waits_working || share.left(workers));
}

}  // namespace

RunRecord run_method(const std::string& method, const PlannedRun& plan, const MethodRun& run, const Common& common) {
    const Scene& scene = plan.scene;
    RunOptions options;
    options.folder = run.folder;
    options.resume = run.resume;
    options.overwrite = run.overwrite;
    options.threads = scene.run.threads;
    const MethodCost& cost = plan.prediction.of(method);
    options.prediction = &plan.prediction;
    options.predicted_seconds = cost.seconds;
    options.predicted_core_seconds = cost.core_seconds;
    options.predicted_elements = cost.with_walls;
    options.predicted_bytes = all_bytes(scene, cost);
    options.predicted_steps = cost.steps;
    options.command = common.command;
    ProgressBar bar(method_label(method), common.quiet);
    RunTeller teller(run.folder, method, scene.sampling.mean_from, Comm::world().first());
    Overdue overdue(cost.seconds);
    options.progress = [&](const Progress& p) {
        bar.show(p);
        if (const std::string late = overdue.look(p); !late.empty()) {
            teller.warn(late);
            if (Comm::world().first()) complain("\n" + method_label(method) + ": " + late);
        }
        teller.progress(p);
        if (run.progress) run.progress(p);
    };
    options.stop_asked = stop_asked;
    const Share share;
    RunRecord record = run_and_tell(method, scene, options, teller);
    // what an effect costs is an estimate of its own, and air's is the roughest
    if (record.state == "finished" && !run.resume && scene.run.ranks == 1 && !scene.effect_on("air"))
        learn_from(record, plan, method, share);
    return record;
}

RunFacts facts_of(const std::string& method, const RunRecord& record, const std::filesystem::path& folder) {
    RunFacts f{method, record.state, record.reason, (folder / "record.h5").string(), record.elements, record.steps, 0};
    for (const Phase& phase : record.phases) f.wall += phase.wall;
    return f;
}

std::string closing_line(const RunFacts& f) {
    return fmt::format("{}{}, {} {}, {} steps, {}, {}\n", f.state, f.reason.empty() ? "" : ": " + f.reason,
                       plain_number(f.elements), elements_of(f.method), plain_number(f.steps), time_text(f.wall),
                       f.record);
}

}  // namespace tw::app
