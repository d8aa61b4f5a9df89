// Zones that absorb waves: their source in each release's case, their cells, and the level that they are to hold.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <sstream>

#include "base/errors.h"
#include "foam_cases/axis_cells.h"
#include "foam_cases/files/case_files.h"
#include "foam_cases/plan_case.h"
#include "foam_cases/read/level_at_ends.h"
#include "scene/mesh/mesh_cells.h"
#include "scenes.h"

namespace tw {
namespace foam_zones_test {

/// A channel of 4.5 m by 0.2 m in a stream of 0.7 m/s, cells of 10 mm, with a zone of 0.32 m ahead and one of 0.48 m
/// behind.
Scene channel() {
    Scene s;
    s.motion = {Motion::Kind::stream, 0.7, 0};
    s.domain.dimensions = 2;
    s.domain.undamped = {Vec3(-2, -0.005, -0.2), Vec3(2.5, 0.005, 0.1)};
    s.domain.box = {Vec3(-2.32, -0.005, -0.2), Vec3(2.98, 0.005, 0.1)};
    s.domain.as_asked = s.domain.undamped;
    s.domain.x_min = Side::inlet;
    s.domain.x_max = Side::outlet;
    s.domain.y_min = s.domain.y_max = Side::symmetry;
    s.resolution = {0.01, 0.01};
    s.sampling.interval = 0.05;
    s.run.duration = 1;
    EffectChoice zones;
    zones.name = "forcing_zones";
    zones.on = true;
    s.effects.push_back(zones);
    return s;
}

OpenFoam installation(const char* vendor, const char* version, const char* library) {
    OpenFoam found;
    found.vendor = vendor, found.version = version, found.zone_library = library;
    return found;
}

std::string text_of(const CasePlan& plan, const std::string& path) {
    for (const CaseFile& f : case_files(plan, 1))
        if (f.path == path) return f.text;
    return {};
}

TEST(ForcingZonesInInterFoam, AreASourceOfMomentumOfTheReleaseAndItsLibrary) {
    const Scene scene = channel();
    for (const auto& [vendor, version, file] : {std::tuple{"openfoam.com", "v1912", "constant/fvOptions"},
                                                {"openfoam.com", "v2506", "constant/fvOptions"},
                                                {"openfoam.org", "12", "constant/fvModels"},
                                                {"openfoam.org", "13", "constant/fvModels"}}) {
        const CasePlan plan = plan_case(scene, installation(vendor, version, "/some where/libforcingZones.so"));
        const std::string source = text_of(plan, file);
        for (const char* part : {"type            forcingZones;", "velocity        (0.7 0 0);", "begin", "-2.32"})
            EXPECT_NE(source.find(part), std::string::npos) << vendor << " " << version << ": " << source;
        EXPECT_NE(control_dict(plan).find("(\"/some where/libforcingZones.so\")"), std::string::npos);
    }
}

// Behind a weir or a gate water of another depth leaves with its own speed: held by zone and outlet where it is slower
// than its waves, else as it comes. It starts there.
TEST(ForcingZonesInInterFoam, DrawToTheSpeedOfTheWaterBehind) {
    Scene scene = channel();
    scene.zones.downstream = 0.16;
    scene.water.gravity = 9.81;
    const OpenFoam com = installation("openfoam.com", "v1912", "/lib/libforcingZones.so");
    const CasePlan slow = plan_case(scene, com);
    const std::string source = text_of(slow, "constant/fvOptions");
    for (const char* part :
         {"forcingZones\n", "velocity        (0.7 0 0);", "forcingZonesBehind\n", "velocity        (0.875 0 0);"})
        EXPECT_NE(source.find(part), std::string::npos) << source;
    EXPECT_NE(text_of(slow, "0.orig/U").find("Umean           0.875;"), std::string::npos) << text_of(slow, "0.orig/U");
    const std::string fields = text_of(slow, "system/setFieldsDict");
    EXPECT_NE(fields.find("volVectorFieldValue U (0.875 0 0)"), std::string::npos) << fields;
    scene.zones.downstream = 0.04;  // 3.5 m/s: the scene has no zone there
    scene.domain.box.max.x() = scene.domain.undamped.max.x();
    const CasePlan fast = plan_case(scene, com);
    EXPECT_EQ(text_of(fast, "0.orig/U").find("outletPhaseMeanVelocity"), std::string::npos);
    EXPECT_EQ(text_of(fast, "constant/fvOptions").find("forcingZonesBehind"), std::string::npos);
    scene.zones.downstream = 0;
    EXPECT_EQ(text_of(plan_case(scene, com), "constant/fvOptions").find("forcingZonesBehind"), std::string::npos);
}

// A sum of waves is handed over in the very numbers that the particles take, for the library to read.
TEST(ForcingZonesInInterFoam, DrawToASumOfWaves) {
    Scene scene = channel();
    scene.motion = {};
    scene.domain.undamped = scene.domain.box;
    scene.domain.x_min = scene.domain.x_max = Side::slip_wall;
    scene.sea = make_sea({.depth = 0.2, .height = 0.02, .peak_period = 0.6, .components = 12});
    const CasePlan plan = plan_case(scene, installation("openfoam.com", "v1912", "/lib/libforcingZones.so"));
    ASSERT_TRUE(plan.zones.sea);
    const std::string source = text_of(plan, "constant/fvOptions");
    for (const char* part :
         {"forcingZonesOfASea;", "makesWave       yes;", "sea\n", "amplitude", "omega", "phase", "current"})
        EXPECT_NE(source.find(part), std::string::npos) << part << ": " << source;
    EXPECT_EQ(source.find("wave\n"), std::string::npos);
    // as many numbers as components, the first of each as it is
    const std::size_t list = source.find("amplitude");
    const std::string numbers = source.substr(list, source.find(';', list) - list);
    EXPECT_EQ(std::ranges::count(numbers, '.'), 12) << numbers;
    EXPECT_NE(text_of(plan, "system/setFieldsDict"), "");
}

// The library's zones move with no stream: they take the frequencies that are met, and with them the velocities of the
// waves in their water.
TEST(ForcingZonesInInterFoam, DrawToASumOfWavesThatAStreamCarries) {
    Scene scene = channel();
    scene.sea =
        make_sea({.depth = 0.2, .direction = -1, .stream = 0.15, .height = 0.02, .peak_period = 0.8, .components = 12});
    scene.motion.speed = 0.15;
    const CasePlan plan = plan_case(scene, installation("openfoam.com", "v1912", "/lib/libforcingZones.so"));
    const std::string source = text_of(plan, "constant/fvOptions");
    const auto numbers = [&](const std::string& name) {
        std::istringstream text(source.substr(source.find('(', source.find(" " + name + "\n")) + 1));
        std::vector<double> found;
        for (double value; text >> value;) found.push_back(value);
        return found;
    };
    const std::vector<double> omega = numbers("omega"), amplitude = numbers("amplitude");
    ASSERT_EQ(omega.size(), 12u) << source;
    ASSERT_EQ(amplitude.size(), 12u) << source;
    const WaveComponents& waves = scene.sea->waves;
    for (std::size_t n = 0; n < 12; ++n) {
        EXPECT_NEAR(omega[n], waves.omega[n] - 0.15 * waves.k[n], 1e-9);
        EXPECT_NEAR(amplitude[n] * omega[n], waves.height[n] * waves.omega[n], 1e-9);
    }
    EXPECT_NE(source.find("current         0.15;"), std::string::npos) << source;
}

// A wave under an angle to x is for a library that knows it; head waves are what they were.
TEST(ForcingZonesInInterFoam, DrawToAnObliqueWave) {
    Scene scene = channel();
    const auto source_of = [&](double direction, double across) {
        scene.wave = regular_wave({.height = 0.02,
                                   .length = 0.8,
                                   .depth = 0.2,
                                   .direction = direction,
                                   .across = across,
                                   .closed = false,
                                   .stream = 0.7});
        return text_of(plan_case(scene, installation("openfoam.com", "v1912", "/lib/libforcingZones.so")),
                       "constant/fvOptions");
    };
    const std::string oblique = source_of(0.6, 0.8), head = source_of(1, 0);
    EXPECT_NE(oblique.find("forcingZonesOblique;"), std::string::npos) << oblique;
    EXPECT_NE(oblique.find("across          0.8;"), std::string::npos) << oblique;
    EXPECT_NE(oblique.find("direction       0.6;"), std::string::npos) << oblique;
    EXPECT_NE(head.find("forcingZones;"), std::string::npos) << head;
    EXPECT_EQ(head.find("across"), std::string::npos) << head;
}

// Without them the case has no word of them.
TEST(ForcingZonesInInterFoam, LeaveNothingBehindWhereTheyAreOff) {
    Scene scene = channel();
    scene.effects.back().on = false;
    const CasePlan plan = plan_case(scene, installation("openfoam.com", "v1912", "/lib/libforcingZones.so"));
    for (const CaseFile& f : case_files(plan, 1)) {
        EXPECT_EQ(f.text.find("forcingZones"), std::string::npos) << f.path;
        EXPECT_NE(f.path, "constant/fvOptions");
    }
}

TEST(ForcingZonesInInterFoam, AreRefusedWithoutALibraryWithWhatToDo) {
    const auto refusal = [](const OpenFoam& found) -> std::string {
        const Scene scene = channel();
        try {
            plan_case(scene, found);
        } catch (const InputError& e) { return e.what(); }
        return "taken";
    };
    OpenFoam mended = installation("openfoam.com", "v1912", "");
    mended.solver = "/own/bin/interFoam", mended.bin = "/usr/bin";
    EXPECT_NE(refusal(mended).find("twinwake setup-openfoam builds it;"), std::string::npos) << refusal(mended);
    OpenFoam loaded = installation("openfoam.org", "13", "");
    loaded.solver = "/opt/openfoam13/bin/foamRun", loaded.bin = "/opt/openfoam13/bin";
    EXPECT_NE(refusal(loaded).find("twinwake setup-openfoam builds it in the environment"), std::string::npos)
        << refusal(loaded);
    loaded.version = "11";
    EXPECT_NE(refusal(loaded).find("openfoam.org from 12"), std::string::npos) << refusal(loaded);
    EXPECT_NE(refusal(loaded).find("forcing_zones = \"off\""), std::string::npos) << refusal(loaded);
}

// A tank's zones and the motion of the tank are sources in one file.
TEST(ForcingZonesInInterFoam, StandBesideTheMotionOfATank) {
    Scene scene = dam_break_scene();
    scene.tank_motion.emplace().law = {.axis = Vec3::UnitX(), .rate = 0.1};
    CasePlan plan = plan_case(scene, Flavour{});
    plan.zones.zones = {{0, true, 0.4, 0.584, 10}};
    const std::string source = text_of(plan, "constant/fvOptions");
    EXPECT_NE(source.find("tabulatedAccelerationSource"), std::string::npos) << source;
    EXPECT_NE(source.find("forcingZones"), std::string::npos) << source;
    const auto files = case_files(plan, 1);
    EXPECT_EQ(std::ranges::count(files, "constant/fvOptions", &CaseFile::path), 1);
}

// What was asked for keeps its cells; a zone has less than half of those that it would have, and begins with one as
// long.
TEST(ForcingZonesInInterFoam, HaveCellsThatGrowOutwards) {
    const Scene scene = channel();
    const AxisCells with = axis_with_zones(scene, 0, 0.01, {}), without = split_axis(-2, 2.5, 0.01, {});
    ASSERT_EQ(with.planes, (std::vector<double>{-2.32, -2, 2.5, 2.98}));
    EXPECT_EQ(with.cells[1], without.cells[0]);
    EXPECT_EQ(with.grows[1], 1);
    const auto first = [&](std::size_t block, double width) {  // of a geometric series, next to the box
        const double q = growth_in_zones;
        EXPECT_NEAR(block == 0 ? 1 / with.grows[0] : with.grows[block], std::pow(q, with.cells[block] - 1), 1e-12);
        return width * (q - 1) / (std::pow(q, with.cells[block]) - 1);
    };
    EXPECT_NEAR(first(0, 0.32) / 0.01, 1, 0.15) << "a whole number of cells: half a step of growth and a little";
    EXPECT_NEAR(first(2, 0.48) / 0.01, 1, 0.15);
    EXPECT_LT(with.cells[0] + with.cells[2], 0.5 * (32 + 48));
    EXPECT_EQ(axis_with_zones(scene, 2, 0.01, {0}).cells, (std::vector<int>{20, 10}));
    EXPECT_NEAR(predicted_cells(scene), 30.0 * std::accumulate(with.cells.begin(), with.cells.end(), 0), 30);
}

/// A channel of one layer of water whose level is `inlet` and `outlet` [m] in the tenths at its ends.
RunRecord channel_with_level(const Scene& scene, double inlet, double outlet) {
    RunRecord record;
    for (const double time : {0.0, 0.5, 1.0}) {
        record.table("samples").append(time);
        LevelAtEnds level(scene);
        const double more = time < 0.4 ? -0.05 : 0.0;  // what the start leaves, before the means
        for (double x = -2.275; x < 2.95; x += 0.05) {
            const double eta = x < 0 ? inlet + more : outlet, zone = x < -2 || x > 2.5 ? 1 : 0;
            level.add(Vec3(x, 0, -0.1), 0.05 * 0.01 * 0.2, 0.05 * 0.01 * (0.2 + zone + std::min(eta, 0.0)));
            level.add(Vec3(x, 0, 0.05), 0.05 * 0.01 * 0.1, 0.05 * 0.01 * std::max(eta, 0.0));
        }
        level.keep(record);
    }
    return record;
}

TEST(LevelAtEnds, IsTheMeanOfTheBoxesFirstAndLastTenthWithoutTheZones) {
    Scene scene = channel();
    scene.sampling.mean_from = 0.4;
    const RunRecord held = channel_with_level(scene, 0.001, -0.003);
    EXPECT_NEAR(held.series("samples", "level_at_inlet")->values.back(), 0.001, 1e-12);
    EXPECT_NEAR(held.series("samples", "level_at_outlet")->values.back(), -0.003, 1e-12);
    ASSERT_EQ(held.validity_checks.size(), 1u);
    EXPECT_NEAR(held.validity_checks[0].value, 0.5, 1e-9) << "of the depth; the start does not count";
    EXPECT_TRUE(held.validity_checks[0].met());
    const RunRecord risen = channel_with_level(scene, 0.069, 0.069);
    EXPECT_FALSE(risen.validity_checks.at(0).met()) << "69 of 200 mm";
    scene.effects.back().on = false;
    EXPECT_TRUE(channel_with_level(scene, 0.069, 0.069).validity_checks.empty());
}

}  // namespace foam_zones_test
}  // namespace tw
