#pragma once
#include <string>
#include <vector>

#include "app/runs/run_method.h"
#include "compare/compare.h"
#include "compare/grid_study/grid_study.h"
#include "foam_cases/doctor.h"
#include "meshes/health.h"
#include "meshes/mass_properties.h"
#include "scene/scene.h"
#include "sph_solver/bench.h"

namespace tw::app {

// The facts of each subcommand for programs; keys may be added, they keep their names.

struct RanksTake;
std::string check_json(const Scene& scene, const Prediction& prediction, const RanksTake& ranks);

struct HullFacts {
    std::string source, hash;
    std::size_t points = 0, triangles = 0;
    Box bounds;
    MassProperties mass;
    std::vector<Finding> findings;
    std::vector<std::string> repairs;
    std::vector<std::vector<std::string>> solids;  ///< the names of each, see meshes/read/named_solid.h
    bool usable = false;
};
std::string hull_json(const HullFacts& facts);

struct MachineFacts {
    std::string version, built_with, processor, isa, mpirun, gpu;
    std::string gpu_reason;   ///< why particles cannot run on a GPU here; empty: they can, and what follows is known
    std::string gpu_verdict;  ///< of its self-test
    double gpu_error = 0;     ///< of that, see gpu_self_test [-]
    double gpu_pace = 0;      ///< as calibrate_gpu_pace [-]
    std::vector<std::string> compilers;
    unsigned cores = 0;
    double memory = 0;  ///< [bytes]
    double pace = 1;    ///< of the particle engine [-], see machine_pace.h
    std::vector<PassesPace> passes;
    std::string chosen_passes;
    std::vector<OpenFoam> openfoam;
    bool sound = false;
};
/// "avx512_16 4.1, avx512 3.2 million evaluations/s", the fastest first.
std::string passes_line(std::vector<PassesPace> paces);
std::string doctor_json(const MachineFacts& facts);
/// The finished runs, where there is nothing to compare.
std::string runs_json(const std::vector<RunFacts>& runs);
/// The facts of the comparison, and beside them `runs` and, where there is one, `ladder`.
std::string run_json(const Comparison& comparison, const std::vector<RunFacts>& runs,
                     const GridStudy* grid_study = nullptr);
std::string bench_json(const BenchResult& result, const std::vector<PassesPace>& passes);

}  // namespace tw::app
