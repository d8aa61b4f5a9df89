#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tw {

/// One OpenFOAM installation and what the self-test says of its interFoam.
struct OpenFoam {
    std::filesystem::path project_dir;   ///< WM_PROJECT_DIR
    std::filesystem::path solver;        ///< the interFoam program (or foamRun)
    std::filesystem::path bin;           ///< of blockMesh, snappyHexMesh, ...
    std::string version, vendor;         ///< "v1912", "openfoam.com"
    bool sound = false;                  ///< exact answer of the self-test reproduced
    double self_test_error = 0;          ///< [m/s], of 0.1
    std::string verdict;                 ///< one line for people
};

/// All that are here, sound or not: the mended solvers of twinwake's own folder, the environment, the usual places.
std::vector<OpenFoam> find_openfoam(const std::string& preferred = {});
/// The first sound one; throws InputError that names the faulty ones and says what to install or run.
OpenFoam sound_openfoam(const std::string& preferred = {});
/// A full pipe of water, turned about two axes, pushed from rest: exact answer 0.1 m/s along the pipe.
void self_test(OpenFoam& candidate);

}  // namespace tw
