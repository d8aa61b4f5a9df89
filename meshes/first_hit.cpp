#include "meshes/first_hit.h"

#include <algorithm>

#include "base/errors.h"
#include "meshes/query/bvh.h"
#include "meshes/query/predicates.h"

namespace tw {

struct FirstHit::Impl {
    Bvh bvh;
    Box box;
};

FirstHit::FirstHit(const Surface& surface) {
    if (surface.triangles.empty()) throw InputError("a surface without triangles cannot be hit; expected at least one");
    impl_ = std::make_unique<Impl>(Impl{Bvh(surface), surface.bounds()});
}
FirstHit::~FirstHit() = default;
FirstHit::FirstHit(FirstHit&&) noexcept = default;

const Box& FirstHit::bounds() const { return impl_->box; }

std::optional<FirstHit::Hit> FirstHit::on(const Vec3& a, const Vec3& b) const {
    const Vec3 d = b - a, inverse = d.cwiseInverse();
    std::optional<Hit> first;
    double nearest = 1;
    impl_->bvh.visit([&](const Box& box) { return Bvh::meets(box, a, inverse, nearest); },
                     [&](const Bvh::Corners& t) {
                         if (!segment_meets_triangle(a, b, t.a, t.b, t.c)) return true;
                         const Vec3 normal = (t.b - t.a).cross(t.c - t.a);
                         const double share = std::clamp((t.a - a).dot(normal) / d.dot(normal), 0.0, 1.0);
                         if (first && share >= nearest) return true;
                         nearest = share;
                         first = Hit{share, t.triangle, a + share * d, normal.stableNormalized()};
                         return true;
                     });
    return first;
}

}  // namespace tw
