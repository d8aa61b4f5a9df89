// Dictionaries written for each release of openfoam.org, read back and compared with what its programs ask for. The
// lists follow the sources of the releases 7 to 13.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "base/errors.h"
#include "foam_cases/files/case_files.h"
#include "scenes.h"

namespace tw {
namespace releases_test {

/// A dictionary as OpenFOAM reads it: the words behind a key, and the dictionaries in them (of a list: each `name {}`).
struct Read {
    std::string words;
    std::map<std::string, Read> parts;

    std::set<std::string> keys() const {
        std::set<std::string> out;
        for (const auto& [key, part] : parts) out.insert(key);
        return out;
    }
};

std::vector<std::string> tokens_of(const std::string& text) {
    std::vector<std::string> out;
    std::string token;
    bool quoted = false;
    for (const char c : text) {
        const bool single = !quoted && std::string("{}();").find(c) != std::string::npos;
        if (c == '"') quoted = !quoted;
        if ((single || (!quoted && (c == ' ' || c == '\n'))) && !token.empty()) out.push_back(token), token.clear();
        if (single) out.emplace_back(1, c);
        if (!single && (quoted || (c != ' ' && c != '\n'))) token += c;
    }
    return out;
}

Read read_back(const std::vector<std::string>& tokens, std::size_t& at) {
    Read all;
    while (at < tokens.size() && tokens[at] != "}") {
        const std::string key = tokens[at++];
        Read entry;
        std::string name;
        int depth = 0, unnamed = 0;
        for (; at < tokens.size() && (depth > 0 || tokens[at] != ";"); ++at) {
            if (tokens[at] == "{") {
                Read inner = read_back(tokens, ++at);
                if (depth == 0) {
                    entry = std::move(inner);
                    break;
                }
                entry.parts[name.empty() ? std::to_string(unnamed++) : name] = std::move(inner);
                name.clear();
                continue;
            }
            depth += (tokens[at] == "(") - (tokens[at] == ")");
            name = tokens[at] == "(" || tokens[at] == ")" ? "" : tokens[at];
            entry.words += (entry.words.empty() ? "" : " ") + tokens[at];
        }
        ++at;
        all.parts[key] = std::move(entry);
    }
    return all;
}

Read read_back(const std::string& text) {
    std::size_t at = 0;
    Read file = read_back(tokens_of(text), at);
    file.parts.erase("FoamFile");
    return file;
}

bool holds(const std::set<std::string>& all, const std::set<std::string>& some) {
    return std::includes(all.begin(), all.end(), some.begin(), some.end());
}

/// What function objects of a release cannot do without.
std::map<std::string, std::set<std::string>> function_objects(int release) {
    std::map<std::string, std::set<std::string>> known{
        {"forces", {"patches", "rho", "CofR"}},
        {"surfaces", {"surfaceFormat", "interpolationScheme", "fields", "surfaces"}},
        {"probes", {"fields", "probeLocations"}},
        {"wallShearStress", {}},
        {"writeCellCentres", {}},
        {"writeCellVolumes", {}},
        {release < 8 ? "abort" : "stopAtFile", {"action"}}};
    if (release < 9) known["fieldMinMax"] = {"fields", "mode"};
    // selects all cells where nothing is said; 11 and 12 ask for `select`, 13 for `cellZone`
    known["volFieldValue"] = {"fields", "operation", "writeFields"};
    if (release >= 11) known["volFieldValue"].insert(release < 13 ? "select" : "cellZone");
    return known;
}
const std::map<std::string, std::set<std::string>> sampled_surfaces{{"patch", {"patches"}},
                                                                    {"isoSurface", {"isoField", "isoValue"}}};

class OpenFoamOrg : public testing::TestWithParam<int> {
protected:
    Flavour flavour = Flavour::from_version("openfoam.org", std::to_string(GetParam()));
};

TEST_P(OpenFoamOrg, KnowsTheFunctionObjectsAndTheirSurfaces) {
    const Scene scene = planing_scene();
    CasePlan plan = plan_case(scene, flavour);
    plan.viscous = true;
    plan.snapshot_every = 4;
    plan.pressure_places = {Vec3(0, 0, -0.5)};
    const Read control = read_back(control_dict(plan));
    EXPECT_EQ(control.parts.contains("solver"), GetParam() >= 11);
    const auto known = function_objects(GetParam());
    int surfaces = 0;
    for (const auto& [name, object] : control.parts.at("functions").parts) {
        const auto type = known.find(object.parts.at("type").words);
        ASSERT_NE(type, known.end()) << name << ": " << object.parts.at("type").words;
        EXPECT_TRUE(holds(object.keys(), type->second)) << name;
        EXPECT_TRUE(object.parts.at("libs").words.starts_with("( \"lib")) << name;
        if (name == "fastest") {
            EXPECT_EQ(object.parts.at(type->first == "volFieldValue" ? "operation" : "mode").words,
                      type->first == "volFieldValue" ? "maxMag" : "magnitude");
        }
        if (type->first != "surfaces") continue;
        for (const auto& [surface, how] : object.parts.at("surfaces").parts) {
            ++surfaces;
            const auto kind = sampled_surfaces.find(how.parts.at("type").words);
            ASSERT_NE(kind, sampled_surfaces.end()) << surface << ": " << how.parts.at("type").words;
            EXPECT_TRUE(holds(how.keys(), kind->second)) << surface;
        }
    }
    EXPECT_EQ(surfaces, 2) << "the hull and the free surface";
    EXPECT_TRUE(control.parts.at("functions").parts.contains("fastest"));
}

TEST_P(OpenFoamOrg, SetsFieldsByRegions) {
    const Scene scene = planing_scene();
    const Read file = read_back(set_fields_dict(plan_case(scene, flavour)));
    EXPECT_EQ(file.keys(), (std::set<std::string>{"defaultFieldValues", "regions"}));
    const Read& regions = file.parts.at("regions");
    EXPECT_EQ(regions.keys(), (std::set<std::string>{"boxToCell", "boxToFace"}));
    for (const auto& [source, region] : regions.parts) {
        EXPECT_EQ(region.keys(), (std::set<std::string>{"box", "fieldValues"})) << source;
        EXPECT_EQ(region.parts.at("fieldValues").words, "( volScalarFieldValue alpha.water 1 )");
    }
}

TEST_P(OpenFoamOrg, DrawsAFlatHullsLayerOutOfTheCaseItself) {
    const Scene scene = flat_plate_scene();
    const CasePlan plan = plan_case(scene, flavour);
    const Read layer = read_back(extrude_mesh_dict(plan));
    EXPECT_TRUE(holds(layer.keys(), {"constructFrom", "sourceCase", "sourcePatches", "exposedPatchName", "flipNormals",
                                     "extrudeModel", "linearDirectionCoeffs", "mergeFaces"}));
    EXPECT_EQ(layer.parts.at("sourceCase").words, "\"$FOAM_CASE\"") << "\"<case>\" is a word of openfoam.com";
    const Read patches = read_back(create_patch_dict(plan));
    EXPECT_TRUE(holds(patches.keys(), {"pointSync", "patches"}));
    ASSERT_EQ(patches.parts.at("patches").parts.size(), 2u);
    for (const auto& [number, patch] : patches.parts.at("patches").parts)
        EXPECT_TRUE(holds(patch.keys(), {"name", "patchInfo", "constructFrom", "patches"})) << number;
    // createPatch leaves planes of the slab without faces, and a field without an entry for one is refused
    for (const std::string& text : {alpha_water(plan), velocity_field(plan), p_rgh(plan)}) {
        const Read sides = read_back(text).parts.at("boundaryField");
        for (const std::size_t side : {2u, 3u}) {
            ASSERT_TRUE(sides.parts.contains(slab_side(plan.sides[side])));
            EXPECT_EQ(sides.parts.at(slab_side(plan.sides[side])).parts.at("type").words, "symmetryPlane");
        }
    }
}

/// A box in water, open all round, whose mesh moves as a whole.
Scene body_scene() {
    Scene scene = dam_break_scene();
    scene.domain.box = {Vec3(-1, 0, -1), Vec3(1, 0.02, 1)};
    scene.water_blocks.clear();
    scene.fvm.body_mesh = "whole";
    MovingBody& b = scene.bodies.emplace_back();
    b.name = "box";
    b.surface = make_hull("box", {{"length", 0.2}, {"beam", 1}, {"height", 0.1}});
    for (Vec3& p : b.surface.points) p.z() -= 0.5 + b.surface.bounds().max.z();
    b.motion.mass = {10, Vec3(0, 0, -0.5), Eigen::Matrix3d::Identity()};
    return scene;
}

MotionLaw swaying() {
    MotionLaw law;
    law.kind = MotionLaw::Kind::sinusoid, law.axis = Vec3::UnitX(), law.amplitude = 0.01, law.period = 0.5;
    return law;
}

/// A function of time as rows of a time and one vector, or of a time and a list of vectors.
void expect_table(const Read& table, int vectors) {
    EXPECT_EQ(table.parts.at("type").words, "table");
    EXPECT_EQ(table.parts.at("interpolationScheme").words, "spline");
    int depth = 0, deepest = 0, numbers = 0, rows = 0;
    std::istringstream words(table.parts.at("values").words);
    for (std::string word; words >> word;) {
        depth += (word == "(") - (word == ")");
        deepest = std::max(deepest, depth);
        rows += word == "(" && depth == 2;
        numbers += word != "(" && word != ")";
    }
    EXPECT_EQ(deepest, vectors == 1 ? 3 : 4);
    EXPECT_GT(rows, 20);
    EXPECT_EQ(numbers, rows * (1 + 3 * vectors));
}

/// constant/dynamicMeshDict's mover, and that its libraries are those of the release.
Read mover_of(const CasePlan& plan, const std::string& library) {
    const std::vector<CaseFile> files = mesh_motion_files(plan);
    EXPECT_EQ(files.size(), 2u) << "dynamicMeshDict and pointDisplacement";
    const Read file = read_back(files.at(0).text);
    EXPECT_EQ(file.keys(), std::set<std::string>{"mover"});
    const Read& mover = file.parts.at("mover");
    EXPECT_EQ(mover.parts.at("type").words, "motionSolver");
    const std::string own = plan.flavour.number < 12 ? "\"libfvMeshMovers.so\" " : "";
    EXPECT_EQ(mover.parts.at("libs").words, "( " + own + "\"lib" + library + ".so\" )");
    return mover;
}

TEST_P(OpenFoamOrg, MovesBodiesAndTanksFromElevenOn) {
    Scene free = body_scene(), tank = dam_break_scene();
    free.bodies[0].motion.free = {{false, false, true}, {false, false, false}};
    tank.tank_motion.emplace().law = swaying();
    for (const Scene* scene : {&free, &tank}) {
        std::string refusal;
        try {
            plan_case(*scene, flavour);
        } catch (const InputError& e) { refusal = e.what(); }
        EXPECT_EQ(refusal.empty(), GetParam() >= 11) << refusal;
        const std::string found = "openfoam.org from 11, and this is openfoam.org " + std::to_string(GetParam());
        EXPECT_TRUE(refusal.empty() || refusal.find(found) != std::string::npos) << refusal;
    }
}

TEST_P(OpenFoamOrg, AFreeBodyIsMovedByAMover) {
    if (GetParam() < 11) GTEST_SKIP() << "refused, see above";
    Scene scene = body_scene();
    scene.bodies[0].motion.free = {{false, false, true}, {false, true, false}};
    const CasePlan plan = plan_case(scene, flavour);
    const Read mover = mover_of(plan, "sixDoFRigidBodyMotion");
    EXPECT_EQ(mover.parts.at("motionSolver").words, "sixDoFRigidBodyMotion");
    EXPECT_TRUE(holds(mover.keys(), {"patches", "innerDistance", "outerDistance", "mass", "centreOfMass", "orientation",
                                     "momentOfInertia", "velocity", "angularMomentum", "acceleration", "solver"}));
    const Read control = read_back(control_dict(plan));
    const auto& objects = control.parts.at("functions").parts;
    EXPECT_EQ(objects.at("bodyState").parts.at("libs").words, "( \"libsixDoFRigidBodyState.so\" )");
    if (GetParam() < 12) {
        ASSERT_TRUE(objects.contains("largestStep0"));
        EXPECT_TRUE(objects.at("largestStep0").parts.contains("endTime")) << "timeEnd is a word of openfoam.com";
        EXPECT_EQ(control.parts.at("writeControl").words, "adjustableRunTime") << "else objects do not shorten steps";
    } else {
        ASSERT_TRUE(objects.contains("largestStep"));
        EXPECT_EQ(objects.at("largestStep").keys(), (std::set<std::string>{"type", "libs", "maxCo", "maxDeltaT"}));
        EXPECT_EQ(objects.at("largestStep").parts.at("maxDeltaT").keys(), (std::set<std::string>{"type", "values"}));
    }
    const Read water = read_back(alpha_water(plan)).parts.at("boundaryField");
    int open = 0;
    for (const auto& [name, patch] : water.parts) {
        if (patch.parts.at("type").words != "fixedProfile") continue;
        ++open;
        EXPECT_TRUE(holds(patch.keys(), {"profile", "direction", "origin"})) << name;
        EXPECT_EQ(patch.parts.at("profile").parts.at("type").words, "table");
    }
    EXPECT_EQ(open, 4) << "exprFixedValue is a type of openfoam.com";
}

TEST_P(OpenFoamOrg, APrescribedBodyFollowsATable) {
    if (GetParam() < 11) GTEST_SKIP() << "refused, see above";
    Scene scene = body_scene();
    scene.bodies[0].motion.law = swaying();
    const Read mover = mover_of(plan_case(scene, flavour), "fvMotionSolvers");
    EXPECT_EQ(mover.parts.at("motionSolver").words, "solidBody");
    EXPECT_EQ(mover.parts.at(GetParam() < 13 ? "select" : "cellZone").words, "all");
    EXPECT_EQ(mover.parts.at("solidBodyMotionFunction").words, "sixDoFMotion");
    const Read& motion = mover.parts.at("sixDoFMotionCoeffs");
    EXPECT_TRUE(motion.parts.contains("CofG"));
    if (GetParam() < 13) return expect_table(motion.parts.at("translationRotation"), 2);
    expect_table(motion.parts.at("translation"), 1);
    expect_table(motion.parts.at("rotation"), 1);
}

TEST_P(OpenFoamOrg, SeveralBodiesAreOneMover) {
    if (GetParam() < 11) GTEST_SKIP() << "refused, see above";
    Scene scene = body_scene();
    scene.fvm.body_mesh = "morphing";
    scene.bodies[0].surface = make_hull("box", {{"length", 0.2}, {"beam", 0.1}, {"height", 0.1}});
    scene.bodies[0].motion.free = {{false, false, true}, {false, false, false}};
    scene.bodies[0].motion.mass = {8, Vec3::Zero(), Eigen::Matrix3d::Identity()};
    MovingBody second = scene.bodies[0];
    second.name = "crate";
    for (MovingBody* body : {&scene.bodies[0], &second}) {
        const Vec3 to(body == &second ? 0.5 : -0.5, 0, 0);
        for (Vec3& p : body->surface.points) p += to;
        body->motion.mass.centre += to;
    }
    scene.bodies.push_back(second);
    const Read mover = mover_of(plan_case(scene, flavour), "rigidBodyMeshMotion");
    EXPECT_EQ(mover.parts.at("motionSolver").words, "rigidBodyMotion");
    EXPECT_TRUE(holds(mover.keys(), {"report", "solver", "q", "qDot", "qDdot", "bodies"}));
    EXPECT_EQ(mover.parts.at("bodies").parts.size(), 2u);
    for (const auto& [name, body] : mover.parts.at("bodies").parts)
        EXPECT_TRUE(holds(body.keys(), {"type", "parent", "mass", "centreOfMass", "inertia", "transform", "joint",
                                        "patches", "innerDistance", "outerDistance"}))
            << name;
}

TEST_P(OpenFoamOrg, ATanksAccelerationIsAModel) {
    if (GetParam() < 11) GTEST_SKIP() << "refused, see above";
    Scene scene = dam_break_scene();
    scene.tank_motion.emplace().law = swaying();
    const std::vector<CaseFile> files = tank_motion_files(plan_case(scene, flavour));
    ASSERT_EQ(files.size(), 1u);
    EXPECT_EQ(files[0].path, "constant/fvModels");
    const Read model = read_back(files[0].text).parts.at("tank");
    EXPECT_EQ(model.parts.at("type").words, "sixDoFAccelerationSource");
    if (GetParam() < 13) return expect_table(model.parts.at("accelerations"), 3);
    for (const char* part : {"acceleration", "angularVelocity", "angularAcceleration"})
        expect_table(model.parts.at(part), 1);
}

// With `level` beside it, later releases would read the list of one distance and level as a number, and stop.
TEST_P(OpenFoamOrg, RefinesBoxesByTheListOfLevelsAlone) {
    const Scene scene = planing_scene();
    const Read mesh = read_back(snappy_hex_mesh_dict(plan_case(scene, flavour)));
    const Read& regions = mesh.parts.at("castellatedMeshControls").parts.at("refinementRegions");
    ASSERT_GE(regions.parts.size(), 2u);
    for (const auto& [name, region] : regions.parts)
        EXPECT_EQ(region.keys(), (std::set<std::string>{"mode", "levels"})) << name;
}

INSTANTIATE_TEST_SUITE_P(Releases, OpenFoamOrg, testing::Range(7, 14));

}  // namespace releases_test
}  // namespace tw
