// Where a hull counts as wet, against a waterline that is known: still water under a tilted plate, by geometry alone.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "../record/free_streamline.h"
#include "record/wet_wall.h"
#include "sph_solver/bodies/samples.h"
#include "sph_solver/equations/half_space.h"
#include "sph_solver/equations/kernel.h"

namespace tw {
namespace wetness_test {

/// A flat plate through the origin, from 6h below still water to 6h above it, looking down at `theta` to the surface
/// (90 degrees: upright), and how far along it the wet patches reach beyond the waterline.
struct Plate {
    Vec3 up;  ///< along the plate, out of the water
    SurfaceSamples samples;

    Plate(double theta, double h)
        : up(std::cos(theta), 0, std::sin(theta)), samples(SurfaceSamples::of_section(strip(up, h), h / 8)) {
        // Water: z < 0 on the plate's outer side, as columns of points far finer than h.
        const Vec3 out(std::sin(theta), 0, -std::cos(theta));
        const Kernel kernel(h, 2);
        const double fine = h / 8;
        const auto support_at = [&](const Vec3& place) {
            double sum = 0;
            for (int i = cell(place.x() - 2 * h, fine); i <= cell(place.x() + 2 * h, fine); ++i)
                for (int k = cell(place.z() - 2 * h, fine); k <= std::min(-1, cell(place.z() + 2 * h, fine)); ++k) {
                    const Vec3 p(i * fine, 0, (k + 0.5) * fine);
                    if (p.dot(out) > 0) sum += fine * fine * kernel.W((p - place).norm());
                }
            return static_cast<float>(sum);
        };
        for (const Vec3& place : samples.points.places) samples.points.support.push_back(support_at(place));
    }
    /// Of the last wet patch, beyond the waterline [m].
    double reach(auto&& wet) const {
        double most = -1e9;
        for (std::size_t k = 0; k < samples.area.size(); ++k)
            if (wet(k)) most = std::max(most, samples.points.places[k].dot(up));
        return most;
    }

private:
    static int cell(double x, double size) { return static_cast<int>(std::floor(x / size)); }
    /// Outward normal out of the plate's water side; as thin as a line.
    static Surface strip(const Vec3& up, double h) {
        const Vec3 side(0, 1e-3 * h, 0), end = 6 * h * up;
        Surface s;
        s.points = {-end - side, end - side, end + side, -end + side};
        s.triangles = {{0, 2, 1}, {0, 3, 2}};
        return s;
    }
};

TEST(Wetness, ReachesAsFarAsTheWaterAtEveryAngle) {
    struct Case {
        double deg, h, most;  ///< largest error [h]; a patch is h / 8 long
    };
    for (const auto& [deg, h, most] :
         {Case{5, 0.1, 0.5}, Case{5, 0.05, 0.5}, Case{10, 0.1, 0.15}, Case{20, 0.1, 0.15}, Case{30, 0.1, 0.15},
          Case{45, 0.1, 0.15}, Case{60, 0.1, 0.15}, Case{90, 0.1, 0.15}, Case{90, 0.05, 0.15}, Case{120, 0.1, 0.15},
          Case{150, 0.1, 0.25}}) {
        const Plate plate(deg * std::numbers::pi / 180, h);
        const double found = plate.reach([&](std::size_t k) { return plate.samples.wet(k); }) / h;
        EXPECT_NEAR(found, 0, most) << deg << " degrees, h " << h;
        // One threshold for all angles, a quarter, is right on an upright side only.
        const double quarter = plate.reach([&](std::size_t k) { return plate.samples.points.support[k] >= 0.25f; });
        std::printf("%5.0f deg, h %.2f: %+.2f h, with a quarter %+.2f h\n", deg, h, found, quarter / h);
        if (deg == 5) { EXPECT_GT(quarter / h, 3.9); }
    }
}

TEST(Wetness, OfAKeelIsItsLengthUpToTheWaterline) {
    for (const double h : {0.1, 0.05}) {
        const double theta = 5 * std::numbers::pi / 180;
        const Plate plate(theta, h);
        EXPECT_NEAR(plate.samples.wetted_length(1) / h, 6 * std::cos(theta), 0.6);
    }
}

TEST(Wetness, TheGapToWaterIsKnownFromItsSupport) {
    const double h = 0.1, fine = h / 16;
    const Kernel kernel(h, 3);
    for (const double gap : {0.0, 0.13, 0.4, 1.0}) {
        double support = 0;
        for (double x = -2 * h + fine / 2; x < 2 * h; x += fine)
            for (double y = -2 * h + fine / 2; y < 2 * h; y += fine)
                for (double z = gap * h + fine / 2; z < 2 * h; z += fine)
                    support += fine * fine * fine * kernel.W(Vec3(x, y, z).norm());
        EXPECT_NEAR(support, half_space_support(gap), 1e-3) << gap;
        EXPECT_NEAR(half_space_distance(half_space_support(gap)), gap, 1e-5);
    }
    EXPECT_EQ(half_space_distance(0.52), 0);
    EXPECT_NEAR(half_space_distance(0), 2, 1e-5);
}

// Water about a cylinder in a free jet, whose exact streamline leaves it at 49 degrees; what the patches see of it.
TEST(Wetness, WaterHasLeftACylinderWhereItsExactStreamlineDoes) {
    const FreeStreamlines exact;
    const FreeStreamlines::Line& line = exact.lines.at(0.5);
    for (const double spacings : {11., 22.}) {  // in the radius
        const double R = 1, dp = R / spacings, h = 1.55 * dp, fine = h / 8;
        const Kernel kernel(h, 2);
        const auto is_water = [&](double x, double z) {
            const double r = std::hypot(x, z), angle = std::atan2(std::abs(x), -z) * 180 / std::numbers::pi;
            return r > R * (1 + line.gap(angle)) && line.gap(angle) < 1;
        };
        WetWall wall;
        for (int k = 0; k < 4 * int(spacings); ++k) {  // one side
            const double at = std::numbers::pi * (k + 0.5) / (4 * spacings);
            const Vec3 out(std::sin(at), 0, -std::cos(at));
            double support = 0;
            for (double x = R * out.x() - 2 * h + fine / 2; x < R * out.x() + 2 * h; x += fine)
                for (double z = R * out.z() - 2 * h + fine / 2; z < R * out.z() + 2 * h; z += fine)
                    if (is_water(x, z)) support += fine * fine * kernel.W(std::hypot(x - R * out.x(), z - R * out.z()));
            wall.add(out, 0, true, 1.55 * half_space_distance(support));
        }
        EXPECT_NEAR(wall.leaving_angle() * 180 / std::numbers::pi, line.leaves(), 4) << spacings;
    }
}

}  // namespace wetness_test
}  // namespace tw
