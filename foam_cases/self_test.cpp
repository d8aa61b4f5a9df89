#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "foam_cases/doctor.h"
#include "foam_cases/files/case_files.h"
#include "foam_cases/read/field_file.h"
#include "foam_cases/run/case_programs.h"
#include "foam_cases/run/temporary_folder.h"

namespace tw {
namespace fs = std::filesystem;

namespace {

constexpr double turn_z = 0.5, turn_x = 0.7;  // of the pipe [rad]
constexpr double push = 1000, rho = 1000, length = 1, duration = 0.1;
constexpr double exact_speed = push / rho / length * duration;  // 0.1 m/s: du/dt = dp / (rho L)
constexpr int pipe_steps = 10;
constexpr double zone_strength = 20, pressure_share = 0.5;  // of a zone [1/s]; of the push, with a zone

/// Velocity to which a zone has to draw the pipe for the same answer, by the solver's implicit Euler steps of dt:
///
///   u_n = (u_(n-1) + dt (a + gamma u_ref)) / (1 + gamma dt)
///
/// so that u_N = (u_ref + a / gamma) (1 - (1 + gamma dt)^-N).
double drawn_to() {
    const double a = pressure_share * push / rho / length;
    return exact_speed / (1 - std::pow(1 + zone_strength * duration / pipe_steps, -pipe_steps)) - a / zone_strength;
}

/// The pipe lies along x; it is turned about z, then about x.
Vec3 turned(const Vec3& p) {
    const Vec3 q(std::cos(turn_z) * p.x() - std::sin(turn_z) * p.y(),
                 std::sin(turn_z) * p.x() + std::cos(turn_z) * p.y(), p.z());
    return {q.x(), std::cos(turn_x) * q.y() - std::sin(turn_x) * q.z(),
            std::sin(turn_x) * q.y() + std::cos(turn_x) * q.z()};
}

std::string pipe_mesh() {
    List vertices;
    for (const double z : {0.0, 1.0})
        for (const auto& [x, y] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}})
            vertices.push_back(turned({x, y, z}));
    const auto side = [](const char* name, const char* type, const List& faces) {
        return Value::named(Word(name), Dictionary{{"type", Word(type)}, {"faces", faces}});
    };
    const List blocks{Value::sequence({Word("hex (0 1 2 3 4 5 6 7) (6 5 4) simpleGrading (1 1 1)")})};
    return foam_file(
        "dictionary", "blockMeshDict",
        {{"scale", 1},
         {"convertToMeters", 1},
         {"vertices", vertices},
         {"blocks", blocks},
         {"edges", List{}},
         {"boundary",
          List{side("inlet", "patch", {Word("(0 4 7 3)")}), side("outlet", "patch", {Word("(1 2 6 5)")}),
               side("sides", "wall", {Word("(0 1 5 4)"), Word("(3 7 6 2)"), Word("(0 3 2 1)"), Word("(4 5 6 7)")})}}});
}

std::string pipe_field(const char* foam_class, const char* name, const Dimensions& dimensions, const char* inside,
                       const Dictionary& inlet, const Dictionary& outlet, const Dictionary& sides) {
    return foam_file(foam_class, name,
                     {{"dimensions", dimensions},
                      {"internalField", Word(inside)},
                      {"boundaryField", Dictionary{{"inlet", inlet}, {"outlet", outlet}, {"sides", sides}}}});
}

/// The pipe's sides as a body that begins to cross the pipe, and takes the water along unless it is held throughout.
std::vector<CaseFile> held_pipe(const Flavour& flavour) {
    const Dictionary body{{"patches", List{Word("sides")}},
                          {"innerDistance", 10},  // the whole mesh
                          {"outerDistance", 20},
                          {"mass", 1},
                          {"centreOfMass", Vec3(Vec3::Zero())},
                          {"momentOfInertia", Vec3(Vec3::Ones())},
                          {"velocity", turned({0, 1, 0})},
                          {"solver", held_newmark(2 * duration, 0.5)}};
    const Dictionary still{{"type", Word("calculated")}, {"value", Word("uniform (0 0 0)")}};
    return {{"constant/dynamicMeshDict",
             foam_file("dictionary", "dynamicMeshDict",
                       flavour.motion_solver("sixDoFRigidBodyMotion", "sixDoFRigidBodyMotion", body))},
            {"0/pointDisplacement",
             pipe_field("pointVectorField", "pointDisplacement", metres, "uniform (0 0 0)", still, still, still)}};
}

