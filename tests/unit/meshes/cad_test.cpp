#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "meshes/health.h"
#include "meshes/mass_properties.h"
#include "meshes/read/cad.h"
#include "meshes/read/solids_of_file.h"
#include "meshes/surface.h"
#include "test_paths.h"
#include "tests/unit/meshes/gzipped.h"

namespace tw {
namespace fs = std::filesystem;
namespace cad_test {

const fs::path drawings = fs::path(TWINWAKE_TEST_DATA) / "drawings";

bool reads_drawings() {
    return fs::exists(fs::path(TWINWAKE_PROGRAM).parent_path() / "meshes/libtwinwake_drawings.so");
}

class Drawings : public testing::Test {
protected:
    void SetUp() override {
        if (!reads_drawings()) GTEST_SKIP() << "built without Open CASCADE";
        fs::create_directories(folder);
    }
    void TearDown() override { fs::remove_all(folder); }
    std::string complaint(const fs::path& file, std::string_view unit = "m") {
        try {
            read_surface(file, unit);
            return "";
        } catch (const InputError& e) { return e.what(); }
    }
    fs::path written(const std::string& name, const std::string& content) {
        std::ofstream(folder / name, std::ios::binary) << content;
        return folder / name;
    }
    fs::path folder = fs::temp_directory_path() / ("twinwake_drawings_" + std::to_string(::getpid()));
};

/// A cylinder of 0.5 m across and 1 m along x, its bow at the origin: chords lie inside, by at most cad_chord of the
/// diagonal, which is (1 - sin t / t) of the volume, t the angle of a chord with such a height.
void expect_the_cylinder(const Surface& s) {
    const double r = 0.25, exact = std::numbers::pi * r * r;
    const double height = cad_chord * std::sqrt(1 + 2 * 4 * r * r), t = 2 * std::acos(1 - height / r);
    const double volume = mass_properties(s).volume;
    EXPECT_LT(volume, exact);
    EXPECT_GT(volume, exact * std::sin(t) / t);
    EXPECT_TRUE(usable(check_surface(s)));
    for (const Vec3& p : s.points) {
        EXPECT_NEAR(std::hypot(p.y(), p.z()), r, 1e-9);
        EXPECT_NEAR(p.x() * (1 - p.x()), 0, 1e-9);
    }
}

TEST_F(Drawings, OfASolidBecomeItsSurfaceInMetres) { expect_the_cylinder(read_surface(drawings / "cylinder.step")); }
TEST_F(Drawings, OfFacesAloneAreSewn) {
    expect_the_cylinder(read_surface(drawings / "cylinder_faces.step"));
    expect_the_cylinder(read_surface(drawings / "cylinder.igs"));
}
TEST_F(Drawings, MayBeCompressed) {
    expect_the_cylinder(read_surface(written("cylinder.stp.gz", gzipped(read_text(drawings / "cylinder.step")))));
}

TEST_F(Drawings, InInchesWithTwoPlacedSolidsAreWhereTheyWereDrawn) {
    const Surface s = read_surface(drawings / "two_boxes_inch.step");
    EXPECT_NEAR(mass_properties(s).volume, 2 * 0.254 * 0.508 * 0.762, 1e-9);
    const auto [low, high] = std::ranges::minmax(s.points, {}, [](const Vec3& p) { return p.x(); });
    EXPECT_NEAR(low.x(), 0, 1e-9);
    EXPECT_NEAR(high.x(), 2.54 + 0.254, 1e-9);
    EXPECT_TRUE(usable(check_surface(s)));
}

TEST_F(Drawings, NameTheirOwnUnit) {
    EXPECT_NE(complaint(drawings / "cylinder.step", "mm").find("leave the unit out"), std::string::npos);
}

TEST_F(Drawings, ThatAreDamagedAreRefusedInWords) {
    const std::string good = read_text(drawings / "cylinder.step");
    for (const std::size_t n : {5u, 300u, 2000u, 4000u, 5600u}) {
        const fs::path file = written("cut.step", good.substr(0, n));
        const std::string said = complaint(file);
        EXPECT_TRUE(said.starts_with(file.string() + ": ")) << n << ": " << said;
    }
    EXPECT_NE(complaint(written("other.iges", good)), "");
    const fs::path empty =
        written("empty.step", good.substr(0, good.find("DATA;")) + "DATA;\nENDSEC;\nEND-ISO-10303-21;\n");
    EXPECT_NE(complaint(empty).find("nothing in it"), std::string::npos) << complaint(empty);
}

TEST(ADrawing, ThatThisProgramCannotReadSaysWhatToInstall) {
    if (reads_drawings()) GTEST_SKIP() << "built with Open CASCADE";
    try {
        read_surface(drawings / "cylinder.step");
        ADD_FAILURE() << "was read";
    } catch (const InputError& e) {
        EXPECT_NE(std::string(e.what()).find("libocct-data-exchange-dev"), std::string::npos);
    }
}

void expect_box(const Surface& s, const Vec3& low, const Vec3& high) {
    EXPECT_LT((s.bounds().min - low).norm() + (s.bounds().max - high).norm(), 1e-9)
        << s.bounds().min.transpose() << " to " << s.bounds().max.transpose();
}
double volume_of(const Surface& s) { return mass_properties(s).volume; }

TEST_F(Drawings, NameTheirSolidsFromTheInsideOut) {
    const std::vector<SolidNames> expected{{"Quay wall", "Pier", "Harbour"},
                                           {"Post", "left post", "Pier", "Harbour"},
                                           {"Post", "right post", "Pier", "Harbour"},
                                           {"Boot äö #1", "Boot", "Harbour"},
                                           {"keel fin", "Boot äö #1", "Boot", "Harbour"}};
    EXPECT_EQ(solids_of_file(drawings / "harbour.step"), expected);
    EXPECT_EQ(solids_of_file(written("harbour.stp.gz", gzipped(read_text(drawings / "harbour.step")))), expected);
    EXPECT_EQ(names_of_bodies(expected),
              (std::vector<std::string>{"Quay wall", "left post", "right post", "Boot äö #1"}));
    EXPECT_EQ(names_of_bodies({{"twin"}, {}, {"twin"}}), std::vector<std::string>{"twin"});
    EXPECT_EQ(solids_of_file(drawings / "cylinder.igs"), std::vector<SolidNames>{});
}

TEST_F(Drawings, GiveASolidByItsNameWhereItsAssembliesPlaceIt) {
    const std::string harbour = (drawings / "harbour.step").string();
    // The pier is turned by 90 degrees about z and stands at x = 10 m; the wall lies on it 0.5 m high.
    expect_box(read_surface(harbour + "#Quay wall"), {9.8, 0, 0.5}, {10, 1, 0.6});
    expect_box(read_surface(harbour + "#left post"), {9.85, 0, 0}, {9.95, 0.1, 0.5});
    expect_box(read_surface(harbour + "#right post"), {9.85, 0.9, 0}, {9.95, 1, 0.5});
    expect_box(read_surface(harbour + "#keel fin"), {0.1, 3, -0.2}, {0.15, 3.02, 0});
    const Surface posts = read_surface(harbour + "#Post");  // a part that is used twice
    expect_box(posts, {9.85, 0, 0}, {9.95, 1, 0.5});
    EXPECT_NEAR(volume_of(posts), 2 * 0.1 * 0.1 * 0.5, 1e-9);
    EXPECT_NEAR(volume_of(read_surface(harbour + "#Pier")), 0.02 + 0.01, 1e-9);
    EXPECT_NEAR(volume_of(read_surface(harbour + "#Boot äö #1")), 0.003 + 0.0002, 1e-9);
    for (const char* name : {"Quay wall", "left post", "keel fin"})
        EXPECT_TRUE(usable(check_surface(read_surface(harbour + "#" + name)))) << name;
}

TEST_F(Drawings, GiveASolidByItsNameInInchesToo) {
    std::string text = read_text(drawings / "two_boxes_inch.step");
    for (const auto& [part, name] : {std::pair{"7.6 2.1", R"(K\X2\00FC\X0\bel ''a'')"}, {"7.6 2.2", "fin"}}) {
        const std::string from = std::string("\n  'Open CASCADE STEP translator ") + part + "'";  // behind the number
        const std::size_t at = text.find(from);
        ASSERT_NE(at, std::string::npos);
        text.replace(at, from.size(), std::string("'") + name + "'");
    }
    const std::string file = written("boxes.step", text).string();
    expect_box(read_surface(file + "#Kübel 'a'"), {0, 0, 0}, {0.254, 0.508, 0.762});
    expect_box(read_surface(file + "#fin"), {2.54, 0, 0}, {2.794, 0.508, 0.762});
}

TEST_F(Drawings, OfFacesAloneGiveAPartByItsName) {
    const std::string file = (drawings / "cylinder_faces.step").string();
    expect_the_cylinder(read_surface(file + "#" + solids_of_file(file).front().back()));
}

TEST_F(Drawings, SayWhichNamesTheyHaveAndHowOften) {
    const std::string harbour = (drawings / "harbour.step").string();
    EXPECT_NE(complaint(harbour + "#rudder")
                  .find("harbour.step: no solid in it is called \"rudder\"; it has: Harbour (5 solids), Pier (3 "
                        "solids), Quay wall, "
                        "left post, Post (2 solids), right post, Boot (2 solids), Boot äö #1 (2 solids), keel fin"),
              std::string::npos)
        << complaint(harbour + "#rudder");
    EXPECT_NE(complaint(harbour + "#").find("expected the name of a solid"), std::string::npos);
    EXPECT_NE(complaint((drawings / "cylinder.igs").string() + "#keel").find("export the bodies as STEP, OBJ"),
              std::string::npos);
    const std::string cut = written("cut.step", read_text(harbour).substr(0, 20000)).string();
    EXPECT_TRUE(complaint(cut + "#Post").starts_with(cut + ": ")) << complaint(cut + "#Post");
}

}  // namespace cad_test
}  // namespace tw
