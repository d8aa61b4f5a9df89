#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "base/exact_sum.h"
#include "record/run_record.h"

namespace tw {

/// Pours water into voxels, conserving volume: the one definition of "where the water is" for both methods.
/// A particle is a cube of volume m/rho; a cell is a cube of its water volume's cell. Each cube's water is shared among
/// the voxels it overlaps in proportion to the overlap. What a voxel has is summed in whole parts of it, 2^-40, so that
/// it does not depend on the order of pouring; a voxel holds up to 2^22 of its own volumes.
class Raster {
public:
    explicit Raster(const RasterSpec& spec);
    /// Of the voxels of `spec` those alone that meet a box [m]; it may reach beyond them, and to infinity. What is poured
    /// elsewhere is not kept.
    Raster(const RasterSpec& spec, const Box& within);
    /// `water` [m3] spread evenly over the cube of edge `edge` [m] round `centre`.
    void pour(const Vec3& centre, double edge, double water);
    /// The same by any number of threads at once, and not counted in `poured`.
    void share_out(const Vec3& centre, double edge, double water);
    /// As `pour`, of a mesh's cell: besides its water all of its volume [m3], wet and dry. Cells are no cubes, so the
    /// cubes in their place overlap here and gape there (half a per cent of the water under a hull's mesh); a voxel
    /// that they fill to within a tenth takes water over volume instead.
    void pour_cell(const Vec3& centre, double volume, double water);
    /// Takes the water of another raster of the same voxels, or of some of them, in place of its own, where the centre of
    /// one of those is `inside`. Layer by layer: several threads may each take others.
    void take_where(const std::function<bool(const Vec3&)>& inside, const Raster& other, int layer);
    int layers() const { return spec_.count[2]; }  ///< along z
    RasterFrame frame(double time) const;          ///< fractions, clamped to 1
    /// What each voxel has in whole parts of it, which processes that pour different water may add.
    std::span<std::int64_t> parts() { return volume_; }
    double poured() const { return poured_.value(); }  ///< all water poured, inside the raster or not [m3]

private:
    RasterSpec spec_;
    using Parts = std::int64_t;
    static constexpr double parts_of_voxel = 0x1p40;  ///< [1/voxel]
    /// Calls `add(voxel, parts)` for the voxels of `into` that get some.
    template <class Add>
    void spread(std::vector<Parts>& into, const Vec3& centre, double edge, double amount, const Add& add) const;
    std::size_t index(long i, long j, long k) const {
        const long nx = end_[0] - first_[0], ny = end_[1] - first_[1];
        return static_cast<std::size_t>(((k - first_[2]) * ny + j - first_[1]) * nx + i - first_[0]);
    }

    std::array<int, 3> first_{}, end_{};  ///< voxels that are kept
    std::vector<Parts> volume_;
    std::vector<Parts> space_;  ///< volume of the cells poured, wet and dry; empty without pour_cell
    ExactSum poured_;
};

}  // namespace tw
