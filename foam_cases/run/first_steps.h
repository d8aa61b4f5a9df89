#pragma once
#include <functional>
#include <optional>

#include "foam_cases/case_plan.h"
#include "foam_cases/run/case_programs.h"

namespace tw {

/// A body that comes down through the air finds air and water at rest in its first field, and its first steps set them
/// in motion: it loses their momentum, which they would have had already (a wedge of 94 kg/m and 1.2 m: 3 % of its
/// speed). That is linear in its speed. Its first steps are therefore run once and thrown away, to find what has to be
/// multiplied with its speed so that it and the air have the right one after them. Returns that factor; none: a stop
/// was asked for. Throws RunError if interFoam fails. The case is a new one, meshed and decomposed, and is left as it
/// was found but for log.first_steps.
std::optional<double> release_factor(const CasePlan& plan, const CasePrograms& programs, int ranks,
                                     const std::function<bool()>& stop_asked);

}  // namespace tw
