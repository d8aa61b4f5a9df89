// What sums over particles make of the kernel's integrals, on a lattice and on jittered particles, two dimensions:
//
//   partition of unity   sum_j V W_ij = 1        sum of gradients   h sum_j V grad_i W_ij = 0
//   first moment         sum_j V r_ji (x) grad_i W_ij = unit tensor
//
// A lattice sum misses an integral only by the kernel's Fourier transform at the lattice's wave numbers 2 pi n / dp
// (Poisson). That of Wendland C2 falls as the power -(d + 3) = -5 of the wave number (Wendland 2004, Scattered Data
// Approximation, theorem 10.35), so the error falls as (dp / h)^5. Places moved at random by a share of dp leave noise
// of (dp / h)^2: the root of the sum of (V |grad W| dp)^2. The renormalised gradient
//
//   <grad f>_i = L_i sum_j (f_j - f_i) grad_i W_ij V_j,   L_i^-1 = sum_j r_ji (x) grad_i W_ij V_j
//
// (Randles & Libersky 1996, doi:10.1016/S0045-7825(96)01090-0) is exact for linear f wherever the particles lie, at the
// free surface too. The engine's own pass is asked for it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

#include "base/vec3.h"
#include "sph_solver/equations/kernel.h"
#include "sph_solver/neighbours/pencils.h"
#include "sph_solver/pair_loops/views.h"

