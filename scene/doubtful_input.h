#pragma once
#include <string>
#include <vector>

#include "scene/scene.h"

namespace tw {

/// What is probably another unit than the one meant, or a value that a run would take without a word, as findings of
/// level warning:
///   dynamic_viscosity   the kinematic viscosity is what the dynamic one of water is in Pa s: 2e-4 to 2e-3, in water
///   odd_density         of the water, outside 500 to 2000 kg/m3
///   odd_tension         above 1 N/m
///   odd_mass            a free hull weighs less than a tenth or more than ten times what it displaces at its draft; a body
///                       less than a fiftieth of the water that it would displace drowned, or more than 25 times as much
///   hardly_standing     a body on the floor weighs one to two times its buoyancy
///   table_moves_on      a motion's table ends before the run, while it moves
///   choked, gate_too_wide, jump_moves   channel_flow.h
std::vector<Finding> doubtful_input(const Scene& scene);

/// Every warning of a scene, of its hull and of its bodies, for the first lines of a run: "warning: ...\n" each; empty:
/// there is none.
std::string warnings_text(const Scene& scene);

}  // namespace tw
