#pragma once
#include <map>
#include <string>
#include <utility>

#include "compare/grid_study/grid_study.h"
#include "compare/report/sentences.h"

namespace tw {

/// What the sentence of a grid study's verdict on two sides is made of; of one side alone, on its value.
Statement statement_of(const GridStudy& grid_study, const GridStudyQuantity& quantity,
                       const GridStudyDifference& difference);

/// Puts what runs of several sizes tell into the comparison of the finest of them: the intervals of the values, the
/// verdicts of every two and their sentences, and what was left out as banners. A source that is not its method's finest
/// run of the grid study (one that failed), and a quantity whose mean that run does not give, keep what the comparison
/// says.
void judge_by_sizes(Comparison& comparison, const GridStudy& grid_study);

/// The errors of one scene's values over their size, for scenes of the same kind that have no coarser members of their
/// own.
struct RelativeErrors {
    struct Share {
        double discretisation, choices, box;  ///< half widths over the size [-]
        std::string why_not;                  ///< why there is no discretisation error
    };
    std::string scene;                                             ///< where they are from; empty: from nowhere
    std::map<std::pair<std::string, std::string>, Share> of = {};  ///< by quantity and method
};
RelativeErrors relative_errors(const GridStudy& grid_study, const std::string& scene);

/// Judges every two runs of a comparison, of one size each, by the errors of another scene:
///
///   U_num = (U_num / S)_other S     U^2 = sum over both methods of u^2 + U_num^2 + U_choices^2
///
/// Quantities that the other scene does not know keep what the comparison says.
void judge_by_errors_of(Comparison& comparison, const RelativeErrors& errors);

}  // namespace tw
