#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "compare/report/report_table.h"
#include "spray/study.h"

namespace tw::spray {

/// What the study found, as tables that terminal, page and CSV share.
std::vector<ReportTable> spray_tables(const SprayStudy& study, const SprayResult& result);

/// Leaves in `folder`, each file written atomically:
///   report.html      tables and figures
///   droplets.csv     every droplet with where it was let go and how its flight ended
///   droplets.vtp, landings.vtp   the same for ParaView
///   ledger.csv, ends.csv, reach.csv, windows.csv, by_area.csv, by_length.csv, face.csv, measured.csv, two_sprays.csv,
///   load.csv         the tables, as far as there are any
/// Throws RunError where VTK cannot turn the droplets into a .vtp file, and where a file cannot be written.
void write_spray(const std::filesystem::path& folder, const SprayStudy& study, const SprayResult& result);

/// The page alone.
std::string spray_html(const SprayStudy& study, const SprayResult& result);

}  // namespace tw::spray
