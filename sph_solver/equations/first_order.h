#pragma once
#include "sph_solver/equations/pair.h"

namespace tw {

/// Fields between particles, exact where they are linear in space, wherever the particles lie (moving least squares of
/// first order; Dilts 1999, doi:10.1002/(SICI)1097-0207(19990320)44:8<1115::AID-NME547>3.0.CO;2-L). With r = x_j - x,
///
///   f(x) = e_1^T M^-1 sum_j V_j W_j P_j f_j,   M = sum_j V_j W_j P_j P_j^T,   P_j = (1, r)
///
/// and M = (S, b^T; b, A) in blocks:
///
///   f(x) = (sum_j V_j W_j f_j - c . sum_j V_j W_j r f_j) / (S - c . b),   A c = b
///
/// Where the neighbours lie in a plane or a line, or all far to one side (c . b > 0.9 S), c = 0: Shepard's mean.
template <class Real>
struct FirstOrder {
    Real S{}, xx{}, xy{}, xz{}, yy{}, yz{}, zz{};
    V3<Real> b{};

    /// Sums of one field.
    struct Field {
        Real f{};
        V3<Real> r{};
        void sums(auto&& of) { of(f, r); }
        template <class Value>
        void add(const V3<Real>& r_ji, const Real& V_W, const Value& f_j) {
            const Real part = V_W * f_j;
            f += part;
            r += part * r_ji;
        }
    };

    void sums(auto&& of) { of(S, xx, xy, xz, yy, yz, zz, b); }
    void add(const V3<Real>& r, const Real& V_W) {
        S += V_W;
        const V3<Real> V_W_r = V_W * r;
        b += V_W_r;
        xx += V_W_r.x * r.x, xy += V_W_r.x * r.y, xz += V_W_r.x * r.z;
        yy += V_W_r.y * r.y, yz += V_W_r.y * r.z, zz += V_W_r.z * r.z;
    }
    /// After all neighbours; then `value` may be asked.
    void solve(bool two_dimensional) {
        const Real zero{};
        const Real inv_S = S > 0.0f ? 1.0f / S : zero;
        // the second moment over S is 0.06 to 0.07 in the water (lengths in 2h)
        const Real a = xx * inv_S, d = two_dimensional ? zero + 0.07f : yy * inv_S, f = zz * inv_S;
        const Real xy_S = xy * inv_S, xz_S = xz * inv_S, yz_S = yz * inv_S;
        const V3<Real> m{b.x * inv_S, b.y * inv_S, b.z * inv_S};
        const Real cxx = d * f - yz_S * yz_S, cxy = xz_S * yz_S - xy_S * f, cxz = xy_S * yz_S - xz_S * d;
        const Real cyy = a * f - xz_S * xz_S, cyz = xy_S * xz_S - a * yz_S, czz = a * d - xy_S * xy_S;
        const Real det = a * cxx + xy_S * cxy + xz_S * cxz;
        const Real inv = det > 1e-6f ? 1.0f / det : zero;
        c_ = {(cxx * m.x + cxy * m.y + cxz * m.z) * inv, (cxy * m.x + cyy * m.y + cyz * m.z) * inv,
              (cxz * m.x + cyz * m.y + czz * m.z) * inv};
        const Real left = 1.0f - dot(c_, m);
        const Real use = left > 0.1f ? zero + 1.0f : zero;
        c_ = use * c_;
        inv_ = inv_S * (left > 0.1f ? 1.0f / left : zero + 1.0f);
    }
    Real value(const Field& field) const { return (field.f - dot(c_, field.r)) * inv_; }
    /// Shepard's mean of a sum of V_j W_j f_j.
    Real mean(const Real& sum) const { return S > 0.0f ? sum / S : Real{}; }

private:
    V3<Real> c_{};
    Real inv_{};
};

}  // namespace tw
