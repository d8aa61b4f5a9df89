#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace tw {

/// One OpenFOAM installation and what the self-test says of its interFoam.
struct OpenFoam {
    std::filesystem::path project_dir;   ///< WM_PROJECT_DIR
    std::filesystem::path solver;        ///< the interFoam program (or foamRun)
    std::filesystem::path bin;           ///< of blockMesh, snappyHexMesh, ...
    std::filesystem::path wall_library;  ///< of walls that let water go (foam_cases/ventilated_wall); empty: none
    std::filesystem::path zone_library;  ///< of zones that absorb waves (foam_cases/forcing_zones); empty: none
    std::filesystem::path hold_library;  ///< that holds a hull until its release (foam_cases/held_body); empty: none
    std::vector<std::string> prefix;     ///< before each program ($TWINWAKE_OPENFOAM_PREFIX): a container's command
    std::string version, vendor;         ///< "v1912", "openfoam.com"
    bool loaded = false;                 ///< its environment is the caller's: WM_PROJECT_DIR
    bool sound = false;                  ///< exact answer of the self-test reproduced
    double self_test_error = 0;          ///< [m/s], of 0.1; NaN: the test did not come to an answer
    std::string verdict;                 ///< one line for people
    /// Of the solver: the prefix and the program.
    std::string command() const {
        std::string words;
        for (const std::string& word : prefix) words += word + " ";
        return words + solver.string();
    }
};

/// openfoam.com numbers its releases by year and month with a v, openfoam.org simply counts.
inline std::string vendor_of(const std::string& version) {
    return version.starts_with('v') ? "openfoam.com" : "openfoam.org";
}

}  // namespace tw
