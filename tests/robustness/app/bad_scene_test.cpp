#include "program.h"

namespace tw::test {
namespace bad_scene_test {

struct BadScene {
    std::string from, to, message;
};

class BadScenes : public Command, public testing::WithParamInterface<BadScene> {};

TEST_P(BadScenes, AreRefusedByCheckAndRunWithThePlaceAndNothingIsWritten) {
    const auto& [from, to, message] = GetParam();
    write("bad.toml", with(planing, from, to));
    for (const char* command : {"check", "run"}) {
        const Outcome o = twinwake({command, "bad.toml"});
        EXPECT_EQ(o.status, 2) << command << o.err;
        EXPECT_EQ(o.err.substr(0, message.size()), message);
        EXPECT_EQ(o.out, "");
    }
    EXPECT_EQ(files(), std::set<std::string>{"bad.toml"});
}

std::string case_name(const testing::TestParamInfo<BadScene>& scene) { return "case" + std::to_string(scene.index); }

INSTANTIATE_TEST_SUITE_P(
    Scenes, BadScenes,
    testing::Values(
        BadScene{"draft =", "darft =",
                 "bad.toml:5:1: [hull] darft = \"0.2 m\": unknown key; this section knows: axes, beam, deadrise, "
                 "draft, file, free, half, heel, height, length, position, "
                 "rake, repair, shape, trim, unit; did you mean 'draft'?\n"},
        BadScene{"near_hull = \"0.1 m\"", "near_hull = -0.1",
                 "bad.toml:11:13: [resolution] near_hull = -0.1: out of range; expected greater than 0 m\n"},
        BadScene{"near_hull = \"0.1 m\"", "near_hull = 0.1\nspacing = -1",
                 "bad.toml:12:11: [resolution] spacing = -1: out of range; expected greater than 0 m\n"},
        BadScene{
            "\"8 m/s\"", "0",
            "bad.toml:9:9: [motion] speed = 0: out of range; expected greater than 0 m/s and at most 1000 m/s (for "
            "still water write kind = \"none\")\n"},
        BadScene{"near_hull = \"0.1 m\"", "near_hull = \"1 mm\"",
                 "bad.toml:11:13: [resolution] near_hull = \"1 mm\": too fine for this machine: 2.6"},
        BadScene{"shape = \"prismatic\"", "file  = \"gone.stl\"",
                 "bad.toml:3:9: [hull] file = \"gone.stl\": there is no file gone.stl\n"},
        BadScene{"shape = \"prismatic\"", "shape = \"prismatik\"",
                 "bad.toml:3:9: [hull] shape = \"prismatik\": not known; expected one of: "},
        BadScene{"draft = \"0.2 m\"", "draft = 0",
                 "bad.toml:5:9: [hull] draft = 0: the hull is not in the water: its lowest point stands 0 m above "
                 "still water"},
        BadScene{"[motion]", "[domain]\nside = 0.3\n[motion]",
                 "bad.toml:8:8: [domain] side = 0.3: the hull is larger than the domain: in y it spans -0.5 to 0.5 m"},
        BadScene{"kind  = \"stream\"", "kind  = \"prescribed\"",
                 "bad.toml:8:9: [motion] kind = \"prescribed\": this version solves a fixed hull only"},
        BadScene{"[run]", "[effects]\ncompressibility = \"on\"\n[run]",
                 "bad.toml:13:19: [effects] compressibility = \"on\": water is solved as (nearly) incompressible"},
        BadScene{"title = \"planing\"", "title = \"planing", "bad.toml:1:17: not valid TOML: "}),
    case_name);

/// A sheet of two elements on a frame: `elements` are the corners of both.
std::string sheet(const std::string& elements) {
    return "*NODE\n1, 0, 0, 0\n2, 0.2, 0, 0\n3, 0.4, 0, 0\n4, 0, 0.2, 0\n5, 0.2, 0.2, 0\n6, 0.4, 0.2, 0\n"
           "7, 0.6, 0, 0\n8, 0.6, 0.2, 0\n*ELEMENT, TYPE=S4\n" +
           elements + "*NSET, NSET=ENDS\n1, 4\n";
}

TEST_F(Command, ElasticBodiesThatCannotBeAreRefusedByCheckAndRunAndNothingIsWritten) {
    const std::string scene = R"(title = "sheet"
[tank]
min = [-1, -1, -1]
max = [1, 1, 1]
[[body]]
name = "sheet"
elastic = "plate"
mesh = "sheet.inp"
middle = [0, 0, 0.5]
thickness = "4 mm"
youngs_modulus = 7e10
poisson = 0.3
density = 2700
carried = ["ENDS"]
mass = "5 kg"
[motion]
kind = "none"
[resolution]
near_hull = "50 mm"
[run]
duration = 0.01
methods = ["sph"]
)";
    const std::string sound = sheet("1, 1, 2, 5, 4\n2, 2, 3, 6, 5\n");
    const struct {
        std::string mesh, scene, message;
    } wrong[] = {
        {sheet("1, 1, 2, 5, 4\n2, 2, 3, 3, 2\n"), scene, "element 2 has no area"},
        {sheet("1, 1, 2, 5, 4\n2, 2, 5, 6, 3\n"), scene, "element 2 is turned the other way than element 1"},
        {sheet("1, 1, 2, 5, 4\n2, 3, 7, 8, 6\n"), scene, "element 2 hangs together with element 1 by no node"},
        {sound, with(scene, "poisson = 0.3", "poisson = 0.5"), "no material has these constants"},
        {sound, with(scene, "carried = [\"ENDS\"]\nmass = \"5 kg\"\n", ""), "neither support nor frame nor velocity"},
    };
    write("sheet.inp", sound);
    write("bad.toml", scene);
    EXPECT_EQ(twinwake({"check", "bad.toml"}).status, 0) << "or nothing below is seen";
    for (const auto& [mesh, text, message] : wrong) {
        write("sheet.inp", mesh);
        write("bad.toml", text);
        for (const char* command : {"check", "run"}) {
            const Outcome o = twinwake({command, "bad.toml"});
            EXPECT_EQ(o.status, 2) << command << o.err;
            EXPECT_EQ(o.err.find("bad.toml:"), 0u) << o.err;
            EXPECT_NE(o.err.find(message), std::string::npos) << o.err;
        }
    }
    EXPECT_EQ(files(), (std::set<std::string>{"bad.toml", "sheet.inp"}));
}

TEST_F(Command, TwoBodiesTooNearToMorphAMeshBetweenThemAreRefusedForTheMeshMethodAndNothingIsWritten) {
    const std::string scene =
        "[tank]\nmin = [-2, -1, -1]\nmax = [2, 1, 1]\n[[body]]\nshape = \"sphere\"\ndiameter = 0.5\ndraft = 0.2\n"
        "density = 500\n[[body]]\nshape = \"sphere\"\ndiameter = 0.5\ndraft = 0.2\nposition = [0.6, 0]\n"
        "density = 500\n[motion]\nkind = \"none\"\n[resolution]\nnear_hull = 0.05\n[run]\nduration = 1\n";
    write("body.toml", scene);  // both methods, as is the default
    for (const std::vector<std::string>& command : {std::vector<std::string>{"check", "body.toml"},
                                                    {"run", "body.toml"},
                                                    {"run", "body.toml", "--method", "fvm"},
                                                    {"case", "body.toml", "case"}}) {
        const Outcome o = twinwake(command);
        EXPECT_EQ(o.status, 2) << command[0] << o.err;
        EXPECT_NE(
            o.err.find("body body2 stands 0.05 m from the middle between it and body body1; a mesh is morphed over "
                       "four cells (0.2 m) or more: move the bodies apart"),
            std::string::npos)
            << o.err;
    }
    EXPECT_EQ(files(), std::set<std::string>{"body.toml"});
}

TEST_F(Command, ABadHullFileIsReportedAtItsKey) {
    const std::string scene = with(planing, "shape = \"prismatic\"", "file  = \"bad.stl\"");
    write("bad.toml", scene);
    for (const std::string& bytes :
         {std::string(), std::string("solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0"), std::string(84, '\xff'),
          std::string("\x7f"
                      "ELF garbage \0\1\2",
                      16)}) {
        write("bad.stl", bytes);
        const Outcome o = twinwake({"check", "bad.toml"});
        EXPECT_EQ(o.status, 2);
        EXPECT_EQ(o.err.substr(0, 36), "bad.toml:3:9: [hull] file = \"bad.stl") << o.err;
    }
}

}  // namespace bad_scene_test
}  // namespace tw::test
