#pragma once
// Eight or sixteen floats at a time (TW_LANES). The vector type is GCC's: with AVX one register, on baseline x86-64
// two, on other machines whatever the compiler makes of it. The pair terms are written against `Real` and never see
// this.
//
// Sixteen halve the operations a pair, but a cluster is visited by every neighbour of any of its particles, and a
// larger cluster has more of those in vain (113 useful pairs a particle; lists with a slack of 0.2 dp hold 297 at h/dp
// = 1.5, and 367 with sixteen). Processors that make a 512-bit operation of two halves lose by it: choose_passes.h
// measures.
//
// Static: what is compiled for one instruction set must not serve another.
#include <cmath>
#include <cstdint>
#if defined(__x86_64__)
#include <immintrin.h>
#endif

#ifndef TW_LANES
#define TW_LANES 8
#endif

namespace tw::simd {

static constexpr int lanes = TW_LANES;
typedef float Real __attribute__((vector_size(4 * lanes)));

#if defined(__AVX512F__) && TW_LANES == 16
static inline Real sqrt(Real x) { return (Real)_mm512_sqrt_ps((__m512)x); }
static inline Real positive_part(Real x) { return (Real)_mm512_max_ps((__m512)x, _mm512_setzero_ps()); }
static inline Real min(Real x, Real y) { return (Real)_mm512_min_ps((__m512)x, (__m512)y); }
static inline Real max(Real x, Real y) { return (Real)_mm512_max_ps((__m512)x, (__m512)y); }
static inline std::uint32_t bits_below(Real x, float limit) {
    return _mm512_cmp_ps_mask((__m512)x, _mm512_set1_ps(limit), _CMP_LT_OQ);
}
static inline Real rough_reciprocal_root(Real x) { return (Real)_mm512_rsqrt14_ps((__m512)x); }
static inline Real rough_reciprocal(Real x) { return (Real)_mm512_rcp14_ps((__m512)x); }
#elif defined(__AVX__) && TW_LANES == 8
static inline Real sqrt(Real x) { return (Real)_mm256_sqrt_ps((__m256)x); }
static inline Real positive_part(Real x) { return (Real)_mm256_max_ps((__m256)x, _mm256_setzero_ps()); }
static inline Real min(Real x, Real y) { return (Real)_mm256_min_ps((__m256)x, (__m256)y); }
static inline Real max(Real x, Real y) { return (Real)_mm256_max_ps((__m256)x, (__m256)y); }
static inline std::uint32_t bits_below(Real x, float limit) {
    return static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_cmp_ps((__m256)x, _mm256_set1_ps(limit), _CMP_LT_OQ)));
}
#if defined(__AVX512VL__)
static inline Real rough_reciprocal_root(Real x) { return (Real)_mm256_rsqrt14_ps((__m256)x); }
static inline Real rough_reciprocal(Real x) { return (Real)_mm256_rcp14_ps((__m256)x); }
#else
static inline Real rough_reciprocal_root(Real x) { return (Real)_mm256_rsqrt_ps((__m256)x); }
static inline Real rough_reciprocal(Real x) { return (Real)_mm256_rcp_ps((__m256)x); }
#endif
#elif defined(__SSE__)
typedef __m128 Register;
static inline Register sqrt(Register x) { return _mm_sqrt_ps(x); }
static inline Register positive_part(Register x) { return _mm_max_ps(x, _mm_setzero_ps()); }
static inline int below(Register x, float limit) { return _mm_movemask_ps(_mm_cmplt_ps(x, _mm_set1_ps(limit))); }
union Parts {
    Real whole;
    Register part[sizeof(Real) / sizeof(Register)];
};
static inline Real sqrt(Real x) {
    Parts u{x};
    for (auto& p : u.part) p = sqrt(p);
    return u.whole;
}
static inline Real positive_part(Real x) {
    Parts u{x};
    for (auto& p : u.part) p = positive_part(p);
    return u.whole;
}
static inline Real min(Real x, Real y) {
    Parts u{x};
    const Parts v{y};
    for (unsigned k = 0; k < sizeof(Real) / sizeof(Register); ++k) u.part[k] = _mm_min_ps(u.part[k], v.part[k]);
    return u.whole;
}
static inline std::uint32_t bits_below(Real x, float limit) {
    const Parts u{x};
    std::uint32_t bits = 0;
    for (unsigned k = 0; k < sizeof(Real) / sizeof(Register); ++k)
        bits |= static_cast<std::uint32_t>(below(u.part[k], limit)) << (4 * k);
    return bits;
}
#else
static inline Real sqrt(Real x) {
    for (int l = 0; l < lanes; ++l) x[l] = std::sqrt(x[l]);
    return x;
}
static inline Real positive_part(Real x) {
    for (int l = 0; l < lanes; ++l) x[l] = x[l] > 0 ? x[l] : 0;
    return x;
}
static inline Real min(Real x, Real y) {
    for (int l = 0; l < lanes; ++l) x[l] = x[l] < y[l] ? x[l] : y[l];
    return x;
}
static inline std::uint32_t bits_below(Real x, float limit) {
    std::uint32_t bits = 0;
    for (int l = 0; l < lanes; ++l) bits |= (x[l] < limit ? 1u : 0u) << l;
    return bits;
}
#endif
#if defined(TW_ROUGH)
/// Root and quotient without the divider: one Newton step from the processor's estimate (12 or 14 bits) gives all but
/// the last bit or two. The root of zero is 1e-15, no neighbour to a closeness in single precision.
static inline Real root(Real x) {
    const Real least = Real{} + 1e-30f;
    x = max(x, least);
    const Real y = rough_reciprocal_root(x), d = x * y;
    return d + (0.5f * d) * (1.0f - d * y);
}
static inline Real quotient(Real a, Real b) {
    const Real y = rough_reciprocal(b), q = a * y;
    return q + y * (a - b * q);
}
#else
static inline Real root(Real x) { return sqrt(x); }
static inline Real quotient(Real a, Real b) { return a / b; }
#endif
/// bits_below: bit l is set where lane l is below the limit.
/// append_set_bits: writes first + k for every set bit k of the mask to out[n...], ascending; returns the new n. May
/// write (and leave rubbish in) up to 16 entries beyond.
static inline int append_set_bits(std::int32_t first, std::uint32_t mask, std::int32_t* out, int n) {
#if defined(__AVX512F__)
    const __m512i step = _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    for (int half = 0; half < 2; ++half) {
        const auto m = static_cast<__mmask16>(mask >> (16 * half));
        const __m512i index = _mm512_add_epi32(step, _mm512_set1_epi32(first + 16 * half));
        _mm512_storeu_si512(out + n, _mm512_maskz_compress_epi32(m, index));
        n += __builtin_popcount(m);
    }
#else
    for (; mask != 0; mask &= mask - 1) out[n++] = first + __builtin_ctz(mask);
#endif
    return n;
}

/// The lowest bits of `bits` at the places of the mask's set bits.
static inline std::uint32_t deposit_bits(std::uint32_t bits, std::uint32_t mask) {
#if defined(__BMI2__)
    return _pdep_u32(bits, mask);
#else
    std::uint32_t r = 0;
    for (; mask != 0; mask &= mask - 1, bits >>= 1)
        if (bits & 1u) r |= mask & -mask;
    return r;
#endif
}

static inline float sqrt(float x) { return std::sqrt(x); }
static inline float positive_part(float x) { return x > 0 ? x : 0; }

}  // namespace tw::simd
