#include "spray/air/foam_air.h"

#include <gtest/gtest.h>

#include "base/errors.h"
#include "tests/unit/record/example_record.h"
#include "tests/unit/spray/row_of_cells.h"

namespace tw::spray {
namespace foam_air_test {
namespace fs = std::filesystem;

std::string complaint(const fs::path& folder, std::optional<double> time) {
    try {
        const FoamAir air(folder, time, {});
    } catch (const InputError& e) { return e.what(); }
    return "none";
}

/// U of the row's cells: (1 0 0), (2 0 0), (3 0 4). Between cells that of their face is the mean of both.
TEST(FoamAir, IsTheFieldOfTheCellsAndContinuousBetweenThem) {
    const ScratchFolder folder;
    write_row_of_cells(folder / "case");
    const FoamAir air(folder / "", 1, {.velocity = {99, 0, 0}, .density = 1.1, .viscosity = 2e-5});
    AirState s;
    ASSERT_TRUE(air.at({1, 0.5, 0.5}, s));
    EXPECT_NEAR(s.velocity.x(), 1.5, 1e-6);
    EXPECT_EQ(s.density, 1.1);
    EXPECT_EQ(s.viscosity, 2e-5);
    ASSERT_TRUE(air.at({2, 0.3, 0.9}, s));
    EXPECT_LT((s.velocity - Vec3(2.5, 0, 2)).norm(), 1e-6);
    ASSERT_TRUE(air.at({1.5, 0.5, 0.5}, s));  // half way between the faces
    EXPECT_LT((s.velocity - Vec3(2, 0, 1)).norm(), 1e-6);
}

/// The cell asked last is remembered by each thread: neither the order of places nor another field may show.
TEST(FoamAir, DoesNotDependOnWhatWasAskedBefore) {
    const ScratchFolder folder;
    write_row_of_cells(folder / "case");
    const fs::path points = folder / "case/constant/polyMesh/points";
    std::string corners = read_text(points);  // the last cube is bent out of shape: another way to find a place in it
    write_text_atomically(points, corners.replace(corners.find("(3 1 1)"), 7, "(3.4 1.2 1.3)"));
    std::vector<Vec3> places;
    for (int i = 0; i < 300; ++i) places.emplace_back(0.01 * i + 0.003, 0.2 + 0.002 * i, 0.9 - 0.002 * i);
    std::vector<Vec3> forth(300), back(300), other(300);
    AirState s;
    {
        const FoamAir air(folder / "", 1, {});
        for (std::size_t i = 0; i < 300; ++i) {
            EXPECT_TRUE(air.at(places[i], s));
            forth[i] = s.velocity;
        }
        for (std::size_t i = 300; i-- > 0;) {
            EXPECT_TRUE(air.at(places[i], s));
            back[i] = s.velocity;
        }
    }
    const fs::path u = folder / "case/1/U";
    std::string text = read_text(u);
    write_text_atomically(u, text.replace(text.find("(1 0 0)"), 7, "(5 0 0)"));
    const FoamAir changed(folder / "", 1, {});
    for (std::size_t i = 0; i < 300; ++i) {
        ASSERT_TRUE(changed.at(places[i], s));
        other[i] = s.velocity;
        EXPECT_EQ(forth[i], back[i]) << i;
    }
    EXPECT_NEAR(forth.front().x(), 1 + 0.5 * 0.003, 1e-6);
    EXPECT_NEAR(other.front().x(), 5 - 1.5 * 0.003, 1e-6);
    EXPECT_EQ(other.back(), forth.back());
}

/// A reader's child is forked: it would wait for ever for a lock that a thread of VTK held just then.
TEST(FoamAir, LeavesNoThreadsOfVtkBehind) {
    const auto threads = [] {
        const fs::directory_iterator all("/proc/self/task");
        return std::distance(begin(all), end(all));
    };
    const ScratchFolder folder;
    write_row_of_cells(folder / "case");
    const auto before = threads();
    const FoamAir air(folder / "", 1, {});
    AirState s;
    EXPECT_TRUE(air.at({1, 0.5, 0.5}, s));
    EXPECT_EQ(threads(), before);
}

TEST(FoamAir, EndsWhereTheMeshEnds) {
    const ScratchFolder folder;
    write_row_of_cells(folder / "case");
    const FoamAir air(folder / "", {}, {});
    AirState s;
    EXPECT_TRUE(air.at({2.99, 0.5, 0.5}, s));
    s.velocity = {7, 7, 7};
    EXPECT_FALSE(air.at({3.01, 0.5, 0.5}, s));
    EXPECT_FALSE(air.at({1, -0.01, 0.5}, s));
    EXPECT_EQ(s.velocity, Vec3(7, 7, 7));
}

TEST(FoamAir, ThatCannotBeReadNamesWhatIsMissing) {
    const ScratchFolder folder;
    write_row_of_cells(folder / "case");
    EXPECT_EQ(complaint(folder / "", 1), "none");
    EXPECT_NE(complaint(folder / "nowhere", 1).find("no OpenFOAM case there"), std::string::npos);
    EXPECT_NE(complaint(folder / "", 0.5).find("no time 0.5 s is written; it has 2 from 0 to 1 s"), std::string::npos);
    EXPECT_NE(complaint(folder / "", 0).find("field U is not there at 0 s"), std::string::npos);
    const fs::path u = folder / "case/1/U";
    std::string text = read_text(u);
    write_text_atomically(u, text.replace(text.find("(2 0 0)"), 7, "(nan 0 0)"));
    EXPECT_NE(complaint(folder / "", 1).find("U"), std::string::npos);
    EXPECT_THROW(FoamAir(folder / "", 1, {.density = -1}), InputError);
}

/// Labels and counts that are none, brackets that never close, places beyond the sky: named, in a few seconds, and VTK
/// stays off the terminal.
TEST(FoamAir, WhoseMeshIsDamagedIsRefused) {
    struct Damage {
        const char *file, *from, *to;
    };
    for (const Damage& d : {Damage{"constant/polyMesh/faces", "4(4 5 6 7)", "4(4 5 6 7000)"},
                            {"constant/polyMesh/faces", "4(4 5 6 7)", "4(4 5 6 -7)"},
                            {"constant/polyMesh/faces", "4(4 5 6 7)", "400000000(4 5 6 7)"},
                            {"constant/polyMesh/owner", "16\n(", "1600000000\n("},
                            {"constant/polyMesh/owner", "(\n0", "(\n900"},
                            {"constant/polyMesh/neighbour", "(\n1", "(\n-9"},
                            {"constant/polyMesh/points", "(0 0 0)", "(1e300 0 0)"},
                            {"constant/polyMesh/points", "(0 0 0)", "(0 0"},
                            {"constant/polyMesh/boundary", "nFaces 14", "nFaces 1400000000"},
                            {"1/U", "3((1 0 0)", "3((1 0"},
                            {"1/U", "List<vector> 3", "List<vector> 300000000"}}) {
        const ScratchFolder folder;
        write_row_of_cells(folder / "case");
        const fs::path file = folder / "case" / d.file;
        std::string text = read_text(file);
        ASSERT_NE(text.find(d.from), std::string::npos) << d.file << " " << d.from;
        write_text_atomically(file, text.replace(text.find(d.from), std::string(d.from).size(), d.to));
        testing::internal::CaptureStderr();
        const std::string message = complaint(folder / "", 1);
        EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << d.file << " " << d.to;
        EXPECT_NE(message.find("case"), std::string::npos) << d.file << " " << d.to << ": " << message;
    }
}

}  // namespace foam_air_test
}  // namespace tw::spray