std::string pipe_control(const Flavour& flavour, const std::vector<fs::path>& libraries) {
    Dictionary d{{"application", Word(flavour.solver_program())}};
    List libs;
    for (const fs::path& library : libraries)
        if (!library.empty()) libs.push_back(Quoted(library.string()));
    if (!libs.empty()) d.add("libs", libs);
    if (!flavour.solver_arguments().empty()) d.add("solver", Word(flavour.solver_arguments().back()));
    d.add({{"startFrom", Word("startTime")},
           {"startTime", 0},
           {"stopAt", Word("endTime")},
           {"endTime", duration},
           {"deltaT", duration / pipe_steps},
           {"writeControl", Word("timeStep")},
           {"writeInterval", pipe_steps},
           {"writeFormat", Word("ascii")},
           {"writePrecision", 12},
           {"writeCompression", Word("off")},
           {"runTimeModifiable", false},
           {"adjustTimeStep", false},
           {"maxCo", 1},
           {"maxAlphaCo", 1},
           {"maxDeltaT", 1}});
    return foam_file("dictionary", "controlDict", d);
}

std::vector<CaseFile> pipe_case(const OpenFoam& candidate) {
    const Flavour flavour = Flavour::from_version(candidate.vendor, candidate.version);
    const auto type = [](const char* name) { return Dictionary{{"type", Word(name)}}; };
    const auto fixed = [](double v) {
        return Dictionary{{"type", Word("fixedValue")}, {"value", Value::sequence({Word("uniform"), v})}};
    };
    const auto solver = [](const char* name, double tolerance) {
        Dictionary d{{"solver", Word(name)}, {"tolerance", tolerance}, {"relTol", 0}};
        return std::string(name) == "PCG" ? d.add("preconditioner", Word("DIC"))
                                          : d.add("smoother", Word("symGaussSeidel"));
    };
    Scene scene;
    scene.water.kinematic_viscosity = scene.water.air_kinematic_viscosity = 0;
    scene.water.air_density = 1;
    scene.water.gravity = 0;
    scene.fvm.interface_compression = 1;
    CasePlan plan;
    plan.scene = &scene;
    plan.flavour = flavour;
    const bool lets_go = !candidate.wall_library.empty(), absorbs = !candidate.zone_library.empty(),
               holds = !candidate.hold_library.empty();
    const std::string moving = flavour.moving_wall(lets_go);  // where it is the library's own it is tried in any case
    const Dictionary moving_sides{{"type", Word(moving)}, {"value", Word("uniform (0 0 0)")}};

    // what interFoam reads, and beside it what interIsoFoam does
    Dictionary alpha{{"nAlphaCorr", 1},    {"nAlphaSubCycles", 1},
                     {"MULESCorr", false}, {"nLimiterIter", 3},
                     {"isoFaceTol", 1e-8}, {"surfCellTol", 1e-8},
                     {"nAlphaBounds", 3},  {"snapTol", 1e-12},
                     {"clip", true},       {"reconstructionScheme", Word("isoAlpha")}};
    if (!flavour.compression_in_scheme()) alpha.add("cAlpha", 1);  // openfoam.org 13 refuses it
    alpha.add(solver("smoothSolver", 1e-8));
    Dictionary solvers;
    solvers.add(Key::pattern("alpha.water.*"), alpha);
    solvers.add(Key::pattern("pcorr.*"), solver("PCG", 1e-10));
    solvers.add(Key::pattern("p_rgh.*"), solver("PCG", 1e-12));
    solvers.add(Key::pattern("U.*"), solver("smoothSolver", 1e-10));
    const Dictionary pimple{
        {"momentumPredictor", false}, {"nOuterCorrectors", 1}, {"nCorrectors", 2}, {"nNonOrthogonalCorrectors", 0}};

    std::vector<CaseFile> files{
        {"system/blockMeshDict", pipe_mesh()},
        {"system/controlDict",
         pipe_control(flavour, {candidate.wall_library, candidate.zone_library, candidate.hold_library})},
        {"system/fvSchemes", fv_schemes(plan)},
        {"system/fvSolution", foam_file("dictionary", "fvSolution", {{"solvers", solvers}, {"PIMPLE", pimple}})},
        {"constant/g", gravity_file(plan)},
        {"constant/" + flavour.turbulence_file(), turbulence_file(plan)},
        {"0/U",
         pipe_field("volVectorField", "U", velocity, "uniform (0 0 0)", type("zeroGradient"), type("zeroGradient"),
                    holds || moving != flavour.moving_wall(false) ? moving_sides : type("slip"))},
        {"0/alpha.water", pipe_field("volScalarField", "alpha.water", dimensionless, "uniform 1", fixed(1),
                                     type("zeroGradient"), type(lets_go ? "ventilatedWallFraction" : "zeroGradient"))},
        {"0/p_rgh",
         pipe_field("volScalarField", "p_rgh", pressure, "uniform 0", fixed(absorbs ? pressure_share * push : push),
                    fixed(0), type(lets_go ? "ventilatedWallPressure" : "zeroGradient"))},
    };
    for (CaseFile& f : phase_files(plan)) files.push_back(std::move(f));
    if (holds)
        for (CaseFile& f : held_pipe(flavour)) files.push_back(std::move(f));
    if (absorbs)  // from beyond the pipe's corners on, which lie within 2 m of the origin
        files.push_back(
            {"constant/" + flavour.sources_file(),
             forcing_zones_file(flavour, {drawn_to() * turned({1, 0, 0}), {{0, true, -4, -3, zone_strength}}})});
    return files;
}

