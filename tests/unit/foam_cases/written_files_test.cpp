// Files that releases of OpenFOAM wrote, of a floating box that is not yet at its draft (tests/data/openfoam_*).
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <string>

#include "base/atomic_file.h"
#include "foam_cases/read/field_file.h"
#include "foam_cases/read/hull_patch.h"
#include "foam_cases/read/number_rows.h"
#include "foam_cases/read/solver_log.h"
#include "foam_cases/read/step_loads.h"
#include "foam_cases/run/watchdog.h"
#include "test_paths.h"

namespace tw {
namespace written_files_test {
namespace fs = std::filesystem;

/// The folder in tests/data, and what the release does in its own way.
struct Release {
    const char* folder;
    bool first_row_at_start;  ///< its tables have a row at time 0
    friend void PrintTo(const Release& r, std::ostream* out) { *out << r.folder; }
};

class WrittenFiles : public testing::TestWithParam<Release> {
protected:
    fs::path folder = fs::path(TWINWAKE_SOURCE) / "tests/data" / GetParam().folder, post = folder / "postProcessing";
    std::size_t rows = GetParam().first_row_at_start ? 5 : 4;
};
INSTANTIATE_TEST_SUITE_P(Releases, WrittenFiles,
                         testing::Values(Release{"openfoam_org_12", true}, Release{"openfoam_com_2506", false}),
                         [](const auto& of) { return std::string(of.param.folder); });

constexpr double last = 0.0028556862;                                          // [s]
constexpr double length = 0.2, height = 0.1, draft = 0.04, thickness = 0.025;  // of the box and the plane [m]
constexpr double mass = 500 * length * height * thickness, g = 9.81;

TEST_P(WrittenFiles, TheLogHasItsFourStepsAndItsEnd) {
    SolverLog log;
    log.feed(read_text(folder / "log.solver"));
    EXPECT_TRUE(log.ended());
    EXPECT_TRUE(log.fatal().empty()) << log.fatal();
    ASSERT_EQ(log.steps().size(), 4u);
    EXPECT_NEAR(log.steps().back().time, last, 1e-9);
    EXPECT_NEAR(log.steps().back().step, last / 4, 1e-9);
    EXPECT_NEAR(log.steps().back().water, 4.3 / 7, 1e-3) << "of the tank less the box";
}

TEST_P(WrittenFiles, TheForceIsBuoyancyAtFirstAndThenWeightLessMassTimesAcceleration) {
    const StepLoads loads = read_loads(post / "forces_box");
    const auto motion = joined_rows(post / "bodyState", "sixDoFRigidBodyState.dat");
    ASSERT_EQ(loads.time.size(), rows);
    ASSERT_EQ(motion.size(), rows);
    if (GetParam().first_row_at_start) {
        EXPECT_NEAR(loads.pressure[0][2], 1000 * g * length * draft * thickness, 0.005);
    }
    const auto speed = [&](std::size_t i) { return motion[i].at(12); };
    double mean = 0;
    for (std::size_t i = rows - 3; i < rows; ++i) mean += loads.pressure[i][2] / 3;
    const double rise = (speed(rows - 1) - speed(rows - 4)) / (motion[rows - 1][0] - motion[rows - 4][0]);
    EXPECT_LT(rise, 0) << "it is 10 mm too high";
    EXPECT_NEAR(mean, mass * (g + rise), 0.01 * mass * g);
}

TEST_P(WrittenFiles, VolumesOfCellsAndWaterAreThoseOfTheTank) {
    const fs::path time = folder / "0.0028556862";
    const FieldFile volume = read_field(time / cell_volumes_in(time)), water = read_field(time / "alpha.water");
    ASSERT_EQ(volume.cells(), 901u);
    ASSERT_EQ(water.cells(), 901u);
    double all = 0, wet = 0;
    for (std::size_t i = 0; i < volume.cells(); ++i) {
        all += volume.scalar(i);
        wet += volume.scalar(i) * water.scalar(i);
    }
    EXPECT_NEAR(all, 0.6 * 0.5 * thickness - length * height * thickness, 1e-8);
    EXPECT_NEAR(wet, 0.6 * 0.3 * thickness - length * draft * thickness, 2e-3 * wet);
}

TEST_P(WrittenFiles, TheBoxIsWetToItsDraftAndPressedUp) {
    const auto patch = read_hull_patch(post / "bodySurfaces/0.0028556862", "box");
    ASSERT_TRUE(patch);
    double area = 0, wet = 0;
    for (const HullPatch::Face& f : patch->faces) {
        area += f.area.norm();
        wet += f.water * f.area.norm();
    }
    EXPECT_NEAR(area, 2 * (length + height) * thickness, 1e-6);
    EXPECT_NEAR(wet, (length + 2 * draft) * thickness, 0.05 * wet);
    const WaterLoad load = water_load(*patch, 1000, 1.2, Vec3::Zero());
    EXPECT_NEAR(load.pressure.z(), read_loads(post / "forces_box").pressure.back()[2], 0.02);
}

TEST_P(WrittenFiles, ProbeAndLargestSpeedAreRead) {
    const auto probe = joined_rows(post / "pressureProbes", "p");
    ASSERT_EQ(probe.size(), rows);
    const double depth = 0.28, falling_box_takes = GetParam().first_row_at_start ? 1 : 10;  // [m], [Pa]
    EXPECT_NEAR(probe.front().at(1), 1000 * g * depth, falling_box_takes);
    EXPECT_NEAR(latest_fastest(post, last), 4.1572e-3, 1e-6);
}

}  // namespace written_files_test
}  // namespace tw
