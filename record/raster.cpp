#include "record/raster.h"

#include <algorithm>
#include <cmath>

namespace tw {

Raster::Raster(const RasterSpec& spec)
    : spec_(spec),
      volume_(static_cast<std::size_t>(std::max(spec.count[0], 0)) *
              static_cast<std::size_t>(std::max(spec.count[1], 0)) *
              static_cast<std::size_t>(std::max(spec.count[2], 0))) {}

namespace {
/// Voxels [first, last] that the interval [low, high] (in voxel edges) meets; empty when first > last.
struct Reach {
    long first, last;
    Reach(double low, double high, int count)
        : first(std::max(0L, static_cast<long>(std::floor(low)))),
          last(std::min(static_cast<long>(count) - 1, static_cast<long>(std::ceil(high)) - 1)) {}
};
/// Share of the interval [low, high] that lies in voxel k [-].
double share(double low, double high, long k) {
    const double k0 = static_cast<double>(k);
    return std::max(0.0, std::min(high, k0 + 1) - std::max(low, k0)) / (high - low);
}
}  // namespace

void Raster::pour(const Vec3& centre, double edge, double water) {
    poured_ += water;
    spread(volume_, centre, edge, water);
}

void Raster::pour_cell(const Vec3& centre, double volume, double water) {
    pour(centre, std::cbrt(volume), water);
    space_.resize(volume_.size());
    spread(space_, centre, std::cbrt(volume), volume);
}

void Raster::spread(std::vector<Parts>& into, const Vec3& centre, double edge, double water) const {
    if (into.empty() || !centre.allFinite() || !std::isfinite(water) || !(edge > 0)) return;
    const Vec3 low = (centre - spec_.origin).array() / spec_.voxel - 0.5 * edge / spec_.voxel;
    const Vec3 high = low.array() + edge / spec_.voxel;
    // Far outside: also keeps the conversion to integers below in range.
    for (int a = 0; a < 3; ++a)
        if (high[a] <= 0 || low[a] >= spec_.count[static_cast<std::size_t>(a)]) return;
    const Reach x(low.x(), high.x(), spec_.count[0]), y(low.y(), high.y(), spec_.count[1]),
        z(low.z(), high.z(), spec_.count[2]);
    const double parts = water / (spec_.voxel * spec_.voxel * spec_.voxel) * parts_of_voxel;
    for (long k = z.first; k <= z.last; ++k) {
        const double in_z = parts * share(low.z(), high.z(), k);
        for (long j = y.first; j <= y.last; ++j) {
            const double in_yz = in_z * share(low.y(), high.y(), j);
            Parts* row = &into[static_cast<std::size_t>((k * spec_.count[1] + j) * spec_.count[0])];
            for (long i = x.first; i <= x.last; ++i) row[i] += std::llround(in_yz * share(low.x(), high.x(), i));
        }
    }
}

void Raster::take_where(const std::function<bool(const Vec3&)>& inside, const Raster& other) {
    if (volume_.empty()) return;
    const auto [nx, ny, nz] = spec_.count;
    std::size_t v = 0;
    for (int k = 0; k < nz; ++k)
        for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx; ++i) {
                const Parts theirs = other.volume_[v];
                if (volume_[v] != theirs && inside(spec_.origin + spec_.voxel * Vec3(i + 0.5, j + 0.5, k + 0.5)))
                    volume_[v] = theirs;
                ++v;
            }
}

RasterFrame Raster::frame(double time) const {
    RasterFrame f;
    f.time = time;
    f.water.resize(volume_.size());
    for (std::size_t i = 0; i < volume_.size(); ++i) {
        const bool filled = !space_.empty() && std::abs(double(space_[i]) / parts_of_voxel - 1) < 0.1;
        const double share = double(volume_[i]) / (filled ? double(space_[i]) : parts_of_voxel);
        f.water[i] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
    }
    return f;
}

}  // namespace tw
