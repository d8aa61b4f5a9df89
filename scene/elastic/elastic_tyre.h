#pragma once
#include <array>
#include <variant>
#include <vector>

#include "base/vec3.h"
#include "scene/elastic/elastic_plate.h"
#include "structure/solid/hyperelastic.h"
#include "structure/tyre.h"

namespace tw {
namespace structure {
class Solid;
}

/// A tyre on a rigid rim, blown up, its axle along y (structure/tyre.h). The rim translates and does not turn. It meets
/// the tank's floor without friction.
struct ElasticTyre {
    structure::Tyre shape;                          ///< before it is blown up
    std::array<structure::Hyperelastic, 3> rubber;  ///< inner tyre, side walls, tread
    double pressure = 0;                            ///< inside [Pa]
    double total_mass = 0;                          ///< of tyre, rim and load [kg]
    Vec3 axle = Vec3::Zero();                       ///< at the start [m]
    Vec3 velocity = Vec3::Zero();                   ///< at the start [m/s]
    std::array<bool, 3> locked{};                   ///< surge, sway, heave of the rim
    double contact_depth = 0;                       ///< by which 1 MPa presses the surface into the floor [m]
    double damping = 0;                             ///< [1/s]
    double largest_step = 0;                        ///< of tyre and water [s]; 0: the water's
    std::vector<ElasticGauge> gauges;               ///< displacements alone

    std::vector<structure::Hyperelastic> rubbers() const { return {rubber.begin(), rubber.end()}; }
    double contact_stiffness() const { return 1e6 / contact_depth; }  ///< [Pa/m]
};

/// The kinds of elastic bodies of a scene.
using ElasticPart = std::variant<ElasticPlate, ElasticTyre>;

/// The tyre about its axle, before it is blown up. Throws InputError: see structure/tyre.h and structure/solid/solid.h.
structure::Solid solid_of(const ElasticTyre& tyre);
/// The degrees of freedom that its rim leaves. Throws InputError where rim and load weigh less than nothing.
structure::DegreesOfFreedom dofs_of(const ElasticTyre& tyre, const structure::Solid& solid);

}  // namespace tw
