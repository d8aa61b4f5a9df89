#pragma once
#include <string>

namespace tw {

/// The jet that a hull throws, and the size of the particles and cells where it leaves the hull. Of a record the numbers
/// jet_thickness and jet_spacing [m]; what gives the thickness is scene/solids/thin_jet.h.
struct SprayJet {
    double thickness = 0, size = 0;  ///< [m]
    double across() const { return thickness / size; }
    /// From three particles or cells across it on heights of splash are judged.
    bool resolved() const { return across() >= 3 * (1 - 1e-9); }
    /// "not resolved: the jet is 0.4 of a particle or cell thick, and three across it are needed (near_hull = 20 mm)"; empty where it is resolved.
    std::string why_not_resolved() const;
};

}  // namespace tw
