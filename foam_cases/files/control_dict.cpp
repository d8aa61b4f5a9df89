#include "foam_cases/files/case_files.h"
#include "meshes/query.h"
#include "scene/new_record.h"

namespace tw {
namespace {

Dictionary every_step() { return {{"log", false}, {"writeControl", Word("timeStep")}, {"writeInterval", 1}}; }
/// An interval of its own would be counted from the time of a restart.
Dictionary every_write(int nth = 1) {
    return {{"log", false}, {"writeControl", Word("writeTime")}, {"writeInterval", nth}};
}

/// Pressure and viscous force of water and air together on a body that moves, or on several solids, every step.
Dictionary forces(const CasePlan& plan, const List& patches) {
    Dictionary d{{"type", Word("forces")},
                 {"libs", plan.flavour.library("forces")},
                 {"patches", patches},
                 {"rho", Word("rho")},  // the solver's own density field
                 {"CofR", moment_reference(*plan.scene)}};
    return d.add(every_step());
}

/// Place, attitude and velocity of a free body, every step.
Dictionary body_state(const CasePlan& plan) {
    Dictionary d{{"type", Word("sixDoFRigidBodyState")},
                 {"libs", plan.flavour.library("sixDoFRigidBodyState")},
                 {"angleFormat", Word("radians")},
                 {"writePrecision", 14}};
    return d.add(every_step());
}

/// Where the cells of a mesh that moves are, and how large.
Dictionary cells_now(const CasePlan& plan, const char* type) {
    Dictionary d{{"type", Word(type)}, {"libs", plan.flavour.library("fieldFunctionObjects")}};
    return d.add(every_write());
}

Dictionary fastest(const CasePlan& plan) {
    Dictionary d{{"type", Word(plan.flavour.field_extremes() ? "fieldMinMax" : "volFieldValue")},
                 {"libs", plan.flavour.library("fieldFunctionObjects")},
                 {"fields", List{Word("U")}}};
    if (plan.flavour.field_extremes()) {
        d.add({{"mode", Word("magnitude")}, {"location", true}});
    } else {  // in all cells: asked for by one key from 11 on, by `regionType` before
        d.add({{"operation", Word("maxMag")},
               {plan.flavour.cell_selection(), Word("all")},
               {"regionType", Word("all")},
               {"writeFields", false}});
    }
    return d.add(every_step());
}

Dictionary wall_shear(const CasePlan& plan) {
    List patches;
    for (const Solid& s : plan.solids) patches.push_back(Word(s.name));
    return {{"type", Word("wallShearStress")},
            {"libs", plan.flavour.library("fieldFunctionObjects")},
            {"patches", patches},
            {"log", false},
            {"writeControl", Word("none")}};  // a field for the surfaces below, never a file of its own
}

Dictionary surface_output(const CasePlan& plan, const List& fields, const List& surfaces, const Dictionary& when) {
    Dictionary d{{"type", Word("surfaces")}, {"libs", plan.flavour.library("sampling")}};
    d.add(when);
    d.add({{"surfaceFormat", Word("vtk")},
           {"formatOptions",
            Dictionary{{"vtk", Dictionary{{"format", Word("binary")}, {"legacy", false}, {"precision", 7}}}}},
           {"interpolationScheme", Word("cellPoint")},
           {"fields", fields},
           {"surfaces", surfaces}});
    return d;
}

/// The faces of a patch as they are.
Dictionary faces_of(const std::string& patch) {
    return {{"type", Word("patch")}, {"patches", List{Word(patch)}}, {"interpolate", false}, {"triangulate", false}};
}

/// What a load on the faces is made of.
List load_fields(const CasePlan& plan) {
    List fields{Word("p"), Word("alpha.water")};
    if (plan.viscous) fields.push_back(Word("wallShearStress"));
    return fields;
}

Dictionary hull_surface(const CasePlan& plan) {
    return surface_output(plan, load_fields(plan), {Value::named(Word("hull"), faces_of("hull"))}, every_write());
}

/// Of obstacles and bodies, for the water's load and the suction on them (read/frame_reader.h).
Dictionary body_surfaces(const CasePlan& plan) {
    List surfaces;
    for (const Solid& s : plan.solids)
        if (!s.is_hull) surfaces.push_back(Value::named(Word(s.name), faces_of(s.name)));
    return surface_output(plan, load_fields(plan), surfaces, every_write());
}

/// The rigid counterpart of an elastic plate, for the strains (one_way.h).
Dictionary plate_surface(const CasePlan& plan) {
    const Dictionary when{{"log", false}, {"writeControl", Word("runTime")}, {"writeInterval", plan.plate_interval}};
    return surface_output(plan, {Word("p"), Word("alpha.water")},
                          {Value::named(Word("plate"), faces_of(plan.bodies.at(0).patch))}, when);
}

Dictionary free_surface(const CasePlan& plan) {
    const Dictionary iso{{"type", Word(plan.flavour.iso_surface())},
                         {"isoField", Word("alpha.water")},
                         {"isoValue", 0.5},
                         {"interpolate", true},
                         {"regularise", true}};
    return surface_output(plan, {Word("U")}, {Value::named(Word("freeSurface"), iso)},
                          every_write(plan.snapshot_every));
}

Dictionary probes(const CasePlan& plan, const List& fields, const std::vector<Vec3>& places, const char* interpolation,
                  bool in_cells_of_the_start = false) {
    List points;
    for (const Vec3& p : places) points.push_back(p);
    Dictionary d{{"type", Word("probes")}, {"libs", plan.flavour.library("sampling")}};
    d.add(every_step());
    d.add({{"fields", fields},
           {"fixedLocations", !in_cells_of_the_start},
           {"interpolationScheme", Word(interpolation)},
           {"probeLocations", points}});
    return d;
}

/// Whether the cells at these places stay where they are, but for a fiftieth of the body's way, while the mesh follows a
/// free body. OpenFOAM seeks the cells of fixed places again, by a tree of all cells, each time that the mesh has moved:
/// in every outer corrector, for twice the time of all else (decision 032).
bool cells_stay(const CasePlan& plan, const std::vector<Vec3>& places) {
    if (plan.mesh_motion.kind != MeshMotion::Kind::morphing || plan.moving().motion.law) return false;
    // half the size of a cell away its corners still move, and OpenFOAM's distances are those between points
    const double most = plan.mesh_motion.follows_by(0.02) + 1.5 * plan.background_cell;
    for (const Solid& solid : plan.solids) {
        if (!solid.moves) continue;
        const SurfaceQuery surface(solid.surface);
        for (const Vec3& place : places)
            if (surface.nearest(place, most).triangle >= 0) return false;
    }
    return true;
}

/// No step is longer than a fiftieth of the time since the release, nor need be shorter than the first cap (release.cpp).
Dictionary largest_step_by_table(const CasePlan& plan) {
    const auto &first = plan.step_caps.front(), &last = plan.step_caps.back();
    const List rows{List{0, first.step}, List{first.until / 2, first.step}, List{last.until, 2 * last.step}};
    return {{"type", Word("fluidMaxDeltaT")},
            {"libs", plan.flavour.library("fluidSolver")},
            {"maxCo", plan.scene->fvm.max_courant},
            {"maxDeltaT", Dictionary{{"type", Word("table")}, {"values", rows}}}};
}

/// Steps that meet the times of writing; for a body that moves they do not, or where its steps are limited without that.
bool steps_meet_writing(const CasePlan& plan) {
    if (!plan.writes_at_steps) return true;
    return !plan.step_caps.empty() && !plan.flavour.objects_set_steps() && !plan.flavour.steps_limited_by_table();
}

Dictionary functions(const CasePlan& plan) {
    Dictionary f;
    List loaded;
    for (const Solid& s : plan.solids)
        if (plan.counts_load_on(s)) loaded.push_back(Word(s.name));
    if (!plan.solids.empty()) f.add("forces", forces(plan, loaded));
    if (plan.mesh_moves()) {
        for (const BodyInMesh& b : plan.bodies)
            if (!plan.scene->hull_is_free()) f.add(b.forces(), forces(plan, {Word(b.patch)}));
        // the log says where several bodies are
        if (!plan.several_bodies() && !plan.moving().motion.law) f.add("bodyState", body_state(plan));
        if (plan.plate_interval > 0) f.add("plateSurface", plate_surface(plan));
        f.add("cellCentres", cells_now(plan, "writeCellCentres"));
        f.add("cellVolumes", cells_now(plan, "writeCellVolumes"));
    }
    f.add("fastest", fastest(plan));
    if (!plan.solids.empty() && plan.viscous)
        f.add("wallShear", wall_shear(plan));  // before the surfaces, which write it
    if (plan.scene->hull) f.add("hullSurface", hull_surface(plan));
    if (plan.solids.size() > (plan.scene->hull ? 1 : 0)) f.add("bodySurfaces", body_surfaces(plan));
    if (plan.snapshot_every > 0) f.add("freeSurface", free_surface(plan));
    if (!plan.pressure_places.empty())  // read/probes.h
        f.add("pressureProbes",
              probes(plan, {Word("p"), Word("p_rgh"), Word("alpha.water")}, plan.pressure_places, "cellPoint"));
    std::vector<Vec3> columns;
    for (const auto& column : plan.height_columns)
        for (const auto& point : column) columns.push_back(point.place);
    if (!columns.empty())
        f.add("heightColumns", probes(plan, {Word("alpha.water")}, columns, "cell", cells_stay(plan, columns)));
    // A file of this name in the case folder ends the run after writing its state.
    const Dictionary stop{{"type", Word(plan.flavour.stop_file_object())},
                          {"libs", plan.flavour.library("utilityFunctionObjects")},
                          {"action", Word("writeNow")}};
    f.add("stop", stop);
    if (plan.flavour.steps_limited_by_table()) {
        if (!plan.step_caps.empty()) f.add("largestStep", largest_step_by_table(plan));
        return f;
    }
    // An object that is to be written at set times shortens the steps that lead there: one that writes nothing is a
    // largest time step for a while.
    for (std::size_t k = 0; k < plan.step_caps.size(); ++k) {
        Dictionary cap = stop;
        cap.add({{plan.flavour.end_of_object() ? "endTime" : "timeEnd", plan.step_caps[k].until},
                 {"writeControl", Word("adjustableRunTime")},
                 {"writeInterval", plan.step_caps[k].step}});
        f.add("largestStep" + std::to_string(k), cap);
    }
    return f;
}

}  // namespace

/// system/controlDict. Transient Euler steps of a fixed largest Courant number; local time stepping is no faster here
/// and its force or its wake is wrong by 5-20 % (measured).
std::string control_dict(const CasePlan& plan) {
    const FvmOptions& fvm = plan.scene->fvm;
    Dictionary d{{"application", Word(plan.solver_program())}};
    if (!plan.flavour.solver_arguments().empty()) d.add("solver", Word(plan.flavour.solver_arguments().back()));
    List libraries;
    for (const std::string& library : {plan.wall_library, plan.zone_library, plan.hold_library})
        if (!library.empty()) libraries.push_back(Quoted(library));
    if (!libraries.empty()) d.add("libs", libraries);
    d.add({{"startFrom", Word("latestTime")},
           {"startTime", 0},
           {"stopAt", Word("endTime")},
           {"endTime", plan.scene->run.duration},
           {"deltaT", plan.first_step},  // of the first step only
           {"writeControl", Word(steps_meet_writing(plan) ? "adjustableRunTime" : "runTime")},
           {"writeInterval", plan.write_interval},
           {"purgeWrite", 0},
           {"writeFormat", Word("binary")},
           {"writePrecision", !plan.mesh_moves() ? 8 : 14},
           {"writeCompression", Word("off")},
           {"timeFormat", Word("general")},
           {"timePrecision", plan.time_precision},
           {"runTimeModifiable", true},
           {"adjustTimeStep", true},
           {"maxCo", fvm.max_courant},
           {"maxAlphaCo", fvm.max_alpha_courant},
           {"maxDeltaT", plan.largest_step},
           {"functions", functions(plan)}});
    return foam_file("dictionary", "controlDict", d);
}

}  // namespace tw
