#pragma once
// The loop over the neighbours of a group, for files that are compiled once per instruction set (TW_ISA names it).
// Everything here has internal linkage and calls no inline function of the standard library: the linker would be free
// to keep one file's AVX-512 copy for the whole program.
#include "sph_solver/backend/pass_data.h"
#include "sph_solver/backend/simd.h"
#include "sph_solver/equations/terms.h"

namespace tw {
namespace TW_ISA {
namespace {

using simd::F;
using simd::lanes;

/// Lengths in 2h, and volumes as G V, see Kernel.
struct Frame {
    float length;  ///< per quantum
    float volume;  ///< per m3
};
inline Frame frame_of(const Kernel& kernel, float quantum) { return {quantum * kernel.inv_support, kernel.gradient}; }

/// A chunk of neighbours as the pair loop loads them, broadcast.
struct alignas(64) Chunk {
    static constexpr int capacity = 256;
    static constexpr int ahead = 3;  // by so many pairs the distances run ahead
    float xyz[capacity + ahead][4];  // relative to the group's centre [2h]; the fourth is G V
    F t[capacity + ahead];           // closeness of each lane
    std::int32_t index[capacity + 16];
};

typedef std::int32_t I4 __attribute__((vector_size(16), may_alias));
typedef float F4 __attribute__((vector_size(16), may_alias));

/// Loads n neighbours, and zeros for the places beyond them whose distances are made and not used.
inline void load_chunk(Chunk& chunk, const PlaceRecord* place, int n, const Group& g, const Frame& frame) {
    for (int k = n; k < n + Chunk::ahead; ++k) *reinterpret_cast<F4*>(chunk.xyz[k]) = F4{};
    const I4 centre{g.x, g.y, g.z, 0};
    for (int k = 0; k < n; ++k) {
        const PlaceRecord& r = place[chunk.index[k]];
        const I4 raw = *reinterpret_cast<const I4*>(&r);
        F4 relative = __builtin_convertvector(raw - centre, F4) * frame.length;
        relative[3] = r.volume * frame.volume;
        *reinterpret_cast<F4*>(chunk.xyz[k]) = relative;
    }
}

/// The group's own particles, one per lane [2h]; lanes beyond its size repeat the last particle.
struct Lanes {
    F x{}, y{}, z{};
};
inline Lanes load_places(const PlaceRecord* place, const Group& g, const Frame& frame) {
    Lanes r;
    for (int l = 0; l < lanes; ++l) {
        const PlaceRecord& a = place[g.first + (l < g.size ? l : g.size - 1)];
        r.x[l] = static_cast<float>(a.x - g.x) * frame.length;
        r.y[l] = static_cast<float>(a.y - g.y) * frame.length;
        r.z[l] = static_cast<float>(a.z - g.z) * frame.length;
    }
    return r;
}

inline V3<F> separation(const Lanes& a, const float* xyz) { return {xyz[0] - a.x, xyz[1] - a.y, xyz[2] - a.z}; }

/// 1 - |r_ji| / 2h, cut off at the support.
inline F closeness(const Lanes& a, const float* xyz) {
    const V3<F> r = separation(a, xyz);
    return simd::positive_part(1.0f - simd::sqrt(dot(r, r)));
}

/// A pair with what of its kernel the terms share, t its closeness.
struct Met : Pair<F> {
    F t, t3;
    V3<F> gradient() const { return {FV * r_ji.x, FV * r_ji.y, FV * r_ji.z}; }  ///< grad_i W_ij V_j [1/m]
    F shape() const { return t * (5.0f - 4.0f * t); }                           ///< W_ij V_j = h/10 FV shape
};
inline Met meet(const Lanes& a, const float* xyz, const F& t) {
    Met k;
    k.r_ji = separation(a, xyz);
    k.t = t;
    k.distance = 1.0f - t;
    k.t3 = (t * t) * t;
    k.FV = k.t3 * xyz[3];
    return k;
}

/// Which places of a block a loop visits: all live ones, or of these those at the free surface.
struct Live {
    std::uint32_t operator()(const NeighbourBlock& b) const { return b.live; }
};
struct AtSurface {
    const std::uint32_t* surface;
    std::uint32_t operator()(const NeighbourBlock& b) const {
        const std::uint32_t* word = surface + b.first / 32;
        const std::uint64_t both = word[0] | std::uint64_t{word[1]} << 32;
        return static_cast<std::uint32_t>(both >> (b.first % 32)) & b.live;
    }
};

/// Calls `body(j, ij)` for the neighbours on a list that `which` names. The distances run ahead: a
/// root takes as long as ten other operations, and the processor itself looks ahead by two or three pairs only.
///
/// Inlined whatever the compiler thinks: GCC 12.2 at -O2 with AVX drops a call, and so the sums, of a function that
/// gets a closure by value and changes things only through the references in it (seen here, and in 25 lines).
template <class Body, class Which = Live>
[[gnu::always_inline]] inline void for_each_neighbour(const PlaceRecord* place, const Lists& lists, const ListRef& ref,
                                                      const Group& g, const Frame& frame, const Lanes& a, Body&& body,
                                                      Which which = {}) {
    const NeighbourBlock* const list = lists.blocks(ref);
    Chunk chunk;
    for (int k = 0; k < ref.size;) {
        int n = 0;
        for (; k < ref.size && n <= Chunk::capacity - 32; ++k)
            n = simd::append_set_bits(list[k].first, which(list[k]), chunk.index, n);
        if (n == 0) continue;
        load_chunk(chunk, place, n, g, frame);
        for (int m = 0; m < Chunk::ahead; ++m) chunk.t[m] = closeness(a, chunk.xyz[m]);
        for (int m = 0; m < n; ++m) {
            chunk.t[m + Chunk::ahead] = closeness(a, chunk.xyz[m + Chunk::ahead]);
            body(chunk.index[m], meet(a, chunk.xyz[m], chunk.t[m]));
        }
    }
}

/// Inverse of a symmetric 3x3 matrix applied to a vector; where it is nearly singular (spray) the result is zero.
inline V3<F> solve_symmetric(const F (&m)[6], const V3<F>& b) {
    const F xx = m[0], xy = m[1], xz = m[2], yy = m[3], yz = m[4], zz = m[5];
    const F cxx = yy * zz - yz * yz, cxy = xz * yz - xy * zz, cxz = xy * yz - xz * yy;
    const F cyy = xx * zz - xz * xz, cyz = xy * xz - xx * yz, czz = xx * yy - xy * xy;
    const F det = xx * cxx + xy * cxy + xz * cxz;
    // det = 1 inside the fluid, about 1/2 at a plane surface
    const F inv = det > 0.02f ? 1.0f / det : F{};
    return {(cxx * b.x + cxy * b.y + cxz * b.z) * inv, (cxy * b.x + cyy * b.y + cyz * b.z) * inv,
            (cxz * b.x + cyz * b.y + czz * b.z) * inv};
}

/// Renormalised gradient of a vector field, exact for linear ones (Randles & Libersky 1996):
///   <grad u>_i = L_i sum_j (u_j - u_i) (x) grad W_ij V_j,   L_i^-1 = sum_j r_ji (x) grad W_ij V_j
struct VectorGradient {
    F m[6] = {};
    V3<F> u{F{}, F{}, F{}}, v{F{}, F{}, F{}}, w{F{}, F{}, F{}};  ///< sums; the gradients of the components once solved

