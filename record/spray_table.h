#pragma once

namespace tw {

/// Table of the water that left a particle run at its gate: of each lump where its centre of mass is (x, y, z) [m], how
/// that moves (vx, vy, vz) [m/s], mass [kg], inner_energy [J] about that velocity, and how many particles it was. Of
/// half a model one half.
inline constexpr const char* spray_table = "spray";
/// Among the record's numbers where a run has a gate, also where nothing has left by it.
inline constexpr const char* spray_gate_number = "spray_gate";

}  // namespace tw
