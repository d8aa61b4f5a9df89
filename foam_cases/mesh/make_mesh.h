#pragma once
#include "foam_cases/case_plan.h"
#include "foam_cases/run/case_programs.h"

namespace tw {

struct MeshOutcome {
    bool stopped = false;             ///< the watch asked for it
    double cells = 0;                 ///< [-]
    bool clean = true;                ///< checkMesh said "Mesh OK"
    std::string check;                ///< else what it found
    double cpu = 0, peak_memory = 0;  ///< [s], [bytes]
    int ranks = 1;
};

/// blockMesh, surface features, snappyHexMesh, extrudeMesh and createPatch where a flat mesh is refined, checkMesh,
/// renumberMesh, fields of 0, water, cell centres and volumes, decomposition. Where a wedge of a cell is left at an
/// edge across the stream, the background mesh is moved along x by quarters of a cell of that edge, and the best of
/// four places kept. `ranks_for` decides by the number of cells. `starting` hears the name of each program. Throws
/// RunError when one fails.
MeshOutcome make_mesh(const CasePlan& plan, const CasePrograms& programs,
                      const std::function<int(double cells)>& ranks_for, const Watch& watch,
                      const std::function<void(const std::string&)>& starting);

}  // namespace tw
