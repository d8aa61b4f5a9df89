#pragma once
#include "foam_cases/case_plan.h"
#include "foam_cases/openfoam.h"

namespace tw {

/// Throws InputError when the scene cannot become an OpenFOAM case (no point of the domain is outside all solids, sizes
/// that are not finite).
CasePlan plan_case(const Scene& scene, const Flavour& flavour);
/// The same for an installation, whose solids let water go if it has the library for it and the scene does not ask
/// otherwise. Throws InputError also where the scene has forcing zones and the installation no library of them.
CasePlan plan_case(const Scene& scene, const OpenFoam& openfoam);

}  // namespace tw
