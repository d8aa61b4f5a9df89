#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <tuple>

#include "base/errors.h"
#include "compare/compare.h"
#include "compare/metrics/box_walls.h"
#include "compare/report/report_files.h"
#include "compare/verdict/quantity_kinds.h"
#include "methods/methods.h"
#include "tests/unit/compare/synthetic_pair.h"

namespace tw {
namespace compare_test {

using namespace synthetic_pair;

TEST(Compare, MeansOfBothSidesAndTheirDifference) {
    const Comparison c = compare_records({synthetic_run(sph), synthetic_run(fvm)});
    const Quantity* lift = c.find("lift");
    ASSERT_NE(lift, nullptr);
    ASSERT_TRUE(lift->values[0].known && lift->values[1].known) << lift->remark;
    EXPECT_NEAR(lift->values[0].value, 2800, 1.5 * lift->values[0].half_width);
    EXPECT_NEAR(lift->values[1].value, 2722, 1.5 * lift->values[1].half_width);
    EXPECT_DOUBLE_EQ(lift->difference, lift->values[1].value - lift->values[0].value);
    // One size each: far apart or near, whether they differ is not known.
    EXPECT_EQ(lift->verdict, Verdict::not_estimated);
    EXPECT_EQ(c.find("drag")->verdict, Verdict::not_estimated);
    EXPECT_EQ(c.names, (std::vector<std::string>{"sph", "fvm"}));
    EXPECT_NEAR(c.find("wetted_length")->values[0].half_width, 0.02, 1e-12);  // half the spacing at the hull
}

/// Two runs and a third source, which says that it was imported.
Comparison of_three() {
    RunRecord tank =
        synthetic_run({.method = "towing tank", .lift = 2600, .drag = 240, .noise = 15, .seed = 3, .frames = false});
    tank.attributes["import_kind"] = "csv";
    return compare_records({synthetic_run(sph), synthetic_run(fvm), tank});
}

TEST(Compare, OfThreeSourcesEveryTwoHaveTheirDifferenceInTextJsonAndTable) {
    const Comparison c = of_three();
    const Quantity& lift = *c.find("lift");
    ASSERT_EQ(lift.pairs.size(), 3u);
    for (const Difference& d : lift.pairs) {
        EXPECT_DOUBLE_EQ(d.difference, lift.values[d.b].value - lift.values[d.a].value);
        EXPECT_GT(d.interval, 0);
    }
    EXPECT_NEAR(lift.pairs[0].difference, -78, 30);
    EXPECT_NEAR(lift.pairs[1].difference, -200, 30);
    EXPECT_NEAR(lift.pairs[2].difference, -122, 20);

    const std::string text = summary_text(c);
    for (const char* said :
         {"| interFoam − SPH", "| towing tank − SPH", "| towing tank − interFoam", "are farthest apart, by"})
        EXPECT_NE(text.find(said), std::string::npos) << said << "\n" << text;
    const auto json = nlohmann::json::parse(comparison_json(c));
    const auto& q = json["quantities"][0];
    ASSERT_EQ(q["name"], "lift");
    ASSERT_EQ(q["pairs"].size(), 3u);
    EXPECT_EQ(q["pairs"][2]["sources"], nlohmann::json({"fvm", "towing tank"}));
    EXPECT_DOUBLE_EQ(q["pairs"][2]["difference"], lift.pairs[2].difference);
    const std::string csv = quantities_csv(c);
    EXPECT_NE(csv.substr(0, csv.find('\n')).find("towing tank - fvm,towing tank - fvm interval"), std::string::npos);
    // Of two sources nothing of this is written: their difference is the quantity's own.
    const Comparison two = compare_records({synthetic_run(sph), synthetic_run(fvm)});
    EXPECT_FALSE(nlohmann::json::parse(comparison_json(two))["quantities"][0].contains("pairs"));
    EXPECT_EQ(quantities_csv(two).find(" - "), std::string::npos);
}

TEST(Compare, AMethodThatNobodyKnowsIsNamedWithThoseThatAreKnown) {
    const auto named = [](const Comparison& c) {
        return std::ranges::any_of(c.banners, [](const std::string& b) {
            return b.starts_with("lattice Boltzmann: no method of this version (sph, fvm), and no import");
        });
    };
    RunRecord other = synthetic_run(fvm);
    other.attributes["method"] = "lattice Boltzmann";
    EXPECT_TRUE(named(compare_records({synthetic_run(sph), other})));
    other.attributes["import_kind"] = "csv";
    EXPECT_FALSE(named(compare_records({synthetic_run(sph), other})));
    try {
        method_named("lbm");
        FAIL();
    } catch (const InputError& e) { EXPECT_STREQ(e.what(), "lbm: there is no such method; expected one of: sph, fvm"); }
}

TEST(Compare, WhatStandsBesideIsNotJudged) {
    const Comparison c = compare_records({synthetic_run(sph), synthetic_run(fvm)});
    for (const char* name : {"lift_surface", "lift_volume", "lift_air", "ventilation", "force_measure_spread"}) {
        ASSERT_NE(c.find(name), nullptr) << name;
        EXPECT_FALSE(c.find(name)->judged) << name;
    }
    EXPECT_NEAR(c.find("force_measure_spread")->values[0].value, 3, 0.1);  // 1.02 against 0.99
    EXPECT_FALSE(c.find("lift_air")->values[0].known);
    ASSERT_EQ(c.references.size(), 5u);  // lift, drags; the lift at each run's own wetted length
    EXPECT_NEAR(c.references[0].value, 2334, 2);   // lift by Savitsky
    EXPECT_NEAR(c.references[1].value, 204, 0.5);  // pressure drag: neither run has friction
}

TEST(Compare, DifferentScenesAreRefusedUnlessForced) {
    RunRecord other = synthetic_run(fvm);
    other.attributes["scene_hash"] = "scene-2";
    try {
        compare_records({synthetic_run(sph), other});
        FAIL() << "compared what was not made from one scene";
    } catch (const InputError& e) { EXPECT_NE(std::string(e.what()).find("scene-2"), std::string::npos); }
    const Comparison forced = compare_records({synthetic_run(sph), other}, {.force = true});
    EXPECT_NE(forced.banners.at(0).find("Forced comparison"), std::string::npos);
    RunRecord hull = synthetic_run(fvm);
    hull.attributes["hull_hash"] = "hull-2";
    EXPECT_THROW(compare_records({synthetic_run(sph), hull}), InputError);
    EXPECT_THROW(compare_records({}), InputError);
    EXPECT_THROW(compare_records({synthetic_run(sph)}, {.agree_within = 0}), InputError);
}

TEST(Compare, AWettedLengthOfNothingIsNotMeasured) {
    std::vector<RunRecord> dry{synthetic_run(sph), synthetic_run(fvm)};
    for (RunRecord& r : dry)
        for (double& v : r.table("samples").column("wetted_length", "m").values) v = 0;
    const Comparison c = compare_records(dry);
    const Quantity* length = c.find("wetted_length");
    EXPECT_FALSE(length->values[0].known || length->values[1].known);
    EXPECT_EQ(length->verdict, Verdict::not_comparable);
    EXPECT_NE(length->remark.find("not measured (no part of the hull is wet)"), std::string::npos) << length->remark;
}

TEST(Compare, AWakeThatTheRasterClipsIsNotJudgedHoweverNarrowItIsElsewhere) {
    SyntheticRun o{.duration = 1.5, .wave = 0.3, .frames = true};
    RunRecord narrow = synthetic_run(o);
    for (RasterFrame& f : narrow.frames) {  // a crest from side to side behind the hull
        const auto [nx, ny, nz] = std::tuple(narrow.raster.count[0], narrow.raster.count[1], narrow.raster.count[2]);
        for (int k = 0; k < nz / 2 + 5; ++k)
            for (int j = 0; j < ny; ++j)
                for (int i = nx - 34; i < nx; ++i) f.water[static_cast<std::size_t>((k * ny + j) * nx + i)] = 255;
    }
    const MeanValue wide = compare_records({narrow}).find("wake_width")->values[0];
    EXPECT_FALSE(wide.known);
    EXPECT_NE(wide.why_not.find("the wake is as wide as the raster"), std::string::npos) << wide.why_not;
    for (RunRecord r : {narrow}) {  // the crest ends before the sides but for the last stations
        const auto [nx, ny, nz] = std::tuple(r.raster.count[0], r.raster.count[1], r.raster.count[2]);
        for (RasterFrame& f : r.frames)
            for (int k = nz / 2; k < nz; ++k)
                for (int i = nx - 34; i < nx - 4; ++i)
                    for (const int j : {0, 1, ny - 2, ny - 1})
                        f.water[static_cast<std::size_t>((k * ny + j) * nx + i)] = 0;
        EXPECT_FALSE(compare_records({r}).find("wake_width")->values[0].known);
    }
    EXPECT_EQ(compare_records({synthetic_run({.duration = 1.5})}).find("wake_width")->values[0].why_not.find("as wide"),
              std::string::npos);
}

TEST(Compare, HalfModelsSayTheirFactor) {
    const Comparison c = compare_records({synthetic_run(sph), synthetic_run(fvm)});
    ASSERT_FALSE(c.banners.empty());
    EXPECT_NE(c.banners[0].find("multiplied by 2"), std::string::npos);
}

TEST(Compare, OneMethodAloneStandsWithoutAVerdict) {
    const Comparison c = compare_records({synthetic_run(sph)});
    EXPECT_TRUE(c.find("lift")->values[0].known);
    EXPECT_EQ(c.find("lift")->verdict, Verdict::not_comparable);
}

TEST(Compare, AMethodWithoutForcesIsNotComparable) {
    RunRecord mute = synthetic_run(fvm);
    mute.tables.erase("forces");
    const Comparison c = compare_records({synthetic_run(sph), mute});
    EXPECT_EQ(c.find("lift")->verdict, Verdict::not_comparable);
    EXPECT_TRUE(std::isnan(c.find("lift")->difference));
}

TEST(Compare, FrictionOnOneSideOnlyIsLeftOutAndSaidSo) {
    RunRecord viscous = synthetic_run(fvm);
    Table& forces = viscous.table("forces");
    const auto pressure = forces.find("fx_pressure")->values;
    forces.column("fx_viscous", "N").values.assign(pressure.size(), 150);
    for (double& v : forces.column("fx", "N").values) v += 150;
    const Comparison c = compare_records({synthetic_run(sph), viscous});
    EXPECT_NEAR(c.find("drag")->values[1].value, 251, 3);
    EXPECT_NE(c.find("drag")->remark.find("friction left out"), std::string::npos);
    EXPECT_NEAR(c.find("drag_friction")->values[1].value, 150, 1e-6);
    bool said = false;
    for (const auto& b : c.banners) said = said || b.find("friction") != std::string::npos;
    EXPECT_TRUE(said);
}

TEST(Compare, DraftSensitivityIsPartOfTheInterval) {
    RunRecord a = synthetic_run(sph), b = synthetic_run(fvm);
    const double without = compare_records({a, b}).find("lift")->interval;
    a.numbers["lift_per_draft"] = 22000;  // 22 N per mm, known to a tenth of 40 mm
    const Quantity with = *compare_records({a, b}).find("lift");
    EXPECT_NEAR(with.interval, std::hypot(without, 88), 1e-6);
    EXPECT_EQ(with.verdict, Verdict::not_estimated);
    EXPECT_NE(with.remark.find("draft"), std::string::npos);
}

TEST(Compare, NotANumberInASeriesDoesNotSpread) {
    RunRecord a = synthetic_run(sph);
    auto& fz = a.table("forces").column("fz", "N").values;
    for (std::size_t i = 0; i < fz.size(); i += 11) fz[i] = std::nan("");
    const Comparison c = compare_records({a, synthetic_run(fvm)});
    EXPECT_TRUE(c.find("lift")->values[0].known);
    EXPECT_NEAR(c.find("lift")->values[0].value, 2800, 30);
    for (double& v : a.table("forces").column("fz", "N").values) v = std::nan("");
    EXPECT_EQ(compare_records({a, synthetic_run(fvm)}).find("lift")->verdict, Verdict::not_comparable);
}

TEST(Compare, AShortRunIsUndecidedWithTheTimeThatIsMissing) {
    SyntheticRun brief = sph;
    brief.duration = 0.7;
    const Quantity lift = *compare_records({synthetic_run(brief), synthetic_run(fvm)}).find("lift");
    EXPECT_EQ(lift.verdict, Verdict::undecided);
    EXPECT_NE(lift.remark.find("s more is needed"), std::string::npos);
}

TEST(Compare, RunsThatDidNotFinishCarryABannerAndAGate) {
    RunRecord stopped = synthetic_run(fvm);
    stopped.state = "stopped";
    stopped.reason = "asked to stop";
    const Comparison c = compare_records({synthetic_run(sph), stopped});
    bool banner = false, gate = false;
    for (const auto& b : c.banners) banner = banner || b.find("asked to stop") != std::string::npos;
    for (const ValidityCheck& g : c.checks) gate = gate || (g.source == "fvm" && g.name == "finished" && !g.pass);
    EXPECT_TRUE(banner);
    EXPECT_TRUE(gate);
}

/// How often a text stands in another.
int count_of(const std::string& what, const std::string& text) {
    int n = 0;
    for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + 1)) ++n;
    return n;
}

