// What `twinwake check` does with a scene takes time in proportion to the rows of its lists.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>

#include "tests/unit/scene/scene_text.h"

namespace tw::test {
namespace scaling_test {

/// Of this thread [s].
double processor_time() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Reads, looks whether a mesh can follow, predicts and prints; the least of some attempts [s].
double time_of(const std::string& text, int attempts) {
    const std::filesystem::path file = written(text);
    double least = HUGE_VAL;
    for (int k = 0; k < attempts; ++k) {
        const double begin = processor_time();
        const Scene scene = read_scene(file);
        refuse_unmeshable(scene);
        to_text(scene, predict(scene));
        least = std::min(least, processor_time() - begin);
    }
    return least;
}

/// Places one apart on a square about the origin.
struct Grid {
    int side;
    explicit Grid(int rows) : side(static_cast<int>(std::ceil(std::sqrt(rows)))) {}
    double x(int k) const { return k % side + 0.5 - 0.5 * side; }
    double y(int k) const { return k / side + 0.5 - 0.5 * side; }
};

std::string tank_for(int rows) {
    const double half = 0.5 * (Grid(rows).side + 1);
    return fmt::format(
        "[tank]\nmin = [{0}, {0}, -0.5]\nmax = [{1}, {1}, 0.5]\n[motion]\nkind = \"none\"\n"
        "[resolution]\nnear_hull = 0.05\n[run]\nduration = 0.2\nmethods = [\"sph\"]\n",
        -half, half);
}

using Row = std::function<std::string(int, const Grid&)>;

std::string scene_of_rows(int rows, const Row& row) {
    std::string text = tank_for(rows);
    for (int k = 0; k < rows; ++k) text += row(k, Grid(rows));
    return text;
}

std::string body(int k, const Grid& at) {
    return fmt::format(
        "[[body]]\nname = \"b{}\"\nshape = \"box\"\nlength = 0.3\nbeam = 0.3\nheight = 0.3\ndraft = 0.15\n"
        "density = 500\nposition = [{}, {}]\n",
        k, at.x(k), at.y(k));
}
std::string obstacle(int k, const Grid& at) {
    return fmt::format("[[obstacle]]\nname = \"o{}\"\nmin = [{}, {}, -0.2]\nmax = [{}, {}, 0.2]\n", k, at.x(k), at.y(k),
                       at.x(k) + 0.3, at.y(k) + 0.3);
}
std::string probe(int k, const Grid& at) {
    return fmt::format("[[probe]]\nname = \"p{}\"\npressure = [{}, {}, -0.2]\n", k, at.x(k), at.y(k));
}

std::string refined(int rows) {
    std::string text = with(planing, "methods  = [\"sph\", \"fvm\"]", "methods = [\"sph\"]");
    const Grid at(rows);
    for (int k = 0; k < rows; ++k) {
        const double x = 4 * at.x(k) / at.side, y = 0.6 + at.y(k) / at.side;
        text += fmt::format("[[refine]]\nname = \"r{}\"\nmin = [{}, {}, -0.2]\nmax = [{}, {}, -0.1]\nspacing = 0.1\n", k, x,
                            y, x + 0.05, y + 0.02);
    }
    return text;
}

/// A laminate of so many plies, each of a material of its own.
std::string laminate(int rows) {
    std::string materials, layup;
    for (int k = 0; k < rows; ++k) {
        materials += fmt::format(
            "[[ply]]\nname = \"C{}\"\nthickness = {}\nE1 = 6e10\nE2 = 1e10\nnu12 = 0.25\nG12 = 4e9\ndensity = 1500\n",
            k, 0.004 / rows);
        layup += fmt::format("{}0 C{}", k == 0 ? "" : "/", k);
    }
    const std::size_t from = dropped.find("[[ply]]"), to = dropped.find("[[body]]");
    return with(dropped.substr(0, from) + materials + dropped.substr(to), "[0 C/90 C]s", "[" + layup + "]");
}

/// Ten times the rows take ten times as long, and a hundred times where each row looks at all others. What is the same
/// for any number of rows lowers the ratio.
void expect_proportional(const std::string& few, const std::string& many) {
    const double of_few = time_of(few, 5), of_many = time_of(many, 2);
    EXPECT_LT(of_many, 30 * of_few) << of_few << " s and " << of_many << " s";
    testing::Test::RecordProperty("ratio", fmt::format("{:.3g}", of_many / of_few));
}

TEST(Scaling, OfBodies) { expect_proportional(scene_of_rows(100, body), scene_of_rows(1000, body)); }
TEST(Scaling, OfObstacles) { expect_proportional(scene_of_rows(900, obstacle), scene_of_rows(9000, obstacle)); }
TEST(Scaling, OfProbes) { expect_proportional(scene_of_rows(900, probe), scene_of_rows(9000, probe)); }
TEST(Scaling, OfFinerPlaces) { expect_proportional(refined(100), refined(1000)); }
TEST(Scaling, OfPlies) { expect_proportional(laminate(300), laminate(3000)); }

}  // namespace scaling_test
}  // namespace tw::test