namespace tw {
namespace kernel_moments_test {

constexpr double dp = 0.01;
constexpr int n = 24;  // particles along an edge

/// A square patch of particles with the low corner at 0, each moved by up to `jitter` dp along x and z.
std::vector<Vec3> patch(double jitter) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> move(-jitter * dp, jitter * dp);
    std::vector<Vec3> places;
    for (int k = 0; k < n; ++k)
        for (int i = 0; i < n; ++i)
            places.emplace_back((i + 0.5) * dp + move(random), 0, (k + 0.5) * dp + move(random));
    return places;
}
/// Whether all of the kernel's support lies within the patch.
bool interior(const Vec3& x, double h) {
    return std::min(x.x(), x.z()) > 2 * h + dp && std::max(x.x(), x.z()) < n * dp - 2 * h - dp;
}

/// What the engine's first pair loop makes of particles with the density deviation f, in the order of `places`.
struct PairLoop {
    std::vector<Vec3> places;
    std::vector<PackedGradientPressure> stress;
    std::vector<PackedShiftSupport> shift;
};
template <class Field>
PairLoop pair_loop(const std::vector<Vec3>& unsorted, double h_over_dp, Field f) {
    const double h = h_over_dp * dp;
    const FixedPoint fixed_point(Vec3::Zero(), dp / (1 << 18));
    const Box area{Vec3(-dp, -dp, -dp), Vec3::Constant(n * dp + dp)};
    const PencilGrid grid(area, dp, 2, fixed_point, passes().lanes);
    const Kernel kernel(h, 2);
    std::vector<WidePlace> raw;
    std::vector<PackedPlace> sorted;
    for (const Vec3& x : unsorted) raw.push_back(fixed_point.wide(Vec3(x.x(), 0, x.z())));
    std::vector<std::int32_t> order, start;
    sort_by_pencil(grid, raw, order, start);
    PairLoop r;
    std::vector<PackedVelocityDensity> motion;
    for (const std::int32_t k : order) {
        const Vec3& x = unsorted[static_cast<std::size_t>(k)];
        sorted.push_back(raw[static_cast<std::size_t>(k)].packed(static_cast<float>(dp * dp)));
        motion.push_back({0, 0, 0, static_cast<float>(f(x))});
        r.places.push_back(x);
    }
    std::vector<Cluster> clusters;
    const Source source{&grid, sorted.data(), &start, 0};
    make_clusters(source, passes().lanes, clusters);
    NeighbourLists lists;
    lists.build(passes(), fixed_point, source, clusters, {source}, {2 * h, 2 * h, 2 * h});
    r.stress.resize(sorted.size());
    r.shift.resize(sorted.size());
    std::vector<PackedRate> rate(sorted.size());
    const FirstPairLoopData d{.water = {.list = lists.view(),
                                        .place = sorted.data(),
                                        .motion = motion.data(),
                                        .kernel = kernel,
                                        .unit = static_cast<float>(fixed_point.size),
                                        .two_dimensional = true},
                              .stress = r.stress.data(),
                              .shift = r.shift.data(),
                              .rate = rate.data(),
                              .inv_W_dp = static_cast<float>(1 / kernel.W(dp))};
    passes().run(d, clusters.data(), static_cast<int>(clusters.size()));
    return r;
}

/// Root mean squares over interior particles.
struct Moments {
    double unity = 0, gradient = 0, first = 0;
    double engine = 0;  ///< largest difference of the engine's kernel support from the sum here
};
Moments moments_of(double h_over_dp, double jitter) {
    const double h = h_over_dp * dp;
    const Kernel kernel(h, 2);
    const PairLoop s = pair_loop(patch(jitter), h_over_dp, [](const Vec3&) { return 0.0; });
    Moments m;
    double count = 0;
    for (std::size_t i = 0; i < s.places.size(); ++i) {
        if (!interior(s.places[i], h)) continue;
        double unity = 0, gx = 0, gz = 0, xx = 0, xz = 0, zz = 0;
        for (const Vec3& place : s.places) {
            const Vec3 r = place - s.places[i];
            const double V = dp * dp, F = kernel.F(r.norm());
            unity += V * kernel.W(r.norm());
            gx += V * F * r.x(), gz += V * F * r.z();
            xx += V * F * r.x() * r.x(), xz += V * F * r.x() * r.z(), zz += V * F * r.z() * r.z();
        }
        m.unity += std::pow(unity - 1, 2);
        m.gradient += h * h * (gx * gx + gz * gz);
        m.first += (std::pow(xx - 1, 2) + std::pow(zz - 1, 2)) / 2 + xz * xz;
        m.engine = std::max(m.engine, std::abs(double(s.shift[i].support) - unity));
        ++count;
    }
    return {std::sqrt(m.unity / count), std::sqrt(m.gradient / count), std::sqrt(m.first / count), m.engine};
}

TEST(KernelMoments, OfALatticeConvergeFastWithTheKernelsWidthAndOfJitteredParticlesSlowly) {
    std::printf("          lattice                                  | jittered by up to dp/5\n");
    std::printf("  h/dp   1 - sum VW  first moment  h sum V grad W  | 1 - sum VW  first moment  h sum V grad W\n");
    std::vector<Moments> lattices, jittered;
    const std::vector<double> ratios = {1.2, 1.5, 2, 2.5, 3};
    for (const double ratio : ratios) {
        lattices.push_back(moments_of(ratio, 0)), jittered.push_back(moments_of(ratio, 0.2));
        const Moments &a = lattices.back(), &b = jittered.back();
        std::printf("  %3.1f    %.2e    %.2e      %.1e         | %.2e    %.2e      %.2e\n", ratio, a.unity, a.first,
                    a.gradient, b.unity, b.first, b.gradient);
        EXPECT_LT(a.engine, 1e-5) << ratio;  // single precision
        EXPECT_LT(b.engine, 1e-5) << ratio;
    }
    const auto order = [&](double a, double b) { return std::log(a / b) / std::log(ratios.back() / ratios[1]); };
    const Moments &a = lattices[1], &b = lattices[4], &c = jittered[1], &d = jittered[4];
    std::printf(
        "  order  %.1f         %.1f                             | %.1f         %.1f           %.1f   (1.5 to 3)\n",
        order(a.unity, b.unity), order(a.first, b.first), order(c.unity, d.unity), order(c.first, d.first),
        order(c.gradient, d.gradient));
    EXPECT_NEAR(order(a.unity, b.unity), 5, 0.5);
    EXPECT_NEAR(order(a.first, b.first), 5, 1);  // its sign changes with h / dp
    EXPECT_LT(a.gradient, 1e-12);                // symmetry
    EXPECT_NEAR(order(c.unity, d.unity), 2, 0.5);
    EXPECT_NEAR(order(c.first, d.first), 2, 0.5);
    EXPECT_NEAR(order(c.gradient, d.gradient), 2, 0.5);
    EXPECT_LT(a.unity, 0.006);  // at the engine's h / dp = 1.5
    EXPECT_LT(a.first, 0.003);
}

TEST(RenormalisedGradient, IsExactForLinearFieldsOnJitteredParticlesUpToTheFreeSurface) {
    const auto linear = [](const Vec3& x) { return 3 * x.x() - 2 * x.z(); };
    std::printf("  h/dp  jitter  largest error of the gradient of a linear field\n");
    for (const double ratio : {1.5, 2.0, 3.0})
        for (const double jitter : {0.0, 0.2, 0.4}) {
            const PairLoop s = pair_loop(patch(jitter), ratio, linear);
            double error = 0;
            for (const PackedGradientPressure& g : s.stress)
                error = std::max(error, std::hypot(g.gx - 3.0, g.gz + 2.0));
            std::printf("  %.1f   %.1f     %.1e\n", ratio, jitter, error / std::sqrt(13.0));
            EXPECT_LT(error, 2e-5) << ratio << " " << jitter;
        }
}

TEST(RenormalisedGradient, OfAQuadraticFieldIsExactInALatticeAndOffByAboutHAtItsEdge) {
    // third moments vanish inside a lattice by symmetry, not among jittered particles, nor where the support is
    // one-sided
    std::printf(
        "  h/dp  error of the gradient of x^2 + z^2, over h: inside the lattice, jittered, within 2h of its edge\n");
    for (const double ratio : {1.5, 2.0, 3.0}) {
        const double h = ratio * dp;
        double inside[2] = {}, edge = 0;
        for (const bool jitter : {false, true}) {
            const PairLoop s = pair_loop(patch(jitter ? 0.2 : 0), ratio, [](const Vec3& x) { return x.squaredNorm(); });
            for (std::size_t i = 0; i < s.places.size(); ++i) {
                const double error =
                    std::hypot(s.stress[i].gx - 2 * s.places[i].x(), s.stress[i].gz - 2 * s.places[i].z()) / h;
                if (interior(s.places[i], h))
                    inside[jitter] = std::max(inside[jitter], error);
                else if (!jitter)
                    edge = std::max(edge, error);
            }
        }
        std::printf("  %.1f   %.1e  %.3f  %.3f\n", ratio, inside[0], inside[1], edge);
        EXPECT_LT(inside[0], 1e-4) << ratio;                   // rounding
        EXPECT_LT(inside[1], 0.7 / (ratio * ratio)) << ratio;  // noise of the places: found 0.5 to 0.4 over the square
        EXPECT_NEAR(edge, 1.25, 0.1) << ratio;                 // first order, the same at any width
    }
}

}  // namespace kernel_moments_test
}  // namespace tw