    /// `jump` is u_j - u_i.
    void add(const Met& ij, const V3<F>& jump) {
        const V3<F>& r = ij.r_ji;
        const V3<F> f = ij.gradient();
        m[0] += f.x * r.x, m[1] += f.x * r.y, m[2] += f.x * r.z;
        m[3] += f.y * r.y, m[4] += f.y * r.z, m[5] += f.z * r.z;
        u.x += jump.x * f.x, u.y += jump.x * f.y, u.z += jump.x * f.z;
        v.x += jump.y * f.x, v.y += jump.y * f.y, v.z += jump.y * f.z;
        w.x += jump.z * f.x, w.y += jump.z * f.y, w.z += jump.z * f.z;
    }
    void solve(float support_length, bool two_dimensional) {
        for (F& entry : m) entry *= support_length;
        if (two_dimensional) m[3] += 1.0f;
        u = solve_symmetric(m, u), v = solve_symmetric(m, v), w = solve_symmetric(m, w);
    }
};

/// Velocities of the group's own particles [m/s].
inline V3<F> velocities(const PassData& d, const Group& g) {
    V3<F> u{};
    for (int l = 0; l < lanes; ++l) {
        const VelocityDensityRecord& r = d.motion[g.first + (l < g.size ? l : g.size - 1)];
        u.x[l] = r.u, u.y[l] = r.v, u.z[l] = r.w;
    }
    return u;
}

/// What every neighbour adds, water, wall or air: kernel support (without the factor tenth_h) and the shifting sum (Sun
/// et al. 2017).
struct ShiftWeight {
    float clumping;
    explicit ShiftWeight(const PassData& d) {
        const float W_over_W_dp = d.kernel.tenth_h * d.kernel.gradient * d.inv_W_dp;  // of t3 shape
        const float ratio2 = W_over_W_dp * W_over_W_dp;
        clumping = 0.2f * ratio2 * ratio2;
    }
    void count_in(const Met& ij, F& support, V3<F>& s) const {
        const F shape = ij.shape();
        support += ij.FV * shape;
        const F W = ij.t3 * shape, W2 = W * W;
        const F share = clumping * (W2 * W2) + 1.0f;
        const V3<F> f = ij.gradient();
        s.x += share * f.x;
        s.y += share * f.y;
        s.z += share * f.z;
    }
};

/// Tension control (Sun et al. 2018, doi:10.1016/j.cpc.2017.11.016): inside the fluid p_j - p_i in place of p_j + p_i
/// where p_i < 0, so that what is stretched does not clump. Not beside walls, where the pair forces are the load.
inline void control_tension(const PassData& d, const Group& g, F& p_i) {
    if (d.tension_control_from > 1.5f || g.wall_list.size > 0) return;
    for (int l = 0; l < lanes; ++l)
        if (d.shift[g.first + (l < g.size ? l : g.size - 1)].support > d.tension_control_from && p_i[l] < 0)
            p_i[l] = -p_i[l];
}

/// Sum of the accelerations w of a group's particles by walls, and of their moments about its centre.
inline WallLoad load_of(const Lanes& a, float support_length, const V3<F>& w, int size) {
    const F x = a.x * support_length, y = a.y * support_length, z = a.z * support_length;
    const V3<F> m{y * w.z - z * w.y, z * w.x - x * w.z, x * w.y - y * w.x};
    WallLoad sum;
    for (int l = 0; l < size; ++l) {
        sum.ax += w.x[l], sum.ay += w.y[l], sum.az += w.z[l];
        sum.mx += m.x[l], sum.my += m.y[l], sum.mz += m.z[l];
    }
    return sum;
}

}  // namespace
}  // namespace TW_ISA
}  // namespace tw
