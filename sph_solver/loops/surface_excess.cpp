#include "sph_solver/loops/surface_excess.h"

#include <cmath>

#include "sph_solver/pair_loops/interpolate.h"

namespace tw {

SurfaceExcess::SurfaceExcess(const Kernel& kernel, double dp, int dimensions) {
    const double volume = dimensions == 3 ? dp * dp * dp : dp * dp;
    const int reach = static_cast<int>(std::ceil(kernel.support() / dp)), across = dimensions == 3 ? reach : 0;
    // over a row at the height z above or below: f(distance)
    const auto row = [&](double z, auto f) {
        double sum = 0;
        for (int i = -reach; i <= reach; ++i)
            for (int j = -across; j <= across; ++j)
                sum += volume * f(std::sqrt(double(i * i + j * j) * dp * dp + z * z));
        return sum;
    };
    const auto W = [&](double r) { return kernel.W(r); };
    const auto support = [&](int k) {  // of row k
        double sum = 0;
        for (int other = 0; other <= k + reach; ++other) sum += row((other - k) * dp, W);
        return sum;
    };
    double A = 0, first_moment = 0;
    for (int k = 1; k <= reach; ++k) {
        const double A_k = row(k * dp, [&](double r) { return kernel.F(r) * k * dp; });
        A += A_k * dp, first_moment += 2 * k * A_k * dp;
    }
    S_0_ = support(0) / support(reach);
    e_0_ = first_moment / (2 * A) - 1;
    const Kernel interpolation(interpolation_h_over_dp * dp, dimensions);
    const auto share_of = [&](double r) { return interpolation.W(r); };
    const auto mean_support = [&](double depth) {
        double sum = 0, weight = 0;
        for (int k = 0; k <= reach + 1; ++k) {
            const double share = row((k + 0.5) * dp - depth, share_of);
            sum += share * support(k), weight += share;
        }
        return sum / weight / support(reach);
    };
    m_0_ = mean_support(dp / 4), m_1_ = mean_support(3 * dp / 4);
}

}  // namespace tw