TEST(Compare, ARunThatFailedIsNamedOnceAndComparedWithNothing) {
    const auto summary = [](std::vector<RunRecord> records) {
        records[0].state = "failed";
        records[0].reason = "the time step has collapsed";
        return summary_text(compare_records(std::move(records)));
    };
    SyntheticRun wrecked = sph;
    wrecked.lift = 193e3;
    const std::string two = summary({synthetic_run(wrecked), synthetic_run(fvm)});
    EXPECT_EQ(two.find("SPH failed: the time step has collapsed. "), 0u) << two;
    EXPECT_EQ(count_of("the time step has collapsed", two), 1) << two;
    EXPECT_EQ(count_of("apart by", two), 0) << two;
    EXPECT_NE(two.find(" 193"), std::string::npos) << "what it recorded is in the tables\n" << two;
    EXPECT_EQ(count_of("One run only", summary({synthetic_run(wrecked)})), 1);

    RunRecord third = synthetic_run(fvm);
    third.attributes["method"] = "measured";
    const std::string three = summary({synthetic_run(wrecked), synthetic_run(fvm), third});
    EXPECT_NE(three.find("Lift: interFoam and measured are farthest apart"), std::string::npos) << three;
}

TEST(Compare, MomentsAreTakenAboutOnePoint) {
    RunRecord a = synthetic_run(sph), b = a;
    a.attributes["moment_reference"] = "0 0 0";
    b.attributes["moment_reference"] = "0.5 0 0.2";
    auto& my = b.table("forces").column("my", "N m").values;
    for (std::size_t i = 0; i < my.size(); ++i)  // the same force, its moment taken about the other point
        my[i] += -0.2 * b.series("forces", "fx")->values[i] + 0.5 * b.series("forces", "fz")->values[i];
    const Comparison c = compare_records({a, b});
    EXPECT_NEAR(c.find("trim_moment")->difference, 0, 1e-6);
    EXPECT_NEAR(c.find("trim_moment")->values[0].value, 900, 20);
}

