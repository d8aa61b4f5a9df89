#pragma once
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "sph_solver/bodies/elastic/interface.h"
#include "structure/degrees_of_freedom.h"
#include "structure/shell/gauge.h"
#include "structure/shell/shell.h"
#include "structure/solid/solid.h"

namespace tw {

/// A place of an elastic body whose displacement is asked for.
struct DeflectionPoint {
    std::string name;
    Vec3 position = Vec3::Zero();  ///< at the start [m]; the nearest place of the mid-surface or wet face is meant
};

/// A shell as it stands at the start.
struct ElasticShell {
    structure::Shell shell;
    /// Of the closed surface that the water sees, about the shell's mid-surface; at least the laminate's [m].
    double skin = 0;
    bool large_rotations = true;
    /// Of linear shells: share of its amplitude that an infinitely fast mode keeps each step (1: energy is kept).
    double kept = 1;  ///< [-]
};

/// A rigid floor that a solid meets without friction (structure/solid/plane_contact.h).
struct FloorContact {
    double height = 0;     ///< [m]
    double stiffness = 0;  ///< [Pa/m]
};

/// A solid of hexahedra as it stands at the start.
struct ElasticSolid {
    structure::Solid solid;
    std::string wet;        ///< the named surface that the water sees; its openings are closed flat
    Eigen::VectorXd start;  ///< displacements of its nodes at the start, in balance or not [m]
    std::string pressed = {};
    double pressure = 0;  ///< that follows the surface `pressed`, none if 0 [Pa]
    std::optional<FloorContact> floor = {};
    double of_limit = 0.7;  ///< sub-steps, of the explicit limit at the start: strain lowers it [-]
};

/// What an elastic body is made from, and what holds or carries it.
struct ElasticSetup {
    std::variant<ElasticShell, ElasticSolid> structure;
    structure::DegreesOfFreedom dofs;
    /// Two dimensions: the structure is a strip about the plane y = 0, so wide [m]; forces are per metre of it. Else 0.
    double width = 0;
    Coupling coupling = {};
    double damping = 0;                         ///< f = -damping M v [1/s]
    double largest_step = 0;                    ///< of the structure [s]; 0: the water's
    Vec3 velocity = Vec3::Zero();               ///< at the start [m/s]
    std::vector<structure::Gauge> gauges = {};  ///< of shells
    std::vector<DeflectionPoint> points = {};

    /// Throw std::bad_variant_access where it is the other.
    const ElasticShell& shell() const { return std::get<ElasticShell>(structure); }
    const ElasticSolid& solid() const { return std::get<ElasticSolid>(structure); }
};

}  // namespace tw
