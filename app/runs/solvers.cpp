#include "app/runs/solvers.h"

#include <algorithm>
#include <functional>
#include <stdexcept>

#include "app/pace/machine_pace.h"
#include "foam_cases/doctor.h"
#include "foam_cases/run_fvm.h"
#include "methods/methods.h"
#include "methods/names.h"
#include "scene/particles/cores_of_particles.h"
#include "sph_solver/on_gpu.h"
#include "sph_solver/run_sph.h"

namespace tw::app {
namespace {

std::string openfoam_line(const Scene& scene, const Prediction*) {
    return "OpenFOAM: " + openfoam_for(scene).verdict + "\n";
}

/// `pace`: of what a name stands for.
Prediction predict_all(const Scene& scene, const std::function<double(const PaceName&)>& pace) {
    Prediction p = predict_sizes(scene);
    for (const Solver& s : solvers()) {
        const PaceName name = pace_of(scene, s.method, &p);
        add_cost(p, scene, {s.method, s.predict, pace(name)});
        if (name.of_gpu) p.costs.back().core_seconds = 0;
    }
    return p;
}

}  // namespace

const std::vector<Solver>& solvers() {
    static const std::vector<Solver> rows{
        {.method = sph_method,
         .predict = predict_particles,
         .run = run_sph,
         .state = "checkpoint.h5",
         .ready = gpu_line},
        {.method = fvm_method,
         .predict = predict_cells,
         .run = run_fvm,
         .elements_per_rank = cells_per_rank,
         .state = "case",
         .refuse = refuse_unmeshable,
         .ready = openfoam_line},
    };
    return rows;
}

const Solver& solver_of(const std::string& method) {
    const auto row = std::ranges::find(solvers(), method_named(method).name, &Solver::method);
    if (row == solvers().end()) throw std::logic_error("nothing runs the method " + method);
    return *row;
}

std::vector<std::string> method_choices() {
    std::vector<std::string> words = method_names();
    words.emplace_back(every_method);
    return words;
}

PaceName pace_of(const Scene& scene, const std::string& method, const Prediction* sizes) {
    const bool of_gpu =
        method == sph_method && (scene.run.device == "gpu" ? !gpu_name().empty() : gpu_wanted(scene, sizes));
    if (!of_gpu) return {method};
    return {pace_on_gpu(method), true, cores_of_particles(scene)};
}

std::string pace_on_gpu(const std::string& method) { return method + " on " + gpu_name(); }

Prediction predict_here(const Scene& scene) {
    return predict_all(scene, [&](const PaceName& pace) {
        if (pace.of_gpu && !knows_pace(pace.name)) calibrate_gpu_pace(pace.name);
        return machine_pace(pace.name) * pace.cores;
    });
}

Prediction predict_by_table(const Scene& scene) {
    return predict_all(scene, [](const PaceName&) { return 1.0; });
}

std::string ready_text(const std::vector<std::string>& methods, const Scene& scene, const Prediction* sizes) {
    std::string text;
    for (const std::string& method : methods)
        if (const Solver& solver = solver_of(method); solver.ready) text += solver.ready(scene, sizes);
    return text;
}

}  // namespace tw::app
