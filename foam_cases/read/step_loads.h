#pragma once
#include <array>
#include <filesystem>
#include <vector>

namespace tw {

/// Pressure and viscous parts (and their moments) from the `forces` function object, in the order force x y z [N],
/// moment x y z [N m], in the case's own axes.
struct StepLoads {
    std::vector<double> time;                              ///< [s]
    std::vector<std::array<double, 6>> pressure, viscous;  ///< one for each time [N, N m]
};

/// Reads the loads of one function object (`folder`: postProcessing/<its name>), the solver's starts joined; times that
/// have a force and no moment, or the reverse, are left out. Empty where there is nothing to read.
/// openfoam.com: force.dat and moment.dat, each total, pressure, viscous. openfoam.org: forces.dat with ((pressure)
/// (viscous)) ((pressure) (viscous)), porous parts behind in some releases.
StepLoads read_loads(const std::filesystem::path& folder);

}  // namespace tw
