#include "meshes/query/predicates.h"

#include <cmath>
#include <limits>

namespace tw {
namespace {
constexpr double rounding = std::numeric_limits<double>::epsilon() / 2;

/// Sign of the exact sum of products a_i b_i: every product is split without error into two doubles (fused
/// multiply-add) and the parts are gathered in a non-overlapping expansion, whose last non-zero term carries the sign.
template <std::size_t N>
int sign_of_sum(const std::array<std::array<double, 2>, N>& products) {
    std::array<double, 2 * N> expansion{};
    std::size_t length = 0;
    const auto grow = [&](double term) {  // Shewchuk's GROW-EXPANSION with zero elimination
        std::size_t kept = 0;
        for (std::size_t i = 0; i < length; ++i) {
            const double sum = term + expansion[i];
            const double shift = sum - term;
            const double error = (term - (sum - shift)) + (expansion[i] - shift);
            if (error != 0) expansion[kept++] = error;
            term = sum;
        }
        if (term != 0) expansion[kept++] = term;
        length = kept;
    };
    for (const auto& [a, b] : products) {
        const double product = a * b;
        grow(std::fma(a, b, -product));
        grow(product);
    }
    if (length == 0) return 0;
    return expansion[length - 1] > 0 ? 1 : -1;
}
}  // namespace

double orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
    const Vec3 u = a - p, v = b - p, w = c - p;
    const double vw_x = v.y() * w.z(), vw_y = v.z() * w.x(), vw_z = v.x() * w.y();
    const double wv_x = v.z() * w.y(), wv_y = v.x() * w.z(), wv_z = v.y() * w.x();
    const double volume = u.x() * (vw_x - wv_x) + u.y() * (vw_y - wv_y) + u.z() * (vw_z - wv_z);
    const double magnitude = std::abs(u.x()) * (std::abs(vw_x) + std::abs(wv_x)) +
                             std::abs(u.y()) * (std::abs(vw_y) + std::abs(wv_y)) +
                             std::abs(u.z()) * (std::abs(vw_z) + std::abs(wv_z));
    constexpr double filter = (7 + 56 * rounding) * rounding;
    return std::abs(volume) > filter * magnitude ? volume : 0.0;
}

int turn_in_plan(const Vec3& a, const Vec3& b, const Vec3& p) {
    const double left = (a.x() - p.x()) * (b.y() - p.y());
    const double right = (a.y() - p.y()) * (b.x() - p.x());
    const double turn = left - right;
    constexpr double filter = (3 + 16 * rounding) * rounding;
    if (std::abs(turn) > filter * (std::abs(left) + std::abs(right))) return turn > 0 ? 1 : -1;
    const int exact = sign_of_sum<6>(
        {{{a.x(), b.y()}, {-a.x(), p.y()}, {-p.x(), b.y()}, {-a.y(), b.x()}, {a.y(), p.x()}, {p.y(), b.x()}}});
    if (exact != 0) return exact;
    // d(turn)/d(p.x) = a.y - b.y, d(turn)/d(p.y) = b.x - a.x
    if (a.y() != b.y()) return a.y() > b.y() ? 1 : -1;
    if (a.x() != b.x()) return b.x() > a.x() ? 1 : -1;
    return 0;
}

int crossing_above(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
    const int turn = turn_in_plan(a, b, p);
    if (turn == 0 || turn_in_plan(b, c, p) != turn || turn_in_plan(c, a, p) != turn) return 0;
    // A triangle seen counter-clockwise from above has its normal up: p is below it when it is behind it.
    return orientation(a, b, c, p) * turn > 0 ? turn : 0;
}

bool segment_meets_triangle(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
    const double side_p = orientation(a, b, c, p), side_q = orientation(a, b, c, q);
    if (side_p * side_q > 0 || (side_p == 0 && side_q == 0)) return false;
    const double u = orientation(p, q, a, b), v = orientation(p, q, b, c), w = orientation(p, q, c, a);
    return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
}

double ray_distance(const Vec3& origin, const Vec3& d, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 e1 = b - a, e2 = c - a;  // Möller & Trumbore 1997
    const Vec3 h = d.cross(e2);
    const double det = e1.dot(h);
    if (det == 0) return -1;
    const Vec3 s = origin - a;
    const double u = s.dot(h) / det;
    const Vec3 q = s.cross(e1);
    const double v = d.dot(q) / det;
    constexpr double slack = 1e-12;  // a ray along an edge hits at least one of its two triangles
    if (!(u >= -slack && v >= -slack && u + v <= 1 + slack)) return -1;
    return e2.dot(q) / det;
}

NearestOnTriangle nearest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a, ac = c - a, ap = p - a;
    const double d1 = ab.dot(ap), d2 = ac.dot(ap);
    if (d1 <= 0 && d2 <= 0) return {a, Feature::corner0};
    const Vec3 bp = p - b;
    const double d3 = ab.dot(bp), d4 = ac.dot(bp);
    if (d3 >= 0 && d4 <= d3) return {b, Feature::corner1};
    const Vec3 cp = p - c;
    const double d5 = ab.dot(cp), d6 = ac.dot(cp);
    if (d6 >= 0 && d5 <= d6) return {c, Feature::corner2};
    const double area_c = d1 * d4 - d3 * d2;
    if (area_c <= 0 && d1 >= 0 && d3 <= 0) return {a + (d1 / (d1 - d3)) * ab, Feature::edge0};
    const double area_b = d5 * d2 - d1 * d6;
    if (area_b <= 0 && d2 >= 0 && d6 <= 0) return {a + (d2 / (d2 - d6)) * ac, Feature::edge2};
    const double area_a = d3 * d6 - d5 * d4;
    const double e = d4 - d3, f = d5 - d6;
    if (area_a <= 0 && e >= 0 && f >= 0) return {b + (e / (e + f)) * (c - b), Feature::edge1};
    const double sum = area_a + area_b + area_c;
    return {a + (area_b / sum) * ab + (area_c / sum) * ac, Feature::face};
}

}  // namespace tw
