// Dictionaries written for each release of openfoam.org, read back and compared with what its programs ask for. The
// lists follow the sources of the releases 7 to 13.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <sstream>

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
    // selects all cells where nothing is said; 11 and 12 ask for `select`
    known["volFieldValue"] = {"fields", "operation", "writeFields"};
    if (release >= 11) known["volFieldValue"].insert("select");
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
}

INSTANTIATE_TEST_SUITE_P(Releases, OpenFoamOrg, testing::Range(7, 14));

}  // namespace releases_test
}  // namespace tw
