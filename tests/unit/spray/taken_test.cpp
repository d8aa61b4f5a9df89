// Droplets from what the gate of a run took out of it.
#include <gtest/gtest.h>

#include "base/errors.h"
#include "record/spray_table.h"
#include "spray/study.h"
#include "tests/unit/record/example_record.h"

namespace tw::spray {
namespace taken_test {

/// A record with two lumps: 0.5 kg at 0.1 s and 0.008 kg at 0.2 s.
RunRecord record_with_lumps() {
    RunRecord r = example_record();
    r.numbers[spray_gate_number] = 1;
    Table& t = r.table(spray_table);
    t.time = {0.1, 0.2};
    const auto column = [&t](const char* name, const char* unit, const std::vector<double>& values) {
        t.column(name, unit).values = values;
    };
    column("x", "m", {1, 2}), column("y", "m", {0.5, 0.25}), column("z", "m", {1, 1});
    column("vx", "m/s", {3, 8}), column("vy", "m/s", {1, -1}), column("vz", "m/s", {2, 0});
    column("mass", "kg", {0.5, 0.008}), column("inner_energy", "J", {0.25, 0});
    column("particles", "-", {500, 8});
    return r;
}
SprayStudy study_of(const std::filesystem::path& run) {
    SprayStudy study;
    study.source.taken = run;
    study.air = std::make_shared<UniformAir>(AirState{});
    return study;
}

TEST(TakenByTheGate, BecomesDropletsWithTheirLedger) {
    const ScratchFolder folder;
    write_record(folder / "record.h5", record_with_lumps());
    const SprayResult r = run_spray(study_of(folder.path()));
    ASSERT_EQ(r.droplets.size(), 2u);
    EXPECT_NEAR(r.droplets[0].diameter, sphere_diameter(5e-4), 1e-15);
    EXPECT_EQ(r.droplets[0].velocity, Vec3(3, 1, 2));
    EXPECT_EQ(r.droplets[1].time, 0.2);
    const Ledger& l = r.extraction.ledger;
    EXPECT_EQ(l.taken.pieces, 508u);
    EXPECT_NEAR(l.taken.volume, 5.08e-4, 1e-15);
    EXPECT_LT((l.droplets.momentum - l.taken.momentum).norm(), 1e-12);
    EXPECT_NEAR(l.droplets.kinetic_energy + l.inner_energy, l.taken.kinetic_energy, 1e-12);
    EXPECT_EQ(l.inner_energy, 0.25);
}

TEST(TakenByTheGate, KeepsToTheLimitsOfSizeAndTime) {
    const ScratchFolder folder;
    write_record(folder / "record.h5", record_with_lumps());
    SprayStudy study = study_of(folder.path());
    study.extraction.fewest = 9;
    EXPECT_EQ(run_spray(study).extraction.ledger.crumbs.pieces, 8u);
    study.extraction.fewest = 1;
    study.extraction.largest_diameter = 0.05;
    EXPECT_EQ(run_spray(study).extraction.ledger.lumps.pieces, 500u);
    study = study_of(folder.path());
    study.source.range.from = 0.15;
    EXPECT_EQ(run_spray(study).droplets.size(), 1u);
}

TEST(TakenByTheGate, OfHalfAModelIsMirrored) {
    const ScratchFolder folder;
    RunRecord record = record_with_lumps();
    record.attributes["symmetry_factor"] = "2";
    write_record(folder / "record.h5", record);
    const SprayResult r = run_spray(study_of(folder.path()));
    ASSERT_EQ(r.droplets.size(), 4u);
    EXPECT_EQ(r.droplets[1].place, Vec3(1, -0.5, 1));
    EXPECT_EQ(r.droplets[1].velocity, Vec3(3, -1, 2));
}

TEST(TakenByTheGate, NeedsARunWithAGate) {
    const ScratchFolder folder;
    EXPECT_THROW(run_spray(study_of(folder.path())), InputError);  // no record
    write_record(folder / "record.h5", example_record());
    EXPECT_THROW(run_spray(study_of(folder.path())), InputError);
    RunRecord record = example_record();  // with a gate by which nothing has left
    record.numbers[spray_gate_number] = 1;
    write_record(folder / "record.h5", record);
    EXPECT_TRUE(run_spray(study_of(folder.path())).droplets.empty());
}

}  // namespace taken_test
}  // namespace tw::spray
