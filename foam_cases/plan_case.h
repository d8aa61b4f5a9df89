#pragma once
#include <vector>

#include "foam_cases/case_plan.h"
#include "foam_cases/openfoam.h"

namespace tw {

/// Throws InputError when the scene cannot become an OpenFOAM case (no point of the domain is outside all solids, sizes
/// that are not finite).
CasePlan plan_case(const Scene& scene, const Flavour& flavour);
/// The same for an installation, whose solids let water go if it has the library for it and the scene does not ask
/// otherwise.
CasePlan plan_case(const Scene& scene, const OpenFoam& openfoam);

/// Cells of about `spacing` from `low` to `high`, with the `wanted` planes on cell faces as far as cells stay within 25
/// % of `spacing`: a water block then begins with exactly its volume.
AxisCells split_axis(double low, double high, double spacing, std::vector<double> wanted);

}  // namespace tw
