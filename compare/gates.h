#pragma once
#include "compare/compare.h"

namespace tw {

/// Soundness checks of one run from its record: finished, particles lost, Mach or Courant number, mass drift (tank),
/// largest speed, ventilation, spread of the force measures. Only those whose data the record holds.
std::vector<Gate> check_gates(const RunRecord& record, const std::string& name);

}  // namespace tw
