#pragma once
#include <vector>

#include "record/run_record.h"

namespace tw {

/// Pours water into voxels, conserving volume: the one definition of "where the water is" for both methods.
/// A particle is a cube of volume m/rho; a cell is a cube of its water volume's cell. Each cube's water is shared among
/// the voxels it overlaps in proportion to the overlap.
class Raster {
public:
    explicit Raster(const RasterSpec& spec);
    /// `water` [m3] spread evenly over the cube of edge `edge` [m] round `centre`.
    void pour(const Vec3& centre, double edge, double water);
    RasterFrame frame(double time) const;      ///< fractions, clamped to 1
    double poured() const { return poured_; }  ///< all water poured, inside the raster or not [m3]

private:
    RasterSpec spec_;
    std::vector<float> volume_;
    double poured_ = 0;
};

}  // namespace tw
