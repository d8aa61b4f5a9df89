// The pair loops of surface tension, once per variant.
#include "sph_solver/effects/surface_tension.h"
#include "sph_solver/equations/surface_tension.h"
#include "sph_solver/pair_loops/pair_loop.h"

namespace tw {
namespace TW_ISA {
namespace {

struct GradientOfColour {
    const ColourGradientData& d;
    V3<Real> gradC{};

    GradientOfColour(const ColourGradientData& data, const Own&) : d(data) {}
    void sums(auto&& of) { of(gradC); }
    void meet(std::int32_t, const Met& ij) { ColourGradient::add(ij, gradC); }
    void meet_wall(std::int32_t j, const Met& ij) { meet(j, ij); }
    void store(const Own& i) const {
        i.for_each([&](int own, int l) { d.gradient[own] = {gradC.x[l], gradC.y[l], gradC.z[l], 0}; });
    }
};

struct Curvature {
    const CurvatureData& d;
    const V3<Real> n_i;
    VectorGradient<Real> grad_n;

    Curvature(const CurvatureData& data, const Own& i) : d(data), n_i(i.velocities(d.normal)) {}
    void sums(auto&& of) { of(grad_n); }
    /// Deep in the water nobody has a normal.
    ListRef list(const Cluster& g) const {
        bool any = false;
        for (int l = 0; l < g.size; ++l) any |= d.normal[g.first + l].drho > 0;
        return any ? g.list : ListRef{};
    }
    void meet(std::int32_t j, const Met& ij) {
        if (d.normal[j].drho > 0) grad_n.add(ij, velocity(d.normal[j]) - n_i);
    }
    void store(const Own& i) {
        grad_n.solve(d.water.kernel.support_length, d.water.two_dimensional);
        const Real kappa = curvature(grad_n);
        i.for_each([&](int own, int l) { d.curvature[own] = d.normal[own].drho > 0 ? kappa[l] : 0.0f; });
    }
};

}  // namespace

template <>
void pass(const ColourGradientData& d, const Cluster* clusters, int count) {
    run<GradientOfColour>(d, clusters, count);
}
template <>
void pass(const CurvatureData& d, const Cluster* clusters, int count) {
    run<Curvature>(d, clusters, count);
}

}  // namespace TW_ISA
}  // namespace tw
