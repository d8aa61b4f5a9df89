#pragma once
#include "compare/compare.h"

namespace tw {

/// Soundness checks of one run from its record: finished, particles lost, Mach or Courant number, mass drift (tank,
/// until water is at its open top), largest speed, ventilation, suction on a hull that has edges in air, drag that a
/// prismatic bottom cannot have, spread of the force measures; then the validity checks made in it. Only those
/// whose data the record holds.
std::vector<Gate> check_gates(const RunRecord& record, const std::string& name);
/// Those that are not met.
std::vector<Gate> failed_gates(std::vector<Gate> gates);

}  // namespace tw
