#include "app/solvers.h"

#include <algorithm>
#include <functional>
#include <stdexcept>

#include "app/machine_pace.h"
#include "foam_cases/doctor.h"
#include "foam_cases/run_fvm.h"
#include "scene/cores_of_particles.h"
#include "sph_solver/on_gpu.h"
#include "sph_solver/run_sph.h"

namespace tw::app {
namespace {

std::string openfoam_line(const Scene& scene) { return "OpenFOAM: " + openfoam_for(scene).verdict + "\n"; }

Prediction predict_all(const Scene& scene, const std::function<double(const std::string& method)>& pace) {
    std::vector<CostOf> costs;
    for (const Solver& s : solvers()) costs.push_back({s.method, s.predict, pace(s.method)});
    return predict(scene, costs);
}

}  // namespace

const std::vector<Solver>& solvers() {
    static const std::vector<Solver> rows{
        {.method = "sph",
         .predict = predict_particles,
         .run = run_sph,
         .state = "checkpoint.h5",
         .refuse = refuse_on_gpu,
         .ready = gpu_line},
        {.method = "fvm",
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

std::string pace_of(const Scene& scene, const std::string& method) {
    if (method != "sph" || scene.run.device == "cpu" || !why_not_on_gpu(scene).empty() || !why_no_gpu_here().empty())
        return method;
    return pace_on_gpu(method);
}

std::string pace_on_gpu(const std::string& method) { return method + " on " + gpu_name(); }

double cores_of_pace(const Scene& scene, const std::string& method) {
    return pace_of(scene, method) == method ? 1 : cores_of_particles(scene);
}

Prediction predict_here(const Scene& scene) {
    return predict_all(scene, [&](const std::string& method) {
        const std::string pace = pace_of(scene, method);
        if (pace != method && !knows_pace(pace)) calibrate_gpu_pace(pace);
        return machine_pace(pace) * cores_of_pace(scene, method);
    });
}

Prediction predict_by_table(const Scene& scene) {
    return predict_all(scene, [](const std::string&) { return 1.0; });
}

std::string ready_text(const std::vector<std::string>& methods, const Scene& scene) {
    std::string text;
    for (const std::string& method : methods)
        if (const Solver& solver = solver_of(method); solver.ready) text += solver.ready(scene);
    return text;
}

}  // namespace tw::app
