// Soundness checks of single runs, and what they say.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "compare/checks/checks.h"
#include "compare/compare.h"
#include "meshes/generate.h"
#include "meshes/section.h"
#include "tests/unit/compare/synthetic_pair.h"

namespace tw {
namespace checks_test {

using namespace synthetic_pair;

TEST(Checks, ARecordedCheckIsACheckOfItsRun) {
    RunRecord pressed = synthetic_run(sph);
    pressed.validity_checks = {{"compression", "%", 17.8, 5, 0.31, {1, 2, -0.5}},
                               {"Mach number", "-", 0.11, 0.15, 0.3}};
    const Comparison c = compare_records({pressed, synthetic_run(fvm)});
    const auto line = std::ranges::find(c.checks, "compression", &ValidityCheck::name);
    ASSERT_NE(line, c.checks.end());
    EXPECT_FALSE(line->pass);
    EXPECT_NE(line->remark.find("at 0.31 s, (1, 2, -0.5) m"), std::string::npos) << line->remark;
    const std::string console = summary_text(c);
    EXPECT_NE(console.find("17.8"), std::string::npos) << console;  // failed ones reach the terminal
    EXPECT_EQ(console.find("Mach number"), std::string::npos) << "met";
}

TEST(Checks, LostParticlesFailTheirCheck) {
    RunRecord leaky = synthetic_run(sph);
    leaky.table("samples").column("particles_lost", "-").values[3] = 2;
    bool failed = false;
    for (const ValidityCheck& g : compare_records({leaky, synthetic_run(fvm)}).checks)
        failed = failed || (g.name == "particles lost" && !g.pass && g.value == 2);
    EXPECT_TRUE(failed);
}

TEST(Checks, WaterMayLeaveATankByItsOpenTopAndBeforeThatItMustNotVanish) {
    RunRecord tank;
    tank.numbers["domain_z_max"] = 0.2;
    tank.raster.voxel = 0.1;
    tank.raster.count = {2, 1, 2};
    Table& samples = tank.table("samples");
    samples.time = {0.1, 0.2, 0.3};
    samples.column("mass", "kg").values = {10, 10, 6};
    tank.frames = {{0.1, {255, 255, 0, 0}}, {0.2, {255, 200, 0, 0}}, {0.3, {200, 100, 0, 7}}};
    const auto drift = [&] {
        for (const ValidityCheck& g : checks_of(tank, "SPH"))
            if (g.name == "mass drift") return g;
        return ValidityCheck{};
    };
    EXPECT_TRUE(drift().pass);
    EXPECT_EQ(drift().remark, "the water of a tank is conserved until it is at the tank's open top, 0.2 s");
    samples.column("mass", "kg").values = {10, 7, 6};
    EXPECT_FALSE(drift().pass);
    EXPECT_NEAR(drift().value, 30, 1e-9);
    samples.column("mass", "kg").values = {10, 10, 6};
    tank.frames.back().water = {200, 100, 0, 0};
    EXPECT_FALSE(drift().pass) << "it is nowhere near the top";
    EXPECT_NEAR(drift().value, 40, 1e-9);
}

TEST(Checks, DragThatTheResolutionMakesIsToldOfASubmergedBody) {
    RunRecord torpedo = synthetic_run(fvm);  // a sphere of 0.5 m, 12.5 spacings, a metre down, 8 m/s
    torpedo.hull = make_hull("sphere", {{"diameter", 0.5}});
    const double top = torpedo.hull.bounds().max.z();
    for (Vec3& p : torpedo.hull.points) p.z() -= 1.0 + top;
    torpedo.hull_pressure.clear(), torpedo.hull_wet.clear();
    torpedo.attributes["symmetry_factor"] = "1";
    const auto gate = [](const RunRecord& r) -> std::optional<ValidityCheck> {
        for (const ValidityCheck& g : checks_of(r, "fvm"))
            if (g.name == "numerical drag of a closed body") return g;
        return {};
    };
    const double numerical = 1.65 / 12.5 * 0.5 * 1000 * 64 * 0.25 * 0.25 * std::numbers::pi;  // 829 N
    ASSERT_TRUE(gate(torpedo));
    EXPECT_NEAR(gate(torpedo)->value, 100 * numerical / 251, 0.02 * 100 * numerical / 251);
    EXPECT_FALSE(gate(torpedo)->pass);
    EXPECT_NE(gate(torpedo)->remark.find("12.5 spacings"), std::string::npos) << gate(torpedo)->remark;
    EXPECT_NE(gate(torpedo)->remark.find("all of the 251 N may be"), std::string::npos) << gate(torpedo)->remark;
    torpedo.numbers["near_hull"] = 0.001;  // 500 spacings: 21 of 251 N
    EXPECT_TRUE(gate(torpedo)->pass);
    EXPECT_NE(gate(torpedo)->remark.find("N of the 251 N are"), std::string::npos) << gate(torpedo)->remark;
    for (Vec3& p : torpedo.hull.points) p.z() += 1.2;  // pierces the surface
    EXPECT_FALSE(gate(torpedo));
    EXPECT_FALSE(gate(synthetic_run(sph)));
}

TEST(Checks, AirSmearedUnderAHullIsToldWithWhatItIsWorth) {
    RunRecord smeared = synthetic_run(fvm);
    const auto air = [](const RunRecord& r) {
        for (const ValidityCheck& g : checks_of(r, "fvm"))
            if (g.name == "air in the water at the hull") return g;
        return ValidityCheck{};
    };
    EXPECT_TRUE(air(smeared).pass);
    for (Column& c : smeared.tables.at("samples").columns)
        if (c.name == "ventilation") std::ranges::fill(c.values, 0.44);
    EXPECT_FALSE(air(smeared).pass);
    EXPECT_NE(air(smeared).remark.find("friction too low in proportion"), std::string::npos) << air(smeared).remark;
    EXPECT_NE(air(smeared).remark.find("a sharper surface lowers the lift"), std::string::npos) << air(smeared).remark;
}

TEST(Checks, WaterThatStaysAttachedBehindAStepIsTold) {
    RunRecord attached = synthetic_run(fvm);
    const auto suction = [](const RunRecord& r) {
        for (const ValidityCheck& g : checks_of(r, "fvm"))
            if (g.name == "suction on the hull") return g;
        return ValidityCheck{};
    };
    EXPECT_TRUE(suction(attached).pass);
    EXPECT_EQ(suction(attached).value, 0);
    for (float& p : attached.hull_pressure) p *= -1;
    EXPECT_NEAR(suction(attached).value, 100, 1e-9);
    EXPECT_FALSE(suction(attached).pass);
}

TEST(Checks, OneFaceThatIsSuckedAtHarderThanTheStreamCanIsTold) {
    RunRecord run = synthetic_run(fvm);  // 8 m/s: rho U^2 / 2 is 32 kPa
    const auto told = [](const RunRecord& r) {
        for (const ValidityCheck& g : checks_of(r, "fvm"))
            if (g.name == "suction over rho U^2 / 2") return g;
        return ValidityCheck{};
    };
    EXPECT_TRUE(told(run).pass);
    std::size_t astern = 0;  // the face that looks most astern
    for (std::size_t t = 0; t < run.hull.triangles.size(); ++t)
        if (run.hull.area_vector2(static_cast<int>(t)).normalized().x() >
            run.hull.area_vector2(static_cast<int>(astern)).normalized().x())
            astern = t;
    std::ranges::fill(run.hull_pressure, 0.0f);
    std::ranges::fill(run.hull_wet, 1.0f);
    run.hull_pressure[astern] = -48000;
    EXPECT_NEAR(told(run).value, 1.5, 1e-6);
    EXPECT_FALSE(told(run).pass);
    EXPECT_NE(told(run).remark.find("make 100 % of the pressure drag"), std::string::npos) << told(run).remark;
    run.hull_wet[astern] = 0.2f;  // dry: air may be sucked off without a word
    EXPECT_EQ(told(run).value, 0);
    run.hull_wet[astern] = 1, run.hull_pressure[astern] = -30000;
    EXPECT_TRUE(told(run).pass);
}

/// Potential flow sucks at a sphere's side with 1.25 rho U^2 / 2, and at the edges of what lies under water with more: no
/// cell is bad there, and no air could come in.
TEST(Checks, SuctionOnRoundHullsAndUnderWaterIsNoFault) {
    const auto told = [](const RunRecord& r) {
        std::string all;
        for (const ValidityCheck& g : checks_of(r, "fvm"))
            if (g.name.starts_with("suction") && !g.pass) all += g.name + "; ";
        return all;
    };
    const auto sucked_at = [](const Surface& hull) {
        RunRecord run = synthetic_run(fvm);
        run.hull = hull;
        run.hull_pressure.assign(hull.triangles.size(), -40000.0f);  // 1.25 rho U^2 / 2
        run.hull_wet.assign(hull.triangles.size(), 1.0f);
        return run;
    };
    const Surface ball = make_hull("sphere", {{"diameter", 0.5}}), box = make_hull("box", {});
    EXPECT_EQ(told(sucked_at(posed(ball, {.draft = 0.25}))), "");
    EXPECT_EQ(told(sucked_at(posed(box, {.draft = 1.01 * box.bounds().size().z()}))), "");
    EXPECT_NE(told(sucked_at(posed(box, {.draft = 0.5 * box.bounds().size().z()}))), "") << "or this test sees nothing";
    RunRecord section = sucked_at(section_prism(posed(make_hull("cylinder", {{"diameter", 0.5}}), {.draft = 0.25})));
    section.numbers["dimensions"] = 2;
    EXPECT_EQ(told(section), "") << "the ends of a section are cuts";
}

/// A body under water with 10 N of lift left of 20 kN up and down: measures of its force that differ by 1 N agree.
TEST(Checks, MeasuresOfALiftNearZeroAreJudgedByTheLoadTheyAreMadeOf) {
    RunRecord run = synthetic_run(sph);
    const auto spread = [](const RunRecord& r) {
        for (const ValidityCheck& g : checks_of(r, "sph"))
            if (g.name == "spread of the force measures") return g;
        return ValidityCheck{};
    };
    const ValidityCheck lifted = spread(run);
    EXPECT_NEAR(lifted.value, 3, 1e-6);  // 1.02 and 0.99 of the lift
    EXPECT_EQ(lifted.remark.find("hardly"), std::string::npos);
    for (const char* name : {"fz", "fz_surface", "fz_volume"})
        std::ranges::fill(run.table("forces").column(name, "N").values, name == std::string("fz") ? 10.0 : 11.0);
    EXPECT_LT(spread(run).value, 1);
    EXPECT_TRUE(spread(run).pass);
    EXPECT_NE(spread(run).remark.find("hardly any lift"), std::string::npos);
    std::ranges::fill(run.hull_pressure, 0.0f);
    EXPECT_NEAR(spread(run).value, 10, 1e-6) << "without a load to judge by, of the lift";
}

TEST(Checks, PressureOnAPrismaticBottomStandsSquareOnItsKeel) {
    RunRecord run = synthetic_run(fvm);  // 2722 N at a trim of 5 degrees: 238.1 N of drag
    const auto told = [](const RunRecord& r) -> std::optional<ValidityCheck> {
        for (const ValidityCheck& g : checks_of(r, "fvm"))
            if (g.name == "drag against lift times tan trim") return g;
        return {};
    };
    const auto set_drag = [&](double drag) {
        std::ranges::fill(run.table("forces").column("fx_pressure", "N").values, drag);
        std::ranges::fill(run.table("forces").column("fz_pressure", "N").values, 2722);
    };
    set_drag(2722 * std::tan(5 * std::numbers::pi / 180));
    ASSERT_TRUE(told(run));
    EXPECT_NEAR(told(run)->value, 0, 1e-9);
    set_drag(214.3);  // a tenth is missing, as if something pushed at the transom's edge
    EXPECT_NEAR(told(run)->value, 10, 0.1);
    EXPECT_FALSE(told(run)->pass);
    run.hull = make_hull("sphere", {{"diameter", 0.5}});
    EXPECT_FALSE(told(run)) << "a sphere's bottom has no keel";
}

}  // namespace checks_test
}  // namespace tw
