// Water at rest has to stay at rest: the laws of hydrostatics, through whole runs of the solver. Shorter and coarser than the
// rows of docs/validation.md, which use the same scenes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "study_run.h"

namespace tw::test {
namespace {

TEST(StillTank, SurfaceStaysWithinHalfASpacingAndPressureWithinAPerCent) {
    const StudyRun run = run_study("still_tank", 2.0);
    ASSERT_EQ(run.record.state, "finished") << run.record.reason;
    const Table& height = run.record.tables.at("height");
    ASSERT_FALSE(height.columns.empty());
    ASSERT_GE(height.time.back(), 1.9);
    for (const Column& probe : height.columns)
        for (std::size_t i = 0; i < height.time.size(); ++i)
            ASSERT_LT(std::abs(probe.values[i] - still_level(run.scene)), 0.5 * run.dp()) << probe.name << " at " << height.time[i] << " s";

    const Column* lost = run.record.series("samples", "particles_lost");
    ASSERT_TRUE(lost);
    EXPECT_EQ(lost->values.back(), 0);
    const Column* mass = run.record.series("samples", "mass");
    ASSERT_TRUE(mass);
    EXPECT_NEAR(mass->values.back() / mass->values.front(), 1, 1e-6);

    const Table& pressure = run.record.tables.at("pressure");
    ASSERT_FALSE(pressure.columns.empty());
    ASSERT_EQ(pressure.columns.size(), run.scene.sampling.pressure.size());
    const Water& water = run.scene.water;
    const double scale = water.density * water.gravity * water.depth;   // pressure on the floor [Pa]
    for (const PressureProbe& probe : run.scene.sampling.pressure) {
        const Column* column = pressure.find(probe.name);
        ASSERT_TRUE(column) << probe.name;
        const double exact = water.density * water.gravity * (still_level(run.scene) - probe.place.z());
        EXPECT_LT(std::abs(mean_from(pressure, *column, 1.0) - exact), 0.01 * scale)
            << probe.name << " at z = " << probe.place.z() << " m: " << mean_from(pressure, *column, 1.0) << " Pa, exact " << exact;
    }
}

TEST(SubmergedBox, WaterCarriesItsOwnWeight) {
    const StudyRun run = run_study("submerged_box", 2.0);
    ASSERT_EQ(run.record.state, "finished") << run.record.reason;
    ASSERT_TRUE(run.scene.hull);
    const double volume = run.scene.hull->still.volume;
    ASSERT_NEAR(volume, run.scene.hull->mass.volume, 1e-9) << "the box of this study lies wholly under water";
    const double buoyancy = run.scene.water.density * run.scene.water.gravity * volume;   // Archimedes [N]
    const Table& forces = run.record.tables.at("forces");
    const auto mean = [&](const char* name) { return mean_from(forces, *forces.find(name), 1.0); };
    EXPECT_NEAR(mean("fz") / buoyancy, 1, 0.005);
    EXPECT_NEAR(mean("fx") / buoyancy, 0, 0.005);
    EXPECT_NEAR(mean("fy") / buoyancy, 0, 0.005);
    // The two other measures of the same force see the same water by other means.
    EXPECT_NEAR(mean("fz_surface") / buoyancy, 1, 0.03);
    EXPECT_NEAR(mean("fz_volume") / buoyancy, 1, 0.03);
}

}  // namespace
}  // namespace tw::test
