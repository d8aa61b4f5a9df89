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

TEST_F(Drawings, ASolidByItsNameIsRefusedInWords) {
    EXPECT_NE(
        complaint((drawings / "two_boxes_inch.step").string() + "#keel").find("export the bodies as OBJ or ascii STL"),
        std::string::npos);
}

}  // namespace cad_test
}  // namespace tw
