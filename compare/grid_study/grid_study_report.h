#pragma once
#include <string>
#include <vector>

#include "compare/grid_study/grid_study.h"
#include "compare/report/report_table.h"

namespace tw {

// A grid-convergence study in sentences, tables and files.

/// The verdict on two sides as a sentence to be forwarded, see sentence_of.
std::string grid_study_sentence(const GridStudy& grid_study, const GridStudyQuantity& quantity,
                                const GridStudyDifference& difference);
/// The sentence on the quantity's own difference.
std::string grid_study_sentence(const GridStudy& grid_study, const GridStudyQuantity& quantity);
/// "Beyond 82 s, at U = 688 N, fvm is the cheaper one, before it sph.", for every two; empty where the lines do not
/// cross within a year.
std::string crossover_sentence(const GridStudy& grid_study, const GridStudyQuantity& quantity);
/// Tables and verdicts for people, in markdown.
std::string grid_study_text(const GridStudy& grid_study);
/// A part of it for the terminal: the verdicts, the comparison with measurements, and the checks that are not met.
std::string grid_study_summary(const GridStudy& grid_study);
std::string grid_study_json(const GridStudy& grid_study);
/// Spacing and values of one side, as `twinwake uncertainty` reads it; levels that lack a quantity leave it out whole.
std::string grid_study_csv(const GridStudy& grid_study, std::size_t side);
/// The part of report.html that stands below the verdicts: convergence, shares, other choices, what accuracy costs.
std::string grid_study_html(const GridStudy& grid_study);
/// The lines above the tables: runs that are left out, choices that are no evidence, sides that are no family.
std::vector<std::string> grid_study_banners(const GridStudy& grid_study);

// The tables of a grid study: the page, the text and the terminal print the same ones.

ReportTable grid_study_verdicts(const GridStudy& grid_study);
/// Each method's finest values beside what was measured, or a formula says.
ReportTable grid_study_held(const GridStudy& grid_study);
/// Validity checks that some run does not meet.
ReportTable grid_study_checks(const GridStudy& grid_study);
/// Behind these, in the order in which they stand: every share of each interval; the values of every size and what the
/// estimators make of them; the runs with another box, sound speed, time step or Courant number; what accuracy costs; the
/// runs.
std::vector<ReportTable> grid_study_details(const GridStudy& grid_study);

}  // namespace tw
