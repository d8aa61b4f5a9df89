#pragma once
// Sixteen floats at a time. The vector type is GCC's: on AVX-512 it is one register, on AVX2 two, on baseline x86-64 four,
// and on other machines whatever the compiler makes of it. The pair terms are written against `Real` and never see this.
#include <cmath>
#include <cstdint>
#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace tw::simd {

inline constexpr int lanes = 16;
typedef float F __attribute__((vector_size(64)));
typedef std::int32_t I __attribute__((vector_size(64)));

inline F splat(float x) { return F{} + x; }

inline F sqrt(F x) {
#if defined(__AVX512F__)
    return (F)_mm512_sqrt_ps((__m512)x);
#elif defined(__AVX__)
    union { F v; __m256 half[2]; } u{x};
    u.half[0] = _mm256_sqrt_ps(u.half[0]);
    u.half[1] = _mm256_sqrt_ps(u.half[1]);
    return u.v;
#elif defined(__SSE__)
    union { F v; __m128 quarter[4]; } u{x};
    for (auto& q : u.quarter) q = _mm_sqrt_ps(q);
    return u.v;
#else
    F r;
    for (int l = 0; l < lanes; ++l) r[l] = std::sqrt(x[l]);
    return r;
#endif
}
inline float sqrt(float x) { return std::sqrt(x); }

inline F positive_part(F x) { return x > 0.0f ? x : F{}; }
inline float positive_part(float x) { return x > 0 ? x : 0; }

}  // namespace tw::simd
