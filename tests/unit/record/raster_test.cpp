#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "base/numbers.h"
#include "record/raster.h"

namespace tw {
namespace raster_test {

constexpr double voxel = 0.1;
const RasterSpec spec{{-0.5, 0.0, -0.4}, voxel, {10, 6, 9}};

struct Moments {
    double volume = 0;
    Vec3 centroid = Vec3::Zero();
};
Moments moments(const RasterFrame& f) {
    Moments m;
    std::size_t n = 0;
    for (int k = 0; k < spec.count[2]; ++k)
        for (int j = 0; j < spec.count[1]; ++j)
            for (int i = 0; i < spec.count[0]; ++i) {
                const double v = f.water[n++] / 255.0 * voxel * voxel * voxel;
                m.volume += v;
                m.centroid += v * (spec.origin + voxel * Vec3(i + 0.5, j + 0.5, k + 0.5));
            }
    m.centroid /= m.volume;
    return m;
}

// A cube whose edge is a whole number of voxels is shared linearly in its position, so the first moment is kept
// exactly; what remains is the rounding of each voxel to 1/255.
TEST(Raster, KeepsVolumeAndCentroidWhereverTheCubesLie) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> x(-0.4, 0.4), y(0.1, 0.5), z(-0.3, 0.4);
    Raster raster(spec);
    double volume = 0;
    Vec3 first = Vec3::Zero();
    for (int i = 0; i < 60; ++i) {
        const Vec3 c(x(random), y(random), z(random));
        const double water = 0.3 * voxel * voxel * voxel;
        raster.pour(c, i % 2 ? voxel : 2 * voxel, water);
        volume += water;
        first += water * c;
    }
    EXPECT_NEAR(raster.poured(), volume, 1e-15);
    const Moments m = moments(raster.frame(0));
    EXPECT_NEAR(m.volume, volume, 0.01 * volume);
    EXPECT_LT((m.centroid - first / volume).norm(), 0.02 * voxel);
}

TEST(Raster, KeepsVolumeOfCubesOfAnySize) {
    std::mt19937 random(8);
    std::uniform_real_distribution<double> x(-0.4, 0.4), y(0.1, 0.5), z(-0.3, 0.4), edge(0.003, 0.19);
    Raster raster(spec);
    for (int i = 0; i < 60; ++i)
        raster.pour({x(random), y(random), z(random)}, edge(random), 0.3 * voxel * voxel * voxel);
    EXPECT_NEAR(moments(raster.frame(0)).volume, 18 * voxel * voxel * voxel, 0.18 * voxel * voxel * voxel);
}

TEST(Raster, CubeOnVoxelFacesFillsExactlyThem) {
    Raster raster(spec);
    raster.pour(spec.origin + voxel * Vec3(3, 2, 4), 2 * voxel, 8 * voxel * voxel * voxel);  // voxels 2..3, 1..2, 3..4
    const RasterFrame f = raster.frame(1.5);
    EXPECT_EQ(f.time, 1.5);
    EXPECT_EQ(std::accumulate(f.water.begin(), f.water.end(), 0), 8 * 255);
    EXPECT_EQ(f.water[static_cast<std::size_t>((3 * 6 + 1) * 10 + 2)], 255);
    EXPECT_EQ(f.water[static_cast<std::size_t>((4 * 6 + 2) * 10 + 3)], 255);
}

TEST(Raster, OffsetCubeIsSharedInProportionToTheOverlap) {
    Raster raster(spec);
    // A cube of one voxel edge, shifted by a quarter along x: three quarters here, one quarter there.
    raster.pour(spec.origin + voxel * Vec3(4.75, 2.5, 3.5), voxel, voxel * voxel * voxel);
    const RasterFrame f = raster.frame(0);
    EXPECT_EQ(f.water[static_cast<std::size_t>((3 * 6 + 2) * 10 + 4)], 191);  // 0.75 * 255 = 191.25
    EXPECT_EQ(f.water[static_cast<std::size_t>((3 * 6 + 2) * 10 + 5)], 64);   // 0.25 * 255 = 63.75
}

TEST(Raster, CellsThatAreNoCubesFillTheirVoxelsWhole) {
    // Cells of 0.95 x 1/0.95 x 1 voxel edges, wet below the third layer: cubes in their place overlap and gape, and
    // would leave some voxels 5 % dry.
    Raster raster(spec);
    const double cell = voxel * voxel * voxel;
    for (int k = 0; k < spec.count[2]; ++k)
        for (double y = -0.5 / 0.95; y < spec.count[1] + 1; y += 1 / 0.95)
            for (double x = -0.475; x < spec.count[0] + 1; x += 0.95)
                raster.pour_cell(spec.origin + voxel * Vec3(x, y, k + 0.5), cell, k < 3 ? cell : 0);
    const RasterFrame f = raster.frame(0);
    for (int k = 0; k < spec.count[2]; ++k)
        for (int j = 1; j + 1 < spec.count[1]; ++j)
            for (int i = 1; i + 1 < spec.count[0]; ++i)
                EXPECT_EQ(f.water[static_cast<std::size_t>((k * spec.count[1] + j) * spec.count[0] + i)],
                          k < 3 ? 255 : 0)
                    << i << ' ' << j << ' ' << k;
}

TEST(Raster, WaterOutsideIsCountedButNotSeenAndOverfullVoxelsStopAtOne) {
    Raster raster(spec);
    raster.pour({1e12, 0, 0}, 0.1, 1);
    raster.pour({-1e300, 0, 0}, 0.1, 1);
    raster.pour({0, 0, std::nan("")}, 0.1, 1);
    EXPECT_EQ(raster.poured(), 3);
    raster.pour(spec.origin + voxel * Vec3(0, 0.5, 0.5), voxel, voxel * voxel * voxel);  // half of it beyond the edge
    raster.pour(spec.origin + voxel * Vec3(5.5, 3.5, 5.5), voxel, 5 * voxel * voxel * voxel);
    const RasterFrame f = raster.frame(0);
    EXPECT_EQ(std::accumulate(f.water.begin(), f.water.end(), 0), 128 + 255);
}

// Each voxel has the water of one of the two, never of both.
TEST(Raster, TakesAnothersWaterWhereItIsAsked) {
    const double cell = voxel * voxel * voxel;
    Raster raster(spec), other(spec);
    const auto centre = [](double i) -> Vec3 { return spec.origin + voxel * Vec3(i + 0.5, 2.5, 3.5); };
    raster.pour(centre(2), voxel, 0.2 * cell);
    raster.pour(centre(6), voxel, 0.2 * cell);
    other.pour(centre(2), voxel, cell);
    other.pour(centre(6), voxel, cell);
    other.pour(centre(7), voxel, cell);
    const double edge = centre(4).x();
    for (int layer = 0; layer < raster.layers(); ++layer)
        raster.take_where([&](const Vec3& at) { return at.x() > edge; }, other, layer);
    const RasterFrame f = raster.frame(0);
    const auto row = f.water.begin() + (3 * 6 + 2) * 10;
    EXPECT_EQ(std::vector<int>(row, row + 10), (std::vector<int>{0, 0, 51, 0, 0, 0, 255, 255, 0, 0}));
    EXPECT_EQ(std::accumulate(f.water.begin(), f.water.end(), 0), 51 + 2 * 255);
}

// To the same bits as all of the voxels would, and what is poured beside them is lost.
TEST(Raster, OfSomeVoxelsIsThatPartOfTheWhole) {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> x(-0.4, 0.4), y(0.1, 0.5), z(-0.3, 0.4), edge(0.003, 0.19);
    const Box within{{-0.13, -infinite, 0.02}, {0.21, 0.38, infinite}};
    const int first[3] = {3, 0, 4}, end[3] = {8, 4, 9};
    Raster whole(spec), some(spec, within), empty(spec);
    for (int n = 0; n < 60; ++n) {
        const Vec3 centre(x(random), y(random), z(random));
        const double a = edge(random);
        whole.pour(centre, a, a * a * a), some.share_out(centre, a, a * a * a);
    }
    for (int layer = 0; layer < empty.layers(); ++layer)
        empty.take_where([](const Vec3&) { return true; }, some, layer);
    const RasterFrame all = whole.frame(0), part = empty.frame(0);
    std::size_t v = 0;
    for (int k = 0; k < spec.count[2]; ++k)
        for (int j = 0; j < spec.count[1]; ++j)
            for (int i = 0; i < spec.count[0]; ++i, ++v) {
                const int at[3] = {i, j, k};
                bool inside = true;
                for (int a = 0; a < 3; ++a) inside = inside && at[a] >= first[a] && at[a] < end[a];
                EXPECT_EQ(part.water[v], inside ? all.water[v] : 0) << i << ' ' << j << ' ' << k;
            }
}

// A voxel is half full of one cube and the rest of its water comes in parts of 2e-8: a sum in single precision has room
// for those only as long as it is small.
TEST(Raster, IsTheSameInAnyOrderOfPouring) {
    const double cell = voxel * voxel * voxel;
    const Vec3 centre = spec.origin + voxel * Vec3(2.5, 2.5, 3.5);
    Raster first(spec), last(spec);
    first.pour(centre, voxel, 0.5 * cell);
    for (Raster* raster : {&first, &last})
        for (int k = 0; k < 400000; ++k) raster->pour(centre, voxel / 300, 2e-8 * cell);
    last.pour(centre, voxel, 0.5 * cell);
    EXPECT_EQ(first.frame(0).water, last.frame(0).water);
    EXPECT_EQ(first.frame(0).water[static_cast<std::size_t>((3 * 6 + 2) * 10 + 2)], 130);  // (0.5 + 0.008) 255 = 129.5
    EXPECT_EQ(first.poured(), last.poured());
}

}  // namespace raster_test
}  // namespace tw
