// A geometric surface as one of a grid study's variations, as a user meets it.
#include <sstream>

#include "program.h"

namespace tw::test {
namespace grid_study_surface_test {

/// Predicted seconds of the plan's row that holds `part`; negative: there is none.
double seconds_of(const std::string& plan, const std::string& part) {
    std::istringstream text(plan);
    for (std::string line; std::getline(text, line);) {
        if (line.find(part) == std::string::npos) continue;
        std::istringstream row(line);
        std::string cell;
        for (int k = 0; k < 4; ++k) std::getline(row, cell, '|');
        return std::stod(cell);
    }
    return -1;
}

TEST_F(Command, AGridStudyVariesTheSurfaceOnlyWhenAskedAndSaysWhatItTakes) {
    write("open.toml", planing);
    const auto plan = [&](std::vector<std::string> more) {
        more.insert(more.begin(),
                    {"ladder", "open.toml", "--method", "fvm", "--levels", "2", "--no-variations", "--plan"});
        return twinwake(more).out;
    };
    EXPECT_LT(seconds_of(plan({}), "geometric surface"), 0);
    const std::string with_surface = plan({"--surface"});
    EXPECT_GT(seconds_of(with_surface, "at 0.1 m, geometric surface"), seconds_of(with_surface, "at 0.1 m  "))
        << with_surface;
    EXPECT_LT(seconds_of(with_surface, "at 0.141421 m, geometric surface"), 0) << "at one size alone";
}

TEST_F(Command, AGridStudySaysWhereTheSurfaceCannotBeVaried) {
    write("open.toml", planing);
    const Outcome particles = twinwake({"ladder", "open.toml", "--method", "sph", "--surface", "--plan"});
    EXPECT_EQ(particles.status, 2);
    EXPECT_NE(particles.err.find("--surface: it is a run of the mesh method"), std::string::npos) << particles.err;
    write("sharp.toml", planing + "[fvm]\ninterface = \"isoadvector\"\n");
    const Outcome sharp = twinwake({"ladder", "sharp.toml", "--method", "fvm", "--surface", "--plan"});
    EXPECT_EQ(sharp.status, 2);
    EXPECT_NE(sharp.err.find("--surface would run the same once more"), std::string::npos) << sharp.err;
    write("falls.toml",
          "[tank]\nmin = [-2, -2, -1]\nmax = [2, 2, 1]\n[[body]]\nname = \"ball\"\nshape = \"sphere\"\n"
          "diameter = 0.5\nposition = [0, 0]\ndraft = 0\ndensity = 500\n[motion]\nkind = \"none\"\n"
          "[resolution]\nnear_hull = 0.1\n[run]\nduration = 0.1\n");
    const Outcome falls = twinwake({"ladder", "falls.toml", "--method", "fvm", "--levels", "1", "--surface", "--plan"});
    EXPECT_EQ(falls.status, 0) << falls.err;
    EXPECT_NE(falls.out.find("geometric surface at 1 times the scene's size: left out: "), std::string::npos)
        << falls.out;
}

}  // namespace grid_study_surface_test
}  // namespace tw::test
