#include <cmath>
#include <numbers>

#include "foam_cases/body_axes.h"
#include "foam_cases/files/case_files.h"
#include "foam_cases/files/several_bodies.h"
#include "foam_cases/files/times_of_table.h"
#include "foam_cases/release.h"

// Recipe and measurements: docs/decisions/032-rigid-bodies.md.

namespace tw {
namespace {

using Kind = MeshMotion::Kind;

Value tensor(const Eigen::Matrix3d& m) {
    return List{m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1), m(2, 2)};
}

/// Motions that are locked. OpenFOAM's line, plane, point and axis are through the centre of mass.
Dictionary constraints(const DegreesOfFreedom& free) {
    Dictionary all;
    const auto count = [](const std::array<bool, 3>& f) { return f[0] + f[1] + f[2]; };
    const auto axis_where = [](const std::array<bool, 3>& f, bool value) {
        Vec3 axis = Vec3::Zero();
        for (std::size_t a = 0; a < 3; ++a)
            if (f[a] == value) axis[static_cast<Eigen::Index>(a)] = 1;
        return axis;
    };
    const auto add = [&](const char* name, const char* type, const char* key, const Vec3& axis) {
        Dictionary d{{"sixDoFRigidBodyMotionConstraint", Word(type)}};
        if (key != nullptr) d.add(key, axis);
        all.add(name, d);
    };
    switch (count(free.along)) {
        case 0: add("place", "point", nullptr, {}); break;
        case 1: add("place", "line", "direction", axis_where(free.along, true)); break;
        case 2: add("place", "plane", "normal", axis_where(free.along, false)); break;
        default: break;
    }
    switch (count(free.about)) {
        case 0: add("attitude", "orientation", nullptr, {}); break;
        case 1: add("attitude", "axis", "axis", axis_where(free.about, true)); break;
        default: break;
    }
    return all;
}

/// A free body, moved by OpenFOAM's own rigid-body solver.
Dictionary free_body(const CasePlan& plan) {
    const RigidBodySetup& motion = plan.moving().motion;
    const double share = plan.solved_share();
    const BodyAxes own_axes = body_axes(motion);
    const bool held = !plan.hold_library.empty();
    const double rise = motion.free.along[2] && !held ? first_rise(plan.moving(), *plan.scene) : 0;
    const bool morphs = plan.mesh_motion.kind == Kind::morphing;
    const Box& box = plan.scene->domain.box;
    const double beyond = 100 * box.size().norm();
    const bool tumbles = motion.free.about[0] && motion.free.about[1] && motion.free.about[2];
    const double own = plan.scene->water.density * mass_properties(plan.moving().surface).volume;
    // Newmark leaves out the gyroscopic term; the explicit solver has it and is unstable for light bodies.
    const bool symplectic = tumbles && motion.mass.mass > 0.7 * own;
    const Dictionary rule = symplectic ? Dictionary{{"type", Word("symplectic")}}
                            : held     ? held_newmark(motion.release, plan.newmark_gamma)
                                       : newmark(plan);
    Dictionary body{
        {"patches", List{Word(plan.bodies.front().patch)}},
        {"innerDistance", morphs ? plan.mesh_motion.inner : beyond},
        {"outerDistance", morphs ? plan.mesh_motion.outer : 1.01 * beyond},
        {"mass", share * motion.mass.mass},
        {"centreOfMass", motion.mass.centre},
        {"orientation", tensor(own_axes.axes)},
        {"momentOfInertia", Vec3(share * own_axes.moments)},
        {"velocity", Vec3(plan.release_factor * motion.velocity)},
        {"angularMomentum", Vec3(share * own_axes.moments.cwiseProduct(own_axes.axes.transpose() * motion.spin))},
        {"acceleration", Vec3(0, 0, rise)},
        {"report", true},
        {"accelerationRelaxation", symplectic ? 1.0 : plan.relaxation},
        {"accelerationDamping", 1},  // anything else scales gravity too
        {"solver", rule},
        {"constraints", constraints(motion.free)}};
    return plan.flavour.motion_solver("sixDoFRigidBodyMotion", "sixDoFRigidBodyMotion", body);
}

/// Where a prescribed body is, at the times of a table: the way along and the angles about the axes [deg].
struct TableOfMotion {
    List times, along, about, both;
};

TableOfMotion table_of_motion(const CasePlan& plan) {
    const MotionLaw& law = *plan.moving().motion.law;
    TableOfMotion table;
    for (const double t : times_of_table(law, plan.scene->run.duration, plan.largest_step)) {
        const double path = law.at(t).path;
        const Vec3 along = law.turns ? Vec3(Vec3::Zero()) : Vec3(path * law.axis);
        const Vec3 about = law.turns ? Vec3(path * law.axis * 180 / std::numbers::pi) : Vec3(Vec3::Zero());
        table.along.push_back(List{t, along});
        table.about.push_back(List{t, about});
        table.both.push_back(List{t, List{along, about}});
    }
    return table;
}

Dictionary motion_function(const CasePlan& plan) {
    const Flavour& f = plan.flavour;
    const std::string type = f.tables_in_files() ? "tabulated6DoFMotion" : "sixDoFMotion";
    // the coefficients name the function once more: they alone are read again when a case is split for several cores
    Dictionary coefficients{{"solidBodyMotionFunction", Word(type)}, {"CofG", plan.moving().motion.mass.centre}};
    if (f.tables_in_files()) {
        coefficients.add("timeDataFileName", Quoted("<case>/constant/motionOfBody.dat"));
    } else {
        const TableOfMotion table = table_of_motion(plan);
        if (f.motion_in_parts())
            coefficients.add(
                {{"translation", f.table_of_times(table.along)}, {"rotation", f.table_of_times(table.about)}});
        else
            coefficients.add("translationRotation", f.table_of_times(table.both));
    }
    return {{"solidBodyMotionFunction", Word(type)}, {type + "Coeffs", coefficients}};
}

Dictionary moved_body(const CasePlan& plan) {
    if (plan.mesh_motion.whole_mesh()) {
        Dictionary whole = motion_function(plan);
        if (!plan.flavour.tables_in_files()) whole.add(plan.flavour.cell_selection(), Word("all"));
        return plan.flavour.motion_solver("solidBody", "", whole);
    }
    return plan.flavour.motion_solver(
        "displacementLaplacian", "fvMotionSolvers",
        {{"diffusivity", Value::sequence({Word("quadratic inverseDistance"), List{Word(plan.bodies.front().patch)}})}});
}

/// 0/pointDisplacement: where the mesh is morphed, walls, floor and top stay; else every point goes with the body.
/// Points of plane sides stay in their planes.
std::string point_displacement(const CasePlan& plan) {
    const Value nothing = Value::sequence({Word("uniform"), Vec3(Vec3::Zero())});
    const bool morphs = plan.mesh_motion.kind == Kind::morphing;
    const auto of_type = [&](const char* type) { return Dictionary{{"type", Word(type)}, {"value", nothing}}; };
    Dictionary boundary;
    for (const Patch& p : plan.sides)  // along planes the points slide
        boundary.add(p.name, p.plane() ? Dictionary{{"type", Word(p.mesh_type())}}
                                       : of_type(morphs ? "fixedValue" : "calculated"));
    for (const Solid& s : plan.solids) {
        if (s.moves && morphs && plan.moving().motion.law) {
            boundary.add(s.name, Dictionary{{"type", Word("solidBodyMotionDisplacement")}}
                                     .add(motion_function(plan))
                                     .add("value", nothing));
        } else {
            boundary.add(s.name, of_type(s.moves || !morphs ? "calculated" : "fixedValue"));
        }
    }
    add_sides_of_slab(plan, boundary);
    return foam_file("pointVectorField", "pointDisplacement",
                     {{"dimensions", metres}, {"internalField", nothing}, {"boundaryField", boundary}});
}

}  // namespace

Dictionary held_newmark(double release, double gamma) {
    return {{"type", Word("heldNewmark")}, {"release", release}, {"gamma", gamma}};
}

std::vector<CaseFile> mesh_motion_files(const CasePlan& plan) {
    if (!plan.mesh_moves()) return {};
    const bool moved = plan.moving().motion.law.has_value();
    const Dictionary motion = plan.several_bodies() ? several_bodies(plan) : moved ? moved_body(plan) : free_body(plan);
    std::vector<CaseFile> files{{"constant/dynamicMeshDict", foam_file("dictionary", "dynamicMeshDict", motion)},
                                {"0.orig/pointDisplacement", point_displacement(plan)}};
    if (moved && plan.flavour.tables_in_files())
        files.push_back({"constant/motionOfBody.dat", Value(table_of_motion(plan).both).text() + "\n"});
    return files;
}

}  // namespace tw
