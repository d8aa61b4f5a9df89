#pragma once
#include "sph_solver/equations/pair.h"

namespace tw {

// Renormalised gradients, exact for linear fields wherever the particles lie (Randles & Libersky 1996,
// doi:10.1016/S0045-7825(96)01090-0):
//
//   <grad f>_i = L_i sum_j (f_j - f_i) grad_i W_ij V_j,   L_i^-1 = M_i = sum_j r_ji (x) grad_i W_ij V_j

/// First moment of the kernel's gradient, M_i; symmetric. In the continuum it is the unit tensor.
template <class Real>
struct FirstMoment {
    Real xx{}, xy{}, xz{}, yy{}, yz{}, zz{};

    void sums(auto&& of) { of(xx, xy, xz, yy, yz, zz); }
    template <class Form>
    void add(const Pair<Real, Form>& ij) {
        const V3<Real>& r = ij.r_ji;
        const V3<Real> V_gradW = ij.V_gradW();
        xx += V_gradW.x * r.x;
        xy += V_gradW.x * r.y;
        xz += V_gradW.x * r.z;
        yy += V_gradW.y * r.y;
        yz += V_gradW.y * r.z;
        zz += V_gradW.z * r.z;
    }
    /// From lengths in 2h to [-].
    void scale(float support_length) {
        xx *= support_length, xy *= support_length, xz *= support_length;
        yy *= support_length, yz *= support_length, zz *= support_length;
    }
    /// In two dimensions nothing varies along y.
    void fill_second_axis() { yy += 1.0f; }
    /// L_i b; where M_i is nearly singular (spray) the result is zero.
    V3<Real> solve(const V3<Real>& b) const {
        const Real cxx = yy * zz - yz * yz, cxy = xz * yz - xy * zz, cxz = xy * yz - xz * yy;
        const Real cyy = xx * zz - xz * xz, cyz = xy * xz - xx * yz, czz = xx * yy - xy * xy;
        const Real det = xx * cxx + xy * cxy + xz * cxz;
        // det = 1 inside the fluid, about 1/2 at a plane surface
        const Real inv = det > 0.02f ? 1.0f / det : Real{};
        return {(cxx * b.x + cxy * b.y + cxz * b.z) * inv, (cxy * b.x + cyy * b.y + cyz * b.z) * inv,
                (cxz * b.x + cyz * b.y + czz * b.z) * inv};
    }
};

/// Of a scalar field.
template <class Real>
struct ScalarGradient {
    FirstMoment<Real> moment;
    V3<Real> sum{};

    void sums(auto&& of) { of(moment, sum); }
    /// `jump` is f_j - f_i.
    template <class Form>
    void add(const Pair<Real, Form>& ij, const Real& jump) {
        moment.add(ij);
        sum += jump * ij.V_gradW();
    }
};

/// Of a vector field, component by component.
template <class Real>
struct VectorGradient {
    FirstMoment<Real> moment;
    V3<Real> u{}, v{}, w{};  ///< sums; the gradients of the components once solved

    void sums(auto&& of) { of(moment, u, v, w); }
    /// `jump` is u_j - u_i.
    template <class Form>
    void add(const Pair<Real, Form>& ij, const V3<Real>& jump) {
        moment.add(ij);
        const V3<Real> V_gradW = ij.V_gradW();
        u += jump.x * V_gradW;
        v += jump.y * V_gradW;
        w += jump.z * V_gradW;
    }
    void solve(float support_length, bool two_dimensional) {
        moment.scale(support_length);
        if (two_dimensional) moment.fill_second_axis();
        u = moment.solve(u), v = moment.solve(v), w = moment.solve(w);
    }
    Real divergence() const { return u.x + v.y + w.z; }
};

}  // namespace tw
