#include <cmath>

#include "base/numbers.h"
#include "meshes/surface.h"
#include "scene/hash.h"
#include "scene_text.h"

namespace tw::test {
namespace scene_test {

TEST(Scene, TwentyLinesGiveTheWholeDescription) {
    const Scene s = scene_of(planing);
    EXPECT_NEAR(s.hull->trim, 5 * degree, 1e-15);
    EXPECT_NEAR(s.hull->surface.bounds().min.z(), -0.2, 1e-12);  // the draft, whatever the trim
    EXPECT_DOUBLE_EQ(s.sph.c0, 80);                              // 10 U
    EXPECT_NEAR(s.motion.ramp, 0.3 * s.hull->length / 8, 1e-12);
    EXPECT_NEAR(s.sampling.mean_from, 1.3 * s.hull->length / 8, 1e-12);  // one L/U after the ramp
    EXPECT_EQ(s.domain.x_min, Side::inlet);
    EXPECT_EQ(s.domain.x_max, Side::outlet);
    EXPECT_EQ(s.domain.y_min, Side::symmetry);
    EXPECT_EQ(s.domain.z_max, Side::atmosphere);
    EXPECT_EQ(s.symmetry_factor(), 2);
    EXPECT_DOUBLE_EQ(s.water.depth, -s.domain.box.min.z());
}

TEST(Scene, TheStillHullDisplacesWhatGeometrySays) {
    // Wetted at rest: the keel from the transom forward to draft / sin(trim); sections at depth d under the water are
    // triangles of d^2 / tan(deadrise) while the chine is dry, cut at the chine depth where it is wet.
    const Scene s = scene_of(planing);
    const double beta = 20 * degree, trim = 5 * degree, chine = 0.5 * std::tan(beta);
    double volume =
        0;  // per section normal to the keel; the keel's draft there is x sin(trim) / cos(trim) in hull axes
    constexpr int n = 20000;
    const double wet_keel = 0.2 / std::sin(trim);
    for (int i = 0; i < n; ++i) {
        const double along = (i + 0.5) / n * wet_keel;
        const double d = along * std::tan(trim);  // depth normal to the keel
        const double triangle = std::min(d, chine), above = std::max(0.0, d - chine);
        volume += (triangle * triangle / std::tan(beta) + above) * wet_keel / n;
    }
    // The transom is square to the keel: the waterline meets it, so sections end there.
    EXPECT_NEAR(s.hull->still.volume / volume, 1, 0.02);
}

TEST(Scene, TheHashIsOfTheNumbersOnly) {
    const std::string hash = scene_of(planing).hash;
    const auto hash_with = [](const std::string& from, const std::string& to) {
        return scene_of(with(planing, from, to)).hash;
    };
    // The same physics in other words
    EXPECT_EQ(hash, hash_with("title = \"planing\"", "title = \"another <b>title</b>\" # and a comment"));
    EXPECT_EQ(hash, hash_with("\"8 m/s\"", "8.0"));
    EXPECT_EQ(hash, hash_with("\"0.05 m\"", "\"50 mm\""));
    EXPECT_EQ(hash, hash_with("duration = \"1.5 s\"", "duration = \"1.5 s\"\nthreads = 1"));
    EXPECT_EQ(hash, hash_with("duration = \"1.5 s\"", "duration = \"3 s\""));  // a longer run of the same question
    EXPECT_EQ(hash, hash_with("[run]", "[sph]\nalpha = 0.02\n[fvm]\nmax_courant = 2\n[run]"));
    EXPECT_EQ(hash, hash_with("methods  = [\"sph\", \"fvm\"]", "methods  = [\"fvm\"]"));
    // Another physics
    EXPECT_NE(hash, hash_with("\"8 m/s\"", "\"8.001 m/s\""));
    EXPECT_NE(hash, hash_with("\"5 deg\"", "\"5.01 deg\""));
    EXPECT_NE(hash, hash_with("\"0.2 m\"", "\"0.201 m\""));
    EXPECT_NE(hash, hash_with("\"0.05 m\"", "\"0.04 m\""));
    EXPECT_NE(hash, hash_with("[motion]", "[water]\ndensity = 1025\n[motion]"));
    EXPECT_NE(hash, hash_with("[motion]", "[domain]\nside = 3\n[motion]"));
    EXPECT_NE(hash, hash_with("[run]", "[sampling]\ncuts_x = [1]\n[run]"));
}

TEST(Scene, TheHashSeesEachNumberByItself) {
    // With every default that follows from the speed written out, the speed itself must still count; and so for the
    // rest.
    const std::string fixed = planing +
                              "[sampling]\ninterval = 0.02\nmean_from = 0.7\n[domain]\nx = [-3, 5]\ny = [-2, 2]\nz = "
                              "[-1.6, 2]\n[sph]\nc0 = 100\n"
                              "[water]\ndensity = 1000\n";
    const std::string hash = scene_of(fixed).hash;
    const std::pair<const char*, const char*> changes[] = {{"\"8 m/s\"", "8.1"},
                                                           {"mean_from = 0.7", "mean_from = 0.8"},
                                                           {"interval = 0.02", "interval = 0.03"},
                                                           {"x = [-3, 5]", "x = [-3, 5.1]"},
                                                           {"density = 1000", "density = 1001"},
                                                           {"density = 1000", "gravity = 9.8"},
                                                           {"density = 1000", "viscosity = 2e-6"},
                                                           {"density = 1000", "surface_tension = 0"},
                                                           {"density = 1000", "air_density = 1"},
                                                           {"half     = true", "half     = false"},
                                                           {"c0 = 100", "c0 = 100\n[effects]\nshifting = \"off\""}};
    for (const auto& [from, to] : changes) EXPECT_NE(scene_of(with(fixed, from, to)).hash, hash) << to;
}

TEST(Scene, AnOptionOnTheCommandLineIsTheSameAsInTheFile) {
    SceneOverrides o;
    o.speed = 12;
    o.near_hull = 0.04;
    EXPECT_EQ(scene_of(planing, o).hash, scene_of(with(with(planing, "\"8 m/s\"", "12"), "\"0.05 m\"", "0.04")).hash);
    SceneOverrides finer;
    finer.scale_resolution = 0.5;
    EXPECT_EQ(scene_of(planing, finer).resolution.near_hull, 0.025);
}

TEST(Scene, ScalesOfOneSceneAreOneFamily) {
    const Scene base = scene_of(planing);
    for (const double scale : {0.5, 1.41421356, 3.0}) {
        SceneOverrides o;
        o.scale_resolution = scale;
        const Scene s = scene_of(planing, o);
        EXPECT_NEAR(s.resolution.near_hull, scale * base.resolution.near_hull, 1e-12);
        EXPECT_NEAR(s.resolution.spacing, scale * base.resolution.spacing, 1e-12);
        ASSERT_EQ(s.refinement.size(), base.refinement.size());
        for (std::size_t k = 0; k < s.refinement.size(); ++k)
            EXPECT_EQ(s.refinement[k].level, base.refinement[k].level);
    }
}

TEST(Scene, AHullHeldInAStreamNeedsTwoPressureCorrectorsUnlessTheSceneSaysHowMany) {
    EXPECT_EQ(scene_of(planing).fvm.correctors, 2);
    EXPECT_EQ(scene_of(with(planing, "[run]", "[fvm]\ncorrectors = 3\n[run]")).fvm.correctors, 3);
    EXPECT_EQ(scene_of(planing + "[effects]\nviscosity = \"on\"\n").fvm.correctors, 3) << "not measured";
    EXPECT_EQ(scene_of("[tank]\nsize = [1, 1, 1]\n[[water_block]]\nmin = [0, 0, 0]\nmax = [0.5, 1, 0.5]\n"
                       "[resolution]\nnear_hull = 0.1\n")
                  .fvm.correctors,
              3);
}

TEST(Scene, AStreamBearsALargeCourantNumberAndASplashDoesNot) {
    EXPECT_EQ(scene_of(planing).fvm.max_courant, 4);
    EXPECT_EQ(scene_of(with(planing, "[run]", "[fvm]\nmax_courant = 2\n[run]")).fvm.max_courant, 2);
    EXPECT_EQ(scene_of("[tank]\nsize = [1, 1, 1]\n[[water_block]]\nmin = [0, 0, 0]\nmax = [0.5, 1, 0.5]\n"
                       "[resolution]\nnear_hull = 0.1\n")
                  .fvm.max_courant,
              1);
}

TEST(Scene, ASwappedHullNeedsNoOtherEdit) {
    // The same hull twice as large, from a file: everything that follows from its size follows.
    const Scene small = scene_of(planing + one_size);
    const auto file = scratch() / "a big hull.stl";
    Surface big = small.hull->surface;
    for (Vec3& p : big.points) p *= 2;
    write_stl(file, big);
    SceneOverrides o;
    o.hull_file = file;
    const Scene s = scene_of(with(planing, "trim     = \"5 deg\"\n", "") + one_size, o);
    EXPECT_NEAR(s.hull->length / small.hull->length, 2, 1e-6);
    EXPECT_NEAR(s.domain.box.size().y() / small.domain.box.size().y(), 2, 0.21);  // faces go out to whole cells
    EXPECT_GT(s.sampling.mean_from, 2 * small.sampling.mean_from);  // below Froude number 1 it waits for the wave too
    EXPECT_EQ(s.hull->source, file.string());
}

TEST(Scene, TheBoxUnderASubmergedBodyFollowsFromItsHeightAndNotFromItsDepth) {
    const auto floor = [](const std::string& draft) {
        return -scene_of("[hull]\nshape = \"torpedo\"\ndraft = \"" + draft + "\"\n[motion]\nspeed = \"8 m/s\"\n" +
                         one_size)
                    .domain.as_asked.min.z();
    };
    EXPECT_NEAR(floor("2 m"), 2 + 3 * 0.32, 1e-6);  // its diameter is 0.32 m
    EXPECT_NEAR(floor("0.31 m"), 4 * 0.31, 1e-6);   // it breaks the surface: a ship
}

TEST(Scene, AHullThatCannotBeSolvedIsRefusedAtItsKey) {
    EXPECT_EQ(complaint(with(planing, "draft    = \"0.2 m\"", "draft    = \"-0.1 m\"")).substr(0, 73),
              "scene.toml:8:12: [hull] draft = \"-0.1 m\": the hull is not in the water: i");
    EXPECT_NE(complaint(with(planing, "draft    = \"0.2 m\"\n", "")).find("the hull is not in the water"),
              std::string::npos);  // a shape stands on z = 0
    EXPECT_NE(complaint(with(planing, "[motion]", "[domain]\nside = 0.4\n[motion]"))
                  .find("scene.toml:12:8: [domain] side = 0.4: the hull is larger than the domain: in y"),
              std::string::npos);
    EXPECT_NE(complaint(with(planing, "[motion]", "[water]\ndepth = 0.15\n[motion]"))
                  .find("[water] depth = 0.15: the hull is larger than the domain: in z"),
              std::string::npos);
    EXPECT_NE(complaint(with(planing, "draft    = \"0.2 m\"", "heel = \"3 deg\"\ndraft = 0.2"))
                  .find("a heeled hull is not symmetric"),
              std::string::npos);
}

TEST(Scene, AnUnhealthyHullIsRefusedUnlessItCanBeMended) {
    Surface flipped = scene_of(planing).hull->surface;
    std::swap(flipped.triangles[4][0], flipped.triangles[4][1]);
    write_stl(scratch() / "flipped.stl", flipped);
    const std::string text = with(
        planing,
        "shape    = \"prismatic\"\nlength   = \"4 m\"\nbeam     = \"1 m\"\ndeadrise = \"20 deg\"\ntrim     = \"5 deg\"",
        "file = \"flipped.stl\"");
    const std::string message = complaint(text);
    EXPECT_EQ(message.substr(0, 61), "scene.toml:3:8: [hull] file = \"flipped.stl\": flipped_normals:") << message;
    EXPECT_EQ(complaint(with(text, "half ", "repair = true\nhalf ")), "");
}

TEST(Scene, AOneSidedHullIsNotHalved) {
    Surface lopsided = scene_of(planing).hull->surface;
    for (Vec3& p : lopsided.points)
        if (p.y() > 0.1) p.y() *= 1.2;
    write_stl(scratch() / "lopsided.stl", lopsided);
    const std::string text = with(
        planing,
        "shape    = \"prismatic\"\nlength   = \"4 m\"\nbeam     = \"1 m\"\ndeadrise = \"20 deg\"\ntrim     = \"5 deg\"",
        "file = \"lopsided.stl\"");
    EXPECT_NE(complaint(text).find("[hull] half = true: the hull is not symmetric about y = 0"), std::string::npos);
    EXPECT_EQ(complaint(with(text, "half     = true", "half     = false")), "");
}

const std::string from_file = with(
    planing,
    "shape    = \"prismatic\"\nlength   = \"4 m\"\nbeam     = \"1 m\"\ndeadrise = \"20 deg\"\ntrim     = \"5 deg\"",
    "file = \"hull.stl\"");

TEST(Scene, SidesThatDifferByLessThanTheParticlesCanTellAreMadeAlike) {
    Surface uneven = posed(scene_of(planing).hull->surface, {.draft = 0.2});
    const auto shifted_side = [&](double by) {
        Surface s = uneven;
        for (Vec3& p : s.points)
            if (p.y() < -0.4) p.y() -= by;
        write_stl(scratch() / "hull.stl", s);
    };
    shifted_side(0.004);  // of near_hull = 50 mm
    const Scene s = scene_of(from_file);
    ASSERT_FALSE(s.hull->findings.empty());
    EXPECT_EQ(s.hull->findings[0].name, "made_symmetric");
    EXPECT_NE(s.hull->findings[0].message.find("the two sides differ by 0.004 m"), std::string::npos)
        << s.hull->findings[0].message;
    EXPECT_NEAR(s.hull->surface.bounds().min.y(), -0.5, 1e-6);
    SceneOverrides fine;
    fine.scale_resolution = 0.5;
    EXPECT_EQ(scene_of(from_file, fine).hull->hash, s.hull->hash);  // one hull at every size of a family
    shifted_side(0.006);
    EXPECT_NE(complaint(from_file).find("[hull] half = true: the hull is not symmetric about y = 0: near ("),
              std::string::npos);
    shifted_side(0);
    EXPECT_TRUE(scene_of(from_file).hull->findings.empty());
}

TEST(Scene, RepairIsSuggestedOnlyWhereItHelps) {
    Surface flipped = scene_of(planing).hull->surface, open = flipped;
    std::swap(flipped.triangles[4][0], flipped.triangles[4][1]);
    open.triangles.resize(open.triangles.size() - 3);
    write_stl(scratch() / "hull.stl", flipped);
    EXPECT_NE(complaint(from_file).find("; repair = true repairs it"), std::string::npos);
    write_stl(scratch() / "hull.stl", open);
    EXPECT_EQ(complaint(from_file).find("repair = true"), std::string::npos) << complaint(from_file);
    EXPECT_NE(complaint(with(from_file, "half ", "repair = true\nhalf ")).find("(repair = true could not repair it)"),
              std::string::npos);
}

TEST(Scene, AHullThatStandsOddlyInTheWaterIsNamed) {
    const auto names = [](const std::string& text, const SceneOverrides& o = {}) {
        const Scene scene = scene_of(text, o);
        std::string all;
        for (const Finding& f : scene.hull->findings)
            if (f.name != "thin_walls") all += f.name + " ";
        return all;
    };
    EXPECT_EQ(names(planing), "");
    EXPECT_EQ(names(with(planing, "draft    = \"0.2 m\"", "draft    = \"0.9 m\"")), "swamped ");  // the stern's deck
    EXPECT_EQ(names(with(planing, "draft    = \"0.2 m\"", "draft    = \"2 m\"")), "submerged ");
    EXPECT_EQ(names(with(planing, "draft    = \"0.2 m\"", "draft    = \"0.04 m\"")), "barely_wet ");
    Surface hull = posed(scene_of(planing).hull->surface, {.draft = 0.2});
    write_stl(scratch() / "hull.stl", hull);
    EXPECT_EQ(names(from_file), "");
    EXPECT_EQ(names(with(from_file, "half ", "axes = \"-x-yz\"\nhalf ")), "stern_first ");
    EXPECT_EQ(names(with(with(from_file, "half ", "axes = \"-x-yz\"\nhalf "), "kind  = \"stream\"\nspeed = \"8 m/s\"",
                         "kind = \"none\"")),
              "");  // still water has no direction
    const auto afloat = [](const std::string& shape) {
        return "[hull]\n" + shape + "\ndraft = 0.15\n[motion]\nspeed = 5\n[resolution]\nnear_hull = 0.02\n";
    };
    for (const char* shape : {"seaplane", "wigley", "box", "sphere", "torpedo"})
        EXPECT_EQ(names(afloat(std::string("shape = '") + shape + "'")), "") << shape;
    Surface boat = scene_of(planing).hull->surface;
    for (Vec3& p : boat.points)
        if (p.x() < boat.bounds().min.x() + 0.5) p.y() *= 0.02;  // a bow
    write_stl(scratch() / "boat.stl", boat);
    EXPECT_EQ(names(afloat("file = 'boat.stl'")), "");
    EXPECT_EQ(names(afloat("file = 'boat.stl'\naxes = '-x-yz'\ntrim = '12 deg'")), "stern_first ")
        << "the transom, now ahead, is lifted out of the water";
}

TEST(Scene, NonsenseIsRefusedAtTheKeyThatIsToBlame) {
    const auto blamed = [](const std::string& text, const std::string& start, const SceneOverrides& o = {}) {
        const std::string message = complaint(text, o);
        EXPECT_EQ(message.substr(0, start.size()), start) << message;
    };
    const std::string tank =
        "[tank]\nsize = [1, 1, 1]\n[[water_block]]\nmin = [0, 0, 0]\nmax = [0.5, 1, 0.5]\n[resolution]\nnear_hull = "
        "0.1\n";
    blamed(tank + "[[probe]]\nheight = [0.2, 0.5]\nfilter = '-1 ms'\n", "scene.toml:10:10: [[probe]] filter = \"-1 ms\": out of range");
    const std::string water_box = tank + "[[volume]]\nname = 'a'\nmin = [0, 0, 0]\nmax = ";
    blamed(water_box + "[0.1, 0, 0.1]\n", "scene.toml:11:7: [[volume]] max = [0.1, 0, 0.1]: the box has no volume");
    blamed(water_box + "[0.1, 1, 0.1]\n[[volume]]\nname = 'a'\nmin = [0, 0, 0]\nmax = [1, 1, 1]\n",
           "scene.toml:13:8: [[volume]] name = \"a\": the name a is taken; give every box its own");
    blamed(tank + "[[volume]]\nmin = [0, 0, 3]\nmax = [1, 1, 4]\n",
           "scene.toml:9:7: [[volume]] min = [0, 0, 3]: the box lies outside the domain");
    blamed(tank + "[[probe]]\nheight = [0.2, 0.5]\ndeck = 0.1\n",
           "scene.toml:10:8: [[probe]] deck = 0.1: events are counted by the periods of waves");
    blamed(tank + "[[probe]]\nheight = [0.2, 0.5]\nslam = 100\n",
           "scene.toml:10:8: [[probe]] slam = 100: a slam is a peak of a pressure; expected deck");
    blamed(tank + "[[probe]]\npressure = [0.2, 0.5, 0.1]\ndeck = 0.1\n",
           "scene.toml:10:8: [[probe]] deck = 0.1: a deck is a level of a height; expected slam");
    blamed(tank + "[[probe]]\nname = 'a'\nheight = [0.2, 0.5]\n[[probe]]\nname = 'a'\nheight = [0.3, 0.5]\n",
           "scene.toml:12:8: [[probe]] name = \"a\": the name a is taken; give every probe its own");
    blamed(
        with(planing, "[motion]", "[domain]\ny = [-1, 3]\n[motion]"),
        "scene.toml:12:5: [domain] y = [-1, 3]: a half model is solved from y = 0 on, and here y runs from -1 to 3 m");
    EXPECT_EQ(complaint(with(planing, "[motion]", "[domain]\ny = [-3, 3]\n[motion]")), "");
    EXPECT_EQ(complaint(with(planing, "[motion]", "[domain]\ny = [0, 3]\n[motion]")), "");
    blamed(planing + "[sph]\nc0 = 7\n",
           "scene.toml:22:6: [sph] c0 = 7: not above the speed of the water, 8 m/s; expected about 80 m/s");
    blamed(tank + "[sph]\nc0 = 2\n", "scene.toml:9:6: [sph] c0 = 2: not above the speed of the water, 3.132 m/s");
    blamed(planing + "[sph]\nc0 = 1e300\n",
           "scene.toml:22:6: [sph] c0 = 1e+300: out of range; expected greater than 0 m/s and at most 100000 m/s");
    blamed(with(planing, "\"0.05 m\"", "1e9"),
           "scene.toml:16:13: [resolution] near_hull = 1000000000: too coarse: 1e+09 m, but the hull is only 1 m "
           "wide or "
           "long; expected at most 0.5 m");
    blamed(with(planing, "near_hull = \"0.05 m\"", "spacing = 1e9"),
           "scene.toml:16:11: [resolution] spacing = 1000000000: too coarse");
    blamed(with(tank, "0.1", "3"),
           "scene.toml:7:13: [resolution] near_hull = 3: too coarse: 3 m, but the tank is only 1 m");
    SceneOverrides coarse;
    coarse.scale_resolution = 100;
    blamed(planing, "scene.toml:16:13: [resolution] near_hull = \"0.05 m\": too coarse: 5 m with --scale 100", coarse);
    blamed(
        planing + "[sampling]\nraster_spacing = 1e-12\n",
        "scene.toml:22:18: [sampling] raster_spacing = 1e-12: makes a raster of more than 1e+09 voxels; expected about "
        "0.1 m");
}

TEST(Scene, ATankHasItsOwnAxesAndNoStream) {
    const std::string tank =
        "[tank]\nsize = [0.584, 0.1, 0.4]\n[[water_block]]\nmin = [0, 0, 0]\nmax = [0.146, 0.1, "
        "0.292]\n[resolution]\nnear_hull = 0.01\n";
    const Scene s = scene_of(tank);
    EXPECT_EQ(s.motion.kind, Motion::Kind::none);
    EXPECT_EQ(s.domain.x_min, Side::slip_wall);
    EXPECT_EQ(s.domain.z_max, Side::atmosphere);
    EXPECT_NEAR(s.water.depth, 0.292, 1e-12);
    EXPECT_NEAR(s.sph.c0, 10 * std::sqrt(2 * 9.81 * 0.292), 1e-9);  // Torricelli
    EXPECT_NE(complaint(tank + "[motion]\nkind = 'stream'\nspeed = 1\n").find("a tank has walls all round"),
              std::string::npos);
    EXPECT_NE(complaint(with(tank, "max = [0.146", "max = [0.9"))
                  .find("scene.toml:5:7: [[water_block]] max = [0.9, 0.1, 0.292]: outside the domain"),
              std::string::npos);
    EXPECT_NE(complaint(with(tank, "[[water_block]]\nmin = [0, 0, 0]\nmax = [0.146, 0.1, 0.292]\n", ""))
                  .find("there is no water"),
              std::string::npos);
}

TEST(Scene, ARunsHashAlsoHoldsItsMethodsNumericsAndNotTheOthers) {
    const Scene s = scene_of(planing), sph = scene_of(with(planing, "[run]", "[sph]\nalpha = 0.02\n[run]"));
    EXPECT_NE(run_hash(s, "sph"), run_hash(sph, "sph"));
    EXPECT_EQ(run_hash(s, "fvm"), run_hash(sph, "fvm"));
    const Scene fvm = scene_of(with(planing, "[run]", "[fvm]\nmax_courant = 2\n[run]"));
    EXPECT_EQ(run_hash(s, "sph"), run_hash(fvm, "sph"));
    EXPECT_NE(run_hash(s, "fvm"), run_hash(fvm, "fvm"));
    EXPECT_NE(run_hash(s, "sph"), run_hash(scene_of(with(planing, "8 m/s", "7 m/s")), "sph"));
}

TEST(Scene, AnotherTimeSteppingSchemeIsAnotherRun) {
    const auto with_scheme = [](const std::string& name) {
        return scene_of(with(planing, "[run]", "[sph]\nscheme = \"" + name + "\"\n[run]"));
    };
    const Scene usual = scene_of(planing), named = with_scheme("kick_drift_kick"),
                other = with_scheme("symplectic_euler");
    EXPECT_EQ(usual.sph.scheme, "kick_drift_kick");
    EXPECT_EQ(other.sph.scheme, "symplectic_euler");
    EXPECT_EQ(run_hash(usual, "sph"), run_hash(named, "sph"));  // the default is what it is when named
    EXPECT_NE(run_hash(usual, "sph"), run_hash(other, "sph"));
    EXPECT_EQ(run_hash(usual, "fvm"), run_hash(other, "fvm"));
    EXPECT_THROW(with_scheme("leapfrog"), InputError);
}

TEST(Scene, TwoDimensionsAreOneParticleThickRoundThePlane) {
    const Scene s = scene_of(
        "[tank]\nsize = [0.584, 0.1, 0.4]\n[domain]\ndimensions = 2\n[[water_block]]\nmin = [0, 0, 0]\nmax = [0.146, "
        "0.1, 0.292]\n"
        "[[obstacle]]\nmin = [0.3, -1, 0]\nmax = [0.32, -0.5, 0.05]\n[[probe]]\npressure = [0.584, 0.05, "
        "0.01]\n[resolution]\nnear_hull = 0.01\n");
    EXPECT_NEAR(s.domain.box.min.y(), -0.005, 1e-15);
    EXPECT_NEAR(s.domain.box.max.y(), 0.005, 1e-15);
    EXPECT_NEAR(s.water_blocks[0].volume(), 0.146 * 0.01 * 0.292, 1e-12);
    EXPECT_NEAR(mass_properties(s.obstacles[0].surface).volume, 0.02 * 0.01 * 0.05, 1e-12);
    EXPECT_EQ(s.sampling.pressure[0].place.y(), 0);
    EXPECT_EQ(s.sampling.raster.count[1], 1);
    EXPECT_NEAR(predict(s).particles, 0.146 * 0.292 / 1e-4, 1);
}

/// A flat plate in a weightless channel, as studies/planing_plate.toml has it.
const std::string plate = R"([hull]
shape = "plate"
length = "4 m"
trim = "30 deg"
draft = "0.1 m"
[water]
depth = "1 m"
[motion]
speed = "10 m/s"
[effects]
gravity = "off"
[resolution]
near_hull = "0.04 m"
[domain]
dimensions = 2
)";

TEST(Scene, AHullInTwoDimensionsIsItsSectionPerMetreOfSpan) {
    const Scene s = scene_of(plate);
    ASSERT_TRUE(s.hull && s.hull->section);
    EXPECT_NEAR(s.hull->mass.volume, 4 * 0.3, 1e-9);
    EXPECT_NEAR(s.hull->draft, 0.1, 1e-12);
    EXPECT_EQ(s.water.gravity, 0);
    EXPECT_EQ(s.domain.box.min.z(), -1);
    EXPECT_EQ(s.span(), s.resolution.near_hull) << "what is solved is one particle thick";
    EXPECT_EQ(s.resolution.spacing, s.resolution.near_hull) << "cells of one size";
    EXPECT_EQ(s.sph.c0, 100);
    EXPECT_EQ(s.spanwise_unit("N"), "N/m");
    EXPECT_EQ(scene_of(planing).spanwise_unit("N"), "N");
    const Vec3 size = s.domain.box.size();
    const double water = size.x() * 1 - s.hull->still.volume;
    EXPECT_NEAR(predict(s).particles * 0.04 * 0.04, water, 1e-6 * water);
    SceneOverrides coarse;
    coarse.scale_resolution = 2;
    EXPECT_EQ(scene_of(plate, coarse).hull->hash, s.hull->hash);
    // Any closed hull that crosses the plane will do: a V-bottom becomes the rectangle over its keel.
    EXPECT_NEAR(scene_of(with(plate, "plate", "prismatic")).hull->mass.volume, 4 * 0.75, 1e-9);
}

TEST(Scene, TheRasterOfASectionHoldsWhatItThrowsUpAndAhead) {
    const Scene s = scene_of(plate);
    const RasterSpec& r = s.sampling.raster;
    const Vec3 high = r.origin + r.voxel * Vec3(r.count[0], r.count[1], r.count[2]);
    for (const int axis : {0, 2}) {
        EXPECT_LE(r.origin[axis], s.domain.box.min[axis] + 1e-9);
        EXPECT_GE(high[axis], s.domain.box.max[axis] - 1e-9);
    }
}

TEST(Scene, AHullWithoutASectionOrWithHalvesIsRefusedInTwoDimensions) {
    const std::string beside = complaint(with(plate, "[water]", "position = [0, \"2 m\"]\n[water]"));
    EXPECT_NE(beside.find("[hull] shape"), std::string::npos) << beside;
    EXPECT_NE(beside.find("y from 1.5 to 2.5 m"), std::string::npos) << beside;
    const std::string half = complaint(with(plate, "[water]", "half = true\n[water]"));
    EXPECT_NE(half.find("[hull] half"), std::string::npos) << half;
    const std::string floor = complaint(with(plate, "\"1 m\"", "\"0.2 m\""));
    EXPECT_NE(floor.find("[water] depth"), std::string::npos) << floor;
    EXPECT_NE(complaint(with(plate, "near_hull = \"0.04 m\"", "near_hull = \"3 m\"")).find("too coarse"),
              std::string::npos);
}

}  // namespace scene_test
}  // namespace tw::test