TEST(Compare, RasterColumnsHalfOutsideTheDomainAreLeftOut) {
    RunRecord a = synthetic_run({}), b = a;
    for (RunRecord* r : {&a, &b})
        r->numbers["domain_x_max"] = r->raster.origin.x() + (r->raster.count[0] - 0.5) * r->raster.voxel;
    for (RasterFrame& f : b.frames)  // as a mesh that ends with the domain leaves it: half the water of the last column
        for (std::size_t v = static_cast<std::size_t>(b.raster.count[0]) - 1; v < f.water.size();
             v += static_cast<std::size_t>(b.raster.count[0]))
            f.water[v] /= 2;
    const Comparison c = compare_records({a, b});
    EXPECT_EQ(c.sources[1].raster.count[0], a.raster.count[0] - 1);
    for (const Quantity& q : c.quantities) {
        if (q.judged) { EXPECT_EQ(q.difference, 0) << q.name; }
    }
}

TEST(Compare, AHullStoredAsOneHalfIsCompleted) {
    RunRecord half = synthetic_run(sph);
    Surface side;
    side.points = half.hull.points;
    std::vector<float> pressure, wet;
    for (std::size_t t = 0; t < half.hull.triangles.size(); ++t) {
        double lowest = 1;
        for (int k = 0; k < 3; ++k) lowest = std::min(lowest, half.hull.corner(static_cast<int>(t), k).y());
        if (lowest < -1e-9) continue;
        side.triangles.push_back(half.hull.triangles[t]);
        pressure.push_back(half.hull_pressure[t]);
        wet.push_back(half.hull_wet[t]);
    }
    for (Vec3& p : side.points) p.y() = std::max(p.y(), 0.0);  // points of the other side are no longer used
    half.hull = side;
    half.hull_pressure = pressure;
    half.hull_wet = wet;
    const Comparison c = compare_records({half});
    EXPECT_EQ(c.sources[0].hull.triangles.size(), 2 * side.triangles.size());
    EXPECT_EQ(c.sources[0].hull_pressure.size(), 2 * side.triangles.size());
    ASSERT_FALSE(c.references.empty());
    EXPECT_NEAR(c.references[0].value, 2334, 2);  // the whole beam
}

