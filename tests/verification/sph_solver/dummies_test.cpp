// Where the water feels a solid's surface to be, against where it is. The dummies of a body are the quadrature of its
// part of a kernel's support, so at a place x on the surface
//
//   e(x) = (sum_k V_k W(x - x_k) - int_solid W(x - x') dx') / int W(s) over the plane through the kernel's middle
//
// is how far the surface stands too far out (e > 0) [m]: a shift of a flat wall by e changes the sum by e times the
// integral below. The solid's own integral is taken by samples of a quarter of a spacing.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>
#include <random>
#include <string>
#include <tuple>

#include "meshes/generate.h"
#include "meshes/mass_properties.h"
#include "sph_solver/bodies/dummies.h"
#include "sph_solver/bodies/samples.h"
#include "sph_solver/equations/kernel.h"

namespace tw {
namespace dummies_test {

using Lengths = std::map<std::string, double>;
const Box everywhere{Vec3::Constant(-100), Vec3::Constant(100)};

/// int W dA over the plane through the middle, by rings; 1/length.
double middle_of(const Kernel& kernel) {
    const double step = kernel.support() / 400;
    double sum = 0;
    for (double r = step / 2; r < kernel.support(); r += step) sum += 2 * std::numbers::pi * r * step * kernel.W(r);
    return sum;
}

struct Errors {
    double mean = 0, root = 0, largest = 0;  ///< of e over the surface, in spacings
};

/// At `count` places spread evenly over the surface by a fixed seed, by area: noses, flanks and edges alike.
Errors errors_of(const Surface& surface, double dp, int count) {
    const SurfaceQuery query(surface);
    const Kernel kernel(1.55 * dp, 3);
    const double reach = kernel.support(), fine = dp / 4;
    const Dummies dummies = make_dummies(query, surface.bounds(), dp, reach + dp, everywhere, 3);
    const SurfaceSamples patches(surface, 2 * dp, everywhere);
    std::mt19937 random(3);
    std::vector<double> areas;
    for (const Vec3& a : patches.area) areas.push_back(a.norm());
    std::discrete_distribution<std::size_t> by_area(areas.begin(), areas.end());
    Errors errors;
    for (int n = 0; n < count; ++n) {
        const Vec3 x = patches.points.places[by_area(random)];
        double felt = 0, solid = 0;
        for (std::size_t k = 0; k < dummies.places.size(); ++k)
            felt += dummies.volumes[k] * kernel.W((x - dummies.places[k]).norm());
        const int half = static_cast<int>(std::ceil(reach / fine));
        for (int i = -half; i < half; ++i)
            for (int j = -half; j < half; ++j)
                for (int k = -half; k < half; ++k) {
                    const Vec3 arm = fine * Vec3(i + 0.5, j + 0.5, k + 0.5);
                    const double w = kernel.W(arm.norm());
                    if (w > 0 && query.nearest(x + arm, 2 * reach).distance < 0) solid += fine * fine * fine * w;
                }
        const double e = (felt - solid) / middle_of(kernel) / dp;
        errors.mean += e / count;
        errors.root += e * e / count;
        errors.largest = std::max(errors.largest, std::abs(e));
    }
    errors.root = std::sqrt(errors.root);
    return errors;
}

TEST(Dummies, FollowNosesAndSharpEdgesWithinATenthOfASpacing) {
    std::printf("surface                spacings   volume [%%]   mean, root mean square, largest error [dp]\n");
    for (const auto& [name, parameters, diameter] : {std::tuple{"sphere", Lengths{{"diameter", 1}}, 1.0},
                                                     {"cylinder", Lengths{{"diameter", 1}, {"span", 1}}, 1.0},
                                                     {"torpedo", Lengths{}, 0.32}})
        for (const double spacings : {6.3, 12.7}) {
            const Surface surface = posed(make_hull(name, parameters), {.trim = 0.31, .draft = 0.137});
            const double dp = diameter / spacings;
            const Dummies all = make_dummies(SurfaceQuery(surface), surface.bounds(), dp, 100, everywhere, 3);
            const double volume = std::accumulate(all.volumes.begin(), all.volumes.end(), 0.0);
            const double off = 100 * (volume / mass_properties(surface).volume - 1);
            const Errors e = errors_of(surface, dp, 10);
            std::printf("%-20s %9.1f %12.2f %12.3f %8.3f %8.3f\n", name, spacings, off, e.mean, e.root, e.largest);
            EXPECT_LT(std::abs(off), 1) << name;  // the body's mass is the surface's own (motion/rigid_mass.h)
            EXPECT_LT(e.largest, 0.1) << name;
            EXPECT_LT(std::abs(e.mean), 0.05) << name;
            EXPECT_GT(e.largest, 1e-4) << "or dummies and samples are the same";
        }
}

}  // namespace dummies_test
}  // namespace tw
