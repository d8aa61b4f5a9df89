// A cloud of parcels as OpenFOAM's text, and what is read back of it.
#include <gtest/gtest.h>

#include <cmath>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "foam_cases/cloud/cloud_case.h"
#include "tests/unit/record/example_record.h"

namespace tw {
namespace cloud_case_test {
namespace fs = std::filesystem;

CloudCase two_parcels() {
    CloudCase cloud;
    cloud.parcels = {{{0, 0, 0}, {20, 0, 5}, 1e-3}, {{0, 0.5, 0}, {10, 0, 5}, 5e-4}};
    cloud.room = {{-1, -1, -4}, {3, 1, 4}};
    return cloud;
}

TEST(CloudCase, HasARowForEachParcelAndLetsEachGoOnce) {
    const ScratchFolder folder;
    write_cloud_case(two_parcels(), folder / "");
    EXPECT_NE(read_text(folder / "constant/droplets").find("(0 0.5 0) (10 0 5) 5e-04 1000 1\n"), std::string::npos);
    // rows * step * parcelsPerSecond = 2.5 parcels, of which the whole part is injected
    EXPECT_NE(read_text(folder / "constant/kinematicCloudProperties").find("parcelsPerSecond 1250"), std::string::npos);
    EXPECT_NE(read_text(folder / "0/U").find("uniform (0 0 0)"), std::string::npos);
}

TEST(CloudCase, GivesEveryCellItsAir) {
    const ScratchFolder folder;
    CloudCase cloud = two_parcels();
    cloud.air_velocity = [](const Vec3& place) { return Vec3(place.z(), 0, 0); };
    write_cloud_case(cloud, folder / "");
    const std::string u = read_text(folder / "0/U");
    EXPECT_NE(u.find("nonuniform List<vector> 1728"), std::string::npos);  // 12 x 6 x 24
    EXPECT_NE(u.find("(-3.8333333333333335 0 0)"), std::string::npos);     // half a cell above the floor
}

TEST(CloudCase, ThatCannotFlyIsRefusedAndNothingIsWritten) {
    const ScratchFolder folder;
    const auto refused = [&](const CloudCase& cloud) {
        EXPECT_THROW(write_cloud_case(cloud, folder / "case"), InputError);
        EXPECT_FALSE(fs::exists(folder / "case"));
    };
    CloudCase cloud = two_parcels();
    cloud.parcels[1].diameter = -1e-3;
    refused(cloud);
    cloud = two_parcels();
    cloud.parcels[1].place.x() = 3.5;  // beyond the room
    refused(cloud);
    cloud = two_parcels();
    cloud.parcels.clear();
    refused(cloud);
    cloud = two_parcels();
    cloud.parcels[0].velocity.x() = std::nan("");
    refused(cloud);
    cloud = two_parcels();
    cloud.liquid_density = 1;  // lighter than air
    refused(cloud);
}

void write_cloud(const fs::path& folder, const std::string& ages, const std::string& names = "2(1 0)") {
    const auto put = [&](const std::string& name, const std::string& body) {
        fs::create_directories(folder / "0.5/lagrangian/kinematicCloud");
        write_text_atomically(folder / "0.5/lagrangian/kinematicCloud" / name,
                              "FoamFile\n{\n    version     2.0;\n    location    \"0.5/lagrangian\";\n}\n"
                              "// * * * //\n\n" +
                                  body + "\n\n// ***** //\n");
    };
    put("positions", "2\n(\n(1 2 3) 7\n(4 5 6) 8\n)");
    put("U", "2{(1 0 0)}");
    put("age", ages);
    put("origId", names);
}

TEST(CloudTracks, AreReadWithTheirParcels) {
    const ScratchFolder folder;
    write_cloud(folder / "", "2(0.5 0.499)");
    const auto frames = read_cloud(folder / "");
    ASSERT_EQ(frames.size(), 1u);
    ASSERT_EQ(frames[0].size(), 2u);
    EXPECT_EQ(frames[0][1].parcel, 0u);
    EXPECT_EQ(frames[0][1].place, Vec3(4, 5, 6));
    EXPECT_EQ(frames[0][1].velocity, Vec3(1, 0, 0));
    EXPECT_EQ(frames[0][1].age, 0.499);
}

/// OpenFOAM writes no cloud at all once every parcel has left.
TEST(CloudTracks, OfATimeWithoutParcelsAreEmpty) {
    const ScratchFolder folder;
    write_cloud(folder / "", "2(0.5 0.499)");
    fs::create_directories(folder / "0.75/uniform");
    const auto frames = read_cloud(folder / "");
    ASSERT_EQ(frames.size(), 2u);
    EXPECT_EQ(frames[0].size(), 2u);
    EXPECT_TRUE(frames[1].empty());
}

TEST(CloudTracks, CutOffOrMissingAreRefused) {
    const ScratchFolder folder;
    EXPECT_THROW(read_cloud(folder / ""), RunError);
    write_cloud(folder / "", "2(0.5");
    EXPECT_THROW(read_cloud(folder / ""), RunError);
    for (const char* ages : {"3(0.5 0.5 0.5)", "1000000000{0.5}"}) {  // of another number of parcels
        write_cloud(folder / "", ages);
        EXPECT_THROW(read_cloud(folder / ""), RunError);
    }
    for (const char* names : {"2(1 -3)", "2(1 1e300)", "2{1}"}) {
        write_cloud(folder / "", "2(0.5 0.499)", names);
        EXPECT_THROW(read_cloud(folder / ""), RunError) << names;
    }
    write_cloud(folder / "", "2(0.5 0.499)");
    fs::remove(folder / "0.5/lagrangian/kinematicCloud/positions");
    EXPECT_THROW(read_cloud(folder / ""), RunError);
}

}  // namespace cloud_case_test
}  // namespace tw
