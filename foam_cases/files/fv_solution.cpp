#include "foam_cases/files/case_files.h"
#include "scene/defaults.h"

namespace tw {
namespace {

/// Of interIsoFoam (Roenby, Bredmose & Jasak 2016, doi:10.1098/rsos.160405): planes through cells from the fraction at their
/// points; four parts of a step, as its author takes Courant numbers up to 0.5 in each.
Dictionary geometric_capture() {
    return {{"reconstructionScheme", Word("isoAlpha")},
            {"isoFaceTol", 1e-8},
            {"surfCellTol", 1e-8},
            {"nAlphaBounds", 3},
            {"snapTol", 1e-12},
            {"clip", true}};
}

}  // namespace

/// system/fvSolution. Semi-implicit MULES takes the water through steps of Courant number 4 and more.
std::string fv_solution(const CasePlan& plan) {
    const Box& box = plan.scene->domain.box;
    Dictionary alpha{{"nAlphaCorr", 1},
                     {"nAlphaSubCycles", plan.scene->fvm.captures_geometrically() ? 4 : 1},
                     {"MULESCorr", true},
                     {"nLimiterIter", hull_held_in_stream(*plan.scene) ? 3 : 8},
                     {"alphaApplyPrevCorr", !plan.mesh_moves()},
                     {"solver", Word("smoothSolver")},
                     {"smoother", Word("symGaussSeidel")},
                     {"tolerance", 1e-8},
                     {"relTol", 0},
                     {"minIter", 1}};
    if (!plan.flavour.compression_in_scheme())
        alpha.add({{"cAlpha", plan.scene->fvm.interface_compression},
                   {"icAlpha", 0}});  // 1 lets twice the air under a hull (measured)
    if (plan.scene->fvm.captures_geometrically()) alpha.add(geometric_capture());
    Dictionary solvers;
    const auto pressure_solver = [](double relative) {
        return Dictionary{
            {"solver", Word("GAMG")}, {"smoother", Word("DIC")}, {"tolerance", 1e-7}, {"relTol", relative}};
    };
    if (plan.mesh_motion.kind == MeshMotion::Kind::morphing && plan.moving().motion.law)
        solvers.add(
            Key::pattern("cellDisplacement.*"),
            Dictionary{
                {"solver", Word("GAMG")}, {"smoother", Word("GaussSeidel")}, {"tolerance", 1e-8}, {"relTol", 0}});
    // After each movement of a morphed mesh, as far as the pressure that follows (decision 032); else at the start alone.
    const double of_fluxes = plan.mesh_motion.kind == MeshMotion::Kind::morphing ? 0.01 : 1e-5;
    const Dictionary preconditioner{
        {"preconditioner", Word("GAMG")}, {"smoother", Word("GaussSeidel")}, {"tolerance", of_fluxes}, {"relTol", 0}};
    solvers.add(Key::pattern("alpha.water.*"), alpha);
    solvers.add(
        Key::pattern("pcorr.*"),
        Dictionary{
            {"solver", Word("PCG")}, {"preconditioner", preconditioner}, {"tolerance", of_fluxes}, {"relTol", 0}});
    const bool steady = hull_held_in_stream(*plan.scene);
    solvers.add("p_rgh", pressure_solver(steady ? 0.05 : 0.01));
    solvers.add("p_rghFinal", pressure_solver(steady ? 0.01 : 0.001));
    solvers.add(Key::pattern("(U|k|omega).*"), Dictionary{{"solver", Word("smoothSolver")},
                                                          {"smoother", Word("symGaussSeidel")},
                                                          {"nSweeps", 1},
                                                          {"tolerance", 1e-8},
                                                          {"relTol", 0.1},
                                                          {"minIter", 1}});
    Dictionary equations;
    equations.add(Key::pattern(".*"), 1);
    Dictionary pimple{{"momentumPredictor", plan.momentum_predictor},
                      {"nOuterCorrectors", plan.outer_correctors},
                      {"nCorrectors", plan.pressure_correctors},
                      {"nNonOrthogonalCorrectors", 0},
                      // asked for only where no side is open to the air: zero in the top corner
                      {"pRefPoint", Vec3(box.max - 0.01 * box.size())},
                      {"pRefValue", 0}};
    if (plan.mesh_moves())
        pimple.add(
            {{"moveMeshOuterCorrectors", true}, {"correctPhi", plan.mesh_motion.kind == MeshMotion::Kind::morphing}});
    return foam_file("dictionary", "fvSolution",
                     {{"solvers", solvers},
                      {"PIMPLE", pimple},
                      {"relaxationFactors", Dictionary{{"equations", equations}}},
                      {"cache", Dictionary{{"grad(U)", Word("true")}}}});
}

}  // namespace tw