double largest_error(const fs::path& case_folder) {
    const FieldFile u = read_field(case_folder / "0.1" / "U");
    const Vec3 exact = exact_speed * turned({1, 0, 0});
    double error = 0;
    for (std::size_t i = 0; i < u.cells(); ++i) {
        const double here = (u.vector(i) - exact).norm();
        error = std::isfinite(here) ? std::max(error, here) : std::numeric_limits<double>::infinity();
    }
    return error;
}

void flow_through_pipe(OpenFoam& candidate) {
    candidate.sound = false;
    candidate.self_test_error = std::nan("");
    try {
        const Flavour flavour = Flavour::from_version(candidate.vendor, candidate.version);
        const TemporaryFolder folder;
        for (const char* part : {"system", "constant", "0"}) fs::create_directories(folder.path / part);
        for (const CaseFile& f : pipe_case(candidate)) write_text_atomically(folder.path / f.path, f.text);
        const CasePrograms programs(candidate, folder.path);
        // A solver that hangs is no sound one. It takes a fifth of a second; a container or a busy machine takes longer.
        constexpr double most = 120;  // [s]
        const double until = wall_clock() + most;
        const Watch patience = [&](ChildProcess&) { return wall_clock() > until; };
        const bool done = programs.run("blockMesh", {}, patience).ok() &&
                          programs.run(candidate.solver, flavour.solver_arguments(), patience, "solver").ok();
        if (!done) throw RunError(fmt::format("it did not end within {:g} s", most));
        candidate.self_test_error = largest_error(folder.path);
        candidate.sound = candidate.self_test_error < 1e-4;
        const char* judged = candidate.sound
                                 ? "sound"
                                 : "FAULTY (miscompiled: velocities are wrong on meshes that are not axis-aligned)";
        candidate.verdict = fmt::format(
            "{} {}, {}: error {:.2g} m/s in a flow of {:g} m/s; walls {}; forcing zones {}; a free hull is {}",
            candidate.vendor, candidate.version, judged, candidate.self_test_error, exact_speed,
            candidate.wall_library.empty() ? "hold water under tension" : "allow separation",
            candidate.zone_library.empty() ? "are missing" : "absorb waves",
            candidate.hold_library.empty() ? "free at once" : "held until its release");
    } catch (const std::exception& e) {
        candidate.verdict = fmt::format("{} {}, unusable: {}", candidate.vendor, candidate.version, e.what());
    }
}

}  // namespace

void self_test(OpenFoam& candidate) {
    constexpr std::array libraries{&OpenFoam::wall_library, &OpenFoam::zone_library, &OpenFoam::hold_library};
    const OpenFoam found = candidate;
    flow_through_pipe(candidate);
    const bool alone = std::ranges::all_of(libraries, [&](const auto library) { return (found.*library).empty(); });
    if (candidate.sound || alone) return;
    for (const auto library : libraries) candidate.*library = fs::path();
    flow_through_pipe(candidate);
    if (!candidate.sound) return;
    // some library spoils the answer: each is used with which it stays right
    for (const auto library : libraries) {
        OpenFoam with = candidate;
        with.*library = found.*library;
        if ((with.*library).empty()) continue;
        flow_through_pipe(with);
        if (with.sound) candidate = with;
    }
}

}  // namespace tw
