#include <fmt/format.h>

#include "foam_cases/files/case_files.h"
#include "scene/box/tank_wave.h"

namespace tw {

/// ./Allrun, for running the case by hand. Every word of it is the program's own; nothing of the scene goes in but the
/// number of ranks.
std::string allrun_script(const CasePlan& plan, int ranks) {
    const Flavour& f = plan.flavour;
    std::string solver = "${SOLVER:-" + plan.solver_program() + "}";
    std::string arguments;
    for (const std::string& a : f.solver_arguments()) arguments += " " + a;
    std::string mesh;
    if (plan.snappy) {
        if (!plan.solids.empty()) mesh += fmt::format("    {0} > log.{0}\n", f.surface_features_program());
        mesh += "    snappyHexMesh -overwrite > log.snappyHexMesh\n";
        if (plan.extrude) mesh += "    extrudeMesh > log.extrudeMesh\n    createPatch -overwrite > log.createPatch\n";
    }
    return fmt::format(R"(#!/bin/sh
# ./Allrun            meshes and starts
# ./Allrun continue   continues from the last time folder
# NP=2 ./Allrun       on two processors
# SOLVER=/path/to/{0} ./Allrun   with another build of the solver ("twinwake doctor" tells which ones are sound)
cd "${{0%/*}}" || exit 1
NP=${{NP:-{1}}}
set -e
if [ "$1" != continue ]; then
    rm -rf 0 [1-9]* 0.[0-9]* processor* postProcessing log.*
    blockMesh > log.blockMesh
{2}    checkMesh > log.checkMesh
    grep -q "Mesh OK" log.checkMesh || echo "Allrun: checkMesh found something, see log.checkMesh"
    renumberMesh -overwrite > log.renumberMesh
    cp -r 0.orig 0
    setFields > log.setFields
    [ "$NP" = 1 ] || decomposePar > log.decomposePar
fi
rm -f stop
if [ "$NP" = 1 ]; then "{3}"{4} >> log.solver 2>&1
else mpirun -np "$NP" --bind-to none --mca mpi_yield_when_idle 1 "{3}"{4} -parallel >> log.solver 2>&1
fi
)",
                       plan.solver_program(), ranks, mesh, solver, arguments);
}

std::string case_readme(const CasePlan& plan) {
    const CasePlan& p = plan;
    std::string title;
    for (const char c : p.scene->title) title += c >= ' ' && c != 127 ? c : ' ';
    return fmt::format(
        R"({0}
OpenFOAM case written by twinwake for {1} {2} ({3}).

  ./Allrun             mesh and run from the start
  ./Allrun continue    continue from the last time folder
  touch stop           end a running solver after it has written its state

Still water is z = 0, x points to the stern. Background cells {4:.6g} m, finest cells {5:.6g} m.
{6}{7}{9}
postProcessing/forces      water and air together on the hull, in a tank without one on all solids{8}, every step
postProcessing/hullSurface pressure and water fraction on the hull at the write times (ParaView opens the .vtp files);
                           bodySurfaces: the same of each other solid
postProcessing/fastest     largest velocity, every step: 1.3 to 1.6 times the stream is normal

A restart does not continue bit by bit: forces differ by about 0.1 % afterwards, because interFoam does not store its last
compression correction.
)",
        title, p.flavour.vendor_name(), p.flavour.version_name(), p.solver_program(), p.background_cell, p.finest_cell,
        p.viscous ? (p.turbulent ? "Viscous and turbulent: k-omega SST with wall functions.\n" : "Viscous, laminar.\n")
                  : "Slip on all solids: the counterpart of an SPH run without physical viscosity.\n",
        p.scene->hull && p.scene->hull->half ? "Half model: multiply fx, fz and my by two.\n" : "",
        p.scene->hull && p.scene->hull->half ? " (half model)" : "",
        begins_with_wave(*p.scene)
            ? "twinwake starts this case with the wave in the tank; ./Allrun starts it with still water.\n"
            : "");
}

}  // namespace tw