TEST(Compare, TwoRunsOfOneMethodAreToldApart) {
    EXPECT_EQ(compare_records({synthetic_run(sph), synthetic_run(sph)}).names,
              (std::vector<std::string>{"sph", "sph 2"}));
    const Comparison same = compare_records({synthetic_run(sph), synthetic_run(sph)});
    EXPECT_EQ(same.find("lift")->difference, 0);
    EXPECT_EQ(same.find("lift")->verdict, Verdict::not_estimated);
}

TEST(Compare, SplashOfBothSidesOnTheCommonRaster) {
    SyntheticRun a = sph, b = fvm;
    a.frames = b.frames = true;
    a.splash = 0.5;
    b.splash = 0.3;
    const Comparison c = compare_records({synthetic_run(a), synthetic_run(b)});
    const Quantity* sheet = c.find("splash_sheet_height");
    ASSERT_TRUE(sheet->values[0].known && sheet->values[1].known) << sheet->remark;
    EXPECT_NEAR(sheet->values[0].value, 0.5, 0.04);
    EXPECT_NEAR(sheet->values[1].value, 0.3, 0.04);
    EXPECT_GE(sheet->values[0].half_width, 0.04);  // half a voxel
    EXPECT_EQ(sheet->verdict, Verdict::not_estimated);
    EXPECT_FALSE(c.find("splash_raw_max")->judged);
    EXPECT_NEAR(c.find("splash_raw_max")->values[0].value, 0.9, 0.05);  // the lone drop
    EXPECT_TRUE(c.find("wake_width")->values[0].known);
}

