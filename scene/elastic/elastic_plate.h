#pragma once
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/vec3.h"
#include "structure/laminate.h"
#include "structure/mesh.h"

namespace tw {
namespace structure {
class DegreesOfFreedom;
class Shell;
}  // namespace structure

/// A place on an elastic body at which its displacement or, with a direction, the strain of a face is recorded.
struct ElasticGauge {
    std::string name;
    Vec3 position = Vec3::Zero();   ///< at the start [m]
    std::optional<Vec3> direction;  ///< none: the displacement is recorded
    bool top = true;                ///< the face out of which the plate's normal points
};

/// An elastic rectangular plate: its mid-surface about `middle`, its own x and y along length and breadth, turned by
/// `trim` about the earth's y axis (bow up, the bow at its low x). In two dimensions a strip that bends in the plane.
/// Or any shell by its mesh, in the same axes.
struct ElasticPlate {
    double length = 0, breadth = 0;  ///< between its edges, of a mesh those of the box about it [m]
    std::array<int, 2> cells{};      ///< along and across; of a mesh none
    /// From a file, as it lies there [m]; null: the rectangle. Supports then name its node sets.
    std::shared_ptr<const structure::ShellMesh> mesh;
    std::vector<structure::Ply> plies;
    Vec3 middle = Vec3::Zero();                         ///< [m]
    double trim = 0;                                    ///< [rad]
    std::vector<std::string> clamped, hinged, carried;  ///< edges x_min, x_max, y_min, y_max, or node sets
    double total_mass = 0;                              ///< of plate and carrying frame; 0: no frame [kg]
    std::array<bool, 6> locked{};                       ///< degrees of freedom of the frame
    Vec3 velocity = Vec3::Zero();                       ///< at the start [m/s]
    double skin = 0;                                    ///< thickness of the surface that the water sees [m]
    double margin = 0;                                  ///< by which the plate goes on, held, beyond clamped edges [m]
    bool large_rotations = true;
    std::string coupling = "pressure";  ///< pressure, penalty or background: how it and the water meet
    std::string contact = "linear";     ///< law of a penalty contact: linear, nonlinear or adaptive
    double contact_factor = 0.01;       ///< of its stiffness [-]
    int coupling_iterations = 1;        ///< of water and plate in each step
    double damping = 0;                 ///< [1/s]
    double largest_step = 0;            ///< of the structure [s]; 0: the water's
    std::vector<ElasticGauge> gauges;

    double thickness() const { return structure::Laminate(plies).thickness(); }
    bool two_dimensional() const { return breadth == 0; }
    double cell() const;   ///< the longest edge of its elements [m]
    int elements() const;  ///< between its edges
    Vec3 centre() const;   ///< of the box about it, as it stands at the start [m]
    /// Where a place of the flat plate about its middle stands, and directions [m].
    Vec3 placed(const Vec3& x) const { return middle + turned(x); }
    Vec3 turned(const Vec3& v) const;
    /// In two dimensions the width of the strip by which forces per metre are multiplied; so large that its ends are
    /// far from the plane. Else 1 [m].
    double strip() const { return two_dimensional() ? 4 * (length + 2 * margin + skin) : 1; }
    std::string supports() const;  ///< in words
    double first_period() const;   ///< of the lowest mode that strains it, its frame at rest, in vacuum [s]
};

/// The plate as it stands at the start, in two dimensions as a strip of this width [m]. Throws InputError: see
/// structure/shell.
structure::Shell shell_of(const ElasticPlate& plate, double width);
/// What supports and frame leave it; `width` as above. Throws InputError where a frame is lighter than nothing.
structure::DegreesOfFreedom dofs_of(const ElasticPlate& plate, const structure::Shell& shell, double width);

}  // namespace tw
