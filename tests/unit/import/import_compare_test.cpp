// An imported record beside runs: what it knows is compared, what it does not know is left out.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/compare.h"
#include "import_folder.h"
#include "tests/unit/compare/synthetic_pair.h"

namespace tw {
namespace import_compare_test {

class ImportCompareTest : public ImportTest {
protected:
    /// A run's forces as a logger would leave them: milliseconds and kilonewtons.
    void write_forces(const RunRecord& run) const {
        std::string text = "t [ms];Drag;Lift\n";
        const Table& f = run.tables.at("forces");
        for (std::size_t i = 0; i < f.time.size(); ++i)
            text += fmt::format("{};{};{}\n", 1e3 * f.time[i], 1e-3 * f.find("fx")->values[i],
                                1e-3 * f.find("fz")->values[i]);
        write("f.csv", text);
    }
    RunRecord tank(const std::string& top = "") const {
        return imported("csv", "f.csv",
                        top +
                            "time = \"t [ms]\"\n[forces]\nfx = { column = \"Drag\", unit = \"kN\" }\n"
                            "fz = { column = \"Lift\", unit = \"kN\" }\n");
    }
    /// A synthetic run that says it solved the imported record's scene.
    static RunRecord run_of(const RunRecord& scene, const SyntheticRun& o) {
        RunRecord r = synthetic_run(o);
        for (const char* key : {"scene_hash", "hull_hash", "moment_reference"})
            r.attributes[key] = scene.attributes.at(key);
        return r;
    }
    static void add_friction(RunRecord& r) {
        Table& f = r.table("forces");
        f.column("fx_viscous", "N").values.assign(f.time.size(), 50.0);
    }
};

const SyntheticRun tank_run{.method = "fvm", .lift = 2722, .drag = 251, .noise = 15, .seed = 2, .frames = false};
const SyntheticRun sph_run{.frames = false};

TEST_F(ImportCompareTest, LiftHasTwoValuesAndTheImportedOneIsThatOfItsFile) {
    write_forces(synthetic_run(tank_run));
    const RunRecord tank_record = tank();
    const RunRecord sph = run_of(tank_record, sph_run);
    const Comparison c = compare_records({sph, tank_record});
    EXPECT_EQ(c.names, (std::vector<std::string>{"sph", "towing tank"}));
    const Quantity* lift = c.find("lift");
    ASSERT_NE(lift, nullptr);
    ASSERT_EQ(lift->values.size(), 2u);
    ASSERT_TRUE(lift->values[0].known && lift->values[1].known) << lift->values[1].why_not;
    const Comparison direct = compare_records({sph, run_of(tank_record, tank_run)});
    EXPECT_NEAR(lift->values[1].value, direct.find("lift")->values[1].value, 1e-6 * 2722);
    EXPECT_NEAR(lift->values[1].half_width, direct.find("lift")->values[1].half_width, 1e-3 * 2722);
    EXPECT_EQ(lift->verdict, Verdict::not_estimated);
    EXPECT_FALSE(c.find("wetted_length")->values[1].known);
    RunRecord other = sph;
    other.attributes["scene_hash"] = "another";
    EXPECT_THROW(compare_records({other, tank_record}), InputError);
}

TEST_F(ImportCompareTest, AThirdSourceWithoutFramesTakesNothingFromTheOthers) {
    write_forces(synthetic_run(tank_run));
    const RunRecord tank_record = tank();
    SyntheticRun short_run{.duration = 1.2};
    const RunRecord sph = run_of(tank_record, short_run);
    short_run.method = "fvm";
    short_run.seed = 5;
    const RunRecord fvm = run_of(tank_record, short_run);
    const Comparison first = compare_records({tank_record, sph, fvm}), last = compare_records({sph, fvm, tank_record});
    EXPECT_EQ(first.quantities.size(), last.quantities.size());
    int surfaces = 0;
    for (const Quantity& q : last.quantities) {
        const Quantity* same = first.find(q.name);
        ASSERT_NE(same, nullptr) << q.name;
        ASSERT_EQ(same->values.size(), 3u);
        for (const int k : {0, 1}) {  // sph and fvm have moved up by one
            const std::size_t at = static_cast<std::size_t>(k);
            EXPECT_EQ(q.values[at].known, same->values[at + 1].known) << q.name;
            if (q.values[at].known) { EXPECT_DOUBLE_EQ(q.values[at].value, same->values[at + 1].value) << q.name; }
        }
        surfaces += q.name.starts_with("crest_") && q.values[0].known;
        if (q.name.starts_with("crest_") || q.name.starts_with("splash_")) {
            EXPECT_FALSE(q.values[2].known) << q.name;
        }
    }
    EXPECT_GT(surfaces, 0);
    // What is printed and written has a place for it.
    EXPECT_TRUE(says(summary_text(first), "towing tank"));
    EXPECT_TRUE(says(comparison_json(last), "\"towing tank\""));
}

TEST_F(ImportCompareTest, AMeasuredDragIsKnownToHoldFriction) {
    write_forces(synthetic_run(tank_run));
    const RunRecord tank_record = tank();
    const auto warns = [](const Comparison& c) {
        return std::ranges::any_of(c.banners,
                                   [](const std::string& b) { return says(b, "include friction in their drag"); });
    };
    RunRecord sph = run_of(tank_record, sph_run);
    EXPECT_TRUE(warns(compare_records({sph, tank_record})));
    EXPECT_FALSE(warns(compare_records({sph, tank("friction = false\n")})));
    RunRecord fvm = run_of(tank_record, tank_run);
    add_friction(fvm);
    EXPECT_FALSE(warns(compare_records({fvm, tank_record})));
    // With the tank there is no common drag without friction: all are compared whole.
    EXPECT_TRUE(warns(compare_records({sph, fvm, tank_record})));
}

TEST_F(ImportCompareTest, ASourceWithoutADragDoesNotTakeFrictionOut) {
    write("f.csv", "t [s],H [m]\n0,0.01\n1,0.02\n2,0.015\n");
    const RunRecord gauges = imported("csv", "f.csv", "time = 1\n[height]\ngauge = 2\n");
    RunRecord sph = run_of(gauges, sph_run), fvm = run_of(gauges, tank_run);
    add_friction(sph);
    add_friction(fvm);
    const Comparison c = compare_records({sph, fvm, gauges});
    for (const std::string& b : c.banners) EXPECT_FALSE(says(b, "friction")) << b;
    ASSERT_NE(c.find("height:gauge"), nullptr);
    EXPECT_DOUBLE_EQ(c.find("height:gauge")->values[2].value, 0.02);
    EXPECT_FALSE(c.find("lift")->values[2].known);
    // One of the two without friction: it is left out, as before.
    const Comparison mixed = compare_records({run_of(gauges, sph_run), fvm, gauges});
    EXPECT_TRUE(
        std::ranges::any_of(mixed.banners, [](const std::string& b) { return says(b, "Only one method solves"); }));
}

TEST_F(ImportCompareTest, AShortSeriesIsToldSo) {
    write("f.csv", "t [ms];Drag;Lift\n0;1;2\n100;1;2\n200;1;2\n");
    const RunRecord tank_record = tank();
    const Comparison c = compare_records({run_of(tank_record, sph_run), tank_record});
    EXPECT_FALSE(c.find("lift")->values[1].known);
    EXPECT_TRUE(says(c.find("lift")->values[1].why_not, "record too short"));
}

}  // namespace import_compare_test
}  // namespace tw