TEST(Compare, WhatTheWallsOfTheBoxDoStandsOnTop) {
    RunRecord r = synthetic_run(sph);
    const std::string walls =
        "the walls of the box (1.5 m to the side, 1.2 m deep) are expected to raise the lift by 12 %";
    const auto said = [&](const RunRecord& record) {
        return std::ranges::any_of(all_banners(compare_records({record})),
                                   [&](const std::string& b) { return b.find(walls) != std::string::npos; });
    };
    EXPECT_FALSE(said(r));
    r.attributes["box_walls"] = walls;
    EXPECT_TRUE(said(r));
}

TEST(Compare, AChannelThatIsMeantIsSaidOnTop) {
    RunRecord r = synthetic_run(sph);
    r.attributes["channel"] = "a channel of this size (1.5 m to each side, 1.2 m deep)";
    const Comparison c = compare_records({r});
    const std::string said =
        "Values are those of a hull in a channel of this size (1.5 m to each side, 1.2 m deep), not of open water.";
    EXPECT_EQ(std::ranges::count(c.banners, said), 1);
    EXPECT_EQ(c.walls, "");
}

TEST(Compare, ForcesInATankAreNamedByTheirDirections) {
    RunRecord stream = synthetic_run(sph), tank = stream;
    tank.attributes["motion"] = "none";
    const Comparison of_stream = compare_records({stream}), of_tank = compare_records({tank});
    for (const auto& [name, in_a_stream, in_a_tank] :
         {std::tuple{"lift", "Lift", "Force up"},
          {"drag", "Pressure drag", "Force along x"},
          {"trim_moment", "Trim moment", "Moment about y"},
          {"drag_pressure", "Drag by pressure", "Force along x by pressure"},
          {"lift_surface", "Lift by surface pressure", "Force up by surface pressure"}}) {
        ASSERT_TRUE(of_stream.find(name) && of_tank.find(name)) << name;
        EXPECT_EQ(of_stream.find(name)->label, in_a_stream);
        EXPECT_EQ(of_tank.find(name)->label, in_a_tank);
    }
    const std::string text = summary_text(of_tank);
    for (const char* word : {"Lift", "lift", "Drag", "drag"})
        EXPECT_EQ(text.find(word), std::string::npos) << word << text;
}

