#pragma once
#include <string>

#include "structure/shell/shell.h"

namespace tw::structure {

/// A strain gauge glued to a face of a shell.
struct Gauge {
    std::string name;
    Vec3 position = Vec3::Zero();    ///< the nearest place of the mid-surface is meant [m]
    Vec3 direction = Vec3::UnitX();  ///< along which it is strained [-]; its part within the element's plane counts
    bool top = true;                 ///< on the face out of which the normal points
};

/// Where a gauge lies and what it reads: a fixed linear function of the degrees of freedom, found once.
class GaugeReader {
public:
    /// Throws InputError naming the gauge if it lies further from the shell than one thickness beyond every element, or
    /// if its direction stands across the shell.
    GaugeReader(const Shell& shell, const Gauge& gauge);

    double strain(const Eigen::VectorXd& all) const;  ///< [-]
    /// By the element's own 24 degrees of freedom, as Corotational::deformation gives them where rotations are large.
    double strain(const Eigen::Matrix<double, 24, 1>& of_element) const { return reading_ * of_element; }
    /// Strains and stresses of a layer at that place, `height` 0 to 1 through it (laminate.h).
    PlyState state(const Eigen::VectorXd& all, int ply, double height) const;
    int element() const { return element_; }

private:
    const Shell* shell_;
    int element_ = -1;
    Mitc4::Strains strains_;                ///< the element's, at the gauge
    Eigen::Matrix<double, 1, 24> reading_;  ///< the strain by the element's degrees of freedom
};

}  // namespace tw::structure
