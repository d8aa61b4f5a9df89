#pragma once
// Vectors of the pair terms. `Real` is a SIMD vector over the particles of a cluster on the CPU, a float on a GPU; what
// belongs to one neighbour alone is a float, the same for all lanes.

namespace tw {

template <class Real>
struct V3 {
    Real x, y, z;
};

template <class A, class B>
inline auto dot(const V3<A>& a, const V3<B>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class A, class B>
inline auto cross(const V3<A>& a, const V3<B>& b) {
    using C = decltype(a.y * b.z);
    return V3<C>{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class A, class B>
inline auto operator-(const V3<A>& a, const V3<B>& b) {
    return V3<decltype(a.x - b.x)>{a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class A, class B>
inline auto operator+(const V3<A>& a, const V3<B>& b) {
    return V3<decltype(a.x + b.x)>{a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class A, class B>
inline auto operator*(const A& factor, const V3<B>& a) {
    return V3<decltype(factor * a.x)>{factor * a.x, factor * a.y, factor * a.z};
}
template <class A, class B>
inline V3<A>& operator+=(V3<A>& a, const V3<B>& b) {
    a.x += b.x;
    a.y += b.y;
    a.z += b.z;
    return a;
}
template <class A, class B>
inline V3<A>& operator-=(V3<A>& a, const V3<B>& b) {
    a.x -= b.x;
    a.y -= b.y;
    a.z -= b.z;
    return a;
}

struct ExactMath {
    template <class Real>
    static Real quotient(const Real& a, const Real& b) {
        return a / b;
    }
};

template <class Real>
inline Real positive_part(const Real& x) {
    return x > 0 ? x : Real{};
}

}  // namespace tw
