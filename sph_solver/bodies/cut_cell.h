#pragma once
#include "base/vec3.h"

namespace tw {

/// What of a cell is on one side of a surface: so many of 6^3 samples (6^2 in two dimensions), and the centroid of
/// these, which is the cell's middle where there are none.
struct CutCell {
    int within = 0, samples = 1;
    Vec3 centroid;  ///< [m]
    double of(double volume) const { return volume * within / samples; }
};

template <class Within>
CutCell cut_cell(const Vec3& middle, const Vec3& edges, bool flat, const Within& within) {
    constexpr int samples = 6;  // per axis
    const int across = flat ? 1 : samples;
    const auto place = [](int a, int n, double edge) { return ((a + 0.5) / n - 0.5) * edge; };
    int count = 0;
    Vec3 sum = Vec3::Zero();
    for (int k = 0; k < samples; ++k)
        for (int j = 0; j < across; ++j)
            for (int i = 0; i < samples; ++i) {
                const Vec3 p = middle + Vec3(place(i, samples, edges.x()), place(j, across, edges.y()),
                                             place(k, samples, edges.z()));
                if (within(p)) ++count, sum += p;
            }
    return {count, samples * samples * across, count > 0 ? Vec3(sum / count) : middle};
}

}  // namespace tw
