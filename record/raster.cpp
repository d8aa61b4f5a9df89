#include "record/raster.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace tw {

namespace {
const Box everywhere{Vec3::Constant(-std::numeric_limits<double>::infinity()),
                     Vec3::Constant(std::numeric_limits<double>::infinity())};

/// Voxels [first, last] of [begin, end) that the interval [low, high] (in voxel edges) meets; empty when first > last.
struct Reach {
    long first, last;
    Reach(double low, double high, int begin, int end)
        : first(std::max(static_cast<long>(begin), static_cast<long>(std::floor(low)))),
          last(std::min(static_cast<long>(end) - 1, static_cast<long>(std::ceil(high)) - 1)) {}
};
const auto alone = [](std::int64_t& voxel, std::int64_t parts) { voxel += parts; };

/// Share of the interval [low, high] that lies in voxel k [-].
double share(double low, double high, long k) {
    const double k0 = static_cast<double>(k);
    return std::max(0.0, std::min(high, k0 + 1) - std::max(low, k0)) / (high - low);
}
}  // namespace

Raster::Raster(const RasterSpec& spec) : Raster(spec, everywhere) {}

Raster::Raster(const RasterSpec& spec, const Box& within) : spec_(spec) {
    std::size_t voxels = 1;
    for (int a = 0; a < 3; ++a) {
        const auto axis = static_cast<std::size_t>(a);
        const double count = std::max(spec.count[axis], 0);
        const auto voxel = [&](double x) { return std::clamp((x - spec.origin[a]) / spec.voxel, 0.0, count); };
        first_[axis] = static_cast<int>(std::floor(voxel(within.min[a])));
        end_[axis] = static_cast<int>(std::ceil(voxel(within.max[a])));
        voxels *= static_cast<std::size_t>(std::max(end_[axis] - first_[axis], 0));
    }
    volume_.resize(voxels);
}

void Raster::pour(const Vec3& centre, double edge, double water) {
    poured_ += water;
    spread(volume_, centre, edge, water, alone);
}

void Raster::share_out(const Vec3& centre, double edge, double water) {
    spread(volume_, centre, edge, water, [](std::int64_t& voxel, std::int64_t parts) {
        std::atomic_ref(voxel).fetch_add(parts, std::memory_order_relaxed);
    });
}

void Raster::pour_cell(const Vec3& centre, double volume, double water) {
    pour(centre, std::cbrt(volume), water);
    space_.resize(volume_.size());
    spread(space_, centre, std::cbrt(volume), volume, alone);
}

template <class Add>
void Raster::spread(std::vector<Parts>& into, const Vec3& centre, double edge, double water, const Add& add) const {
    if (into.empty() || water == 0 || !centre.allFinite() || !std::isfinite(water) || !(edge > 0)) return;
    const Vec3 low = (centre - spec_.origin).array() / spec_.voxel - 0.5 * edge / spec_.voxel;
    const Vec3 high = low.array() + edge / spec_.voxel;
    // Far outside: also keeps the conversion to integers below in range.
    for (int a = 0; a < 3; ++a)
        if (high[a] <= first_[static_cast<std::size_t>(a)] || low[a] >= end_[static_cast<std::size_t>(a)]) return;
    const Reach x(low.x(), high.x(), first_[0], end_[0]), y(low.y(), high.y(), first_[1], end_[1]),
        z(low.z(), high.z(), first_[2], end_[2]);
    const double parts = water / (spec_.voxel * spec_.voxel * spec_.voxel) * parts_of_voxel;
    for (long k = z.first; k <= z.last; ++k) {
        const double in_z = parts * share(low.z(), high.z(), k);
        for (long j = y.first; j <= y.last; ++j) {
            const double in_yz = in_z * share(low.y(), high.y(), j);
            Parts* const row = &into[index(x.first, j, k)];
            for (long i = x.first; i <= x.last; ++i)
                add(row[i - x.first], std::llround(in_yz * share(low.x(), high.x(), i)));
        }
    }
}

void Raster::take_where(const std::function<bool(const Vec3&)>& inside, const Raster& other, int layer) {
    if (other.volume_.empty() || layer < other.first_[2] || layer >= other.end_[2]) return;
    for (int j = other.first_[1]; j < other.end_[1]; ++j)
        for (int i = other.first_[0]; i < other.end_[0]; ++i) {
            Parts& own = volume_[index(i, j, layer)];
            const Parts theirs = other.volume_[other.index(i, j, layer)];
            if (own != theirs && inside(spec_.origin + spec_.voxel * Vec3(i + 0.5, j + 0.5, layer + 0.5))) own = theirs;
        }
}

RasterFrame Raster::frame(double time) const {
    RasterFrame f;
    f.time = time;
    f.water.resize(volume_.size());
    for (std::size_t i = 0; i < volume_.size(); ++i) {
        if (volume_[i] == 0) continue;
        const bool filled = !space_.empty() && std::abs(double(space_[i]) / parts_of_voxel - 1) < 0.1;
        const double share = double(volume_[i]) / (filled ? double(space_[i]) : parts_of_voxel);
        f.water[i] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
    }
    return f;
}

}  // namespace tw
