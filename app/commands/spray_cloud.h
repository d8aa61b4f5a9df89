#pragma once
#include <filesystem>

#include "compare/report/report_table.h"
#include "spray/study.h"

namespace tw::app {

/// The study's droplets as an OpenFOAM cloud in `folder`, each let go at time 0; targets are left out. Where an
/// installation has the solver it is run, and the table says how far its trajectories are from ours; else the table has
/// a note only. Throws InputError: `folder` is there and not empty, no droplets, air that one density and viscosity do
/// not describe or that does not cover the flights.
ReportTable fly_in_openfoam(const spray::SprayStudy& study, const spray::SprayResult& result,
                            const std::filesystem::path& folder);

}  // namespace tw::app