TEST(Compare, OfAJetThatIsNotResolvedTheHeightIsShownAndNotJudged) {
    const auto compared = [](double jet) {
        SyntheticRun a = sph, b = fvm;
        a.frames = b.frames = true;
        RunRecord first = synthetic_run(a), second = synthetic_run(b);
        for (RunRecord* r : {&first, &second}) r->numbers["jet_thickness"] = jet, r->numbers["jet_spacing"] = 0.05;
        second.numbers["jet_spacing"] = 0.1;  // the coarser one decides
        return compare_records({first, second});
    };
    const Comparison thin = compared(0.04), thick = compared(0.31);
    const std::string why =
        "not resolved: the jet is 0.4 of a particle or cell thick, and three across it are needed (near_hull = 13 "
        "mm)";
    for (const char* name : {"splash_sheet_height", "splash_p99", "airborne_volume"}) {
        EXPECT_EQ(thin.find(name)->not_resolved, why) << name;
        EXPECT_FALSE(thin.find(name)->judged) << name;
        EXPECT_EQ(thick.find(name)->not_resolved, "") << name;
        EXPECT_TRUE(thick.find(name)->judged) << name;
    }
    EXPECT_TRUE(thin.find("splash_sheet_height")->values[0].known);
    const std::string text = summary_text(thin);
    EXPECT_NE(text.find("Splash height (connected sheet): " + why + "."), std::string::npos) << text;
    EXPECT_EQ(summary_text(thick).find("not resolved"), std::string::npos);
    EXPECT_TRUE(thin.find("splash_raised")->judged) << "an integral needs no jet";
    EXPECT_LT(main_rank("splash_raised"), main_rank("splash_sheet_height"));
}

TEST(Compare, AColumnInTwoUnitsIsRefused) {
    RunRecord a = synthetic_run({}), b = synthetic_run({.method = "fvm"});
    for (RunRecord* r : {&a, &b}) {
        Table& t = r->table("pressure");
        t.time = {0, 1, 2};
        t.column("P1", r == &a ? "Pa" : "kPa").values = {1, 2, 3};
    }
    try {
        compare_records({a, b});
        FAIL() << "compared";
    } catch (const InputError& e) {
        EXPECT_NE(std::string(e.what()).find("P1 of table pressure is in Pa in SPH and in kPa in interFoam"),
                  std::string::npos)
            << e.what();
    }
    EXPECT_THROW(compare_records({a, b}, {.force = true}), InputError);  // no banner mends a unit
}

TEST(Compare, OneRunAloneSaysSo) {
    const Comparison c = compare_records({synthetic_run({})});
    ASSERT_FALSE(c.banners.empty());
    EXPECT_NE(c.banners.front().find("One run only, SPH"), std::string::npos);
}

}  // namespace compare_test
}  // namespace tw
